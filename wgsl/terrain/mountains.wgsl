// Mountains and hills: where the land is high it is rugged, and water has cut gullies into its slopes.

#include <fractal/fbm.wgsl> as relief with noise2 = terrain_noise
#include <fractal/gullies.wgsl>
#include <fractal/ridged.wgsl> as range with noise2 = terrain_noise
#include <terrain/basis.wgsl>
#include <terrain/height.wgsl>

/// Height of the highest peaks above the valley floors.
#param terrain.peak_height: f32 = 2400.0, range 0 .. 9000, unit m
/// How many times stronger an octave is than the next finer one is 1 / gain: the land's roughness.
#param terrain.gain: f32 = 0.45, range 0.1 .. 0.9
/// How many times finer an octave is than the one before.
#param terrain.lacunarity: f32 = 2.02, range 1.5 .. 3
/// How sharp the ridges are: 0 a knife's edge, 0.3 worn hills.
#param terrain.roundness: f32 = 0.08, range 0 .. 1
/// How much of the land is valley: -1 none, 1 nearly all.
#param terrain.valleys: f32 = 0.0, range -1 .. 1
/// How deep water has cut into the slopes.
#param terrain.gully_depth: f32 = 220.0, range 0 .. 2000, unit m
/// How wide the widest gullies are.
#param terrain.gully_width: f32 = 900.0, range 10 .. 20000, unit m
/// Height of the roughness on top of it all: boulders, humps and hollows.
#param terrain.detail: f32 = 110.0, range 0 .. 500, unit m

const DETAIL_OCTAVE: f32 = 4.0; // the octave at which roughness begins: a sixteenth of the scale

/// Height (m) at `p` (m) of the first `octaves` octaves, which may be fractional; for 0 and less only the lie of
/// the land.
///
/// Costly: up to `terrain.octaves` + 4 noises and five generations of gullies.
fn mountains_height_grad(p: vec2f, octaves: f32) -> vec3f {
    let q = p / terrain.scale;
    // Where the mountains are: a map of its own, much coarser than they.
    let region = terrain_noise(0.31 * q + vec2f(3.7, 9.2), terrain.seed + 101u);
    let rugged = smoothstep(-0.45, 0.5, region.x - terrain.valleys * 0.5);

    let coarse = min(octaves, DETAIL_OCTAVE);
#if terrain.relief == fbm
    let noise = relief_fbm2_damped(q, terrain.seed, coarse, terrain.gain, terrain.lacunarity, 0.25);
    let forms = vec3f(0.5, 0.0, 0.0) + 0.5 * noise;
    let rounded = forms;
#else
    let roundness = mix(max(0.2, terrain.roundness), terrain.roundness, rugged); // no sharp crests in the lowlands
    let forms = range_ridged2(q, terrain.seed, coarse, terrain.gain, terrain.lacunarity, 2.0, roundness);
    // Water follows the broad slopes: those of the sharp crests turn about within a few metres, and would tear
    // its gullies.
    let rounded = range_ridged2(q, terrain.seed, min(coarse, 3.0), terrain.gain, terrain.lacunarity, 2.0, 0.25);
#endif
    let swell = terrain.peak_height * (0.08 + 0.80 * rugged);
    var land = vec3f(swell, vec2f(swell / terrain.scale)) * forms;
    land.x += 0.12 * terrain.peak_height * rugged;

    // Water.
    let gully_octaves = min(5.0, octaves - log2(terrain.scale / terrain.gully_width) + 1.0);
    let catchment = smoothstep(0.10, 0.40, land.x / max(terrain.peak_height, 1.0)); // low hills shed little water
    let downhill = 1.7 * swell / terrain.scale * rounded.yz; // rounding took about that much of the slope
    let depth = terrain.gully_depth * catchment;
    let cut = gullies2(p, downhill, terrain.gully_width, depth, 0.55, gully_octaves, 0.43, terrain.seed + 211u);
    land += cut;

    // Roughness, most where it is steep.
    let steep = smoothstep(0.1, 1.0, length(land.yz));
    let fine = relief_fbm2(16.0 * q, terrain.seed + 307u, octaves - DETAIL_OCTAVE, 0.58, terrain.lacunarity);
    land.x += terrain.detail * (0.08 + 0.92 * steep) * fine.x;
    return land;
}

/// A height (m) that the mountains nowhere exceed.
fn mountains_ceiling() -> f32 {
    let rest = terrain.gain / (1.0 - terrain.gain);
#if terrain.relief == fbm
    let forms = 1.0 + 0.5 * rest;
#else
    let forms = 1.0 + 0.394 * rest;
#endif
    return terrain.peak_height * (0.12 + 0.88 * forms) + terrain.gully_depth + 2.4 * terrain.detail;
}
