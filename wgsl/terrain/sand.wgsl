// Bare sand: ripples across the wind, and grains sorted into lighter and darker drifts.

#include <fractal/fbm.wgsl> as drift with noise2 = perlin_noise2_grad
#include <noise/perlin.wgsl>
#include <terrain/material.wgsl>

/// Albedo of the sand.
#param ground.sand: vec3f = (0.40, 0.30, 0.18), color
/// Albedo of the coarser grains that gather in the hollows.
#param ground.coarse_sand: vec3f = (0.31, 0.21, 0.12), color
/// Where the wind that made the ripples blows to, clockwise from north.
#param ground.ripple_heading: f32 = 60.0, range -360 .. 360, unit deg
/// From one ripple to the next.
#param ground.ripple_length: f32 = 0.22, range 0.02 .. 50, unit m
/// Steepest slope of a ripple, rise over run.
#param ground.ripple_slope: f32 = 0.22, range 0 .. 1

/// Slope of a field of ripples along the wind: steep to leeward, gentle to windward.
fn ripple_slope_at(p: vec2f, wind: vec2f, wavelength: f32, seed: u32) -> f32 {
    let along = dot(p, wind);
    let across = dot(p, vec2f(-wind.y, wind.x));
    let wander = drift_fbm2(vec2f(along, 0.45 * across) / (9.0 * wavelength), seed, 2.0, 0.5, 2.3).x;
    let phase = 6.2831853 * (along / wavelength + 1.5 * wander);
    return 0.75 * cos(phase) + 0.25 * cos(2.0 * phase + 0.9);
}

/// The sand. Ripples in two sizes, each fading before it is too small for the pixel.
fn sand_surface(position: vec3f, normal: vec3f, footprint: f32) -> Surface {
    let wind = vec2f(sin(ground.ripple_heading), -cos(ground.ripple_heading));
    let p = position.xz;
    let fine = 1.0 - smoothstep(0.12, 0.45, footprint / ground.ripple_length);
    let broad_length = 17.0 * ground.ripple_length;
    let broad = 1.0 - smoothstep(0.12, 0.45, footprint / broad_length);
    let lee = 1.0 - smoothstep(0.42, 0.55, length(normal.xz) / max(normal.y, 0.05)); // sand slides there: no ripples
    let octaves = clamp(log2(60.0 / max(2.0 * footprint, 0.05)), 0.0, 7.0);
    let patchy = drift_fbm2(p / 60.0, 23u, octaves, 0.5, 2.1).x;

    var tilt = 0.0;
    if fine > 0.0 {
        tilt += fine * ripple_slope_at(p, wind, ground.ripple_length, 27u) * (0.7 + 0.5 * patchy);
    }
    if broad > 0.0 {
        tilt += 0.30 * broad * ripple_slope_at(p, wind, broad_length, 29u) * smoothstep(0.0, 0.5, patchy);
    }
    let slope = ground.ripple_slope * tilt * lee;
    let bent = normalize(normal - slope * vec3f(wind.x, 0.0, wind.y));
    let sorted = clamp(0.45 + 0.5 * patchy - 0.25 * tilt * lee, 0.0, 1.0);
    return Surface(mix(ground.sand, ground.coarse_sand, sorted), bent);
}
