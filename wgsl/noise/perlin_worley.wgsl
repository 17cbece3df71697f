// Perlin-Worley noise (Schneider 2015, "The Real-time Volumetric Cloudscapes of Horizon: Zero Dawn").
//
// Connected like Perlin noise, billowing like inverted Worley noise: the base of clouds.

#include <math/remap.wgsl>
#include <noise/perlin.wgsl>
#include <noise/worley.wgsl>

/// Perlin-Worley noise in space, 0 .. 1, repeating every `period` cells along each axis; any period from 1 to 2^29.
///
/// `remap(perlin, 0, 1, worley, 1)`: three octaves of Perlin noise, carried to 0 .. 1, lift three octaves of inverted
/// Worley noise, weighted .625, .25 and .125. p and p + period give the same bits. Costly: made to be baked or seldom
/// called.
fn perlin_worley3_tiled(p: vec3f, period: vec3u, seed: u32) -> f32 {
    var perlin = 0.0;
    var worley = 0.0;
    var scale = 1u;
    for (var octave = 0u; octave < 3u; octave++) {
        let q = p * f32(scale);
        let weight = select(0.5 / f32(scale), 0.625, octave == 0u);
        perlin += perlin_noise3_tiled(q, period * scale, seed + octave).x / f32(scale);
        worley += weight * (1.0 - worley_noise3_tiled(q, period * scale, seed + octave).f1 * inverseSqrt(3.0));
        scale *= 2u;
    }
    return remap(0.5 + 0.5 * perlin / 1.75, 0.0, 1.0, worley, 1.0);
}
