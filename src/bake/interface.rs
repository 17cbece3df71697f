//! What a host needs to know of a shader: entry points, bindings, the uniform buffer's layout, overrides.

use std::ops::Range;

use rustc_hash::FxHashMap;
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
    /// Everything that is bound, the uniform buffer of live parameters included. Without the feature `check`, that alone.
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
    /// The stages whose entry points read it: `vertex`, `fragment`, `compute`. None where there are no entry points.
    pub stages: Vec<&'static str>,
    /// What a layout has to say of it.
    pub resource: Resource,
}

/// What a bind group's layout has to say of a binding. Names are those of WebGPU's Rust API, `wgpu`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Resource {
    /// A uniform buffer.
    Uniform {
        /// Bytes.
        size: u32,
    },
    /// A storage buffer.
    Storage {
        /// Whether the shader only reads it.
        read_only: bool,
        /// Bytes at least: an array of no fixed length counts as one element.
        size: u32,
    },
    /// A sampler.
    Sampler {
        /// Whether it compares.
        comparison: bool,
    },
    /// A texture that is sampled or loaded from.
    Texture {
        /// `float`, `sint`, `uint` or `depth`
        sample: &'static str,
        /// `D1`, `D2`, `D2Array`, `D3`, `Cube` or `CubeArray`
        dimension: &'static str,
        /// Whether it has several samples a texel.
        multisampled: bool,
    },
    /// A texture that is written.
    StorageTexture {
        /// `Rgba8Unorm`, …
        format: String,
        /// `ReadOnly`, `WriteOnly` or `ReadWrite`
        access: &'static str,
        /// `D1`, `D2`, `D2Array` or `D3`
        dimension: &'static str,
    },
    /// Something else.
    Other,
}

/// The uniform buffer of live parameters: one group after the other, each from a multiple of 16 bytes on.
///
/// So the bytes of a group depend on which of its own parameters are live, and on nothing else.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Uniform {
    /// `@group`
    pub group: u32,
    /// `@binding`
    pub binding: u32,
    /// The variable's name.
    pub name: String,
    /// Bytes.
    pub size: u32,
    /// Its groups of parameters, in order.
    pub groups: Vec<UniformGroup>,
    /// Its fields, in order.
    pub fields: Vec<Field>,
}

impl Uniform {
    /// The bytes of one parameter (`sun.elevation`), or of a whole group (`sun`); none where it is not live.
    ///
    /// ```
    /// # let bake = orogen::Bake::live(["sun.*"]);
    /// let shader = orogen::compose(&orogen::Library::standard(), &orogen::Preset::named("alpine")?, &bake)?;
    /// let uniform = shader.interface().uniform.as_ref().ok_or("nothing is live")?;
    /// assert_eq!(uniform.range("sun.elevation").map(|bytes| bytes.len()), Some(4));
    /// assert_eq!(uniform.range("terrain.peak_height"), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn range(&self, name: &str) -> Option<Range<usize>> {
        let field = self.fields.iter().find(|field| field.parameter == name);
        let group = || self.groups.iter().find(|group| group.name == name);
        let (offset, size) = match field {
            Some(field) => (field.offset, field.size),
            None => group().map(|group| (group.offset, group.size))?,
        };
        Some(offset as usize..(offset + size) as usize)
    }
}

/// The live parameters of one group, next to each other in the uniform buffer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct UniformGroup {
    /// `sun`
    pub name: String,
    /// Bytes from the buffer's start, a multiple of 16.
    pub offset: u32,
    /// Bytes, a multiple of 16.
    pub size: u32,
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
    let mut layout = Layout::default();
    for index in &by_group(composition, storage, used) {
        let parameter = &composition.parameters[*index];
        let (key, unit) = (&parameter.decl.key, unit_in_code(parameter));
        let value = literal::in_code(&parameter.value, parameter.decl.unit.as_deref());
        match storage[*index] {
            Storage::Uniform => {
                let (align, size) = align_and_size(parameter.decl.ty);
                let offset = layout.place(&key.group, align, size);
                layout.fields.push(Field {
                    name: composition.flat(key),
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
                        name: composition.flat(key) + suffix,
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
    if !layout.fields.is_empty() {
        let (group, binding) = binding;
        let name = composition.prefix.before(UNIFORM.0);
        let Layout { end, groups, fields } = layout;
        let size = end.next_multiple_of(GROUP_ALIGN);
        interface.bindings.push(Binding {
            group,
            binding,
            name: name.clone(),
            kind: "uniform".to_owned(),
            stages: Vec::new(),
            resource: Resource::Uniform { size },
        });
        interface.uniform = Some(Uniform { group, binding, name, size, groups, fields });
    }
    interface
}

/// Where a group may start: where WGSL lets a struct start in a uniform buffer (§14.4.1).
const GROUP_ALIGN: u32 = 16;

#[derive(Default)]
struct Layout {
    end: u32,
    groups: Vec<UniformGroup>,
    fields: Vec<Field>,
}

impl Layout {
    /// The offset of a field of `group`, behind all that was placed before.
    fn place(&mut self, group: &str, align: u32, size: u32) -> u32 {
        if self.groups.last().is_none_or(|last| last.name != group) {
            self.end = self.end.next_multiple_of(GROUP_ALIGN);
            self.groups.push(UniformGroup { name: group.to_owned(), offset: self.end, size: 0 });
        }
        let offset = self.end.next_multiple_of(align);
        self.end = offset + size;
        if let Some(group) = self.groups.last_mut() {
            group.size = (self.end - group.offset).next_multiple_of(GROUP_ALIGN);
        }
        offset
    }
}

/// `used` with the live parameters of each group together, groups and what is in them in the order of declaration.
pub(super) fn by_group(composition: &Composition, storage: &[Storage], used: &[usize]) -> Vec<usize> {
    let group = |index: &usize| &composition.parameters[*index].decl.key.group;
    let mut first: FxHashMap<&String, usize> = FxHashMap::default();
    let mut all = used.to_vec();
    for index in used {
        first.entry(group(index)).or_insert(*index);
    }
    let is_live = |index: &usize| storage[*index] == Storage::Uniform;
    all.sort_by_key(|index| (is_live(index), if is_live(index) { first[group(index)] } else { *index }));
    all
}

/// Fields that fill the stretch from where a group ends, `end`, to where the `next` starts: the type of each. Spelled out,
/// since not every language that a shader is translated into keeps `@align`.
pub(super) fn padding(end: u32, next: u32) -> &'static [&'static str] {
    match next - end {
        4 => &["u32"],
        8 => &["vec2u"],
        12 => &["u32", "vec2u"],
        _ => &[],
    }
}

/// What is put behind the name of a vector's override for each of its components.
pub(crate) fn suffixes(ty: Type) -> &'static [&'static str] {
    match ty.components() {
        1 => &[""],
        n => &["_x", "_y", "_z", "_w"][..n],
    }
}
