// Noise that hides the steps of 8 bits.

#include <noise/interleaved_gradient.wgsl>

/// `encoded` (display values, 0 .. 1) with noise on it that makes up for rounding to 255 steps: the mean over neighbouring
/// pixels, and over frames, is then that of `encoded`.
///
/// Triangular noise of up to one step either way, whose grain does not depend on the value; in the last half step before
/// black and before white, where that would be cut off, even noise of half a step. Other noise in each channel. Every 3x3
/// pixels have all strengths of it between them (interleaved gradient noise), so it is hardly seen. Returns
/// -.002 .. 1.002.
fn dither_255(encoded: vec3f, pixel: vec2f, frame_number: u32) -> vec3f {
    let even = vec3f(
        interleaved_gradient_noise(pixel, frame_number),
        interleaved_gradient_noise(pixel + vec2f(41.0, 17.0), frame_number),
        interleaved_gradient_noise(pixel + vec2f(13.0, 71.0), frame_number),
    ) - 0.5;
    let triangular = sign(even) * (1.0 - sqrt(1.0 - 2.0 * abs(even)));
    let steps = saturate(encoded) * 255.0;
    let to_end = min(steps, 255.0 - steps);
    return encoded + select(triangular, 0.999 * even, to_end < vec3f(0.5)) / 255.0;
}
