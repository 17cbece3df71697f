//! Rust for a shader's host: [`Shader`] → one file of structs, constants and layouts.
//!
//! What the file looks like is the template `rust.jinja`; here is decided what things are called and where padding goes. Each
//! group of live parameters is a `#[repr(C)]` struct, and the uniform buffer a struct of those, since the buffer's layout
//! has each group on its own (see [`Uniform`](crate::bake::Uniform)). Every offset is asserted in the file itself.

use std::collections::HashSet;

use serde::Serialize;

use super::header::header;
use crate::bake::{Binding, Field, Resource, Storage, clean, in_code, suffixes};
use crate::compose::Parameter;
use crate::diagnostic::Error;
use crate::shader::Shader;
use crate::source::Templates;
use crate::syntax::Value;
use crate::template;

/// What vectors are in the generated Rust.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Types {
    /// `[f32; 3]`
    #[default]
    Arrays,
    /// `glam::Vec3`
    Glam,
}

/// What the generated Rust is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RustStyle {
    /// What vectors are.
    pub types: Types,
    /// Whether there are layouts of bind groups, for hosts that use `wgpu` 30.
    pub layouts: bool,
    /// Whether the shader's text is in it too, so that the two cannot differ.
    pub wgsl: bool,
}

impl Default for RustStyle {
    /// Arrays; with layouts; with the text.
    fn default() -> Self {
        Self { types: Types::Arrays, layouts: true, wgsl: true }
    }
}

#[derive(Serialize)]
struct Context {
    header: String,
    glam: bool,
    uniform: Option<Whole>,
    groups: Vec<Group>,
    overrides: Vec<Constant>,
    entry_points: Vec<Constant>,
    bind_groups: Vec<BindGroup>,
    /// A literal; empty where it is not wanted.
    wgsl: String,
}

#[derive(Serialize)]
struct Whole {
    ty: String,
    group: u32,
    binding: u32,
    size: u32,
}

#[derive(Serialize)]
struct Group {
    /// `sun`
    name: String,
    field: String,
    ty: String,
    offset: u32,
    size: u32,
    fields: Vec<Member>,
}

#[derive(Serialize)]
struct Member {
    name: String,
    ty: String,
    value: String,
    /// From the group's start.
    offset: u32,
    doc: Vec<String>,
    padding: bool,
}

#[derive(Serialize)]
struct Constant {
    name: String,
    id: String,
    doc: Vec<String>,
    about: String,
    value: String,
}

#[derive(Serialize)]
struct BindGroup {
    number: u32,
    entries: Vec<Entry>,
}

#[derive(Serialize)]
struct Entry {
    name: String,
    binding: u32,
    visibility: String,
    ty: String,
}

/// A Rust file for the host of `shader`.
///
/// # Errors
/// Where a template cannot be rendered.
pub fn bindings(shader: &Shader, style: &RustStyle, templates: &Templates) -> Result<String, Error> {
    let baked = shader.baked();
    let context = Context {
        header: header(shader, templates)?,
        glam: style.types == Types::Glam,
        uniform: shader.interface().uniform.as_ref().map(|uniform| Whole {
            ty: "Params".to_owned(),
            group: uniform.group,
            binding: uniform.binding,
            size: uniform.size,
        }),
        groups: groups(shader, style.types),
        overrides: overrides(shader),
        entry_points: entry_points(shader),
        bind_groups: if style.layouts { bind_groups(shader) } else { Vec::new() },
        wgsl: if style.wgsl { text_literal(&baked.text) } else { String::new() },
    };
    template::render(templates, "rust.jinja", context)
}

fn groups(shader: &Shader, types: Types) -> Vec<Group> {
    let Some(uniform) = &shader.interface().uniform else { return Vec::new() };
    let mut taken: HashSet<String> = HashSet::from(["Params".to_owned(), "Self".to_owned()]);
    let group = |group: &crate::bake::UniformGroup| {
        let inside = group.offset..group.offset + group.size;
        let fields: Vec<_> = uniform.fields.iter().filter(|field| inside.contains(&field.offset)).collect();
        Group {
            name: group.name.clone(),
            field: ident(&group.name),
            ty: free(camel(&group.name), &mut taken),
            offset: group.offset,
            size: group.size,
            fields: members(shader, &fields, group.offset, group.size, types),
        }
    };
    uniform.groups.iter().map(group).collect()
}

/// The fields of a group, with padding before and behind them where there is any.
fn members(shader: &Shader, fields: &[&Field], start: u32, size: u32, types: Types) -> Vec<Member> {
    let parameters = &shader.baked().composition.parameters;
    let mut taken = HashSet::new();
    let mut members = Vec::new();
    let mut end = 0;
    for field in fields {
        let Some(parameter) = parameters.iter().find(|p| p.decl.key.to_string() == field.parameter) else {
            continue;
        };
        let offset = field.offset - start;
        pad(&mut members, &mut taken, end, offset);
        let (ty, value) = typed(parameter, types);
        let name = free(ident(&parameter.decl.key.name), &mut taken);
        members.push(Member { name, ty, value, offset, doc: doc(parameter), padding: false });
        end = offset + field.size;
    }
    pad(&mut members, &mut taken, end, size);
    members
}

fn pad(members: &mut Vec<Member>, taken: &mut HashSet<String>, from: u32, to: u32) {
    let words = to.saturating_sub(from) / 4;
    if words > 0 {
        let number = members.iter().filter(|member| member.padding).count();
        let name = free(format!("_pad{number}"), taken);
        let (ty, value) = (format!("[u32; {words}]"), format!("[0; {words}]"));
        members.push(Member { name, ty, value, offset: from, doc: Vec::new(), padding: true });
    }
}

/// The Rust type and the preset's value, angles in radians.
fn typed(parameter: &Parameter, types: Types) -> (String, String) {
    let value = in_code(&parameter.value, parameter.decl.unit.as_deref());
    let parts: Vec<_> = value.floats().iter().map(|value| format!("{value:?}")).collect();
    let list = parts.join(", ");
    match (value, types) {
        (Value::Bool(on), _) => ("u32".to_owned(), u32::from(on).to_string()),
        (Value::I32(value), _) => ("i32".to_owned(), value.to_string()),
        (Value::U32(value), _) => ("u32".to_owned(), value.to_string()),
        (Value::F32(_), _) => ("f32".to_owned(), list),
        (_, Types::Arrays) => (format!("[f32; {}]", parts.len()), format!("[{list}]")),
        (_, Types::Glam) => {
            let ty = format!("::glam::Vec{}", parts.len());
            (ty.clone(), format!("{ty}::new({list})"))
        }
    }
}

/// What the declaration says, then unit and range on a line of their own.
fn doc(parameter: &Parameter) -> Vec<String> {
    let decl = &parameter.decl;
    let mut lines: Vec<_> = decl.doc.lines().map(plain).collect();
    let angle = decl.unit.as_deref() == Some("deg");
    let mut remarks = Vec::new();
    if decl.ty == crate::syntax::Type::Bool {
        remarks.push("0 or 1".to_owned());
    }
    if decl.color {
        remarks.push("linear sRGB".to_owned());
    }
    match decl.unit.as_deref() {
        Some("deg") => remarks.push("in rad".to_owned()),
        Some(unit) => remarks.push(format!("in {}", plain(unit))),
        None => {}
    }
    match decl.range {
        Some((low, high)) if angle => {
            let [a, b] = [low, high].map(|degrees| degrees.to_radians() as f32);
            remarks.push(format!("{a} .. {b} ({low}° .. {high}°)"));
        }
        Some((low, high)) => remarks.push(format!("{low} .. {high}")),
        None => {}
    }
    if lines.is_empty() {
        lines.push(format!("`{}`", decl.key));
    }
    if !remarks.is_empty() {
        lines.extend([String::new(), format!("`{}`: {}.", decl.key, remarks.join(", "))]);
    }
    lines
}

/// Text for a comment: on one line, and without the marks that turn the direction of writing, which Rust refuses.
fn plain(text: &str) -> String {
    let turns = |c: &char| matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    clean(text).chars().filter(|c| !turns(c)).collect()
}

fn overrides(shader: &Shader) -> Vec<Constant> {
    let baked = shader.baked();
    let composition = &baked.composition;
    let mut taken = HashSet::from(["VALUES".to_owned()]);
    let mut all = Vec::new();
    let parameters = composition.parameters.iter().zip(&baked.storage);
    for (parameter, _) in parameters.filter(|(p, storage)| p.read && **storage == Storage::Override) {
        let decl = &parameter.decl;
        let value = in_code(&parameter.value, decl.unit.as_deref());
        let numbers = match value {
            Value::Bool(on) => vec![f64::from(u8::from(on))],
            Value::I32(value) => vec![f64::from(value)],
            Value::U32(value) => vec![f64::from(value)],
            floats => floats.floats().iter().map(|value| f64::from(*value)).collect(),
        };
        for (suffix, number) in suffixes(decl.ty).iter().zip(numbers) {
            let name = free(format!("{}{suffix}", decl.key.flat()).to_uppercase(), &mut taken);
            let id = composition.flat(&decl.key) + suffix;
            all.push(Constant {
                name,
                id,
                doc: doc(parameter),
                about: String::new(),
                value: format!("{number:?}"),
            });
        }
    }
    all
}

fn entry_points(shader: &Shader) -> Vec<Constant> {
    let mut taken = HashSet::new();
    let constant = |entry: &crate::bake::EntryPoint| Constant {
        name: free(entry.name.to_uppercase(), &mut taken),
        id: entry.name.clone(),
        doc: Vec::new(),
        about: match entry.workgroup_size {
            Some([x, y, z]) => format!("A compute entry point; workgroups are {x} × {y} × {z}."),
            None => format!("A {} entry point.", entry.stage),
        },
        value: String::new(),
    };
    shader.interface().entry_points.iter().map(constant).collect()
}

fn bind_groups(shader: &Shader) -> Vec<BindGroup> {
    let mut bindings = shader.interface().bindings.clone();
    bindings.sort_by_key(|binding| (binding.group, binding.binding));
    let mut groups: Vec<BindGroup> = Vec::new();
    for binding in &bindings {
        let Some(ty) = layout(&binding.resource) else { continue };
        let entry = Entry {
            name: plain(&binding.name),
            binding: binding.binding,
            visibility: visibility(binding),
            ty,
        };
        match groups.last_mut() {
            Some(last) if last.number == binding.group => last.entries.push(entry),
            _ => groups.push(BindGroup { number: binding.group, entries: vec![entry] }),
        }
    }
    groups
}

/// The stages that read it; of a module without an entry point, any may.
fn visibility(binding: &Binding) -> String {
    let stage = |stage: &&str| match *stage {
        "vertex" => "::wgpu::ShaderStages::VERTEX",
        "fragment" => "::wgpu::ShaderStages::FRAGMENT",
        _ => "::wgpu::ShaderStages::COMPUTE",
    };
    let all = ["vertex", "fragment", "compute"];
    let stages: &[&str] = if binding.stages.is_empty() { &all } else { &binding.stages };
    let mut stages = stages.iter().map(stage);
    let first = stages.next().unwrap_or_default().to_owned();
    stages.fold(first, |all, stage| format!("{all}.union({stage})"))
}

/// As `wgpu` 30 says it.
fn layout(resource: &Resource) -> Option<String> {
    let buffer = |ty: &str, size: u32| {
        format!(
            "::wgpu::BindingType::Buffer {{ ty: ::wgpu::BufferBindingType::{ty}, has_dynamic_offset: false, \
             min_binding_size: ::core::num::NonZeroU64::new({size}) }}"
        )
    };
    let view = |dimension: &str| format!("::wgpu::TextureViewDimension::{dimension}");
    Some(match resource {
        Resource::Uniform { size } => buffer("Uniform", *size),
        Resource::Storage { read_only, size } => {
            buffer(&format!("Storage {{ read_only: {read_only} }}"), *size)
        }
        Resource::Sampler { comparison } => {
            let kind = if *comparison { "Comparison" } else { "Filtering" };
            format!("::wgpu::BindingType::Sampler(::wgpu::SamplerBindingType::{kind})")
        }
        Resource::Texture { sample, dimension, multisampled } => {
            let sample = match (*sample, *multisampled) {
                ("float", multisampled) => format!("Float {{ filterable: {} }}", !multisampled),
                ("sint", _) => "Sint".to_owned(),
                ("uint", _) => "Uint".to_owned(),
                _ => "Depth".to_owned(),
            };
            format!(
                "::wgpu::BindingType::Texture {{ sample_type: ::wgpu::TextureSampleType::{sample}, \
                 view_dimension: {}, multisampled: {multisampled} }}",
                view(dimension)
            )
        }
        Resource::StorageTexture { format, access, dimension } => format!(
            "::wgpu::BindingType::StorageTexture {{ access: ::wgpu::StorageTextureAccess::{access}, \
             format: ::wgpu::TextureFormat::{format}, view_dimension: {} }}",
            view(dimension)
        ),
        Resource::Other => return None,
    })
}

/// `name` as a Rust identifier.
fn ident(name: &str) -> String {
    // Of Rust's words, those that `r#` cannot make names of.
    const NEVER: [&str; 4] = ["self", "Self", "super", "crate"];
    const WORDS: &str = "as break const continue else enum extern false fn for if impl in let loop match mod move mut pub ref \
        return static struct trait true type unsafe use where while async await dyn abstract become box do final macro \
        override priv typeof unsized virtual yield try gen";
    if NEVER.contains(&name) {
        format!("{name}_")
    } else if WORDS.split_whitespace().any(|word| word == name) {
        format!("r#{name}")
    } else {
        name.to_owned()
    }
}

/// `tree_line` → `TreeLine`
fn camel(name: &str) -> String {
    let words = name.split('_').filter(|word| !word.is_empty());
    let word = |word: &str| {
        let mut letters = word.chars();
        letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
    };
    let joined: String = words.map(word).collect();
    if joined.starts_with(|c: char| c.is_alphabetic()) { joined } else { format!("Group{joined}") }
}

/// `name`, or with `_` behind it until nobody else has it.
fn free(mut name: String, taken: &mut HashSet<String>) -> String {
    while !taken.insert(name.clone()) {
        name.push('_');
    }
    name
}

/// `text` as a Rust literal: raw, so that it can be read, where Rust allows that.
fn text_literal(text: &str) -> String {
    let odd = |c: char| {
        c != '\n' && c != '\t' && c.is_control()
            || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    if text.contains(odd) {
        let escaped: String = text.chars().flat_map(char::escape_default).collect();
        return format!("\"{escaped}\"");
    }
    let longest = text.split('"').skip(1).map(|rest| rest.len() - rest.trim_start_matches('#').len()).max();
    let hashes = "#".repeat(longest.map_or(1, |longest| longest + 1));
    format!("r{hashes}\"{text}\"{hashes}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_rust_s() {
        assert_eq!(["type", "self", "sun"].map(ident), ["r#type", "self_", "sun"]);
        assert_eq!(["sun", "relief_detail", "_x", "9"].map(camel), ["Sun", "ReliefDetail", "X", "Group9"]);
        let mut taken = HashSet::new();
        assert_eq!(["A", "A", "A"].map(|name| free(name.into(), &mut taken)), ["A", "A_", "A__"]);
    }

    #[test]
    fn any_text_is_a_literal() {
        assert_eq!(text_literal("a"), "r#\"a\"#");
        assert_eq!(text_literal("say \"#hi\"##"), "r###\"say \"#hi\"##\"###");
        assert_eq!(text_literal("a\rb"), "\"a\\rb\"");
    }
}
