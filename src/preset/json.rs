//! JSON with the place of every value and key, so that an error can point at it.
//!
//! `serde_json` does the reading: its `RawValue` borrows from the text, and where a borrowed piece lies in the text is
//! where it stands in the file.

use std::fmt;

use serde::de::{Deserialize, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;

use crate::source::Span;
use crate::syntax::Spanned;

/// How deep values may lie in each other. A preset needs four levels.
const MAX_DEPTH: usize = 16;

/// A JSON value and its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Json {
    pub(crate) kind: JsonKind,
    pub(crate) span: Span,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum JsonKind {
    Null,
    Bool(bool),
    /// As it is spelled.
    Number(String),
    String(String),
    Array(Vec<Json>),
    /// In order; keys may repeat.
    Object(Vec<(Spanned<String>, Json)>),
}

impl JsonKind {
    /// For «expected …, found …».
    pub(crate) fn describe(&self) -> &'static str {
        match self {
            Self::Null => "null",
            Self::Bool(_) => "a boolean",
            Self::Number(_) => "a number",
            Self::String(_) => "a string",
            Self::Array(_) => "a list",
            Self::Object(_) => "an object",
        }
    }
}

/// What is wrong, and where.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct JsonError {
    pub(crate) why: String,
    pub(crate) span: Span,
}

pub(crate) fn parse(text: &str) -> Result<Json, JsonError> {
    let raw: &RawValue = serde_json::from_str(text).map_err(|error| syntax(text, &error))?;
    read(text, raw, 0)
}

fn syntax(text: &str, error: &serde_json::Error) -> JsonError {
    let why = without_place(error);
    let line: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
    // Column 0 is the line break before: the word that it cuts short ends there.
    let at = text.floor_char_boundary((line + error.column()).saturating_sub(1).min(text.len()));
    let end = text[at..].chars().next().filter(|c| *c != '\n').map_or(at, |c| at + c.len_utf8());
    JsonError { why, span: Span::new(at, end) }
}

/// What is wrong, without the line and column, which count from the start of the piece.
fn without_place(error: &serde_json::Error) -> String {
    let message = error.to_string();
    message.split(" at line ").next().unwrap_or(&message).to_owned()
}

fn place(text: &str, piece: &str) -> Span {
    let start = (piece.as_ptr() as usize).saturating_sub(text.as_ptr() as usize);
    Span::new(start, start + piece.len())
}

fn read(text: &str, raw: &RawValue, depth: usize) -> Result<Json, JsonError> {
    let piece = raw.get();
    let span = place(text, piece);
    let wrong = |error: serde_json::Error| JsonError { why: without_place(&error), span };
    if depth > MAX_DEPTH {
        return Err(JsonError { why: format!("nested deeper than {MAX_DEPTH} levels"), span });
    }
    let kind = match piece.as_bytes().first() {
        Some(b'{') => {
            let pairs: Pairs<'_> = serde_json::from_str(piece).map_err(wrong)?;
            let mut object = Vec::new();
            for (key, value) in pairs.0 {
                let name = serde_json::from_str(key.get()).map_err(wrong)?;
                object.push((
                    Spanned { value: name, span: place(text, key.get()) },
                    read(text, value, depth + 1)?,
                ));
            }
            JsonKind::Object(object)
        }
        Some(b'[') => {
            let items: Items<'_> = serde_json::from_str(piece).map_err(wrong)?;
            let items = items.0.into_iter().map(|item| read(text, item, depth + 1));
            JsonKind::Array(items.collect::<Result<_, _>>()?)
        }
        Some(b'"') => JsonKind::String(serde_json::from_str(piece).map_err(wrong)?),
        Some(b't') => JsonKind::Bool(true),
        Some(b'f') => JsonKind::Bool(false),
        Some(b'n') => JsonKind::Null,
        _ => JsonKind::Number(piece.to_owned()),
    };
    Ok(Json { kind, span })
}

struct Pairs<'a>(Vec<(&'a RawValue, &'a RawValue)>);

impl<'de> Deserialize<'de> for Pairs<'de> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;
        impl<'de> Visitor<'de> for Reader {
            type Value = Pairs<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Pairs<'de>, A::Error> {
                let mut pairs = Vec::new();
                while let Some(pair) = map.next_entry()? {
                    pairs.push(pair);
                }
                Ok(Pairs(pairs))
            }
        }
        deserializer.deserialize_map(Reader)
    }
}

struct Items<'a>(Vec<&'a RawValue>);

impl<'de> Deserialize<'de> for Items<'de> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;
        impl<'de> Visitor<'de> for Reader {
            type Value = Items<'de>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Items<'de>, A::Error> {
                let mut items = Vec::new();
                while let Some(item) = seq.next_element()? {
                    items.push(item);
                }
                Ok(Items(items))
            }
        }
        deserializer.deserialize_seq(Reader)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_and_value_knows_its_place() {
        let text = r#" {"sun": {"azi\u006duth": 215.0}, "x": [1, "é"]}"#;
        let Ok(Json { kind: JsonKind::Object(pairs), span }) = parse(text) else { unreachable!() };
        assert_eq!(&text[span.range()], text.trim());
        let JsonKind::Object(sun) = &pairs[0].1.kind else { unreachable!() };
        assert_eq!(sun[0].0.value, "azimuth");
        assert_eq!(&text[sun[0].0.span.range()], r#""azi\u006duth""#);
        assert_eq!(&text[sun[0].1.span.range()], "215.0");
        let JsonKind::Array(items) = &pairs[1].1.kind else { unreachable!() };
        assert_eq!(&text[items[1].span.range()], "\"é\"");
    }

    #[test]
    fn what_is_no_json_says_where() {
        let error = parse("{\n  \"a\": tru\n}").unwrap_err();
        assert_eq!(error.span.start, 12);
        let deep = "[".repeat(40) + &"]".repeat(40);
        assert!(parse(&deep).unwrap_err().why.contains("deeper"));
    }
}
