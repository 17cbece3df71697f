//! What constant expressions of abstract numbers come to: WGSL works them out in 64 bits before it picks a type.

use std::cmp::Ordering;

use super::infer::{Meaning, Typed};
use super::tree::*;

/// A number, with what 32-bit floats make of the same calculation, step by step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::export) enum Number {
    Int(i64),
    Float { exact: f64, single: f32 },
}

impl Number {
    fn exact(self) -> f64 {
        match self {
            Self::Int(value) => value as f64,
            Self::Float { exact, .. } => exact,
        }
    }

    fn single(self) -> f32 {
        match self {
            Self::Int(value) => value as f32,
            Self::Float { single, .. } => single,
        }
    }

    /// Whether the comparison `operator` with `other` holds, and whether it does for 32-bit floats.
    pub(in crate::export) fn compare(self, operator: &str, other: Self) -> Option<(bool, bool)> {
        let holds = |order: Option<Ordering>| {
            Some(match operator {
                "==" => order == Some(Ordering::Equal),
                "!=" => order != Some(Ordering::Equal),
                "<" => order == Some(Ordering::Less),
                "<=" => matches!(order, Some(Ordering::Less | Ordering::Equal)),
                ">" => order == Some(Ordering::Greater),
                ">=" => matches!(order, Some(Ordering::Greater | Ordering::Equal)),
                _ => return None,
            })
        };
        if let (Self::Int(a), Self::Int(b)) = (self, other) {
            let order = holds(Some(a.cmp(&b)))?;
            return Some((order, order));
        }
        let exact = holds(self.exact().partial_cmp(&other.exact()))?;
        Some((exact, holds(self.single().partial_cmp(&other.single()))?))
    }
}

impl Typed<'_> {
    /// The value of a constant scalar, as far as it is made of numbers, constants and arithmetic.
    pub(in crate::export) fn number(&self, id: ExprId) -> Option<Number> {
        match &self.tree.expr(id).kind {
            ExprKind::Literal => literal(self.tree.word(self.tree.expr(id).first)),
            ExprKind::Paren { inner } => self.number(*inner),
            ExprKind::Name { .. } => match self.meaning(id) {
                Meaning::Global(index) => match &self.tree.declarations[index as usize].kind {
                    DeclKind::Const { value, .. } => self.number(*value),
                    _ => None,
                },
                Meaning::Local(number) => self.number(*self.constants.get(&number)?),
                _ => None,
            },
            ExprKind::Unary { operand } => {
                let operand = self.number(*operand)?;
                match (self.tree.word(self.tree.expr(id).first), operand) {
                    ("-", Number::Int(value)) => Some(Number::Int(value.checked_neg()?)),
                    ("-", Number::Float { exact, single }) => {
                        Some(Number::Float { exact: -exact, single: -single })
                    }
                    _ => None,
                }
            }
            ExprKind::Binary { left, operator, right } => {
                combine(self.tree.word(*operator), self.number(*left)?, self.number(*right)?)
            }
            ExprKind::Call { callee, arguments } => self.converted(*callee, arguments),
            _ => None,
        }
    }

    /// `u32(4)` and `i32(4)`.
    fn converted(&self, callee: ExprId, arguments: &[ExprId]) -> Option<Number> {
        let [only] = arguments else { return None };
        match (self.meaning(callee), self.number(*only)?) {
            (Meaning::Type(super::Ty::U32 | super::Ty::I32), Number::Int(value)) => Some(Number::Int(value)),
            _ => None,
        }
    }

    /// The value of a constant integer.
    pub(in crate::export) fn integer(&self, id: ExprId) -> Option<i64> {
        match self.number(id)? {
            Number::Int(value) => Some(value),
            Number::Float { .. } => None,
        }
    }
}

fn combine(operator: &str, a: Number, b: Number) -> Option<Number> {
    if let (Number::Int(a), Number::Int(b)) = (a, b) {
        return Some(Number::Int(match operator {
            "+" => a.checked_add(b)?,
            "-" => a.checked_sub(b)?,
            "*" => a.checked_mul(b)?,
            "/" => a.checked_div(b)?,
            "%" => a.checked_rem(b)?,
            "&" => a & b,
            "|" => a | b,
            "^" => a ^ b,
            "<<" => a.checked_shl(u32::try_from(b).ok()?).filter(|_| b < 63)?,
            ">>" => a.checked_shr(u32::try_from(b).ok()?)?,
            _ => return None,
        }));
    }
    let both = |exact: f64, single: f32| Some(Number::Float { exact, single });
    let (x, y, s, t) = (a.exact(), b.exact(), a.single(), b.single());
    match operator {
        "+" => both(x + y, s + t),
        "-" => both(x - y, s - t),
        "*" => both(x * y, s * t),
        "/" => both(x / y, s / t),
        "%" => both(x % y, s % t),
        _ => None,
    }
}

/// What the literal `word` says.
pub(super) fn literal(word: &str) -> Option<Number> {
    let plain = word.trim_end_matches(['u', 'i']);
    if let Some(hex) = plain.strip_prefix("0x").or_else(|| plain.strip_prefix("0X")) {
        return if hex.contains(['.', 'p', 'P']) {
            hex_float(hex)
        } else {
            i64::from_str_radix(hex, 16).ok().map(Number::Int)
        };
    }
    if let Ok(value) = plain.parse::<i64>() {
        return Some(Number::Int(value));
    }
    let exact = plain.trim_end_matches(['f', 'h']).parse::<f64>().ok()?;
    Some(Number::Float { exact, single: exact as f32 })
}

/// `1.8p-3f` without its `0x`.
fn hex_float(text: &str) -> Option<Number> {
    let (digits, exponent) = text.split_once(['p', 'P']).unwrap_or((text, "0"));
    let exponent: i32 = exponent.trim_end_matches(['f', 'h']).parse().ok()?;
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let mut value = 0.0f64;
    for digit in whole.chars().chain(fraction.chars()) {
        value = value * 16.0 + f64::from(digit.to_digit(16)?);
    }
    let exact = value * 2f64.powi(exponent.checked_sub(4 * fraction.len() as i32)?);
    Some(Number::Float { exact, single: exact as f32 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_are_read_as_wgsl_spells_them() {
        assert_eq!(literal("0xFFu"), Some(Number::Int(255)));
        assert_eq!(literal("12"), Some(Number::Int(12)));
        assert_eq!(literal("1.5f"), Some(Number::Float { exact: 1.5, single: 1.5 }));
        assert_eq!(literal("0x1.8p3"), Some(Number::Float { exact: 12.0, single: 12.0 }));
        assert_eq!(literal("1e3"), Some(Number::Float { exact: 1000.0, single: 1000.0 }));
    }
}
