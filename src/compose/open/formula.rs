//! What holds under which choices: conditions as sets of options' values.

/// A condition over options. A set of values is a bit for each, in the order of the option's domain.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Formula {
    /// The option of that number has one of these values.
    Is(usize, u64),
    /// All of them hold; none is named: always.
    All(Vec<Formula>),
    /// One of them holds; none is named: never.
    Any(Vec<Formula>),
}

/// All values of each option, and the one that it has where nothing is said.
pub(crate) type Full = Vec<Values>;

/// The values of an option.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Values {
    /// All of them.
    pub(crate) all: u64,
    /// The default.
    pub(crate) default: u64,
}

impl Values {
    /// How many words it takes to say `some` of them: the default has none, and is said by the others' absence.
    fn words(self, some: u64) -> u32 {
        if some & self.default == 0 { some.count_ones() } else { (self.all & !some).count_ones() }
    }
}

impl Formula {
    /// Holds whatever is chosen.
    pub(crate) const ALWAYS: Self = Self::All(Vec::new());
    /// Holds for no choice.
    pub(crate) const NEVER: Self = Self::Any(Vec::new());

    /// Whether it is known to hold whatever is chosen.
    pub(crate) fn is_always(&self) -> bool {
        *self == Self::ALWAYS
    }

    /// Whether it is known to hold for no choice.
    pub(crate) fn is_never(&self) -> bool {
        *self == Self::NEVER
    }

    /// `option` has one of `values`.
    pub(crate) fn is(option: usize, values: u64, full: &Full) -> Self {
        match values & full[option].all {
            0 => Self::NEVER,
            all if all == full[option].all => Self::ALWAYS,
            some => Self::Is(option, some),
        }
    }

    /// It does not hold.
    pub(crate) fn not(&self, full: &Full) -> Self {
        match self {
            Self::Is(option, values) => Self::is(*option, !values, full),
            Self::All(parts) => Self::any(parts.iter().map(|part| part.not(full)), full),
            Self::Any(parts) => Self::all(parts.iter().map(|part| part.not(full)), full),
        }
    }

    /// All of `parts` hold.
    pub(crate) fn all(parts: impl IntoIterator<Item = Self>, full: &Full) -> Self {
        let mut flat = Vec::new();
        for part in parts {
            match part {
                Self::All(inner) => flat.extend(inner),
                other => flat.push(other),
            }
        }
        match merged(flat, true, full) {
            None => Self::NEVER,
            Some(parts) => single(parts, Self::All),
        }
    }

    /// One of `parts` holds.
    pub(crate) fn any(parts: impl IntoIterator<Item = Self>, full: &Full) -> Self {
        let mut flat = Vec::new();
        for part in parts {
            match part {
                Self::Any(inner) => flat.extend(inner),
                other => flat.push(other),
            }
        }
        match merged(flat, false, full) {
            None => Self::ALWAYS,
            Some(parts) => single(parts, Self::Any),
        }
    }

    /// What is left of it once `option` is known to have one of `values`.
    fn given(self, option: usize, values: u64, full: &Full) -> Self {
        match self {
            Self::Is(own, allowed) if own == option => match allowed & values {
                0 => Self::NEVER,
                left if left == values => Self::ALWAYS,
                left => {
                    // What is known not to be may be said or not.
                    let wide = left | (full[own].all & !values);
                    let shorter = full[own].words(wide) < full[own].words(left);
                    Self::Is(own, if shorter { wide } else { left })
                }
            },
            Self::Is(..) => self,
            Self::All(parts) => {
                Self::all(parts.into_iter().map(|part| part.given(option, values, full)), full)
            }
            Self::Any(parts) => {
                Self::any(parts.into_iter().map(|part| part.given(option, values, full)), full)
            }
        }
    }
}

fn single(mut parts: Vec<Formula>, join: fn(Vec<Formula>) -> Formula) -> Formula {
    if parts.len() == 1
        && let Some(only) = parts.pop()
    {
        return only;
    }
    join(parts)
}

/// `parts` with one set of values an option, and without what these sets decide. None where they decide all: of `all`, that
/// it never holds; else, that it always does.
fn merged(parts: Vec<Formula>, all: bool, full: &Full) -> Option<Vec<Formula>> {
    let mut sets: Vec<(usize, u64)> = Vec::new();
    let mut rest: Vec<Formula> = Vec::new();
    for part in parts {
        match part {
            Formula::Is(option, values) => match sets.iter_mut().find(|(known, _)| *known == option) {
                Some((_, known)) if all => *known &= values,
                Some((_, known)) => *known |= values,
                None => sets.push((option, values)),
            },
            other if rest.contains(&other) => {}
            other => rest.push(other),
        }
    }
    if sets.iter().any(|(option, values)| *values == if all { 0 } else { full[*option].all }) {
        return None;
    }
    let mut merged: Vec<Formula> =
        sets.iter().map(|(option, values)| Formula::Is(*option, *values)).collect();
    let mut changed = false;
    for part in rest {
        let known = sets.iter().fold(part.clone(), |part, (option, values)| {
            let known = if all { *values } else { full[*option].all & !values };
            part.given(*option, known, full)
        });
        if known == if all { Formula::NEVER } else { Formula::ALWAYS } {
            return None;
        }
        if known == if all { Formula::ALWAYS } else { Formula::NEVER } {
            continue;
        }
        changed |= known != part;
        if !merged.contains(&known) {
            merged.push(known);
        }
    }
    if !changed {
        return Some(merged);
    }
    // What became simpler may have become a set, or a part of this list.
    let again = if all { Formula::all(merged, full) } else { Formula::any(merged, full) };
    Some(match again {
        Formula::All(parts) if all => parts,
        Formula::Any(parts) if !all => parts,
        Formula::All(parts) if parts.is_empty() => return None,
        Formula::Any(parts) if parts.is_empty() => return None,
        other => vec![other],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Three options of two, three and four values.
    fn full() -> Full {
        [0b11, 0b111, 0b1111].map(|all| Values { all, default: 0b10 }).to_vec()
    }

    fn holds(formula: &Formula, chosen: &[usize]) -> bool {
        match formula {
            Formula::Is(option, values) => values >> chosen[*option] & 1 == 1,
            Formula::All(parts) => parts.iter().all(|part| holds(part, chosen)),
            Formula::Any(parts) => parts.iter().any(|part| holds(part, chosen)),
        }
    }

    fn formulas() -> impl Strategy<Value = Formula> {
        let leaf =
            (0usize..3, any::<u64>()).prop_map(|(option, values)| Formula::is(option, values, &full()));
        leaf.prop_recursive(4, 24, 4, |inner| {
            let list = proptest::collection::vec(inner, 0..4);
            prop_oneof![list.clone().prop_map(Formula::All), list.prop_map(Formula::Any)]
        })
    }

    fn all_choices() -> impl Iterator<Item = [usize; 3]> {
        (0..24).map(|n| [n % 2, n / 2 % 3, n / 6])
    }

    proptest! {
        #[test]
        fn what_is_simplified_holds_where_it_held(a in formulas(), b in formulas()) {
            let full = full();
            let (all, any, not) = (
                Formula::all([a.clone(), b.clone()], &full),
                Formula::any([a.clone(), b.clone()], &full),
                a.not(&full),
            );
            for chosen in all_choices() {
                let (left, right) = (holds(&a, &chosen), holds(&b, &chosen));
                prop_assert_eq!(holds(&all, &chosen), left && right);
                prop_assert_eq!(holds(&any, &chosen), left || right);
                prop_assert_eq!(holds(&not, &chosen), !left);
            }
        }
    }

    #[test]
    fn what_is_known_is_not_said_again() {
        let full = full();
        let (a, b) = (Formula::Is(0, 0b01), Formula::Is(1, 0b001));
        let either = Formula::any([a.clone(), b.clone()], &full);
        assert_eq!(Formula::all([a.clone(), either.clone()], &full), a);
        assert_eq!(
            Formula::all([a.not(&full), either.clone()], &full),
            Formula::all([a.not(&full), b.clone()], &full)
        );
        assert_eq!(Formula::any([either.clone(), a.clone()], &full), either);
        assert!(Formula::any([a.clone(), a.not(&full)], &full).is_always());
        assert!(Formula::all([a.clone(), a.not(&full)], &full).is_never());
        assert_eq!(
            Formula::all([Formula::Is(2, 0b0111), Formula::Is(2, 0b1110)], &full),
            Formula::Is(2, 0b0110)
        );
    }
}
