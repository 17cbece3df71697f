//! What every name means: declarations of all active instances, slots, parameters and options.
//!
//! A name in an instance is looked up, in this order, as a slot of its fragment, as a declaration of the instance or of
//! what it includes `as` something (both carry the instance's prefix), as a declaration of everybody, and as a group of
//! parameters. What is found nowhere is WGSL's own, or naga's to complain about.

use std::borrow::Cow;
use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};

use super::builtin::is_builtin_function;
use super::error::{At, ComposeError};
use super::graph::Graph;
use super::prefix::Prefix;
use crate::diagnostic::{ENOUGH, choices, nearest};
use crate::preset::{Declarations, Knob};
use crate::syntax::{
    Declaration, DeclarationKind, DirectiveKind, Include, Module, OptionKind, Reference, Signature, Slot,
    Symbol, TokenKind, is_reserved, lex, signature,
};

/// The name of the uniform buffer, and of its type.
pub const UNIFORM: (&str, &str) = ("orogen", "OrogenParams");

/// A declaration: which instance, and which of its module's declarations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Global {
    pub(super) instance: u32,
    pub(super) declaration: u32,
}

/// What a name means where it stands.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Meaning {
    /// WGSL's own, or unknown.
    Foreign,
    /// A declaration that is called the same in the result.
    Global(Global),
    /// A declaration, or WGSL's own function, that is called otherwise in the result.
    Renamed(Option<Global>, Arc<str>),
    /// A group of parameters: the member decides.
    Group,
    /// A parameter or an option without a group.
    Knob(Knob),
    /// A slot that nothing fills, of a generic fragment on its own: called the same in the result.
    OpenSlot,
}

/// An instance that is in, with its declarations.
pub(super) struct Active<'a> {
    pub(super) instance: usize,
    pub(super) text: &'a str,
    pub(super) module: &'a Module,
    /// Which of its fragment's directives are in.
    pub(super) directives: &'a [bool],
}

pub(super) struct Names<'a> {
    pub(super) graph: &'a Graph,
    pub(super) declarations: &'a Declarations,
    /// What all names start with in the result. The table below knows them without it.
    pub(super) prefix: &'a Prefix,
    /// By instance; none where the instance is not in.
    pub(super) active: Vec<Option<Active<'a>>>,
    pub(super) order: &'a [usize],
    table: FxHashMap<Cow<'a, str>, Global>,
    /// By instance: what fills its slots.
    slots: FxHashMap<u32, FxHashMap<String, Meaning>>,
    /// By loaded file: which of its directives are slots.
    slots_in: Vec<Vec<usize>>,
    /// The slots of roots, which nobody fills.
    open: FxHashSet<(usize, &'a str)>,
}

impl<'a> Names<'a> {
    /// Collects all declarations, and fills all slots.
    pub(super) fn new(
        graph: &'a Graph,
        declarations: &'a Declarations,
        prefix: &'a Prefix,
        active: Vec<Option<Active<'a>>>,
        order: &'a [usize],
        errors: &mut Vec<ComposeError>,
    ) -> Self {
        let count = active.iter().flatten().map(|active| active.module.declarations.len()).sum();
        let table = FxHashMap::with_capacity_and_hasher(count, Default::default());
        let slots_in = graph.loaded.iter().map(|loaded| {
            let placed = loaded.fragment.directives.iter().enumerate();
            let slots = placed.filter(|(_, p)| matches!(p.directive.kind, DirectiveKind::Slot(_)));
            slots.map(|(index, _)| index).collect()
        });
        let slots_in = slots_in.collect();
        let (slots, open) = (FxHashMap::default(), FxHashSet::default());
        let mut names = Self { graph, declarations, prefix, active, order, table, slots, slots_in, open };
        names.open =
            names.open_slots().into_iter().map(|(root, slot)| (root, slot.name.value.as_str())).collect();
        for instance in order {
            names.declare(*instance, errors);
        }
        names.check_flat_names(errors);
        names.check_prefixed(errors);
        names.fill_slots(errors);
        names
    }

    fn declare(&mut self, instance: usize, errors: &mut Vec<ComposeError>) {
        let prefix = &self.graph.instances[instance].prefix;
        let Some(active) = &self.active[instance] else { return };
        for (index, declaration) in active.module.declarations.iter().enumerate() {
            let Some((symbol, span)) = declaration.name else { continue };
            let own = active.module.name(active.text, symbol);
            let name =
                if prefix.is_empty() { Cow::Borrowed(own) } else { Cow::Owned(format!("{prefix}_{own}")) };
            let global = Global { instance: instance as u32, declaration: index as u32 };
            let at = (self.graph.file(instance), span);
            let has_uniform = !self.declarations.parameters.is_empty();
            let is_ours = has_uniform && (*name == *UNIFORM.0 || *name == *UNIFORM.1);
            let reserved = is_ours.then(|| name.to_string());
            match self.table.entry(name) {
                std::collections::hash_map::Entry::Vacant(slot) => drop(slot.insert(global)),
                std::collections::hash_map::Entry::Occupied(taken) => {
                    let name = taken.key().to_string();
                    let first = *taken.get();
                    let first = self.place(first);
                    const HELP: &str =
                        "rename one of them, or include one of the fragments `as` a name of its own";
                    errors.push(ComposeError::Duplicate { name, at, first, help: HELP });
                }
            }
            if let Some(name) = reserved {
                errors.push(ComposeError::Reserved { name, at });
            }
        }
    }

    /// With a prefix, a name may become one of WGSL's own.
    fn check_prefixed(&self, errors: &mut Vec<ComposeError>) {
        if self.prefix.is_empty() {
            return;
        }
        let (parameters, options) = self.declarations.in_code();
        let globals = self.table.iter().map(|(name, global)| (name.to_string(), self.place(*global)));
        let parameters = parameters.iter().map(|p| (p.decl.key.flat(), (p.file, p.span)));
        let options = options.iter().map(|o| (o.decl.key.flat(), (o.file, o.span)));
        let slots = self.open_slots().into_iter();
        let slots =
            slots.map(|(root, slot)| (slot.name.value.clone(), (self.graph.file(root), slot.name.span)));
        let all = globals.chain(parameters).chain(options).chain(slots);
        let mut taken: Vec<_> = all.filter(|(name, _)| is_reserved(&self.prefix.before(name))).collect();
        taken.sort_unstable_by_key(|(_, (file, span))| (*file, span.start)); // tables have no order
        errors.extend(taken.into_iter().take(ENOUGH).map(|(name, at)| ComposeError::PrefixTaken {
            prefix: self.prefix.to_string(),
            becomes: self.prefix.before(&name),
            name,
            at,
        }));
    }

    /// What the host sees of a parameter, `group_name`, is a name of module scope too.
    fn check_flat_names(&self, errors: &mut Vec<ComposeError>) {
        const HELP: &str = "the host sees the parameter under this name; rename one of the two";
        const IN_GROUP: &str =
            "parameters are read as `group.name`, and this is the name of a group; rename one";
        let (parameters, options) = self.declarations.in_code();
        let in_group = parameters.iter().map(|p| (&p.decl.key.group, (p.file, p.span)));
        let also = options.iter().map(|o| (&o.decl.key.group, (o.file, o.span)));
        let mut groups = FxHashSet::default();
        for (group, first) in in_group.chain(also) {
            if groups.insert(group)
                && let Some(global) = self.table.get(group.as_str())
            {
                let (name, at) = (group.clone(), self.place(*global));
                errors.push(ComposeError::Duplicate { name, at, first, help: IN_GROUP });
            }
        }
        let mut flat: FxHashMap<String, At> = FxHashMap::default();
        let parameters = parameters.iter().flat_map(|p| {
            let flat = p.decl.key.flat();
            // As an override, a vector is one scalar a component.
            let parts = ["_x", "_y", "_z", "_w"].into_iter().take(p.decl.ty.components());
            let parts: Vec<_> =
                parts.filter(|_| p.decl.ty.components() > 1).map(|part| format!("{flat}{part}")).collect();
            std::iter::once(flat).chain(parts).map(|name| (name, (p.file, p.span)))
        });
        let options = options.iter().map(|o| (o.decl.key.flat(), (o.file, o.span)));
        for (name, at) in parameters.chain(options) {
            if let Some(global) = self.table.get(name.as_str()) {
                let other = self.place(*global);
                errors.push(ComposeError::Duplicate { name: name.clone(), at: other, first: at, help: HELP });
            }
            if let Some(first) = flat.insert(name.clone(), at) {
                errors.push(ComposeError::Duplicate { name, at, first, help: HELP });
            }
        }
    }

    /// Where a declaration's name stands.
    pub(super) fn place(&self, global: Global) -> At {
        let declaration = self.declaration(global);
        let span = declaration.name.map_or(declaration.span, |(_, span)| span);
        (self.graph.file(global.instance as usize), span)
    }

    /// What its author calls a declaration; none where it has no name.
    pub(super) fn own_name(&self, global: Global) -> Option<&'a str> {
        let active = self.active[global.instance as usize].as_ref()?;
        let (symbol, _) = self.declaration(global).name?;
        Some(active.module.name(active.text, symbol))
    }

    pub(super) fn declaration(&self, global: Global) -> &'a Declaration {
        let active = self.active[global.instance as usize].as_ref();
        // Only active instances are in the table.
        &active.map_or(&*EMPTY, |active| active.module).declarations[global.declaration as usize]
    }

    fn fill_slots(&mut self, errors: &mut Vec<ComposeError>) {
        let mut filled_by: FxHashMap<usize, (usize, usize)> = FxHashMap::default();
        // Includers come after those that they include: from the back, each finds its own slots filled.
        for position in (0..self.order.len()).rev() {
            let includer = self.order[position];
            for (directive, child) in self.graph.instances[includer].includes.clone() {
                let is_active =
                    self.active[includer].as_ref().is_some_and(|active| active.directives[directive]);
                let Some(include) = self.graph.include(includer, directive) else { continue };
                if !is_active {
                    continue;
                }
                let given = self.given(includer, include, child, errors);
                self.check_missing(includer, include, child, errors);
                match filled_by.get(&child).copied() {
                    None => {
                        filled_by.insert(child, (includer, directive));
                        if !given.is_empty() {
                            self.slots.insert(child as u32, given.into_iter().collect());
                        }
                    }
                    Some(first) => {
                        let known = self.slots.get(&(child as u32));
                        let same = given
                            .iter()
                            .all(|(slot, meaning)| known.and_then(|known| known.get(slot)) == Some(meaning));
                        if !same {
                            errors.push(self.conflict(includer, include, child, first));
                        }
                    }
                }
            }
        }
    }

    fn slots_of(&self, instance: usize) -> Vec<&'a Slot> {
        let Some(active) = &self.active[instance] else { return Vec::new() };
        let directives = &self.graph.fragment(instance).directives;
        let in_fragment = self.slots_in[self.graph.instances[instance].loaded].iter();
        in_fragment
            .filter(|index| active.directives[**index])
            .filter_map(|index| match &directives[*index].directive.kind {
                DirectiveKind::Slot(slot) => Some(slot),
                _ => None,
            })
            .collect()
    }

    fn fragment_name(&self, instance: usize) -> String {
        let loaded = &self.graph.loaded[self.graph.instances[instance].loaded];
        let prefix = &self.graph.instances[instance].prefix;
        let name = &loaded.source.name;
        if prefix.is_empty() { name.to_string() } else { format!("{name} as {prefix}") }
    }

    fn conflict(
        &self,
        includer: usize,
        include: &Include,
        child: usize,
        first: (usize, usize),
    ) -> ComposeError {
        let first_span =
            self.graph.include(first.0, first.1).map_or(include.path.span, |include| include.path.span);
        ComposeError::SlotConflict {
            fragment: self.fragment_name(child),
            at: (self.graph.file(includer), include.path.span),
            first: (self.graph.file(first.0), first_span),
        }
    }

    fn check_missing(
        &self,
        includer: usize,
        include: &Include,
        child: usize,
        errors: &mut Vec<ComposeError>,
    ) {
        for slot in self.slots_of(child) {
            if !include.with.iter().any(|(name, _)| name.value == slot.name.value) {
                errors.push(ComposeError::SlotMissing {
                    slot: slot.name.value.clone(),
                    fragment: self.fragment_name(child),
                    signature: slot.signature.to_string(),
                    at: (self.graph.file(includer), include.path.span),
                    declared: (self.graph.file(child), slot.name.span),
                });
            }
        }
    }

    /// What an include gives to the slots of `child`.
    fn given(
        &self,
        includer: usize,
        include: &Include,
        child: usize,
        errors: &mut Vec<ComposeError>,
    ) -> Vec<(String, Meaning)> {
        let slots = self.slots_of(child);
        let mut given = Vec::new();
        for (name, target) in &include.with {
            let at = (self.graph.file(includer), target.span);
            let Some(slot) = slots.iter().find(|slot| slot.name.value == name.value) else {
                let names: Vec<_> = slots.iter().map(|slot| slot.name.value.as_str()).collect();
                let has = if names.is_empty() { "no slots".into() } else { choices(names) };
                errors.push(ComposeError::SlotUnknown {
                    slot: name.value.clone(),
                    fragment: self.fragment_name(child),
                    slots: has,
                    at: (self.graph.file(includer), name.span),
                });
                continue;
            };
            let meaning = match self.find(includer, &target.value) {
                Meaning::Global(global) => Meaning::Renamed(Some(global), target.value.as_str().into()),
                Meaning::Foreign if is_builtin_function(&target.value) => {
                    Meaning::Renamed(None, target.value.as_str().into())
                }
                renamed @ Meaning::Renamed(..) => renamed,
                Meaning::OpenSlot => Meaning::Renamed(None, self.prefix.before(&target.value).into()),
                _ => {
                    let names = self.table.keys().map(AsRef::as_ref).filter(|_| errors.len() < ENOUGH);
                    let nearest = nearest(&target.value, names);
                    errors.push(ComposeError::SlotTarget {
                        target: target.value.clone(),
                        slot: name.value.clone(),
                        nearest,
                        at,
                    });
                    continue;
                }
            };
            if let Meaning::Renamed(Some(global), _) = &meaning
                && let Err(found) = self.fits(*global, child, &slot.signature)
            {
                errors.push(ComposeError::SlotType {
                    target: target.value.clone(),
                    slot: name.value.clone(),
                    expected: slot.signature.to_string(),
                    found,
                    at,
                    declared: (self.graph.file(child), slot.signature_span),
                    target_at: self.place(*global),
                });
            }
            given.push((name.value.clone(), meaning));
        }
        given
    }

    /// Whether a declaration is a function of that signature; else what it is.
    ///
    /// `owner` is the instance whose slot it is: types are compared by what they are called in the result.
    fn fits(&self, global: Global, owner: usize, expected: &Signature) -> Result<(), String> {
        let declaration = self.declaration(global);
        let text = self.active[global.instance as usize].as_ref().map_or("", |active| active.text);
        if declaration.kind != DeclarationKind::Function {
            return Err("no function".into());
        }
        let Some(found) = signature(&text[declaration.span.range()]) else {
            return Err("no function".into());
        };
        let same = self.spelled(&found, global.instance as usize) == self.spelled(expected, owner);
        if same { Ok(()) } else { Err(format!("`{found}`")) }
    }

    /// A signature as the result spells it, seen from `instance`.
    pub(super) fn spelled(&self, signature: &Signature, instance: usize) -> Signature {
        Signature {
            takes: signature.takes.iter().map(|ty| self.plain(ty, instance, 0)).collect(),
            gives: signature.gives.as_ref().map(|ty| self.plain(ty, instance, 0)),
        }
    }

    /// A type as the result spells it, seen from `instance`: names of instances in full, aliases followed (a few steps at
    /// most).
    fn plain(&self, ty: &str, instance: usize, depth: usize) -> String {
        let tokens = lex(ty);
        let mut text = String::new();
        for (kind, span) in tokens.iter() {
            let word = &ty[span.range()];
            let meaning =
                if kind == TokenKind::Ident { self.look_up(instance, word) } else { Meaning::Foreign };
            match meaning {
                Meaning::Global(global) | Meaning::Renamed(Some(global), _) => {
                    let declaration = self.declaration(global);
                    let owner = global.instance as usize;
                    let source = self.active[owner].as_ref().map_or("", |active| active.text);
                    let is = source[declaration.span.range()]
                        .split_once('=')
                        .map(|(_, is)| is.trim_end_matches(';'));
                    match (is, meaning) {
                        (Some(is), _) if declaration.kind == DeclarationKind::Alias && depth < 16 => {
                            text.push_str(&self.plain(is, owner, depth + 1));
                        }
                        (_, Meaning::Renamed(_, name)) => text.push_str(&name),
                        _ => text.push_str(word),
                    }
                }
                _ => text.push_str(word),
            }
        }
        crate::syntax::plain_type(&text)
    }

    /// What `name` means in `instance`, and what it is called in the result.
    pub(super) fn look_up(&self, instance: usize, name: &str) -> Meaning {
        let meaning = self.find(instance, name);
        if self.prefix.is_empty() {
            return meaning;
        }
        match meaning {
            Meaning::Global(global) => Meaning::Renamed(Some(global), self.prefix.before(name).into()),
            Meaning::Renamed(Some(global), own) => {
                Meaning::Renamed(Some(global), self.prefix.before(&own).into())
            }
            Meaning::OpenSlot => Meaning::Renamed(None, self.prefix.before(name).into()),
            same => same,
        }
    }

    /// What `name` means in `instance`, the prefix left out.
    fn find(&self, instance: usize, name: &str) -> Meaning {
        if let Some(meaning) = self.slots.get(&(instance as u32)).and_then(|slots| slots.get(name)) {
            return meaning.clone();
        }
        let prefix = &self.graph.instances[instance].prefix;
        if !prefix.is_empty() {
            let own = format!("{prefix}_{name}");
            if let Some(global) =
                self.table.get(own.as_str()).filter(|global| self.is_within(**global, prefix))
            {
                return Meaning::Renamed(Some(*global), own.into());
            }
        }
        if let Some(global) = self.table.get(name) {
            return Meaning::Global(*global);
        }
        let renamed = &self.graph.instances[instance].renamed;
        if self.declarations.is_group_in_code(name)
            || renamed.as_ref().is_some_and(|(from, _)| from == name)
            || !prefix.is_empty() && self.declarations.is_group_in_code(&format!("{prefix}_{name}"))
        {
            return Meaning::Group;
        }
        if let Some(knob) = self.declarations.find(name) {
            return Meaning::Knob(knob);
        }
        if self.open.contains(&(instance, name)) {
            return Meaning::OpenSlot;
        }
        Meaning::Foreign
    }

    /// Whether a declaration belongs to the instance of that prefix, or to one that it includes `as` something: others may
    /// be called alike by chance.
    fn is_within(&self, global: Global, prefix: &str) -> bool {
        let owner = &*self.graph.instances[global.instance as usize].prefix;
        owner.strip_prefix(prefix).is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
    }

    /// Where `main_image` is declared, and what it is where it is not the scene contract's.
    pub(super) fn main_image(&self) -> Option<(At, Option<String>)> {
        let global = self.table.get("main_image")?;
        let contract = Signature { takes: vec!["vec2f".into()], gives: Some("vec4f".into()) };
        Some((self.place(*global), self.fits(*global, global.instance as usize, &contract).err()))
    }

    /// The slots of the root fragments, which nobody fills.
    pub(super) fn open_slots(&self) -> Vec<(usize, &'a Slot)> {
        let roots = self.graph.roots.iter();
        roots.flat_map(|root| self.slots_of(*root).into_iter().map(move |slot| (*root, slot))).collect()
    }

    /// The parameter or option that `reference`, whose name is a group, stands for, if there is one.
    pub(super) fn find_member(&self, instance: usize, reference: &Reference) -> Option<Knob> {
        let active = self.active[instance].as_ref()?;
        let group = active.module.name(active.text, reference.symbol);
        let member = active.module.name(active.text, reference.member?.0);
        let renamed = self.graph.instances[instance].renamed.as_ref();
        let own = renamed.filter(|(from, _)| from == group).map(|(_, to)| format!("{to}.{member}"));
        let prefix = &self.graph.instances[instance].prefix;
        // An instance of its own has its parameters below its own prefix.
        let inner = (!prefix.is_empty()).then(|| format!("{prefix}_{group}.{member}"));
        let found = own.and_then(|own| self.declarations.find(&own));
        let found = found.or_else(|| self.declarations.find(&inner?));
        found.or_else(|| self.declarations.find(&format!("{group}.{member}")))
    }

    /// As [`Names::find_member`], with what is wrong where there is none.
    pub(super) fn member(&self, instance: usize, reference: &Reference) -> Result<Knob, ComposeError> {
        let Some(active) = &self.active[instance] else { return Ok(Knob::Parameter(0)) };
        let name = |symbol: Symbol| active.module.name(active.text, symbol);
        let group = name(reference.symbol);
        let file = self.graph.file(instance);
        let Some((member, member_span)) = reference.member else {
            return Err(ComposeError::GroupAsValue { group: group.into(), at: (file, reference.span) });
        };
        let at = (file, reference.span.to(member_span));
        if let Some(knob) = self.find_member(instance, reference) {
            return self.readable(knob, at);
        }
        let key = format!("{group}.{}", name(member));
        // In an instance, the group has another name than in its fragment.
        let renamed = self.graph.instances[instance].renamed.as_ref();
        let here = renamed.filter(|(from, _)| from == group).map_or(group, |(_, to)| to);
        let in_group =
            self.declarations.keys().filter_map(|known| known.strip_prefix(here)?.strip_prefix('.'));
        let near = nearest(name(member), in_group)
            .map(|near| format!("{group}.{near}"))
            .or_else(|| nearest(&key, self.declarations.keys()));
        Err(ComposeError::UnknownMember { key, nearest: near, at })
    }

    /// A choice among names has no value in code.
    pub(super) fn readable(&self, knob: Knob, at: At) -> Result<Knob, ComposeError> {
        if let Knob::Option(index) = knob
            && let OptionKind::Choice(_) = self.declarations.options[index].decl.kind
        {
            let key = self.declarations.options[index].decl.key.to_string();
            return Err(ComposeError::ChoiceInCode { key, at, declared: self.declarations.place(knob) });
        }
        Ok(knob)
    }

    /// The identifier that `knob` has in the result.
    pub(super) fn flat(&self, knob: Knob) -> String {
        match knob {
            Knob::Parameter(index) => {
                self.prefix.before(&self.declarations.parameters[index].decl.key.flat())
            }
            Knob::Option(index) => self.prefix.before(&self.declarations.options[index].decl.key.flat()),
        }
    }
}

static EMPTY: std::sync::LazyLock<Module> = std::sync::LazyLock::new(Module::default);
