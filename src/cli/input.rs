//! From what stands on the command line to what the library takes.

use std::path::{Path, PathBuf};

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
    Ok(Origin::of(name)?.read(&common.set)?)
}

/// Where a preset comes from.
#[derive(Debug, Clone)]
pub(super) enum Origin {
    BuiltIn(String),
    Module(String),
    Json(PathBuf),
    Fragment(PathBuf),
}

impl Origin {
    /// What `name` stands for.
    pub(super) fn of(name: &str) -> Result<Self, Failure> {
        let path = Path::new(name);
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        Ok(match extension.as_deref() {
            _ if name.starts_with('<') => Self::Module(module(name)?.to_owned()),
            Some("json") => Self::Json(path.to_owned()),
            Some("wgsl") => Self::Fragment(path.to_owned()),
            _ if is_meant_as_path(name) => {
                let why = format!("`{name}`: a preset's file ends in .json, a fragment's in .wgsl");
                return Err(Failure::System(why));
            }
            _ => Self::BuiltIn(name.to_owned()),
        })
    }

    /// The preset as it is now, with the values of `--set`.
    pub(super) fn read(&self, set: &[String]) -> Result<Preset, orogen::Error> {
        let mut preset = match self {
            Self::BuiltIn(name) => Preset::named(name)?,
            Self::Module(path) => Preset::of_module(path),
            Self::Json(path) => Preset::file(path)?,
            Self::Fragment(path) => Preset::of_file(path),
        };
        set.iter().try_for_each(|assignment| preset.set(assignment))?;
        Ok(preset)
    }

    /// The file on disk, if it is one.
    pub(super) fn path(&self) -> Option<&Path> {
        match self {
            Self::Json(path) | Self::Fragment(path) => Some(path),
            Self::BuiltIn(_) | Self::Module(_) => None,
        }
    }
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
