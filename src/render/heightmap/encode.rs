//! [`Heightmap`] → the bytes of a file, and the words about it that go beside.

use std::io::Cursor;
use std::path::Path;

use image::{ExtendedColorType, ImageEncoder};
use serde_json::json;

use super::super::error::RenderError;
use super::Heightmap;
use super::error::HeightmapError;
use crate::diagnostic::Error;

/// A format of heightmap files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HeightFormat {
    /// 16-bit grey PNG: 0 .. 65,535 over a range of heights.
    Png,
    /// OpenEXR with one channel, `Y`: metres, 32-bit float.
    Exr,
    /// Little-endian 16-bit integers and nothing else, as engines import them: 0 .. 65,535 over a range of heights.
    R16,
}

/// The height of 0 and the height of 65,535 (m).
pub type Range = [f32; 2];

impl HeightFormat {
    /// The format that a file's name asks for.
    ///
    /// # Errors
    /// Where the name ends in none of `.png`, `.exr`, `.r16` and `.raw`.
    pub fn of(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        match path.extension().and_then(|end| end.to_str()).map(str::to_ascii_lowercase).as_deref() {
            Some("png") => Ok(Self::Png),
            Some("exr") => Ok(Self::Exr),
            Some("r16" | "raw") => Ok(Self::R16),
            _ => Err(HeightmapError::Format { file: path.display().to_string() }.into()),
        }
    }

    /// Whether it holds integers, which mean heights only together with a range.
    pub fn has_range(self) -> bool {
        self != Self::Exr
    }
}

/// The file's bytes, rows from north to south, each from west to east. Heights outside of `range` come out as its ends;
/// EXR takes no notice of it. The same heights give the same bytes, always.
///
/// # Errors
/// Where `range` is none, and where the map is larger than the format can hold.
pub fn encode_heights(map: &Heightmap, format: HeightFormat, range: Range) -> Result<Vec<u8>, Error> {
    let [low, high] = range;
    if format.has_range() && !(low < high && (high - low).is_finite()) {
        return Err(HeightmapError::Range { low, high }.into());
    }
    let pixels = map.tile.pixels;
    match format {
        HeightFormat::R16 => Ok(levels(map, range).flat_map(u16::to_le_bytes).collect()),
        HeightFormat::Png => {
            let bytes: Vec<u8> = levels(map, range).flat_map(u16::to_ne_bytes).collect();
            let mut file = Vec::new();
            image::codecs::png::PngEncoder::new(&mut file)
                .write_image(&bytes, pixels, pixels, ExtendedColorType::L16)
                .map_err(|why| RenderError::Encode(why.to_string()))?;
            Ok(file)
        }
        HeightFormat::Exr => Ok(exr(map)?),
    }
}

/// How far up `range` each height lies, of 65,535.
fn levels(map: &Heightmap, [low, high]: Range) -> impl Iterator<Item = u16> + '_ {
    let (low, scale) = (f64::from(low), 65_535.0 / (f64::from(high) - f64::from(low)));
    map.heights.iter().map(move |height| ((f64::from(*height) - low) * scale).round() as u16) // saturates
}

fn exr(map: &Heightmap) -> Result<Vec<u8>, RenderError> {
    use exr::prelude::{Encoding, Image, SpecificChannels, Vec2, WritableImage};
    let pixels = map.tile.pixels as usize;
    let height = |at: Vec2<usize>| (map.heights[at.y() * pixels + at.x()],);
    let channels = SpecificChannels::build().with_channel("Y").with_pixel_fn(height);
    let image = Image::from_encoded_channels((pixels, pixels), Encoding::SMALL_LOSSLESS, channels);
    let mut file = Cursor::new(Vec::new());
    image
        .write()
        .non_parallel()
        .to_buffered(&mut file)
        .map_err(|why| RenderError::Encode(why.to_string()))?;
    Ok(file.into_inner())
}

/// What a reader of the file has to know, as JSON: where the tile lies, what its numbers mean, and what they span.
pub fn heights_about(map: &Heightmap, preset: &str, format: HeightFormat, range: Range) -> String {
    let metres = |mm: i64| mm as f64 / 1000.0;
    let tile = &map.tile;
    let [low, high] = map.span();
    let mut about = json!({
        "preset": preset,
        "pixels": tile.pixels,
        "origin": { "x": metres(tile.origin[0]), "z": metres(tile.origin[1]) },
        "size": tile.size as f64 / 1000.0,
        "spacing": tile.spacing(),
        "unit": "m",
        "rows": "north to south (z), each from west to east (x); the last of each way is the next tile's first",
        "lowest": low,
        "highest": high,
    });
    about["encoding"] = if format.has_range() {
        json!({ "type": "u16", "endian": if format == HeightFormat::R16 { "little" } else { "big" },
                "height_of_0": range[0], "height_of_65535": range[1] })
    } else {
        json!({ "type": "f32", "channel": "Y" })
    };
    format!("{about:#}\n")
}
