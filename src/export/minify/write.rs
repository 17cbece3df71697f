//! WGSL without what nobody needs: tokens and their new names → text, and where each token of it is from.

use std::borrow::Cow;

use super::number;
use super::scopes::{Meaning, Scopes, Solid};
use super::short::Short;
use crate::source::Span;
use crate::syntax::TokenKind;

/// A token of the result.
pub(super) struct Placed {
    /// Where it stands in the result.
    pub(super) out: Span,
    /// Where it stood.
    pub(super) from: Span,
    /// Whether it is spelled as it was.
    pub(super) copied: bool,
}

/// The squeezed text, appended to `out`.
pub(super) fn write(
    text: &str,
    tokens: &[Solid],
    scopes: &Scopes<'_>,
    short: &Short,
    out: &mut String,
) -> Vec<Placed> {
    let mut placed = Vec::with_capacity(tokens.len());
    let mut previous: Option<(TokenKind, usize)> = None;
    let is_needed = needed(tokens);
    for (index, token) in tokens.iter().enumerate() {
        if !is_needed[index] {
            continue;
        }
        let old = &text[token.span.range()];
        let new = match scopes.meanings[index] {
            Meaning::Global(number) => short.globals[number as usize].as_deref().map(Cow::Borrowed),
            Meaning::Local(number) => short.locals[number as usize].as_deref().map(Cow::Borrowed),
            Meaning::Member(number) => short.members[number as usize].as_deref().map(Cow::Borrowed),
            Meaning::Word if token.kind == TokenKind::Number => Some(number::wgsl(old)),
            Meaning::Word => None,
        };
        let new = new.unwrap_or(Cow::Borrowed(old));
        if token.kind == TokenKind::Directive && previous.is_some() {
            out.push('\n');
        } else if let Some((kind, start)) = previous {
            match kind {
                TokenKind::Directive => out.push('\n'),
                _ if needs_space((kind, &out[start..]), (token.kind, &new)) => out.push(' '),
                _ => {}
            }
        }
        let start = out.len();
        out.push_str(&new);
        placed.push(Placed { out: Span::new(start, out.len()), from: token.span, copied: *new == *old });
        previous = Some((token.kind, start));
    }
    placed
}

/// Whether two tokens would be read as others without a space between them.
fn needs_space((left_kind, left): (TokenKind, &str), (right_kind, right): (TokenKind, &str)) -> bool {
    use TokenKind as K;
    let is_word = |c: char| c == '_' || !c.is_ascii() || c.is_ascii_alphanumeric();
    let (Some(last), Some(first)) = (left.chars().next_back(), right.chars().next()) else { return false };
    let is_operator = |kind| matches!(kind, K::Operator | K::Equal | K::TemplateClose | K::TemplateOpen);
    match (left_kind, right_kind) {
        (K::Unknown, _) | (_, K::Unknown) => true,
        (K::Number, _) => is_word(first) || first == '.',
        // `return .5`: fine for every compiler there is, but not for every highlighter.
        (_, K::Number) if first == '.' => is_word(last) || last == '.',
        (K::TemplateClose, K::TemplateClose) => false,
        // `vec2<f32> = b`
        (K::TemplateClose, right) if is_operator(right) => matches!(first, '=' | '>'),
        // `- -b`, `& &b`, `a / *b`
        (left, right) if is_operator(left) && is_operator(right) && last != '_' => {
            first == last || matches!(first, '=' | '>') || (last == '/' && first == '*')
        }
        _ => is_word(last) && is_word(first),
    }
}

/// Which tokens mean something: a comma before a closing bracket does not, nor does a statement that is empty.
fn needed(tokens: &[Solid]) -> Vec<bool> {
    use TokenKind as K;
    let mut needed = vec![true; tokens.len()];
    let mut round = 0u32;
    let mut last = None; // of those that are needed
    for (index, token) in tokens.iter().enumerate() {
        match token.kind {
            K::ParenOpen | K::BracketOpen => round += 1,
            K::ParenClose | K::BracketClose => round = round.saturating_sub(1),
            K::Comma => {
                let next = tokens.get(index + 1).map(|token| token.kind);
                needed[index] = !matches!(next, Some(K::ParenClose | K::TemplateClose | K::BraceClose));
            }
            // In the header of a `for`, empty ones count.
            K::Semicolon if round == 0 => {
                needed[index] = !matches!(last, None | Some(K::Semicolon | K::BraceOpen | K::BraceClose));
            }
            _ => {}
        }
        if needed[index] {
            last = Some(token.kind);
        }
    }
    needed
}
