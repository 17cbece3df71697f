// What shapes clouds out of noise: profiles over height, cover, the lifting and the erosion of noise by noise
// (Schneider 2015, "The Real-time Volumetric Cloudscapes of Horizon: Zero Dawn").

#include <math/remap.wgsl>

/// Where in its layer a sheet of stratus begins, is full, begins to thin out, and ends: fractions of the layer's
/// height.
const CLOUD_STRATUS: vec4f = vec4f(0.0, 0.1, 0.2, 0.3);
/// As `CLOUD_STRATUS`, of stratocumulus.
const CLOUD_STRATOCUMULUS: vec4f = vec4f(0.02, 0.2, 0.48, 0.625);
/// As `CLOUD_STRATUS`, of cumulus.
const CLOUD_CUMULUS: vec4f = vec4f(0.01, 0.0625, 0.78, 1.0);

/// Begin, full, thinning and end of clouds of a type: 0 stratus, 1/2 stratocumulus, 1 cumulus, and what lies between.
/// Each part is in 0 .. 1 and less than the next.
fn cloud_stops(kind: f32) -> vec4f {
    let t = clamp(2.0 * kind, 0.0, 2.0);
    return mix(mix(CLOUD_STRATUS, CLOUD_STRATOCUMULUS, min(t, 1.0)), CLOUD_CUMULUS, max(t - 1.0, 0.0));
}

/// How dense a cloud may be at a height, 0 .. 1: the trapezoid that rises between the first two `stops` and falls
/// between the last two. `height`: fraction of the layer. 0 outside of the stops.
fn cloud_gradient(height: f32, stops: vec4f) -> f32 {
    let rise = (height - stops.x) / (stops.y - stops.x);
    let fall = (stops.w - height) / (stops.w - stops.z);
    return clamp(min(rise, fall), 0.0, 1.0);
}

/// What clouds are cut out of: remap(`lifted`, `holes` - 1, 1, 0, 1), of Perlin-Worley noise `lifted` and a finer fBm
/// of Worley noise `holes`, both 0 .. 1.
///
/// Where `holes` is 1 it is `lifted`, where it is 0 half of what lacks to 1 is filled. Result `lifted` .. 1.
fn cloud_lift(lifted: f32, holes: f32) -> f32 {
    return remap(lifted, holes - 1.0, 1.0, 0.0, 1.0);
}

/// What `coverage` (0 .. 1) leaves of `base` (0 .. 1): remap(base, 1 - coverage, 1, 0, 1) · coverage, which is
/// base - (1 - coverage), never negative: 0 .. `coverage`.
fn cloud_cover(base: f32, coverage: f32) -> f32 {
    return max(base + coverage - 1.0, 0.0);
}

/// How far `detail` (0 .. 1: puffs) eats into a cloud at `height` (fraction of the layer), 0 .. 1.
///
/// Near the bottom it eats where the puffs are and leaves wisps, from a tenth of the layer on between them and leaves
/// heaps.
fn cloud_bite(detail: f32, height: f32) -> f32 {
    return mix(detail, 1.0 - detail, clamp(10.0 * height, 0.0, 1.0));
}

/// `density` (0 .. 1) after its edges were eaten away: remap(density, bite, 1, 0, 1), 0 where it is below `bite`.
///
/// `bite` 0 .. 0.99. Result 0 .. 1, never above `density`: the inside of a cloud keeps it, and 1 stays 1.
fn cloud_erode(density: f32, bite: f32) -> f32 {
    return clamp(remap(density, bite, 1.0, 0.0, 1.0), 0.0, 1.0);
}
