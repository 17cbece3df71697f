// Fractal Brownian motion over any two-dimensional noise: octaves of rising frequency and falling strength.

#include <fractal/octaves.wgsl>

/// The noise: (value, d/dx, d/dy), value -1 .. 1.
#slot noise2: fn(p: vec2f, seed: u32) -> vec3f

/// Sum of octaves with its analytic gradient: (value, d/dx, d/dy).
///
/// Octave i has `gain`^i times the strength and `lacunarity`^i times the frequency of the first, which has
/// strength 1 and the noise's own scale. `octaves` may be fractional, 0 .. 16: the last one then has that part of
/// its strength, so that a count which falls with distance does not pop. Range +-`fbm_bound(octaves, gain)`. For
/// noise of Hurst exponent H take gain = lacunarity^-H (`fbm_gain`; Musgrave, in Ebert et al., "Texturing and
/// Modeling").
fn fbm2(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32) -> vec3f {
    return fbm2_turned(p, seed, octaves, gain, lacunarity, FRACTAL_TURN, FRACTAL_SHIFT);
}

/// As `fbm2`, divided by `fbm_bound(octaves, gain)`: value -1 .. 1 whatever the octaves. `octaves` > 0.
fn fbm2_normalized(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32) -> vec3f {
    return fbm2(p, seed, octaves, gain, lacunarity) / max(fbm_bound(octaves, gain), 1e-6);
}

/// As `fbm2`, with the rotation `turn` from one octave to the next and the offset `shift` (in an octave's own cells) an
/// octave: octave i is looked up at (lacunarity · turn)^i p + i · shift.
///
/// Without either (identity, 0) all lattices have their corners in common, and show. The gradient is exact for any
/// matrix; `fbm_slope_bound` holds for rotations.
fn fbm2_turned(
    p: vec2f,
    seed: u32,
    octaves: f32,
    gain: f32,
    lacunarity: f32,
    turn: mat2x2f,
    shift: vec2f,
) -> vec3f {
    var sum = vec3f(0.0);
    var strength = 1.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0)); // from p to this octave's plane
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = noise2(q + f32(i) * shift, seed + u32(i));
        sum += strength * presence * vec3f(n.x, n.yz * to_octave); // a row vector times M is Mᵀ times the vector
        strength *= gain;
        q = lacunarity * (turn * q);
        to_octave = lacunarity * (turn * to_octave);
    }
    return sum;
}

/// The largest value that `fbm2` can reach: 1 + gain + gain² + …, the last octave in part.
fn fbm_bound(octaves: f32, gain: f32) -> f32 {
    return octave_sum(octaves, gain);
}

/// A slope that `fbm2` nowhere exceeds, where the noise itself nowhere exceeds `noise_slope`: its Lipschitz bound.
fn fbm_slope_bound(octaves: f32, gain: f32, lacunarity: f32, noise_slope: f32) -> f32 {
    return noise_slope * octave_sum(octaves, gain * lacunarity);
}
