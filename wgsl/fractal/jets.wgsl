// Fractals with their second derivatives: what erosion stands on.
//
// The same surfaces as `fbm2`, `ridged2` and `hybrid2` of the files beside this one, at up to twice their cost.

#include <fractal/octaves.wgsl>
#include <math/jet.wgsl>

/// The noise with its first and second derivatives, value -1 .. 1.
#slot noise2: fn(p: vec2f, seed: u32) -> Jet2

/// `fbm2` of <fractal/fbm.wgsl> with its second derivatives.
fn fbm2_jet(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32) -> Jet2 {
    var sum = Jet2(0.0, vec2f(0.0), vec3f(0.0));
    var strength = 1.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0)); // from p to this octave's plane
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let octave = jet2_carried(noise2(q + f32(i) * FRACTAL_SHIFT, seed + u32(i)), to_octave);
        sum = jet2_sum(sum, jet2_scaled(octave, strength * presence));
        strength *= gain;
        q = lacunarity * (FRACTAL_TURN * q);
        to_octave = lacunarity * (FRACTAL_TURN * to_octave);
    }
    return sum;
}

/// `ridged2` of <fractal/ridged.wgsl> with its second derivatives. They jump where sharpness · signal passes 2, and at
/// the crests where `roundness` is 0.
fn ridged2_jet(
    p: vec2f,
    seed: u32,
    octaves: f32,
    gain: f32,
    lacunarity: f32,
    sharpness: f32,
    roundness: f32,
) -> Jet2 {
    var sum = Jet2(0.0, vec2f(0.0), vec3f(0.0));
    var weight = Jet2(1.0, vec2f(0.0), vec3f(0.0));
    var strength = 1.0;
    var mean = 0.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0));
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = jet2_carried(noise2(q + f32(i) * FRACTAL_RIDGE_SHIFT, seed + u32(i)), to_octave);
        // Of (1 - height)², height = sqrt(n² + roundness²): height' = n / height, height'' = roundness² / height³.
        let height = max(sqrt(n.value * n.value + roundness * roundness), 1e-6);
        let ridge = 1.0 - height;
        let tilt = n.value / height;
        let curve = (1.0 - tilt * tilt) / height;
        let signal = jet2_through(n, ridge * ridge, -2.0 * ridge * tilt, 2.0 * (tilt * tilt - ridge * curve));
        let centred = Jet2(signal.value - mean, signal.gradient, signal.hessian);
        sum = jet2_sum(sum, jet2_scaled(jet2_product(weight, centred), strength * presence));
        let rest = max(1.0 - 0.5 * sharpness * signal.value, 0.0);
        let turn = select(0.0, -0.5 * sharpness * sharpness, rest > 0.0);
        weight = jet2_through(signal, 1.0 - rest * rest, rest * sharpness, turn);
        mean = FRACTAL_MEAN_RIDGE;
        strength *= gain;
        q = lacunarity * (FRACTAL_TURN * q);
        to_octave = lacunarity * (FRACTAL_TURN * to_octave);
    }
    return sum;
}

/// `hybrid2` of <fractal/hybrid.wgsl> with its second derivatives. They jump where a weight passes 0 or 2.
fn hybrid2_jet(p: vec2f, seed: u32, octaves: f32, gain: f32, lacunarity: f32, offset: f32) -> Jet2 {
    var sum = Jet2(0.0, vec2f(0.0), vec3f(0.0));
    var weight = Jet2(1.0, vec2f(0.0), vec3f(0.0));
    var strength = 1.0;
    var q = p;
    var to_octave = mat2x2f(vec2f(1.0, 0.0), vec2f(0.0, 1.0));
    for (var i = 0; i < FRACTAL_MAX_OCTAVES; i++) {
        let presence = clamp(octaves - f32(i), 0.0, 1.0);
        if presence <= 0.0 {
            break;
        }
        let n = jet2_carried(noise2(q + f32(i) * FRACTAL_SHIFT, seed + u32(i)), to_octave);
        let signal = jet2_scaled(Jet2(n.value + offset, n.gradient, n.hessian), strength);
        let term = jet2_product(weight, signal);
        sum = jet2_sum(sum, jet2_scaled(term, presence));
        // min(w, 1) with the corner rounded: w below 0, w - w²/4 from there to 2, 1 above.
        let w = min(term.value, 2.0);
        let above = max(w, 0.0);
        let inside = term.value < 2.0;
        let turn = select(0.0, -0.5, inside && term.value > 0.0);
        weight = jet2_through(term, w - 0.25 * above * above, select(0.0, 1.0 - 0.5 * above, inside), turn);
        strength *= gain;
        q = lacunarity * (FRACTAL_TURN * q);
        to_octave = lacunarity * (FRACTAL_TURN * to_octave);
    }
    return sum;
}
