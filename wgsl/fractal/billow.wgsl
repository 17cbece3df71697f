// Billow over any two-dimensional noise: octaves of |noise|, round hills between sharp creases.

#include <fractal/octaves.wgsl>

/// The noise: (value, d/dx, d/dy), value -1 .. 1.
#slot noise2: fn(p: vec2f, seed: u32) -> vec3f

// Mean of |n| for gradient noise. Later octaves are centred on it, so that leaving one out does not sink the land.
const MEAN_BILLOW: f32 = 0.245;

/// Round hills between creases where the noise crosses zero, with the analytic gradient: (value, d/dx, d/dy).
///
/// The first octave is |n|, 0 .. 1 (Perlin 1985, "turbulence"). Each later one is the same less its mean, `gain` times
/// as strong as the one before. `roundness` >= 0 rounds the creases: |n| becomes (sqrt(n² + r²) - r)/(sqrt(1 + r²) -
/// r), still 0 .. 1; at 0 the gradient jumps where an octave crosses zero. `octaves` may be fractional, 0 .. 16. Value
/// within `billow_bound(octaves, gain)`.
fn billow2(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32, roundness: f32) -> vec3f {
    let scale = 1.0 / (sqrt(1.0 + roundness * roundness) - roundness);
    var sum = vec3f(0.0);
    var strength = 1.0;
    var mean = 0.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0)); // from p to this octave's plane
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = noise2(q + f32(i) * FRACTAL_SHIFT, seed + u32(i));
        let height = sqrt(n.x * n.x + roundness * roundness);
        let slope = (scale * n.x / max(height, 1e-9)) * (n.yz * to_octave); // row vector times M: Mᵀ times the vector
        sum += strength * presence * vec3f(scale * (height - roundness) - mean, slope);
        mean = MEAN_BILLOW;
        strength *= gain;
        q = lacunarity * (FRACTAL_TURN * q);
        to_octave = lacunarity * (FRACTAL_TURN * to_octave);
    }
    return sum;
}

/// The lowest and the highest value that `billow2` can reach: -0.245 b and 1 + 0.755 b where b = gain + gain² + … .
fn billow_bound(octaves: f32, gain: f32) -> vec2f {
    let first = min(octaves, 1.0);
    let later = octave_sum(octaves, gain) - first;
    return vec2f(-MEAN_BILLOW * later, first + (1.0 - MEAN_BILLOW) * later);
}

/// A slope that `billow2` nowhere exceeds, where the noise itself nowhere exceeds `noise_slope`: its Lipschitz bound.
///
/// Rounded, |n| is steepest at 1: there by 1/(sqrt(1 + r²) (sqrt(1 + r²) - r)).
fn billow_slope_bound(octaves: f32, gain: f32, lacunarity: f32, roundness: f32, noise_slope: f32) -> f32 {
    let far = sqrt(1.0 + roundness * roundness);
    return noise_slope * octave_sum(octaves, gain * lacunarity) / (far * (far - roundness));
}
