// Hybrid multifractal over any two-dimensional noise (Musgrave, in Ebert et al., "Texturing and Modeling"): valleys are
// smooth, and the higher the land the rougher it is.

#include <fractal/octaves.wgsl>

/// The noise: (value, d/dx, d/dy), value -1 .. 1.
#slot noise2: fn(p: vec2f, seed: u32) -> vec3f

/// Octaves of noise + `offset`, each weighted by what those before reached there, with the analytic gradient: (value,
/// d/dx, d/dy).
///
/// Octave i has `gain`^i times the strength and `lacunarity`^i times the frequency of the first; the weight is the
/// product of all octaves before, at most 1. Musgrave (`offset` 0.7, gain = lacunarity^-0.25) cuts it off there; here a
/// parabola leads up to 1, so that the gradient is continuous. `offset` 0 .. 1. `octaves` may be fractional, 0 .. 16;
/// as the terms are not centred, land with fewer octaves lies lower. Value within `hybrid_bound(octaves, gain,
/// offset)`.
fn hybrid2(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32, offset: f32) -> vec3f {
    var sum = vec3f(0.0);
    var weight = vec3f(1.0, 0.0, 0.0); // with its gradient
    var strength = 1.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0)); // from p to this octave's plane
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = noise2(q + f32(i) * FRACTAL_SHIFT, seed + u32(i));
        let signal = strength * vec3f(n.x + offset, n.yz * to_octave); // a row vector times M is Mᵀ times the vector
        let term = vec3f(weight.x * signal.x, weight.x * signal.yz + weight.yz * signal.x);
        sum += presence * term;
        let limited = hybrid_limit(term.x);
        weight = vec3f(limited.x, limited.y * term.yz);
        strength *= gain;
        q = lacunarity * (FRACTAL_TURN * q);
        to_octave = lacunarity * (FRACTAL_TURN * to_octave);
    }
    return sum;
}

/// min(weight, 1) with the corner rounded, and its slope: w below 0, w - w²/4 from there to 2, 1 above.
fn hybrid_limit(weight: f32) -> vec2f {
    let w = min(weight, 2.0);
    let above = max(w, 0.0);
    return vec2f(w - 0.25 * above * above, select(0.0, 1.0 - 0.5 * above, weight < 2.0));
}

/// The lowest and the highest value that `hybrid2` can reach with an `offset` of 0 .. 1.
fn hybrid_bound(octaves: f32, gain: f32, offset: f32) -> vec2f {
    var bound = vec2f(0.0);
    var weight = vec2f(0.0, 1.0); // lowest and highest
    var strength = 1.0;
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        let low = strength * (offset - 1.0);
        let high = strength * (offset + 1.0);
        let term = vec2f(min(weight.y * low, weight.x * high), max(weight.y * high, weight.x * low));
        bound += presence * term;
        weight = vec2f(term.x, hybrid_limit(term.y).x);
        strength *= gain;
    }
    return bound;
}

/// A slope that `hybrid2` nowhere exceeds, where the noise itself nowhere exceeds `noise_slope`: its Lipschitz bound.
fn hybrid_slope_bound(octaves: f32, gain: f32, lacunarity: f32, offset: f32, noise_slope: f32) -> f32 {
    var bound = 0.0;
    var weight = 1.0; // the largest, either side of 0
    var weight_slope = 0.0;
    var strength = 1.0;
    var frequency = 1.0;
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        let slope = strength * (weight * frequency * noise_slope + weight_slope * (1.0 + offset));
        bound += presence * slope;
        weight = min(weight * strength * (1.0 + offset), 1.0);
        weight_slope = slope; // the limit is nowhere steeper than 1
        strength *= gain;
        frequency *= lacunarity;
    }
    return bound;
}
