//! One file per target.

use crate::diagnostic::Error;
use crate::source::{Source, Templates};
use crate::template;

/// The stage of the entry point that a scene gets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Stage {
    /// A triangle over the whole target, and a fragment entry point.
    #[default]
    Fragment,
    /// A compute entry point that writes a storage texture.
    Compute,
    /// `main_image` itself is what the target calls.
    MainImage,
}

/// The entry point of a scene that has `main_image`, as a fragment that calls it.
pub(crate) fn entry_point(stage: Stage, templates: &Templates) -> Result<Source, Error> {
    let name = match stage {
        Stage::Fragment => "entry_fragment.wgsl",
        Stage::Compute => "entry_compute.wgsl",
        Stage::MainImage => "entry_main_image.wgsl",
    };
    let text = template::render(templates, name, ())?;
    Ok(Source::text(format!("templates/{name}"), text))
}
