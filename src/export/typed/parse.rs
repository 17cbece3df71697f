//! WGSL text → [`Tree`]: declarations and statements. naga has accepted the text before, so what does not fit is a construct
//! that this parser does not know, and is refused with its place.

use super::tree::*;
use crate::source::Span;
use crate::syntax::{TokenKind, lex};

/// A construct that is not known, or nests too deep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::export) struct Unreadable {
    pub(in crate::export) what: std::borrow::Cow<'static, str>,
    pub(in crate::export) span: Span,
}

pub(super) type Parsed<T> = Result<T, Unreadable>;

/// How deep expressions and statements may nest: each level takes some of the stack.
pub(super) const DEEPEST: u32 = 10_000;

/// Reads `text`.
pub(in crate::export) fn parse(text: &str) -> Parsed<Tree<'_>> {
    let tokens = lex(text);
    let significant: Vec<Tok> = (0..tokens.len())
        .filter(|index| !tokens.kind(*index).is_trivia())
        .map(|index| index as Tok)
        .collect();
    let in_attribute = vec![false; tokens.len()];
    let tree =
        Tree { text, tokens, declarations: Vec::new(), expressions: Vec::new(), in_attribute, locals: 0 };
    let mut parser = Parser { tree, significant, at: 0, depth: 0 };
    while !parser.at_end() {
        if parser.takes(TokenKind::Semicolon) {
            continue;
        }
        let declaration = parser.declaration()?;
        parser.tree.declarations.push(declaration);
    }
    Ok(parser.tree)
}

pub(super) struct Parser<'a> {
    pub(super) tree: Tree<'a>,
    significant: Vec<Tok>,
    /// Which of `significant` comes next.
    at: usize,
    pub(super) depth: u32,
}

impl<'a> Parser<'a> {
    fn at_end(&self) -> bool {
        self.at >= self.significant.len()
    }

    /// The next token; the last one at the end.
    pub(super) fn here(&self) -> Tok {
        self.significant.get(self.at).or(self.significant.last()).copied().unwrap_or(0)
    }

    pub(super) fn kind(&self) -> Option<TokenKind> {
        self.significant.get(self.at).map(|tok| self.tree.kind(*tok))
    }

    pub(super) fn word(&self) -> &'a str {
        self.significant.get(self.at).map_or("", |tok| self.tree.word(*tok))
    }

    /// What kind the token after the next one is.
    pub(super) fn kind_after(&self) -> Option<TokenKind> {
        self.significant.get(self.at + 1).map(|tok| self.tree.kind(*tok))
    }

    pub(super) fn unreadable<T>(&self, what: &'static str) -> Parsed<T> {
        if self.tree.tokens.is_empty() {
            return Err(Unreadable { what: what.into(), span: Span::new(0, 0) });
        }
        let here = self.here();
        Err(Unreadable { what: what.into(), span: self.tree.span_of(here, here) })
    }

    pub(super) fn advance(&mut self) -> Tok {
        let tok = self.here();
        self.at += 1;
        tok
    }

    /// The token just taken.
    pub(super) fn behind(&self) -> Tok {
        self.significant[self.at.saturating_sub(1).min(self.significant.len() - 1)]
    }

    pub(super) fn takes(&mut self, kind: TokenKind) -> bool {
        let found = self.kind() == Some(kind);
        self.at += usize::from(found);
        found
    }

    fn takes_word(&mut self, word: &str) -> bool {
        let found = self.word() == word;
        self.at += usize::from(found);
        found
    }

    pub(super) fn expect(&mut self, kind: TokenKind, what: &'static str) -> Parsed<Tok> {
        if self.kind() == Some(kind) { Ok(self.advance()) } else { self.unreadable(what) }
    }

    pub(super) fn deeper<T>(&mut self, work: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth >= DEEPEST {
            return self.unreadable("nesting of this depth");
        }
        self.depth += 1;
        let outcome = work(self);
        self.depth -= 1;
        outcome
    }

    fn attributes(&mut self) -> Parsed<Vec<Attribute>> {
        let mut attributes = Vec::new();
        while self.kind() == Some(TokenKind::At) {
            let first = self.advance();
            let name = self.expect(TokenKind::Ident, "this attribute")?;
            let mut arguments = Vec::new();
            if self.takes(TokenKind::ParenOpen) {
                while self.kind() != Some(TokenKind::ParenClose) {
                    arguments.push(self.expression()?);
                    if !self.takes(TokenKind::Comma) {
                        break;
                    }
                }
                self.expect(TokenKind::ParenClose, "this attribute")?;
            }
            for tok in first..=self.behind() {
                self.tree.in_attribute[tok as usize] = true;
            }
            attributes.push(Attribute { name, arguments });
        }
        Ok(attributes)
    }

    fn declaration(&mut self) -> Parsed<Decl> {
        let first = self.here();
        self.attributes()?;
        let keyword = self.word();
        let name = match keyword {
            "fn" | "struct" | "const" | "override" | "alias" => {
                self.advance();
                self.expect(TokenKind::Ident, "this declaration")?
            }
            _ => self.advance(),
        };
        let mut declared = name;
        let kind = match keyword {
            "enable" | "requires" | "diagnostic" | "const_assert" => {
                while !matches!(self.kind(), None | Some(TokenKind::Semicolon)) {
                    self.at += 1;
                }
                if keyword == "const_assert" { DeclKind::Assert } else { DeclKind::Directive }
            }
            "alias" => {
                self.expect(TokenKind::Equal, "this alias")?;
                DeclKind::Alias(self.expression()?)
            }
            "const" => {
                let ty = self.type_annotation()?;
                self.expect(TokenKind::Equal, "this constant")?;
                DeclKind::Const { ty, value: self.expression()? }
            }
            "override" => DeclKind::Override { ty: self.type_annotation()?, value: self.initializer()? },
            "var" => {
                let space = self.address_space()?;
                declared = self.expect(TokenKind::Ident, "this variable")?;
                DeclKind::Var { space, ty: self.type_annotation()?, value: self.initializer()? }
            }
            "struct" => {
                let open = self.expect(TokenKind::BraceOpen, "this struct")?;
                let members = self.fields(TokenKind::BraceClose, false)?;
                let close = self.expect(TokenKind::BraceClose, "this struct")?;
                return Ok(Decl {
                    kind: DeclKind::Struct { open, members, close },
                    name,
                    first,
                    last: close,
                });
            }
            "fn" => {
                let open = self.expect(TokenKind::ParenOpen, "this function")?;
                let parameters = self.fields(TokenKind::ParenClose, true)?;
                let close = self.expect(TokenKind::ParenClose, "this function")?;
                let (mut result, mut result_attributes) = (None, Vec::new());
                if self.takes_word("->") {
                    result_attributes = self.attributes()?;
                    result = Some(self.type_name()?);
                }
                let body = self.block()?;
                let last = body.close;
                let function = Function { parameters, open, close, result, result_attributes, body };
                return Ok(Decl { kind: DeclKind::Function(Box::new(function)), name, first, last });
            }
            _ => return self.unreadable("this declaration"),
        };
        let last = self.expect(TokenKind::Semicolon, "this declaration")?;
        Ok(Decl { kind, name: declared, first, last })
    }

    /// `<space, access>` behind `var`: the first word.
    fn address_space(&mut self) -> Parsed<Option<Tok>> {
        if !self.takes(TokenKind::TemplateOpen) {
            return Ok(None);
        }
        let space = self.here();
        while self.kind() != Some(TokenKind::TemplateClose) {
            if self.kind().is_none() {
                return self.unreadable("this variable");
            }
            self.at += 1;
        }
        self.at += 1;
        Ok(Some(space))
    }

    fn type_annotation(&mut self) -> Parsed<Option<ExprId>> {
        if self.takes(TokenKind::Colon) { self.type_name().map(Some) } else { Ok(None) }
    }

    fn initializer(&mut self) -> Parsed<Option<ExprId>> {
        if self.takes(TokenKind::Equal) { self.expression().map(Some) } else { Ok(None) }
    }

    fn fields(&mut self, end: TokenKind, parameters: bool) -> Parsed<Vec<Field>> {
        let mut fields = Vec::new();
        while self.kind().is_some_and(|kind| kind != end) {
            let attributes = self.attributes()?;
            let name = self.expect(TokenKind::Ident, "this declaration")?;
            self.expect(TokenKind::Colon, "this declaration")?;
            let ty = self.type_name()?;
            let number = if parameters { self.fresh_local() } else { 0 };
            fields.push(Field { attributes, name, ty, number });
            if !self.takes(TokenKind::Comma) {
                break;
            }
        }
        Ok(fields)
    }

    fn fresh_local(&mut self) -> u32 {
        self.tree.locals += 1;
        self.tree.locals - 1
    }

    fn block(&mut self) -> Parsed<Block> {
        self.attributes()?;
        let open = self.expect(TokenKind::BraceOpen, "this block")?;
        let statements = self.deeper(Self::statements)?;
        let close = self.expect(TokenKind::BraceClose, "this block")?;
        Ok(Block { open, statements, close })
    }

    /// Up to what closes the block, or to its `continuing` or `break if`.
    fn statements(&mut self) -> Parsed<Vec<Statement>> {
        let mut statements = Vec::new();
        loop {
            let is_break_if =
                || self.significant.get(self.at + 1).is_some_and(|tok| self.tree.word(*tok) == "if");
            match self.kind() {
                None | Some(TokenKind::BraceClose) => return Ok(statements),
                _ if self.word() == "continuing" => return Ok(statements),
                _ if self.word() == "break" && is_break_if() => return Ok(statements),
                _ => statements.push(self.statement()?),
            }
        }
    }

    fn statement(&mut self) -> Parsed<Statement> {
        self.attributes()?;
        let first = self.here();
        let kind = match (self.kind(), self.word()) {
            (Some(TokenKind::Semicolon), _) => {
                self.advance();
                StatementKind::Empty
            }
            (Some(TokenKind::BraceOpen), _) => StatementKind::Block(self.block()?),
            (_, "if") => self.if_chain()?,
            (_, "switch") => self.switch()?,
            (_, "loop") => self.loop_()?,
            (_, "while") => {
                self.advance();
                StatementKind::While { condition: self.expression()?, body: self.block()? }
            }
            (_, "for") => self.for_()?,
            _ => {
                let kind = self.simple_statement()?;
                self.expect(TokenKind::Semicolon, "this statement")?;
                kind
            }
        };
        Ok(Statement { kind, first, last: self.behind() })
    }

    /// One without its semicolon: also what stands in the head of a `for`.
    fn simple_statement(&mut self) -> Parsed<StatementKind> {
        let is_keyword = self.kind() == Some(TokenKind::Ident);
        match self.word() {
            "let" | "const" | "var" if is_keyword => return self.local(),
            "return" if is_keyword => {
                self.advance();
                let is_bare = self.kind() == Some(TokenKind::Semicolon);
                return Ok(StatementKind::Return(if is_bare { None } else { Some(self.expression()?) }));
            }
            "break" | "continue" | "discard" if is_keyword => {
                let tok = self.advance();
                return Ok(match self.tree.word(tok) {
                    "break" => StatementKind::Break,
                    "continue" => StatementKind::Continue,
                    _ => StatementKind::Discard,
                });
            }
            "const_assert" if is_keyword => {
                self.advance();
                self.expression()?;
                return Ok(StatementKind::Assert);
            }
            "_" => {
                self.advance();
                self.expect(TokenKind::Equal, "this assignment")?;
                return Ok(StatementKind::Phony { right: self.expression()? });
            }
            _ => {}
        }
        let left = self.unary()?;
        let operator = self.here();
        match (self.kind(), self.word()) {
            (Some(TokenKind::Equal), _)
            | (_, "+=" | "-=" | "*=" | "/=" | "%=" | "&=" | "|=" | "^=" | "<<=" | ">>=") => {
                self.advance();
                Ok(StatementKind::Assign { left, operator, right: self.expression()? })
            }
            (_, "++" | "--") => {
                self.advance();
                Ok(StatementKind::Step { left })
            }
            _ if matches!(self.tree.expr(left).kind, ExprKind::Call { .. }) => Ok(StatementKind::Call(left)),
            _ => self.unreadable("this statement"),
        }
    }

    fn local(&mut self) -> Parsed<StatementKind> {
        let keyword = self.advance();
        let binding = match self.tree.word(keyword) {
            "let" => Binding::Let,
            "const" => Binding::Const,
            _ => Binding::Var,
        };
        if binding == Binding::Var {
            self.address_space()?;
        }
        let name = self.expect(TokenKind::Ident, "this declaration")?;
        let (ty, value) = (self.type_annotation()?, self.initializer()?);
        Ok(StatementKind::Local(Local { binding, name, ty, value, number: self.fresh_local() }))
    }

    fn if_chain(&mut self) -> Parsed<StatementKind> {
        let mut arms = Vec::new();
        loop {
            self.advance(); // `if`
            arms.push(Arm { condition: self.expression()?, body: self.block()? });
            if !self.takes_word("else") {
                return Ok(StatementKind::If { arms, otherwise: None });
            }
            if self.word() != "if" {
                return Ok(StatementKind::If { arms, otherwise: Some(self.block()?) });
            }
        }
    }

    fn switch(&mut self) -> Parsed<StatementKind> {
        self.advance();
        let selector = self.expression()?;
        self.attributes()?;
        let open = self.expect(TokenKind::BraceOpen, "this switch")?;
        let mut clauses = Vec::new();
        while matches!(self.word(), "case" | "default") {
            let first = self.advance();
            let mut selectors = Vec::new();
            if self.tree.word(first) == "default" {
                selectors.push(None);
            } else {
                while !matches!(self.kind(), Some(TokenKind::Colon | TokenKind::BraceOpen | TokenKind::At)) {
                    let is_default = self.takes_word("default");
                    selectors.push(if is_default { None } else { Some(self.expression()?) });
                    if !self.takes(TokenKind::Comma) {
                        break;
                    }
                }
            }
            self.takes(TokenKind::Colon);
            clauses.push(Clause { first, selectors, body: self.block()? });
        }
        self.expect(TokenKind::BraceClose, "this switch")?;
        Ok(StatementKind::Switch { selector, open, clauses })
    }

    fn loop_(&mut self) -> Parsed<StatementKind> {
        self.advance();
        self.attributes()?;
        let open = self.expect(TokenKind::BraceOpen, "this loop")?;
        let statements = self.deeper(Self::statements)?;
        let mut continuing = None;
        if self.word() == "continuing" {
            let first = self.advance();
            self.attributes()?;
            let open = self.expect(TokenKind::BraceOpen, "this block")?;
            let statements = self.deeper(Self::statements)?;
            let mut break_if = None;
            if self.takes_word("break") {
                self.takes_word("if");
                break_if = Some(self.expression()?);
                self.expect(TokenKind::Semicolon, "this statement")?;
            }
            let close = self.expect(TokenKind::BraceClose, "this block")?;
            continuing = Some(Continuing { first, body: Block { open, statements, close }, break_if });
        }
        let close = self.expect(TokenKind::BraceClose, "this loop")?;
        Ok(StatementKind::Loop { body: Block { open, statements, close }, continuing })
    }

    fn for_(&mut self) -> Parsed<StatementKind> {
        self.advance();
        let open = self.expect(TokenKind::ParenOpen, "this loop")?;
        let init = self.head_statement(TokenKind::Semicolon)?;
        self.expect(TokenKind::Semicolon, "this loop")?;
        let is_endless = self.kind() == Some(TokenKind::Semicolon);
        let condition = if is_endless { None } else { Some(self.expression()?) };
        self.expect(TokenKind::Semicolon, "this loop")?;
        let step = self.head_statement(TokenKind::ParenClose)?;
        let close = self.expect(TokenKind::ParenClose, "this loop")?;
        Ok(StatementKind::For { open, init, condition, step, close, body: self.block()? })
    }

    fn head_statement(&mut self, end: TokenKind) -> Parsed<Option<Box<Statement>>> {
        if self.kind() == Some(end) {
            return Ok(None);
        }
        let first = self.here();
        let kind = self.simple_statement()?;
        Ok(Some(Box::new(Statement { kind, first, last: self.behind() })))
    }
}
