//! From what stands on the command line to what the library takes.

use std::path::Path;

use orogen::source::preset_names;
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
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    let mut preset = match extension.as_deref() {
        _ if name.starts_with('<') => Preset::of_module(module(name)?),
        Some("json") => Preset::file(path)?,
        Some("wgsl") => Preset::of_file(path),
        _ if is_meant_as_path(name) => {
            let why = format!("`{name}`: a preset's file ends in .json, a fragment's in .wgsl");
            return Err(Failure::System(why));
        }
        _ => Preset::named(name)?,
    };
    for assignment in &common.set {
        preset.set(assignment)?;
    }
    Ok(preset)
}

/// `<noise/perlin.wgsl>` → `noise/perlin.wgsl`. Where only a module can stand, the brackets may be left out.
pub(super) fn module(name: &str) -> Result<&str, Failure> {
    let Some(rest) = name.strip_prefix('<') else { return Ok(name) };
    rest.strip_suffix('>').ok_or_else(|| {
        Failure::Usage(format!("`{name}` has no `>` at its end: write '<noise/perlin.wgsl>', in quotes"))
    })
}

/// Whether `name` is no name of a built-in preset, but of something on disk. A folder `alpine` hides no preset.
fn is_meant_as_path(name: &str) -> bool {
    !preset_names().contains(&name) && (name.contains(['/', '\\']) || Path::new(name).exists())
}

/// How parameters are baked.
pub(super) fn bake(baking: &Baking) -> orogen::Bake {
    orogen::Bake::live(baking.live.clone()).with_overrides(baking.overrides.clone())
}
