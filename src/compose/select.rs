//! What of which files is in, and under which names: everything about a composition that no parameter's value changes.
//!
//! [`Survey`] → [`Selection`]. One is kept with what it was made of ([`Basis`]), so that composing with other values of
//! parameters decides, names and shakes nothing again.

use std::sync::Arc;

use rustc_hash::FxHashSet;

use super::cache::Cache;
use super::decide::{Known, decide};
use super::emit::{self, Hoisted, Piece};
use super::error::ComposeError;
use super::graph::Graph;
use super::hoist::hoist;
use super::names::{Active, Names};
use super::prefix::Prefix;
use super::shake;
use super::{Part, Request, Survey, fail};
use crate::diagnostic::{ENOUGH, Error};
use crate::preset::Knob;
use crate::syntax::{DirectiveKind, Fragment, Module, OptionValue, Slot, Term};

/// What is in.
#[derive(Debug)]
pub(super) struct Selection {
    /// The parts, each after those that it includes.
    pub(super) parts: Vec<Part>,
    /// `enable`, `requires` and `diagnostic`, merged.
    pub(super) hoisted: Vec<Hoisted>,
    /// Slots that stand open, each with its instance.
    pub(super) slots: Vec<(usize, Slot)>,
    /// By parameter: whether the code that is in reads it.
    pub(super) parameters: Vec<bool>,
    /// By option: the same.
    pub(super) options: Vec<bool>,
    /// The options that decide about what is in.
    pub(super) deciding: FxHashSet<usize>,
    /// By instance: who brings it in.
    pub(super) parents: Vec<Option<(usize, usize)>>,
}

/// A file's name, and what was read of it.
type Read = (Arc<str>, Arc<Fragment>);

/// An instance: of which file, under which prefix, and whom it includes by which directive.
type Reached = (usize, Arc<str>, Vec<(usize, usize)>);

/// What a selection follows from.
#[derive(Debug)]
pub(super) struct Basis {
    /// The files in the order in which they were reached.
    files: Vec<Read>,
    instances: Vec<Reached>,
    roots: Vec<usize>,
    only_from: Option<usize>,
    wrapper: Option<usize>,
    options: Vec<OptionValue>,
    parameters: usize,
    only: Vec<String>,
    prefix: Prefix,
    keep_unused: bool,
}

impl Basis {
    pub(super) fn of(survey: &Survey, request: &Request<'_>) -> Self {
        let graph = &survey.graph;
        let files = graph.loaded.iter().map(|loaded| (loaded.source.name.clone(), loaded.fragment.clone()));
        let instances = graph.instances.iter();
        Self {
            files: files.collect(),
            instances: instances.map(|one| (one.loaded, one.prefix.clone(), one.includes.clone())).collect(),
            roots: graph.roots.clone(),
            only_from: graph.only_from,
            wrapper: survey.wrapper,
            options: survey.settings.options.clone(),
            parameters: survey.declarations.in_code().0.len(),
            only: request.only.clone(),
            prefix: request.prefix.clone(),
            keep_unused: request.keep_unused,
        }
    }
}

impl PartialEq for Basis {
    /// Fragments are the same where they are the cache's same one: it reads again only what has changed.
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&Read, &Read)| a.0 == b.0 && Arc::ptr_eq(&a.1, &b.1);
        self.files.len() == other.files.len()
            && self.files.iter().zip(&other.files).all(same)
            && self.instances == other.instances
            && (&self.roots, self.only_from, self.wrapper) == (&other.roots, other.only_from, other.wrapper)
            && (&self.options, self.parameters) == (&other.options, other.parameters)
            && (&self.only, &self.prefix) == (&other.only, &other.prefix)
            && self.keep_unused == other.keep_unused
    }
}

/// Decides what of a survey is in.
///
/// # Errors
/// What is wrong with conditions, names and slots.
pub(super) fn select(
    survey: &mut Survey,
    cache: &mut Cache,
    request: &Request<'_>,
) -> Result<Selection, Error> {
    let mut errors = Vec::new();
    let (active, truths) = activity(survey, &mut errors);
    if !errors.is_empty() {
        return Err(fail(errors, survey.files.clone()));
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
            (!pieces.is_empty()).then(|| part(graph, active.instance, pieces))
        });
        parts.collect::<Vec<_>>()
    };
    let slots: Vec<_> = names
        .open_slots()
        .into_iter()
        .map(|(instance, slot)| {
            let signature = names.spelled(&slot.signature, instance);
            (instance, Slot { signature, ..slot.clone() })
        })
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
        return Err(fail(errors, survey.files.clone()));
    }
    drop(names);
    let deciding = deciding(survey, result.iter().map(|part| part.instance));
    let parents = survey.graph.instances.iter().map(|instance| instance.parent).collect();
    let (parameters, options) = (kept.parameters, kept.options);
    Ok(Selection { parts: result, hoisted, slots, parameters, options, deciding, parents })
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
pub(super) fn known(survey: &Survey, instance: usize) -> Known<'_> {
    let instance = &survey.graph.instances[instance];
    Known {
        declarations: &survey.declarations,
        settings: &survey.settings,
        prefix: &instance.prefix,
        renamed: instance.renamed.as_ref().map(|(from, to)| (from.as_str(), &**to)),
    }
}

/// By instance: which directives are in, and the truth of each condition.
pub(super) fn activity(survey: &Survey, errors: &mut Vec<ComposeError>) -> Activity {
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

/// What is in of `instance`.
pub(super) fn part(graph: &Graph, instance: usize, pieces: Vec<Piece>) -> Part {
    let number = instance;
    let instance = &graph.instances[number];
    let loaded = &graph.loaded[instance.loaded];
    let name = if instance.prefix.is_empty() {
        loaded.source.name.to_string()
    } else {
        format!("{} as {}", loaded.source.name, instance.prefix)
    };
    Part {
        name,
        path: loaded.source.path().clone(),
        prefix: instance.prefix.clone(),
        file: loaded.file,
        instance: number,
        licence: loaded.source.licence(),
        pieces,
    }
}
