//! `orogen export`

use std::io::IsTerminal;
use std::path::Path;

use orogen::{Prefix, Shader, Templates, export};

use super::args::{self, Common, Export};
use super::failure::{Failure, Outcome};
use super::{input, made_of, output, package};

pub(super) fn run(args: &Export, common: &Common) -> Outcome {
    let target = match args.target {
        args::Target::Wgsl => export::Target::Wgsl,
        args::Target::Shadertoy => export::Target::Shadertoy,
        args::Target::Glsl => export::Target::Glsl,
        args::Target::Isf => export::Target::Isf,
        args::Target::ComputeToys => export::Target::ComputeToys,
        args::Target::Spirv => export::Target::Spirv,
        args::Target::Hlsl => export::Target::Hlsl,
        args::Target::Msl => export::Target::Msl,
        args::Target::Json => export::Target::Json,
        args::Target::Rust => export::Target::Rust,
        args::Target::Wesl => export::Target::Wesl,
    };
    let stage = args.stage.map(|stage| match stage {
        args::Stage::Fragment => export::Stage::Fragment,
        args::Stage::Compute => export::Stage::Compute,
    });
    let to_stdout = args.output == Path::new("-");
    if args.source_map && (to_stdout || target != export::Target::Wgsl) {
        let why = "--source-map writes FILE.map beside a WGSL file: it needs `-o FILE` and the target wgsl";
        return Err(Failure::Usage(why.into()));
    }
    if to_stdout && !target.is_one_file() {
        return Err(Failure::Usage(format!("{target} is a folder of files: say which with `-o DIR`")));
    }
    if to_stdout && target == export::Target::Spirv && std::io::stdout().is_terminal() {
        return Err(Failure::Usage("SPIR-V is binary: write it to a file with `-o FILE`".into()));
    }
    if args.minify && !target.is_minified() {
        let error = orogen::Error::from(export::ExportError::NotMinified { target });
        let told = &error.diagnostics()[0];
        let help = told.help.as_deref().unwrap_or_default();
        return Err(Failure::Usage(format!("{}: {help}", told.message)));
    }
    if target == export::Target::Wesl && (args.preset.is_none() || args.keep_unused) {
        return whole_library(args, common, stage);
    }
    let Some(preset) = &args.preset else {
        let why = "which preset or fragment is to be written? `orogen list presets` names the built-in ones; only the target \
                   wesl takes none, for the whole library";
        return Err(Failure::Usage(why.into()));
    };
    let library = input::library(common)?;
    let preset = input::preset(preset, common)?;
    let mut composer = input::composer(common)?;
    composer.stage =
        target.stage(stage).map_err(|error| Failure::Usage(error.diagnostics()[0].message.clone()))?;
    composer.keep_unused = args.keep_unused;
    composer.module = args.module.as_deref().map(input::module).transpose()?.map(str::to_owned);
    composer.only.clone_from(&args.only);
    composer.prefix = Prefix::new(&args.prefix)?;
    composer.view.clone_from(&args.viewing.view);
    if args.common && (to_stdout || target != export::Target::Shadertoy) {
        let why = "--common writes two files for Shadertoy: it needs `-o FILE` and the target shadertoy";
        return Err(Failure::Usage(why.into()));
    }
    let (group, binding) = args.binding;
    let bake = input::bake(&args.baking).at_binding(group, binding);
    let shader = composer.run(&library, &preset, &target.bake(bake))?;
    if !target.is_one_file() {
        return package::write(&args.output, &export::package(&shader, &composer.templates)?);
    }
    if args.common {
        return write_tabs(&args.output, &shader, &composer.templates);
    }
    let minified = if args.minify { Some(export::minify(&shader, &composer.templates)?) } else { None };
    let bytes = match &minified {
        Some(minified) => minified.export(target, None, &composer.templates)?,
        None if target == export::Target::Rust => {
            let types = match args.types {
                args::Types::Arrays => export::Types::Arrays,
                args::Types::Glam => export::Types::Glam,
            };
            let style =
                export::RustStyle { types, layouts: !args.no_layouts, ..export::RustStyle::default() };
            export::bindings(&shader, &style, &composer.templates)?.into_bytes()
        }
        None => export::export(&shader, target, &composer.templates)?,
    };
    let shader = minified.as_ref().map_or(&shader, export::Minified::shader);
    if !args.baking.overrides.is_empty() && !common.quiet && !has_overrides(target) {
        output::complain(&format!(
            "note: {target} has no pipeline overrides: those parameters are constants\n"
        ));
    }
    made_of::spare(shader, &args.output)?;
    if args.source_map {
        write_with_map(&args.output, &bytes, shader)
    } else {
        output::write(&args.output, &bytes)
    }
}

fn has_overrides(target: export::Target) -> bool {
    matches!(
        target,
        export::Target::Wgsl | export::Target::Json | export::Target::Rust | export::Target::Wesl
    )
}

/// A WESL package of everything that the library has.
fn whole_library(args: &Export, common: &Common, stage: Option<export::Stage>) -> Outcome {
    let parts = [
        ("--view", args.viewing.view.is_some()),
        ("--module", args.module.is_some()),
        ("--only", !args.only.is_empty()),
        ("--prefix", !args.prefix.is_empty()),
    ];
    if let Some((flag, _)) = parts.iter().find(|(_, given)| *given) {
        return Err(Failure::Usage(format!(
            "{flag} is for what a preset reaches: the whole library is written without it"
        )));
    }
    let preset = match &args.preset {
        Some(name) => Some(input::preset(name, common)?),
        None if common.set.is_empty() => None,
        None => {
            let why = "--set and --quality set what a preset says: name one, and `--keep-unused` writes the whole library with it";
            return Err(Failure::Usage(why.into()));
        }
    };
    let (group, binding) = args.binding;
    let bake = input::bake(&args.baking).at_binding(group, binding);
    let style = export::LibraryStyle { preset, stage: stage.unwrap_or_default(), bake };
    let templates = input::composer(common)?.templates;
    package::write(&args.output, &export::library_package(&input::library(common)?, &style, &templates)?)
}

/// The files for the tabs Image and Common, or neither: `alpine.glsl` and `alpine.common.glsl`.
fn write_tabs(path: &Path, shader: &Shader, templates: &Templates) -> Outcome {
    let tabs = export::shadertoy_tabs(shader, templates)?;
    let extension = path.extension().map_or_else(|| "glsl".into(), |extension| extension.to_string_lossy());
    let beside = path.with_extension(format!("common.{extension}"));
    made_of::spare(shader, path)?;
    made_of::spare(shader, &beside)?;
    let drafts =
        [output::prepare(path, tabs.image.as_bytes())?, output::prepare(&beside, tabs.common.as_bytes())?];
    drafts.into_iter().try_for_each(output::Draft::persist)
}

/// The file and its map, or neither.
fn write_with_map(path: &Path, bytes: &[u8], shader: &Shader) -> Outcome {
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let map = export::source_map(shader, &name);
    let mut beside = path.as_os_str().to_owned();
    beside.push(".map");
    let beside = Path::new(&beside);
    made_of::spare(shader, beside)?;
    let drafts = [output::prepare(path, bytes)?, output::prepare(beside, map.as_bytes())?];
    drafts.into_iter().try_for_each(output::Draft::persist)
}
