//! Reads the inside of one directive, character by character, and says where it stopped.

use super::lexer::{continues_ident, is_blank, starts_ident};
use crate::source::Span;

/// What is wrong in a directive: expected this, there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Unexpected {
    /// What should have stood there.
    pub expected: String,
    /// Where.
    pub span: Span,
}

/// A piece of text with its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Spanned<T> {
    /// The thing.
    pub value: T,
    /// Where it stands.
    pub span: Span,
}

pub(super) struct Cursor<'a> {
    text: &'a str,
    at: usize,
    /// Where `text` starts in its file.
    base: usize,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(text: &'a str, base: usize) -> Self {
        Self { text, at: 0, base }
    }

    pub(super) fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn skip_blank(&mut self) {
        self.at = self.text.len() - self.rest().trim_start_matches(is_blank).len();
    }

    /// Where the next thing starts.
    pub(super) fn here(&mut self) -> usize {
        self.skip_blank();
        self.base + self.at
    }

    pub(super) fn peek(&mut self) -> Option<char> {
        self.skip_blank();
        self.rest().chars().next()
    }

    /// Whether nothing but a comment is left.
    pub(super) fn at_end(&mut self) -> bool {
        self.skip_blank();
        self.rest().is_empty() || self.rest().starts_with("//")
    }

    pub(super) fn unexpected<T>(&mut self, expected: impl Into<String>) -> Result<T, Unexpected> {
        let start = self.here();
        let word =
            self.rest().find(|c: char| is_blank(c) || ",(){}=".contains(c)).unwrap_or(self.rest().len());
        let first = self.rest().chars().next().map_or(0, char::len_utf8);
        let len = if self.at_end() { 0 } else { word.max(first) };
        Err(Unexpected { expected: expected.into(), span: Span::new(start, start + len) })
    }

    pub(super) fn take(&mut self, mark: &str) -> bool {
        self.skip_blank();
        let found = self.rest().starts_with(mark);
        if found {
            self.at += mark.len();
        }
        found
    }

    pub(super) fn expect(&mut self, mark: &str) -> Result<(), Unexpected> {
        if self.take(mark) { Ok(()) } else { self.unexpected(format!("`{mark}`")) }
    }

    pub(super) fn ident(&mut self, what: &str) -> Result<Spanned<&'a str>, Unexpected> {
        self.skip_blank();
        let rest = self.rest();
        if !rest.starts_with(starts_ident) {
            return self.unexpected(what);
        }
        let len = rest.find(|c| !continues_ident(c)).unwrap_or(rest.len());
        Ok(self.advance(len))
    }

    /// Takes the word if it comes next, as a whole word.
    pub(super) fn word(&mut self, word: &str) -> bool {
        self.skip_blank();
        let next = self.rest().strip_prefix(word).map(|after| !after.starts_with(continues_ident));
        if next == Some(true) {
            self.at += word.len();
        }
        next == Some(true)
    }

    /// A number as it is spelled: sign, digits, point, exponent. A second point ends it, so that `0..1` is a range.
    pub(super) fn number(&mut self, what: &str) -> Result<Spanned<&'a str>, Unexpected> {
        self.skip_blank();
        let rest = self.rest().as_bytes();
        let mut len = usize::from(matches!(rest.first(), Some(b'-' | b'+')));
        let digits = |mut at: usize| {
            while rest.get(at).is_some_and(u8::is_ascii_digit) {
                at += 1;
            }
            at
        };
        let whole = digits(len);
        let mut any = whole > len;
        len = whole;
        if rest.get(len) == Some(&b'.') && rest.get(len + 1) != Some(&b'.') {
            let end = digits(len + 1);
            any |= end > len + 1;
            len = end;
        }
        if matches!(rest.get(len), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(rest.get(len + 1), Some(b'-' | b'+')));
            let end = digits(len + 1 + sign);
            if end > len + 1 + sign {
                len = end;
            }
        }
        let ends = self.rest()[len..].chars().next().is_none_or(|c| !continues_ident(c));
        if any && ends { Ok(self.advance(len)) } else { self.unexpected(what) }
    }

    /// Everything up to `end`, without it.
    pub(super) fn until(&mut self, end: char) -> Result<Spanned<&'a str>, Unexpected> {
        match self.rest().find(end) {
            Some(len) => {
                let piece = self.advance(len);
                self.at += end.len_utf8();
                Ok(piece)
            }
            None => {
                let at = self.base + self.text.len();
                Err(Unexpected { expected: format!("`{end}`"), span: Span::new(at, at) })
            }
        }
    }

    /// The next `len` bytes.
    pub(super) fn advance(&mut self, len: usize) -> Spanned<&'a str> {
        let start = self.at;
        self.at += len;
        Spanned { value: &self.text[start..self.at], span: Span::new(self.base + start, self.base + self.at) }
    }
}
