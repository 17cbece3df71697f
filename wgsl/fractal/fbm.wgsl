// Fractal Brownian motion over any two-dimensional noise: octaves of rising frequency and falling strength.

/// The noise: (value, d/dx, d/dy), value -1 .. 1.
#slot noise2: fn(p: vec2f, seed: u32) -> vec3f

const FBM_MAX_OCTAVES: i32 = 16;
// Each octave is turned by 36.87 degrees (exact in a 3-4-5 triangle) and shifted, so that no two lattices line up.
const FBM_TURN: mat2x2f = mat2x2f(vec2f(0.8, 0.6), vec2f(-0.6, 0.8));
const FBM_SHIFT: vec2f = vec2f(37.31, 17.83);

/// Sum of octaves with its analytic gradient: (value, d/dx, d/dy).
///
/// Octave i has `gain`^i times the strength and `lacunarity`^i times the frequency of the first, which has
/// strength 1 and the noise's own scale. `octaves` may be fractional, 0 .. 16: the last one then has that part of
/// its strength, so that a count which falls with distance does not pop. Range +-`fbm_bound(octaves, gain)`. For
/// noise of Hurst exponent H take gain = lacunarity^-H (Musgrave, in Ebert et al., "Texturing and Modeling").
fn fbm2(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32) -> vec3f {
    var sum = vec3f(0.0);
    var strength = 1.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0)); // from p to this octave's plane
    for (var i = 0; i < FBM_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = noise2(q, seed + u32(i));
        sum += strength * presence * vec3f(n.x, n.yz * to_octave); // a row vector times M is Mᵀ times the vector
        strength *= gain;
        q = lacunarity * (FBM_TURN * q) + FBM_SHIFT;
        to_octave = lacunarity * (FBM_TURN * to_octave);
    }
    return sum;
}

/// As `fbm2`, but each octave is weakened where the ground is steep already: divided by 1 + `damping` |sum of
/// gradients|².
///
/// Smooth valleys and rough heights from the same sum. The second and third component are the sum of the damped
/// octaves' gradients, which is the gradient only as far as the damping itself is constant.
fn fbm2_damped(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32, damping: f32) -> vec3f {
    var sum = vec3f(0.0);
    var slope = vec2f(0.0);
    var strength = 1.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0));
    for (var i = 0; i < FBM_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = noise2(q, seed + u32(i));
        let rise = strength * presence * vec3f(n.x, n.yz * to_octave);
        slope += rise.yz;
        sum += rise / (1.0 + damping * dot(slope, slope));
        strength *= gain;
        q = lacunarity * (FBM_TURN * q) + FBM_SHIFT;
        to_octave = lacunarity * (FBM_TURN * to_octave);
    }
    return sum;
}

/// The largest value that `fbm2` and `fbm2_damped` can reach: 1 + gain + gain² + …, the last octave in part.
fn fbm_bound(octaves: f32, gain: f32) -> f32 {
    var sum = 0.0;
    var strength = 1.0;
    for (var i = 0; i < FBM_MAX_OCTAVES; i++) {
        sum += strength * clamp(octaves - f32(i), 0.0, 1.0);
        strength *= gain;
    }
    return sum;
}
