//! `orogen render`

use std::path::{Path, PathBuf};

use orogen::render::{self, Gpu, Shot};

use super::args::{Common, Render};
use super::failure::{Failure, Outcome};
use super::{input, output, progress};

pub(super) fn run(args: &Render, common: &Common) -> Outcome {
    let library = input::library(common)?;
    let mut preset = input::preset(&args.preset, common)?;
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}.png", preset.name())));
    let format = render::Format::of(&path)?;
    let mut composer = input::composer(common)?;
    if format == render::Format::Exr {
        linear_display(&mut composer, &library, &mut preset, common)?;
    }
    let shader = composer.run(&library, &preset, &input::bake(&args.baking))?;
    let gpu = Gpu::new(args.adapter.as_deref())?;
    let frames = args.frames.unwrap_or(1);
    let bar = progress::bar(preset.name(), common.quiet);
    for index in 0..frames {
        let (width, height) = args.size;
        let shot = Shot {
            samples: args.samples,
            time: args.time + index as f32 / args.fps,
            delta: args.frames.map(|_| 1.0 / args.fps),
            index,
            ..Shot::new(width, height)
        };
        let mut report = |done: u64, total: u64| {
            bar.set_length(total * u64::from(frames));
            bar.set_position(done + total * u64::from(index));
        };
        let picture = render::render(&gpu, &shader, &preset, &shot, &mut report)?;
        let target = if args.frames.is_some() { numbered(&path, index, frames) } else { path.clone() };
        output::write(&target, &render::encode(&picture, format)?)?;
    }
    bar.finish_and_clear();
    if !common.quiet {
        let what = if args.frames.is_some() { numbered(&path, 0, frames) } else { path };
        let more = if frames > 1 { format!(" and {} more", frames - 1) } else { String::new() };
        output::complain(&format!("{}{more}, on {}\n", what.display(), gpu.name()));
    }
    Ok(())
}

/// Pictures of linear light are for further work: no tone map, where the scene has an option to leave it out.
fn linear_display(
    composer: &mut orogen::Compose,
    library: &orogen::Library,
    preset: &mut orogen::Preset,
    common: &Common,
) -> Result<(), Failure> {
    const OPTION: &str = "display.tone_map";
    let survey = composer.survey(library, preset)?;
    let is_told = common.set.iter().any(|assignment| assignment.trim_start().starts_with(OPTION));
    if !is_told && survey.declarations.find(OPTION).is_some() {
        preset.set(&format!("{OPTION}=none"))?;
    }
    Ok(())
}

/// `out.png` → `out_0001.png`, with as many digits as the sequence needs, four at least.
fn numbered(path: &Path, index: u32, frames: u32) -> PathBuf {
    let digits = frames.to_string().len().max(4);
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let extension = path.extension().map_or_else(String::new, |ext| ext.to_string_lossy().into_owned());
    path.with_file_name(format!("{stem}_{:0digits$}.{extension}", index + 1))
}
