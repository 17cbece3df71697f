//! One file per target: `Shader` → WGSL, Shadertoy, GLSL ES 3.00, ISF, compute.toys, SPIR-V, HLSL, MSL, JSON,
//! or Rust; and a folder of WESL modules.
//!
//! A target says how it wants the shader composed (`Target::stage`, `Target::bake`); `export` then writes the file. Targets
//! need the feature `check`; without it there are WGSL itself, its source map, and [`bindings`] in Rust.

#[cfg(feature = "check")]
mod back;
#[cfg(feature = "check")]
mod error;
#[cfg(feature = "check")]
mod glsl;
mod header;
#[cfg(feature = "check")]
mod json;
#[cfg(feature = "check")]
mod minify;
mod rust;
mod source_map;
mod target;
#[cfg(feature = "check")]
mod toys;
#[cfg(feature = "check")]
mod typed;
mod wesl;

#[cfg(feature = "check")]
pub use error::ExportError;
#[cfg(feature = "check")]
pub use glsl::{Glsl, Tabs, glsl, shadertoy_tabs};
#[cfg(feature = "check")]
pub use minify::{Minified, minify, minify_text};
pub use rust::{RustStyle, Types, bindings};
pub use source_map::source_map;
pub use target::Stage;
#[cfg(feature = "check")]
pub use target::Target;
pub use wesl::{LibraryStyle, Package, library_features, library_package, package};

use crate::diagnostic::Error;
#[cfg(feature = "check")]
use crate::shader::Shader;
use crate::source::{Source, Templates};
use crate::template;

/// The file for `target`. Of several fragment entry points, GLSL and Shadertoy get the first.
///
/// # Errors
/// Where the target has no words for what the shader does, or a template cannot be rendered.
#[cfg(feature = "check")]
pub fn export(shader: &Shader, target: Target, templates: &Templates) -> Result<Vec<u8>, Error> {
    export_entry(shader, target, None, templates)
}

/// As [`export`], with the fragment entry point that GLSL or Shadertoy is to get chosen by name.
///
/// # Errors
/// As [`export`], and where there is no such entry point.
#[cfg(feature = "check")]
pub fn export_entry(
    shader: &Shader,
    target: Target,
    entry_point: Option<&str>,
    templates: &Templates,
) -> Result<Vec<u8>, Error> {
    if target == Target::Shadertoy && !shader.baked().composition.prefix.is_empty() {
        return Err(ExportError::Prefix { target }.told(shader)); // it calls `mainImage` and sets variables by name
    }
    let text = match target {
        Target::Wgsl => Ok(shader.wgsl().to_owned()),
        Target::Json => Ok(json::interface(shader)),
        Target::Glsl | Target::Shadertoy | Target::Isf => {
            return glsl(shader, target, entry_point, templates).map(|glsl| glsl.text.into_bytes());
        }
        Target::ComputeToys => toys::wgsl(shader),
        Target::Hlsl => back::hlsl(shader, templates)?,
        Target::Msl => back::msl(shader, templates)?,
        Target::Rust => return bindings(shader, &RustStyle::default(), templates).map(String::into_bytes),
        Target::Spirv => return back::spirv(shader).map_err(|error| error.told(shader)),
        Target::Wesl => Err(ExportError::NotOneFile { target }),
    };
    text.map(String::into_bytes).map_err(|error: ExportError| error.told(shader))
}

/// `error`, told at its place.
#[cfg(feature = "check")]
fn export_error(error: ExportError, shader: &Shader) -> Error {
    error.told(shader)
}

/// The entry point of a scene that has `main_image`, as a fragment that calls it.
pub(crate) fn entry_point(stage: Stage, templates: &Templates) -> Result<Source, Error> {
    let name = match stage {
        Stage::Fragment => "entry_fragment.wgsl",
        Stage::Compute => "entry_compute.wgsl",
        Stage::MainImage => "entry_main_image.wgsl",
    };
    let text = template::render(templates, name, ())?;
    let shown = format!("templates/{name}");
    Ok(if templates.overlays(name) { Source::text(shown, text) } else { Source::ours(shown, text) })
}
