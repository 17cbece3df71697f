//! Expressions and type names: tokens → [`Expr`]s.

use super::parse::{DEEPEST, Parsed, Parser};
use super::tree::*;
use crate::syntax::TokenKind;

/// How strongly an operator binds; naga's order, which is that of C and of GLSL.
fn strength(operator: &str) -> Option<u8> {
    Some(match operator {
        "||" => 1,
        "&&" => 2,
        "|" => 3,
        "^" => 4,
        "&" => 5,
        "==" | "!=" => 6,
        "<" | "<=" | ">" | ">=" => 7,
        "<<" | ">>" => 8,
        "+" | "-" => 9,
        "*" | "/" | "%" => 10,
        _ => return None,
    })
}

impl Parser<'_> {
    pub(super) fn expression(&mut self) -> Parsed<ExprId> {
        self.deeper(|parser| parser.binary(1))
    }

    /// A type: a name with its template list.
    pub(super) fn type_name(&mut self) -> Parsed<ExprId> {
        self.expect_name()
    }

    fn binary(&mut self, weakest: u8) -> Parsed<ExprId> {
        let mut left = self.unary()?;
        loop {
            let found = match self.kind() {
                Some(TokenKind::Operator) => strength(self.word()).filter(|found| *found >= weakest),
                _ => None,
            };
            let Some(found) = found else { return Ok(left) };
            let operator = self.advance();
            let right = self.binary(found + 1)?;
            left =
                self.push(ExprKind::Binary { left, operator, right }, left, self.behind(), &[left, right])?;
        }
    }

    pub(super) fn unary(&mut self) -> Parsed<ExprId> {
        let is_prefix = self.kind() == Some(TokenKind::Operator)
            && matches!(self.word(), "-" | "!" | "~" | "*" | "&" | "--" | "&&");
        if !is_prefix {
            return self.postfix();
        }
        if matches!(self.word(), "--" | "&&") {
            return self.unreadable("this operator"); // two prefix operators without a space: naga refuses them as well
        }
        let first = self.advance();
        let operand = self.deeper(Self::unary)?;
        self.push_from(ExprKind::Unary { operand }, first, self.behind(), &[operand])
    }

    fn postfix(&mut self) -> Parsed<ExprId> {
        let mut base = self.primary()?;
        loop {
            if self.takes(TokenKind::Dot) {
                let name = self.expect(TokenKind::Ident, "this member")?;
                base = self.push(ExprKind::Member { base, name }, base, name, &[base])?;
            } else if self.takes(TokenKind::BracketOpen) {
                let index = self.expression()?;
                let close = self.expect(TokenKind::BracketClose, "this index")?;
                base = self.push(ExprKind::Index { base, index }, base, close, &[base, index])?;
            } else {
                return Ok(base);
            }
        }
    }

    fn primary(&mut self) -> Parsed<ExprId> {
        match self.kind() {
            Some(TokenKind::Number) => self.literal(),
            Some(TokenKind::Ident) if matches!(self.word(), "true" | "false") => self.literal(),
            Some(TokenKind::ParenOpen) => {
                let first = self.advance();
                let inner = self.expression()?;
                let close = self.expect(TokenKind::ParenClose, "this expression")?;
                self.push_from(ExprKind::Paren { inner }, first, close, &[inner])
            }
            Some(TokenKind::Ident) => {
                let callee = self.expect_name()?;
                if !self.takes(TokenKind::ParenOpen) {
                    return Ok(callee);
                }
                let arguments = self.list(TokenKind::ParenClose)?;
                let close = self.expect(TokenKind::ParenClose, "this call")?;
                let kind = ExprKind::Call { callee, arguments: arguments.clone() };
                self.push(kind, callee, close, &arguments)
            }
            _ => self.unreadable("this expression"),
        }
    }

    fn literal(&mut self) -> Parsed<ExprId> {
        let tok = self.advance();
        self.push_from(ExprKind::Literal, tok, tok, &[])
    }

    fn expect_name(&mut self) -> Parsed<ExprId> {
        let has_list = self.kind_after() == Some(TokenKind::TemplateOpen);
        let first = self.expect(TokenKind::Ident, "this name")?;
        let mut arguments = Vec::new();
        if has_list {
            self.advance();
            arguments = self.deeper(|parser| parser.list(TokenKind::TemplateClose))?;
            self.expect(TokenKind::TemplateClose, "this type")?;
        }
        let last = self.behind();
        self.push_from(ExprKind::Name { arguments: arguments.clone() }, first, last, &arguments)
    }

    /// Expressions with commas between them, and perhaps one at the end.
    fn list(&mut self, end: TokenKind) -> Parsed<Vec<ExprId>> {
        let mut all = Vec::new();
        while self.kind().is_some() && self.kind() != Some(end) {
            all.push(self.expression()?);
            if !self.takes(TokenKind::Comma) {
                break;
            }
        }
        Ok(all)
    }

    fn push(&mut self, kind: ExprKind, start: ExprId, last: Tok, parts: &[ExprId]) -> Parsed<ExprId> {
        let first = self.tree.expr(start).first;
        self.push_from(kind, first, last, parts)
    }

    fn push_from(&mut self, kind: ExprKind, first: Tok, last: Tok, parts: &[ExprId]) -> Parsed<ExprId> {
        let depth = parts.iter().map(|part| self.tree.expr(*part).depth + 1).max().unwrap_or(0);
        if depth > DEEPEST {
            return self.unreadable("nesting of this depth");
        }
        self.tree.expressions.push(Expr { kind, first, last, depth });
        Ok(ExprId(self.tree.expressions.len() as u32 - 1))
    }
}
