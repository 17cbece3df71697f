//! Two pictures → how alike they are; pictures from files, and into files for people to look at.

use std::fmt;
use std::fs;
use std::path::Path;

use crate::run::{Failure, Outcome};

/// Red, green and blue, 8 bits each, row by row from the top.
#[derive(Debug, PartialEq)]
pub(crate) struct Rgb(pub(crate) Vec<u8>);

/// Peak signal-to-noise ratio in dB; infinite for equal pictures.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) struct Psnr(pub(crate) f64);

impl fmt::Display for Psnr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_finite() { write!(f, "{:.1} dB", self.0) } else { f.pad("equal") }
    }
}

/// How alike `a` and `b` are; none where they differ in size, or have none.
pub(crate) fn psnr(a: &Rgb, b: &Rgb) -> Option<Psnr> {
    if a.0.len() != b.0.len() || a.0.is_empty() {
        return None;
    }
    let squares = a.0.iter().zip(&b.0).map(|(&a, &b)| f64::from(a.abs_diff(b)).powi(2));
    let mean = squares.sum::<f64>() / a.0.len() as f64;
    Some(Psnr(10.0 * (255.0 * 255.0 / mean).log10()))
}

/// The picture in an EXR file of linear light, as a display of 8 bits shows it: encoded and rounded, nothing more.
pub(crate) fn shown(exr: &Path) -> Outcome<Rgb> {
    let picture = image::open(exr).map_err(|why| Failure::Check(format!("{}: {why}", exr.display())))?;
    Ok(Rgb(picture.to_rgb32f().iter().map(|&linear| (srgb_encode(linear) * 255.0).round() as u8).collect()))
}

/// The sRGB transfer function (IEC 61966-2-1), 0 .. 1.
fn srgb_encode(linear: f32) -> f32 {
    let linear = linear.clamp(0.0, 1.0);
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// The picture in a file of bare RGBA bytes; alpha is left out.
pub(crate) fn bare(rgba: &Path) -> Outcome<Rgb> {
    let bytes = fs::read(rgba).map_err(|cause| Failure::File { path: rgba.to_owned(), cause })?;
    Ok(Rgb(bytes.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()))
}

/// Writes `picture` as PNG.
pub(crate) fn write_png(path: &Path, picture: &Rgb, (width, height): (u32, u32)) -> Outcome {
    image::save_buffer(path, &picture.0, width, height, image::ExtendedColorType::Rgb8)
        .map_err(|why| Failure::Check(format!("{}: {why}", path.display())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_step_everywhere_is_48_db_and_nothing_is_equal() {
        let (a, b) = (Rgb(vec![100; 300]), Rgb(vec![101; 300]));
        let one_step = psnr(&a, &b).expect("of one size");
        assert!((one_step.0 - 48.13).abs() < 0.01, "{one_step:?}");
        assert_eq!(one_step.to_string(), "48.1 dB");
        assert_eq!(psnr(&a, &a).expect("of one size").to_string(), "equal");
    }

    #[test]
    fn pictures_of_other_sizes_and_of_none_are_not_alike() {
        assert_eq!(psnr(&Rgb(vec![0; 3]), &Rgb(vec![0; 6])), None);
        assert_eq!(psnr(&Rgb(Vec::new()), &Rgb(Vec::new())), None);
    }

    #[test]
    fn light_is_encoded_as_displays_take_it() {
        for (linear, encoded) in [(0.0, 0.0), (0.002, 0.025_84), (0.5, 0.735_357), (1.0, 1.0), (7.0, 1.0)] {
            assert!((srgb_encode(linear) - encoded).abs() < 1e-5, "{linear}");
        }
        assert_eq!((srgb_encode(f32::NAN) * 255.0).round() as u8, 0);
    }
}
