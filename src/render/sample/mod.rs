//! One WGSL expression over many points → [`Table`]: what `orogen eval` runs on the GPU.
//!
//! In steps: the expression is held against the lexer (`expression`), a fragment with it is written (`text`) and composed
//! once to learn its type (`layout`) and once more as a compute shader that stores its components, which then runs over
//! the points in a few dispatches (`dispatch`). Errors point into the expression as its author wrote it.

mod dispatch;
mod error;
mod expression;
mod layout;
mod suggest;
mod text;
mod value;

pub use error::SampleError;
pub use value::{Column, Kind, Points, Scalar, Table};

use super::adapter::Gpu;
use super::draw::only_bound_here;
use crate::bake::Bake;
use crate::diagnostic::Error;
use crate::preset::Preset;
use crate::shader::{Compose, Shader};
use crate::source::{Library, Source, Templates};
use layout::Leaf;
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
    expression::check(query.expression)?;
    text::check_includes(query.includes)?;
    value::check(query.points)?;
    let mut compose = Compose::default();
    compose.templates = templates.clone();
    let probe = text::root(query, None);
    let shader = composed(&mut compose, library, query, &probe)?;
    let leaves = layout::leaves(shader.checked(), text::ENTRY, text::VALUE)
        .map_err(|error| text::whole(query.expression, error))?;
    let kernel = text::root(query, Some(&leaves));
    let shader = composed(&mut compose, library, query, &kernel)?;
    run(gpu, &shader, query, &kernel, &leaves)
}

fn run(gpu: &Gpu, shader: &Shader, query: &Query<'_>, root: &Root, leaves: &[Leaf]) -> Result<Table, Error> {
    let uniform = shader.uniform_bytes(&preset(query, root))?;
    let bits = gpu.guarded(|| {
        let entries = &shader.interface().entry_points;
        let entry: Vec<_> = entries.iter().position(|entry| entry.name == text::ENTRY).into_iter().collect();
        only_bound_here(shader, &entry, &[text::INPUT, text::OUTPUT])?;
        dispatch::run(gpu, shader, &uniform, query.points, leaves.len())
    })?;
    let kinds = leaves.iter().map(|leaf| leaf.kind).cycle();
    Ok(Table {
        columns: leaves.iter().map(|leaf| leaf.name.clone()).collect(),
        values: bits.into_iter().zip(kinds).map(|(bits, kind)| Scalar::from_bits(kind, bits)).collect(),
    })
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
