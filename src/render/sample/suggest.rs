//! An unknown name → where the library has it, or the name that was probably meant.

use crate::diagnostic::{Diagnostic, Error, nearest};
use crate::source::Library;
use crate::syntax::{TokenKind, lex};

/// What naga says of a name that nothing declares.
const UNKNOWN: &str = "no definition in scope for identifier: ";

/// `error`, with a help for each unknown name that has none: the fragment to include, or the nearest name of those that
/// are included. (What an expression does not use is shaken out before naga could know it.)
pub(super) fn helped(error: Error, library: &Library) -> Error {
    let is_helpless = |diagnostic: &&Diagnostic| diagnostic.help.is_none();
    if !error.diagnostics().iter().any(|diagnostic| is_helpless(&diagnostic) && unknown(diagnostic).is_some())
    {
        return error;
    }
    let helped = error.diagnostics().iter().map(|diagnostic| {
        let name = Some(diagnostic).filter(is_helpless).and_then(unknown);
        let help = name.and_then(|name| help(name, &error, library));
        if help.is_some() { diagnostic.clone().help(help) } else { diagnostic.clone() }
    });
    Error::new(helped.collect(), error.files().clone())
}

fn unknown(diagnostic: &Diagnostic) -> Option<&str> {
    Some(diagnostic.message.strip_prefix(UNKNOWN)?.trim_matches(['`', '\'']))
}

fn help(name: &str, error: &Error, library: &Library) -> Option<String> {
    for path in library.modules() {
        let source = library.find(&path).ok()?;
        if functions(&source.text).any(|function| function == name) {
            return Some(format!("`{name}` is in the library: `--include '<{path}>'`"));
        }
    }
    let included = error.files().iter().flat_map(|(_, file)| functions(&file.text));
    nearest(name, included).map(|near| format!("did you mean `{near}`?"))
}

/// The names of the functions that a text declares.
fn functions(text: &str) -> impl Iterator<Item = &str> {
    let tokens = lex(text);
    let words: Vec<_> = tokens
        .iter()
        .filter(|(kind, _)| !kind.is_trivia())
        .map(|(kind, span)| (kind, &text[span.range()]))
        .collect();
    let mut names = Vec::new();
    for pair in words.windows(2) {
        if let [(TokenKind::Ident, "fn"), (TokenKind::Ident, name)] = pair {
            names.push(*name);
        }
    }
    names.into_iter()
}
