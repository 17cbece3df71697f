//! The lossless WGSL lexer: text → [`Tokens`], one pass, any input.
//!
//! Follows the WGSL specification's chapter 3 (textual structure): blank space and line breaks as it names them, nested
//! block comments, identifiers of UAX 31, every form of literal, the longest operator that fits, and template lists found
//! as §3.9 describes, so that `array<vec2<f32>>` and `a >> b` come out right. A line whose first character past blank
//! space is `#` is one [`TokenKind::Directive`].

use std::sync::LazyLock;

use rustc_hash::FxHashSet;

use super::token::{Token, TokenKind, Tokens};

/// Splits `text` into tokens; concatenated they are `text` again. Never fails and never recurses.
pub fn lex(text: &str) -> Tokens {
    let mut lexer = Lexer {
        text,
        bytes: text.as_bytes(),
        at: 0,
        list: Vec::with_capacity(text.len() / 3),
        line_start: true,
        after_name: false,
        depth: 0,
        pending: Vec::new(),
    };
    while lexer.at < text.len() {
        lexer.step();
    }
    Tokens::new(lexer.list, text.len())
}

/// Whether `c` can start an identifier.
pub(super) fn starts_ident(c: char) -> bool {
    c == '_' || if c.is_ascii() { c.is_ascii_alphabetic() } else { unicode_ident::is_xid_start(c) }
}

/// Whether `c` can go on in an identifier.
pub(super) fn continues_ident(c: char) -> bool {
    if c.is_ascii() { c == '_' || c.is_ascii_alphanumeric() } else { unicode_ident::is_xid_continue(c) }
}

/// Whether `name` is spelled like an identifier (keywords are, too).
pub fn is_ident(name: &str) -> bool {
    let mut chars = name.chars();
    chars.next().is_some_and(starts_ident) && chars.all(continues_ident) && name != "_"
}

/// Keywords, reserved words and predeclared names of WGSL (its specification's chapters 3, 6 and 17).
static WORDS: LazyLock<FxHashSet<&str>> =
    LazyLock::new(|| include_str!("wgsl_words.txt").split_whitespace().collect());

/// Whether WGSL has another use for `name`, or keeps it for one: a declaration of that name would be an error, or hide a
/// type or a function of WGSL's own.
pub fn is_reserved(name: &str) -> bool {
    WORDS.contains(name) || name == "_" || name.starts_with("__")
}

/// Whether `c` ends a line in WGSL.
pub fn is_line_break(c: char) -> bool {
    matches!(c, '\n' | '\u{b}' | '\u{c}' | '\r' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// Whether `c` is blank space in WGSL (Unicode's `Pattern_White_Space`).
pub(super) fn is_blank(c: char) -> bool {
    is_line_break(c) || matches!(c, ' ' | '\t' | '\u{200e}' | '\u{200f}')
}

/// A `<` that may open a template list.
struct Candidate {
    token: usize,
    depth: u32,
}

struct Lexer<'a> {
    text: &'a str,
    bytes: &'a [u8],
    at: usize,
    list: Vec<Token>,
    /// Only blank space has come since the last line break.
    line_start: bool,
    /// The last token but trivia was an identifier: a `<` may open a template list.
    after_name: bool,
    /// How many `(` and `[` are open (WGSL §3.9).
    depth: u32,
    pending: Vec<Candidate>,
}

impl Lexer<'_> {
    fn push(&mut self, kind: TokenKind, end: usize) {
        self.list.push(Token { kind, start: self.at as u32 });
        self.at = end;
        if kind != TokenKind::Blank {
            self.line_start = false;
        }
        if !kind.is_trivia() {
            self.after_name = kind == TokenKind::Ident;
        }
    }

    fn byte(&self, at: usize) -> u8 {
        self.bytes.get(at).copied().unwrap_or(0)
    }

    fn step(&mut self) {
        let byte = self.bytes[self.at];
        match byte {
            b' ' | b'\t' | b'\n' | b'\r' | 0x0b | 0x0c => self.blank(),
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => self.ident(),
            b'0'..=b'9' => self.number(),
            b'.' if self.byte(self.at + 1).is_ascii_digit() => self.number(),
            b'/' if self.byte(self.at + 1) == b'/' => {
                let end = self.line_end();
                self.push(TokenKind::LineComment, end);
            }
            b'/' if self.byte(self.at + 1) == b'*' => self.block_comment(),
            b'#' if self.line_start => {
                let end = self.line_end();
                self.push(TokenKind::Directive, end);
            }
            _ if byte.is_ascii() => self.punctuation(byte),
            _ => self.beyond_ascii(),
        }
    }

    fn blank(&mut self) {
        let mut end = self.at;
        loop {
            match self.byte(end) {
                b' ' | b'\t' => end += 1,
                b'\n' | b'\r' | 0x0b | 0x0c => {
                    self.line_start = true;
                    end += 1;
                }
                byte if byte.is_ascii() => break,
                _ => match self.text[end..].chars().next() {
                    Some(c) if is_blank(c) => {
                        self.line_start |= is_line_break(c);
                        end += c.len_utf8();
                    }
                    _ => break,
                },
            }
        }
        self.push(TokenKind::Blank, end);
    }

    fn line_end(&self) -> usize {
        let mut end = self.at;
        loop {
            match self.byte(end) {
                b'\n' | b'\r' | 0x0b | 0x0c => return end,
                0 if end >= self.bytes.len() => return end,
                byte if byte.is_ascii() => end += 1,
                _ => match self.text[end..].chars().next() {
                    Some(c) if is_line_break(c) => return end,
                    Some(c) => end += c.len_utf8(),
                    None => return end,
                },
            }
        }
    }

    fn block_comment(&mut self) {
        let mut end = self.at + 2;
        let mut open = 1;
        while open > 0 && end < self.bytes.len() {
            match (self.bytes[end], self.byte(end + 1)) {
                (b'/', b'*') => {
                    open += 1;
                    end += 2;
                }
                (b'*', b'/') => {
                    open -= 1;
                    end += 2;
                }
                _ => end += 1,
            }
        }
        self.push(TokenKind::BlockComment, end);
    }

    fn ident(&mut self) {
        let mut end = self.at;
        loop {
            match self.byte(end) {
                b'a'..=b'z' | b'A'..=b'Z' | b'_' | b'0'..=b'9' => end += 1,
                byte if byte.is_ascii() => break,
                _ => match self.text[end..].chars().next() {
                    Some(c) if continues_ident(c) => end += c.len_utf8(),
                    _ => break,
                },
            }
        }
        let alone = end == self.at + 1 && self.bytes[self.at] == b'_';
        self.push(if alone { TokenKind::Operator } else { TokenKind::Ident }, end);
    }

    fn beyond_ascii(&mut self) {
        match self.text[self.at..].chars().next() {
            Some(c) if is_blank(c) => self.blank(),
            Some(c) if starts_ident(c) => self.ident(),
            Some(c) => self.push(TokenKind::Unknown, self.at + c.len_utf8()),
            None => self.at = self.bytes.len(),
        }
    }

    fn digits(&self, mut at: usize, hex: bool) -> usize {
        while if hex { self.byte(at).is_ascii_hexdigit() } else { self.byte(at).is_ascii_digit() } {
            at += 1;
        }
        at
    }

    fn number(&mut self) {
        let hex = self.bytes[self.at] == b'0' && matches!(self.byte(self.at + 1), b'x' | b'X');
        let mut end = self.digits(if hex { self.at + 2 } else { self.at }, hex);
        let mut float = false;
        if self.byte(end) == b'.' {
            float = true;
            end = self.digits(end + 1, hex);
        }
        let mark = self.byte(end).to_ascii_lowercase();
        if mark == if hex { b'p' } else { b'e' } {
            let sign = usize::from(matches!(self.byte(end + 1), b'+' | b'-'));
            if self.byte(end + 1 + sign).is_ascii_digit() {
                float = true;
                end = self.digits(end + 1 + sign, false);
            }
        }
        match self.byte(end) {
            b'u' | b'i' if !float => end += 1,
            b'f' | b'h' => end += 1, // in a hexadecimal number without exponent, `f` was a digit
            _ => {}
        }
        self.push(TokenKind::Number, end);
    }

    fn punctuation(&mut self, byte: u8) {
        use TokenKind as K;
        let (next, third) = (self.byte(self.at + 1), self.byte(self.at + 2));
        let (kind, len) = match (byte, next) {
            (b'(', _) => (K::ParenOpen, 1),
            (b')', _) => (K::ParenClose, 1),
            (b'[', _) => (K::BracketOpen, 1),
            (b']', _) => (K::BracketClose, 1),
            (b'{', _) => (K::BraceOpen, 1),
            (b'}', _) => (K::BraceClose, 1),
            (b',', _) => (K::Comma, 1),
            (b';', _) => (K::Semicolon, 1),
            (b':', _) => (K::Colon, 1),
            (b'.', _) => (K::Dot, 1),
            (b'@', _) => (K::At, 1),
            (b'<', _) => return self.less(next, third),
            (b'>', _) => return self.greater(next, third),
            (b'=', b'=') | (b'!', b'=') | (b'&', b'&') | (b'|', b'|') | (b'-', b'>') => (K::Operator, 2),
            (b'=', _) => (K::Equal, 1),
            (b'+', b'+') | (b'-', b'-') => (K::Operator, 2),
            (b'+' | b'-' | b'*' | b'/' | b'%' | b'&' | b'|' | b'^', b'=') => (K::Operator, 2),
            (b'+' | b'-' | b'*' | b'/' | b'%' | b'&' | b'|' | b'^' | b'!' | b'~', _) => (K::Operator, 1),
            _ => (K::Unknown, 1),
        };
        // What template lists may not reach across (§3.9).
        match (kind, byte, next) {
            (K::ParenOpen | K::BracketOpen, ..) => self.depth += 1,
            (K::ParenClose | K::BracketClose, ..) => {
                self.drop_pending(self.depth);
                self.depth = self.depth.saturating_sub(1);
            }
            (K::Operator, b'&', b'&') | (K::Operator, b'|', b'|') => self.drop_pending(self.depth),
            (K::Semicolon | K::BraceOpen | K::Colon | K::Equal, ..) => {
                self.pending.clear();
                self.depth = 0;
            }
            _ => {}
        }
        self.push(kind, self.at + len);
    }

    fn drop_pending(&mut self, depth: u32) {
        while self.pending.last().is_some_and(|candidate| candidate.depth >= depth) {
            self.pending.pop();
        }
    }

    fn less(&mut self, next: u8, third: u8) {
        let len = match (next, third) {
            (b'<', b'=') => 3,
            (b'<' | b'=', _) => 2,
            _ => {
                if self.after_name {
                    self.pending.push(Candidate { token: self.list.len(), depth: self.depth });
                }
                1
            }
        };
        self.push(TokenKind::Operator, self.at + len);
    }

    fn greater(&mut self, next: u8, third: u8) {
        if let Some(open) = self.pending.pop_if(|candidate| candidate.depth == self.depth) {
            self.list[open.token].kind = TokenKind::TemplateOpen;
            return self.push(TokenKind::TemplateClose, self.at + 1);
        }
        let len = match (next, third) {
            (b'>', b'=') => 3,
            (b'>' | b'=', _) => 2,
            _ => 1,
        };
        self.push(TokenKind::Operator, self.at + len);
    }
}
