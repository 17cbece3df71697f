//! The interface of a shader as JSON: [`Shader`] → everything that a host may want to know.

use serde::Serialize;
use serde_json::Value as Plain;

use crate::bake::{Interface, Storage};
use crate::compose::Parameter;
use crate::ordered::Json;
use crate::preset::listing::{option_json, value_json};
use crate::shader::Shader;

#[derive(Serialize)]
struct Document<'a> {
    /// Orogen's version.
    orogen: &'static str,
    name: &'a str,
    about: &'a str,
    /// In force, by key.
    options: Json,
    parameters: Vec<Entry<'a>>,
    #[serde(flatten)]
    interface: &'a Interface,
}

/// A parameter, its value in the declared unit.
#[derive(Serialize)]
struct Entry<'a> {
    key: String,
    #[serde(rename = "type")]
    ty: &'static str,
    storage: &'static str,
    /// Whether the code reads it.
    read: bool,
    value: Plain,
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    range: Option<(f64, f64)>,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    color: bool,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    log: bool,
    doc: &'a str,
}

pub(super) fn interface(shader: &Shader) -> String {
    let baked = shader.baked();
    let composition = &baked.composition;
    let parameters = composition.parameters.iter().zip(&baked.storage);
    let options = composition.options.iter();
    let options = options.map(|one| (one.decl.key.to_string(), option_json(&one.decl, one.value).into()));
    let document = Document {
        orogen: env!("CARGO_PKG_VERSION"),
        name: &composition.name,
        about: &composition.about,
        options: Json::Object(options.collect()),
        parameters: parameters.map(|(parameter, storage)| entry(parameter, *storage)).collect(),
        interface: shader.interface(),
    };
    // Strings and numbers only: nothing in it can fail to be written.
    serde_json::to_string_pretty(&document).unwrap_or_default() + "\n"
}

fn entry(parameter: &Parameter, storage: Storage) -> Entry<'_> {
    let decl = &parameter.decl;
    Entry {
        key: decl.key.to_string(),
        ty: decl.ty.name(),
        storage: match storage {
            Storage::Const => "const",
            Storage::Override => "override",
            Storage::Uniform => "uniform",
            Storage::Variable => "variable",
        },
        read: parameter.read,
        value: value_json(&parameter.value),
        unit: decl.unit.as_deref(),
        range: decl.range,
        color: decl.color,
        log: decl.log,
        doc: &decl.doc,
    }
}
