//! Which functions do more than give a value: they write to variables of the module, write through pointers, or discard.

use super::infer::{Meaning, Typed};
use super::tree::*;
use super::ty::Ty;

/// Of each declaration, whether calling it has an effect.
pub(super) fn effects(typed: &Typed<'_>) -> Vec<bool> {
    let mut effects: Vec<bool> = typed
        .tree
        .declarations
        .iter()
        .map(|decl| match &decl.kind {
            DeclKind::Function(function) => {
                function.parameters.iter().any(|field| matches!(typed.ty(field.ty), Ty::Pointer(_)))
                    || function.body.statements.iter().any(|statement| writes(typed, statement))
            }
            _ => false,
        })
        .collect();
    // Whoever calls one that has an effect has it too. WGSL has no recursion, so this ends after a call chain's length.
    loop {
        let mut changed = false;
        for (index, references) in typed.references.iter().enumerate() {
            let has = references.iter().any(|called| effects[*called as usize]);
            changed |= has && !effects[index];
            effects[index] |= has;
        }
        if !changed {
            return effects;
        }
    }
}

fn writes(typed: &Typed<'_>, statement: &Statement) -> bool {
    let any = |block: &Block| block.statements.iter().any(|statement| writes(typed, statement));
    let some =
        |statement: &Option<Box<Statement>>| statement.iter().any(|statement| writes(typed, statement));
    match &statement.kind {
        StatementKind::Discard => true,
        StatementKind::Assign { left, .. } | StatementKind::Step { left } => is_global(typed, *left),
        StatementKind::Block(block) | StatementKind::While { body: block, .. } => any(block),
        StatementKind::If { arms, otherwise } => {
            arms.iter().any(|arm| any(&arm.body)) || otherwise.as_ref().is_some_and(any)
        }
        StatementKind::Switch { clauses, .. } => clauses.iter().any(|clause| any(&clause.body)),
        StatementKind::Loop { body, continuing } => {
            any(body) || continuing.as_ref().is_some_and(|continuing| any(&continuing.body))
        }
        StatementKind::For { init, step, body, .. } => some(init) || some(step) || any(body),
        _ => false,
    }
}

/// Whether what is written to is a variable of the module. Through a pointer it may be.
fn is_global(typed: &Typed<'_>, place: ExprId) -> bool {
    match &typed.tree.expr(place).kind {
        ExprKind::Name { .. } => matches!(typed.meaning(place), Meaning::Global(_)),
        ExprKind::Index { base, .. } | ExprKind::Member { base, .. } => {
            is_global(typed, *base) || matches!(typed.ty(*base), Ty::Pointer(_))
        }
        ExprKind::Unary { .. } => true,
        ExprKind::Paren { inner } => is_global(typed, *inner),
        _ => false,
    }
}

impl Typed<'_> {
    /// Whether evaluating `id` does more than give a value.
    pub(in crate::export) fn has_effect(&self, id: ExprId) -> bool {
        match &self.tree.expr(id).kind {
            ExprKind::Literal | ExprKind::Name { .. } => false,
            ExprKind::Paren { inner } => self.has_effect(*inner),
            ExprKind::Unary { operand } => self.has_effect(*operand),
            ExprKind::Member { base, .. } => self.has_effect(*base),
            ExprKind::Index { base, index } => self.has_effect(*base) || self.has_effect(*index),
            ExprKind::Binary { left, right, .. } => self.has_effect(*left) || self.has_effect(*right),
            ExprKind::Call { callee, arguments } => {
                let own =
                    matches!(self.meaning(*callee), Meaning::Global(index) if self.effects[index as usize]);
                own || arguments.iter().any(|argument| self.has_effect(*argument))
            }
        }
    }
}
