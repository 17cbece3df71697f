//! [`Picture`] → the bytes of a file: PNG or JPEG (8-bit sRGB, dithered), or EXR (linear light, 32-bit float).

use std::io::Cursor;
use std::path::Path;

use image::{ExtendedColorType, ImageEncoder};

use super::error::RenderError;
use super::picture::{Picture, srgb_encode};
use crate::diagnostic::Error;

/// 1 to 100: at 90 no blocks show in a sky.
const JPEG_QUALITY: u8 = 90;

/// A format of picture files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// 8-bit sRGB, dithered.
    Png,
    /// 8-bit sRGB without alpha, dithered: smaller than PNG, and not exact.
    Jpeg,
    /// Linear light, 32-bit float.
    Exr,
}

impl Format {
    /// The format that a file's name asks for.
    ///
    /// # Errors
    /// Where the name ends in none of `.png`, `.jpg`, `.jpeg` and `.exr`.
    pub fn of(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        match path.extension().and_then(|end| end.to_str()).map(str::to_ascii_lowercase).as_deref() {
            Some("png") => Ok(Self::Png),
            Some("jpg" | "jpeg") => Ok(Self::Jpeg),
            Some("exr") => Ok(Self::Exr),
            _ => Err(RenderError::Format { file: path.display().to_string() }.into()),
        }
    }
}

/// The file's bytes. The same picture gives the same bytes, always.
///
/// # Errors
/// Where the picture is larger than the format can hold.
pub fn encode(picture: &Picture, format: Format) -> Result<Vec<u8>, Error> {
    let mut file = Cursor::new(Vec::new());
    let written = match format {
        Format::Png => {
            let opaque = picture.pixels.iter().all(|pixel| pixel[3] >= 1.0);
            let (bytes, kind) = if opaque {
                (without_alpha(&to_srgb8(picture)), ExtendedColorType::Rgb8)
            } else {
                (to_srgb8(picture), ExtendedColorType::Rgba8)
            };
            image::codecs::png::PngEncoder::new(&mut file).write_image(
                &bytes,
                picture.width,
                picture.height,
                kind,
            )
        }
        Format::Jpeg => image::codecs::jpeg::JpegEncoder::new_with_quality(&mut file, JPEG_QUALITY)
            .write_image(
                &without_alpha(&to_srgb8(picture)),
                picture.width,
                picture.height,
                ExtendedColorType::Rgb8,
            ),
        Format::Exr => {
            let bytes: Vec<u8> =
                picture.pixels.iter().flatten().flat_map(|value| value.to_ne_bytes()).collect();
            let kind = ExtendedColorType::Rgba32F;
            image::codecs::openexr::OpenExrEncoder::new(&mut file).write_image(
                &bytes,
                picture.width,
                picture.height,
                kind,
            )
        }
    };
    written.map_err(|why| RenderError::Encode(why.to_string()))?;
    Ok(file.into_inner())
}

fn without_alpha(bytes: &[u8]) -> Vec<u8> {
    bytes.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

/// Red, green, blue and alpha of each pixel, sRGB-encoded, 8 bits each, dithered: no band shows in a sky, and the mean of
/// any area is that of the picture. Black and white stay exact, and alpha is rounded plainly.
pub fn to_srgb8(picture: &Picture) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(picture.pixels.len() * 4);
    for (index, pixel) in picture.pixels.iter().enumerate() {
        let (x, y) = (index as u32 % picture.width, index as u32 / picture.width);
        for (channel, value) in pixel.iter().take(3).enumerate() {
            bytes.push(dither(srgb_encode(*value), pcg3d([x, y, channel as u32])));
        }
        bytes.push((pixel[3].clamp(0.0, 1.0) * 255.0).round() as u8);
    }
    bytes
}

/// `value` (0 .. 1) in 255 steps, one step up or down by chance so that the mean is exact.
///
/// Triangular noise, whose error does not depend on the value; at the ends, where that would clip, even noise.
fn dither(value: f32, random: [u32; 3]) -> u8 {
    let steps = value.clamp(0.0, 1.0) * 255.0;
    let [first, second, _] = random.map(|bits| (bits >> 8) as f32 / 16_777_216.0);
    let to_end = steps.min(255.0 - steps);
    let noise = if to_end < 0.5 { first - 0.5 } else { first - second };
    (steps + noise).round().clamp(0.0, 255.0) as u8 // NaN comes out black
}

/// Hash of three integers (Jarzynski & Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3)).
fn pcg3d(value: [u32; 3]) -> [u32; 3] {
    let mut v = value.map(|x| x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    let stir = |v: &mut [u32; 3]| {
        v[0] = v[0].wrapping_add(v[1].wrapping_mul(v[2]));
        v[1] = v[1].wrapping_add(v[2].wrapping_mul(v[0]));
        v[2] = v[2].wrapping_add(v[0].wrapping_mul(v[1]));
    };
    stir(&mut v);
    v = v.map(|x| x ^ (x >> 16));
    stir(&mut v);
    v
}
