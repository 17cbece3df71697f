//! `orogen render`

use std::path::{Path, PathBuf};

use orogen::Shader;
use orogen::preset::{Declarations, Knob};
use orogen::render::{self, Gpu, Shot};
use orogen::syntax::OptionKind;

use super::args::{Common, Render};
use super::failure::{Failure, Outcome};
use super::{input, made_of, output, progress};

pub(super) fn run(args: &Render, common: &Common) -> Outcome {
    let library = input::library(common)?;
    let mut preset = input::preset(&args.preset, common)?;
    let path = args.output.clone().unwrap_or_else(|| match &args.viewing.view {
        None => PathBuf::from(format!("{}.png", preset.name())),
        Some(view) => PathBuf::from(format!("{}_{view}.png", preset.name())),
    });
    let format = render::Format::of(&path)?;
    let mut composer = input::composer(common)?;
    composer.view.clone_from(&args.viewing.view);
    for_a_file(format, &mut composer, &library, &mut preset, common)?;
    let shader = composer.run(&library, &preset, &input::bake(&args.baking))?;
    let (start, first) = first_frame(&shader);
    let start = args.time.unwrap_or(start);
    let gpu = Gpu::new(args.adapter.as_deref())?;
    let frames = args.frames.unwrap_or(1);
    let bar = progress::bar(preset.name(), common.quiet);
    for index in 0..frames {
        let (width, height) = args.size;
        let shot = Shot {
            samples: args.samples,
            time: start + index as f32 / args.fps,
            delta: args.frames.map(|_| 1.0 / args.fps),
            index: first.wrapping_add(index),
            ..Shot::new(width, height)
        };
        let mut report = |done: u64, total: u64| {
            bar.set_length(total * u64::from(frames));
            bar.set_position(done + total * u64::from(index));
        };
        let target = if args.frames.is_some() { numbered(&path, index, frames) } else { path.clone() };
        made_of::spare(&shader, &target)?;
        let picture = render::render(&gpu, &shader, &preset, &shot, &mut report)?;
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

/// What a display would need is left out where the scene has an option for it: dithering, which is done once the samples are
/// averaged ([`render::encode`]), and in pictures of linear light, which are for further work, the tone map.
fn for_a_file(
    format: render::Format,
    composer: &mut orogen::Compose,
    library: &orogen::Library,
    preset: &mut orogen::Preset,
    common: &Common,
) -> Result<(), Failure> {
    const TONE_MAP: &str = "display.tone_map";
    const DITHER: &str = "display.dither";
    let declarations = composer.survey(library, preset)?.declarations;
    let is_told = |name| common.set.iter().any(|assignment| name_in(assignment) == name);
    if format == render::Format::Exr && !is_told(TONE_MAP) && can_be_none(&declarations, TONE_MAP) {
        preset.set(&format!("{TONE_MAP}=none"))?;
    }
    if !is_told(DITHER) && can_be_off(&declarations, DITHER) {
        preset.set(&format!("{DITHER}=false"))?;
    }
    Ok(())
}

/// `sun.elevation=6` → `sun.elevation`
fn name_in(assignment: &str) -> &str {
    assignment.split_once('=').map_or(assignment, |(name, _)| name).trim()
}

fn can_be_none(declarations: &Declarations, option: &str) -> bool {
    let Some(Knob::Option(index)) = declarations.find(option) else { return false };
    matches!(&declarations.options[index].decl.kind, OptionKind::Choice(choices) if choices.iter().any(|c| c == "none"))
}

fn can_be_off(declarations: &Declarations, option: &str) -> bool {
    let Some(Knob::Option(index)) = declarations.find(option) else { return false };
    matches!(&declarations.options[index].decl.kind, OptionKind::Bool)
}

/// The preset's `frame.time` and `frame.index`, as far as the shader reads them.
fn first_frame(shader: &Shader) -> (f32, u32) {
    let fields = shader.interface().uniform.iter().flat_map(|uniform| &uniform.fields);
    let (mut time, mut index) = (0.0, 0);
    for field in fields {
        match field.parameter.as_str() {
            "frame.time" => time = field.value.as_f64().unwrap_or_default() as f32,
            "frame.index" => {
                index = field.value.as_u64().and_then(|value| value.try_into().ok()).unwrap_or_default();
            }
            _ => {}
        }
    }
    (time, index)
}

/// `out.png` → `out_0001.png`, with as many digits as the sequence needs, four at least.
fn numbered(path: &Path, index: u32, frames: u32) -> PathBuf {
    let digits = frames.to_string().len().max(4);
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let extension = path.extension().map_or_else(String::new, |ext| ext.to_string_lossy().into_owned());
    path.with_file_name(format!("{stem}_{:0digits$}.{extension}", index + 1))
}
