//! What was read once need not be read again: parsed fragments and their splits, kept by content.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use crate::source::Source;
use crate::syntax::{Fragment, Module, parse_fragment, split};

/// How many ways of deciding one file's conditions are kept.
const MAX_SPLITS: usize = 16;

/// Parsed fragments. Hand the same one to several compositions, and only what changed is read again.
#[derive(Debug, Default)]
pub struct Cache {
    entries: FxHashMap<Arc<str>, Entry>,
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
        let module = Arc::new(split(fragment, truth));
        if entry.splits.len() >= MAX_SPLITS {
            entry.splits.remove(0);
        }
        entry.splits.push((truth.to_vec(), module.clone()));
        module
    }
}
