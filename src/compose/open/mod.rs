//! The whole library with its choices left open: every fragment and instance with all of its branches, what each of its names
//! is, and when. For languages that decide conditions themselves.
//!
//! Composing decides conditions first and finds names after. Here every branch is looked at, so that a name may be one thing
//! under one choice and another under the next: it is imported from each, under the condition that leads there.

mod choices;
mod cut;
mod find;
mod formula;

pub(crate) use choices::Choices;
pub(crate) use formula::Formula;

use std::sync::Arc;

use rustc_hash::FxHashSet;

use super::cache::Cache;
use super::error::ComposeError;
use super::graph::Graph;
use super::prefix::Prefix;
use super::select::{activity, known, part};
use super::{Choice, Composition, Parameter, Survey, fail, root};
use crate::diagnostic::{Diagnostic, Error};
use crate::preset::{self, Declarations, Knob, Preset};
use crate::source::{Library, Source};
use crate::syntax::{DirectiveKind, Module, OptionValue, Slot, parse_fragment, split};
use choices::{LONGEST, MOST, NoFormula};
use cut::Cut;

/// What to do about what cannot be left open.
const DECIDED: &str = "export a preset, which decides it";

/// The same, about a condition that cuts something through.
const AROUND: &str =
    "let it stand around whole declarations, statements or members; or export a preset, which decides it";

/// The whole library.
pub(crate) struct Open {
    /// Parameters and options, the texts that they are from, and a part without text for each module.
    pub(crate) composition: Composition,
    /// Everything that a preset can set.
    pub(crate) declarations: Declarations,
    /// What can be chosen.
    pub(crate) choices: Choices,
    /// By the option's number: whether code reads it as a value.
    pub(crate) read: Vec<bool>,
    /// By the option's number: whether a condition asks for it.
    pub(crate) decides: Vec<bool>,
    /// The fragments and instances, one for each part.
    pub(crate) modules: Vec<OpenModule>,
}

/// A fragment or an instance of one.
pub(crate) struct OpenModule {
    /// Its text, in order.
    pub(crate) pieces: Vec<OpenPiece>,
    /// What it takes from other modules.
    pub(crate) imports: Vec<Import>,
    /// Slots that nobody fills.
    pub(crate) slots: Vec<Slot>,
    /// Slots that functions of WGSL's own fill, by which and when.
    pub(crate) built_in: Vec<(Slot, String, Formula)>,
}

/// A piece of a module's text.
pub(crate) enum OpenPiece {
    /// Text.
    Text(String),
    /// A parameter or an option is read.
    Read(Knob),
}

/// A name from another module.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Import {
    /// Its number.
    pub(crate) module: usize,
    /// What it is called there.
    pub(crate) name: String,
    /// What it is called here, if otherwise.
    pub(crate) alias: Option<String>,
    /// When it is that one.
    pub(crate) when: Formula,
}

/// The library with the values of `preset` as defaults. With `wrapper`, the preset's scene is in with the entry point that it
/// gets.
///
/// # Errors
/// Everything that is wrong with any of the fragments but what only a WGSL compiler can tell, and conditions that stand in the
/// middle of a declaration or a statement.
pub(crate) fn open(library: &Library, preset: &Preset, wrapper: Option<Source>) -> Result<Open, Error> {
    let mut cache = Cache::default();
    let mut files = preset.files.clone();
    let mut errors = Vec::new();
    let mut graph = Graph::default();
    for path in library.modules() {
        match library.find(&path) {
            Ok(source) => drop(graph.add_root(source, library, &mut cache, &mut files, &mut errors)),
            Err(error) => errors.push(ComposeError::Module { error, nearest: None }),
        }
    }
    let mut called = None;
    if let Some(wrapper) = wrapper {
        match root(library, preset) {
            Ok(scene) => {
                let scene = graph.add_root(scene, library, &mut cache, &mut files, &mut errors);
                let wrapper = graph.add_root(wrapper, library, &mut cache, &mut files, &mut errors);
                called = Some((wrapper, scene));
            }
            Err(error) => errors.push(error),
        }
    }
    if !errors.is_empty() {
        return Err(fail(errors, files));
    }
    let declarations = graph.declarations(&mut errors);
    if !errors.is_empty() {
        return Err(fail(errors, files));
    }
    let settings = match preset::settle(preset, &declarations) {
        Ok(settings) => settings,
        Err(errors) => return Err(Error::new(errors.into_iter().map(Diagnostic::from).collect(), files)),
    };
    let name = preset.name().to_owned();
    let survey =
        Survey { name, scene: "".into(), files: files.into(), declarations, settings, graph, wrapper: None };
    activity(&survey, &mut errors); // what is wrong with conditions
    if !errors.is_empty() {
        return Err(fail(errors, survey.files));
    }
    let mut opened = match cut_all(&survey) {
        Ok(opened) => opened,
        Err(error) => return Err(fail([error], survey.files)),
    };
    opened.edges(called);
    let (modules, uses) = find::modules(&opened, &mut errors);
    if !errors.is_empty() {
        return Err(fail(errors, survey.files.clone()));
    }
    let choices = opened.choices;
    let decides = opened.decides;
    let parameters = survey.declarations.parameters.iter().zip(&survey.settings.parameters).enumerate();
    let parameters = parameters.map(|(index, (declared, value))| Parameter {
        decl: declared.decl.clone(),
        value: *value,
        read: uses.contains(&Knob::Parameter(index)),
        at: (declared.file, declared.span),
    });
    let read: Vec<bool> =
        (0..survey.declarations.options.len()).map(|index| uses.contains(&Knob::Option(index))).collect();
    let options = survey.declarations.options.iter().zip(&survey.settings.options).enumerate();
    let options = options.map(|(index, (declared, value))| Choice {
        decl: declared.decl.clone(),
        value: *value,
        // One that a condition asks for has another value with another feature: whoever writes it says so itself.
        read: read[index] && !is_feature(&choices, index, &decides, value),
        decides: decides[index],
        at: (declared.file, declared.span),
    });
    let composition = Composition {
        name: survey.name.clone(),
        about: preset.about().to_owned(),
        files: survey.files.clone(),
        parameters: parameters.collect(),
        options: options.collect(),
        slots: Vec::new(),
        hoisted: Vec::new(),
        parts: (0..modules.len()).map(|instance| part(&survey.graph, instance, Vec::new())).collect(),
        prefix: Prefix::default(),
        graph: Arc::new(survey.graph),
    };
    Ok(Open { composition, declarations: survey.declarations, choices, read, decides, modules })
}

/// Whether features choose the value of option number `index`. Of a whole number that no condition asks for, none does.
fn is_feature(choices: &Choices, index: usize, decides: &[bool], value: &OptionValue) -> bool {
    decides[index] || !matches!(value, OptionValue::Integer(_)) && choices.domains[index].features.len() > 1
}

/// The fragments, cut.
struct Opened<'a> {
    survey: &'a Survey,
    choices: Choices,
    decides: Vec<bool>,
    cuts: Vec<Cut>,
    modules: Vec<Module>,
    /// By instance: whom it includes, and when.
    edges: Vec<Vec<(Formula, usize)>>,
}

/// Every instance with its branches.
fn cut_all(survey: &Survey) -> Result<Opened<'_>, ComposeError> {
    let graph = &survey.graph;
    let options = survey.declarations.options.len();
    let (mut numbers, mut decides) = (vec![Vec::new(); options], vec![false; options]);
    for instance in 0..graph.instances.len() {
        let known = known(survey, instance);
        for placed in &graph.fragment(instance).directives {
            if let DirectiveKind::If(expr) | DirectiveKind::Elif(expr) = &placed.directive.kind {
                choices::note_cuts(expr, &known, &mut numbers);
                for term in &expr.terms {
                    if let crate::syntax::Term::Name(name) = &term.value
                        && let Some(Knob::Option(index)) = known.find(name)
                    {
                        decides[index] = true;
                    }
                }
            }
        }
    }
    let too_many = |index: usize| {
        let declared = &survey.declarations.options[index];
        let key = &declared.decl.key;
        let what =
            format!("`{key}` cannot be left open: conditions tell more than {MOST} of its values apart");
        ComposeError::NotOpen { what, help: DECIDED, at: (declared.file, declared.span) }
    };
    let choices = match Choices::new(&survey.declarations, &survey.settings, &numbers) {
        Ok(choices) => choices,
        Err(NoFormula::Many(index)) => return Err(too_many(index)),
        Err(NoFormula::Long) => Choices { domains: Vec::new(), full: Vec::new() }, // it reads no condition
    };
    let (mut cuts, mut modules) = (Vec::new(), Vec::new());
    for instance in 0..graph.instances.len() {
        let (fragment, file) = (graph.fragment(instance), graph.file(instance));
        let known = known(survey, instance);
        let mut conditions = Vec::new();
        for placed in &fragment.directives {
            if let DirectiveKind::If(expr) | DirectiveKind::Elif(expr) = &placed.directive.kind {
                conditions.push(choices.formula(expr, &known).map_err(|_| ComposeError::NotOpen {
                    what: format!("a condition of more than {LONGEST} steps cannot be left open"),
                    help: DECIDED,
                    at: (file, placed.directive.span),
                })?);
            }
        }
        let cut = cut::cut(fragment, &conditions, &choices.full, |formula| choices.wesl(formula)).map_err(
            |span| {
                let what =
                    "a condition in the middle of a declaration, a statement or a member cannot be left open";
                ComposeError::NotOpen { what: what.into(), help: AROUND, at: (file, span) }
            },
        )?;
        modules.push(split(&parse_fragment(cut.text.as_str().into()), &[]));
        cuts.push(cut);
    }
    Ok(Opened { survey, choices, decides, cuts, modules, edges: Vec::new() })
}

impl Opened<'_> {
    /// Notes whom each instance includes, and that the entry point calls the scene.
    fn edges(&mut self, called: Option<(usize, usize)>) {
        let instances = self.survey.graph.instances.iter().zip(&self.cuts);
        let edges = instances.map(|(instance, cut)| {
            let includes = instance.includes.iter();
            includes.map(|(directive, child)| (cut.directives[*directive].clone(), *child)).collect()
        });
        self.edges = edges.collect();
        if let Some((wrapper, scene)) = called {
            self.edges[wrapper].push((Formula::ALWAYS, scene));
        }
    }

    /// The instances that `from` can reach, itself first.
    fn reachable(&self, from: usize) -> FxHashSet<usize> {
        let mut seen = FxHashSet::default();
        let mut ahead = vec![from];
        while let Some(instance) = ahead.pop() {
            if seen.insert(instance) {
                ahead.extend(self.edges[instance].iter().map(|(_, child)| *child));
            }
        }
        seen
    }

    /// When what `from` includes leads to `to`.
    fn leads(&self, from: usize, to: usize) -> Formula {
        let full = &self.choices.full;
        let mut leads = vec![Formula::NEVER; self.edges.len()];
        leads[to] = Formula::ALWAYS;
        let within: Vec<usize> = {
            let mut within: Vec<_> = self.reachable(from).into_iter().collect();
            within.sort_unstable();
            within
        };
        // Each round looks one include further.
        for _ in 0..within.len() {
            let mut changed = false;
            for instance in within.iter().filter(|instance| **instance != to) {
                let ways = self.edges[*instance]
                    .iter()
                    .map(|(when, child)| Formula::all([when.clone(), leads[*child].clone()], full));
                let now = Formula::any(ways, full);
                if now != leads[*instance] {
                    leads[*instance] = now;
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
        leads[from].clone()
    }
}
