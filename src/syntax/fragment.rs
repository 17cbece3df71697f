//! A whole file: its directives, and how its conditions nest.

use std::sync::{Arc, Mutex, PoisonError};

use super::directive::{Directive, DirectiveError, DirectiveKind, MAX_PREFIXES, parse_directive};
use super::lexer::{is_line_break, lex};
use super::token::{TokenKind, Tokens};
use crate::source::Span;

/// A directive in its file.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// What it says.
    pub directive: Directive,
    /// Its token.
    pub token: usize,
    /// What goes when the directive is taken out: its doc comment, its line, the line break.
    pub removed: Span,
    /// For `#if` and `#elif`: which of the file's conditions this is, counted from 0.
    pub condition: Option<usize>,
}

/// A file, read but not yet decided: conditions are open.
#[derive(Debug)]
pub struct Fragment {
    /// Its text.
    pub text: Arc<str>,
    /// How many tokens it has.
    pub tokens: usize,
    /// All of its directives that could be read, in order.
    pub directives: Vec<Placed>,
    /// How many conditions there are.
    pub conditions: usize,
    /// It has an attribute `@vertex`, `@fragment` or `@compute` outside of every condition.
    pub has_entry_point: bool,
    /// It declares `fn main_image`, the whole picture of a scene.
    pub has_main_image: bool,
    /// What could not be read.
    pub errors: Vec<DirectiveError>,
    /// Its tokens, until it is split. Kept, they would be more than half of what is known of a file, and few files are split
    /// a second time: then they are read anew.
    spare: Mutex<Option<Tokens>>,
}

impl Fragment {
    /// All of its tokens; the caller's to keep or to drop.
    pub(super) fn take_tokens(&self) -> Tokens {
        let spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner).take();
        spare.unwrap_or_else(|| lex(&self.text))
    }
}

/// Reads a file. What is wrong with its directives is in [`Fragment::errors`].
pub fn parse_fragment(text: Arc<str>) -> Fragment {
    let tokens = lex(&text);
    let mut fragment = Fragment {
        text,
        tokens: tokens.len(),
        directives: Vec::new(),
        conditions: 0,
        has_entry_point: false,
        has_main_image: false,
        errors: Vec::new(),
        spare: Mutex::default(),
    };
    // The last token but trivia: `@`, or the word `fn`.
    let (mut after_at, mut after_fn) = (false, false);
    let text = fragment.text.clone();
    // What has come since the last token that was neither blank nor a `///` line: the doc comment of a directive.
    let mut doc: Option<(u32, String)> = None;
    let mut broken_condition = false;
    let mut open_conditions = 0usize;
    let mut prefixes = Prefixes::default();
    for token in 0..tokens.len() {
        let span = tokens.span(token);
        let piece = &text[span.range()];
        match tokens.kind(token) {
            TokenKind::Blank => {
                if piece.chars().filter(|c| *c == '\n').count() > 1 {
                    doc = None;
                }
            }
            TokenKind::LineComment if piece.starts_with("///") && starts_line(&text, span.start) => {
                let line = piece.trim_start_matches('/');
                let (_, lines) = doc.get_or_insert_with(|| (line_start(&text, span.start), String::new()));
                if !lines.is_empty() {
                    lines.push('\n');
                }
                lines.push_str(line.strip_prefix(' ').unwrap_or(line).trim_end());
            }
            TokenKind::Directive => {
                let (doc_start, lines) = doc.take().unzip();
                match parse_directive(piece, span.start as usize, lines.as_deref().unwrap_or("")) {
                    Ok(directive) => {
                        match directive.kind {
                            DirectiveKind::If(_) => open_conditions += 1,
                            DirectiveKind::Endif => open_conditions = open_conditions.saturating_sub(1),
                            _ => {}
                        }
                        let owns_doc = matches!(
                            directive.kind,
                            DirectiveKind::Param(_) | DirectiveKind::Option(_) | DirectiveKind::Slot(_)
                        );
                        let start = doc_start.filter(|_| owns_doc).unwrap_or(line_start(&text, span.start));
                        let end = after_line_break(&text, span.end as usize);
                        fragment.place(directive, token, Span { start, end: end as u32 });
                    }
                    Err(error) => {
                        let name = piece[1..].trim_start();
                        broken_condition |= name.starts_with("if") || name.starts_with("el");
                        fragment.errors.push(error);
                    }
                }
            }
            kind => {
                doc = None;
                if !kind.is_trivia() {
                    let is_word = kind == TokenKind::Ident;
                    fragment.errors.extend(prefixes.pass(piece, span));
                    let is_stage = after_at && matches!(piece, "vertex" | "fragment" | "compute");
                    fragment.has_entry_point |= is_stage && open_conditions == 0;
                    fragment.has_main_image |= after_fn && piece == "main_image";
                    (after_at, after_fn) = (kind == TokenKind::At, is_word && piece == "fn");
                }
            }
        }
    }
    if !broken_condition {
        fragment.check_nesting(); // else every `#endif` of a misspelt `#if` would be a fault too
    }
    fragment.spare = Mutex::new(Some(tokens));
    fragment
}

/// Counts operators that stand in a row.
#[derive(Default)]
struct Prefixes {
    start: Span,
    count: usize,
}

impl Prefixes {
    /// Goes past a token; an error once a row gets too long.
    fn pass(&mut self, piece: &str, span: Span) -> Option<DirectiveError> {
        if !matches!(piece, "!" | "~" | "-" | "&" | "*" | "--" | "&&") {
            self.count = 0;
            return None;
        }
        if self.count == 0 {
            self.start = span;
        }
        self.count += 1;
        (self.count == MAX_PREFIXES + 1).then_some(DirectiveError::Operators { span: self.start })
    }
}

impl Fragment {
    fn place(&mut self, directive: Directive, token: usize, removed: Span) {
        let condition = matches!(directive.kind, DirectiveKind::If(_) | DirectiveKind::Elif(_)).then(|| {
            self.conditions += 1;
            self.conditions - 1
        });
        self.directives.push(Placed { directive, token, removed, condition });
    }

    /// Every `#elif`, `#else` and `#endif` needs its `#if`; every `#if` its `#endif`.
    fn check_nesting(&mut self) {
        let mut open: Vec<(Span, Option<Span>)> = Vec::new();
        for placed in &self.directives {
            let (kind, span) = (&placed.directive.kind, placed.directive.span);
            let alone = |name: &str| DirectiveError::Unbalanced {
                why: format!("this `#{name}` has no `#if`"),
                span,
                other: None,
            };
            match (kind, open.last_mut()) {
                (DirectiveKind::If(_), _) => open.push((span, None)),
                (DirectiveKind::Elif(_), None) => self.errors.push(alone("elif")),
                (DirectiveKind::Else, None) => self.errors.push(alone("else")),
                (DirectiveKind::Endif, None) => self.errors.push(alone("endif")),
                (DirectiveKind::Elif(_) | DirectiveKind::Else, Some((_, Some(before)))) => {
                    self.errors.push(DirectiveError::Unbalanced {
                        why: format!("this `#{}` comes after an `#else`", kind.name()),
                        span,
                        other: Some(*before),
                    });
                }
                (DirectiveKind::Else, Some((_, seen))) => *seen = Some(span),
                (DirectiveKind::Endif, Some(_)) => drop(open.pop()),
                _ => {}
            }
        }
        for (span, _) in open {
            let why = "this `#if` has no `#endif`".into();
            self.errors.push(DirectiveError::Unbalanced { why, span, other: None });
        }
    }

    /// Which directives are in, given the truth of each condition. Of the conditions themselves, none.
    pub fn active(&self, truth: &[bool]) -> Vec<bool> {
        let mut branches = Branches::default();
        let mut active = Vec::with_capacity(self.directives.len());
        for placed in &self.directives {
            let is_condition = branches.pass(placed, truth);
            active.push(!is_condition && branches.active());
        }
        active
    }
}

/// Walks through the conditions of a file and knows whether the place reached is in.
#[derive(Default)]
pub(super) struct Branches {
    /// Of every open `#if`: whether its current branch is in, and whether any has been.
    open: Vec<(bool, bool)>,
    /// How many of them are not in.
    off: usize,
}

impl Branches {
    pub(super) fn active(&self) -> bool {
        self.off == 0
    }

    /// Goes past a directive; says whether it was a condition. Those out of balance (already reported) count for nothing.
    pub(super) fn pass(&mut self, placed: &Placed, truth: &[bool]) -> bool {
        let holds = placed.condition.is_some_and(|index| truth.get(index).copied().unwrap_or(false));
        let change = |open: &mut Vec<(bool, bool)>, holds: bool| {
            let Some((now, ever)) = open.last_mut() else { return (true, true) };
            let before = *now;
            *now = holds && !*ever;
            *ever |= *now;
            (before, *now)
        };
        let (before, after) = match placed.directive.kind {
            DirectiveKind::If(_) => {
                self.open.push((holds, holds));
                (true, holds)
            }
            DirectiveKind::Elif(_) => change(&mut self.open, holds),
            DirectiveKind::Else => change(&mut self.open, true),
            DirectiveKind::Endif => (self.open.pop().is_none_or(|(now, _)| now), true),
            _ => return false,
        };
        self.off = self.off + usize::from(before) - usize::from(after);
        true
    }
}

/// Where the line with byte `at` starts.
fn line_start(text: &str, at: u32) -> u32 {
    text[..at as usize]
        .rfind(is_line_break)
        .map_or(0, |before| before + text[before..].chars().next().map_or(0, char::len_utf8)) as u32
}

fn starts_line(text: &str, at: u32) -> bool {
    text[line_start(text, at) as usize..at as usize].trim().is_empty()
}

/// One past the line break at `at`, if there is one.
pub(super) fn after_line_break(text: &str, at: usize) -> usize {
    let rest = &text[at..];
    match rest.chars().next() {
        Some('\r') if rest.starts_with("\r\n") => at + 2,
        Some(c) if is_line_break(c) => at + c.len_utf8(),
        _ => at,
    }
}
