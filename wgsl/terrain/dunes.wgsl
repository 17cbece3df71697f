// A sea of sand: trains of dunes, gentle to windward and at the angle of repose to leeward, running into each other.

#include <math/rotation.wgsl>
#include <fractal/fbm.wgsl> as sand with noise2 = perlin_noise2_grad
#include <noise/perlin.wgsl>
#include <terrain/height.wgsl>

/// Where the wind blows to, clockwise from north.
#param dunes.wind: f32 = 60.0, range -360 .. 360, unit deg
/// Distance from one crest to the next.
#param dunes.spacing: f32 = 320.0, range 5 .. 5000, unit m
/// Height of the crests over the hollows.
#param dunes.crest_height: f32 = 38.0, range 0 .. 500, unit m
/// How steep dry sand can stand.
#param dunes.repose: f32 = 32.5, range 10 .. 45, unit deg
/// How much the crests wind about: 0 straight, 1 sinuous.
#param dunes.sinuosity: f32 = 0.8, range 0 .. 2

/// A train of dunes: height (m) at `p` (m), 0 .. `crest`.
///
/// `heading`: where the wind blows to (rad), `spacing` and `crest` (m). Crests wander by a slow noise, and fade in
/// and out.
fn dune_train(p: vec2f, heading: f32, spacing: f32, crest: f32, sinuosity: f32, seed: u32) -> f32 {
    let wind = vec2f(sin(heading), -cos(heading));
    let along = dot(p, wind);
    let across = dot(p, vec2f(-wind.y, wind.x));
    let q = vec2f(along / (3.1 * spacing), across / (2.2 * spacing));
    let wander = sand_fbm2(q, seed, 3.0, 0.42, 2.1).x;
    let presence = smoothstep(-0.75, 0.35, perlin_noise2(q * 0.9 + vec2f(11.3, 5.1), seed + 31u));
    let height = crest * (0.25 + 0.75 * presence);
    let phase = along / spacing + sinuosity * wander;
    let x = fract(phase);
    // The lee side is as long as sand at the angle of repose needs.
    let lee = clamp(height / (tan(dunes.repose) * spacing), 0.06, 0.6);
    let windward = x / (1.0 - lee);
    let fallen = clamp((x - (1.0 - lee)) / lee, 0.0, 1.0);
    let rise = windward * windward * (2.1 - 1.1 * windward);
    return height * select(rise, 1.0 - fallen, x > 1.0 - lee);
}

/// Height (m) of the sand at `p` (m).
fn dunes_height(p: vec2f, octaves: f32, footprint: f32) -> f32 {
    let spacing = dunes.spacing;
    let crest = dunes.crest_height;
    let first = dune_train(p, dunes.wind, spacing, crest, dunes.sinuosity, terrain.seed);
    let second = dune_train(p, dunes.wind + 0.55, 0.71 * spacing, 0.66 * crest, dunes.sinuosity, terrain.seed + 57u);
    let third = dune_train(p, dunes.wind - 0.40, 0.23 * spacing, 0.15 * crest, dunes.sinuosity, terrain.seed + 91u);
    let great = max(first, second);
    let floor_height = 0.8 * crest * sand_fbm2(p / (6.0 * spacing), terrain.seed + 7u, min(octaves, 3.0), 0.5, 2.0).x;
    // Small dunes ride on the windward sides and between, and die out toward the great crests.
    let room = 1.0 - smoothstep(0.35, 0.9, great / max(crest, 1e-3));
    return floor_height + great + third * (0.25 + 0.75 * room);
}

/// A height (m) that the sand nowhere exceeds.
fn dunes_ceiling() -> f32 {
    return dunes.crest_height * (1.0 + 0.15 + 0.8 * 1.75);
}
