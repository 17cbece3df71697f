//! The tree of a WGSL text: declarations, statements and expressions, each by the tokens that it is made of.
//!
//! Nothing is copied out of the text: whoever writes it anew copies tokens, blank space and comments included, and changes
//! only what has to be said in other words.

use crate::syntax::{TokenKind, Tokens};

/// A token, by number.
pub(in crate::export) type Tok = u32;

/// An expression, by number. Type names are expressions too, as in WGSL's own grammar.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(in crate::export) struct ExprId(pub(super) u32);

impl ExprId {
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

/// An expression: tokens `first` to `last`.
#[derive(Debug)]
pub(in crate::export) struct Expr {
    pub(in crate::export) kind: ExprKind,
    pub(in crate::export) first: Tok,
    pub(in crate::export) last: Tok,
    /// How deep it nests.
    pub(super) depth: u32,
}

#[derive(Debug)]
pub(in crate::export) enum ExprKind {
    /// A number, `true` or `false`.
    Literal,
    /// `name`, `name<arguments>`; the name is the first token.
    Name { arguments: Vec<ExprId> },
    /// `callee(arguments)`
    Call { callee: ExprId, arguments: Vec<ExprId> },
    /// `base[index]`
    Index { base: ExprId, index: ExprId },
    /// `base.name`
    Member { base: ExprId, name: Tok },
    /// The operator is the first token.
    Unary { operand: ExprId },
    /// `left operator right`
    Binary { left: ExprId, operator: Tok, right: ExprId },
    /// `(inner)`
    Paren { inner: ExprId },
}

/// `{ … }`
#[derive(Debug)]
pub(in crate::export) struct Block {
    pub(in crate::export) open: Tok,
    pub(in crate::export) statements: Vec<Statement>,
    pub(in crate::export) close: Tok,
}

/// A statement: tokens `first` to `last`, its semicolon included.
#[derive(Debug)]
pub(in crate::export) struct Statement {
    pub(in crate::export) kind: StatementKind,
    pub(in crate::export) first: Tok,
    pub(in crate::export) last: Tok,
}

/// How a local variable is declared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::export) enum Binding {
    Let,
    Var,
    Const,
    Parameter,
}

/// `let name: ty = value`
#[derive(Debug)]
pub(in crate::export) struct Local {
    pub(in crate::export) binding: Binding,
    pub(in crate::export) name: Tok,
    pub(in crate::export) ty: Option<ExprId>,
    pub(in crate::export) value: Option<ExprId>,
    /// Which local variable of the text it is.
    pub(in crate::export) number: u32,
}

/// `if condition { … }`, one of a chain.
#[derive(Debug)]
pub(in crate::export) struct Arm {
    pub(in crate::export) condition: ExprId,
    pub(in crate::export) body: Block,
}

/// `case a, b: { … }`
#[derive(Debug)]
pub(in crate::export) struct Clause {
    pub(in crate::export) first: Tok,
    /// Without an expression: `default`.
    pub(in crate::export) selectors: Vec<Option<ExprId>>,
    pub(in crate::export) body: Block,
}

/// `continuing { … break if condition; }`
#[derive(Debug)]
pub(in crate::export) struct Continuing {
    pub(in crate::export) first: Tok,
    pub(in crate::export) body: Block,
    pub(in crate::export) break_if: Option<ExprId>,
}

#[derive(Debug)]
pub(in crate::export) enum StatementKind {
    Empty,
    Block(Block),
    Local(Local),
    /// `left = right`, `left += right`, …
    Assign {
        left: ExprId,
        operator: Tok,
        right: ExprId,
    },
    /// `_ = right`
    Phony {
        right: ExprId,
    },
    /// `left++`, `left--`
    Step {
        left: ExprId,
    },
    Call(ExprId),
    Return(Option<ExprId>),
    Break,
    Continue,
    Discard,
    If {
        arms: Vec<Arm>,
        otherwise: Option<Block>,
    },
    Switch {
        selector: ExprId,
        open: Tok,
        clauses: Vec<Clause>,
    },
    Loop {
        body: Block,
        continuing: Option<Continuing>,
    },
    While {
        condition: ExprId,
        body: Block,
    },
    For {
        open: Tok,
        init: Option<Box<Statement>>,
        condition: Option<ExprId>,
        step: Option<Box<Statement>>,
        close: Tok,
        body: Block,
    },
    Assert,
}

/// `@name(argument, …)`
#[derive(Debug, Clone)]
pub(in crate::export) struct Attribute {
    pub(in crate::export) name: Tok,
    pub(in crate::export) arguments: Vec<ExprId>,
}

/// A member of a struct or a parameter of a function.
#[derive(Debug)]
pub(in crate::export) struct Field {
    pub(in crate::export) attributes: Vec<Attribute>,
    pub(in crate::export) name: Tok,
    pub(in crate::export) ty: ExprId,
    /// Of a parameter: which local variable of the text it is.
    pub(in crate::export) number: u32,
}

#[derive(Debug)]
pub(in crate::export) struct Function {
    pub(in crate::export) parameters: Vec<Field>,
    pub(in crate::export) open: Tok,
    pub(in crate::export) close: Tok,
    pub(in crate::export) result: Option<ExprId>,
    pub(in crate::export) result_attributes: Vec<Attribute>,
    pub(in crate::export) body: Block,
}

#[derive(Debug)]
pub(in crate::export) enum DeclKind {
    /// `enable`, `requires`, `diagnostic`
    Directive,
    Assert,
    Alias(ExprId),
    Const {
        ty: Option<ExprId>,
        value: ExprId,
    },
    Override {
        ty: Option<ExprId>,
        value: Option<ExprId>,
    },
    /// A variable in the address space that the token names, if any.
    Var {
        space: Option<Tok>,
        ty: Option<ExprId>,
        value: Option<ExprId>,
    },
    Struct {
        open: Tok,
        members: Vec<Field>,
        close: Tok,
    },
    Function(Box<Function>),
}

/// A declaration of the module: tokens `first` to `last`, attributes and semicolon included.
#[derive(Debug)]
pub(in crate::export) struct Decl {
    pub(in crate::export) kind: DeclKind,
    pub(in crate::export) name: Tok,
    pub(in crate::export) first: Tok,
    pub(in crate::export) last: Tok,
}

/// All of it.
pub(in crate::export) struct Tree<'a> {
    pub(in crate::export) text: &'a str,
    pub(in crate::export) tokens: Tokens,
    pub(in crate::export) declarations: Vec<Decl>,
    pub(super) expressions: Vec<Expr>,
    /// Of each token, whether it belongs to an attribute.
    pub(in crate::export) in_attribute: Vec<bool>,
    /// How many local variables there are.
    pub(super) locals: u32,
}

impl<'a> Tree<'a> {
    pub(in crate::export) fn expr(&self, id: ExprId) -> &Expr {
        &self.expressions[id.index()]
    }

    /// What token `tok` says.
    pub(in crate::export) fn word(&self, tok: Tok) -> &'a str {
        &self.text[self.tokens.span(tok as usize).range()]
    }

    pub(in crate::export) fn kind(&self, tok: Tok) -> TokenKind {
        self.tokens.kind(tok as usize)
    }

    /// The next token after `tok` but blank space and comments.
    pub(in crate::export) fn next(&self, tok: Tok) -> Tok {
        let mut next = tok + 1;
        while (next as usize) < self.tokens.len() && self.kind(next).is_trivia() {
            next += 1;
        }
        next
    }

    /// Every name in an expression, and the token that says it.
    pub(in crate::export) fn names(&self) -> impl Iterator<Item = (ExprId, Tok)> {
        let all = self.expressions.iter().enumerate();
        all.filter(|(_, expr)| matches!(expr.kind, ExprKind::Name { .. }))
            .map(|(index, expr)| (ExprId(index as u32), expr.first))
    }

    /// Without the parentheses around it.
    pub(in crate::export) fn bare(&self, mut id: ExprId) -> ExprId {
        while let ExprKind::Paren { inner } = self.expr(id).kind {
            id = inner;
        }
        id
    }

    /// Where the expression stands in the text.
    pub(in crate::export) fn span(&self, id: ExprId) -> crate::source::Span {
        let expr = self.expr(id);
        self.span_of(expr.first, expr.last)
    }

    /// Where tokens `first` to `last` stand in the text.
    pub(in crate::export) fn span_of(&self, first: Tok, last: Tok) -> crate::source::Span {
        crate::source::Span {
            start: self.tokens.span(first as usize).start,
            end: self.tokens.span(last as usize).end,
        }
    }

    /// The arguments of the attribute `name`, if it is there.
    pub(in crate::export) fn attribute<'t>(
        &self,
        attributes: &'t [Attribute],
        name: &str,
    ) -> Option<&'t Attribute> {
        attributes.iter().find(|attribute| self.word(attribute.name) == name)
    }
}
