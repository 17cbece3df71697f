//! Which declarations are in: those that the entry points reach by name.
//!
//! Without an entry point, every declaration of the root fragments counts as one: a module on its own.

use super::error::ComposeError;
use super::names::{Global, Meaning, Names};
use crate::diagnostic::{ENOUGH, choices, nearest};
use crate::preset::Knob;
use crate::syntax::{DeclarationKind, Symbol};

/// What is in, and what each name in it means.
pub(super) struct Kept {
    /// By instance, by declaration.
    pub(super) declarations: Vec<Vec<bool>>,
    /// By instance, by symbol; none where nobody asked.
    pub(super) meanings: Vec<Vec<Option<Meaning>>>,
    /// By instance: whether any of its names is spelled otherwise in the result. Most are not, and are copied whole.
    pub(super) rewrites: Vec<bool>,
    /// Which parameters are read, by number.
    pub(super) parameters: Vec<bool>,
    /// Which options are read, by number.
    pub(super) options: Vec<bool>,
}

impl Kept {
    /// What the name numbered `symbol` means in `instance`.
    fn meaning(&mut self, names: &Names<'_>, instance: usize, symbol: Symbol) -> Meaning {
        let slot = &mut self.meanings[instance][symbol as usize];
        if slot.is_none() {
            let name =
                names.active[instance].as_ref().map_or("", |active| active.module.name(active.text, symbol));
            let meaning = names.look_up(instance, name);
            self.rewrites[instance] |=
                matches!(meaning, Meaning::Renamed(..) | Meaning::Group | Meaning::Knob(_));
            *slot = Some(meaning);
        }
        slot.clone().unwrap_or(Meaning::Foreign)
    }
}

/// Follows names from the roots. With `keep_all`, every active declaration is a root; with `only`, those named so.
pub(super) fn shake(
    names: &Names<'_>,
    keep_all: bool,
    only: &[String],
    errors: &mut Vec<ComposeError>,
) -> Kept {
    let sizes = names.active.iter();
    let mut kept = Kept {
        declarations: sizes
            .clone()
            .map(|a| vec![false; a.as_ref().map_or(0, |a| a.module.declarations.len())])
            .collect(),
        meanings: sizes.map(|a| vec![None; a.as_ref().map_or(0, |a| a.module.symbols())]).collect(),
        rewrites: vec![false; names.active.len()],
        parameters: vec![false; names.declarations.parameters.len()],
        options: vec![false; names.declarations.options.len()],
    };
    let mut open = roots(names, keep_all, only, errors);
    for global in &open {
        kept.declarations[global.instance as usize][global.declaration as usize] = true;
    }
    while let Some(global) = open.pop() {
        let instance = global.instance as usize;
        let Some(active) = &names.active[instance] else { continue };
        let declaration = &active.module.declarations[global.declaration as usize];
        if matches!(
            declaration.kind,
            DeclarationKind::Enable | DeclarationKind::Requires | DeclarationKind::Diagnostic
        ) {
            continue;
        }
        for reference in &active.module.references[declaration.references.clone()] {
            let knob = match kept.meaning(names, instance, reference.symbol) {
                Meaning::Global(target) | Meaning::Renamed(Some(target), _) => {
                    let known = &mut kept.declarations[target.instance as usize][target.declaration as usize];
                    if !std::mem::replace(known, true) {
                        open.push(target);
                    }
                    continue;
                }
                Meaning::Group => names.member(instance, reference),
                Meaning::Knob(knob) => names.readable(knob, (names.graph.file(instance), reference.span)),
                Meaning::Foreign | Meaning::OpenSlot | Meaning::Renamed(None, _) => continue,
            };
            match knob {
                Ok(Knob::Parameter(index)) => kept.parameters[index] = true,
                Ok(Knob::Option(index)) => kept.options[index] = true,
                Err(error) => {
                    errors.push(error);
                    if errors.len() >= ENOUGH {
                        return kept;
                    }
                }
            }
        }
    }
    kept
}

fn roots(names: &Names<'_>, keep_all: bool, only: &[String], errors: &mut Vec<ComposeError>) -> Vec<Global> {
    let mut entries = Vec::new();
    let mut always = Vec::new();
    let mut own = Vec::new();
    for instance in names.order {
        let Some(active) = &names.active[*instance] else { continue };
        let is_root = names.graph.roots.contains(instance);
        let is_entered = is_root && names.graph.only_from.is_none_or(|root| root == *instance);
        for (index, declaration) in active.module.declarations.iter().enumerate() {
            let global = Global { instance: *instance as u32, declaration: index as u32 };
            if keep_all {
                always.push(global);
                continue;
            }
            match declaration.kind {
                // What holds for the whole module, and what only naga can say something about.
                DeclarationKind::ConstAssert | DeclarationKind::Other => always.push(global),
                DeclarationKind::Enable | DeclarationKind::Requires | DeclarationKind::Diagnostic => {}
                _ if is_entered && declaration.stage.is_some() => entries.push(global),
                _ if is_root => own.push(global),
                _ => {}
            }
        }
    }
    if entries.is_empty() && own.is_empty() {
        own = included(names); // a file that only includes others stands for them
    }
    if !only.is_empty() {
        entries.extend(own);
        always.extend(wanted(names, &entries, only, errors));
    } else {
        always.extend(if entries.is_empty() { own } else { entries });
    }
    always
}

/// Of the declarations `all`, those that `only` names.
fn wanted(names: &Names<'_>, all: &[Global], only: &[String], errors: &mut Vec<ComposeError>) -> Vec<Global> {
    let mut found = Vec::new();
    let known = || all.iter().filter_map(|global| names.own_name(*global));
    for name in only {
        match all.iter().find(|global| names.own_name(**global) == Some(name)) {
            Some(global) => found.push(*global),
            None => errors.push(ComposeError::NotDeclared {
                name: name.clone(),
                nearest: nearest(name, known()),
                known: choices(known()),
            }),
        }
    }
    found
}

/// The declarations of all that the roots include themselves.
fn included(names: &Names<'_>) -> Vec<Global> {
    let mut all = Vec::new();
    for root in &names.graph.roots {
        let Some(active) = &names.active[*root] else { continue };
        for (directive, child) in &names.graph.instances[*root].includes {
            let Some(module) = names.active[*child].as_ref().filter(|_| active.directives[*directive]) else {
                continue;
            };
            let named = module.module.declarations.iter().enumerate().filter(|(_, d)| d.name.is_some());
            all.extend(named.map(|(index, _)| Global { instance: *child as u32, declaration: index as u32 }));
        }
    }
    all
}
