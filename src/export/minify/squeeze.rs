//! GLSL without comments and blank space: text → text. Names are left alone.

use super::number;

/// `text` squeezed. Lines of the preprocessor stay lines of their own; `header` goes to the top, below `#version`.
pub(super) fn squeeze(text: &str, header: &str) -> String {
    let mut out = String::with_capacity(text.len() / 2);
    let mut header = Some(header);
    let mut last = Last::Line;
    for (kind, piece) in (Pieces { rest: text, line_start: true }) {
        let is_version = kind == Kind::Directive && piece.starts_with("#version");
        if !is_version && let Some(header) = header.take() {
            start_line(&mut out);
            out.push_str(header);
            start_line(&mut out);
        }
        let piece = if kind == Kind::Number { number::glsl(piece) } else { piece.into() };
        match kind {
            Kind::Directive => start_line(&mut out),
            _ if last == Last::Line => {}
            _ if needs_space(last, out.chars().next_back(), kind, &piece) => out.push(' '),
            _ => {}
        }
        out.push_str(&piece);
        last = Last::Kind(kind);
        if kind == Kind::Directive {
            out.push('\n');
            last = Last::Line;
        }
    }
    start_line(&mut out);
    out
}

fn start_line(out: &mut String) {
    if !out.is_empty() && !out.ends_with('\n') {
        out.push('\n');
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A line of the preprocessor, with those that it goes on in.
    Directive,
    Word,
    Number,
    /// An operator, or any other character.
    Sign,
}

/// Operators of several characters; of those that start alike, the longest first.
const OPERATORS: [&str; 21] = [
    "<<=", ">>=", "++", "--", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "&&", "||", "^^", "==", "!=",
    "<=", ">=", "<<", ">>",
];

#[derive(Clone, Copy, PartialEq)]
enum Last {
    /// Nothing stands on this line yet.
    Line,
    Kind(Kind),
}

/// Whether what stands there and `piece` would be read as something else without a space.
fn needs_space(last: Last, end: Option<char>, kind: Kind, piece: &str) -> bool {
    let (Last::Kind(last), Some(end), Some(start)) = (last, end, piece.chars().next()) else { return false };
    match (last, kind) {
        (Kind::Number, _) => is_word(start) || start == '.',
        (_, Kind::Number) if start == '.' => is_word(end) || end == '.',
        // `- -b`, `a / *`, `! =`
        (Kind::Sign, Kind::Sign) => {
            let are_operators = [end, start].iter().all(|c| "+-*/%&|^=<>!~".contains(*c));
            are_operators && (end == start || start == '=' || end == '/' && start == '*')
        }
        _ => is_word(end) && is_word(start),
    }
}

fn is_word(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

/// What is left of a text without blank space and comments.
struct Pieces<'a> {
    rest: &'a str,
    line_start: bool,
}

impl<'a> Iterator for Pieces<'a> {
    type Item = (Kind, &'a str);

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let rest = self.rest;
            let first = rest.chars().next()?;
            let (kind, len) = if first.is_whitespace() {
                self.line_start |= first == '\n';
                (None, first.len_utf8())
            } else if rest.starts_with("//") {
                (None, line(rest))
            } else if let Some(inside) = rest.strip_prefix("/*") {
                (None, inside.find("*/").map_or(rest.len(), |at| at + 4))
            } else if first == '#' && self.line_start {
                (Some(Kind::Directive), line(rest))
            } else if first.is_ascii_digit()
                || first == '.' && rest[1..].starts_with(|c: char| c.is_ascii_digit())
            {
                (Some(Kind::Number), number_len(rest))
            } else if is_word(first) {
                (Some(Kind::Word), rest.find(|c| !is_word(c)).unwrap_or(rest.len()))
            } else {
                let operator = OPERATORS.iter().find(|operator| rest.starts_with(**operator));
                (Some(Kind::Sign), operator.map_or(first.len_utf8(), |operator| operator.len()))
            };
            let (piece, after) = rest.split_at(len);
            self.rest = after;
            if let Some(kind) = kind {
                self.line_start = false;
                let comment = if kind == Kind::Directive { piece.find("//") } else { None };
                return Some((kind, piece[..comment.unwrap_or(piece.len())].trim_end()));
            }
        }
    }
}

/// To the end of the line, and of those that a backslash joins to it.
fn line(rest: &str) -> usize {
    let mut end = 0;
    for line in rest.split_inclusive('\n') {
        end += line.len();
        if !line.trim_end_matches(['\n', '\r']).ends_with('\\') {
            return end - (line.len() - line.trim_end_matches(['\n', '\r']).len());
        }
    }
    end
}

/// A number, with its sign of the exponent and its suffix.
fn number_len(rest: &str) -> usize {
    let is_hex = rest.starts_with("0x") || rest.starts_with("0X");
    let mut before = ' ';
    let ends = |c: char| {
        let is_sign = matches!(c, '+' | '-') && matches!(before, 'e' | 'E') && !is_hex;
        before = c;
        !(is_word(c) || c == '.' || is_sign)
    };
    rest.find(ends).unwrap_or(rest.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_be_read_otherwise_keeps_its_space() {
        let all = [
            ("a - -b + +c - --d;", "a- -b+ +c- --d;"),
            ("a  /  b; // note\n/* more */ return  .5;", "a/b;return .5;"),
            ("float  x = 1.0 ;", "float x=1.;"),
            ("vec2(1.0).x + 1.5e-5", "vec2(1.).x+15e-6"),
            ("x = 0x1Fu & ~ 3u; b = ! c;", "x=0x1Fu&~3u;b=!c;"),
            ("if (a < b && ! c) { } else if (d) e++;", "if(a<b&&!c){}else if(d)e++;"),
            ("a = b ? c : - d", "a=b?c:-d"),
            ("f(1. .x)", "f(1. .x)"),
            ("a/**/b", "a b"),
        ];
        for (long, short) in all {
            assert_eq!(squeeze(long, "//").lines().nth(1), Some(short), "{long}");
        }
    }

    #[test]
    fn lines_of_the_preprocessor_stay_lines_and_the_header_goes_below_the_version() {
        let text =
            "#version 300 es\n// gone\nprecision highp float;\n  #define A(x) \\\n  x // note\nint a; # \n";
        let short = "#version 300 es\n// kept\nprecision highp float;\n#define A(x) \\\n  x\nint a;#\n";
        assert_eq!(squeeze(text, "// kept"), short);
        assert_eq!(squeeze("int  a;", "// kept"), "// kept\nint a;\n");
    }
}
