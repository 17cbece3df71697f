//! The result's text: the template's, with the fragments' own text and the baked values in their places.

use std::fmt::Write;

use serde::Serialize;

use super::Baked;
use super::facts::Facts;
use super::interface::{Interface, by_group, padding, suffixes};
use super::literal::{in_code, literal, scalars, uniform_type};
use super::map::{Segment, SourceMap};
use super::plan::Storage;
use crate::compose::{Composition, Hoisted, OpenSlot, Parameter, Piece, UNIFORM};
use crate::diagnostic::Error;
use crate::preset::Knob;
use crate::source::{FileId, Span, Templates};
use crate::syntax::{DeclarationKind, OptionValue, Type};
use crate::template;

/// Around the number of a piece in the rendered template. Both are private-use characters: what comes into the template
/// from outside is freed of them.
const MARKS: (char, char) = ('\u{e0f0}', '\u{e0f1}');

/// The heading of live parameters that are variables.
const LIVE: &str = "live parameters: change them here";

/// What stands at a mark.
enum Insert<'a> {
    Part(&'a crate::compose::Part),
    Line { text: String, file: FileId, from: Span },
}

#[derive(Serialize)]
struct Context {
    /// `header.jinja`, rendered.
    header: String,
    #[serde(flatten)]
    facts: Facts,
    directives: Vec<String>,
    groups: Vec<Group>,
    uniform: Option<UniformBlock>,
    slots: Vec<Item>,
    modules: Vec<Item>,
}

#[derive(Serialize)]
struct Group {
    name: String,
    items: Vec<Item>,
}

#[derive(Serialize)]
struct UniformBlock {
    group: u32,
    binding: u32,
    name: String,
    ty: String,
    fields: Vec<Item>,
}

/// A declaration or a module, with what a template may want to say about it.
#[derive(Serialize, Default)]
struct Item {
    name: String,
    doc: Vec<String>,
    unit: String,
    range: String,
    value: String,
    /// Marks: one a line.
    lines: Vec<String>,
}

pub(super) fn assemble(
    composition: &Composition,
    storage: &[Storage],
    used: &[usize],
    interface: &Interface,
    templates: &Templates,
) -> Result<(String, SourceMap), Error> {
    let mut inserts = Vec::new();
    let context = context(composition, storage, used, interface, &mut inserts);
    assemble_of(composition, storage, templates, context, &inserts)
}

/// The result taken apart: what stands before the parts, and the text of each part.
pub(crate) fn apart(baked: &Baked, templates: &Templates) -> Result<(String, Vec<String>), Error> {
    let Baked { composition, storage, interface, .. } = baked;
    let used: Vec<_> =
        (0..composition.parameters.len()).filter(|index| composition.parameters[*index].read).collect();
    let mut inserts = Vec::new();
    let mut context = context(composition, storage, &used, interface, &mut inserts);
    context.modules.clear();
    context.directives.clear();
    let (head, _) = assemble_of(composition, storage, templates, context, &inserts)?;
    let parts = composition.parts.iter().map(|part| {
        let (text, map) = (String::new(), SourceMap::default());
        let mut writer = Writer { composition, storage, text, map };
        writer.part(part);
        writer.text
    });
    Ok((head, parts.collect()))
}

fn assemble_of(
    composition: &Composition,
    storage: &[Storage],
    templates: &Templates,
    mut context: Context,
    inserts: &[Insert<'_>],
) -> Result<(String, SourceMap), Error> {
    context.header = template::render(templates, "header.jinja", &context.facts)?.trim_end().to_owned();
    let rendered = template::render(templates, "wgsl.jinja", context)?;
    let size: usize = inserts.iter().map(size).sum();
    let mut writer = Writer {
        composition,
        storage,
        text: String::with_capacity(rendered.len() + size),
        map: SourceMap::default(),
    };
    let mut rest = rendered.as_str();
    while let Some(at) = rest.find(MARKS.0) {
        writer.glue(&rest[..at]);
        rest = &rest[at + MARKS.0.len_utf8()..];
        let Some((number, after)) = rest.split_once(MARKS.1) else { break };
        match number.parse::<usize>().ok().and_then(|index| inserts.get(index)) {
            Some(Insert::Part(part)) => writer.part(part),
            Some(Insert::Line { text, file, from }) => writer.made(text, *file, *from, None),
            None => {}
        }
        rest = after;
    }
    writer.glue(rest);
    Ok((writer.text, writer.map))
}

fn size(insert: &Insert<'_>) -> usize {
    match insert {
        Insert::Line { text, .. } => text.len(),
        Insert::Part(part) => part
            .pieces
            .iter()
            .map(|piece| match piece {
                Piece::Copy(span) => span.len(),
                Piece::Word(word, _) => word.len(),
                Piece::Read(..) => 32,
            })
            .sum(),
    }
}

struct Writer<'a> {
    composition: &'a Composition,
    storage: &'a [Storage],
    text: String,
    map: SourceMap,
}

impl Writer<'_> {
    fn part(&mut self, part: &crate::compose::Part) {
        let (file, instance) = (part.file, Some(part.instance as u32));
        let source = self.composition.files.get(file).text.clone();
        for piece in &part.pieces {
            match piece {
                Piece::Copy(span) => {
                    let surplus = self.surplus(&source[span.range()]);
                    let from = Span { start: span.start + surplus as u32, end: span.end };
                    let start = self.text.len();
                    self.text.push_str(&source[from.range()]);
                    let out = Span::new(start, self.text.len());
                    self.map.push(Segment { out, file, from, copied: true, instance });
                }
                Piece::Word(word, span) => self.made(word, file, *span, instance),
                Piece::Read(knob, span) => {
                    let text = read(self.composition, self.storage, *knob);
                    self.made(&text, file, *span, instance);
                }
            }
        }
    }

    /// Text of the template's own.
    fn glue(&mut self, text: &str) {
        for line in text.split_inclusive('\n') {
            self.text.push_str(&line[self.surplus(line)..]);
        }
    }

    /// How many line breaks at the start of `text` would leave two empty lines in a row where pieces meet.
    fn surplus(&self, text: &str) -> usize {
        if !self.text.ends_with("\n\n") {
            return 0;
        }
        text.bytes().take_while(|byte| *byte == b'\n').count()
    }

    /// Text that stands for `from`.
    fn made(&mut self, text: &str, file: FileId, from: Span, instance: Option<u32>) {
        let start = self.text.len();
        self.text.push_str(text);
        let out = Span::new(start, self.text.len());
        self.map.push(Segment { out, file, from, copied: false, instance });
    }
}

/// How the code reads a parameter or an option.
pub(crate) fn read(composition: &Composition, storage: &[Storage], knob: Knob) -> String {
    let index = match knob {
        Knob::Option(index) => return composition.flat(&composition.options[index].decl.key),
        Knob::Parameter(index) => index,
    };
    let decl = &composition.parameters[index].decl;
    let flat = composition.flat(&decl.key);
    let uniform = || composition.prefix.before(UNIFORM.0);
    match (storage[index], decl.ty) {
        (Storage::Uniform, Type::Bool) => format!("({}.{flat} != 0u)", uniform()),
        (Storage::Uniform, _) => format!("{}.{flat}", uniform()),
        (Storage::Override, ty) if ty.components() > 1 => {
            let parts: Vec<_> = suffixes(ty).iter().map(|suffix| format!("{flat}{suffix}")).collect();
            format!("{ty}({})", parts.join(", "))
        }
        _ => flat,
    }
}

fn context<'a>(
    composition: &'a Composition,
    storage: &[Storage],
    used: &[usize],
    interface: &Interface,
    inserts: &mut Vec<Insert<'a>>,
) -> Context {
    let mut groups: Vec<Group> = Vec::new();
    let mut fields = Vec::new();
    let layout = interface.uniform.as_ref();
    let mut pads = 0;
    for index in &by_group(composition, storage, used) {
        let parameter = &composition.parameters[*index];
        let flat = composition.flat(&parameter.decl.key);
        let item = parameter_item(parameter, &flat, storage[*index], inserts);
        if storage[*index] == Storage::Uniform {
            let at = layout.and_then(|uniform| uniform.fields.get(fields.len() - pads));
            let last = layout.and_then(|uniform| uniform.fields.get((fields.len() - pads).checked_sub(1)?));
            if let (Some(last), Some(at)) = (last, at) {
                let end = last.offset + last.size;
                let starts = layout.is_some_and(|u| u.groups.iter().any(|group| group.offset == at.offset));
                for ty in padding(end, if starts { at.offset } else { end }) {
                    fields.push(Item { lines: vec![format!("_pad{pads}: {ty},")], ..Item::default() });
                    pads += 1;
                }
            }
            fields.push(item);
        } else {
            let key = &parameter.decl.key.group;
            let is_live = storage[*index] == Storage::Variable && key != "frame";
            group(&mut groups, if is_live { LIVE } else { key }).items.push(item);
        }
    }
    // What a person may change by hand comes first.
    groups.sort_by_key(|group| group.name != LIVE);
    let read = composition.options.iter().filter(|option| option.read);
    for option in read {
        let key = &option.decl.key;
        let value = option.decl.show(option.value);
        let ty = if matches!(option.value, OptionValue::Bool(_)) { "bool" } else { "i32" };
        let text = format!("const {}: {ty} = {value};", composition.flat(key));
        let item = Item {
            name: key.to_string(),
            doc: lines(&option.decl.doc),
            value,
            lines: vec![mark(inserts, Insert::Line { text, file: option.at.0, from: option.at.1 })],
            ..Item::default()
        };
        group(&mut groups, &key.group).items.push(item);
    }
    let uniform = interface.uniform.as_ref().map(|uniform| UniformBlock {
        group: uniform.group,
        binding: uniform.binding,
        name: uniform.name.clone(),
        ty: composition.prefix.before(UNIFORM.1),
        fields,
    });
    let modules = composition.parts.iter().map(|part| Item {
        name: clean(&part.name),
        lines: vec![mark(inserts, Insert::Part(part))],
        ..Item::default()
    });
    let modules = modules.collect();
    Context {
        header: String::new(),
        facts: Facts::of(composition),
        directives: composition
            .hoisted
            .iter()
            .map(|directive| {
                let text = directive_text(directive);
                mark(inserts, Insert::Line { text, file: directive.file, from: directive.span })
            })
            .collect(),
        groups,
        uniform,
        slots: composition.slots.iter().map(|slot| slot_item(composition, slot, inserts)).collect(),
        modules,
    }
}

fn group<'a>(groups: &'a mut Vec<Group>, name: &str) -> &'a mut Group {
    let at = groups.iter().position(|group| group.name == name).unwrap_or_else(|| {
        groups.push(Group { name: name.to_owned(), items: Vec::new() });
        groups.len() - 1
    });
    &mut groups[at]
}

fn parameter_item(
    parameter: &Parameter,
    flat: &str,
    storage: Storage,
    inserts: &mut Vec<Insert<'_>>,
) -> Item {
    let decl = &parameter.decl;
    let ty = decl.ty;
    let value = in_code(&parameter.value, decl.unit.as_deref());
    let texts = match storage {
        Storage::Const => vec![format!("const {flat}: {ty} = {};", literal(&value))],
        Storage::Variable => vec![format!("var<private> {flat}: {ty} = {};", literal(&value))],
        Storage::Uniform => vec![format!("{flat}: {},", uniform_type(ty))],
        Storage::Override => {
            let parts = scalars(&value);
            let parts = suffixes(ty).iter().zip(&parts);
            parts
                .map(|(suffix, scalar)| {
                    format!("override {flat}{suffix}: {} = {};", ty.scalar(), literal(scalar))
                })
                .collect()
        }
    };
    let line = |text| mark(inserts, Insert::Line { text, file: parameter.at.0, from: parameter.at.1 });
    let unit = decl.unit.clone().unwrap_or_default();
    Item {
        name: decl.key.to_string(),
        doc: lines(&decl.doc),
        range: decl.range.map_or(String::new(), |(low, high)| format!("{low} .. {high}")),
        value: literal(&parameter.value),
        lines: texts.into_iter().map(line).collect(),
        unit: clean(&unit),
    }
}

fn slot_item(composition: &Composition, open: &OpenSlot, inserts: &mut Vec<Insert<'_>>) -> Item {
    let signature = &open.slot.signature;
    let takes: Vec<_> = signature.takes.iter().enumerate().map(|(n, ty)| format!("a{n}: {ty}")).collect();
    let gives = signature.gives.as_ref();
    let name = composition.prefix.before(&open.slot.name.value);
    let head = format!("fn {name}({})", takes.join(", "));
    let text = match gives {
        Some(ty) => format!("{head} -> {ty} {{ return {ty}(); }}"),
        None => format!("{head} {{}}"),
    };
    Item {
        name: clean(&open.slot.name.value),
        doc: lines(&open.slot.doc),
        lines: vec![mark(inserts, Insert::Line { text, file: open.at.0, from: open.at.1 })],
        ..Item::default()
    }
}

pub(crate) fn directive_text(directive: &Hoisted) -> String {
    let keyword = match directive.kind {
        DeclarationKind::Enable => "enable ",
        DeclarationKind::Requires => "requires ",
        _ => "diagnostic",
    };
    format!("{keyword}{};", directive.body)
}

fn mark<'a>(inserts: &mut Vec<Insert<'a>>, insert: Insert<'a>) -> String {
    inserts.push(insert);
    let mut mark = String::new();
    let _ = write!(mark, "{}{}{}", MARKS.0, inserts.len() - 1, MARKS.1); // writing to a String cannot fail
    mark
}

/// Text from outside on one line, without marks: it ends up in comments of the result.
pub(crate) fn clean(text: &str) -> String {
    text.chars()
        .filter(|c| *c != MARKS.0 && *c != MARKS.1)
        .map(|c| if crate::syntax::is_line_break(c) || c.is_control() { ' ' } else { c })
        .collect()
}

fn lines(doc: &str) -> Vec<String> {
    doc.lines().map(clean).collect()
}
