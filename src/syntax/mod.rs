//! Text → tokens → directives and declarations. Knows WGSL's spelling and scopes, and nothing of its types.

mod condition;
mod cursor;
mod declaration;
mod directive;
mod fragment;
mod lexer;
mod split;
mod token;
mod value;

pub use condition::{Expr, Operator, Term};
pub use cursor::Spanned;
pub use declaration::{Declaration, DeclarationKind, Module, Reference, Stage, Symbol, signature};
pub use directive::{
    Directive, DirectiveError, DirectiveKind, Include, Signature, Slot, nearest_directive, parse_directive,
    plain_type,
};
pub use fragment::{Fragment, Placed, parse_fragment};
pub use lexer::{is_ident, is_line_break, is_reserved, lex};
pub use split::split;
pub use token::{Token, TokenKind, Tokens};
pub use value::{Key, OptionDecl, OptionKind, OptionValue, ParamDecl, Type, Value};
