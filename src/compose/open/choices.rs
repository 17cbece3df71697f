//! What can be chosen, as features that are on or off: options → [`Choices`], and conditions over them → [`Formula`].
//!
//! With no feature on, every option has its default. A choice among names has a feature for each other name
//! (`terrain_basis_simplex`), a bool one for the other value (`terrain_eroded`, or `no_terrain_eroded` where true is the
//! default), a whole number one for each stretch of values that conditions tell apart, named by the largest of them.

use super::formula::{Formula, Full, Values};
use crate::compose::decide::{Known, compare};
use crate::preset::{Declarations, Knob, Settings};
use crate::syntax::{Expr, Operator, OptionKind, OptionValue, Term};

/// How many values of one option conditions may tell apart.
pub(super) const MOST: usize = 64;

/// How many steps a condition may have.
pub(super) const LONGEST: usize = 256;

/// The values of one option that conditions tell apart.
#[derive(Debug, Clone)]
pub(crate) struct Domain {
    /// What comparisons compare: of names their number, of false and true 0 and 1.
    values: Vec<f64>,
    /// The feature that chooses each value; none for the default.
    pub(crate) features: Vec<Option<String>>,
    /// Each value as presets write it.
    pub(crate) shown: Vec<String>,
}

/// The domains of all options.
pub(crate) struct Choices {
    /// By the option's number.
    pub(crate) domains: Vec<Domain>,
    /// All values of each.
    pub(crate) full: Full,
}

/// Why a condition is no formula.
pub(super) enum NoFormula {
    /// It has too many steps.
    Long,
    /// An option has too many values that conditions tell apart.
    Many(usize),
}

impl Choices {
    /// The domains of the options in `declarations`, with `settings` as their defaults. `cuts` are, by option, the whole
    /// numbers between which and the next one a condition decides otherwise.
    pub(super) fn new(
        declarations: &Declarations,
        settings: &Settings,
        cuts: &[Vec<i64>],
    ) -> Result<Self, NoFormula> {
        let mut domains = Vec::new();
        for (index, declared) in declarations.options.iter().enumerate() {
            let flat = declared.decl.key.flat();
            domains.push(match (&declared.decl.kind, settings.options[index]) {
                (OptionKind::Choice(names), chosen) => {
                    let is_default = |at: usize| chosen == OptionValue::Choice(at);
                    let feature = |(at, name)| (!is_default(at)).then(|| format!("{flat}_{name}"));
                    Domain {
                        values: (0..names.len()).map(|at| at as f64).collect(),
                        features: names.iter().enumerate().map(feature).collect(),
                        shown: names.clone(),
                    }
                }
                (OptionKind::Bool, chosen) => {
                    let features = if chosen == OptionValue::Bool(true) {
                        vec![Some(format!("no_{flat}")), None]
                    } else {
                        vec![None, Some(flat)]
                    };
                    Domain { values: vec![0.0, 1.0], features, shown: vec!["false".into(), "true".into()] }
                }
                (OptionKind::Integer(range), chosen) => integers(&flat, *range, chosen, &cuts[index]),
            });
            if domains[index].values.len() > MOST {
                return Err(NoFormula::Many(index));
            }
        }
        let full = domains.iter().map(|domain| {
            let default = domain.features.iter().position(Option::is_none).unwrap_or(0);
            Values { all: u64::MAX >> (64 - domain.values.len().max(1)), default: 1 << default }
        });
        let full = full.collect();
        Ok(Self { domains, full })
    }

    /// The feature that chooses `value` of option number `option`; none where it is the default.
    pub(crate) fn feature(&self, option: usize, value: OptionValue) -> Option<&str> {
        let domain = &self.domains[option];
        let value = number(value);
        // A stretch of whole numbers goes up to the value that it is named by.
        let at = domain.values.iter().position(|known| value <= *known)?;
        domain.features[at].as_deref()
    }

    /// `formula` as WESL's attributes say it.
    pub(crate) fn wesl(&self, formula: &Formula) -> String {
        match formula {
            Formula::Is(option, values) => {
                let domain = &self.domains[*option];
                let features = domain.features.iter().enumerate();
                let has_default = features.clone().any(|(at, name)| name.is_none() && values >> at & 1 == 1);
                let named = features
                    .filter(|(at, _)| (values >> at & 1 == 1) != has_default)
                    .filter_map(|(_, name)| name.as_deref());
                if has_default {
                    named.map(|name| format!("!{name}")).collect::<Vec<_>>().join(" && ")
                } else {
                    named.collect::<Vec<_>>().join(" || ")
                }
            }
            Formula::All(parts) if parts.is_empty() => "true".into(),
            Formula::Any(parts) if parts.is_empty() => "false".into(),
            Formula::All(parts) => self.joined(parts, " && "),
            Formula::Any(parts) => self.joined(parts, " || "),
        }
    }

    fn joined(&self, parts: &[Formula], operator: &str) -> String {
        let other = if operator == " && " { "||" } else { "&&" };
        let part = |part: &Formula| {
            let text = self.wesl(part);
            if text.contains(other) { format!("({text})") } else { text }
        };
        parts.iter().map(part).collect::<Vec<_>>().join(operator)
    }

    /// `expr` as a formula. It has been decided once, so that names and types are known to fit.
    pub(super) fn formula(&self, expr: &Expr, known: &Known<'_>) -> Result<Formula, NoFormula> {
        if expr.terms.len() > LONGEST {
            return Err(NoFormula::Long);
        }
        let mut stack: Vec<Operand<'_>> = Vec::new();
        for term in &expr.terms {
            let operand = match &term.value {
                Term::Bool(true) => Operand::Formula(Formula::ALWAYS),
                Term::Bool(false) => Operand::Formula(Formula::NEVER),
                Term::Number(value) => Operand::Number(*value),
                Term::Name(name) => match known.find(name) {
                    Some(Knob::Option(index)) => Operand::Option(index),
                    _ => Operand::Name(name),
                },
                Term::Apply(Operator::Not) => match stack.pop() {
                    Some(inner) => Operand::Formula(self.truth(inner).not(&self.full)),
                    None => continue,
                },
                Term::Apply(operator) => match (stack.pop(), stack.pop()) {
                    (Some(right), Some(left)) => Operand::Formula(self.apply(*operator, left, right, known)),
                    _ => continue,
                },
            };
            stack.push(operand);
        }
        Ok(stack.pop().map_or(Formula::NEVER, |last| self.truth(last)))
    }

    fn truth(&self, operand: Operand<'_>) -> Formula {
        match operand {
            Operand::Formula(formula) => formula,
            Operand::Option(option) => Formula::is(option, 0b10, &self.full),
            Operand::Number(_) | Operand::Name(_) => Formula::NEVER, // deciding it has refused that
        }
    }

    fn apply(&self, operator: Operator, left: Operand<'_>, right: Operand<'_>, known: &Known<'_>) -> Formula {
        match operator {
            Operator::And => return Formula::all([self.truth(left), self.truth(right)], &self.full),
            Operator::Or => return Formula::any([self.truth(left), self.truth(right)], &self.full),
            _ => {}
        }
        if let (Operand::Formula(left), right) | (right, Operand::Formula(left)) =
            (left.clone(), right.clone())
        {
            // Of truths there is only whether they are the same.
            let right = self.truth(right);
            let (not_left, not_right) = (left.not(&self.full), right.not(&self.full));
            let same = Formula::any(
                [Formula::all([left, right], &self.full), Formula::all([not_left, not_right], &self.full)],
                &self.full,
            );
            return if operator == Operator::NotEqual { same.not(&self.full) } else { same };
        }
        let (a, b) = (self.values(&left, &right, known), self.values(&right, &left, known));
        let mut ways = Vec::new();
        for (value_a, when_a) in &a {
            for (value_b, when_b) in &b {
                if compare(operator, *value_a, *value_b) {
                    ways.push(Formula::all([when_a.clone(), when_b.clone()], &self.full));
                }
            }
        }
        Formula::any(ways, &self.full)
    }

    /// The numbers that an operand can be, and when. A name is a choice of the option on the `other` side.
    fn values(&self, operand: &Operand<'_>, other: &Operand<'_>, known: &Known<'_>) -> Vec<(f64, Formula)> {
        match (operand, other) {
            (Operand::Number(value), _) => vec![(*value, Formula::ALWAYS)],
            (Operand::Option(option), _) => {
                let values = self.domains[*option].values.iter().enumerate();
                values.map(|(at, value)| (*value, Formula::is(*option, 1 << at, &self.full))).collect()
            }
            (Operand::Name(name), Operand::Option(option)) => {
                let OptionKind::Choice(names) = &known.declarations.options[*option].decl.kind else {
                    return Vec::new();
                };
                let at = names.iter().position(|known| known == name);
                at.map(|at| (at as f64, Formula::ALWAYS)).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }
}

#[derive(Clone)]
enum Operand<'a> {
    Formula(Formula),
    Number(f64),
    Option(usize),
    Name(&'a str),
}

fn number(value: OptionValue) -> f64 {
    match value {
        OptionValue::Bool(on) => f64::from(u8::from(on)),
        OptionValue::Integer(value) => value as f64,
        OptionValue::Choice(index) => index as f64,
    }
}

/// The stretches of whole numbers between `cuts`, each by its largest; of the default's, by the default.
fn integers(flat: &str, range: Option<(i64, i64)>, chosen: OptionValue, cuts: &[i64]) -> Domain {
    let (low, high) = range.unwrap_or((i64::from(i32::MIN), i64::from(i32::MAX)));
    let chosen = if let OptionValue::Integer(value) = chosen { value } else { low };
    let mut ends: Vec<i64> = cuts.iter().copied().filter(|cut| *cut >= low && *cut < high).collect();
    ends.push(high);
    ends.sort_unstable();
    ends.dedup();
    let default = ends.iter().position(|end| chosen <= *end).unwrap_or(0);
    let feature = |(at, end): (usize, &i64)| {
        let sign = if *end < 0 { "minus_" } else { "" };
        (at != default).then(|| format!("{flat}_{sign}{}", end.unsigned_abs()))
    };
    Domain {
        values: ends.iter().map(|end| *end as f64).collect(),
        features: ends.iter().enumerate().map(feature).collect(),
        shown: ends.iter().map(i64::to_string).collect(),
    }
}

/// Notes, by option, between which whole numbers and the next one `expr` may decide otherwise.
pub(super) fn note_cuts(expr: &Expr, known: &Known<'_>, cuts: &mut [Vec<i64>]) {
    enum Side {
        Number(f64),
        Whole(usize),
        Other,
    }
    let mut stack = Vec::new();
    for term in &expr.terms {
        let side = match &term.value {
            Term::Number(value) => Side::Number(*value),
            Term::Name(name) => match known.find(name) {
                Some(Knob::Option(index)) if is_whole(known, index) => Side::Whole(index),
                _ => Side::Other,
            },
            Term::Bool(_) => Side::Other,
            Term::Apply(Operator::Not) => continue,
            Term::Apply(operator) => {
                match (stack.pop(), stack.pop()) {
                    (Some(Side::Number(number)), Some(Side::Whole(index))) => {
                        cuts[index].extend(ends(*operator, number));
                    }
                    (Some(Side::Whole(index)), Some(Side::Number(number))) => {
                        cuts[index].extend(ends(mirrored(*operator), number));
                    }
                    (Some(Side::Whole(a)), Some(Side::Whole(b))) => {
                        for index in [a, b] {
                            cuts[index].extend(every_value(known, index));
                        }
                    }
                    _ => {}
                }
                Side::Other
            }
        };
        stack.push(side);
    }
}

fn is_whole(known: &Known<'_>, index: usize) -> bool {
    matches!(known.declarations.options[index].decl.kind, OptionKind::Integer(_))
}

/// The values of a whole number, as far as they may be told apart, and one more.
fn every_value(known: &Known<'_>, index: usize) -> Vec<i64> {
    let OptionKind::Integer(range) = known.declarations.options[index].decl.kind else { return Vec::new() };
    let (low, high) = range.unwrap_or((i64::from(i32::MIN), i64::from(i32::MAX)));
    (low..=high).take(MOST + 1).collect()
}

/// `operator` with its sides exchanged.
fn mirrored(operator: Operator) -> Operator {
    match operator {
        Operator::Less => Operator::Greater,
        Operator::LessEqual => Operator::GreaterEqual,
        Operator::Greater => Operator::Less,
        Operator::GreaterEqual => Operator::LessEqual,
        same => same,
    }
}

/// The last whole numbers before `value operator number` changes.
fn ends(operator: Operator, number: f64) -> Vec<i64> {
    let (below, at) = (number.ceil() as i64 - 1, number.floor() as i64); // casts saturate
    match operator {
        Operator::Less | Operator::GreaterEqual => vec![below],
        Operator::LessEqual | Operator::Greater => vec![at],
        _ => vec![below, at],
    }
}
