//! What a decided file declares: [`Module`], and what one declaration of it says.

use super::directive::{DirectiveError, Signature, plain_type};
use super::lexer::lex;
use super::token::TokenKind;
use crate::source::Span;

/// The number of a name in its [`Module`].
pub type Symbol = u32;

/// What a declaration declares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DeclarationKind {
    /// `fn`
    Function,
    /// `struct`
    Struct,
    /// `const`
    Const,
    /// `override`
    Override,
    /// `var`
    Var,
    /// `alias`
    Alias,
    /// `const_assert`
    ConstAssert,
    /// `enable`
    Enable,
    /// `requires`
    Requires,
    /// `diagnostic`
    Diagnostic,
    /// No WGSL: left for naga to complain about.
    Other,
}

/// The stage of an entry point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stage {
    /// `@vertex`
    Vertex,
    /// `@fragment`
    Fragment,
    /// `@compute`
    Compute,
}

/// A use of a module-scope name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reference {
    /// The name.
    pub symbol: Symbol,
    /// Where it stands.
    pub span: Span,
    /// What stands right after a dot behind it: a parameter, or a field.
    pub member: Option<(Symbol, Span)>,
}

/// A top-level declaration.
#[derive(Debug, Clone, PartialEq)]
pub struct Declaration {
    /// What it declares.
    pub kind: DeclarationKind,
    /// Its name, if it has one.
    pub name: Option<(Symbol, Span)>,
    /// The stage, if it is an entry point.
    pub stage: Option<Stage>,
    /// From its first attribute or keyword to its last token.
    pub span: Span,
    /// Its text with all that belongs to it: what is left of it where conditions and directives cut.
    pub pieces: std::ops::Range<usize>,
    /// Names of module scope that it uses, its own among them; in order.
    pub references: std::ops::Range<usize>,
    /// Local variables and parameters that it declares.
    pub locals: std::ops::Range<usize>,
}

/// A decided file.
#[derive(Debug, Clone, Default)]
pub struct Module {
    /// Its declarations in order.
    pub declarations: Vec<Declaration>,
    /// Stretches of text that [`Declaration::pieces`], `head` and `tail` index.
    pub pieces: Vec<Span>,
    /// The comment at the very top, where a blank line sets it off: kept with any of the file's declarations.
    pub head: std::ops::Range<usize>,
    /// What comes after the last declaration.
    pub tail: std::ops::Range<usize>,
    /// What [`Declaration::references`] index.
    pub references: Vec<Reference>,
    /// What [`Declaration::locals`] index.
    pub locals: Vec<(Symbol, Span)>,
    /// The first place of each name.
    pub(super) names: Vec<Span>,
    /// Directives that stand inside a declaration.
    pub errors: Vec<DirectiveError>,
}

impl Module {
    /// How many names there are.
    pub fn symbols(&self) -> usize {
        self.names.len()
    }

    /// The name numbered `symbol`, in the file's `text`.
    pub fn name<'a>(&self, text: &'a str, symbol: Symbol) -> &'a str {
        &text[self.names[symbol as usize].range()]
    }
}

/// The types that the function declared by `text` takes and gives; none where it is no function.
pub fn signature(text: &str) -> Option<Signature> {
    let tokens = lex(text);
    let mut solid = tokens.iter().filter(|(kind, _)| !kind.is_trivia() && *kind != TokenKind::Directive);
    solid.find(|(kind, span)| *kind == TokenKind::Ident && &text[span.range()] == "fn")?;
    solid.find(|(kind, _)| *kind == TokenKind::ParenOpen)?;
    let mut signature = Signature { takes: Vec::new(), gives: None };
    let (mut depth, mut template, mut ty): (u32, u32, Option<String>) = (0, 0, None);
    for (kind, span) in solid.by_ref() {
        match kind {
            TokenKind::ParenOpen => depth += 1,
            TokenKind::TemplateOpen => template += 1,
            TokenKind::TemplateClose => template = template.saturating_sub(1),
            TokenKind::Colon if depth == 0 => {
                ty = Some(String::new());
                continue;
            }
            TokenKind::Comma if depth == 0 && template == 0 => {
                signature.takes.extend(ty.take().map(|ty| plain_type(&ty)));
            }
            TokenKind::ParenClose if depth == 0 => {
                signature.takes.extend(ty.take().map(|ty| plain_type(&ty)));
                break;
            }
            TokenKind::ParenClose => depth -= 1,
            _ => {}
        }
        if let Some(ty) = &mut ty {
            ty.push_str(&text[span.range()]);
        }
    }
    let mut rest = solid.skip_while(|(_, span)| &text[span.range()] != "->");
    if rest.next().is_some() {
        let mut gives = String::new();
        let (mut attribute, mut depth) = (false, 0u32);
        for (kind, span) in rest {
            match kind {
                TokenKind::BraceOpen => break,
                TokenKind::At => attribute = true,
                TokenKind::ParenOpen if attribute => depth += 1,
                TokenKind::ParenClose if attribute => {
                    depth = depth.saturating_sub(1);
                    attribute = depth > 0;
                }
                _ if attribute => {}
                _ => gives.push_str(&text[span.range()]),
            }
        }
        signature.gives = Some(plain_type(&gives));
    }
    Some(signature)
}
