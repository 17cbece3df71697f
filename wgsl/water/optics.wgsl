// What water does to light that passes through it.

#include <light/fresnel.wgsl>
#include <water/level.wgsl>

/// How strongly water swallows red, green and blue: pure water (0.35, 0.06, 0.02), lakes more, by what grows in them.
#param water.absorption: vec3f = (0.50, 0.17, 0.16), unit 1/m
/// Albedo of water too deep to see the ground.
#param water.deep: vec3f = (0.006, 0.017, 0.019), color

const WATER_IOR: f32 = 1.333;
const WATER_WET: f32 = 0.6; // albedo of ground under water over that of dry ground: light is trapped at the surface

/// Part of the light left after `path` (m) of water: exp(-absorption · path), 0 .. 1 in each channel.
fn water_transmittance(path: f32) -> vec3f {
    return exp(-water.absorption * path);
}

/// Radiance that comes back out of deep water under `irradiance` of its surface.
fn water_deep_radiance(irradiance: vec3f) -> vec3f {
    return water.deep * irradiance / 3.14159265;
}

/// Unit direction of a ray that goes down into level water in the unit `direction`, `direction.y` <= 0.
fn water_refracted_down(direction: vec3f) -> vec3f {
    let level = direction.xz / WATER_IOR; // Snell
    return vec3f(level.x, -sqrt(max(1.0 - dot(level, level), 0.0)), level.y);
}

/// How much of the water's look there is over ground `depth` (m) below the surface: 0 at the waterline, 1 from `edge` (m)
/// down. Smooth, so that the waterline neither cuts nor flickers.
fn water_presence(depth: f32, edge: f32) -> f32 {
    return smoothstep(0.0, edge, depth);
}

/// Ground with radiance `bed` if it were dry, seen through water.
///
/// `presence` is `water_presence`, `irradiance` that of the surface; `depth` and `path` (m) are how deep the ground lies
/// and how far the eye looks through water to it. `bed` itself where all three are 0.
fn water_over_ground(bed: vec3f, presence: f32, depth: f32, path: f32, irradiance: vec3f) -> vec3f {
    let there_and_back = water_transmittance(path + depth);
    let wet = bed * mix(1.0, WATER_WET, presence);
    return wet * there_and_back + water_deep_radiance(irradiance) * (1.0 - there_and_back);
}
