//! A picture in linear light, and the sRGB curve between it and what displays take.

/// A picture: linear-light sRGB primaries and straight alpha, rows from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green, blue and alpha of each pixel; 1 is a display's white, and there may be more.
    pub pixels: Vec<[f32; 4]>,
}

/// Linear light of an sRGB-encoded value (IEC 61966-2-1), beyond 0 .. 1 too; odd.
pub fn srgb_decode(encoded: f32) -> f32 {
    let value = encoded.abs();
    let linear = if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) };
    linear.copysign(encoded)
}

/// The sRGB-encoded value of linear light, beyond 0 .. 1 too; odd.
pub fn srgb_encode(linear: f32) -> f32 {
    let value = linear.abs();
    let encoded = if value <= 0.003_130_8 { value * 12.92 } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
    encoded.copysign(linear)
}
