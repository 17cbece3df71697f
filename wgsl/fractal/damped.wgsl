// Derivative-damped fBm over any two-dimensional noise: smooth slopes, rough where the land is level.

#include <fractal/octaves.wgsl>
#include <math/jet.wgsl>

/// The noise with its first and second derivatives, value -1 .. 1.
#slot noise2: fn(p: vec2f, seed: u32) -> Jet2

/// Sum of octaves, each divided by 1 + `damping` |G|² where G is the gradient of the sum of this octave and those
/// before it, undamped; with the exact gradient: (value, d/dx, d/dy).
///
/// Where the coarse octaves are steep the fine ones are weak (Quilez 2008, "Value noise derivatives"). The gradient
/// needs the noise's second derivatives, for the damping varies too. `octaves` may be fractional, 0 .. 16; `damping` >=
/// 0, 0 being fBm: the octaves are those of `fbm2`. Range +-`damped_bound(octaves, gain)`.
fn damped2(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32, damping: f32) -> vec3f {
    var sum = vec3f(0.0);
    var slope = vec2f(0.0); // G
    var bend = vec3f(0.0); // its derivatives: xx, xy, yy
    var strength = 1.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0)); // from p to this octave's plane
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = jet2_carried(noise2(q + f32(i) * FRACTAL_SHIFT, seed + u32(i)), to_octave);
        let octave = jet2_scaled(n, strength * presence);
        slope += octave.gradient;
        bend += octave.hessian;
        let kept = 1.0 / (1.0 + damping * dot(slope, slope));
        // Gradient of `kept`: -2 damping kept² (G's derivatives) G.
        let kept_slope = -2.0 * damping * kept * kept * vec2f(dot(bend.xy, slope), dot(bend.yz, slope));
        sum += vec3f(kept * octave.value, kept * octave.gradient + octave.value * kept_slope);
        strength *= gain;
        q = lacunarity * (FRACTAL_TURN * q);
        to_octave = lacunarity * (FRACTAL_TURN * to_octave);
    }
    return sum;
}

/// The largest value that `damped2` can reach: that of the undamped sum, 1 + gain + gain² + … .
fn damped_bound(octaves: f32, gain: f32) -> f32 {
    return octave_sum(octaves, gain);
}

/// A slope that `damped2` nowhere exceeds, where the noise's slope nowhere exceeds `noise_slope` and its second
/// derivative in any direction `noise_bend`: its Lipschitz bound.
///
/// 2 damping |G| / (1 + damping |G|²)² is at most 0.6496 sqrt(damping), where damping |G|² = 1/3. Far from tight at
/// many octaves: 2 to 5 times what is found.
fn damped_slope_bound(
    octaves: f32,
    gain: f32,
    lacunarity: f32,
    damping: f32,
    noise_slope: f32,
    noise_bend: f32,
) -> f32 {
    var bound = noise_slope * octave_sum(octaves, gain * lacunarity);
    var strength = 1.0;
    var bend = 0.0; // of the octaves so far
    var frequency = 1.0;
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let present = clamp(octaves - f32(i), 0.0, 1.0) * strength;
        bend += present * frequency * frequency * noise_bend;
        bound += present * 0.6496 * sqrt(damping) * bend;
        strength *= gain;
        frequency *= lacunarity;
    }
    return bound;
}
