//! Names in what naga writes: the author's, where naga would have spelled them otherwise.
//!
//! naga appends `_` to names that end in a digit, and numbers all names of a file through, so that the eighth `p` becomes
//! `p_8`. So every name goes through naga as a word that it leaves alone ([`hide`]), and afterwards each word becomes the
//! name that its author gave it, or the nearest one that the language has free ([`show`]).

use naga::Module;
use rustc_hash::{FxHashMap, FxHashSet};

/// A name on its way through naga.
pub(super) struct Word {
    name: String,
    scope: Scope,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Scope {
    Global,
    Function(usize),
    /// Of a struct's members, which stand behind a dot.
    Members(usize),
}

/// Around the number of a word. naga leaves names alone that are no keyword and end in a letter.
const MARKS: (&str, &str) = ("orogen", "n");

/// Replaces every name of `module` but those of its entry points.
pub(super) fn hide(module: &mut Module) -> Vec<Word> {
    let mut words = Vec::new();
    let mut word = |name: &str, scope| {
        words.push(Word { name: name.to_owned(), scope });
        format!("{}{}{}", MARKS.0, words.len() - 1, MARKS.1)
    };
    let types: Vec<_> = module.types.iter().map(|(handle, ty)| (handle, ty.clone())).collect();
    for (index, (handle, mut ty)) in types.into_iter().enumerate() {
        let Some(name) = ty.name.take() else { continue };
        ty.name = Some(word(&name, Scope::Global));
        if let naga::TypeInner::Struct { members, .. } = &mut ty.inner {
            for member in members {
                member.name = member.name.take().map(|name| word(&name, Scope::Members(index)));
            }
        }
        module.types.replace(handle, ty);
    }
    let globals = module.global_variables.iter_mut().map(|(_, variable)| &mut variable.name);
    let constants = module.constants.iter_mut().map(|(_, constant)| &mut constant.name);
    for name in globals.chain(constants) {
        *name = name.take().map(|name| word(&name, Scope::Global));
    }
    let entries = module.entry_points.iter_mut().map(|entry| &mut entry.function);
    for (index, function) in entries.chain(module.functions.iter_mut().map(|(_, f)| f)).enumerate() {
        function.name = function.name.take().map(|name| word(&name, Scope::Global));
        let arguments = function.arguments.iter_mut().map(|argument| &mut argument.name);
        for name in arguments.chain(function.local_variables.iter_mut().map(|(_, local)| &mut local.name)) {
            *name = name.take().map(|name| word(&name, Scope::Function(index)));
        }
        for (_, name) in &mut function.named_expressions {
            *name = word(name, Scope::Function(index));
        }
    }
    words
}

/// The names that words got.
pub(super) struct Shown {
    /// The text with them.
    pub(super) text: String,
    globals: FxHashMap<String, String>,
}

impl Shown {
    /// What the global `name` is called in the text; none where it does not occur.
    pub(super) fn global(&self, name: &str) -> Option<&str> {
        self.globals.get(name).map(String::as_str)
    }
}

/// Puts names in for the words in `text`. No name becomes one that `is_reserved`. `fixed` are naga's own names that become
/// others.
pub(super) fn show(
    text: &str,
    words: &[Word],
    is_reserved: impl Fn(&str) -> bool,
    fixed: &[(&str, &str)],
) -> Shown {
    let pieces = split(text);
    // What naga itself wrote, type names and built-in functions included.
    let mut taken: FxHashSet<&str> = fixed.iter().map(|(_, to)| *to).collect();
    let mut occurs = FxHashSet::default();
    for (index, (piece, is_name)) in pieces.iter().enumerate() {
        match marked(piece) {
            Some((number, _)) if *is_name => drop(occurs.insert(number)),
            _ if *is_name && !(index > 0 && pieces[index - 1].0.ends_with('.')) => drop(taken.insert(piece)),
            _ => {}
        }
    }
    let mut names = vec![String::new(); words.len()];
    let mut used: FxHashSet<(Scope, String)> = FxHashSet::default();
    let in_order = |locals: bool| {
        let wanted = move |(_, word): &(usize, &Word)| matches!(word.scope, Scope::Function(_)) == locals;
        words.iter().enumerate().filter(wanted)
    };
    // Globals first, so that it is the local that gives way.
    for (index, word) in in_order(false).chain(in_order(true)) {
        if !occurs.contains(&index) {
            continue;
        }
        let is_member = matches!(word.scope, Scope::Members(_));
        let is_local = matches!(word.scope, Scope::Function(_));
        let is_taken = |name: &String| {
            used.contains(&(word.scope, name.clone()))
                || !is_member && taken.contains(name.as_str())
                || is_local && used.contains(&(Scope::Global, name.clone()))
        };
        let is_free = |name: &String| !is_reserved(name) && !is_taken(name);
        let plain = sanitized(&word.name);
        let base = plain.trim_end_matches('_');
        let name = if is_free(&plain) {
            plain.clone()
        } else {
            // Before the first free number at the latest, there are more numbers than names.
            (1..=words.len() + taken.len() + 1)
                .map(|n| if n == 1 { format!("{base}_") } else { format!("{base}_{n}") })
                .find(is_free)
                .unwrap_or_else(|| format!("{base}_{index}_n"))
        };
        used.insert((word.scope, name.clone()));
        names[index] = name;
    }
    let mut shown = Shown { text: String::with_capacity(text.len()), globals: FxHashMap::default() };
    for (piece, is_name) in pieces {
        let fixed = fixed.iter().find(|(from, _)| is_name && *from == piece);
        match (marked(piece), fixed) {
            (Some((number, rest)), _) if is_name && number < names.len() => {
                shown.text.push_str(&names[number]);
                shown.text.push_str(rest);
            }
            (_, Some((_, to))) => shown.text.push_str(to),
            _ => shown.text.push_str(piece),
        }
    }
    let globals = words.iter().zip(&names).enumerate();
    let globals = globals.filter(|(index, (word, _))| word.scope == Scope::Global && occurs.contains(index));
    shown.globals = globals.map(|(_, (word, name))| (word.name.clone(), name.clone())).collect();
    shown
}

/// `orogen12n_block` → 12 and `_block`.
fn marked(piece: &str) -> Option<(usize, &str)> {
    let (number, rest) = piece.strip_prefix(MARKS.0)?.split_once(MARKS.1)?;
    Some((number.parse().ok()?, rest))
}

/// `text` in pieces, and of each whether it is an identifier.
fn split(text: &str) -> Vec<(&str, bool)> {
    let mut pieces = Vec::new();
    let mut rest = text;
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    while let Some(first) = rest.chars().next() {
        let is_name = first.is_ascii_alphabetic() || first == '_';
        let end = if is_word(first) {
            // A number takes its letters with it: `0x1fu`, `1e5`.
            rest.find(|c| !is_word(c))
        } else {
            rest.find(is_word)
        };
        let (piece, after) = rest.split_at(end.unwrap_or(rest.len()));
        pieces.push((piece, is_name));
        rest = after;
    }
    pieces
}

/// `name` in the letters that C-like languages have, without what they keep for themselves.
fn sanitized(name: &str) -> String {
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
    if plain.starts_with("gl_") || plain.starts_with(|c: char| c.is_ascii_digit()) || plain == "_" {
        plain.insert(0, 'n');
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_free_comes_back_and_one_that_is_not_gets_a_number() {
        let word = |name: &str, scope| Word { name: name.into(), scope };
        let words = [
            word("noise2", Scope::Global),
            word("float", Scope::Global),
            word("p", Scope::Function(0)),
            word("p", Scope::Function(0)),
            word("noise2", Scope::Function(1)),
            word("gl_höhe__1", Scope::Function(1)),
            word("float", Scope::Members(0)),
        ];
        let text = "float orogen0n(orogen2n, orogen3n, 1e5) { orogen1n.orogen6n; orogen4n_1 = orogen5n.xy; }";
        let shown = show(text, &words, |name| name == "float", &[]);
        let expected = "float noise2(p, p_, 1e5) { float_.float_; noise2__1 = ngl_hu00f6he_1.xy; }";
        assert_eq!(shown.text, expected);
        assert_eq!(shown.global("noise2"), Some("noise2"));
    }
}
