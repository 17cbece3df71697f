//! The writer: goes through the tokens, copies what GLSL shares with WGSL, and says the rest in GLSL's words.
//!
//! A cursor stands before the token that comes next. Whoever writes a node of the tree finds the cursor before its first
//! token, or anywhere else, and leaves it behind its last. Blank space and comments on the way are copied.

use rustc_hash::{FxHashMap, FxHashSet};

use super::evaluation::Root;
use super::helpers::Helpers;
use super::names::Names;
use super::spelling;
use crate::export::typed::{ExprId, Opaque, Scalar, Tok, Ty, Typed, Types, Unreadable};
use crate::source::Span;
use crate::syntax::TokenKind;

/// What GLSL ES 3.00 has no words for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Refusal {
    pub(super) what: String,
    pub(super) span: Span,
}

pub(super) type Written<T = ()> = Result<T, Refusal>;

impl From<Unreadable> for Refusal {
    fn from(Unreadable { what, span }: Unreadable) -> Self {
        Self { what: what.into_owned(), span }
    }
}

/// No file that a person would open is as large: what grows like this was made to.
const LARGEST: usize = 64 << 20;

/// How a loop that is being written goes on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Loop<'t> {
    pub(super) continuing: Option<&'t crate::export::typed::Continuing>,
    /// How many `switch`es lie between here and the loop.
    pub(super) switches: u32,
    /// `continue` inside of a `switch` cannot break out of the loop: it tells this variable.
    pub(super) again: Option<u32>,
}

pub(super) struct Writer<'w, 'a> {
    pub(super) typed: &'w Typed<'a>,
    pub(super) types: Types,
    pub(super) out: String,
    pub(super) cursor: Tok,
    pub(super) names: Names,
    pub(super) helpers: Helpers,
    /// Names of local variables that are not spelled as others of their name.
    pub(super) own_names: FxHashMap<u32, String>,
    /// What a local pointer points to.
    pub(super) places: FxHashMap<u32, String>,
    /// Which variable a local pointer points into.
    pub(super) roots: FxHashMap<u32, Root>,
    /// What is evaluated after what is being written, in the same expression, and does more than give a value.
    pub(super) later: Vec<ExprId>,
    /// Whether the expression that comes next is written to, or part of a larger place.
    pub(super) as_place: bool,
    /// Semicolons of the module that end nothing: GLSL ES has none.
    pub(super) stray: FxHashSet<Tok>,
    /// What is written for a variable of the module.
    pub(super) instead: FxHashMap<u32, String>,
    /// What naga has worked out of constants.
    pub(super) values: FxHashMap<u32, String>,
    pub(super) loops: Vec<Loop<'w>>,
    /// Names of variables that end loops.
    pub(super) again: Vec<String>,
    /// Structs around arrays that are elements of arrays: of which type, and their names.
    pub(super) rows: Vec<(Ty, String)>,
    /// What the function being written gives.
    pub(super) result: Ty,
    /// Whether y grows upward here and downward in WGSL.
    pub(super) flipped: bool,
}

impl Writer<'_, '_> {
    pub(super) fn refuse<T>(&self, what: impl Into<String>, span: Span) -> Written<T> {
        Err(Refusal { what: what.into(), span })
    }

    pub(super) fn put(&mut self, text: &str) {
        self.out.push_str(text);
    }

    /// Copies up to `tok`, without it.
    pub(super) fn upto(&mut self, tok: Tok) {
        while self.cursor < tok {
            self.copy_next();
        }
    }

    /// Copies up to `tok`, and with it.
    pub(super) fn through(&mut self, tok: Tok) {
        self.upto(tok + 1);
    }

    fn copy_next(&mut self) {
        let tok = self.cursor;
        self.cursor += 1;
        let tree = &self.typed.tree;
        if tree.in_attribute[tok as usize] {
            // What separated the attribute from what follows goes with it.
            let next = self.cursor as usize;
            if next < tree.tokens.len() && tree.kind(self.cursor) == TokenKind::Blank {
                self.cursor += 1;
            }
            return;
        }
        let word = tree.word(tok);
        match tree.kind(tok) {
            TokenKind::Blank => blank(word, &mut self.out),
            TokenKind::LineComment => line_comment(word, &mut self.out),
            TokenKind::BlockComment => block_comment(word, &mut self.out),
            TokenKind::Semicolon if self.stray.contains(&tok) => {}
            _ => self.out.push_str(word),
        }
    }

    /// Goes to `tok` and drops what lies between, but for the comments.
    pub(super) fn skip_to(&mut self, tok: Tok) {
        while self.cursor < tok {
            let (kind, word) = (self.typed.tree.kind(self.cursor), self.typed.tree.word(self.cursor));
            match kind {
                TokenKind::LineComment => {
                    let inner = word.trim_start_matches('/').trim();
                    self.out.push_str(" /* ");
                    self.out.push_str(&inner.replace("*/", "* /").replace("/*", "/ *"));
                    self.out.push_str(" */ ");
                }
                TokenKind::BlockComment => block_comment(word, &mut self.out),
                _ => {}
            }
            self.cursor += 1;
        }
        self.cursor = tok;
    }

    /// What `work` writes, apart.
    pub(super) fn apart(&mut self, work: impl FnOnce(&mut Self) -> Written) -> Written<String> {
        let (out, cursor) = (std::mem::take(&mut self.out), self.cursor);
        let outcome = work(self);
        self.cursor = cursor;
        let written = std::mem::replace(&mut self.out, out);
        outcome.map(|()| written)
    }

    /// Refuses to grow without bounds: some constructs are written more than once.
    pub(super) fn bounded(&self, span: Span) -> Written {
        if self.out.len() > LARGEST { self.refuse("a file of this size", span) } else { Ok(()) }
    }

    /// The name of local variable `number`.
    pub(super) fn local_name(&self, number: u32) -> String {
        if let Some(own) = self.own_names.get(&number) {
            return own.clone();
        }
        let word = self.typed.tree.word(self.typed.locals[number as usize].name);
        self.names.get(word).to_owned()
    }

    /// The name of declaration `index`.
    pub(super) fn global_name(&self, index: u32) -> String {
        let word = self.typed.tree.word(self.typed.tree.declarations[index as usize].name);
        self.names.get(word).to_owned()
    }

    /// `ty` as GLSL spells it.
    pub(super) fn type_of(&mut self, ty: Ty, span: Span) -> Written<String> {
        match ty {
            Ty::Nothing => Ok("void".to_owned()),
            Ty::Struct(index) => Ok(self.global_name(index)),
            Ty::Array(index) => {
                let (element, len) = self.types.of_array(index);
                let Some(len) = len else { return self.refuse("an array whose length is not fixed", span) };
                Ok(format!("{}[{len}]", self.element(element, span)?))
            }
            Ty::Pointer(_) => {
                let pointee = self.types.pointee(ty);
                self.type_of(pointee, span)
            }
            Ty::Modf(size) => {
                self.helpers.ask_shaped("modf", Ty::of(size, Scalar::F32));
                Ok(super::helpers::struct_name("modf", size))
            }
            Ty::Frexp(size) => {
                self.helpers.ask_shaped("frexp", Ty::of(size, Scalar::F32));
                Ok(super::helpers::struct_name("frexp", size))
            }
            Ty::Opaque(Opaque::Texture) => self.refuse("a texture apart from its sampler", span),
            Ty::Opaque(Opaque::Sampler) => self.refuse("a sampler apart from its texture", span),
            Ty::Opaque(Opaque::Atomic) => self.refuse("an atomic", span),
            numeric => Ok(spelling::numeric(numeric)),
        }
    }

    /// The type of an array's elements. GLSL ES 3.00 has no arrays of arrays, but arrays of structs that hold one.
    fn element(&mut self, ty: Ty, span: Span) -> Written<String> {
        if !matches!(ty, Ty::Array(_)) {
            return self.type_of(ty, span);
        }
        let ty = self.types.concrete(ty);
        if let Some((_, name)) = self.rows.iter().find(|(known, _)| *known == ty) {
            return Ok(name.clone());
        }
        self.type_of(ty, span)?; // what it holds comes before it
        let name = self.names.fresh_like("Row");
        self.rows.push((ty, name.clone()));
        Ok(name)
    }

    /// The struct around `ty` where it is an element of an array.
    pub(super) fn row(&mut self, ty: Ty, span: Span) -> Written<Option<String>> {
        if matches!(ty, Ty::Array(_)) { self.element(ty, span).map(Some) } else { Ok(None) }
    }

    /// The zero value of `ty`.
    pub(super) fn zero(&mut self, ty: Ty, span: Span) -> Written<String> {
        self.bounded(span)?;
        Ok(match ty {
            Ty::Scalar(scalar) => spelling::zero(scalar).to_owned(),
            Ty::Vector(_, scalar) | Ty::Matrix(_, _, scalar) => {
                format!("{}({})", spelling::numeric(ty), spelling::zero(scalar))
            }
            Ty::Array(index) => {
                let (element, len) = self.types.of_array(index);
                let mut one = self.zero(element, span)?;
                if let Some(row) = self.row(element, span)? {
                    one = format!("{row}({one})");
                }
                let len = len.unwrap_or(0) as usize;
                if one.len().saturating_mul(len) > LARGEST {
                    return self.refuse("an array of this size", span);
                }
                format!("{}({})", self.type_of(ty, span)?, vec![one; len].join(", "))
            }
            Ty::Struct(index) => {
                let members: Vec<Ty> = self.typed.members(index).map(|(_, ty)| ty).collect();
                let mut zeros = Vec::with_capacity(members.len());
                for member in members {
                    zeros.push(self.zero(member, span)?);
                }
                format!("{}({})", self.global_name(index), zeros.join(", "))
            }
            other => {
                return self.refuse("a value of this type", span).and_then(|()| self.type_of(other, span));
            }
        })
    }
}

/// Line breaks that GLSL knows, and nothing that it does not.
fn blank(text: &str, out: &mut String) {
    for c in text.chars() {
        match c {
            ' ' | '\t' | '\n' | '\r' => out.push(c),
            c if crate::syntax::is_line_break(c) => out.push('\n'),
            _ => {}
        }
    }
}

/// A backslash at the end would join the next line to the comment.
fn line_comment(text: &str, out: &mut String) {
    // `///` tells documentation apart in WGSL, and nothing in GLSL; kept, since it is what the author wrote.
    out.push_str(text.trim_end().trim_end_matches('\\'));
}

/// GLSL's comments do not nest.
fn block_comment(text: &str, out: &mut String) {
    let inner = text.strip_prefix("/*").and_then(|text| text.strip_suffix("*/")).unwrap_or_default();
    out.push_str("/*");
    let mut flat = String::with_capacity(inner.len());
    blank_lines(inner, &mut flat);
    out.push_str(&flat.replace("*/", "* /").replace("/*", "/ *"));
    out.push_str("*/");
}

fn blank_lines(text: &str, out: &mut String) {
    out.extend(text.chars().map(|c| if c != '\r' && crate::syntax::is_line_break(c) { '\n' } else { c }));
}
