//! What stands after `#if` and `#elif`: text → [`Expr`].
//!
//! The expression is kept in postfix order, so that reading and deciding it need no recursion: a hostile line of ten
//! thousand brackets costs ten thousand steps and no stack.

use super::cursor::{Cursor, Spanned, Unexpected};
use crate::source::Span;

/// An operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    /// `!`
    Not,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `&&`
    And,
    /// `||`
    Or,
}

impl Operator {
    /// How tightly it binds.
    fn precedence(self) -> u8 {
        match self {
            Self::Or => 1,
            Self::And => 2,
            Self::Equal | Self::NotEqual => 3,
            Self::Less | Self::LessEqual | Self::Greater | Self::GreaterEqual => 4,
            Self::Not => 5,
        }
    }

    /// As it is written.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Not => "!",
            Self::Equal => "==",
            Self::NotEqual => "!=",
            Self::Less => "<",
            Self::LessEqual => "<=",
            Self::Greater => ">",
            Self::GreaterEqual => ">=",
            Self::And => "&&",
            Self::Or => "||",
        }
    }
}

/// One step of an expression in postfix order.
#[derive(Debug, Clone, PartialEq)]
pub enum Term {
    /// `terrain.basis`, `quality`, `simplex`
    Name(String),
    /// `64`, `.5`
    Number(f64),
    /// `true`, `false`
    Bool(bool),
    /// Takes its one or two operands from what came before.
    Apply(Operator),
}

/// A condition in postfix order, each step with the stretch of text that it covers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Expr {
    /// The steps.
    pub terms: Vec<Spanned<Term>>,
}

enum Open {
    Bracket(Span),
    Operator(Spanned<Operator>),
}

/// Reads a whole condition.
pub(super) fn parse(cursor: &mut Cursor<'_>) -> Result<Expr, Unexpected> {
    let mut terms = Vec::new();
    let mut open: Vec<Open> = Vec::new();
    loop {
        // An operand, after any number of `!` and `(`.
        loop {
            let start = cursor.here();
            if cursor.rest().starts_with('!') && !cursor.rest().starts_with("!=") {
                let span = cursor.advance(1).span;
                open.push(Open::Operator(Spanned { value: Operator::Not, span }));
            } else if cursor.take("(") {
                open.push(Open::Bracket(Span::new(start, start + 1)));
            } else {
                break;
            }
        }
        terms.push(operand(cursor)?);
        // Closing brackets, then an operator or the end.
        let operator = loop {
            if cursor.at_end() {
                break None;
            }
            let start = cursor.here();
            if !cursor.take(")") {
                break Some(binary(cursor)?);
            }
            loop {
                match open.pop() {
                    Some(Open::Operator(operator)) => terms.push(apply(operator)),
                    Some(Open::Bracket(_)) => break,
                    None => {
                        return Err(Unexpected {
                            expected: "an operator or the end of the line".into(),
                            span: Span::new(start, start + 1),
                        });
                    }
                }
            }
        };
        let Some(operator) = operator else { break };
        while let Some(Open::Operator(top)) = open.last() {
            if top.value.precedence() < operator.value.precedence() {
                break;
            }
            terms.push(apply(top.clone()));
            open.pop();
        }
        open.push(Open::Operator(operator));
    }
    while let Some(last) = open.pop() {
        match last {
            Open::Operator(operator) => terms.push(apply(operator)),
            Open::Bracket(span) => return Err(Unexpected { expected: "`)` for this `(`".into(), span }),
        }
    }
    Ok(Expr { terms })
}

fn apply(operator: Spanned<Operator>) -> Spanned<Term> {
    Spanned { value: Term::Apply(operator.value), span: operator.span }
}

fn operand(cursor: &mut Cursor<'_>) -> Result<Spanned<Term>, Unexpected> {
    const WHAT: &str = "an option, a number, `true`, `false` or `(`";
    if cursor.peek().is_some_and(|c| c.is_ascii_digit() || matches!(c, '.' | '-' | '+')) {
        let number = cursor.number(WHAT)?;
        let value = number.value.parse().unwrap_or(f64::INFINITY);
        return Ok(Spanned { value: Term::Number(value), span: number.span });
    }
    let first = cursor.ident(WHAT)?;
    let mut span = first.span;
    let value = match first.value {
        "true" => Term::Bool(true),
        "false" => Term::Bool(false),
        name if cursor.rest().starts_with('.') => {
            cursor.expect(".")?;
            let member = cursor.ident("a name after the `.`")?;
            span = span.to(member.span);
            Term::Name(format!("{name}.{}", member.value))
        }
        name => Term::Name(name.to_owned()),
    };
    Ok(Spanned { value, span })
}

fn binary(cursor: &mut Cursor<'_>) -> Result<Spanned<Operator>, Unexpected> {
    use Operator::*;
    // Two characters before one.
    for operator in [Equal, NotEqual, LessEqual, GreaterEqual, And, Or, Less, Greater] {
        let start = cursor.here();
        if cursor.take(operator.symbol()) {
            return Ok(Spanned { value: operator, span: Span::new(start, start + operator.symbol().len()) });
        }
    }
    cursor.unexpected("`==`, `!=`, `<`, `<=`, `>`, `>=`, `&&`, `||` or the end of the line")
}
