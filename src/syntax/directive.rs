//! The lines that start with `#`: text → [`Directive`].

use super::condition::{self, Expr};
use super::cursor::{Cursor, Spanned, Unexpected};
use super::lexer::is_ident;
use super::value::{Key, OptionDecl, OptionKind, OptionValue, ParamDecl, Type, Value};
use crate::source::Span;

/// `#include <fractal/fbm.wgsl> as relief with noise2 = perlin_noise2_grad`
#[derive(Debug, Clone, PartialEq)]
pub struct Include {
    /// What stands between the brackets or the quotes.
    pub path: Spanned<String>,
    /// `"…"`: beside this file first.
    pub beside: bool,
    /// The instance's name.
    pub instance: Option<Spanned<String>>,
    /// What goes into which slot.
    pub with: Vec<(Spanned<String>, Spanned<String>)>,
}

/// `#slot noise2: fn(p: vec2f) -> vec3f`
#[derive(Debug, Clone, PartialEq)]
pub struct Slot {
    /// Its name.
    pub name: Spanned<String>,
    /// Types of the arguments and of the result, `vec2<f32>` spelled `vec2f`.
    pub signature: Signature,
    /// Where the signature stands.
    pub signature_span: Span,
    /// The doc comment above it.
    pub doc: String,
}

/// What a function takes and gives, type by type, blank space and spelling variants gone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Signature {
    /// Types of the arguments.
    pub takes: Vec<String>,
    /// Type of the result.
    pub gives: Option<String>,
}

impl std::fmt::Display for Signature {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "fn({})", self.takes.join(", "))?;
        self.gives.as_ref().map_or(Ok(()), |gives| write!(f, " -> {gives}"))
    }
}

/// What a line that starts with `#` says.
#[derive(Debug, Clone, PartialEq)]
pub enum DirectiveKind {
    /// `#include`
    Include(Include),
    /// `#param`
    Param(ParamDecl),
    /// `#option`
    Option(OptionDecl),
    /// `#slot`
    Slot(Slot),
    /// `#if`
    If(Expr),
    /// `#elif`
    Elif(Expr),
    /// `#else`
    Else,
    /// `#endif`
    Endif,
}

/// A directive and its line.
#[derive(Debug, Clone, PartialEq)]
pub struct Directive {
    /// What it says.
    pub kind: DirectiveKind,
    /// From its `#` to the end of the line.
    pub span: Span,
}

/// Why a directive cannot be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DirectiveError {
    /// `OR0101`
    #[error("there is no directive `#{name}`")]
    Unknown {
        /// What stands there.
        name: String,
        /// Where.
        span: Span,
    },
    /// `OR0102`
    #[error("expected {expected}")]
    Syntax {
        /// What should stand there.
        expected: String,
        /// Where.
        span: Span,
        /// How the directive is written.
        usage: &'static str,
    },
    /// `OR0103`
    #[error("{why}")]
    Value {
        /// What is wrong with the value.
        why: String,
        /// Where it stands.
        span: Span,
    },
    /// `OR0104`
    #[error("{why}")]
    Unbalanced {
        /// Which of `#if`, `#elif`, `#else`, `#endif` is out of place.
        why: String,
        /// Where.
        span: Span,
        /// The `#if` or `#else` that it has to do with.
        other: Option<Span>,
    },
    /// `OR0106`
    #[error("more than {MAX_PREFIXES} operators in a row")]
    Operators {
        /// Where the row starts.
        span: Span,
    },
    /// `OR0105`
    #[error("`#{name}` stands inside a declaration")]
    Inside {
        /// Which directive.
        name: &'static str,
        /// Where.
        span: Span,
    },
}

/// How many operators may stand before one operand. Compilers recurse once for each.
pub(super) const MAX_PREFIXES: usize = 1000;

const NAMES: [&str; 8] = ["include", "param", "option", "slot", "if", "elif", "else", "endif"];

impl DirectiveKind {
    /// Its name, without the `#`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Include(_) => NAMES[0],
            Self::Param(_) => NAMES[1],
            Self::Option(_) => NAMES[2],
            Self::Slot(_) => NAMES[3],
            Self::If(_) => NAMES[4],
            Self::Elif(_) => NAMES[5],
            Self::Else => NAMES[6],
            Self::Endif => NAMES[7],
        }
    }

    /// Whether it belongs to a condition.
    pub fn is_condition(&self) -> bool {
        matches!(self, Self::If(_) | Self::Elif(_) | Self::Else | Self::Endif)
    }
}

/// The directive nearest to `name`, for the help of `OR0101`.
pub fn nearest_directive(name: &str) -> Option<String> {
    crate::diagnostic::nearest(name, NAMES)
}

/// Reads one directive. `line` starts at its `#`, which is byte `base` of the file; `doc` is the comment above it.
pub fn parse_directive(line: &str, base: usize, doc: &str) -> Result<Directive, DirectiveError> {
    let mut cursor = Cursor::new(line, base);
    cursor.take("#");
    let start = cursor.here();
    let name = match cursor.ident("") {
        Ok(name) => name,
        Err(_) => {
            return Err(DirectiveError::Unknown {
                name: String::new(),
                span: Span::new(base, start.max(base + 1)),
            });
        }
    };
    let syntax =
        |usage| move |e: Unexpected| DirectiveError::Syntax { expected: e.expected, span: e.span, usage };
    let c = &mut cursor;
    let (kind, usage) = match name.value {
        "include" => {
            const USAGE: &str = "#include <path> [as NAME] [with slot = function, …]";
            let include = include(c).map_err(syntax(USAGE))?;
            let mut filled = std::collections::BTreeSet::new();
            if let Some((slot, _)) = include.with.iter().find(|(slot, _)| !filled.insert(&slot.value)) {
                let why = format!("the slot `{}` is filled twice", slot.value);
                return Err(DirectiveError::Value { why, span: slot.span });
            }
            (DirectiveKind::Include(include), USAGE)
        }
        "param" => {
            const USAGE: &str =
                "#param group.name: type = default[, range a .. b][, unit u][, color][, log][, live]";
            (DirectiveKind::Param(param(c, doc, USAGE)?), USAGE)
        }
        "option" => {
            const USAGE: &str = "#option group.name = default { a, b, c }, = true, or = 8[, range 1 .. 16]";
            (DirectiveKind::Option(option(c, doc, USAGE)?), USAGE)
        }
        "slot" => {
            const USAGE: &str = "#slot name: fn(argument: type, …) -> type";
            (DirectiveKind::Slot(slot(c, doc).map_err(syntax(USAGE))?), USAGE)
        }
        "if" => {
            const USAGE: &str = "#if group.option == choice && other.option >= 8";
            (DirectiveKind::If(condition::parse(c).map_err(syntax(USAGE))?), USAGE)
        }
        "elif" => {
            const USAGE: &str = "#elif group.option == choice && other.option >= 8";
            (DirectiveKind::Elif(condition::parse(c).map_err(syntax(USAGE))?), USAGE)
        }
        "else" => (DirectiveKind::Else, "#else"),
        "endif" => (DirectiveKind::Endif, "#endif"),
        other => return Err(DirectiveError::Unknown { name: other.into(), span: name.span }),
    };
    if !cursor.at_end() {
        cursor.unexpected("the end of the line").map_err(syntax(usage))?;
    }
    Ok(Directive { kind, span: Span::new(base, base + line.len()) })
}

fn owned(piece: Spanned<&str>) -> Spanned<String> {
    Spanned { value: piece.value.to_owned(), span: piece.span }
}

fn include(c: &mut Cursor<'_>) -> Result<Include, Unexpected> {
    let (path, beside) = if c.take("<") {
        (c.until('>')?, false)
    } else if c.take("\"") {
        (c.until('"')?, true)
    } else {
        return c.unexpected("`<path>` or `\"path\"`");
    };
    let instance = if c.word("as") { Some(owned(own_name(c, "a name for the instance")?)) } else { None };
    let mut with = Vec::new();
    if c.word("with") {
        loop {
            let slot = owned(c.ident("the name of a slot")?);
            c.expect("=")?;
            with.push((slot, owned(c.ident("the name of a function")?)));
            if !c.take(",") {
                break;
            }
        }
    }
    Ok(Include { path: owned(path), beside, instance, with })
}

/// A name that `group_name` or `instance_name` can be built of and still be a WGSL identifier.
fn own_name<'a>(c: &mut Cursor<'a>, what: &str) -> Result<Spanned<&'a str>, Unexpected> {
    let name = c.ident(what)?;
    if name.value.starts_with('_') || name.value.ends_with('_') {
        let expected = format!("{what} that neither starts nor ends with `_`");
        return Err(Unexpected { expected, span: name.span });
    }
    Ok(name)
}

fn key(c: &mut Cursor<'_>, grouped: bool) -> Result<(Key, Span), Unexpected> {
    let first = own_name(c, if grouped { "`group.name`" } else { "`group.name` or a name" })?;
    if !c.rest().starts_with('.') {
        if grouped {
            return c.unexpected("`.` and the parameter's name in the group");
        }
        return Ok((Key { group: String::new(), name: first.value.into() }, first.span));
    }
    c.expect(".")?;
    let name = own_name(c, "a name after the `.`")?;
    Ok((Key { group: first.value.into(), name: name.value.into() }, first.span.to(name.span)))
}

fn param(c: &mut Cursor<'_>, doc: &str, usage: &'static str) -> Result<ParamDecl, DirectiveError> {
    let syntax = |e: Unexpected| DirectiveError::Syntax { expected: e.expected, span: e.span, usage };
    let (key, key_span) = key(c, true).map_err(syntax)?;
    c.expect(":").map_err(syntax)?;
    let ty_name = c.ident("a type").map_err(syntax)?;
    let Some(ty) = Type::ALL.into_iter().find(|ty| ty.name() == ty_name.value) else {
        let expected = crate::diagnostic::choices(Type::ALL.map(Type::name));
        return Err(DirectiveError::Syntax { expected, span: ty_name.span, usage });
    };
    c.expect("=").map_err(syntax)?;
    let start = c.here();
    let default = value(c, ty, usage)?;
    let default_span = Span::new(start, c.here());
    let mut decl = ParamDecl {
        key,
        key_span,
        ty,
        default,
        range: None,
        unit: None,
        color: false,
        log: false,
        live: false,
        doc: doc.into(),
    };
    let mut seen = Vec::new();
    while c.take(",") {
        let word = c.ident("`range`, `unit`, `color`, `log` or `live`").map_err(syntax)?;
        if seen.contains(&word.value) {
            let why = format!("`{}` is said twice", word.value);
            return Err(DirectiveError::Value { why, span: word.span });
        }
        seen.push(word.value);
        match word.value {
            "range" => decl.range = Some(range(c, usage)?),
            "unit" => decl.unit = Some(unit(c).map_err(syntax)?),
            "color" => decl.color = true,
            "log" => decl.log = true,
            "live" => decl.live = true,
            _ => {
                let expected = "`range`, `unit`, `color`, `log` or `live`".into();
                return Err(DirectiveError::Syntax { expected, span: word.span, usage });
            }
        }
        let misfit = match word.value {
            "range" | "log" if ty == Type::Bool => Some("a `bool` has no range"),
            "unit" if ty == Type::Bool => Some("a `bool` has no unit"),
            "color" if !matches!(ty, Type::Vec3f | Type::Vec4f) => Some("a colour is a `vec3f` or a `vec4f`"),
            _ if decl.unit.as_deref() == Some("deg") && !ty.is_float() => Some("an angle is made of floats"),
            _ => None,
        };
        if let Some(why) = misfit {
            return Err(DirectiveError::Value { why: why.into(), span: word.span });
        }
    }
    if let Some((low, high)) = decl.range
        && let Some(outside) = decl.outside(&decl.default)
    {
        let why = format!("the default {outside} is outside of the range {low} .. {high}");
        return Err(DirectiveError::Value { why, span: default_span });
    }
    Ok(decl)
}

fn unit(c: &mut Cursor<'_>) -> Result<String, Unexpected> {
    c.here();
    let len = c.rest().find([',', ' ', '\t']).unwrap_or(c.rest().len());
    if len == 0 { c.unexpected("a unit") } else { Ok(c.advance(len).value.to_owned()) }
}

fn range(c: &mut Cursor<'_>, usage: &'static str) -> Result<(f64, f64), DirectiveError> {
    let syntax = |e: Unexpected| DirectiveError::Syntax { expected: e.expected, span: e.span, usage };
    let low = c.number("the least value").map_err(syntax)?;
    c.expect("..").map_err(syntax)?;
    let high = c.number("the greatest value").map_err(syntax)?;
    let span = low.span.to(high.span);
    let (low, high) = (low.value.parse::<f64>(), high.value.parse::<f64>());
    match (low, high) {
        (Ok(low), Ok(high)) if low.is_finite() && high.is_finite() && low <= high => Ok((low, high)),
        _ => Err(DirectiveError::Value {
            why: "a range goes from the least to the greatest value".into(),
            span,
        }),
    }
}

fn value(c: &mut Cursor<'_>, ty: Type, usage: &'static str) -> Result<Value, DirectiveError> {
    let syntax = |e: Unexpected| DirectiveError::Syntax { expected: e.expected, span: e.span, usage };
    if ty == Type::Bool {
        return if c.word("true") {
            Ok(Value::Bool(true))
        } else if c.word("false") {
            Ok(Value::Bool(false))
        } else {
            c.unexpected("`true` or `false`").map_err(syntax)
        };
    }
    if ty.components() > 1 {
        let start = c.here();
        c.expect("(").map_err(syntax)?;
        let mut floats = Vec::new();
        loop {
            floats.push(float(c, usage)?);
            if !c.take(",") {
                break;
            }
        }
        c.expect(")").map_err(syntax)?;
        let span = Span::new(start, c.here());
        let why = format!("a `{ty}` has {} components, not {}", ty.components(), floats.len());
        return Value::from_floats(ty, &floats).ok_or(DirectiveError::Value { why, span });
    }
    if ty == Type::F32 {
        return Ok(Value::F32(float(c, usage)?));
    }
    let number = c.number("a whole number").map_err(syntax)?;
    let parsed = match ty {
        Type::I32 => number.value.parse().map(Value::I32).ok(),
        _ => number.value.parse().map(Value::U32).ok(),
    };
    let why = format!("`{}` is not of type `{ty}`", number.value);
    parsed.ok_or(DirectiveError::Value { why, span: number.span })
}

fn float(c: &mut Cursor<'_>, usage: &'static str) -> Result<f32, DirectiveError> {
    let number = c.number("a number").map_err(|e| DirectiveError::Syntax {
        expected: e.expected,
        span: e.span,
        usage,
    })?;
    match number.value.parse::<f32>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => {
            let why = format!("`{}` is too large for an `f32`", number.value);
            Err(DirectiveError::Value { why, span: number.span })
        }
    }
}

fn option(c: &mut Cursor<'_>, doc: &str, usage: &'static str) -> Result<OptionDecl, DirectiveError> {
    let syntax = |e: Unexpected| DirectiveError::Syntax { expected: e.expected, span: e.span, usage };
    let (key, key_span) = key(c, false).map_err(syntax)?;
    c.expect("=").map_err(syntax)?;
    let (kind, default) = if c.word("true") {
        (OptionKind::Bool, OptionValue::Bool(true))
    } else if c.word("false") {
        (OptionKind::Bool, OptionValue::Bool(false))
    } else if c.peek().is_some_and(|first| first.is_ascii_digit() || matches!(first, '-' | '+')) {
        let number = c.number("a whole number").map_err(syntax)?;
        let Ok(default) = number.value.parse::<i32>() else {
            let why = format!("`{}` is not of type `i32`", number.value);
            return Err(DirectiveError::Value { why, span: number.span });
        };
        let default = i64::from(default);
        let mut limits = None;
        if c.take(",") {
            if !c.word("range") {
                return c.unexpected("`range`").map_err(syntax);
            }
            let start = c.here();
            let (low, high) = range(c, usage)?;
            let span = Span::new(start, c.here());
            if low.fract() != 0.0 || high.fract() != 0.0 || low < -2147483648.0 || high > 2147483647.0 {
                let why = "the range of a whole number is made of two of them".into();
                return Err(DirectiveError::Value { why, span });
            }
            if (default as f64) < low || default as f64 > high {
                let why = format!("the default {default} is outside of the range {low} .. {high}");
                return Err(DirectiveError::Value { why, span: number.span });
            }
            limits = Some((low as i64, high as i64));
        }
        (OptionKind::Integer(limits), OptionValue::Integer(default))
    } else {
        let chosen = c.ident("a choice, `true`, `false` or a whole number").map_err(syntax)?;
        c.expect("{").map_err(syntax)?;
        let mut names: Vec<String> = Vec::new();
        loop {
            let name = c.ident("a choice").map_err(syntax)?;
            if names.iter().any(|known| known == name.value) {
                let why = format!("`{}` is listed twice", name.value);
                return Err(DirectiveError::Value { why, span: name.span });
            }
            names.push(name.value.to_owned());
            if !c.take(",") {
                break;
            }
        }
        c.expect("}").map_err(syntax)?;
        let Some(index) = names.iter().position(|name| name == chosen.value) else {
            let why = format!("the default `{}` is not among the choices", chosen.value);
            return Err(DirectiveError::Value { why, span: chosen.span });
        };
        (OptionKind::Choice(names), OptionValue::Choice(index))
    };
    Ok(OptionDecl { key, key_span, kind, default, doc: doc.into() })
}

fn slot(c: &mut Cursor<'_>, doc: &str) -> Result<Slot, Unexpected> {
    let name = owned(c.ident("the slot's name")?);
    c.expect(":")?;
    let start = c.here();
    if !c.word("fn") {
        return c.unexpected("`fn(…) -> type`");
    }
    c.expect("(")?;
    let mut takes = Vec::new();
    while !c.take(")") {
        c.ident("an argument's name, or `)`")?;
        c.expect(":")?;
        takes.push(type_name(c, ",)")?);
        if !c.take(",") {
            c.expect(")")?;
            break;
        }
    }
    let gives = if c.take("->") { Some(type_name(c, "")?) } else { None };
    let signature_span = Span::new(start, c.here());
    Ok(Slot { name, signature: Signature { takes, gives }, signature_span, doc: doc.into() })
}

/// A type up to one of `ends` outside of its `<…>`, or to the end of the line.
fn type_name(c: &mut Cursor<'_>, ends: &str) -> Result<String, Unexpected> {
    c.here();
    let mut depth = 0usize;
    let rest = c.rest();
    let rest = &rest[..rest.find("//").unwrap_or(rest.len())];
    let end = rest.char_indices().find(|(_, ch)| {
        match ch {
            '<' => depth += 1,
            '>' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && ends.contains(*ch)
    });
    let len = end.map_or(rest.len(), |(at, _)| at);
    if !rest[..len].trim_start().chars().next().is_some_and(|first| is_ident(first.encode_utf8(&mut [0; 4])))
    {
        return c.unexpected("a type");
    }
    Ok(plain_type(c.advance(len).value))
}

/// One spelling for every type: no blank space, and `vec3<f32>` written `vec3f`.
pub fn plain_type(spelled: &str) -> String {
    let mut plain: String = spelled.chars().filter(|c| !super::lexer::is_blank(*c)).collect();
    for (long, short) in [("<f32>", "f"), ("<i32>", "i"), ("<u32>", "u"), ("<f16>", "h")] {
        let mut from = 0;
        while let Some(at) = plain[from..].find(long).map(|at| at + from) {
            let head =
                plain[..at].rsplit(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).next().unwrap_or("");
            let is_vector = matches!(head, "vec2" | "vec3" | "vec4");
            let is_matrix = matches!(long, "<f32>" | "<f16>") && head.len() == 6 && head.starts_with("mat");
            if is_vector || is_matrix {
                plain.replace_range(at..at + long.len(), short);
            }
            from = at + 1;
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_type_has_one_spelling() {
        assert_eq!(plain_type("vec3< f32 >"), "vec3f");
        assert_eq!(plain_type("array<vec2<u32>, 4>"), "array<vec2u,4>");
        assert_eq!(plain_type("ptr<function, mat4x4<f32>>"), "ptr<function,mat4x4f>");
        assert_eq!(plain_type("atomic<u32>"), "atomic<u32>");
    }
}
