// Ridged multifractal over any two-dimensional noise (Musgrave, in Ebert et al., "Texturing and Modeling").

/// The noise: (value, d/dx, d/dy), value -1 .. 1.
#slot noise2: fn(p: vec2f, seed: u32) -> vec3f

const RIDGED_MAX_OCTAVES: i32 = 16;
const RIDGED_TURN: mat2x2f = mat2x2f(vec2f(0.8, 0.6), vec2f(-0.6, 0.8)); // 36.87 degrees an octave
const RIDGED_SHIFT: vec2f = vec2f(-21.67, 43.19);
// Mean of (1 - |n|)² for gradient noise. Later octaves are centred on it, so that leaving one out does not sink the
// land.
const MEAN_RIDGE: f32 = 0.606;

/// Ridges where the noise crosses zero, with the analytic gradient: (value, d/dx, d/dy).
///
/// The first octave is (1 - |n|)², 0 .. 1. Each later one is the same less its mean, `gain` times as strong as the one
/// before and weighted by what the octave before reached there: crests are rough, hollows smooth. `sharpness` > 0 is how
/// strongly (Musgrave: 2). `roundness` rounds the crests: 0 is a knife's edge, .1 an old range. `octaves` may be
/// fractional, 0 .. 16. Value within -0.606 b .. 1 + 0.394 b where b = gain + gain² + … .
fn ridged2(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32, sharpness: f32, roundness: f32) -> vec3f {
    var sum = vec3f(0.0);
    var weight = vec3f(1.0, 0.0, 0.0); // with its gradient
    var strength = 1.0;
    var mean = 0.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0)); // from p to this octave's plane
    for (var i = 0; i < RIDGED_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = noise2(q, seed + u32(i));
        let height = sqrt(n.x * n.x + roundness * roundness);
        let ridge = 1.0 - height;
        let slope = -2.0 * ridge * (n.x / max(height, 1e-6)) * (n.yz * to_octave); // of ridge², row vector times M
        let signal = vec3f(ridge * ridge, slope);
        let centred = signal.x - mean;
        sum += strength * presence * vec3f(weight.x * centred, weight.x * signal.yz + weight.yz * centred);
        // Musgrave clamps sharpness · signal to 1; this parabola gets there without a kink, so the gradient is continuous.
        let rest = max(1.0 - 0.5 * sharpness * signal.x, 0.0);
        weight = vec3f(1.0 - rest * rest, rest * sharpness * signal.yz);
        mean = MEAN_RIDGE;
        strength *= gain;
        q = lacunarity * (RIDGED_TURN * q) + RIDGED_SHIFT;
        to_octave = lacunarity * (RIDGED_TURN * to_octave);
    }
    return sum;
}
