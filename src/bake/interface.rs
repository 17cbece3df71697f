//! What a host needs to know of a shader: entry points, bindings, the uniform buffer's layout, overrides.

use serde::Serialize;

use crate::compose::{Composition, Parameter, UNIFORM};
use crate::preset::listing::value_json;
use crate::syntax::Type;

use super::literal;
use super::plan::Storage;

/// What a host needs to know of a shader.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Interface {
    /// The entry points, in the order of the text.
    pub entry_points: Vec<EntryPoint>,
    /// Everything that is bound, the uniform buffer of live parameters included.
    pub bindings: Vec<Binding>,
    /// The uniform buffer of live parameters; none where no parameter is live.
    pub uniform: Option<Uniform>,
    /// The pipeline overrides.
    pub overrides: Vec<Override>,
}

/// An entry point.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct EntryPoint {
    /// Its name.
    pub name: String,
    /// `vertex`, `fragment` or `compute`.
    pub stage: &'static str,
    /// Of a compute entry point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub workgroup_size: Option<[u32; 3]>,
}

/// Something bound to the shader.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Binding {
    /// `@group`
    pub group: u32,
    /// `@binding`
    pub binding: u32,
    /// The variable's name.
    pub name: String,
    /// `uniform`, `storage`, `texture`, `sampler`, …
    pub kind: String,
}

/// The uniform buffer of live parameters.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Uniform {
    /// `@group`
    pub group: u32,
    /// `@binding`
    pub binding: u32,
    /// The variable's name.
    pub name: &'static str,
    /// Bytes.
    pub size: u32,
    /// Its fields, in order.
    pub fields: Vec<Field>,
}

/// A field of the uniform buffer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Field {
    /// `sun_elevation`
    pub name: String,
    /// `sun.elevation`
    pub parameter: String,
    /// Its WGSL type in the buffer: a `bool` travels as `u32`.
    #[serde(rename = "type")]
    pub ty: &'static str,
    /// Bytes from the buffer's start.
    pub offset: u32,
    /// Bytes.
    pub size: u32,
    /// The unit in the buffer: angles are in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// The preset's value, in that unit.
    pub value: serde_json::Value,
}

/// A pipeline override.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Override {
    /// The key by which a pipeline sets it: `sun_elevation`; of a vector, `terrain_rock_x` and so on.
    pub name: String,
    /// `sun.elevation`
    pub parameter: String,
    /// Its WGSL type.
    #[serde(rename = "type")]
    pub ty: &'static str,
    /// The unit: angles are in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// The preset's value, in that unit.
    pub default: serde_json::Value,
}

/// Alignment and size of a type in the uniform address space (WGSL §14.4.1).
pub(super) fn align_and_size(ty: Type) -> (u32, u32) {
    match ty {
        Type::Bool | Type::I32 | Type::U32 | Type::F32 => (4, 4),
        Type::Vec2f => (8, 8),
        Type::Vec3f => (16, 12),
        Type::Vec4f => (16, 16),
    }
}

fn unit_in_code(parameter: &Parameter) -> Option<String> {
    let unit = parameter.decl.unit.as_deref()?;
    Some(if unit == "deg" { "rad" } else { unit }.to_owned())
}

/// Uniform layout and overrides of the parameters that `used` names. Entry points and bindings are known after checking.
pub(super) fn interface(
    composition: &Composition,
    storage: &[Storage],
    used: &[usize],
    binding: (u32, u32),
) -> Interface {
    let mut interface = Interface::default();
    let mut fields = Vec::new();
    let (mut end, mut align) = (0u32, 16);
    for index in used {
        let parameter = &composition.parameters[*index];
        let (key, unit) = (&parameter.decl.key, unit_in_code(parameter));
        let value = literal::in_code(&parameter.value, parameter.decl.unit.as_deref());
        match storage[*index] {
            Storage::Uniform => {
                let (field_align, size) = align_and_size(parameter.decl.ty);
                let offset = end.next_multiple_of(field_align);
                (end, align) = (offset + size, align.max(field_align));
                fields.push(Field {
                    name: key.flat(),
                    parameter: key.to_string(),
                    ty: literal::uniform_type(parameter.decl.ty).name(),
                    offset,
                    size,
                    unit,
                    value: value_json(&value),
                });
            }
            Storage::Override => {
                for (scalar, suffix) in literal::scalars(&value).iter().zip(suffixes(parameter.decl.ty)) {
                    interface.overrides.push(Override {
                        name: key.flat() + suffix,
                        parameter: key.to_string(),
                        ty: scalar.ty().name(),
                        unit: unit.clone(),
                        default: value_json(scalar),
                    });
                }
            }
            Storage::Const | Storage::Variable => {}
        }
    }
    if !fields.is_empty() {
        let (group, binding) = binding;
        let size = end.next_multiple_of(align);
        interface.uniform = Some(Uniform { group, binding, name: UNIFORM.0, size, fields });
    }
    interface
}

/// What is put behind the name of a vector's override for each of its components.
pub(super) fn suffixes(ty: Type) -> &'static [&'static str] {
    match ty.components() {
        1 => &[""],
        n => &["_x", "_y", "_z", "_w"][..n],
    }
}
