//! The include graph: from the root fragments to every instance that any branch can reach.
//!
//! An instance is a file together with a prefix: included plainly, the prefix is empty and the file is shared by all; as
//! `NAME`, the prefix is `NAME`, below that of the includer. The walk keeps its own stack: depth costs no recursion.

use std::sync::Arc;

use rustc_hash::{FxHashMap, FxHashSet};

use super::cache::Cache;
use super::error::{At, ComposeError};
use crate::diagnostic::{ENOUGH, nearest};
use crate::preset::{Declarations, Declared};
use crate::source::{FileId, Files, Library, Source, SourceError, Span};
use crate::syntax::{DirectiveKind, Fragment, Include};

/// How deep includes may nest.
const MAX_DEPTH: usize = 1024;
/// How many instances there may be.
const MAX_INSTANCES: usize = 65_536;
/// How many MiB all instances may hold together.
const MAX_MIB: usize = 256;

/// A file that was read.
pub(super) struct Loaded {
    pub(super) source: Source,
    pub(super) file: FileId,
    pub(super) fragment: Arc<Fragment>,
}

/// An instance of a file.
pub(super) struct Instance {
    /// Which of [`Graph::loaded`].
    pub(super) loaded: usize,
    /// Empty where the file was included plainly.
    pub(super) prefix: Arc<str>,
    /// Who included it first, and by which of its directives; none for a root.
    pub(super) parent: Option<(usize, usize)>,
    /// Whom it includes: its directive, and the instance.
    pub(super) includes: Vec<(usize, usize)>,
    /// Its fragment's own group, and what the group is called in this instance.
    pub(super) renamed: Option<(String, Arc<str>)>,
}

/// Every file and instance that any branch can reach.
#[derive(Default)]
pub(super) struct Graph {
    pub(super) loaded: Vec<Loaded>,
    pub(super) instances: Vec<Instance>,
    /// The instances that are in for their own sake.
    pub(super) roots: Vec<usize>,
    /// The one root whose entry points count, where the others' do not.
    pub(super) only_from: Option<usize>,
    /// From which instance on they are there for their declarations only, and the scene that they are there for.
    aside: Option<(usize, usize)>,
    by_identity: FxHashMap<Arc<str>, usize>,
    by_prefix: FxHashMap<(usize, Arc<str>), usize>,
    /// What `<path>` has found.
    by_path: FxHashMap<String, usize>,
    /// The size of all instances.
    bytes: usize,
}

impl Graph {
    /// Goes from `root` to everything that it includes.
    pub(super) fn add_root(
        &mut self,
        root: Source,
        library: &Library,
        cache: &mut Cache,
        files: &mut Files,
        errors: &mut Vec<ComposeError>,
    ) -> usize {
        let loaded = self.load(root, cache, files, errors);
        let (root, is_new) = self.instance(loaded, "".into(), None);
        self.roots.push(root);
        if !is_new {
            return root; // another root has led here
        }
        let mut path = vec![(root, 0)];
        while let Some((instance, next)) = path.last_mut() {
            let (instance, directive) = (*instance, *next);
            *next += 1;
            let loaded = self.instances[instance].loaded;
            let fragment = self.loaded[loaded].fragment.clone();
            let Some(placed) = fragment.directives.get(directive) else {
                path.pop();
                continue;
            };
            let DirectiveKind::Include(include) = &placed.directive.kind else { continue };
            let at = (self.loaded[loaded].file, include.path.span);
            let known = self.by_path.get(&include.path.value).copied().filter(|_| !include.beside);
            let target =
                match known.map_or_else(|| self.find(include, loaded, library, at).map(Err), |k| Ok(Ok(k))) {
                    Ok(Ok(known)) => known,
                    Ok(Err(source)) => self.load(source, cache, files, errors),
                    Err(error) => {
                        errors.push(error);
                        if errors.len() >= ENOUGH {
                            return root; // a whole library is missing: more of the same would say nothing
                        }
                        continue;
                    }
                };
            if !include.beside {
                self.by_path.insert(include.path.value.clone(), target);
            }
            let prefix = match &include.instance {
                None => "".into(),
                Some(name) if self.instances[instance].prefix.is_empty() => name.value.as_str().into(),
                Some(name) => format!("{}_{}", self.instances[instance].prefix, name.value).into(),
            };
            let (child, is_new) = self.instance(target, prefix, Some((instance, directive)));
            self.instances[instance].includes.push((directive, child));
            if is_new {
                if let Some(error) = self.over_a_limit(path.len(), at) {
                    errors.push(error);
                    return root;
                }
                path.push((child, 0));
            }
        }
        root
    }

    /// Goes from `scene` to everything that it includes for the sake of what can be set there: nothing of it comes in but
    /// what a root includes too. To be called after all roots are added.
    pub(super) fn add_aside(
        &mut self,
        scene: Source,
        library: &Library,
        cache: &mut Cache,
        files: &mut Files,
        errors: &mut Vec<ComposeError>,
    ) {
        let from = self.instances.len();
        let scene = self.add_root(scene, library, cache, files, errors);
        self.aside = Some((from, scene));
        self.roots.pop();
    }

    /// The files of the scene in whose place a view is drawn: of the branches that `active` tells, or of all; none where no
    /// scene stands aside.
    pub(super) fn files_aside(&self, active: Option<&[Vec<bool>]>) -> Option<FxHashSet<FileId>> {
        let (_, scene) = self.aside?;
        let mut files = FxHashSet::default();
        let mut seen = vec![false; self.instances.len()];
        let mut ahead = vec![scene];
        while let Some(instance) = ahead.pop() {
            if !std::mem::replace(&mut seen[instance], true) {
                files.insert(self.file(instance));
                let includes = self.instances[instance].includes.iter();
                let is_in = |directive: usize| active.is_none_or(|active| active[instance][directive]);
                ahead.extend(includes.filter(|(directive, _)| is_in(*directive)).map(|(_, child)| *child));
            }
        }
        Some(files)
    }

    fn over_a_limit(&self, depth: usize, at: At) -> Option<ComposeError> {
        if depth >= MAX_DEPTH {
            Some(ComposeError::TooDeep { limit: MAX_DEPTH, at })
        } else if self.instances.len() > MAX_INSTANCES {
            Some(ComposeError::TooMany { limit: MAX_INSTANCES, at })
        } else if self.bytes > MAX_MIB << 20 {
            Some(ComposeError::TooLarge { limit: MAX_MIB, at })
        } else {
            None
        }
    }

    fn find(
        &self,
        include: &Include,
        from: usize,
        library: &Library,
        at: At,
    ) -> Result<Source, ComposeError> {
        let path = &include.path.value;
        let found = if include.beside {
            library.find_beside(&self.loaded[from].source, path)
        } else {
            library.find(path)
        };
        found.map_err(|error| ComposeError::Include { nearest: nearest_path(&error, library), error, at })
    }

    fn load(
        &mut self,
        source: Source,
        cache: &mut Cache,
        files: &mut Files,
        errors: &mut Vec<ComposeError>,
    ) -> usize {
        if let Some(known) = self.by_identity.get(&source.identity) {
            return *known;
        }
        let fragment = cache.fragment(&source);
        let file = files.add_read(source.name.clone(), source.text.clone(), source.on_disk.clone());
        errors.extend(fragment.errors.iter().map(|error| ComposeError::Directive(file, error.clone())));
        let index = self.loaded.len();
        self.by_identity.insert(source.identity.clone(), index);
        self.loaded.push(Loaded { source, file, fragment });
        index
    }

    fn instance(&mut self, loaded: usize, prefix: Arc<str>, parent: Option<(usize, usize)>) -> (usize, bool) {
        let next = self.instances.len();
        let index = *self.by_prefix.entry((loaded, prefix.clone())).or_insert(next);
        if index == next {
            // Every name may carry the prefix, and prefixes grow with depth.
            let fragment = &self.loaded[loaded].fragment;
            self.bytes += fragment.text.len() + prefix.len() * (fragment.tokens / 2 + 1);
            self.instances.push(Instance { loaded, prefix, parent, includes: Vec::new(), renamed: None });
        }
        (index, index == next)
    }

    /// The file of an instance.
    pub(super) fn file(&self, instance: usize) -> FileId {
        self.loaded[self.instances[instance].loaded].file
    }

    /// The fragment of an instance.
    pub(super) fn fragment(&self, instance: usize) -> &Arc<Fragment> {
        &self.loaded[self.instances[instance].loaded].fragment
    }

    /// The place of the include that first reached an instance.
    pub(super) fn included_at(&self, instance: usize) -> Option<At> {
        let (parent, directive) = self.instances[instance].parent?;
        Some((self.file(parent), self.fragment(parent).directives[directive].directive.span))
    }

    /// The include directive numbered `directive` of an instance.
    pub(super) fn include(&self, instance: usize, directive: usize) -> Option<&Include> {
        match &self.fragment(instance).directives[directive].directive.kind {
            DirectiveKind::Include(include) => Some(include),
            _ => None,
        }
    }

    /// The instances that are in when `active` tells which directives are, each after those that it includes.
    ///
    /// From here on, an instance's parent is whoever brings it in: a branch that is off has no part in it.
    pub(super) fn order(&mut self, active: &[Vec<bool>]) -> Vec<usize> {
        let mut order = Vec::with_capacity(self.instances.len());
        let mut seen = vec![false; self.instances.len()];
        for root in self.roots.clone() {
            if std::mem::replace(&mut seen[root], true) {
                continue;
            }
            let mut path = vec![(root, 0)];
            while let Some((instance, next)) = path.last_mut() {
                let Some((directive, child)) = self.instances[*instance].includes.get(*next).copied() else {
                    order.push(*instance);
                    path.pop();
                    continue;
                };
                *next += 1;
                if active[*instance][directive] && !std::mem::replace(&mut seen[child], true) {
                    self.instances[child].parent = Some((*instance, directive));
                    path.push((child, 0));
                }
            }
        }
        order
    }

    /// All parameters and options of all instances.
    pub(super) fn declarations(&mut self, errors: &mut Vec<ComposeError>) -> Declarations {
        let mut declarations = Declarations::default();
        for index in 0..self.instances.len() {
            if self.aside.is_some_and(|(from, _)| from == index) {
                declarations.close_to_code();
            }
            self.declare(index, &mut declarations, errors);
        }
        declarations
    }

    fn declare(&mut self, index: usize, declarations: &mut Declarations, errors: &mut Vec<ComposeError>) {
        let (fragment, file) = (self.fragment(index).clone(), self.file(index));
        let prefix = self.instances[index].prefix.clone();
        let mut own: Option<(String, Span)> = None;
        for placed in &fragment.directives {
            let (key, span) = match &placed.directive.kind {
                DirectiveKind::Param(decl) => (&decl.key, decl.key_span),
                DirectiveKind::Option(decl) => (&decl.key, decl.key_span),
                _ => continue,
            };
            let mut key = key.clone();
            if !prefix.is_empty() && !key.group.is_empty() {
                let (group, first) = own.get_or_insert_with(|| (key.group.clone(), span));
                if *group != key.group {
                    let at = self.included_at(index).unwrap_or((file, span));
                    let (first, second) = ((file, *first), (file, span));
                    errors.push(ComposeError::SeveralGroups { at, first, second });
                    return;
                }
                key.group = prefix.to_string();
            }
            let name = key.to_string();
            let shared = key.group.is_empty();
            let added = match placed.directive.kind.clone() {
                DirectiveKind::Param(decl) => declarations.add_parameter(Declared {
                    decl: crate::syntax::ParamDecl { key, ..decl },
                    file,
                    span,
                }),
                DirectiveKind::Option(decl) => declarations.add_option(Declared {
                    decl: crate::syntax::OptionDecl { key, ..decl },
                    file,
                    span,
                }),
                _ => Ok(()),
            };
            if let Err(first) = added
                && !(shared && first == (file, span))
            {
                const HELP: &str = "a parameter is declared once; include the file that declares it";
                errors.push(ComposeError::Duplicate { name, at: (file, span), first, help: HELP });
            }
        }
        self.instances[index].renamed = own.map(|(group, _)| (group, prefix));
    }

    /// How an instance was reached, innermost first: notes for a diagnostic.
    pub(super) fn chain(&self, instance: usize, files: &Files) -> Vec<String> {
        let mut notes = Vec::new();
        let mut current = instance;
        while let Some((parent, directive)) = self.instances[current].parent {
            let Some(include) = self.include(parent, directive) else { break };
            let file = files.get(self.file(parent));
            let place = file.place(self.fragment(parent).directives[directive].directive.span.start as usize);
            let at = format!("{}:{}:{}", file.name, place.line, place.column);
            let name = &files.get(self.file(current)).name;
            let with: Vec<_> = include
                .with
                .iter()
                .map(|(slot, target)| format!("{} = {}", slot.value, target.value))
                .collect();
            let with = if with.is_empty() { String::new() } else { format!(" with {}", with.join(", ")) };
            let prefix = &self.instances[current].prefix;
            let named = if prefix.is_empty() { String::new() } else { format!(" as `{prefix}`") };
            notes.push(format!("`{name}`{named}{with} is included at {at}"));
            if notes.len() == 16 {
                notes.push("…".into());
                break;
            }
            current = parent;
        }
        notes
    }
}

/// The library's path that was probably meant.
pub(super) fn nearest_path(error: &SourceError, library: &Library) -> Option<String> {
    let SourceError::NotFound { path, .. } = error else { return None };
    let modules = library.modules();
    let same_name = || {
        let name = path.rsplit('/').next()?;
        modules.iter().find(|module| module.rsplit('/').next() == Some(name)).cloned()
    };
    nearest(path, modules.iter().map(String::as_str)).or_else(same_name)
}
