//! What the lexer hands on.

use crate::source::Span;

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TokenKind {
    /// Blank space, line breaks included.
    Blank,
    /// `// …`, without its line break.
    LineComment,
    /// `/* … */`, nested ones included; to the end of the text where it is never closed.
    BlockComment,
    /// A line that starts with `#`, without its line break.
    Directive,
    /// An identifier or a keyword.
    Ident,
    /// A number, suffix included.
    Number,
    /// `<` that opens a template list.
    TemplateOpen,
    /// `>` that closes a template list.
    TemplateClose,
    /// `(`
    ParenOpen,
    /// `)`
    ParenClose,
    /// `[`
    BracketOpen,
    /// `]`
    BracketClose,
    /// `{`
    BraceOpen,
    /// `}`
    BraceClose,
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// `:`
    Colon,
    /// `.`
    Dot,
    /// `@`
    At,
    /// `=`
    Equal,
    /// Any other operator, the longest that fits: `->`, `<<=`, `&&`, `_` alone, …
    Operator,
    /// A character that no WGSL token starts with.
    Unknown,
}

impl TokenKind {
    /// Whether it is blank space or a comment.
    pub fn is_trivia(self) -> bool {
        matches!(self, Self::Blank | Self::LineComment | Self::BlockComment)
    }
}

/// A token. It ends where the next one starts, so that no byte can be lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Its first byte.
    pub start: u32,
}

/// The tokens of one text. Together they are the text, byte for byte.
#[derive(Debug, Clone, Default)]
pub struct Tokens {
    list: Vec<Token>,
    end: u32,
}

impl Tokens {
    pub(super) fn new(list: Vec<Token>, end: usize) -> Self {
        Self { list, end: end as u32 }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether the text is empty.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// What token `index` is.
    pub fn kind(&self, index: usize) -> TokenKind {
        self.list[index].kind
    }

    /// Where token `index` stands.
    pub fn span(&self, index: usize) -> Span {
        let end = self.list.get(index + 1).map_or(self.end, |next| next.start);
        Span { start: self.list[index].start, end }
    }

    /// Every token with its span.
    pub fn iter(&self) -> impl Iterator<Item = (TokenKind, Span)> {
        (0..self.len()).map(|index| (self.kind(index), self.span(index)))
    }
}
