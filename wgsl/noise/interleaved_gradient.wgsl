// Interleaved gradient noise (Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare").
//
// For dithers and the starts of marches, where any 3x3 pixels should have all values between them.

/// A number for each pixel, 0 <= result < 1, evenly spread over every 3x3 neighbourhood.
///
/// fract(52.9829189 fract(.06711056 x + .00583715 y)) of the pixel's whole coordinates; each frame moves it by
/// 5.588238 pixels both ways. The inner fraction is kept in 32-bit fixed point: equal on every GPU, and as fine in the
/// last pixel of a large picture as in the first.
fn interleaved_gradient_noise(pixel: vec2f, frame_number: u32) -> f32 {
    let whole = bitcast<vec2u>(vec2i(floor(pixel)));
    let phase = whole.x * 288237660u + whole.y * 25070368u + frame_number * 1750839832u;
    return fract(52.9829189 * (f32(phase >> 8u) / 16777216.0));
}
