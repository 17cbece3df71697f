//! What was read once need not be read again: parsed fragments and their splits, kept by content.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::select::{Basis, Selection};
use crate::source::Source;
use crate::syntax::{Fragment, Module, parse_fragment, split};

/// How many ways of deciding one file's conditions are kept.
const MAX_SPLITS: usize = 16;

/// How many selections are kept: a host composes a few shaders in turn.
const MAX_SELECTIONS: usize = 8;

/// Parsed fragments, and what was selected of them. Hand the same one to several compositions, and only what changed is done
/// again.
#[derive(Debug, Default)]
pub struct Cache {
    entries: FxHashMap<Arc<str>, Entry>,
    /// The latest last.
    selections: Vec<(Basis, Arc<Selection>)>,
    work: Work,
}

/// How often what was done, since the beginning.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Fragments that were read: lexed, and their directives parsed.
    pub fragments: usize,
    /// Fragments that were split into declarations, their conditions decided.
    pub splits: usize,
    /// Compositions whose names were resolved and whose declarations were shaken.
    pub selections: usize,
}

#[derive(Debug)]
struct Entry {
    fragment: Arc<Fragment>,
    splits: Vec<(Vec<bool>, Arc<Module>)>,
}

impl Cache {
    /// The fragment in `source`, read anew only where its text has changed.
    pub(super) fn fragment(&mut self, source: &Source) -> Arc<Fragment> {
        if let Some(entry) = self.entries.get(&source.identity)
            && (Arc::ptr_eq(&entry.fragment.text, &source.text) || entry.fragment.text == source.text)
        {
            return entry.fragment.clone();
        }
        self.work.fragments += 1;
        let fragment = Arc::new(parse_fragment(source.text.clone()));
        let entry = Entry { fragment: fragment.clone(), splits: Vec::new() };
        self.entries.insert(source.identity.clone(), entry);
        fragment
    }

    /// The declarations of `fragment`, which came from `source`, with its conditions decided.
    pub(super) fn split(&mut self, source: &Source, fragment: &Arc<Fragment>, truth: &[bool]) -> Arc<Module> {
        let Some(entry) = self.entries.get_mut(&source.identity) else {
            return Arc::new(split(fragment, truth));
        };
        if let Some((_, module)) = entry.splits.iter().find(|(known, _)| known == truth) {
            return module.clone();
        }
        self.work.splits += 1;
        let module = Arc::new(split(fragment, truth));
        if entry.splits.len() >= MAX_SPLITS {
            entry.splits.remove(0);
        }
        entry.splits.push((truth.to_vec(), module.clone()));
        module
    }

    /// What was selected on this basis before.
    pub(super) fn selection(&self, basis: &Basis) -> Option<Arc<Selection>> {
        let known = self.selections.iter().find(|(known, _)| known == basis)?;
        Some(known.1.clone())
    }

    /// Keeps what was selected.
    pub(super) fn keep_selection(&mut self, basis: Basis, selection: Arc<Selection>) {
        self.work.selections += 1;
        if self.selections.len() >= MAX_SELECTIONS {
            self.selections.remove(0);
        }
        self.selections.push((basis, selection));
    }

    /// How often what was done.
    pub fn work(&self) -> Work {
        self.work
    }
}
