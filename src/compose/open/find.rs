//! What each name of each module is, and when: [`Opened`] → [`OpenModule`]s.

use std::collections::BTreeMap;

use rustc_hash::{FxHashMap, FxHashSet};

use super::formula::Formula;
use super::{Import, OpenModule, OpenPiece, Opened};
use crate::compose::builtin::is_builtin_function;
use crate::compose::error::ComposeError;
use crate::compose::select::known;
use crate::diagnostic::{ENOUGH, nearest};
use crate::preset::Knob;
use crate::source::Span;
use crate::syntax::{DirectiveKind, OptionKind, Reference, Slot, TokenKind, lex};

/// What a name is.
enum Found {
    /// WGSL's own, or unknown.
    Foreign,
    /// A slot of the fragment.
    Slot,
    /// One of these declarations: in which instance, called what, and when it is that one.
    Declared(Vec<(usize, String, Formula)>),
    /// A group of parameters.
    Group,
    /// A parameter or an option without a group.
    Knob(Knob),
}

/// What fills a slot.
#[derive(PartialEq, Clone)]
enum Filler {
    Declared(usize, String),
    BuiltIn(String),
}

struct Finder<'a> {
    opened: &'a Opened<'a>,
    /// By the name in full: where it is declared, and when.
    table: FxHashMap<String, Vec<(usize, Formula)>>,
    /// By instance: whom it can reach.
    reach: Vec<FxHashSet<usize>>,
    /// By instance: who includes it.
    includers: Vec<Vec<(usize, usize)>>,
    /// By instance: its slots.
    slots: Vec<Vec<&'a Slot>>,
}

/// The modules, and what parameters and options they read.
pub(super) fn modules(
    opened: &Opened<'_>,
    errors: &mut Vec<ComposeError>,
) -> (Vec<OpenModule>, FxHashSet<Knob>) {
    let finder = Finder::new(opened);
    let mut uses = FxHashSet::default();
    let count = opened.cuts.len();
    let modules = (0..count).map(|instance| finder.module(instance, &mut uses, errors)).collect();
    (modules, uses)
}

impl<'a> Finder<'a> {
    fn new(opened: &'a Opened<'a>) -> Self {
        let graph = &opened.survey.graph;
        let count = graph.instances.len();
        let mut table: FxHashMap<String, Vec<(usize, Formula)>> = FxHashMap::default();
        let mut includers = vec![Vec::new(); count];
        let mut slots = Vec::new();
        for instance in 0..count {
            let (module, cut) = (&opened.modules[instance], &opened.cuts[instance]);
            for (symbol, span) in module.declarations.iter().filter_map(|declaration| declaration.name) {
                let name = full_name(&graph.instances[instance].prefix, module.name(&cut.text, symbol));
                let when = cut.presence(span.start);
                let known = table.entry(name).or_default();
                match known.iter_mut().find(|(other, _)| *other == instance) {
                    Some((_, known)) => *known = Formula::any([known.clone(), when], &opened.choices.full),
                    None => known.push((instance, when)),
                }
            }
            for (directive, child) in &graph.instances[instance].includes {
                includers[*child].push((instance, *directive));
            }
            let placed = graph.fragment(instance).directives.iter();
            slots.push(
                placed
                    .filter_map(|placed| match &placed.directive.kind {
                        DirectiveKind::Slot(slot) => Some(slot),
                        _ => None,
                    })
                    .collect(),
            );
        }
        let reach = (0..count).map(|instance| opened.reachable(instance)).collect();
        Self { opened, table, reach, includers, slots }
    }

    fn prefix(&self, instance: usize) -> &str {
        &self.opened.survey.graph.instances[instance].prefix
    }

    /// What `name` is in `instance`; looked up in the order of composing.
    fn find(&self, instance: usize, name: &str) -> Found {
        if self.slots[instance].iter().any(|slot| slot.name.value == name) {
            return Found::Slot;
        }
        let prefix = self.prefix(instance);
        if !prefix.is_empty() {
            let own = full_name(prefix, name);
            let is_within = |other: usize| {
                let rest = self.prefix(other).strip_prefix(prefix);
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
            };
            let found = self.declared(instance, &own, is_within);
            if !found.is_empty() {
                return Found::Declared(found);
            }
        }
        let found = self.declared(instance, name, |_| true);
        if !found.is_empty() {
            return Found::Declared(found);
        }
        let survey = self.opened.survey;
        let renamed = &survey.graph.instances[instance].renamed;
        if survey.declarations.is_group_in_code(name)
            || renamed.as_ref().is_some_and(|(from, _)| from == name)
            || !prefix.is_empty() && survey.declarations.is_group_in_code(&full_name(prefix, name))
        {
            return Found::Group;
        }
        survey.declarations.find(name).map_or(Found::Foreign, Found::Knob)
    }

    /// The declarations of `name` in full that `instance` can mean.
    fn declared(
        &self,
        instance: usize,
        name: &str,
        fits: impl Fn(usize) -> bool,
    ) -> Vec<(usize, String, Formula)> {
        let all = self.table.get(name).map(Vec::as_slice).unwrap_or_default();
        let all = || all.iter().filter(|(owner, _)| fits(*owner));
        let mut near: Vec<_> =
            all().filter(|(owner, _)| self.reach[instance].contains(owner)).cloned().collect();
        if near.is_empty() {
            near = all().cloned().collect(); // another one's include brings it in
        }
        if let [(owner, _)] = near[..] {
            return vec![(owner, name.to_owned(), Formula::ALWAYS)];
        }
        let full = &self.opened.choices.full;
        let when = |(owner, when): (usize, Formula)| {
            let when = Formula::all([self.opened.leads(instance, owner), when], full);
            (owner, name.to_owned(), when)
        };
        near.into_iter().map(when).filter(|(.., when)| !when.is_never()).collect()
    }

    /// What fills the slot `name` of `instance`, and when; nothing where nobody fills it.
    fn fillers(&self, instance: usize, name: &str, depth: usize) -> Vec<(Filler, Formula)> {
        let full = &self.opened.choices.full;
        let mut all: Vec<(Filler, Formula)> = Vec::new();
        let mut add = |filler: Filler, when: Formula| match all.iter_mut().find(|(known, _)| *known == filler)
        {
            Some((_, known)) => *known = Formula::any([known.clone(), when], full),
            None => all.push((filler, when)),
        };
        for (includer, directive) in &self.includers[instance] {
            let Some(include) = self.opened.survey.graph.include(*includer, *directive) else { continue };
            let Some((_, target)) = include.with.iter().find(|(slot, _)| slot.value == name) else {
                continue;
            };
            let present = &self.opened.cuts[*includer].directives[*directive];
            match self.find(*includer, &target.value) {
                Found::Declared(declared) => {
                    for (owner, name, when) in declared {
                        add(Filler::Declared(owner, name), Formula::all([present.clone(), when], full));
                    }
                }
                // Handed on. Slots may hand on in a circle; names of files nest less deep than that.
                Found::Slot if depth < 64 => {
                    for (filler, when) in self.fillers(*includer, &target.value, depth + 1) {
                        add(filler, Formula::all([present.clone(), when], full));
                    }
                }
                Found::Foreign if is_builtin_function(&target.value) => {
                    add(Filler::BuiltIn(target.value.clone()), present.clone());
                }
                _ => {}
            }
        }
        if let [(_, when)] = &mut all[..] {
            *when = Formula::ALWAYS; // whoever includes it, it is this one
        }
        all
    }

    fn module(
        &self,
        instance: usize,
        uses: &mut FxHashSet<Knob>,
        errors: &mut Vec<ComposeError>,
    ) -> OpenModule {
        let (module, cut) = (&self.opened.modules[instance], &self.opened.cuts[instance]);
        let mut made =
            OpenModule { pieces: Vec::new(), imports: Vec::new(), slots: Vec::new(), built_in: Vec::new() };
        let mut words: BTreeMap<u32, (u32, OpenPiece)> = BTreeMap::new();
        let mut known: FxHashMap<u32, Option<String>> = FxHashMap::default();
        for reference in &module.references {
            let name = module.name(&cut.text, reference.symbol);
            if let Some(word) = known.get(&reference.symbol) {
                if let Some(word) = word {
                    words.insert(reference.span.start, (reference.span.end, OpenPiece::Text(word.clone())));
                }
                continue;
            }
            let knob = match self.find(instance, name) {
                Found::Foreign => {
                    known.insert(reference.symbol, None);
                    continue;
                }
                Found::Slot => {
                    self.slot(instance, name, &mut made);
                    known.insert(reference.symbol, None);
                    continue;
                }
                Found::Declared(declared) => {
                    let full = declared.first().map(|(_, full, _)| full.clone()).unwrap_or_default();
                    for (owner, name, when) in declared.into_iter().filter(|(owner, ..)| *owner != instance) {
                        made.imports.push(Import { module: owner, name, alias: None, when });
                    }
                    let word = (full != name).then_some(full);
                    if let Some(word) = &word {
                        let piece = OpenPiece::Text(word.clone());
                        words.insert(reference.span.start, (reference.span.end, piece));
                    }
                    known.insert(reference.symbol, word);
                    continue;
                }
                Found::Group => self.member(instance, name, reference),
                Found::Knob(knob) => {
                    self.readable(instance, knob, reference.span).map(|knob| (knob, reference.span))
                }
            };
            match knob {
                Ok((knob, span)) => {
                    uses.insert(knob);
                    words.insert(span.start, (span.end, OpenPiece::Read(knob)));
                }
                Err(error) if errors.len() < ENOUGH => errors.push(error),
                Err(_) => {}
            }
        }
        let mut start = 0;
        for (at, (end, piece)) in words {
            made.pieces.push(OpenPiece::Text(cut.text[start..at as usize].to_owned()));
            made.pieces.push(piece);
            start = end as usize;
        }
        made.pieces.push(OpenPiece::Text(cut.text[start..].to_owned()));
        made
    }

    /// Takes in what fills the slot `name`.
    fn slot(&self, instance: usize, name: &str, made: &mut OpenModule) {
        let Some(slot) = self.slots[instance].iter().find(|slot| slot.name.value == name) else { return };
        let fillers = self.fillers(instance, name, 0);
        let is_written_here = |filler: &Filler| matches!(filler, Filler::BuiltIn(_));
        if fillers.is_empty() || fillers.iter().any(|(filler, _)| is_written_here(filler)) {
            self.types(instance, slot, made);
        }
        if fillers.is_empty() {
            made.slots.push((*slot).clone());
        }
        for (filler, when) in fillers {
            match filler {
                Filler::Declared(module, target) => {
                    let alias = (target != name).then(|| name.to_owned());
                    made.imports.push(Import { module, name: target, alias, when });
                }
                Filler::BuiltIn(target) => made.built_in.push(((*slot).clone(), target, when)),
            }
        }
    }

    /// Takes in the types that a slot's signature names.
    fn types(&self, instance: usize, slot: &Slot, made: &mut OpenModule) {
        for ty in slot.signature.takes.iter().chain(&slot.signature.gives) {
            for (kind, span) in lex(ty).iter() {
                let Found::Declared(declared) = (match kind {
                    TokenKind::Ident => self.find(instance, &ty[span.range()]),
                    _ => Found::Foreign,
                }) else {
                    continue;
                };
                for (owner, name, when) in declared.into_iter().filter(|(owner, ..)| *owner != instance) {
                    made.imports.push(Import { module: owner, name, alias: None, when });
                }
            }
        }
    }

    fn member(
        &self,
        instance: usize,
        group: &str,
        reference: &Reference,
    ) -> Result<(Knob, Span), ComposeError> {
        let (module, cut) = (&self.opened.modules[instance], &self.opened.cuts[instance]);
        let survey = self.opened.survey;
        let file = survey.graph.file(instance);
        let Some((member, member_span)) = reference.member else {
            let at = (file, cut.origin(reference.span));
            return Err(ComposeError::GroupAsValue { group: group.to_owned(), at });
        };
        let key = format!("{group}.{}", module.name(&cut.text, member));
        let span = reference.span.to(member_span);
        match known(survey, instance).find(&key) {
            Some(knob) => self.readable(instance, knob, span).map(|knob| (knob, span)),
            None => {
                let nearest = nearest(&key, survey.declarations.keys());
                Err(ComposeError::UnknownMember { key, nearest, at: (file, cut.origin(span)) })
            }
        }
    }

    /// A choice among names has no value in code.
    fn readable(&self, instance: usize, knob: Knob, span: Span) -> Result<Knob, ComposeError> {
        let survey = self.opened.survey;
        if let Knob::Option(index) = knob
            && let OptionKind::Choice(_) = &survey.declarations.options[index].decl.kind
        {
            let key = survey.declarations.options[index].decl.key.to_string();
            let at = (survey.graph.file(instance), self.opened.cuts[instance].origin(span));
            return Err(ComposeError::ChoiceInCode { key, at, declared: survey.declarations.place(knob) });
        }
        Ok(knob)
    }
}

fn full_name(prefix: &str, name: &str) -> String {
    if prefix.is_empty() { name.to_owned() } else { format!("{prefix}_{name}") }
}
