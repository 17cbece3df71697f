// The wind on the water: how rough it makes it, and where.

#include <fractal/fbm.wgsl> as breeze with noise2 = perlin_noise2_grad
#include <frame.wgsl>
#include <math/rotation.wgsl>
#include <noise/perlin.wgsl>

/// Length of the longest waves, crest to crest.
#param water.wave_length: f32 = 2.0, range 0.05 .. 500, log, unit m
/// Root mean square slope of the waves where the breeze is: .02 a mirror, .12 a light breeze, .2 a fresh one; a sea has
/// sqrt(.003 + .00512 U) in wind of U m/s (Cox & Munk 1954).
#param water.slope: f32 = 0.05, range 0 .. 0.5
/// Where the wind blows to, clockwise from north.
#param water.wind_heading: f32 = 70.0, range -360 .. 360, unit deg
/// How much calmer the calm lanes are than those where the breeze is: 0 no lanes, 1 mirrors between them.
#param water.lanes: f32 = 0.7, range 0 .. 1
/// From one lane of breeze to the next.
#param water.lane_width: f32 = 160.0, range 1 .. 10000, unit m

/// Waves at a place, seen by a pixel of some width.
struct Waves {
    /// Height above the level (m).
    height: f32,
    /// Rise over run to the east and to the south, of waves wide enough to see.
    slope: vec2f,
    /// Variance of the slope, in each direction, of all other waves.
    variance: f32,
    /// How much of the surface is foam, 0 .. 1.
    foam: f32,
}

/// Part of the waves of a length (m) that is seen by a pixel `footprint` (m) wide: 0 below two pixels a wave, 1 from five.
fn wave_presence(wave_length: f32, footprint: f32) -> f32 {
    return smoothstep(2.0, 5.0, wave_length / max(footprint, 1e-6));
}

/// How much of the breeze there is at `p` (m), 1 - lanes .. 1: long lanes along the wind that drift with it. Three noises.
fn water_breeze(p: vec2f, footprint: f32) -> f32 {
    let heading = 1.5707963 - water.wind_heading;
    let along = rotate2(vec2f(p.x, -p.y), -heading) - vec2f(0.8 * frame.time, 0.0);
    let octaves = clamp(log2(water.lane_width / max(footprint, 1e-3)), 0.0, 3.0);
    let gust = breeze_fbm2(along * vec2f(0.18, 1.0) / water.lane_width, 71u, octaves, 0.6, 2.1).x;
    return mix(1.0 - water.lanes, 1.0, smoothstep(-0.35, 0.45, gust));
}
