//! One WGSL expression over many points → [`Table`]: what `orogen eval` runs on the GPU.
//!
//! In steps: the expression is held against the lexer (`expression`), a fragment with it is written (`text`) and composed
//! once to learn its type (`layout`) and once more as a compute shader that stores its components (`sampler`), which then
//! runs over the points in a few dispatches (`dispatch`). Errors point into the expression as its author wrote it.
//!
//! [`evaluate`] does it once; a [`Sampler`] is kept by who asks again and again.

mod dispatch;
mod error;
mod expression;
mod layout;
mod sampler;
mod suggest;
mod text;
mod value;

pub use error::SampleError;
pub use sampler::Sampler;
pub use value::{Column, Kind, Points, Scalar, Table};

use super::adapter::Gpu;
use crate::bake::Bake;
use crate::diagnostic::Error;
use crate::preset::Preset;
use crate::shader::{Compose, Shader};
use crate::source::{Library, Source, Templates};
use text::Root;

/// What to evaluate, and where.
#[derive(Debug, Clone, Copy)]
pub struct Query<'a> {
    /// One WGSL expression.
    pub expression: &'a str,
    /// Fragments whose names it uses: `<noise/perlin.wgsl>`, or all else that can follow `#include`.
    pub includes: &'a [String],
    /// Gives parameters and options their values, and its scene's names to the expression.
    pub preset: Option<&'a Preset>,
    /// The points; without columns, there is one evaluation.
    pub points: &'a Points,
}

/// Evaluates the expression at every point.
///
/// Each column is a scalar of its name in the expression; columns `x`, `y` of f32 (and `z`, `w`) also make the vector `p`.
/// Parameters have the preset's values, or their defaults.
///
/// # Errors
/// What is wrong with the expression, the includes, the preset or the points; and what wgpu or the driver refuses.
pub fn evaluate(
    gpu: &Gpu,
    library: &Library,
    templates: &Templates,
    query: &Query<'_>,
) -> Result<Table, Error> {
    Sampler::of(gpu, library, templates, query)?.table(query.points)
}

/// The generated fragment beside the preset's scene, or alone.
fn composed(
    compose: &mut Compose,
    library: &Library,
    query: &Query<'_>,
    root: &Root,
) -> Result<Shader, Error> {
    let preset = preset(query, root);
    let has_scene = query.preset.is_some_and(|preset| preset.scene.is_some());
    compose.beside = has_scene.then(|| Source::text(text::NAME, root.text.as_str()));
    compose
        .run(library, &preset, &Bake::constants())
        .map_err(|error| suggest::helped(root.told(error, query), library))
}

fn preset(query: &Query<'_>, root: &Root) -> Preset {
    match query.preset {
        Some(preset) if preset.scene.is_some() => preset.clone(),
        Some(preset) => preset.clone().with_scene_text(text::NAME, &root.text),
        None => Preset::of_text(text::NAME, &root.text),
    }
}
