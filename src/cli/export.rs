//! `orogen export`

use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use orogen::export;

use super::args::{self, Common, Export};
use super::failure::{Failure, Outcome};
use super::{input, output};

pub(super) fn run(args: &Export, common: &Common) -> Outcome {
    let target = match args.target {
        args::Target::Wgsl => export::Target::Wgsl,
        args::Target::Shadertoy => export::Target::Shadertoy,
        args::Target::Glsl => export::Target::Glsl,
        args::Target::Spirv => export::Target::Spirv,
        args::Target::Hlsl => export::Target::Hlsl,
        args::Target::Msl => export::Target::Msl,
        args::Target::Json => export::Target::Json,
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
    if to_stdout && target == export::Target::Spirv && std::io::stdout().is_terminal() {
        return Err(Failure::Usage("SPIR-V is binary: write it to a file with `-o FILE`".into()));
    }
    let library = input::library(common)?;
    let preset = input::preset(&args.preset, common)?;
    let mut composer = input::composer(common)?;
    composer.stage =
        target.stage(stage).map_err(|error| Failure::Usage(error.diagnostics()[0].message.clone()))?;
    composer.keep_unused = args.keep_unused;
    let shader = composer.run(&library, &preset, &target.bake(input::bake(&args.baking)))?;
    let bytes = export::export(&shader, target, &composer.templates)?;
    if args.source_map {
        let name =
            args.output.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let mut beside = args.output.clone().into_os_string();
        beside.push(".map");
        output::write(&PathBuf::from(beside), export::source_map(&shader, &name).as_bytes())?;
    }
    output::write(&args.output, &bytes)
}
