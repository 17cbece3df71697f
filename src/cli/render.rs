//! `orogen render`

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use orogen::preset::{Declarations, Knob};
use orogen::render::{self, Format, Gpu, Picture, Projection, Shot};
use orogen::syntax::OptionKind;
use orogen::watch::{Recipe, Watch};
use orogen::{Compose, Library, Preset, Shader};

use super::args::{self, Common, Render};
use super::failure::{Failure, Outcome};
use super::{input, made_of, output, progress};

pub(super) fn run(args: &Render, common: &Common) -> Outcome {
    let origin = input::Origin::of(&args.preset)?;
    let library = input::library(common)?;
    let mut composer = input::composer(common)?;
    composer.view.clone_from(&args.viewing.view);
    if args.watch {
        return watch(args, common, origin, library, composer);
    }
    let preset = origin.read(&common.set)?;
    let path = path(args, preset.name());
    let format = Format::of(&path)?;
    let preset = prepared(args, common, preset, format, &library, &mut composer)?;
    let shader = composer.run(&library, &preset, &input::bake(&args.baking))?;
    check_faces(args, &shader)?;
    let gpu = Gpu::new(args.adapter.as_deref())?;
    let written = draw(args, common, &gpu, &shader, &preset, &path)?;
    if !common.quiet {
        output::complain(&format!("{}, on {}\n", told(&written), gpu.name()));
    }
    Ok(())
}

/// Draws whenever there is something new to be drawn, until the process is ended.
fn watch(
    args: &Render,
    common: &Common,
    origin: input::Origin,
    library: Library,
    composer: Compose,
) -> Outcome {
    if origin.path().is_none() && common.folders.is_empty() {
        let why = format!(
            "--watch needs files: `{}` is built in. Write a preset that extends it, or lay a folder of yours over the \
             library with -I",
            args.preset
        );
        return Err(Failure::Usage(why));
    }
    let name = origin.path().and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned());
    let path = path(args, &name.unwrap_or_else(|| args.preset.clone()));
    let format = Format::of(&path)?;
    let gpu = Gpu::new(args.adapter.as_deref())?;
    let (args_there, common_there) = (args.clone(), common.clone());
    let file = origin.path().map(Path::to_owned);
    let mut recipe = Recipe::new(library, input::bake(&args.baking), move |library, composer| {
        let preset = origin.read(&common_there.set)?;
        prepared(&args_there, &common_there, preset, format, library, composer)
    });
    recipe.compose = composer;
    recipe.files.extend(file);
    let mut watch = Watch::new(recipe)?;
    while let Some(news) = watch.next(Duration::MAX) {
        let drawn = news.map_err(Failure::from).and_then(|made| {
            check_faces(args, &made.shader)?;
            let start = Instant::now();
            let written = draw(args, common, &gpu, &made.shader, &made.preset, &path)?;
            Ok((written, made.took, start.elapsed()))
        });
        match drawn {
            Ok((written, composed, drawn)) if !common.quiet => {
                let (composed, drawn) = (composed.as_millis(), drawn.as_millis());
                let what = told(&written);
                output::complain(&format!(
                    "{what}: composed in {composed} ms, drawn in {drawn} ms; watching\n"
                ));
            }
            Ok(_) => {}
            Err(Failure::Input(error)) => {
                output::complain(&error.render(super::colour()));
                let shown = path.display();
                output::complain(&format!("{shown} stays as it was; watching\n"));
            }
            Err(other) => return Err(other),
        }
    }
    Ok(())
}

/// Where to write, of a preset called `name`.
fn path(args: &Render, name: &str) -> PathBuf {
    args.output.clone().unwrap_or_else(|| match &args.viewing.view {
        None => PathBuf::from(format!("{name}.png")),
        Some(view) => PathBuf::from(format!("{name}_{view}.png")),
    })
}

/// `preset`, with what the command line says about projection and format.
fn prepared(
    args: &Render,
    common: &Common,
    mut preset: Preset,
    format: Format,
    library: &Library,
    composer: &mut Compose,
) -> Result<Preset, orogen::Error> {
    if let Some(projection) = args.projection.map(known) {
        let declarations = composer.survey(library, &preset)?.declarations;
        projection.set(&mut preset, &declarations)?;
    }
    for_a_file(format, composer, library, &mut preset, common)?;
    Ok(preset)
}

fn check_faces(args: &Render, shader: &Shader) -> Outcome {
    if args.faces && Projection::of(shader) != Projection::Cube {
        let why = "--faces writes the six faces of a cube: it needs `--projection cube`";
        return Err(Failure::Usage(why.into()));
    }
    Ok(())
}

/// Draws all frames, and says which files were written.
fn draw(
    args: &Render,
    common: &Common,
    gpu: &Gpu,
    shader: &Shader,
    preset: &Preset,
    path: &Path,
) -> Result<Vec<PathBuf>, Failure> {
    let format = Format::of(path)?;
    let projection = Projection::of(shader);
    let (width, height) = args.size.unwrap_or_else(|| projection.default_size());
    let (start, first) = first_frame(shader);
    let start = args.time.unwrap_or(start);
    let frames = args.frames.unwrap_or(1);
    let mut written = Vec::new();
    let bar = progress::bar(preset.name(), common.quiet);
    for index in 0..frames {
        let shot = Shot {
            samples: args.samples,
            time: start + index as f32 / args.fps,
            delta: args.frames.map(|_| 1.0 / args.fps),
            index: first.wrapping_add(index),
            mouse: args.mouse,
            ..Shot::new(width, height)
        };
        let shot = projection.shot(shot, width, height)?;
        let mut report = |done: u64, total: u64| {
            bar.set_length(total * u64::from(frames));
            bar.set_position(done + total * u64::from(index));
        };
        let target = if args.frames.is_some() { numbered(path, index, frames) } else { path.to_owned() };
        let targets =
            if args.faces { render::FACES.map(|face| marked(&target, face)).to_vec() } else { vec![target] };
        targets.iter().try_for_each(|target| made_of::spare(shader, target))?;
        let picture = render::render(gpu, shader, preset, &shot, &mut report)?;
        let pictures = if args.faces { render::faces(&picture).to_vec() } else { vec![picture] };
        write(&targets, &pictures, format)?;
        written.extend(targets);
    }
    bar.finish_and_clear();
    Ok(written)
}

/// `a.png`, or `a_0001.png and 47 more`.
fn told(written: &[PathBuf]) -> String {
    let what = written.first().map_or_else(String::new, |first| first.display().to_string());
    let more = if written.len() > 1 { format!(" and {} more", written.len() - 1) } else { String::new() };
    format!("{what}{more}")
}

fn known(projection: args::Projection) -> Projection {
    match projection {
        args::Projection::Perspective => Projection::Perspective,
        args::Projection::Equirectangular => Projection::Equirectangular,
        args::Projection::Cube => Projection::Cube,
    }
}

/// All of them, or, as far as that can be told before, none.
fn write(targets: &[PathBuf], pictures: &[Picture], format: Format) -> Outcome {
    let files = pictures.iter().map(|picture| render::encode(picture, format));
    let files = files.collect::<Result<Vec<_>, _>>()?;
    let drafts = targets.iter().zip(&files).map(|(target, file)| output::prepare(target, file));
    let drafts = drafts.collect::<Result<Vec<_>, _>>()?;
    drafts.into_iter().try_for_each(output::Draft::persist)
}

/// What a display would need is left out where the scene has an option for it: dithering, which is done once the samples are
/// averaged ([`render::encode`]), and in pictures of linear light, which are for further work, the tone map.
fn for_a_file(
    format: Format,
    composer: &mut Compose,
    library: &Library,
    preset: &mut Preset,
    common: &Common,
) -> Result<(), orogen::Error> {
    const TONE_MAP: &str = "display.tone_map";
    const DITHER: &str = "display.dither";
    let declarations = composer.survey(library, preset)?.declarations;
    let is_told = |name| common.set.iter().any(|assignment| name_in(assignment) == name);
    if format == Format::Exr && !is_told(TONE_MAP) && can_be_none(&declarations, TONE_MAP) {
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
    marked(path, &format!("{:0digits$}", index + 1))
}

/// `out.png` → `out_px.png`
fn marked(path: &Path, mark: &str) -> PathBuf {
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let extension = path.extension().map_or_else(String::new, |ext| ext.to_string_lossy().into_owned());
    path.with_file_name(format!("{stem}_{mark}.{extension}"))
}
