//! Interactive Shader Format: live parameters → inputs, and the JSON header that tells of them (ISF 2.0).

use serde_json::{Value as Json, json};

use crate::bake::Storage;
use crate::compose::Parameter;
use crate::shader::Shader;
use crate::syntax::{Type, Value};

/// A live parameter as a host offers it.
pub(super) struct Input {
    /// The variable that it stands for.
    pub(super) variable: String,
    /// The names of its inputs: of a vector that is neither a colour nor a point, one each component.
    pub(super) names: Vec<String>,
    /// What reads it.
    pub(super) read: String,
    /// How the header tells of it, one an input.
    told: Vec<Json>,
}

/// The inputs of `shader`, in the order of its parameters.
pub(super) fn inputs(shader: &Shader) -> Vec<Input> {
    let baked = &shader.checked().baked;
    let all = baked.composition.parameters.iter().zip(&baked.storage);
    let live = all.filter(|(parameter, storage)| {
        **storage == Storage::Variable && parameter.read && parameter.decl.key.group != "frame"
    });
    live.map(|(parameter, _)| input(&baked.composition.flat(&parameter.decl.key), parameter)).collect()
}

fn input(name: &str, parameter: &Parameter) -> Input {
    let decl = &parameter.decl;
    let is_angle = decl.unit.as_deref() == Some("deg");
    let label = label(parameter);
    let range = |json: &mut Json, n: usize| {
        let Some((low, high)) = decl.range else { return };
        json["MIN"] = if n == 1 { json!(low) } else { json!(vec![low; n]) };
        json["MAX"] = if n == 1 { json!(high) } else { json!(vec![high; n]) };
    };
    let floats = parameter.value.floats();
    let exact = |value: f32| value.to_string().parse::<f64>().unwrap_or_else(|_| f64::from(value));
    let one = |ty: &str, read: String, default: Json, ranged: usize| {
        let mut told = json!({ "NAME": name, "LABEL": label, "TYPE": ty, "DEFAULT": default });
        if ranged > 0 {
            range(&mut told, ranged);
        }
        Input { variable: name.to_owned(), names: vec![name.to_owned()], read, told: vec![told] }
    };
    match (decl.ty, &parameter.value) {
        (Type::Bool, Value::Bool(value)) => one("bool", name.to_owned(), json!(value), 0),
        (Type::I32, Value::I32(value)) => one("long", name.to_owned(), json!(value), 1),
        (Type::U32, Value::U32(value)) => one("long", format!("uint({name})"), json!(value), 1),
        (Type::F32, _) => {
            let read = if is_angle { format!("radians({name})") } else { name.to_owned() };
            one("float", read, json!(floats.first().copied().map(exact)), 1)
        }
        (Type::Vec3f | Type::Vec4f, _) if decl.color => {
            let mut default: Vec<f64> = floats.iter().copied().map(exact).collect();
            default.resize(4, 1.0);
            let read = if decl.ty == Type::Vec3f { format!("{name}.rgb") } else { name.to_owned() };
            one("color", read, json!(default), 0)
        }
        (Type::Vec2f, _) if !is_angle => {
            one("point2D", name.to_owned(), json!(floats.iter().copied().map(exact).collect::<Vec<_>>()), 2)
        }
        _ => {
            let names: Vec<String> =
                ["x", "y", "z", "w"].iter().take(floats.len()).map(|part| format!("{name}_{part}")).collect();
            let told = names.iter().zip(floats).map(|(part, value)| {
                let letter = part.rsplit('_').next().unwrap_or_default();
                let label = format!("{label}, {letter}");
                let mut told =
                    json!({ "NAME": part, "LABEL": label, "TYPE": "float", "DEFAULT": exact(*value) });
                range(&mut told, 1);
                told
            });
            let told = told.collect();
            let read = format!("vec{}({})", floats.len(), names.join(", "));
            let read = if is_angle { format!("radians({read})") } else { read };
            Input { variable: name.to_owned(), names, read, told }
        }
    }
}

/// What it is, in a few words, with its unit.
fn label(parameter: &Parameter) -> String {
    let decl = &parameter.decl;
    let sentence = decl.doc.split(['.', '\n', ';']).next().unwrap_or_default().trim();
    let what = if sentence.is_empty() { decl.key.to_string() } else { sentence.to_owned() };
    match &decl.unit {
        Some(unit) => format!("{what} ({unit})"),
        None => what,
    }
}

/// The header, with the inputs that are read.
pub(super) fn json(shader: &Shader, read: &[String]) -> String {
    let composition = &shader.checked().baked.composition;
    let told: Vec<Json> = inputs(shader)
        .into_iter()
        .filter(|input| read.contains(&input.read))
        .flat_map(|input| input.told)
        .collect();
    let header = json!({
        "DESCRIPTION": if composition.about.is_empty() { &composition.name } else { &composition.about },
        "CREDIT": format!("Composed by Orogen {}", env!("CARGO_PKG_VERSION")),
        "ISFVSN": "2.0",
        "CATEGORIES": ["Generator"],
        "INPUTS": told,
    });
    // It stands in a comment; JSON lets a slash be escaped.
    format!("{header:#}").replace("*/", "*\\/")
}
