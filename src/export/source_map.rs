//! Source Map v3 (ECMA-426): a shader's source map → the JSON that browsers and editors read.
//!
//! One mapping for each token of the authors' own text and for each piece that stands for something of theirs; an empty
//! one where Orogen's own text begins. Columns count UTF-16 code units, as the format wants it.

use rustc_hash::FxHashMap;
use serde::Serialize;

use crate::bake::Segment;
use crate::shader::Shader;
use crate::source::FileId;
use crate::syntax::lex;

#[derive(Serialize)]
struct Document<'a> {
    version: u8,
    file: &'a str,
    sources: Vec<&'a str>,
    #[serde(rename = "sourcesContent")]
    contents: Vec<&'a str>,
    names: [&'a str; 0],
    mappings: String,
}

/// A source map of the shader's WGSL, which lies in the file `file_name`.
pub fn source_map(shader: &Shader, file_name: &str) -> String {
    let baked = shader.baked();
    let files = &baked.composition.files;
    let mut sources: Vec<FileId> = Vec::new();
    let mut lines: FxHashMap<FileId, usize> = FxHashMap::default();
    for segment in baked.map.segments() {
        lines.entry(segment.file).or_insert_with(|| {
            sources.push(segment.file);
            sources.len() - 1
        });
    }
    let mut writer =
        Writer { out: Place::new(&baked.text), mappings: String::new(), last: [0; 4], fresh: true };
    let mut froms: Vec<_> = sources.iter().map(|file| Place::new(&files.get(*file).text)).collect();
    let token_starts: Vec<u32> =
        lex(&baked.text).iter().filter(|(kind, _)| !kind.is_trivia()).map(|(_, span)| span.start).collect();
    let mut end = 0;
    for segment in baked.map.segments() {
        if segment.out.start > end {
            writer.gap(end as usize);
        }
        end = segment.out.end;
        let source = lines[&segment.file];
        for at in starts(segment, &baked.text, &token_starts) {
            let from = if segment.copied {
                segment.from.start + (at - segment.out.start)
            } else {
                segment.from.start
            };
            let (line, column) = froms[source].of(from as usize);
            writer.mapping(at as usize, [source, line, column]);
        }
    }
    if (end as usize) < baked.text.len() {
        writer.gap(end as usize);
    }
    let document = Document {
        version: 3,
        file: file_name,
        sources: sources.iter().map(|file| &*files.get(*file).name).collect(),
        contents: sources.iter().map(|file| &*files.get(*file).text).collect(),
        names: [],
        mappings: writer.mappings,
    };
    serde_json::to_string(&document).unwrap_or_default() // strings and numbers only: it cannot fail
}

/// Where in `segment` a mapping starts: at its first byte; in copied text, also at each line and each token.
fn starts(segment: &Segment, text: &str, tokens: &[u32]) -> Vec<u32> {
    let mut all = vec![segment.out.start];
    if segment.copied {
        let first = tokens.partition_point(|at| *at <= segment.out.start);
        all.extend(tokens[first..].iter().take_while(|at| **at < segment.out.end));
        let breaks = text[segment.out.range()].bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let lines = breaks.map(|(at, _)| segment.out.start + at as u32 + 1);
        all.extend(lines.filter(|at| *at < segment.out.end));
        all.sort_unstable();
        all.dedup();
    }
    all
}

/// Line and column, both from 0, of one offset after another: each is counted on from the one before.
struct Place<'a> {
    text: &'a str,
    at: usize,
    line: usize,
    column: usize,
}

impl<'a> Place<'a> {
    fn new(text: &'a str) -> Self {
        Self { text, at: 0, line: 0, column: 0 }
    }

    fn of(&mut self, offset: usize) -> (usize, usize) {
        if offset < self.at {
            *self = Self::new(self.text); // another instance of the file
        }
        for c in self.text[self.at..offset].chars() {
            if c == '\n' {
                (self.line, self.column) = (self.line + 1, 0);
            } else {
                self.column += c.len_utf16();
            }
        }
        self.at = offset;
        (self.line, self.column)
    }
}

struct Writer<'a> {
    out: Place<'a>,
    mappings: String,
    /// Column of the result, source, line, column: what the next mapping is counted from.
    last: [usize; 4],
    /// Nothing stands on this line yet.
    fresh: bool,
}

impl Writer<'_> {
    /// From here on, no author's text.
    fn gap(&mut self, at: usize) {
        let column = self.to(at);
        self.number(column, 0);
    }

    fn mapping(&mut self, at: usize, from: [usize; 3]) {
        let column = self.to(at);
        self.number(column, 0);
        for (value, field) in from.into_iter().zip(1..) {
            self.number(value, field);
        }
    }

    /// Goes to the byte `at` of the result; gives back its column.
    fn to(&mut self, at: usize) -> usize {
        let before = self.out.line;
        let (line, column) = self.out.of(at);
        for _ in before..line {
            self.mappings.push(';');
            self.last[0] = 0;
            self.fresh = true;
        }
        if !self.fresh {
            self.mappings.push(',');
        }
        self.fresh = false;
        column
    }

    fn number(&mut self, value: usize, field: usize) {
        vlq(value as i64 - self.last[field] as i64, &mut self.mappings);
        self.last[field] = value;
    }
}

/// Base 64, five bits a digit, the lowest first; the lowest bit of all is the sign.
fn vlq(value: i64, out: &mut String) {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut rest = value.unsigned_abs() << 1 | u64::from(value < 0);
    loop {
        let digit = (rest & 31) as usize;
        rest >>= 5;
        out.push(char::from(DIGITS[if rest > 0 { digit | 32 } else { digit }]));
        if rest == 0 {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_the_format_shows_them() {
        let written = |value| {
            let mut out = String::new();
            vlq(value, &mut out);
            out
        };
        assert_eq!([0, 1, -1, 15, 16, -16, 1000].map(written), ["A", "C", "D", "e", "gB", "hB", "w+B"]);
    }
}
