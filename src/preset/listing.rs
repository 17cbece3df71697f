//! What a scene offers to be set, for people and for programs: table, Markdown, JSON.

use std::fmt::Write;

use serde_json::{Map, Value as Json, json};

use super::settle::{Declarations, Settings};
use crate::syntax::{OptionDecl, OptionKind, OptionValue, ParamDecl, Value};

/// A parameter or an option, in words.
struct Row {
    key: String,
    kind: String,
    value: String,
    range: String,
    doc: String,
}

fn rows(declarations: &Declarations, settings: &Settings) -> Vec<Row> {
    let parameters = declarations.parameters.iter().zip(&settings.parameters).map(|(p, value)| Row {
        key: p.decl.key.to_string(),
        kind: kind(&p.decl),
        value: show(value),
        range: range(&p.decl),
        doc: sentence(&p.decl.doc),
    });
    let options = declarations.options.iter().zip(&settings.options).map(|(o, value)| Row {
        key: o.decl.key.to_string(),
        kind: "option".into(),
        value: o.decl.show(*value),
        range: o.decl.possible(),
        doc: sentence(&o.decl.doc),
    });
    let mut rows: Vec<_> = parameters.chain(options).collect();
    rows.sort_by(|a, b| a.key.cmp(&b.key));
    rows
}

fn kind(decl: &ParamDecl) -> String {
    if decl.color { format!("{} colour", decl.ty) } else { decl.ty.to_string() }
}

fn range(decl: &ParamDecl) -> String {
    let unit = decl.unit.as_deref().unwrap_or("");
    match decl.range {
        Some((low, high)) => format!("{low} .. {high} {unit}").trim_end().to_owned(),
        None => unit.to_owned(),
    }
}

/// The doc comment on one line.
fn sentence(doc: &str) -> String {
    doc.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn show(value: &Value) -> String {
    match value {
        Value::Bool(value) => value.to_string(),
        Value::I32(value) => value.to_string(),
        Value::U32(value) => value.to_string(),
        floats => {
            let parts: Vec<_> = floats.floats().iter().map(f32::to_string).collect();
            if let [only] = parts.as_slice() { only.clone() } else { format!("[{}]", parts.join(", ")) }
        }
    }
}

/// Columns aligned for a terminal, one name a line: key, type, value, range, what it is.
pub fn table(declarations: &Declarations, settings: &Settings) -> String {
    let rows = rows(declarations, settings);
    let width =
        |column: fn(&Row) -> &str| rows.iter().map(|row| column(row).chars().count()).max().unwrap_or(0);
    let widths = [width(|r| &r.key), width(|r| &r.kind), width(|r| &r.value), width(|r| &r.range)];
    let mut text = String::new();
    for row in &rows {
        let cells = [&row.key, &row.kind, &row.value, &row.range];
        for (cell, width) in cells.iter().zip(widths) {
            let _ = write!(text, "{cell:<width$}  "); // writing to a String cannot fail
        }
        text.push_str(&row.doc);
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

/// A Markdown table, one name a row.
pub fn markdown(declarations: &Declarations, settings: &Settings) -> String {
    let mut text =
        String::from("| name | type | value | range | what it is |\n| --- | --- | --- | --- | --- |\n");
    let cell = |text: &str| text.replace('|', "\\|");
    for row in rows(declarations, settings) {
        let Row { key, kind, value, range, doc } = row;
        let _ = writeln!(text, "| `{key}` | {kind} | `{value}` | {} | {} |", cell(&range), cell(&doc));
    }
    text
}

/// `{"parameters": […], "options": […]}`, with everything that the declarations say.
pub fn json(declarations: &Declarations, settings: &Settings) -> String {
    let parameters = declarations.parameters.iter().zip(&settings.parameters).map(|(p, value)| {
        let decl = &p.decl;
        json!({
            "name": decl.key.to_string(),
            "type": decl.ty.name(),
            "default": value_json(&decl.default),
            "value": value_json(value),
            "range": decl.range.map(|(low, high)| [low, high]),
            "unit": decl.unit,
            "color": decl.color,
            "log": decl.log,
            "live": decl.live,
            "doc": sentence(&decl.doc),
        })
    });
    let options = declarations.options.iter().zip(&settings.options).map(|(o, value)| {
        let decl = &o.decl;
        let mut object = json!({
            "name": decl.key.to_string(),
            "default": option_json(decl, decl.default),
            "value": option_json(decl, *value),
            "doc": sentence(&decl.doc),
        });
        match &decl.kind {
            OptionKind::Choice(names) => object["choices"] = json!(names),
            OptionKind::Bool => object["choices"] = json!([true, false]),
            OptionKind::Integer(limits) => object["range"] = json!(limits.map(|(low, high)| [low, high])),
        }
        object
    });
    let all = json!({ "parameters": parameters.collect::<Vec<_>>(), "options": options.collect::<Vec<_>>() });
    pretty(&all)
}

/// A value as a preset writes it.
pub fn value_json(value: &Value) -> Json {
    let float = |value: &f32| serde_json::from_str(&format!("{value:?}")).unwrap_or(Json::Null); // f32's own digits
    match value {
        Value::Bool(value) => json!(value),
        Value::I32(value) => json!(value),
        Value::U32(value) => json!(value),
        Value::F32(value) => float(value),
        vector => vector.floats().iter().map(float).collect(),
    }
}

/// An option's value as a preset writes it.
pub fn option_json(decl: &OptionDecl, value: OptionValue) -> Json {
    match value {
        OptionValue::Bool(on) => json!(on),
        OptionValue::Integer(n) => json!(n),
        OptionValue::Choice(_) => json!(decl.show(value)),
    }
}

/// A JSON Schema (draft 2020-12) of the presets of a scene: for editors, and for checking presets without Orogen.
pub fn schema(declarations: &Declarations, scene: &str) -> String {
    let mut groups: Map<String, Json> = Map::new();
    let mut put = |group: &str, name: &str, schema: Json| {
        if group.is_empty() {
            groups.insert(name.to_owned(), schema);
            return;
        }
        let entry = groups
            .entry(group)
            .or_insert_with(|| json!({ "type": "object", "additionalProperties": false, "properties": {} }));
        entry["properties"][name] = schema;
    };
    for parameter in &declarations.parameters {
        let key = &parameter.decl.key;
        put(&key.group, &key.name, parameter_schema(&parameter.decl));
    }
    for option in &declarations.options {
        let key = &option.decl.key;
        put(&key.group, &key.name, option_schema(&option.decl));
    }
    let schema = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": format!("Orogen preset for {scene}"),
        "type": "object",
        "required": ["orogen"],
        "additionalProperties": false,
        "properties": {
            "$schema": { "type": "string" },
            "orogen": { "description": "Version of the preset format.", "const": 1 },
            "about": { "description": "One line about the preset.", "type": "string" },
            "extends": {
                "description": "A built-in preset, or a .json file beside this one, whose values hold where this one sets none.",
                "type": "string",
            },
            "scene": { "description": "The fragment that is the scene.", "type": "string" },
            "set": { "type": "object", "additionalProperties": false, "properties": groups },
        },
    });
    pretty(&schema)
}

fn parameter_schema(decl: &ParamDecl) -> Json {
    use crate::syntax::Type as T;
    let limits = |low: f64, high: f64| json!({ "minimum": low, "maximum": high });
    let (low, high) = match decl.ty {
        T::I32 => (f64::from(i32::MIN), f64::from(i32::MAX)),
        T::U32 => (0.0, f64::from(u32::MAX)),
        _ => (f64::from(f32::MIN), f64::from(f32::MAX)),
    };
    let (low, high) = decl.range.map_or((low, high), |(a, b)| (a.max(low), b.min(high)));
    let mut number = limits(low, high);
    number["type"] = json!(if matches!(decl.ty, T::I32 | T::U32) { "integer" } else { "number" });
    let mut schema = match decl.ty {
        T::Bool => json!({ "type": "boolean" }),
        T::I32 | T::U32 | T::F32 => number,
        vector => {
            let n = vector.components();
            json!({ "type": "array", "items": number, "minItems": n, "maxItems": n })
        }
    };
    if decl.color {
        let digits = if decl.ty == T::Vec4f {
            "^#([0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})$"
        } else {
            "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"
        };
        schema = json!({ "anyOf": [schema, { "type": "string", "pattern": digits }] });
    }
    describe(&mut schema, &decl.doc, decl.unit.as_deref());
    schema["default"] = value_json(&decl.default);
    schema
}

fn option_schema(decl: &OptionDecl) -> Json {
    let mut schema = match &decl.kind {
        OptionKind::Choice(names) => json!({ "enum": names }),
        OptionKind::Bool => json!({ "type": "boolean" }),
        OptionKind::Integer(limits) => {
            let (low, high) = limits.unwrap_or((i64::from(i32::MIN), i64::from(i32::MAX)));
            json!({ "type": "integer", "minimum": low, "maximum": high })
        }
    };
    describe(&mut schema, &decl.doc, None);
    schema["default"] = option_json(decl, decl.default);
    schema
}

fn describe(schema: &mut Json, doc: &str, unit: Option<&str>) {
    let unit = unit.map_or(String::new(), |unit| format!(" ({unit})"));
    let text = sentence(doc) + &unit;
    if !text.trim().is_empty() {
        schema["description"] = json!(text.trim());
    }
}

fn pretty(value: &Json) -> String {
    serde_json::to_string_pretty(value).unwrap_or_default() + "\n" // maps with string keys always serialise
}
