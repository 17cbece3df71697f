// Fractal Brownian motion over any three-dimensional noise.

#include <fractal/octaves.wgsl>

/// The noise: (value, d/dx, d/dy, d/dz), value -1 .. 1.
#slot noise3: fn(p: vec3f, seed: u32) -> vec4f

// A rotation by 115.4 degrees about an axis off the lattice's planes: rows (-2, -3, -6)/7, (-3, 6, -2)/7, (6, 2, -3)/7.
const FBM3_TURN: mat3x3f = mat3x3f(
    vec3f(-0.28571429, -0.42857143, 0.85714286),
    vec3f(-0.42857143, 0.85714286, 0.28571429),
    vec3f(-0.85714286, -0.28571429, -0.42857143),
);
const FBM3_SHIFT: vec3f = vec3f(37.31, 17.83, 53.47);

/// Sum of octaves with its analytic gradient: (value, d/dx, d/dy, d/dz).
///
/// As `fbm2` of <fractal/fbm.wgsl>: octave i has `gain`^i times the strength and `lacunarity`^i times the frequency of
/// the first; `octaves` may be fractional, 0 .. 16. Range +-`fbm3_bound(octaves, gain)`.
fn fbm3(p: vec3f, seed: u32, octaves: f32, gain: f32, lacunarity: f32) -> vec4f {
    var sum = vec4f(0.0);
    var strength = 1.0;
    var q = p;
    var to_octave = mat3x3f(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0));
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = noise3(q + f32(i) * FBM3_SHIFT, seed + u32(i));
        sum += strength * presence * vec4f(n.x, n.yzw * to_octave); // a row vector times M is Mᵀ times the vector
        strength *= gain;
        q = lacunarity * (FBM3_TURN * q);
        to_octave = lacunarity * (FBM3_TURN * to_octave);
    }
    return sum;
}

/// As `fbm3`, divided by `fbm3_bound(octaves, gain)`: value -1 .. 1 whatever the octaves. `octaves` > 0.
fn fbm3_normalized(p: vec3f, seed: u32, octaves: f32, gain: f32, lacunarity: f32) -> vec4f {
    return fbm3(p, seed, octaves, gain, lacunarity) / max(fbm3_bound(octaves, gain), 1e-6);
}

/// The largest value that `fbm3` can reach: 1 + gain + gain² + …, the last octave in part.
fn fbm3_bound(octaves: f32, gain: f32) -> f32 {
    return octave_sum(octaves, gain);
}

/// A slope that `fbm3` nowhere exceeds, where the noise itself nowhere exceeds `noise_slope`: its Lipschitz bound.
fn fbm3_slope_bound(octaves: f32, gain: f32, lacunarity: f32, noise_slope: f32) -> f32 {
    return noise_slope * octave_sum(octaves, gain * lacunarity);
}
