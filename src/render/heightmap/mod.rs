//! A preset and a [`Tile`] → [`Heightmap`] → 16-bit PNG, EXR or raw: land for engines that bring their own terrain.
//!
//! Tiles fit together: the last row and column of one are the first of the next, bit for bit, in every format. Places are
//! counted in whole millimetres ([`Tile`]), each height is a function of its place alone, and what 16 bits mean is a
//! property of the preset's land and not of the tile.
//!
//! ```
//! use orogen::render::{Gpu, HeightFormat, Tile, encode_heights, heightmap};
//! use orogen::{Library, Preset};
//!
//! let (library, preset) = (Library::standard(), Preset::named("alpine")?);
//! let tile = Tile { origin: [-9_000_000, 0], size: 2_048_000, pixels: 65 }; // mm
//! let map = heightmap(&Gpu::new(None)?, &library, &preset, tile, 0.0, &mut |_, _| {})?;
//! let range = map.range(&preset)?; // of all tiles of this preset
//! let file = encode_heights(&map, HeightFormat::R16, range)?;
//! assert_eq!(file.len(), 65 * 65 * 2);
//! # Ok::<(), orogen::Error>(())
//! ```

mod encode;
mod error;
mod tile;

pub use encode::{HeightFormat, Range, encode_heights, heights_about};
pub use error::HeightmapError;
pub use tile::{MOST_PIXELS, Tile};

use super::adapter::Gpu;
use super::draw::Progress;
use super::error::RenderError;
use super::sample::Sampler;
use crate::diagnostic::Error;
use crate::preset::{Knob, Preset};
use crate::shader::Compose;
use crate::source::Library;
use crate::syntax::{OptionKind, OptionValue};

/// The option that says that there is land, and of which kind.
const RELIEF: &str = "terrain.relief";
/// The kind that falls away from the plane without end.
const UNBOUNDED: &str = "planet";
/// Points between two words about progress.
const BATCH: usize = 1 << 16;

/// Heights of a square of land.
#[derive(Debug, Clone, PartialEq)]
pub struct Heightmap {
    /// The square.
    pub tile: Tile,
    /// Metres; rows from north to south, each from west to east.
    pub heights: Vec<f32>,
    /// The lowest and the highest height (m) that the preset's land can have anywhere, where such are known.
    pub bounds: Option<Range>,
}

impl Heightmap {
    /// The lowest and the highest height of this tile (m).
    pub fn span(&self) -> Range {
        let heights = self.heights.iter().copied();
        heights.fold([f32::MAX, f32::MIN], |[low, high], height| [low.min(height), high.max(height)])
    }

    /// What 16 bits stand for unless something else is told: the heights that the land of `preset` can have, in whole tens
    /// of metres; so it is the same for all tiles.
    ///
    /// # Errors
    /// Where the land has no such bounds.
    pub fn range(&self, preset: &Preset) -> Result<Range, Error> {
        let [low, high] =
            self.bounds.ok_or_else(|| HeightmapError::NoBounds { preset: preset.name().into() })?;
        Ok([(low / 10.0).floor() * 10.0, (high / 10.0).ceil() * 10.0])
    }

    /// How many heights lie outside of `range`: 16-bit files have them at its ends.
    pub fn outside(&self, [low, high]: Range) -> usize {
        self.heights.iter().filter(|height| !(low..=high).contains(*height)).count()
    }
}

/// Measures the land of `preset` at every sample of `tile`, without forms too small to be seen in a pixel `footprint` (m)
/// wide: 0 gives the land that meshes stand on, the tile's spacing one that does not alias.
///
/// `progress` is told how many heights are done, and of how many.
///
/// # Errors
/// A preset without land, a tile that cannot be sampled; and what wgpu or the driver refuses.
pub fn heightmap(
    gpu: &Gpu,
    library: &Library,
    preset: &Preset,
    tile: Tile,
    footprint: f32,
    progress: Progress<'_>,
) -> Result<Heightmap, Error> {
    tile.check()?;
    if !(footprint >= 0.0 && footprint.is_finite()) {
        let why = format!("no pixel is {footprint} m wide");
        return Err(HeightmapError::Tile { why, help: "give metres, as in `--footprint 2`" }.into());
    }
    let relief = relief(library, preset)?;
    let bounds = if relief == UNBOUNDED { None } else { Some(bounds(gpu, library, preset)?) };
    let expression = format!("terrain_height_filtered(p, {footprint:?})");
    let mut sampler = Sampler::new(gpu, library, preset, &expression, &["x", "y"])?;
    let pixels = tile.pixels as usize;
    let mut heights = Vec::new();
    heights.try_reserve_exact(pixels * pixels).map_err(|_| RenderError::OutOfMemory)?;
    let east: Vec<f32> = (0..tile.pixels).map(|column| tile.position(0, column)).collect();
    let rows: Vec<u32> = (0..tile.pixels).collect();
    for rows in rows.chunks((BATCH / pixels).max(1)) {
        let places = rows.iter().flat_map(|row| {
            let south = tile.position(1, *row);
            east.iter().map(move |east| [*east, south])
        });
        let found: Vec<[f32; 1]> = sampler.run(&places.collect::<Vec<_>>())?;
        heights.extend(found.into_iter().flatten());
        progress(heights.len() as u64, (pixels * pixels) as u64);
    }
    Ok(Heightmap { tile, heights, bounds })
}

/// Which relief the land of `preset` has.
fn relief(library: &Library, preset: &Preset) -> Result<String, Error> {
    let survey = Compose::default().survey(library, preset)?;
    let no_land = || HeightmapError::NoLand { preset: preset.name().into() };
    let Some(Knob::Option(index)) = survey.declarations.find(RELIEF) else { return Err(no_land().into()) };
    match (&survey.declarations.options[index].decl.kind, survey.settings.options[index]) {
        (OptionKind::Choice(choices), OptionValue::Choice(chosen)) => Ok(choices[chosen].clone()),
        _ => Err(no_land().into()),
    }
}

fn bounds(gpu: &Gpu, library: &Library, preset: &Preset) -> Result<Range, Error> {
    let expression = "vec2f(terrain_floor(), terrain_ceiling())";
    let mut sampler = Sampler::new(gpu, library, preset, expression, &[])?;
    Ok(sampler.run(&[[]])?[0])
}
