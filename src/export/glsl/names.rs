//! Names: the author's, but for those that GLSL, or what surrounds the shader, keeps for itself.
//!
//! A name gets one new spelling for the whole file, whatever it names: two that were different stay different, and one that
//! hid another still does.

use std::sync::LazyLock;

use rustc_hash::{FxHashMap, FxHashSet};

/// Keywords, reserved words and built-in functions of every version of GLSL.
static WORDS: LazyLock<FxHashSet<&str>> =
    LazyLock::new(|| include_str!("../glsl_words.txt").split_whitespace().collect());

/// Spelling of names.
#[derive(Debug, Default)]
pub(super) struct Names {
    /// Those that changed.
    renamed: FxHashMap<String, String>,
    /// All that are taken, old and new.
    taken: FxHashSet<String>,
}

impl Names {
    /// Spells `names`, none of them as one of `reserved`.
    pub(super) fn new<'a>(names: impl Iterator<Item = &'a str>, reserved: &[&str]) -> Self {
        let wanted: FxHashSet<&str> = names.collect();
        let is_free =
            |name: &str| !WORDS.contains(name) && !reserved.contains(&name) && !name.starts_with("wgsl_");
        let mut changing: Vec<&str> = Vec::new();
        let mut this = Self::default();
        for name in &wanted {
            if is_free(name) && plain(name) == **name {
                this.taken.insert((*name).to_owned());
            } else {
                changing.push(name);
            }
        }
        this.taken.extend(reserved.iter().map(|word| (*word).to_owned()));
        changing.sort_unstable(); // the same file, whatever the hash
        for name in changing {
            let base = plain(name);
            let fresh = if is_free(&base) { this.fresh_like(&base) } else { this.fresh(&base) };
            this.renamed.insert(name.to_owned(), fresh);
        }
        this
    }

    /// How `name` is spelled.
    pub(super) fn get<'n>(&'n self, name: &'n str) -> &'n str {
        self.renamed.get(name).map_or(name, String::as_str)
    }

    /// `base` itself, if nothing is called so.
    pub(super) fn fresh_like(&mut self, base: &str) -> String {
        if WORDS.contains(base) || self.taken.contains(base) {
            return self.fresh(base);
        }
        self.taken.insert(base.to_owned());
        base.to_owned()
    }

    /// A name like `base` that nothing has.
    pub(super) fn fresh(&mut self, base: &str) -> String {
        let base = base.trim_end_matches('_');
        let base = if base.is_empty() { "n" } else { base };
        let mut number = 1;
        loop {
            let name = if number == 1 { format!("{base}_") } else { format!("{base}_{number}") };
            if !WORDS.contains(name.as_str()) && self.taken.insert(name.clone()) {
                return name;
            }
            number += 1;
        }
    }

    /// Every name that changed, with its new spelling, in the order of the alphabet.
    pub(super) fn changes(self) -> Vec<(String, String)> {
        let mut changes: Vec<_> = self.renamed.into_iter().collect();
        changes.sort_unstable();
        changes
    }
}

/// `name` in the letters that GLSL has, without what it keeps for itself.
fn plain(name: &str) -> String {
    let mut plain = String::with_capacity(name.len());
    for c in name.chars() {
        if c == '_' && plain.ends_with('_') {
            continue; // two in a row are reserved
        }
        if c.is_ascii_alphanumeric() || c == '_' {
            plain.push(c);
        } else {
            plain.push_str(&format!("u{:04x}", u32::from(c)));
        }
    }
    // GLSL's own, its macros', and WebGL's.
    let is_theirs = ["gl_", "GL_", "webgl_", "_webgl_"].iter().any(|start| plain.starts_with(start));
    if is_theirs || plain == "_" {
        plain.insert(0, 'n');
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_free_stays_and_one_that_is_not_gets_the_nearest() {
        let names =
            Names::new(["noise2", "sample", "sample_", "gl_höhe__1", "iTime", "p_"].into_iter(), &["iTime"]);
        let spelled =
            ["noise2", "sample", "sample_", "gl_höhe__1", "iTime", "p_"].map(|name| names.get(name));
        assert_eq!(spelled, ["noise2", "sample_2", "sample_", "ngl_hu00f6he_1", "iTime_", "p_"]);
    }
}
