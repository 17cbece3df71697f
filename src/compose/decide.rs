//! Conditions: `#if terrain.basis == simplex && march.steps >= 64` → `true`.

use super::error::{At, ComposeError};
use crate::diagnostic::{choices, nearest};
use crate::preset::{Declarations, Knob, Settings};
use crate::source::FileId;
use crate::syntax::{Expr, Operator, OptionKind, OptionValue, Spanned, Term};

/// Names and values that a condition can ask for.
pub(super) struct Known<'a> {
    pub(super) declarations: &'a Declarations,
    pub(super) settings: &'a Settings,
    /// Of the instance; empty where there is none.
    pub(super) prefix: &'a str,
    /// In an instance: its fragment's group, and the name that the group has there.
    pub(super) renamed: Option<(&'a str, &'a str)>,
}

#[derive(Clone)]
enum Operand<'a> {
    Bool(bool),
    Number(f64),
    /// The value of an enum option.
    Choice {
        index: usize,
        names: &'a [String],
        option: String,
    },
    /// A name that is no option: a choice of what stands on the other side.
    Name(&'a str),
}

impl Operand<'_> {
    fn describe(&self) -> String {
        match self {
            Self::Bool(_) => "a boolean".into(),
            Self::Number(_) => "a number".into(),
            Self::Choice { option, .. } => format!("the choice `{option}`"),
            Self::Name(name) => format!("`{name}`"),
        }
    }
}

impl Known<'_> {
    /// What `name` stands for, with the instance's own group first.
    pub(super) fn find(&self, name: &str) -> Option<Knob> {
        let own = self.renamed.and_then(|(from, to)| {
            let member = name.strip_prefix(from)?.strip_prefix('.')?;
            self.declarations.find(&format!("{to}.{member}"))
        });
        let inner = || self.declarations.find(&format!("{}_{name}", self.prefix));
        let inner = || if self.prefix.is_empty() || !name.contains('.') { None } else { inner() };
        own.or_else(inner).or_else(|| self.declarations.find(name))
    }
}

/// Decides `expr`. Every name is looked up, also on the side of `&&` that cannot change the result: a misspelt option
/// must not hide behind a false one.
pub(super) fn decide(expr: &Expr, file: FileId, known: &Known<'_>) -> Result<bool, ComposeError> {
    let mut stack: Vec<Spanned<Operand<'_>>> = Vec::new();
    for term in &expr.terms {
        let at = (file, term.span);
        let operand = match &term.value {
            Term::Bool(value) => Operand::Bool(*value),
            Term::Number(value) => Operand::Number(*value),
            Term::Name(name) => look_up(name, at, known)?,
            Term::Apply(Operator::Not) => {
                let Some(inner) = stack.pop() else { continue };
                Operand::Bool(!truth(&inner, file, known)?)
            }
            Term::Apply(operator) => {
                let (Some(right), Some(left)) = (stack.pop(), stack.pop()) else { continue };
                let span = left.span.to(right.span);
                let value = Operand::Bool(apply(*operator, &left, &right, at, known)?);
                stack.push(Spanned { value, span });
                continue;
            }
        };
        stack.push(Spanned { value: operand, span: term.span });
    }
    stack.pop().map_or(Ok(false), |last| truth(&last, file, known))
}

fn look_up<'a>(name: &'a str, at: At, known: &Known<'a>) -> Result<Operand<'a>, ComposeError> {
    match known.find(name) {
        Some(Knob::Option(index)) => {
            let decl = &known.declarations.options[index].decl;
            Ok(match (known.settings.options[index], &decl.kind) {
                (OptionValue::Bool(on), _) => Operand::Bool(on),
                (OptionValue::Integer(n), _) => Operand::Number(n as f64),
                (OptionValue::Choice(index), OptionKind::Choice(names)) => {
                    Operand::Choice { index, names, option: decl.key.to_string() }
                }
                (OptionValue::Choice(_), _) => Operand::Bool(false),
            })
        }
        Some(knob @ Knob::Parameter(_)) => Err(ComposeError::ParameterInCondition {
            name: name.into(),
            at,
            declared: known.declarations.place(knob),
        }),
        None if !name.contains('.') => Ok(Operand::Name(name)),
        None => Err(unknown(name, at, known)),
    }
}

fn unknown(name: &str, at: At, known: &Known<'_>) -> ComposeError {
    let options = known.declarations.options.iter().map(|option| option.decl.key.to_string());
    let options: Vec<_> = options.collect();
    let nearest = nearest(name, options.iter().map(String::as_str));
    ComposeError::UnknownOption { name: name.into(), nearest, at }
}

fn truth(operand: &Spanned<Operand<'_>>, file: FileId, known: &Known<'_>) -> Result<bool, ComposeError> {
    match &operand.value {
        Operand::Bool(value) => Ok(*value),
        Operand::Name(name) => Err(unknown(name, (file, operand.span), known)),
        other => Err(ComposeError::NotBool { found: other.describe(), at: (file, operand.span) }),
    }
}

/// The number of a choice, or the number itself: what comparisons compare.
fn apply(
    operator: Operator,
    left: &Spanned<Operand<'_>>,
    right: &Spanned<Operand<'_>>,
    at: At,
    known: &Known<'_>,
) -> Result<bool, ComposeError> {
    use Operand as O;
    if matches!(operator, Operator::And | Operator::Or) {
        let (left, right) = (truth(left, at.0, known)?, truth(right, at.0, known)?);
        return Ok(if operator == Operator::And { left && right } else { left || right });
    }
    let named = |name: &Spanned<Operand<'_>>, text: &str, names: &[String], option: &str| {
        names.iter().position(|known| known == text).ok_or_else(|| ComposeError::UnknownChoice {
            found: text.into(),
            option: option.into(),
            choices: choices(names.iter().map(String::as_str)),
            nearest: nearest(text, names.iter().map(String::as_str)),
            at: (at.0, name.span),
        })
    };
    let (a, b) = match (&left.value, &right.value) {
        (O::Number(a), O::Number(b)) => (*a, *b),
        (O::Choice { index, names, option }, O::Name(text)) => {
            (*index as f64, named(right, text, names, option)? as f64)
        }
        (O::Name(text), O::Choice { index, names, option }) => {
            (named(left, text, names, option)? as f64, *index as f64)
        }
        (O::Bool(a), O::Bool(b)) if matches!(operator, Operator::Equal | Operator::NotEqual) => {
            (f64::from(u8::from(*a)), f64::from(u8::from(*b)))
        }
        (O::Choice { index: a, names: left, .. }, O::Choice { index: b, names: right, .. })
            if left == right =>
        {
            (*a as f64, *b as f64)
        }
        (O::Name(name), _) => return Err(unknown(name, (at.0, left.span), known)),
        (_, O::Name(name)) => return Err(unknown(name, (at.0, right.span), known)),
        (a, b) => return Err(ComposeError::Mismatch { left: a.describe(), right: b.describe(), at }),
    };
    Ok(compare(operator, a, b))
}

/// What a comparison of numbers says; of choices, of their numbers.
pub(super) fn compare(operator: Operator, a: f64, b: f64) -> bool {
    match operator {
        Operator::Equal => a == b,
        Operator::NotEqual => a != b,
        Operator::Less => a < b,
        Operator::LessEqual => a <= b,
        Operator::Greater => a > b,
        _ => a >= b,
    }
}
