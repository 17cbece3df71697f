// The land as a plain sum of octaves, one at a time, with what each can reach: what a march needs that misses nothing.

#include <fractal/octaves.wgsl>
#include <noise/perlin.wgsl>
#include <noise/simplex.wgsl>
#include <noise/value.wgsl>
#include <terrain/basis.wgsl>
#include <terrain/height.wgsl>
#include <terrain/mountains.wgsl>

// What the noise nowhere exceeds: value, slope, curvature.
#if terrain.basis == perlin
const BASIS_BOUNDS: vec3f = vec3f(PERLIN_NOISE2_RANGE, PERLIN_NOISE2_SLOPE, PERLIN_NOISE2_CURVATURE);
#elif terrain.basis == simplex
const BASIS_BOUNDS: vec3f = vec3f(SIMPLEX_NOISE2_RANGE, SIMPLEX_NOISE2_SLOPE, SIMPLEX_NOISE2_CURVATURE);
#else
const BASIS_BOUNDS: vec3f = vec3f(VALUE_NOISE2_RANGE, VALUE_NOISE2_SLOPE, VALUE_NOISE2_CURVATURE);
#endif

#if terrain.dual
const WIDE_OCTAVES: i32 = 2; // those of the wide map come first
#else
const WIDE_OCTAVES: i32 = 0;
#endif

/// Mean height (m) that the octaves stand on.
fn sum_base() -> f32 {
#if terrain.dual
    return 0.5 * terrain.uplift;
#else
    return 0.5 * terrain.peak_height;
#endif
}

/// Octave `index` at `p` (m): its height (m) and its slope along both axes.
fn sum_octave(p: vec2f, index: i32) -> vec3f {
    let wide = index < WIDE_OCTAVES;
    let number = select(index - WIDE_OCTAVES, index, wide);
    var lacunarity = terrain.lacunarity;
    var place = p / terrain.scale;
    var to_octave = mat2x2f(vec2f(1.0 / terrain.scale, 0.0), vec2f(0.0, 1.0 / terrain.scale));
    var strength = 0.5 * terrain.peak_height * pow(terrain.gain, f32(number));
    var seed = terrain.seed;
    if wide {
        lacunarity = WIDE_LACUNARITY;
        place = p / terrain.region + WIDE_PLACE;
        to_octave = mat2x2f(vec2f(1.0 / terrain.region, 0.0), vec2f(0.0, 1.0 / terrain.region));
        strength = 0.5 * terrain.uplift * pow(WIDE_GAIN, f32(number));
        seed += WIDE_SEED;
    }
    for (var i = 0; i < number; i++) {
        place = lacunarity * (FRACTAL_TURN * place);
        to_octave = lacunarity * (FRACTAL_TURN * to_octave);
    }
    let n = terrain_noise(place + f32(number) * FRACTAL_SHIFT, seed + u32(number));
    let octave = strength * vec3f(n.x, n.yz * to_octave);
#if terrain.dual
    if index == WIDE_OCTAVES {
        return vec3f(octave.x + 0.5 * terrain.peak_height, octave.yz); // the mean of the rugged part, as rugged as it
    }
#endif
    return octave;
}

/// What octave `index` nowhere exceeds in size: height (m), slope, curvature (1/m).
fn sum_octave_bounds(index: i32) -> vec3f {
    let wide = index < WIDE_OCTAVES;
    let number = f32(select(index - WIDE_OCTAVES, index, wide));
    var strength = 0.5 * terrain.peak_height * pow(terrain.gain, number);
    var frequency = pow(terrain.lacunarity, number) / terrain.scale;
    if wide {
        strength = 0.5 * terrain.uplift * pow(WIDE_GAIN, number);
        frequency = pow(WIDE_LACUNARITY, number) / terrain.region;
    }
    var bounds = 1.001 * strength * BASIS_BOUNDS * vec3f(1.0, frequency, frequency * frequency);
#if terrain.dual
    bounds.x += select(0.0, 0.5 * terrain.peak_height, index == WIDE_OCTAVES);
#endif
    return bounds;
}

/// The part of the finer octaves that counts where the wide map adds up to `height` (m), and how fast it rises at most.
fn sum_ruggedness(height: f32) -> vec2f {
#if terrain.dual
    let metres = 0.5 * max(terrain.uplift, 1.0);
    let middle = 0.5 * terrain.valleys;
    let rugged = smoothstep(middle - 0.45, middle + 0.5, height / metres);
    let share = 1.0 - terrain.lowland;
    return vec2f(terrain.lowland + share * rugged, 1.5 / 0.95 * share / metres);
#else
    return vec2f(1.0, 0.0);
#endif
}
