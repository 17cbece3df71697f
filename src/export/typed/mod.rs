//! A WGSL text → its tree, with the type of every expression and the meaning of every name.
//!
//! naga has accepted the text before; but naga's module has lost what a reader wants back: names of constants, spelling,
//! abstract numbers, the tree itself. So the tree is read again, and typed by WGSL's rules, from the leaves up.

mod builtin;
mod effects;
mod infer;
mod parse;
mod parse_expr;
mod scopes;
mod tree;
mod ty;
mod value;

pub(super) use infer::{Meaning, Typed, type_check};
pub(super) use parse::{Unreadable, parse};
pub(super) use tree::{
    Arm, Attribute, Binding, Block, Clause, Continuing, Decl, DeclKind, ExprId, ExprKind, Field, Function,
    Local as LocalDecl, Statement, StatementKind, Tok,
};
pub(super) use ty::{Opaque, Scalar, Ty, Types};
pub(super) use value::Number;
