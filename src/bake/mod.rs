//! Values put in: [`Composition`] + [`Bake`] → [`Baked`]: the text, where every byte of it is from, and its interface.
//!
//! What the result looks like is the template `wgsl.jinja`. The fragments' own text never goes through the template
//! engine: the template places a mark for each piece, and the pieces go in afterwards, so that the source map stays exact.

mod facts;
mod interface;
mod literal;
mod map;
mod plan;
mod text;

pub(crate) use facts::Facts;
pub(crate) use interface::suffixes;
pub use interface::{Binding, EntryPoint, Field, Interface, Override, Resource, Uniform, UniformGroup};
pub(crate) use literal::in_code;
pub use literal::literal;
pub use map::{Origin, Segment, SourceMap};
pub use plan::{Bake, Storage};
pub(crate) use text::{apart, clean, directive_text, read};

use crate::compose::Composition;
use crate::diagnostic::Error;
use crate::preset::{Declarations, Declared, Preset, settle};
use crate::source::{Files, Templates};
use crate::syntax::Value;

/// A composed shader with its values in it, not yet checked.
pub struct Baked {
    /// The text.
    pub text: String,
    /// Where every byte of it is from.
    pub map: SourceMap,
    /// Uniform layout and overrides.
    pub interface: Interface,
    /// What each parameter became, by number.
    pub storage: Vec<Storage>,
    /// What it was made of.
    pub composition: Composition,
}

/// Puts the values of `composition` in.
///
/// # Errors
/// Patterns that match no parameter; a template that cannot be rendered.
pub fn bake(composition: Composition, bake: &Bake, templates: &Templates) -> Result<Baked, Error> {
    let storage = plan::plan(&composition, bake)?;
    let used: Vec<_> =
        (0..composition.parameters.len()).filter(|index| composition.parameters[*index].read).collect();
    let interface = interface::interface(&composition, &storage, &used, bake.binding);
    let (text, map) = text::assemble(&composition, &storage, &used, &interface, templates)?;
    Ok(Baked { text, map, interface, storage, composition })
}

/// The bytes of the uniform buffer with the values of `preset`; none where no parameter is live.
pub(crate) fn uniform_bytes(
    interface: &Interface,
    parameters: &Declarations,
    declared_in: &Files,
    preset: &Preset,
) -> Result<Vec<u8>, Error> {
    let settings = settle(preset, parameters).map_err(|errors| {
        // The declarations' texts are numbered as the composition read them, not as this preset did.
        let mut files = preset.files.clone();
        let offset = files.append(declared_in);
        let diagnostics = errors.into_iter().map(|mut error| {
            error.kind.shift_declared(offset);
            error.into()
        });
        Error::new(diagnostics.collect(), files)
    })?;
    let values = parameters.parameters.iter().zip(&settings.parameters);
    let values = values.map(|(declared, value)| (declared, *value));
    Ok(layout_bytes(interface, values))
}

fn layout_bytes<'a>(
    interface: &Interface,
    values: impl Iterator<Item = (&'a Declared<crate::syntax::ParamDecl>, Value)>,
) -> Vec<u8> {
    let Some(uniform) = &interface.uniform else { return Vec::new() };
    let mut bytes = vec![0; uniform.size as usize];
    for (declared, value) in values {
        let key = declared.decl.key.to_string();
        if let Some(field) = uniform.fields.iter().find(|field| field.parameter == key) {
            let value = literal::in_code(&value, declared.decl.unit.as_deref());
            let at = field.offset as usize;
            bytes[at..at + field.size as usize].copy_from_slice(&literal::bytes(&value));
        }
    }
    bytes
}
