//! What a scene offers to be set, for people and for programs: table, Markdown, JSON.

use std::fmt::Write;

use serde_json::Value as Plain;

use super::settle::{Declarations, Settings};
use crate::ordered::Json;
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
        Json::object([
            ("name", decl.key.to_string().into()),
            ("type", decl.ty.name().into()),
            ("default", value_json(&decl.default).into()),
            ("value", value_json(value).into()),
            ("range", decl.range.map(|(low, high)| vec![low, high]).into()),
            ("unit", decl.unit.clone().into()),
            ("color", decl.color.into()),
            ("log", decl.log.into()),
            ("live", decl.live.into()),
            ("doc", sentence(&decl.doc).into()),
        ])
    });
    let options = declarations.options.iter().zip(&settings.options).map(|(o, value)| {
        let decl = &o.decl;
        let mut object = Json::object([
            ("name", decl.key.to_string().into()),
            ("default", option_json(decl, decl.default).into()),
            ("value", option_json(decl, *value).into()),
            ("doc", sentence(&decl.doc).into()),
        ]);
        match &decl.kind {
            OptionKind::Choice(names) => object.set("choices", names.clone()),
            OptionKind::Bool => object.set("choices", vec![true, false]),
            OptionKind::Integer(limits) => object.set("range", limits.map(|(low, high)| vec![low, high])),
        }
        object
    });
    let (parameters, options) = (parameters.collect(), options.collect());
    Json::object([("parameters", Json::List(parameters)), ("options", Json::List(options))]).pretty()
}

/// A value as a preset writes it.
pub fn value_json(value: &Value) -> Plain {
    let float = |value: &f32| serde_json::from_str(&format!("{value:?}")).unwrap_or(Plain::Null); // f32's own digits
    match value {
        Value::Bool(value) => (*value).into(),
        Value::I32(value) => (*value).into(),
        Value::U32(value) => (*value).into(),
        Value::F32(value) => float(value),
        vector => vector.floats().iter().map(float).collect(),
    }
}

/// An option's value as a preset writes it.
pub fn option_json(decl: &OptionDecl, value: OptionValue) -> Plain {
    match value {
        OptionValue::Bool(on) => on.into(),
        OptionValue::Integer(n) => n.into(),
        OptionValue::Choice(_) => decl.show(value).into(),
    }
}

/// A JSON Schema (draft 2020-12) of the presets of a scene: for editors, and for checking presets without Orogen.
pub fn schema(declarations: &Declarations, scene: &str) -> String {
    let mut groups = Json::object([]);
    let mut put = |group: &str, name: &str, schema: Json| {
        if group.is_empty() {
            groups.set(name, schema);
        } else if let Some(entry) = groups.entry(group) {
            if *entry == Json::object([]) {
                *entry = Json::object([("type", "object".into()), ("additionalProperties", false.into())]);
            }
            if let Some(properties) = entry.entry("properties") {
                properties.set(name, schema);
            }
        }
    };
    for parameter in &declarations.parameters {
        let key = &parameter.decl.key;
        put(&key.group, &key.name, parameter_schema(&parameter.decl));
    }
    for option in &declarations.options {
        let key = &option.decl.key;
        put(&key.group, &key.name, option_schema(&option.decl));
    }
    let text =
        |description: &str| Json::object([("description", description.into()), ("type", "string".into())]);
    let version =
        Json::object([("description", "Version of the preset format.".into()), ("const", 1.into())]);
    let set = Json::object([
        ("type", "object".into()),
        ("additionalProperties", false.into()),
        ("properties", groups),
    ]);
    let properties = Json::object([
        ("$schema", Json::object([("type", "string".into())])),
        ("orogen", version),
        ("about", text("One line about the preset.")),
        (
            "extends",
            text(
                "A built-in preset, or a .json file beside this one, whose values hold where this one sets none.",
            ),
        ),
        ("scene", text("The fragment that is the scene.")),
        ("set", set),
    ]);
    let schema = Json::object([
        ("$schema", "https://json-schema.org/draft/2020-12/schema".into()),
        ("title", format!("Orogen preset for {scene}").into()),
        ("type", "object".into()),
        ("required", vec!["orogen"].into()),
        ("additionalProperties", false.into()),
        ("properties", properties),
    ]);
    schema.pretty()
}

fn parameter_schema(decl: &ParamDecl) -> Json {
    use crate::syntax::Type as T;
    let (low, high) = match decl.ty {
        T::I32 => (f64::from(i32::MIN), f64::from(i32::MAX)),
        T::U32 => (0.0, f64::from(u32::MAX)),
        _ => (f64::from(f32::MIN), f64::from(f32::MAX)),
    };
    let (low, high) = decl.range.map_or((low, high), |(a, b)| (a.max(low), b.min(high)));
    let number = Json::object([
        ("minimum", low.into()),
        ("maximum", high.into()),
        ("type", if matches!(decl.ty, T::I32 | T::U32) { "integer" } else { "number" }.into()),
    ]);
    let mut schema = match decl.ty {
        T::Bool => Json::object([("type", "boolean".into())]),
        T::I32 | T::U32 | T::F32 => number,
        vector => {
            let n = vector.components();
            Json::object([
                ("type", "array".into()),
                ("items", number),
                ("minItems", n.into()),
                ("maxItems", n.into()),
            ])
        }
    };
    if decl.color {
        let digits = if decl.ty == T::Vec4f {
            "^#([0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})$"
        } else {
            "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"
        };
        let written = Json::object([("type", "string".into()), ("pattern", digits.into())]);
        schema = Json::object([("anyOf", Json::List(vec![schema, written]))]);
    }
    describe(&mut schema, &decl.doc, decl.unit.as_deref());
    schema.set("default", value_json(&decl.default));
    schema
}

fn option_schema(decl: &OptionDecl) -> Json {
    let mut schema = match &decl.kind {
        OptionKind::Choice(names) => Json::object([("enum", names.clone().into())]),
        OptionKind::Bool => Json::object([("type", "boolean".into())]),
        OptionKind::Integer(limits) => {
            let (low, high) = limits.unwrap_or((i64::from(i32::MIN), i64::from(i32::MAX)));
            Json::object([("type", "integer".into()), ("minimum", low.into()), ("maximum", high.into())])
        }
    };
    describe(&mut schema, &decl.doc, None);
    schema.set("default", option_json(decl, decl.default));
    schema
}

fn describe(schema: &mut Json, doc: &str, unit: Option<&str>) {
    let unit = unit.map_or(String::new(), |unit| format!(" ({unit})"));
    let text = sentence(doc) + &unit;
    if !text.trim().is_empty() {
        schema.set("description", text.trim());
    }
}
