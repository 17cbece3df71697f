//! Text → the certainty that it is one expression: nothing in it can end the statement that it is put into.

use super::error::SampleError;
use crate::source::Span;
use crate::syntax::{TokenKind, lex};

/// Refuses what is no part of an expression: statements, blocks, directives, brackets and comments that are left open.
pub(super) fn check(text: &str) -> Result<(), SampleError> {
    let fault =
        |why: &str, span| Err(SampleError::Expression { why: why.to_owned(), text: text.to_owned(), span });
    let mut open: Vec<(TokenKind, Span)> = Vec::new();
    let mut is_empty = true;
    for (kind, span) in lex(text).iter() {
        use TokenKind as K;
        match kind {
            K::Semicolon => return fault("`;` ends a statement, and this is an expression", span),
            K::BraceOpen | K::BraceClose => return fault("a block is no part of an expression", span),
            K::Directive => return fault("a directive is no part of an expression", span),
            K::BlockComment if !is_closed(&text[span.range()]) => {
                return fault("this comment is not closed", Span { end: span.start + 2, ..span });
            }
            K::ParenOpen | K::BracketOpen => open.push((kind, span)),
            K::ParenClose | K::BracketClose => {
                let partner = if kind == K::ParenClose { K::ParenOpen } else { K::BracketOpen };
                match open.pop() {
                    Some((opener, _)) if opener == partner => {}
                    Some(_) => return fault("this bracket closes one of another kind", span),
                    None => return fault("this bracket closes nothing", span),
                }
            }
            _ => {}
        }
        is_empty &= kind.is_trivia();
    }
    if let Some((_, span)) = open.pop() {
        return fault("this bracket is not closed", span);
    }
    if is_empty {
        return fault("there is no expression", Span::new(0, text.len()));
    }
    Ok(())
}

/// Whether a block comment ends where its text does: put before a `;`, it does not swallow it.
fn is_closed(comment: &str) -> bool {
    let behind = format!("{comment};");
    lex(&behind).iter().last().is_some_and(|(kind, _)| kind == TokenKind::Semicolon)
}
