//! Fragments + preset → [`Composition`]: which text is in, in which order, with which names, and where each piece is from.
//!
//! In steps: the graph of all includes (`graph`); all parameters and options held against the preset; conditions decided
//! (`decide`); names resolved and slots filled (`names`); declarations shaken (`shake`); pieces collected (`emit`). The
//! values themselves are put in by the next stage, `bake`. Nothing here knows naga.

#![allow(
    clippy::result_large_err,
    reason = "a fault ends the composition: its size costs nothing on the way there"
)]

mod builtin;
mod cache;
mod catalogue;
mod decide;
mod emit;
mod error;
mod graph;
mod hoist;
mod names;
pub(crate) mod open;
mod prefix;
mod select;
mod shake;

pub use cache::{Cache, Work};
pub use catalogue::{Catalogue, catalogue, views};
pub use emit::{Hoisted, Piece};
pub use error::{At, ComposeError};
pub use names::UNIFORM;
pub use prefix::Prefix;

use std::sync::Arc;

use rustc_hash::FxHashSet;

use crate::diagnostic::{Diagnostic, Error};
use crate::preset::{self, Declarations, Preset, Scene, Settings};
use crate::source::{self, FileId, Files, Library, Source, SourceError};
use crate::syntax::{Key, OptionDecl, OptionValue, ParamDecl, Slot, Value};
use graph::Graph;
use select::Basis;

/// A parameter of a composition.
#[derive(Debug, Clone)]
pub struct Parameter {
    /// Its declaration; in an instance, with the instance's group.
    pub decl: ParamDecl,
    /// Its value, in the declared unit.
    pub value: Value,
    /// Whether the code that is in reads it.
    pub read: bool,
    /// Where it is declared.
    pub at: At,
}

/// An option of a composition.
#[derive(Debug, Clone)]
pub struct Choice {
    /// Its declaration; in an instance, with the instance's group.
    pub decl: OptionDecl,
    /// Its value.
    pub value: OptionValue,
    /// Whether the code that is in reads it.
    pub read: bool,
    /// Whether a condition asks for it, in a fragment of which something is in.
    pub decides: bool,
    /// Where it is declared.
    pub at: At,
}

/// What is in of one instance.
#[derive(Debug, Clone)]
pub struct Part {
    /// The fragment's name, with its instance's.
    pub name: String,
    /// Its path inside the folder or the library that it lies in.
    pub path: Arc<str>,
    /// What it is included `as`, with what its includer is; empty where it is included plainly.
    pub prefix: Arc<str>,
    /// The fragment.
    pub file: FileId,
    /// Which instance, for [`Composition::chain`].
    pub instance: usize,
    /// Its licence as the file states it (SPDX), if it does.
    pub licence: Option<String>,
    /// Its text, in order.
    pub pieces: Vec<Piece>,
}

/// A slot of a generic fragment on its own, which nothing fills.
#[derive(Debug, Clone)]
pub struct OpenSlot {
    /// The slot.
    pub slot: Slot,
    /// Where it is declared.
    pub at: At,
}

/// Everything that the result is made of.
#[derive(Clone)]
pub struct Composition {
    /// The preset's name.
    pub name: String,
    /// The preset's line about itself.
    pub about: String,
    /// Every text that was read.
    pub files: Arc<Files>,
    /// All parameters that any branch can reach.
    pub parameters: Vec<Parameter>,
    /// All options that any branch can reach.
    pub options: Vec<Choice>,
    /// Slots that stand open.
    pub slots: Vec<OpenSlot>,
    /// `enable`, `requires` and `diagnostic`, merged; where the only part keeps its own, none.
    pub hoisted: Vec<Hoisted>,
    /// The parts, each after those that it includes.
    pub parts: Vec<Part>,
    /// What every name of module scope starts with in the result.
    pub prefix: Prefix,
    graph: Arc<Graph>,
}

impl Composition {
    /// How an instance was reached, innermost include first: notes for a diagnostic.
    pub fn chain(&self, instance: usize) -> Vec<String> {
        self.graph.chain(instance, &self.files)
    }

    /// The name that a parameter or an option has in the result: `sun_elevation`, or with a prefix `og_sun_elevation`.
    pub fn flat(&self, key: &Key) -> String {
        self.prefix.before(&key.flat())
    }
}

/// What to compose.
pub struct Request<'a> {
    /// Values and scene.
    pub preset: &'a Preset,
    /// The debug view that is composed in the scene's place. The preset is held against the scene's declarations and the
    /// view's.
    pub view: Option<String>,
    /// The fragment of the library that is composed in the scene's place, on its own.
    pub module: Option<String>,
    /// Of the root's declarations, those that are wanted, with what they reach; all where none is named.
    pub only: Vec<String>,
    /// What every name of module scope is to start with.
    pub prefix: Prefix,
    /// The entry point of a scene that has `main_image` and no entry point of its own.
    pub wrapper: Option<Source>,
    /// A fragment that is put in beside the scene: its entry points are the only ones.
    pub beside: Option<Source>,
    /// Keep declarations that no entry point reaches.
    pub keep_unused: bool,
}

/// What a scene offers to be set, and what is set: the first half of a composition.
pub struct Survey {
    /// The preset's name.
    pub name: String,
    /// The scene's name.
    pub scene: Arc<str>,
    /// Every text that was read.
    pub files: Arc<Files>,
    /// All parameters and options that any branch can reach.
    pub declarations: Declarations,
    /// The value of each.
    pub settings: Settings,
    graph: Graph,
    /// The root that calls `main_image`, if the scene may need one.
    wrapper: Option<usize>,
}

/// Reads a scene with everything that it can reach, and holds the preset against it.
///
/// # Errors
/// What is wrong with the preset, the include graph or a directive.
pub fn survey(library: &Library, cache: &mut Cache, request: &Request<'_>) -> Result<Survey, Error> {
    let mut files = request.preset.files.clone();
    let mut errors = Vec::new();
    let mut graph = Graph::default();
    let scene = match root(library, request.preset) {
        Ok(scene) => scene,
        Err(error) => return Err(fail([error], files)),
    };
    let scene_name = scene.name.clone();
    let in_place = match (&request.view, &request.module) {
        (Some(view), _) => Some(catalogue::view(library, view)),
        (None, Some(module)) => Some(module_source(library, module)),
        (None, None) => None,
    };
    let (root, aside) = match in_place {
        None => (scene, None),
        Some(Ok(source)) => (source, Some(scene)),
        Some(Err(error)) => return Err(fail([error], files)),
    };
    let root = graph.add_root(root, library, cache, &mut files, &mut errors);
    let has_entry = graph.fragment(root).has_entry_point;
    let mut wrapper_root = None;
    let has_image = graph.loaded.iter().any(|loaded| loaded.fragment.has_main_image);
    if let Some(wrapper) = &request.wrapper
        && has_image
        && !has_entry
    {
        wrapper_root = Some(graph.add_root(wrapper.clone(), library, cache, &mut files, &mut errors));
    }
    if let Some(beside) = &request.beside {
        graph.only_from = Some(graph.add_root(beside.clone(), library, cache, &mut files, &mut errors));
    }
    if let Some(scene) = aside {
        graph.add_aside(scene, library, cache, &mut files, &mut errors);
    }
    if !errors.is_empty() {
        return Err(fail(errors, files));
    }
    let declarations = graph.declarations(&mut errors);
    if !errors.is_empty() {
        return Err(fail(errors, files));
    }
    let settings = match preset::settle(request.preset, &declarations) {
        Ok(settings) => settings,
        Err(errors) => return Err(Error::new(errors.into_iter().map(Diagnostic::from).collect(), files)),
    };
    let preset = request.preset.name();
    let mut survey = Survey {
        name: match (&request.view, &request.module) {
            (Some(view), _) => format!("{preset} (view {view})"),
            (None, Some(module)) => format!("{module} of {preset}"),
            (None, None) => preset.to_owned(),
        },
        scene: scene_name,
        files: files.into(),
        declarations,
        settings,
        graph,
        wrapper: wrapper_root,
    };
    tell_of_scene(&mut survey);
    Ok(survey)
}

/// A view's options `inspect.has_…` say whether its scene has the element of that name: all that the scene's own options
/// leave out is missing, whatever they are set to.
fn tell_of_scene(survey: &mut Survey) {
    if survey.graph.files_aside(None).is_none() {
        return;
    }
    let (active, _) = select::activity(survey, &mut Vec::new()); // what is wrong is told when the view itself is composed
    let Some(files) = survey.graph.files_aside(Some(&active)) else { return };
    let parameters = survey.declarations.parameters.iter().map(|p| (&p.decl.key.group, p.file));
    let options = survey.declarations.options.iter().map(|o| (&o.decl.key.group, o.file));
    let all = parameters.chain(options).filter(|(_, file)| files.contains(file));
    let has: FxHashSet<&str> = all.map(|(group, _)| group.as_str()).collect();
    for (option, value) in survey.declarations.options.iter().zip(&mut survey.settings.options) {
        let element = option.decl.key.name.strip_prefix("has_");
        if option.decl.key.group == catalogue::OF_VIEWS
            && element.is_some_and(|element| !has.contains(element))
            && let OptionValue::Bool(value) = value
        {
            *value = false;
        }
    }
}

/// Puts a scene together. What `cache` knows is not done again: files that have not changed, and all that does not follow
/// from the values of parameters.
///
/// # Errors
/// Everything that is wrong with preset and fragments but what only a WGSL compiler can tell.
pub fn compose(library: &Library, cache: &mut Cache, request: &Request<'_>) -> Result<Composition, Error> {
    let mut survey = survey(library, cache, request)?;
    let basis = Basis::of(&survey, request);
    let selection = match cache.selection(&basis) {
        Some(known) => known,
        None => {
            let selection = Arc::new(select::select(&mut survey, cache, request)?);
            cache.keep_selection(basis, selection.clone());
            selection
        }
    };
    for (instance, parent) in survey.graph.instances.iter_mut().zip(&selection.parents) {
        instance.parent = *parent;
    }
    let graph = &survey.graph;
    let parameters = survey.declarations.parameters.iter().enumerate().map(|(index, declared)| Parameter {
        decl: declared.decl.clone(),
        value: survey.settings.parameters[index],
        read: selection.parameters[index],
        at: (declared.file, declared.span),
    });
    let options = survey.declarations.options.iter().enumerate().map(|(index, declared)| Choice {
        decl: declared.decl.clone(),
        value: survey.settings.options[index],
        read: selection.options[index],
        decides: selection.deciding.contains(&index),
        at: (declared.file, declared.span),
    });
    let (parameters, options): (Vec<_>, Vec<_>) = (parameters.collect(), options.collect());
    if let Some(view) = &request.view
        && let Some(files) = graph.files_aside(None)
        && let groups = foreign(&parameters, &options, &files)
        && !groups.is_empty()
    {
        let (view, scene) = (view.clone(), survey.scene);
        return Err(fail([ComposeError::NotInScene { view, scene, groups }], survey.files));
    }
    // Files are numbered anew each time.
    let slot = |(instance, slot): &(usize, Slot)| {
        let at = (graph.file(*instance), slot.name.span);
        OpenSlot { slot: slot.clone(), at }
    };
    let part = |part: &Part| Part { file: graph.file(part.instance), ..part.clone() };
    let line = |line: &Hoisted| Hoisted { file: graph.file(line.instance), ..line.clone() };
    Ok(Composition {
        name: survey.name,
        about: request.preset.about().to_owned(),
        files: survey.files,
        parameters,
        options,
        slots: selection.slots.iter().map(slot).collect(),
        hoisted: selection.hoisted.iter().map(line).collect(),
        parts: selection.parts.iter().map(part).collect(),
        prefix: request.prefix.clone(),
        graph: Arc::new(survey.graph),
    })
}

/// The groups that a view reads and that are not its scene's, whose files are `of_scene`: what is not there can't be shown.
/// What the host tells and what views have for themselves is nobody's.
fn foreign(parameters: &[Parameter], options: &[Choice], of_scene: &FxHashSet<FileId>) -> Vec<String> {
    let parameters = parameters.iter().map(|p| (&p.decl.key.group, p.read, p.at.0));
    let options = options.iter().map(|o| (&o.decl.key.group, o.read, o.at.0));
    let all: Vec<_> = parameters.chain(options).filter(|(group, ..)| !group.is_empty()).collect();
    let has = |group: &String| all.iter().any(|(other, _, file)| *other == group && of_scene.contains(file));
    let mut groups = Vec::new();
    for (group, read, _) in &all {
        let is_own = ["frame", catalogue::OF_VIEWS].contains(&group.as_str());
        if *read && !is_own && !groups.contains(*group) && !has(group) {
            groups.push((*group).clone());
        }
    }
    groups
}

fn fail(errors: impl IntoIterator<Item = ComposeError>, files: impl Into<Arc<Files>>) -> Error {
    // Every instance of a fragment has its faults; each place is told once.
    let mut told = FxHashSet::default();
    let diagnostics = errors.into_iter().map(Diagnostic::from);
    let once = diagnostics.filter(|diagnostic| {
        let place = diagnostic.labels.first().map(|label| (label.file, label.span));
        told.insert((diagnostic.code, diagnostic.message.clone(), place))
    });
    Error::new(once.collect(), files)
}

/// The scene's own text.
fn root(library: &Library, preset: &Preset) -> Result<Source, ComposeError> {
    let scene = preset.scene.as_ref().ok_or(ComposeError::NoScene)?;
    let fail = |error: SourceError, at| {
        let nearest = graph::nearest_path(&error, library);
        ComposeError::Scene { error, at, nearest }
    };
    match scene {
        Scene::Text { name, text } => Ok(Source::text(name.as_str(), text.clone())),
        Scene::File(path) => Source::file(path).map_err(|error| fail(error, None)),
        Scene::Named { path, beside, file, span } => {
            let at = Some((*file, *span));
            if let Some(folder) = beside.as_ref().and_then(|preset| preset.parent())
                && let Ok(inside) = source::join("", path)
            {
                match Source::file_in(folder, &inside) {
                    Err(SourceError::NotFound { .. }) => {} // then it is one of the library's
                    found => return found.map_err(|error| fail(error, at)),
                }
            }
            library.find(path).map_err(|error| fail(error, at))
        }
    }
}

/// The text of a module that stands on its own.
fn module_source(library: &Library, path: &str) -> Result<Source, ComposeError> {
    library.find(path).map_err(|error| {
        let nearest = graph::nearest_path(&error, library);
        ComposeError::Module { error, nearest }
    })
}
