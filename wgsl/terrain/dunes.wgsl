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

/// A train of dunes: (height in m, its slope) at `p` (m), 0 .. `crest` m high.
///
/// `heading`: where the wind blows to (rad), `spacing` and `crest` (m). Crests wander by a slow noise, and fade in
/// and out. Values with their gradients are carried through as one `vec3f` each.
fn dune_train(p: vec2f, heading: f32, spacing: f32, crest: f32, sinuosity: f32, seed: u32) -> vec3f {
    let wind = vec2f(sin(heading), -cos(heading));
    let side = vec2f(-wind.y, wind.x);
    let along = vec3f(dot(p, wind), wind);
    let q = vec2f(along.x / (3.1 * spacing), dot(p, side) / (2.2 * spacing));
    let to_plane = mat2x2f(wind / (3.1 * spacing), side / (2.2 * spacing)); // a gradient in q times this is one in p

    let wander = sand_fbm2(q, seed, 3.0, 0.42, 2.1);
    let phase = along / spacing + sinuosity * vec3f(wander.x, to_plane * wander.yz);
    let x = vec3f(fract(phase.x), phase.yz);

    let fades = perlin_noise2_grad(q * 0.9 + vec2f(11.3, 5.1), seed + 31u);
    let t = clamp((fades.x + 0.75) / 1.1, 0.0, 1.0); // smoothstep from -0.75 to 0.35
    let presence = vec3f(t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / 1.1 * 0.9 * (to_plane * fades.yz));
    let height = crest * (vec3f(0.25, 0.0, 0.0) + 0.75 * presence);

    // The lee side is as long as sand at the angle of repose needs.
    var lee = height / (tan(dunes.repose) * spacing);
    if lee.x < 0.06 || lee.x > 0.6 {
        lee = vec3f(clamp(lee.x, 0.06, 0.6), 0.0, 0.0);
    }
    var profile: vec3f;
    if x.x > 1.0 - lee.x {
        let fallen = (x.x - 1.0 + lee.x) / lee.x;
        profile = vec3f(1.0 - fallen, -(x.yz + (1.0 - fallen) * lee.yz) / lee.x);
    } else {
        let windward = x.x / (1.0 - lee.x);
        let slope = (x.yz + windward * lee.yz) / (1.0 - lee.x);
        profile = vec3f(windward * windward * (2.1 - 1.1 * windward), windward * (4.2 - 3.3 * windward) * slope);
    }
    return vec3f(height.x * profile.x, height.x * profile.yz + profile.x * height.yz);
}

/// Height of the sand (m) and its slope at `p` (m).
fn dunes_height_grad(p: vec2f, octaves: f32) -> vec3f {
    let spacing = dunes.spacing;
    let crest = dunes.crest_height;
    var trains: array<vec3f, 3>;
    for (var i = 0; i < 3; i++) { // a loop: compilers copy a function into every place that it is called from
        let turn = select(select(-0.40, 0.55, i == 1), 0.0, i == 0);
        let size = select(select(0.23, 0.71, i == 1), 1.0, i == 0);
        let strength = select(select(0.15, 0.66, i == 1), 1.0, i == 0);
        let seed = terrain.seed + select(select(91u, 57u, i == 1), 0u, i == 0);
        trains[i] = dune_train(p, dunes.wind + turn, size * spacing, strength * crest, dunes.sinuosity, seed);
    }
    let great = select(trains[1], trains[0], trains[0].x > trains[1].x);
    let swell = 0.8 * crest * sand_fbm2(p / (6.0 * spacing), terrain.seed + 7u, min(octaves, 3.0), 0.5, 2.0);
    // Small dunes ride on the windward sides and between, and die out toward the great crests.
    let t = clamp((great.x / max(crest, 1e-3) - 0.35) / 0.55, 0.0, 1.0);
    let room = 1.0 - 0.75 * t * t * (3.0 - 2.0 * t);
    let closing = -4.5 * t * (1.0 - t) / (0.55 * max(crest, 1e-3));
    let slope = swell.yz / (6.0 * spacing) + great.yz + room * trains[2].yz + trains[2].x * closing * great.yz;
    return vec3f(swell.x + great.x + room * trains[2].x, slope);
}

/// A height (m) that the sand nowhere exceeds.
fn dunes_ceiling() -> f32 {
    return dunes.crest_height * (1.0 + 0.15 + 0.8 * 1.75);
}

/// A height (m) that the sand nowhere falls below.
fn dunes_floor() -> f32 {
    return -dunes.crest_height * 0.8 * 1.75;
}
