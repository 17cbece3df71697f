//! What is left of a fragment in the result: pieces of its own text, and words that stand in for names.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::error::ComposeError;
use super::names::{Active, Meaning, Names, UNIFORM};
use super::shake::Kept;
use crate::preset::Knob;
use crate::source::{FileId, Span};
use crate::syntax::{Declaration, DeclarationKind};

/// A piece of the result. Spans are of the fragment's file.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    /// The author's own text.
    Copy(Span),
    /// A name that is spelled otherwise here.
    Word(Arc<str>, Span),
    /// A parameter or an option is read.
    Read(Knob, Span),
}

/// What stands at the top of a WGSL module, once: `enable`, `requires`, `diagnostic`.
#[derive(Debug, Clone, PartialEq)]
pub struct Hoisted {
    /// The instance that it is from.
    pub instance: usize,
    /// The file that it is from.
    pub file: FileId,
    /// Where it stands.
    pub span: Span,
    /// Its keyword.
    pub kind: DeclarationKind,
    /// What stands between keyword and semicolon.
    pub body: String,
}

/// The pieces of one instance; empty where nothing of it is in.
pub(super) fn pieces(
    names: &Names<'_>,
    kept: &Kept,
    active: &Active<'_>,
    keep_all: bool,
    hoist: bool,
    errors: &mut Vec<ComposeError>,
) -> Vec<Piece> {
    let module = active.module;
    let in_file = &kept.declarations[active.instance];
    let mut pieces = Vec::new();
    let is_kept = |index: usize| {
        let directive = is_directive(module.declarations[index].kind);
        if directive { !hoist } else { in_file[index] }
    };
    let any = (0..module.declarations.len()).any(|index| in_file[index]);
    let is_empty_root = keep_all && module.declarations.is_empty(); // comments are all there is
    if !any && !is_empty_root {
        return pieces;
    }
    copy(&mut pieces, &module.pieces[module.head.clone()]);
    let head = pieces.len();
    let contiguous = match pieces.last() {
        Some(Piece::Copy(span)) => span.end,
        _ => 0,
    };
    let mut hides = vec![None; module.symbols()];
    let mut last_kept = true;
    for (index, declaration) in module.declarations.iter().enumerate() {
        last_kept = is_kept(index);
        if last_kept {
            check_locals(names, kept, active, declaration, &mut hides, errors);
            let first = pieces.len() == head;
            declare(names, kept, active, declaration, &mut pieces);
            if first {
                skip_blank_lines(active.text, &mut pieces, head, contiguous);
            }
        }
    }
    if last_kept {
        copy(&mut pieces, &module.pieces[module.tail.clone()]);
    }
    pieces
}

pub(super) fn is_directive(kind: DeclarationKind) -> bool {
    matches!(kind, DeclarationKind::Enable | DeclarationKind::Requires | DeclarationKind::Diagnostic)
}

fn copy(pieces: &mut Vec<Piece>, spans: &[Span]) {
    for span in spans {
        push(pieces, *span);
    }
}

/// Blank lines that stood between what is left out and the first declaration that is in.
fn skip_blank_lines(text: &str, pieces: &mut Vec<Piece>, first: usize, contiguous: u32) {
    let Some(Piece::Copy(span)) = pieces.get_mut(first) else { return };
    if span.start == contiguous {
        return; // nothing is left out
    }
    let piece = &text[span.range()];
    let blank = piece.len() - piece.trim_start().len();
    let lines = piece[..blank].rfind('\n').map_or(0, |at| at + 1);
    span.start += lines as u32;
    if span.is_empty() {
        pieces.remove(first);
    }
}

fn push(pieces: &mut Vec<Piece>, span: Span) {
    if span.is_empty() {
        return;
    }
    if let Some(Piece::Copy(last)) = pieces.last_mut()
        && last.end == span.start
    {
        last.end = span.end;
    } else {
        pieces.push(Piece::Copy(span));
    }
}

fn declare(
    names: &Names<'_>,
    kept: &Kept,
    active: &Active<'_>,
    declaration: &Declaration,
    pieces: &mut Vec<Piece>,
) {
    let module = active.module;
    if !kept.rewrites[active.instance] {
        return copy(pieces, &module.pieces[declaration.pieces.clone()]);
    }
    let references = &module.references[declaration.references.clone()];
    let meanings = &kept.meanings[active.instance];
    let mut changes =
        references.iter().filter_map(|reference| match meanings[reference.symbol as usize].as_ref()? {
            Meaning::Renamed(_, name) => Some(Piece::Word(name.clone(), reference.span)),
            Meaning::Knob(knob) => Some(Piece::Read(*knob, reference.span)),
            Meaning::Group => {
                let knob = names.find_member(active.instance, reference)?;
                let end = reference.member.map_or(reference.span, |(_, span)| span);
                Some(Piece::Read(knob, reference.span.to(end)))
            }
            Meaning::Foreign | Meaning::Global(_) | Meaning::OpenSlot => None,
        });
    let mut change = changes.next();
    for span in &module.pieces[declaration.pieces.clone()] {
        let mut start = span.start;
        while let Some(piece) = &change {
            let (Piece::Word(_, at) | Piece::Read(_, at) | Piece::Copy(at)) = piece;
            if at.end > span.end {
                break;
            }
            push(pieces, Span { start, end: at.start });
            start = at.end;
            pieces.push(piece.clone());
            change = changes.next();
        }
        push(pieces, Span { start, end: span.end });
    }
}

/// Whether a file has `group.member` anywhere, for a member that there is: groups that only other files read may be called
/// like its locals.
fn speaks_of_group(names: &Names<'_>, text: &str, group: &str) -> bool {
    let continues = |c: char| unicode_ident::is_xid_continue(c);
    text.match_indices(group).any(|(at, _)| {
        let starts = !text[..at].ends_with(continues);
        let Some(rest) = text[at + group.len()..].trim_start().strip_prefix('.') else { return false };
        let rest = rest.trim_start();
        let member = &rest[..rest.find(|c| !continues(c)).unwrap_or(rest.len())];
        starts && names.declarations.find(&format!("{group}.{member}")).is_some()
    })
}

/// A local variable may hide neither a group of parameters that its file reads, nor a name that takes another spelling in
/// the result.
fn check_locals(
    names: &Names<'_>,
    kept: &Kept,
    active: &Active<'_>,
    declaration: &Declaration,
    hides: &mut [Option<bool>],
    errors: &mut Vec<ComposeError>,
) {
    let locals = &active.module.locals[declaration.locals.clone()];
    let file = names.graph.file(active.instance);
    for (symbol, span) in locals {
        let name = active.module.name(active.text, *symbol);
        let hidden = hides[*symbol as usize].get_or_insert_with(|| {
            let renamed = &names.graph.instances[active.instance].renamed;
            renamed.as_ref().is_some_and(|(from, _)| from == name)
                || names.declarations.is_group_in_code(name) && speaks_of_group(names, active.text, name)
        });
        if *hidden {
            let what = format!("the group `{name}` of parameters");
            errors.push(ComposeError::Hidden { name: name.into(), what, at: (file, *span) });
        }
    }
    if locals.is_empty() || !kept.rewrites[active.instance] {
        return;
    }
    let by_name: FxHashMap<&str, Span> =
        locals.iter().rev().map(|(symbol, span)| (active.module.name(active.text, *symbol), *span)).collect();
    for reference in &active.module.references[declaration.references.clone()] {
        let spelled: String = match kept.meanings[active.instance][reference.symbol as usize].as_ref() {
            Some(Meaning::Renamed(_, name)) => name.to_string(),
            Some(Meaning::Knob(knob)) => names.flat(*knob),
            Some(Meaning::Group) => match names.find_member(active.instance, reference) {
                Some(knob) => names.flat(knob),
                None => continue,
            },
            _ => continue,
        };
        // However the parameter is baked: `group_name`, a component of it, or a field of the uniform buffer.
        let is_read =
            !matches!(kept.meanings[active.instance][reference.symbol as usize], Some(Meaning::Renamed(..)));
        let component = |suffix: &str| by_name.get(format!("{spelled}{suffix}").as_str());
        let hiding = by_name.get(spelled.as_str()).or_else(|| {
            let read = is_read.then(|| by_name.get(names.prefix.before(UNIFORM.0).as_str()));
            read?.or_else(|| ["_x", "_y", "_z", "_w"].into_iter().find_map(component))
        });
        if let Some(span) = hiding {
            let name = active.text[span.range()].to_owned();
            let source =
                names.active[active.instance].as_ref().map_or("", |a| &a.text[reference.span.range()]);
            let what = match reference.member {
                Some((_, member)) if is_read => {
                    format!("the parameter `{}`", &active.text[reference.span.to(member).range()])
                }
                _ => format!("`{source}`, which is called `{spelled}` in the result"),
            };
            errors.push(ComposeError::Hidden { name, what, at: (file, *span) });
            return;
        }
    }
}
