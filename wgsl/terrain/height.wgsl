// The height of the land: which relief it has, and its slope.

#include <quality.wgsl>

/// The forms of the land: rolling hills, mounds, ridged mountains, ranges worn in their valleys, hills smooth where they
/// are steep, a sea of dunes, or terraced canyons; or the ground of a planet around the world's origin, by `planet.*`.
#option terrain.relief = ridged { fbm, billow, ridged, hybrid, damped, dunes, terraces, planet }
/// Which land of its kind: another seed, another land.
#param terrain.seed: u32 = 1
/// Width of the largest forms.
#param terrain.scale: f32 = 6000.0, range 10 .. 1000000, log, unit m
/// Octaves of the noise that the land is made of; those too small to see in a pixel are left out.
#param terrain.octaves: f32 = 13.0, range 1 .. 14

#if terrain.relief == dunes
#include <terrain/dunes.wgsl>
#elif terrain.relief == terraces
#include <terrain/terraces.wgsl>
#elif terrain.relief == planet
#include <planet/local.wgsl>
#else
#include <terrain/mountains.wgsl>
#endif

/// Height of the land (m) at `p` (m, east and south), with every detail.
fn terrain_height(p: vec2f) -> f32 {
    return terrain_height_grad_filtered(p, 0.0).x;
}

/// Height of the land (m) at `p` (m), without the octaves that are too small to be seen in a pixel `footprint` (m)
/// wide.
fn terrain_height_filtered(p: vec2f, footprint: f32) -> f32 {
    return terrain_height_grad_filtered(p, footprint).x;
}

/// Height of the land and its slope: (height in m, rise over run to the east, to the south). Analytic.
fn terrain_height_grad(p: vec2f) -> vec3f {
    return terrain_height_grad_filtered(p, 0.0);
}

/// As `terrain_height_grad`, without the octaves that are too small to be seen in a pixel `footprint` (m) wide.
fn terrain_height_grad_filtered(p: vec2f, footprint: f32) -> vec3f {
    let octaves = min(terrain.octaves, log2(terrain.scale / max(2.0 * footprint, 1e-3)));
#if terrain.relief == dunes
    return dunes_height_grad(p, octaves);
#elif terrain.relief == terraces
    return terraces_height_grad(p, octaves);
#elif terrain.relief == planet
    return local_height_grad(p, footprint);
#else
    return mountains_height_grad(p, octaves);
#endif
}

/// A height (m) that the land nowhere exceeds.
fn terrain_ceiling() -> f32 {
#if terrain.relief == dunes
    return dunes_ceiling();
#elif terrain.relief == terraces
    return terraces_ceiling();
#elif terrain.relief == planet
    return local_ceiling();
#else
    return mountains_ceiling();
#endif
}

#if terrain.relief != planet
/// A height (m) that the land nowhere falls below. (A planet's land falls away from the plane without end.)
fn terrain_floor() -> f32 {
#if terrain.relief == dunes
    return dunes_floor();
#elif terrain.relief == terraces
    return terraces_floor();
#else
    return mountains_bounds().x;
#endif
}
#endif
