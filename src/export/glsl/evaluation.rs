//! Order of evaluation: what an expression reads before a call in it changes that.
//!
//! WGSL works out operands from left to right. So does GLSL as far as calls go; a variable that stands before a call is read
//! behind it by some compilers, since they take operands for trees and calls for statements before them. What is passed to a
//! function is read in its turn, by all.

use super::write::{Writer, Written};
use super::write_expr::Wanted;
use crate::export::typed::{DeclKind, ExprId, ExprKind, Meaning, Ty};
use crate::source::Span;

/// The variable that a place lies in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Root {
    Local(u32),
    Global(u32),
}

impl Writer<'_, '_> {
    /// Writes what is evaluated before `later`.
    pub(super) fn before(&mut self, later: &[ExprId], work: impl FnOnce(&mut Self) -> Written) -> Written {
        let known = self.later.len();
        self.later.extend(later.iter().filter(|id| self.typed.has_effect(**id)));
        let outcome = work(self);
        self.later.truncate(known);
        outcome
    }

    /// Writes the place `id`, which is not read.
    pub(super) fn written_to(&mut self, id: ExprId) -> Written {
        self.as_place = true;
        self.expr(id, None)
    }

    /// Whether `id` reads a variable that something later in the same expression changes.
    pub(super) fn changes_later(&self, id: ExprId) -> bool {
        if self.later.is_empty() || matches!(self.typed.ty(id), Ty::Pointer(_)) {
            return false;
        }
        let Some(root) = self.root(id) else { return false };
        self.later.iter().any(|later| self.changes(*later, root))
    }

    /// Writes the place `id` such that it is read in its turn.
    pub(super) fn now(&mut self, id: ExprId, wanted: Wanted) -> Written {
        let later = std::mem::take(&mut self.later);
        let text = self.apart(|writer| {
            writer.as_place = true;
            writer.expr(id, wanted)
        });
        self.later = later;
        let read = self.now_of(&text?, self.types.pointee(self.typed.ty(id)), self.typed.tree.span(id))?;
        self.put(&read);
        self.cursor = self.typed.tree.expr(id).last + 1;
        Ok(())
    }

    /// `place`, of type `ty`, read in its turn.
    pub(super) fn now_of(&mut self, place: &str, ty: Ty, span: Span) -> Written<String> {
        match ty {
            Ty::Scalar(_) | Ty::Vector(..) => Ok(format!("{}({place})", self.helpers.ask("now", ty))),
            _ => self.refuse("reading this before a call that changes it, in one expression", span),
        }
    }

    /// The variable that the place `id` lies in.
    pub(super) fn root(&self, id: ExprId) -> Option<Root> {
        match &self.typed.tree.expr(id).kind {
            ExprKind::Name { .. } => match self.typed.meaning(id) {
                Meaning::Local(number) => {
                    Some(self.roots.get(&number).copied().unwrap_or(Root::Local(number)))
                }
                Meaning::Global(index) => {
                    let is_variable = matches!(
                        self.typed.tree.declarations[index as usize].kind,
                        DeclKind::Var { space: Some(space), .. } if self.typed.tree.word(space) == "private"
                    );
                    (is_variable && !self.instead.contains_key(&index)).then_some(Root::Global(index))
                }
                _ => None,
            },
            ExprKind::Member { base, .. } | ExprKind::Index { base, .. } => self.root(*base),
            ExprKind::Unary { operand } => {
                let word = self.typed.tree.word(self.typed.tree.expr(id).first);
                if matches!(word, "&" | "*") { self.root(*operand) } else { None }
            }
            ExprKind::Paren { inner } => self.root(*inner),
            _ => None,
        }
    }

    /// Whether a call in `id` may write to `root`: through a pointer into it, or to any variable of the module where the
    /// function has an effect at all.
    pub(super) fn changes(&self, id: ExprId, root: Root) -> bool {
        match &self.typed.tree.expr(id).kind {
            ExprKind::Literal | ExprKind::Name { .. } => false,
            ExprKind::Paren { inner } => self.changes(*inner, root),
            ExprKind::Unary { operand } => self.changes(*operand, root),
            ExprKind::Member { base, .. } => self.changes(*base, root),
            ExprKind::Index { base, index } => self.changes(*base, root) || self.changes(*index, root),
            ExprKind::Binary { left, right, .. } => self.changes(*left, root) || self.changes(*right, root),
            ExprKind::Call { callee, arguments } => {
                let own = match self.typed.meaning(*callee) {
                    Meaning::Global(index) => self.typed.effects[index as usize],
                    _ => false,
                };
                let points = |argument: &ExprId| {
                    matches!(self.typed.ty(*argument), Ty::Pointer(_)) && self.root(*argument) == Some(root)
                };
                (own && (matches!(root, Root::Global(_)) || arguments.iter().any(points)))
                    || arguments.iter().any(|argument| self.changes(*argument, root))
            }
        }
    }
}
