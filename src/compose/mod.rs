//! Fragments + preset → [`Composition`]: which text is in, in which order, with which names, and where each piece is from.
//!
//! In steps: the graph of all includes (`graph`); all parameters and options held against the preset; conditions decided
//! (`decide`); names resolved and slots filled (`names`); declarations shaken (`shake`); pieces collected (`emit`). The
//! values themselves are put in by the next stage, `bake`. Nothing here knows naga.

#![allow(
    clippy::result_large_err,
    reason = "a fault ends the composition: its size costs nothing on the way there"
)]

mod cache;
mod catalogue;
mod decide;
mod emit;
mod error;
mod graph;
mod names;
mod prefix;
mod shake;

pub use cache::Cache;
pub use catalogue::{Catalogue, catalogue, views};
pub use emit::{Hoisted, Piece};
pub use error::{At, ComposeError};
pub use names::UNIFORM;
pub use prefix::Prefix;

use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostic::{Diagnostic, ENOUGH, Error};
use crate::preset::{self, Declarations, Knob, Preset, Scene, Settings};
use crate::source::{self, FileId, Files, Library, Source, SourceError};
use crate::syntax::{
    DeclarationKind, DirectiveKind, Key, Module, OptionDecl, OptionValue, ParamDecl, Slot, Term,
    Value,
};
use decide::{Known, decide};
use graph::Graph;
use names::{Active, Names};

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
    let (active, _) = activity(survey, &mut Vec::new()); // what is wrong is told when the view itself is composed
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

/// Puts a scene together.
///
/// # Errors
/// Everything that is wrong with preset and fragments but what only a WGSL compiler can tell.
pub fn compose(library: &Library, cache: &mut Cache, request: &Request<'_>) -> Result<Composition, Error> {
    let mut survey = survey(library, cache, request)?;
    let mut errors = Vec::new();
    let (active, truths) = activity(&survey, &mut errors);
    if !errors.is_empty() {
        return Err(fail(errors, survey.files));
    }
    let mut order = survey.graph.order(&active);
    let mut modules = modules(&survey.graph, cache, &order, &truths);
    if let Some(wrapper) = survey.wrapper
        && !needs_wrapper(&survey.graph, &modules, wrapper)
    {
        survey.graph.roots.retain(|root| *root != wrapper);
        survey.wrapper = None;
        order = survey.graph.order(&active);
        let is_in: FxHashSet<_> = order.iter().copied().collect();
        for (_, module) in modules.iter_mut().enumerate().filter(|(instance, _)| !is_in.contains(instance)) {
            *module = None;
        }
    }
    let graph = &survey.graph;
    for (instance, module) in modules.iter().enumerate() {
        let faults = module.iter().flat_map(|module| &module.errors);
        errors.extend(faults.map(|error| ComposeError::Directive(graph.file(instance), error.clone())));
    }
    let in_names = modules.iter().enumerate().map(|(instance, module)| {
        module.as_ref().map(|module| Active {
            instance,
            text: &graph.fragment(instance).text,
            module,
            directives: &active[instance],
        })
    });
    let prefix = &request.prefix;
    let names = Names::new(graph, &survey.declarations, prefix, in_names.collect(), &order, &mut errors);
    if survey.wrapper.is_some()
        && let Some((at, Some(found))) = names.main_image()
    {
        errors.push(ComposeError::MainImage { found, at });
    }
    let kept = shake::shake(&names, request.keep_unused, &request.only, &mut errors);
    let parts = |hoist: bool, errors: &mut Vec<ComposeError>| {
        let in_order = order.iter().filter_map(|instance| names.active[*instance].as_ref());
        let parts = in_order.filter_map(|active| {
            let pieces = emit::pieces(&names, &kept, active, request.keep_unused, hoist, errors);
            (!pieces.is_empty()).then(|| part(graph, active, pieces))
        });
        parts.collect::<Vec<_>>()
    };
    let slots: Vec<_> = names
        .open_slots()
        .into_iter()
        .map(|(instance, slot)| OpenSlot { slot: slot.clone(), at: (graph.file(instance), slot.name.span) })
        .collect();
    let before = errors.len();
    let mut result = parts(false, &mut errors);
    // A lone file with nothing before it keeps its directives where they are.
    let reads = kept.parameters.iter().chain(&kept.options).any(|read| *read);
    let mut hoisted = Vec::new();
    let mut directives = order.iter().filter(|instance| {
        let active = names.active[**instance].as_ref();
        active.is_some_and(|a| a.module.declarations.iter().any(|d| emit::is_directive(d.kind)))
    });
    let alone = result.len() == 1 && !reads && slots.is_empty();
    let is_elsewhere = |instance: &usize| !(alone && result[0].instance == *instance);
    if directives.any(is_elsewhere) {
        errors.truncate(before); // what `parts` found, it finds again
        result = parts(true, &mut errors);
        hoisted = hoist(&names, &kept, &mut errors);
    }
    if !errors.is_empty() {
        drop(names);
        return Err(fail(errors, survey.files));
    }
    let deciding = deciding(&survey, result.iter().map(|part| part.instance));
    let parameters = survey.declarations.parameters.iter().enumerate().map(|(index, declared)| Parameter {
        decl: declared.decl.clone(),
        value: survey.settings.parameters[index],
        read: kept.parameters[index],
        at: (declared.file, declared.span),
    });
    let options = survey.declarations.options.iter().enumerate().map(|(index, declared)| Choice {
        decl: declared.decl.clone(),
        value: survey.settings.options[index],
        read: kept.options[index],
        decides: deciding.contains(&index),
        at: (declared.file, declared.span),
    });
    let (parameters, options): (Vec<_>, Vec<_>) = (parameters.collect(), options.collect());
    drop(names);
    if let Some(view) = &request.view
        && let Some(files) = survey.graph.files_aside(None)
        && let groups = foreign(&parameters, &options, &files)
        && !groups.is_empty()
    {
        let (view, scene) = (view.clone(), survey.scene);
        return Err(fail([ComposeError::NotInScene { view, scene, groups }], survey.files));
    }
    Ok(Composition {
        name: survey.name,
        about: request.preset.about().to_owned(),
        files: survey.files,
        parameters,
        options,
        slots,
        hoisted,
        parts: result,
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

/// The declarations of every instance that is in.
fn modules(
    graph: &Graph,
    cache: &mut Cache,
    order: &[usize],
    truths: &[Vec<bool>],
) -> Vec<Option<Arc<Module>>> {
    let mut modules = vec![None; graph.instances.len()];
    for instance in order {
        let loaded = &graph.loaded[graph.instances[*instance].loaded];
        modules[*instance] = Some(cache.split(&loaded.source, &loaded.fragment, &truths[*instance]));
    }
    modules
}

/// Whether the scene, its conditions decided, has `main_image` and no entry point of its own.
fn needs_wrapper(graph: &Graph, modules: &[Option<Arc<Module>>], wrapper: usize) -> bool {
    let scene = graph.roots.first().and_then(|root| modules[*root].as_ref());
    let has_entry = scene.is_some_and(|module| module.declarations.iter().any(|d| d.stage.is_some()));
    let declares = |(instance, module): (usize, &Option<Arc<Module>>)| {
        let (Some(module), text) = (module, &graph.fragment(instance).text) else { return false };
        let names = module.declarations.iter().filter_map(|declaration| declaration.name);
        instance != wrapper
            && graph.fragment(instance).has_main_image
            && names.into_iter().any(|(symbol, _)| module.name(text, symbol) == "main_image")
    };
    !has_entry && modules.iter().enumerate().any(declares)
}

type Activity = (Vec<Vec<bool>>, Vec<Vec<bool>>);

/// The options that conditions of these instances, and of the roots, ask for.
fn deciding(survey: &Survey, instances: impl Iterator<Item = usize>) -> FxHashSet<usize> {
    let mut found = FxHashSet::default();
    let roots = survey.graph.roots.iter().copied();
    for instance in instances.chain(roots) {
        let known = known(survey, instance);
        for placed in &survey.graph.fragment(instance).directives {
            if let DirectiveKind::If(expr) | DirectiveKind::Elif(expr) = &placed.directive.kind {
                let names = expr.terms.iter().filter_map(|term| match &term.value {
                    Term::Name(name) => known.find(name),
                    _ => None,
                });
                found.extend(names.filter_map(|knob| match knob {
                    Knob::Option(index) => Some(index),
                    Knob::Parameter(_) => None,
                }));
            }
        }
    }
    found
}

/// What a condition in `instance` can ask for.
fn known(survey: &Survey, instance: usize) -> Known<'_> {
    let instance = &survey.graph.instances[instance];
    Known {
        declarations: &survey.declarations,
        settings: &survey.settings,
        prefix: &instance.prefix,
        renamed: instance.renamed.as_ref().map(|(from, to)| (from.as_str(), &**to)),
    }
}

/// By instance: which directives are in, and the truth of each condition.
fn activity(survey: &Survey, errors: &mut Vec<ComposeError>) -> Activity {
    let graph = &survey.graph;
    let mut all = (Vec::new(), Vec::new());
    for index in 0..graph.instances.len() {
        let known = known(survey, index);
        let fragment = graph.fragment(index);
        let mut truth = Vec::with_capacity(fragment.conditions);
        for placed in &fragment.directives {
            if let DirectiveKind::If(expr) | DirectiveKind::Elif(expr) = &placed.directive.kind {
                if errors.len() >= ENOUGH {
                    truth.push(false);
                    continue;
                }
                truth.push(decide(expr, graph.file(index), &known).unwrap_or_else(|error| {
                    errors.push(error);
                    false
                }));
            }
        }
        all.0.push(fragment.active(&truth));
        all.1.push(truth);
    }
    all
}

fn part(graph: &Graph, active: &Active<'_>, pieces: Vec<Piece>) -> Part {
    let instance = &graph.instances[active.instance];
    let loaded = &graph.loaded[instance.loaded];
    let name = if instance.prefix.is_empty() {
        loaded.source.name.to_string()
    } else {
        format!("{} as {}", loaded.source.name, instance.prefix)
    };
    Part { name, file: loaded.file, instance: active.instance, licence: loaded.source.licence(), pieces }
}

/// `enable`, `requires` and `diagnostic` of all that is in: each once.
fn hoist(names: &Names<'_>, kept: &shake::Kept, errors: &mut Vec<ComposeError>) -> Vec<Hoisted> {
    let mut hoisted: Vec<Hoisted> = Vec::new();
    let mut by_rule: FxHashMap<String, usize> = FxHashMap::default();
    for instance in names.order {
        let Some(active) = &names.active[*instance] else { continue };
        let is_root = names.graph.roots.contains(instance);
        // A file of nothing but directives is included for their sake.
        let only_directives = active.module.declarations.iter().all(|d| emit::is_directive(d.kind));
        if !is_root && !only_directives && !kept.declarations[*instance].contains(&true) {
            continue;
        }
        for declaration in active.module.declarations.iter().filter(|d| emit::is_directive(d.kind)) {
            let text = active.text[declaration.span.range()].trim_end_matches(';');
            let body: String = text
                .split_once(|c: char| !c.is_ascii_alphabetic())
                .map_or("", |(keyword, _)| &text[keyword.len()..])
                .trim()
                .into();
            let file = names.graph.file(*instance);
            let new =
                Hoisted { instance: *instance, file, span: declaration.span, kind: declaration.kind, body };
            let twin = *by_rule.entry(subject(&new)).or_insert(hoisted.len());
            match hoisted.get(twin) {
                None => hoisted.push(new),
                Some(known) if plain(&known.body) != plain(&new.body) => {
                    let value = |body: &str| {
                        body.trim_matches(['(', ')']).split(',').next().unwrap_or("").trim().to_owned()
                    };
                    let rule =
                        plain(&new.body).split_once(',').map_or(String::new(), |(_, rule)| rule.into());
                    errors.push(ComposeError::DiagnosticConflict {
                        name: rule.trim_end_matches(')').into(),
                        value: value(&new.body),
                        first_value: value(&known.body),
                        at: (names.graph.file(*instance), new.span),
                        first: (names.graph.file(known.instance), known.span),
                    });
                }
                Some(_) => {}
            }
        }
    }
    // WGSL wants `diagnostic`, `enable` and `requires` before all else, in any order.
    hoisted.sort_by_key(|directive| directive.kind != DeclarationKind::Enable);
    hoisted
}

fn plain(body: &str) -> String {
    body.chars().filter(|c| !c.is_whitespace()).collect()
}

/// What a directive says something about: there is one of each.
fn subject(directive: &Hoisted) -> String {
    let body = plain(&directive.body);
    match (directive.kind, body.split_once(',')) {
        (DeclarationKind::Diagnostic, Some((_, rule))) => format!("diagnostic {rule}"),
        (kind, _) => format!("{kind:?} {body}"),
    }
}
