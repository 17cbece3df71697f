//! `orogen heightmap`

use std::path::{Path, PathBuf};

use orogen::render::{self, Gpu, HeightFormat, Tile};

use super::args::{Common, Heightmap};
use super::failure::Outcome;
use super::{input, output, progress};

pub(super) fn run(args: &Heightmap, common: &Common) -> Outcome {
    let library = input::library(common)?;
    let preset = input::preset(&args.preset, common)?;
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}_height.png", preset.name())));
    let format = HeightFormat::of(&path)?;
    let tile = Tile { origin: args.origin, size: args.size, pixels: args.pixels };
    let gpu = Gpu::new(args.adapter.as_deref())?;
    let bar = progress::bar(preset.name(), common.quiet);
    let mut report = |done: u64, total: u64| {
        bar.set_length(total);
        bar.set_position(done);
    };
    let map = render::heightmap(&gpu, &library, &preset, tile, args.footprint, &mut report)?;
    bar.finish_and_clear();
    let span = map.span();
    let range = match args.range {
        Some(range) => range,
        None if format.has_range() => map.range(&preset)?,
        None => span,
    };
    let file = render::encode_heights(&map, format, range)?;
    let about = render::heights_about(&map, preset.name(), format, range);
    let beside = with_json(&path);
    // Both, or, as far as that can be told before, neither.
    let drafts = [output::prepare(&path, &file)?, output::prepare(&beside, about.as_bytes())?];
    drafts.into_iter().try_for_each(output::Draft::persist)?;
    let clipped = if format.has_range() { map.outside(range) } else { 0 };
    if clipped > 0 {
        let [low, high] = range;
        output::complain(&format!(
            "warning: {clipped} of {} heights lie outside of {low} m to {high} m, and were written as its ends\n",
            map.heights.len()
        ));
    }
    if !common.quiet {
        let (shown, beside) = (path.display(), beside.display());
        output::complain(&format!(
            "{shown}: {0}x{0} heights every {1} m, from {2:.1} m to {3:.1} m; {beside} says the rest\n",
            tile.pixels,
            tile.spacing(),
            span[0],
            span[1],
        ));
    }
    Ok(())
}

/// `h.png` → `h.png.json`
fn with_json(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".json");
    name.into()
}
