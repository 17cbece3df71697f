//! From what stands on the command line to what the library takes.

use std::path::{Path, PathBuf};

use orogen::{Compose, Library, Preset, Templates};

use super::args::{Baking, Common};
use super::failure::Failure;

/// The library, with the folders of `-I` over it.
pub(super) fn library(common: &Common) -> Result<Library, Failure> {
    common.folders.iter().try_fold(Library::standard(), |library, folder| {
        library.with_folder(folder).map_err(|why| Failure::Usage(format!("-I: {why}")))
    })
}

/// A composer with the templates of `--templates`.
pub(super) fn composer(common: &Common) -> Result<Compose, Failure> {
    let mut composer = Compose::default();
    if let Some(folder) = &common.templates {
        composer.templates =
            Templates::with_folder(folder).map_err(|why| Failure::Usage(format!("--templates: {why}")))?;
    }
    Ok(composer)
}

/// The preset that `name` stands for, with the values of `--set`.
pub(super) fn preset(name: &str, common: &Common) -> Result<Preset, Failure> {
    let path = Path::new(name);
    let extension = path.extension().and_then(|extension| extension.to_str());
    let mut preset = match extension {
        _ if name.starts_with('<') => Preset::of_module(name.trim_matches(['<', '>'])),
        Some("json") => Preset::file(path)?,
        Some("wgsl") => Preset::of_file(PathBuf::from(name)),
        _ => Preset::named(name)?,
    };
    for assignment in &common.set {
        preset.set(assignment)?;
    }
    Ok(preset)
}

/// How parameters are baked.
pub(super) fn bake(baking: &Baking) -> orogen::Bake {
    orogen::Bake::live(baking.live.clone()).with_overrides(baking.overrides.clone())
}
