//! The whole library as a WESL package: [`Library`] → [`Package`], its options as features.

use std::fmt::Write;

use super::imports::{self, names, with_imports};
use super::paths::{Paths, relative};
use super::{About, MAIN, PARAMETERS, Package, finished, module_path};
use crate::bake::{Bake, Baked, apart, bake, clean, read};
use crate::compose::Choice;
use crate::compose::open::{Choices, Formula, Open, OpenModule, OpenPiece, open};
use crate::diagnostic::{Diagnostic, Error};
use crate::export::{Stage, entry_point};
use crate::preset::{Preset, settle};
use crate::source::{Library, Templates};
use crate::syntax::{OptionDecl, OptionKind, Slot};
use crate::template;

/// What the whole library's package is made with.
#[derive(Debug, Clone, Default)]
pub struct LibraryStyle {
    /// The preset whose values parameters and options have where nothing else is said, and whose scene the module `main`
    /// draws; without one, what the fragments declare, and no `main`.
    pub preset: Option<Preset>,
    /// Which entry point `main` has.
    pub stage: Stage,
    /// Which parameters stay live, and where their buffer is bound.
    pub bake: Bake,
}

/// A package of everything that `library` has. Options are features.
///
/// # Errors
/// Everything that is wrong with any fragment but what only a WGSL compiler can tell; a condition that stands in the middle of a
/// declaration or a statement (`OR0418`); a template that cannot be rendered.
pub fn library_package(
    library: &Library,
    style: &LibraryStyle,
    templates: &Templates,
) -> Result<Package, Error> {
    let wrapper = match &style.preset {
        Some(_) => Some(entry_point(style.stage, templates)?),
        None => None,
    };
    let preset = style.preset.clone().unwrap_or_else(|| Preset::of_module(""));
    let Open { mut composition, choices, read: is_read, decides, modules, .. } =
        open(library, &preset, wrapper)?;
    if style.preset.is_none() {
        composition.name = "Orogen's library".into();
    }
    let baked = bake(composition, &style.bake, templates)?;
    let composition = &baked.composition;
    let (mut text, _) = apart(&baked, templates)?;
    for (index, option) in composition.options.iter().enumerate() {
        if is_read[index] && !option.read {
            text.push_str(&constants(&option.decl, index, &choices));
        }
    }
    let mut paths = Paths::default();
    let parameters = Place { path: paths.take(&[PARAMETERS]), declared: names(&text).declared };
    let at: Vec<_> = composition.parts.iter().map(|part| module_path(&mut paths, part)).collect();
    let mut files = vec![(format!("{PARAMETERS}.wesl"), with_imports(&text, &[]))];
    for (module, path) in modules.iter().zip(&at) {
        let text = text_of(module, &baked, &choices);
        let lines = import_lines(module, path, &at, &choices, &text, &parameters);
        files.push((format!("{}.wesl", path.join("/")), with_imports(&text, &lines)));
    }
    let root = if style.preset.is_some() { MAIN.to_owned() } else { String::new() };
    let options = composition.options.iter().enumerate();
    let generic = modules.iter().zip(&at).filter(|(module, _)| !module.slots.is_empty());
    let readme = Readme {
        about: About::of(&baked, &root),
        options: options
            .filter(|(index, _)| decides[*index] || is_read[*index])
            .map(|(index, option)| Feature::of(option, index, &choices))
            .collect(),
        generic: generic.map(|(module, path)| Generic::of(module, path)).collect(),
    };
    let readme = template::render(templates, "wesl_library_readme.jinja", readme)?;
    Ok(finished(files, root, readme))
}

/// The features with which the package that [`library_package`] makes in this style has the options of `preset`.
///
/// # Errors
/// As [`library_package`], and where `preset` does not fit what the library declares.
pub fn library_features(
    library: &Library,
    style: &LibraryStyle,
    preset: &Preset,
) -> Result<Vec<String>, Error> {
    let defaults = style.preset.clone().unwrap_or_else(|| Preset::of_module(""));
    let Open { declarations, choices, decides, read: is_read, .. } = open(library, &defaults, None)?;
    let settings = settle(preset, &declarations).map_err(|errors| {
        Error::new(errors.into_iter().map(Diagnostic::from).collect(), preset.files.clone())
    })?;
    let chosen = settings.options.iter().enumerate().filter(|(index, _)| decides[*index] || is_read[*index]);
    Ok(chosen.filter_map(|(index, value)| choices.feature(index, *value)).map(str::to_owned).collect())
}

/// A module by its path, and what it declares.
struct Place {
    path: Vec<String>,
    declared: Vec<String>,
}

/// The text of `module`, without imports.
fn text_of(module: &OpenModule, baked: &Baked, choices: &Choices) -> String {
    let mut text = String::new();
    for piece in &module.pieces {
        match piece {
            OpenPiece::Text(piece) => text.push_str(piece),
            OpenPiece::Read(knob) => text.push_str(&read(&baked.composition, &baked.storage, *knob)),
        }
    }
    let mut text = without_gaps(&text);
    for slot in &module.slots {
        text.push_str(&open_slot(slot));
    }
    for (slot, target, when) in &module.built_in {
        text.push_str(&calls_built_in(slot, target, &choices.wesl(when)));
    }
    text
}

/// Not more than one empty line in a row.
fn without_gaps(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut empty = 0;
    for line in text.split_inclusive('\n') {
        empty = if line.trim().is_empty() { empty + 1 } else { 0 };
        if empty < 2 {
            plain.push_str(line);
        }
    }
    plain.trim_end().to_owned() + "\n"
}

/// The imports of `module`, which lies at `path`; `text` is its text.
fn import_lines(
    module: &OpenModule,
    path: &[String],
    at: &[Vec<String>],
    choices: &Choices,
    text: &str,
    parameters: &Place,
) -> Vec<String> {
    let mut from: Vec<(usize, String, Vec<String>)> = Vec::new();
    for import in &module.imports {
        let name = match &import.alias {
            Some(alias) => format!("{} as {alias}", import.name),
            None => import.name.clone(),
        };
        let when = if import.when.is_always() { String::new() } else { choices.wesl(&import.when) };
        match from.iter_mut().find(|(owner, known, _)| *owner == import.module && *known == when) {
            Some((.., names)) if names.contains(&name) => {}
            Some((.., names)) => names.push(name),
            None => from.push((import.module, when, vec![name])),
        }
    }
    let line = |(owner, when, names): (usize, String, Vec<String>)| {
        let names = names.iter().map(String::as_str).collect();
        (imports::line(&relative(path, &at[owner]), names), when)
    };
    let mut lines: Vec<_> = from.into_iter().map(line).collect();
    let used = names(text).used;
    let knobs: Vec<_> =
        used.iter().filter(|name| parameters.declared.contains(name)).map(String::as_str).collect();
    if !knobs.is_empty() {
        lines.push((imports::line(&relative(path, &parameters.path), knobs), String::new()));
    }
    lines.sort();
    let conditional =
        |(line, when): (String, String)| if when.is_empty() { line } else { format!("@if({when}) {line}") };
    lines.into_iter().map(conditional).collect()
}

/// An option that code reads and features choose: a constant for each of its values.
fn constants(decl: &OptionDecl, index: usize, choices: &Choices) -> String {
    let domain = &choices.domains[index];
    let ty = if decl.kind == OptionKind::Bool { "bool" } else { "i32" };
    let mut text = String::from("\n");
    for line in decl.doc.lines() {
        let _ = writeln!(text, "/// {}", clean(line)); // writing to a String cannot fail
    }
    let flat = decl.key.flat();
    for (at, shown) in domain.shown.iter().enumerate() {
        let when = choices.wesl(&Formula::is(index, 1 << at, &choices.full));
        let _ = writeln!(text, "@if({when}) const {flat}: {ty} = {shown};");
    }
    text
}

/// A stand-in for what nobody fills.
fn open_slot(slot: &Slot) -> String {
    let body = slot.signature.gives.as_ref().map_or(String::new(), |ty| format!(" return {ty}(); "));
    format!(
        "\n/// A slot: put a function of your own here, or import one by this name.\n{} {{{body}}}\n",
        head(slot)
    )
}

/// A function of WGSL's own under the slot's name: it cannot be imported.
fn calls_built_in(slot: &Slot, target: &str, when: &str) -> String {
    let arguments: Vec<_> = (0..slot.signature.takes.len()).map(|n| format!("a{n}")).collect();
    let call = format!("{target}({})", arguments.join(", "));
    let body = if slot.signature.gives.is_some() { format!("return {call};") } else { format!("{call};") };
    format!("\n@if({when})\n{} {{ {body} }}\n", head(slot))
}

fn head(slot: &Slot) -> String {
    let takes = slot.signature.takes.iter().enumerate();
    let takes: Vec<_> = takes.map(|(n, ty)| format!("a{n}: {ty}")).collect();
    let gives = slot.signature.gives.as_ref().map_or(String::new(), |ty| format!(" -> {ty}"));
    format!("fn {}({}){gives}", slot.name.value, takes.join(", "))
}

/// What `wesl_library_readme.jinja` is told.
#[derive(serde::Serialize)]
struct Readme {
    #[serde(flatten)]
    about: About,
    /// By another name than that of the facts' options.
    #[serde(rename = "features")]
    options: Vec<Feature>,
    generic: Vec<Generic>,
}

/// An option, and how features choose it.
#[derive(serde::Serialize)]
struct Feature {
    key: String,
    doc: String,
    default: String,
    /// Each other value, and its feature.
    others: Vec<(String, String)>,
}

impl Feature {
    fn of(option: &Choice, index: usize, choices: &Choices) -> Self {
        let domain = &choices.domains[index];
        let others = domain.features.iter().zip(&domain.shown);
        Self {
            key: option.decl.key.to_string(),
            doc: clean(&option.decl.doc.split_whitespace().collect::<Vec<_>>().join(" ")),
            default: option.decl.show(option.value),
            others: others.filter_map(|(name, shown)| Some((shown.clone(), name.clone()?))).collect(),
        }
    }
}

/// A generic fragment on its own.
#[derive(serde::Serialize)]
struct Generic {
    path: String,
    slots: Vec<String>,
}

impl Generic {
    fn of(module: &OpenModule, path: &[String]) -> Self {
        let slots = module.slots.iter().map(|slot| slot.name.value.clone());
        Self { path: path.join("::"), slots: slots.collect() }
    }
}
