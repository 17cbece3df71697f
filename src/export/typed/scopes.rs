//! The bodies of functions: which local variable a name stands for, statement by statement.

use rustc_hash::FxHashMap;

use super::infer::{Local as LocalFacts, Typer};
use super::parse::Parsed;
use super::tree::*;
use super::ty::Ty;

impl Typer<'_> {
    /// Types the body of declaration `index`, if it is a function.
    pub(super) fn function(&mut self, index: u32) -> Parsed<()> {
        let nothing = DeclKind::Directive;
        let kind = std::mem::replace(&mut self.typed.tree.declarations[index as usize].kind, nothing);
        let outcome = match &kind {
            DeclKind::Function(function) => {
                self.doing = index;
                self.body(function)
            }
            _ => Ok(()),
        };
        self.typed.tree.declarations[index as usize].kind = kind;
        outcome
    }

    fn body(&mut self, function: &Function) -> Parsed<()> {
        self.scopes = vec![FxHashMap::default()];
        for field in &function.parameters {
            let ty = self.typed.ty(field.ty);
            self.show(field.name, field.number, ty, Binding::Parameter);
        }
        self.block(&function.body)
    }

    fn show(&mut self, name: Tok, number: u32, ty: Ty, binding: Binding) {
        self.typed.locals[number as usize] = LocalFacts { name, ty, binding, function: self.doing };
        let word = self.typed.tree.word(name);
        if let Some(scope) = self.scopes.last_mut() {
            scope.insert(word, number);
        }
    }

    fn scoped(&mut self, work: impl FnOnce(&mut Self) -> Parsed<()>) -> Parsed<()> {
        self.scopes.push(FxHashMap::default());
        let outcome = work(self);
        self.scopes.pop();
        outcome
    }

    fn block(&mut self, block: &Block) -> Parsed<()> {
        self.scoped(|typer| typer.statements(&block.statements))
    }

    fn statements(&mut self, statements: &[Statement]) -> Parsed<()> {
        statements.iter().try_for_each(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &Statement) -> Parsed<()> {
        match &statement.kind {
            StatementKind::Empty
            | StatementKind::Break
            | StatementKind::Continue
            | StatementKind::Discard
            | StatementKind::Assert
            | StatementKind::Return(None) => Ok(()),
            StatementKind::Block(block) => self.block(block),
            StatementKind::Local(local) => self.local(local),
            StatementKind::Assign { left, right, .. } => {
                self.expr(*left)?;
                self.expr(*right).map(drop)
            }
            StatementKind::Phony { right: only }
            | StatementKind::Step { left: only }
            | StatementKind::Call(only)
            | StatementKind::Return(Some(only)) => self.expr(*only).map(drop),
            StatementKind::If { arms, otherwise } => {
                for arm in arms {
                    self.expr(arm.condition)?;
                    self.block(&arm.body)?;
                }
                otherwise.iter().try_for_each(|block| self.block(block))
            }
            StatementKind::Switch { selector, clauses, .. } => {
                self.expr(*selector)?;
                for clause in clauses {
                    for selector in clause.selectors.iter().flatten() {
                        self.expr(*selector)?;
                    }
                    self.block(&clause.body)?;
                }
                Ok(())
            }
            StatementKind::Loop { body, continuing } => self.scoped(|typer| {
                typer.statements(&body.statements)?;
                let Some(continuing) = continuing else { return Ok(()) };
                typer.scoped(|typer| {
                    typer.statements(&continuing.body.statements)?;
                    continuing.break_if.map_or(Ok(()), |condition| typer.expr(condition).map(drop))
                })
            }),
            StatementKind::While { condition, body } => {
                self.expr(*condition)?;
                self.block(body)
            }
            StatementKind::For { init, condition, step, body, .. } => self.scoped(|typer| {
                init.iter().try_for_each(|init| typer.statement(init))?;
                condition.map_or(Ok(()), |condition| typer.expr(condition).map(drop))?;
                step.iter().try_for_each(|step| typer.statement(step))?;
                typer.block(body)
            }),
        }
    }

    fn local(&mut self, local: &Local) -> Parsed<()> {
        let own = local.value.map(|value| self.expr(value)).transpose()?;
        let ty = match local.ty {
            Some(ty) => self.type_name(ty)?,
            // A constant stays abstract: it may be read as several types.
            None if local.binding == Binding::Const => own.unwrap_or(Ty::Nothing),
            None => self.typed.types.concrete(own.unwrap_or(Ty::Nothing)),
        };
        if let (Binding::Const, Some(value)) = (local.binding, local.value) {
            self.typed.constants.insert(local.number, value);
        }
        self.show(local.name, local.number, ty, local.binding);
        Ok(())
    }
}
