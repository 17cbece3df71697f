//! naga's errors, told at the place in the author's file.

use std::error::Error as _;

use naga::front::wgsl::ParseError;
use naga::valid::ValidationError;
use naga::{Span as NagaSpan, WithSpan};

use crate::bake::Baked;
use crate::diagnostic::{Diagnostic, nearest};
use crate::source::Span;
use crate::syntax::{TokenKind, lex};

pub(super) fn parse_error(baked: &Baked, error: &ParseError) -> Diagnostic {
    let mut diagnostic = Diagnostic::error("OR0701", error.message());
    let labels: Vec<_> = error.labels().map(|(span, label)| (span, label.to_owned())).collect();
    diagnostic = place(baked, diagnostic, &labels);
    diagnostic = diagnostic.notes(error.notes().map(str::to_owned));
    let unknown = error.message().strip_prefix("no definition in scope for identifier: ");
    if let Some(name) = unknown.map(|name| name.trim_matches(['`', '\''])) {
        diagnostic = diagnostic.help(near_name(baked, name).map(|near| format!("did you mean `{near}`?")));
    }
    diagnostic
}

pub(super) fn validation_error(baked: &Baked, error: &WithSpan<ValidationError>) -> Diagnostic {
    // The innermost reason says what is wrong; the outer ones, in naga's numbers, where.
    let mut reasons = vec![error.as_inner().to_string()];
    let mut source = error.as_inner().source();
    while let Some(inner) = source {
        reasons.push(inner.to_string());
        source = inner.source();
    }
    let message = reasons.pop().unwrap_or_default();
    let mut diagnostic = Diagnostic::error("OR0702", message);
    let labels: Vec<_> = error.spans().map(|(span, label)| (*span, label.clone())).collect();
    diagnostic = place(baked, diagnostic, &labels);
    diagnostic.notes(reasons)
}

/// Labels at the authors' places, the first as the primary one, and how its file was reached.
fn place(baked: &Baked, mut diagnostic: Diagnostic, labels: &[(NagaSpan, String)]) -> Diagnostic {
    let mut chain = None;
    for (span, label) in labels {
        let Some(range) = span.to_range() else { continue };
        let Some(origin) = baked.map.origin(Span::new(range.start, range.end)) else { continue };
        let is_first = diagnostic.labels.is_empty();
        let twice =
            diagnostic.labels.iter().any(|known| known.file == origin.file && known.span == origin.span);
        if is_first {
            chain = origin.instance;
            diagnostic = diagnostic.at(origin.file, origin.span, label);
        } else if !twice {
            diagnostic = diagnostic.and(origin.file, origin.span, label);
        }
    }
    let notes = chain.map(|instance| baked.composition.chain(instance as usize)).unwrap_or_default();
    diagnostic.notes(notes)
}

/// The identifier of the text nearest to `name`, among those that something declares.
fn near_name(baked: &Baked, name: &str) -> Option<String> {
    let text = &baked.text;
    let tokens = lex(text);
    let mut declared = Vec::new();
    let mut after_keyword = false;
    for (kind, span) in tokens.iter().filter(|(kind, _)| !kind.is_trivia()) {
        let word = &text[span.range()];
        if kind == TokenKind::Ident && after_keyword && word != name {
            declared.push(word);
        }
        after_keyword = matches!(word, "fn" | "struct" | "const" | "override" | "var" | "alias" | "let")
            || after_keyword
                && matches!(kind, TokenKind::TemplateOpen | TokenKind::TemplateClose | TokenKind::Comma)
            || after_keyword && matches!(word, "private" | "storage" | "uniform" | "workgroup" | "read");
    }
    nearest(name, declared)
}
