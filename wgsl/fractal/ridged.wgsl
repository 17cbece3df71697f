// Ridged multifractal over any two-dimensional noise (Musgrave, in Ebert et al., "Texturing and Modeling").

#include <fractal/octaves.wgsl>

/// The noise: (value, d/dx, d/dy), value -1 .. 1.
#slot noise2: fn(p: vec2f, seed: u32) -> vec3f

/// Ridges where the noise crosses zero, with the analytic gradient: (value, d/dx, d/dy).
///
/// The first octave is (1 - |n|)², 0 .. 1. Each later one is the same less its mean, `gain` times as strong as the one
/// before and weighted by what the octave before reached there: crests are rough, hollows smooth. `sharpness` > 0 is
/// how strongly (Musgrave: 2). `roundness`, 0 .. 1, rounds the crests: 0 is a knife's edge, where the gradient jumps,
/// .1 an old range. `octaves` may be fractional, 0 .. 16. Value within `ridged_bound(octaves, gain)`.
fn ridged2(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32, sharpness: f32, roundness: f32) -> vec3f {
    var sum = vec3f(0.0);
    var weight = vec3f(1.0, 0.0, 0.0); // with its gradient
    var strength = 1.0;
    var mean = 0.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0)); // from p to this octave's plane
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = noise2(q + f32(i) * FRACTAL_RIDGE_SHIFT, seed + u32(i));
        let height = sqrt(n.x * n.x + roundness * roundness);
        let ridge = 1.0 - height;
        let slope = -2.0 * ridge * (n.x / max(height, 1e-6)) * (n.yz * to_octave); // of ridge², row vector times M
        let signal = vec3f(ridge * ridge, slope);
        let centred = signal.x - mean;
        sum += strength * presence * vec3f(weight.x * centred, weight.x * signal.yz + weight.yz * centred);
        // Musgrave clamps sharpness · signal to 1; this parabola gets there without a kink, so the gradient is
        // continuous.
        let rest = max(1.0 - 0.5 * sharpness * signal.x, 0.0);
        weight = vec3f(1.0 - rest * rest, rest * sharpness * signal.yz);
        mean = FRACTAL_MEAN_RIDGE;
        strength *= gain;
        q = lacunarity * (FRACTAL_TURN * q);
        to_octave = lacunarity * (FRACTAL_TURN * to_octave);
    }
    return sum;
}

/// The lowest and the highest value that `ridged2` can reach: -0.606 b and 1 + 0.394 b where b = gain + gain² + … .
fn ridged_bound(octaves: f32, gain: f32) -> vec2f {
    let first = min(octaves, 1.0);
    let later = octave_sum(octaves, gain) - first;
    return vec2f(-FRACTAL_MEAN_RIDGE * later, first + (1.0 - FRACTAL_MEAN_RIDGE) * later);
}

/// A slope that `ridged2` nowhere exceeds, where the noise itself nowhere exceeds `noise_slope`: its Lipschitz bound.
///
/// An octave of frequency f rises by at most 2 f · noise_slope, its weight by 1.0887 sqrt(sharpness) times the slope of
/// the noise one octave before (at signal = 2/(3 sharpness)), on a signal at most 0.606 off its mean.
fn ridged_slope_bound(octaves: f32, gain: f32, lacunarity: f32, sharpness: f32, noise_slope: f32) -> f32 {
    let all = octave_sum(octaves, gain * lacunarity);
    let later = all - min(octaves, 1.0);
    return noise_slope * (2.0 * all + FRACTAL_MEAN_RIDGE * 1.0887 * sqrt(sharpness) / lacunarity * later);
}
