//! A fragment with all of its branches in: its `#` lines taken out, and an attribute `@if(…)` before each declaration, statement
//! and member that is in under a condition only.

use super::formula::{Formula, Full};
use crate::source::Span;
use crate::syntax::{DirectiveKind, Fragment, TokenKind, Tokens, lex};

/// A fragment, all branches of it.
pub(super) struct Cut {
    /// The text with attributes.
    pub(super) text: String,
    /// Where each stretch of it starts, where that stands in the fragment, and when it is in.
    stretches: Vec<(usize, u32, Formula)>,
    /// When each directive is in.
    pub(super) directives: Vec<Formula>,
}

impl Cut {
    fn stretch(&self, at: u32) -> Option<&(usize, u32, Formula)> {
        let after = self.stretches.partition_point(|(start, ..)| *start <= at as usize);
        self.stretches.get(after.checked_sub(1)?)
    }

    /// When the byte at `at` of the text is in.
    pub(super) fn presence(&self, at: u32) -> Formula {
        self.stretch(at).map_or(Formula::ALWAYS, |(.., formula)| formula.clone())
    }

    /// Where `span` of the text stands in the fragment.
    pub(super) fn origin(&self, span: Span) -> Span {
        self.stretch(span.start).map_or(span, |(start, from, _)| {
            let from = from + (span.start - *start as u32);
            Span { start: from, end: from + span.len() as u32 }
        })
    }
}

/// What stands between braces, or the file itself.
struct Level {
    /// How many conditions are open where it opens.
    conditions: usize,
    /// In the middle of a declaration, statement or member: how many conditions are open where that starts.
    item: Option<usize>,
    /// How many `(`, `[` and `<` are open in it.
    round: u32,
    kind: Kind,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    File,
    Members,
    Statements,
}

struct Open {
    /// When the current branch is in, of itself.
    now: Formula,
    /// What the branches before it ask for.
    before: Vec<Formula>,
    /// What it asks for itself.
    asks: Formula,
}

struct Cutter<'a> {
    fragment: &'a Fragment,
    tokens: &'a Tokens,
    full: &'a Full,
    cut: Cut,
    from: u32,
    open: Vec<Open>,
    levels: Vec<Level>,
    /// The declaration at hand is a structure.
    is_struct: bool,
}

/// Cuts `fragment`, whose conditions are `conditions`. `word` says a formula as an attribute does.
///
/// # Errors
/// The `#if`, `#elif`, `#else` or `#endif` that stands in the middle of a declaration, statement or member.
pub(super) fn cut(
    fragment: &Fragment,
    conditions: &[Formula],
    full: &Full,
    word: impl Fn(&Formula) -> String,
) -> Result<Cut, Span> {
    let cut = Cut {
        text: String::with_capacity(fragment.text.len()),
        stretches: Vec::new(),
        directives: Vec::new(),
    };
    let level = Level { conditions: 0, item: None, round: 0, kind: Kind::File };
    let tokens = &lex(&fragment.text);
    let mut cutter = Cutter {
        fragment,
        tokens,
        full,
        cut,
        from: 0,
        open: Vec::new(),
        levels: vec![level],
        is_struct: false,
    };
    let mut directives = fragment.directives.iter().peekable();
    for index in 0..tokens.len() {
        let kind = tokens.kind(index);
        if kind == TokenKind::Directive {
            let Some(placed) = directives.next_if(|placed| placed.token == index) else { continue };
            cutter.copy(placed.removed.start);
            cutter.from = placed.removed.end;
            let condition = placed.condition.and_then(|at| conditions.get(at)).cloned();
            cutter.directive(&placed.directive.kind, condition).map_err(|()| placed.directive.span)?;
        } else if !kind.is_trivia() {
            cutter.token(index, &word);
        }
    }
    cutter.copy(fragment.text.len() as u32);
    Ok(cutter.cut)
}

impl Cutter<'_> {
    fn copy(&mut self, until: u32) {
        if until > self.from {
            let formula = Formula::all(self.open.iter().map(|open| open.now.clone()), self.full);
            self.cut.stretches.push((self.cut.text.len(), self.from, formula));
            self.cut.text.push_str(&self.fragment.text[self.from as usize..until as usize]);
            self.from = until;
        }
    }

    fn directive(&mut self, kind: &DirectiveKind, condition: Option<Formula>) -> Result<(), ()> {
        let condition = condition.unwrap_or(Formula::ALWAYS);
        let in_middle = self.levels.last().is_some_and(|level| level.item.is_some());
        let opened_outside = self.levels.last().is_some_and(|level| self.open.len() <= level.conditions);
        match (kind, self.open.last_mut()) {
            (kind, _) if !kind.is_condition() => {}
            _ if in_middle => return Err(()),
            (DirectiveKind::If(_), _) => {
                self.open.push(Open { now: condition.clone(), before: Vec::new(), asks: condition });
            }
            _ if opened_outside => return Err(()),
            (DirectiveKind::Endif, _) => drop(self.open.pop()),
            (_, Some(open)) => {
                open.before.push(std::mem::replace(&mut open.asks, condition.clone()));
                let not_before = open.before.iter().map(|before| before.not(self.full));
                open.now = Formula::all(not_before.chain([condition]), self.full);
            }
            (_, None) => {}
        }
        self.cut.directives.push(Formula::all(self.open.iter().map(|open| open.now.clone()), self.full));
        Ok(())
    }

    fn token(&mut self, index: usize, word: &impl Fn(&Formula) -> String) {
        use TokenKind as K;
        let (kind, span) = (self.tokens.kind(index), self.tokens.span(index));
        let is_file = self.levels.len() == 1;
        let Some(level) = self.levels.last_mut() else { return };
        if level.item.is_none() && !matches!(kind, K::BraceClose | K::Semicolon) {
            level.item = Some(self.open.len());
            let outside = level.conditions;
            let own = self.open[outside.min(self.open.len())..].iter().map(|open| open.now.clone());
            let formula = Formula::all(own, self.full);
            if is_file {
                self.is_struct = false;
            }
            if !formula.is_always() {
                self.copy(span.start);
                let end = if is_file { "\n" } else { " " };
                self.cut.text.push_str(&format!("@if({}){end}", word(&formula)));
            }
        }
        if is_file && kind == K::Ident && &self.fragment.text[span.range()] == "struct" {
            self.is_struct = true;
        }
        let conditions = self.open.len();
        let Some(level) = self.levels.last_mut() else { return };
        match kind {
            K::ParenOpen | K::BracketOpen | K::TemplateOpen => level.round += 1,
            K::ParenClose | K::BracketClose | K::TemplateClose => level.round = level.round.saturating_sub(1),
            K::Semicolon if level.round == 0 && level.kind != Kind::Members => level.item = None,
            K::Comma if level.round == 0 && level.kind == Kind::Members => level.item = None,
            K::BraceOpen => {
                let kind = if is_file && self.is_struct { Kind::Members } else { Kind::Statements };
                self.levels.push(Level { conditions, item: None, round: 0, kind });
            }
            K::BraceClose if !is_file => {
                self.levels.pop();
                if !self.goes_on_with_else(index)
                    && let Some(level) = self.levels.last_mut()
                {
                    level.item = None;
                }
            }
            _ => {}
        }
    }

    /// Whether an `else` comes after the token numbered `index`.
    fn goes_on_with_else(&self, index: usize) -> bool {
        let tokens = self.tokens;
        let next = (index + 1..tokens.len())
            .find(|next| !tokens.kind(*next).is_trivia() && tokens.kind(*next) != TokenKind::Directive);
        next.is_some_and(|next| &self.fragment.text[tokens.span(next).range()] == "else")
    }
}
