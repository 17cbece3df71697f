//! naga's errors, told at the place in the author's file.

use std::ops::Range;

use naga::back::pipeline_constants::PipelineConstantError;
use naga::front::wgsl::ParseError;
use naga::valid::{CallError, EntryPointError, ExpressionError, FunctionError, ValidationError};
use naga::{BinaryOperator, Module, Scalar, ScalarKind, Span as NagaSpan, TypeInner, WithSpan};

use super::overrides::Unsettled;
use super::statement;
use crate::bake::Baked;
use crate::diagnostic::{Diagnostic, nearest};
use crate::source::Span;
use crate::syntax::{TokenKind, lex};

pub(super) fn parse_error(baked: &Baked, error: &ParseError) -> Diagnostic {
    let mut diagnostic = Diagnostic::error("OR0701", error.message());
    let labels = error.labels().map(|(span, label)| {
        let label = if label == "see msg" { "here" } else { label };
        (span, label.to_owned())
    });
    let labels = argument_first(baked, labels.collect());
    diagnostic = place(baked, diagnostic, &labels);
    diagnostic = diagnostic.notes(error.notes().map(str::to_owned));
    if error.message().starts_with("Unexpected runtime-expression") {
        diagnostic.message = "a constant is made of what is known only while the shader runs".into();
        diagnostic = diagnostic.help(Some(
            "a live parameter is no constant: use it in a function, or bake it as a constant".into(),
        ));
    }
    let unknown = error.message().strip_prefix("no definition in scope for identifier: ");
    if let Some(name) = unknown.map(|name| name.trim_matches(['`', '\''])) {
        diagnostic = diagnostic.help(near_name(baked, name).map(|near| format!("did you mean `{near}`?")));
    }
    diagnostic
}

/// Of a call, the argument that is wrong is the place of the fault, not the function's name before it. What it stands for may
/// be declared elsewhere, and naga then points there: the call stays the place.
fn argument_first(baked: &Baked, mut labels: Vec<(NagaSpan, String)>) -> Vec<(NagaSpan, String)> {
    let wrong = labels.iter().position(|(_, label)| label.starts_with("argument #"));
    let ranges = wrong.and_then(|wrong| Some((labels.first()?.0.to_range()?, labels[wrong].0.to_range()?)));
    if let (Some(wrong), Some((call, argument))) = (wrong, ranges)
        && let Some(between) = baked.text.get(call.end..argument.start)
        && !between.contains(';')
    {
        labels[..=wrong].rotate_right(1);
    }
    labels
}

pub(super) fn validation_error(
    baked: &Baked,
    module: &Module,
    error: &WithSpan<ValidationError>,
) -> Diagnostic {
    let function = function_error(error.as_inner());
    let plain =
        function.and_then(|(name, error)| in_words(name, error)).or_else(|| binding_clash(error.as_inner()));
    let (message, at_place, help) = plain.unwrap_or_else(|| (innermost(error), "here".to_owned(), None));
    let mut labels: Vec<_> = narrowest(error)
        .into_iter()
        .map(|(span, label)| {
            let says_more = !label.contains("naga::") && label != message;
            (span, if says_more { label } else { at_place.clone() })
        })
        .collect();
    // Where a value is declared is not where it is wrong.
    let statement = statement::refused(module, error.as_inner()).and_then(|span| head(baked, span));
    if let Some(statement) = statement {
        let range = |span: &NagaSpan| span.to_range().unwrap_or_default();
        let has =
            |outer: &Range<usize>, inner: &Range<usize>| outer.start <= inner.start && inner.end <= outer.end;
        if !labels.iter().any(|(span, _)| has(&statement, &range(span))) {
            labels.retain(|(span, _)| !has(&range(span), &statement)); // the whole function
            for (_, label) in labels.iter_mut().filter(|(_, label)| label == "here") {
                *label = "comes from here".into();
            }
            labels.insert(0, (NagaSpan::new(statement.start as u32, statement.end as u32), "here".into()));
        }
    }
    // Of an entry point's interface naga tells no place: its name, then.
    if let (true, ValidationError::EntryPoint { name, .. }) = (labels.is_empty(), error.as_inner()) {
        labels.extend(function_name(baked, name).map(|span| (span, at_place)));
    }
    let mut diagnostic = place(baked, Diagnostic::error("OR0702", message), &labels).help(help);
    let named = match error.as_inner() {
        ValidationError::Function { name, .. } => Some(format!("in the function `{name}`")),
        ValidationError::EntryPoint { name, .. } => Some(format!("in the entry point `{name}`")),
        ValidationError::GlobalVariable { name, .. } => Some(format!("in the variable `{name}`")),
        ValidationError::Type { name, .. } if !name.is_empty() => Some(format!("in the type `{name}`")),
        _ => None,
    };
    diagnostic.notes.splice(0..0, named);
    diagnostic
}

/// Of overrides that naga cannot make a pipeline with.
pub(super) fn unsettled(baked: &Baked, why: &Unsettled) -> Diagnostic {
    let of_overrides = "made of overrides and constants only";
    let (message, span, label, remedy) = match why {
        Unsettled::Uncomputed(call) => {
            let text = call.to_range().and_then(|range| baked.text.get(range)).unwrap_or_default();
            let function = text.split(['(', '<']).next().unwrap_or_default().trim();
            let message = format!(
                "a variable begins with `{function}` of overrides alone, which naga cannot draw with"
            );
            (message, Some(*call), of_overrides, "give the value to a `let` first")
        }
        Unsettled::Refused(error) => match &**error {
            PipelineConstantError::ValidationError(error) => {
                let span = narrowest(error).map(|(span, _)| span);
                if let Some((_, FunctionError::ExpressionAlreadyInScope(_))) =
                    function_error(error.as_inner())
                {
                    let message =
                        "a part of what overrides alone make is used twice, which naga cannot draw with";
                    (message.to_owned(), span, of_overrides, "give each part to a `let`")
                } else {
                    let message = format!("naga cannot draw with these overrides: {}", innermost(error));
                    (message, span, "here", "write it another way")
                }
            }
            error => (
                format!("naga cannot draw with these overrides: {error}"),
                None,
                "here",
                "give them other values",
            ),
        },
    };
    let labels: Vec<_> = span.into_iter().map(|span| (span, label.to_owned())).collect();
    let help = format!("{remedy}, or bake the parameters that it is made of as constants or live");
    place(baked, Diagnostic::error("OR0704", message), &labels).help(Some(help))
}

/// The function that is wrong and what is wrong in it, where it is a function.
fn function_error(error: &ValidationError) -> Option<(&String, &FunctionError)> {
    match error {
        ValidationError::Function { name, source, .. }
        | ValidationError::EntryPoint { name, source: EntryPointError::Function(source), .. } => {
            Some((name, source))
        }
        _ => None,
    }
}

/// The innermost reason says what is wrong.
fn innermost(error: &WithSpan<ValidationError>) -> String {
    let mut reason: &dyn std::error::Error = error.as_inner();
    while let Some(inner) = reason.source() {
        reason = inner;
    }
    without_handles(&reason.to_string())
}

/// The narrowest place: the whole function around it says nothing that the narrower does not.
fn narrowest(error: &WithSpan<ValidationError>) -> Option<(NagaSpan, String)> {
    let spans = error.spans().cloned();
    spans.min_by_key(|(span, _)| span.to_range().map_or(usize::MAX, |range| range.len()))
}

/// Where the function `name` is declared: its name there.
fn function_name(baked: &Baked, name: &str) -> Option<NagaSpan> {
    let tokens = lex(&baked.text);
    let words: Vec<_> = tokens.iter().filter(|(kind, _)| !kind.is_trivia()).map(|(_, span)| span).collect();
    let text = |span: &Span| &baked.text[span.range()];
    let declared = words.windows(2).find(|pair| text(&pair[0]) == "fn" && text(&pair[1]) == name)?;
    let range = declared[1].range();
    Some(NagaSpan::new(range.start as u32, range.end as u32))
}

/// A statement without the blocks in it.
fn head(baked: &Baked, statement: NagaSpan) -> Option<Range<usize>> {
    let range = statement.to_range()?;
    let text = baked.text.get(range.clone())?;
    let head = text.find('{').map_or(text, |block| &text[..block]).trim_end();
    Some(range.start..range.start + head.len())
}

/// The commonest faults without naga's numbers: the message, the label at the place, and the help.
fn in_words(name: &str, error: &FunctionError) -> Option<(String, String, Option<String>)> {
    match error {
        FunctionError::InvalidReturnType { expression: None, .. } => Some((
            format!("`{name}` can end without returning a value"),
            "here".into(),
            Some("add a `return` at its end".into()),
        )),
        FunctionError::InvalidReturnType { expression: Some(_), .. } => Some((
            format!("the returned value is not of the type that `{name}` declares"),
            "of another type".into(),
            None,
        )),
        FunctionError::Expression {
            source: ExpressionError::InvalidBinaryOperandTypes { op, lhs_type, rhs_type, .. },
            ..
        } => {
            let (left, right) = (type_name(lhs_type)?, type_name(rhs_type)?);
            let message = format!("`{}` does not take `{left}` and `{right}`", operator(*op));
            Some((message, "here".into(), None))
        }
        FunctionError::InvalidIfType(_) => {
            Some(("the condition of `if` is not a `bool`".into(), "here".into(), None))
        }
        FunctionError::InvalidCall { error: CallError::ArgumentType { index, .. }, .. } => Some((
            format!("argument {} is not of the type that the function declares", index + 1),
            "here".into(),
            None,
        )),
        FunctionError::InvalidCall { error: CallError::ArgumentCount { required, seen }, .. } => {
            Some((format!("the function takes {required} arguments, not {seen}"), "called here".into(), None))
        }
        _ => None,
    }
}

/// As WGSL names the type; none where that takes more than its shape.
fn type_name(ty: &TypeInner) -> Option<String> {
    let scalar = |scalar: &Scalar| {
        let kind = match scalar.kind {
            ScalarKind::Sint => "i",
            ScalarKind::Uint => "u",
            ScalarKind::Float => "f",
            ScalarKind::Bool => return Some("bool".to_owned()),
            ScalarKind::AbstractInt | ScalarKind::AbstractFloat => return None,
        };
        Some(format!("{kind}{}", 8 * u32::from(scalar.width)))
    };
    match ty {
        TypeInner::Scalar(of) => scalar(of),
        TypeInner::Vector { size, scalar: of } => Some(format!("vec{}<{}>", *size as u8, scalar(of)?)),
        TypeInner::Matrix { columns, rows, scalar: of } => {
            Some(format!("mat{}x{}<{}>", *columns as u8, *rows as u8, scalar(of)?))
        }
        _ => None,
    }
}

fn operator(operator: BinaryOperator) -> &'static str {
    use BinaryOperator as B;
    match operator {
        B::Add => "+",
        B::Subtract => "-",
        B::Multiply => "*",
        B::Divide => "/",
        B::Modulo => "%",
        B::Equal => "==",
        B::NotEqual => "!=",
        B::Less => "<",
        B::LessEqual => "<=",
        B::Greater => ">",
        B::GreaterEqual => ">=",
        B::And => "&",
        B::ExclusiveOr => "^",
        B::InclusiveOr => "|",
        B::LogicalAnd => "&&",
        B::LogicalOr => "||",
        B::ShiftLeft => "<<",
        B::ShiftRight => ">>",
    }
}

/// `message` without naga's numbers of types and expressions: `[3]`.
fn without_handles(message: &str) -> String {
    if message.starts_with("Type flags") {
        return "a variable in this address space cannot be of this type".into();
    }
    let mut words: Vec<&str> = Vec::new();
    for word in message.split(' ') {
        let bare = word.trim_end_matches([',', '.']);
        let is_handle = bare
            .strip_prefix('[')
            .and_then(|rest| rest.strip_suffix(']'))
            .is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit()));
        if !is_handle {
            words.push(word);
        }
    }
    words.join(" ")
}

/// Two variables at one place: what is wrong, what to say there, what to do.
fn binding_clash(error: &ValidationError) -> Option<(String, String, Option<String>)> {
    let ValidationError::EntryPoint { source: EntryPointError::BindingCollision(_), .. } = error else {
        return None;
    };
    let help = "the live parameters are at `@group(0) @binding(0)`; bind your own elsewhere";
    let message = "two variables are bound at the same place, and one entry point uses both";
    Some((message.into(), "bound where another one is".into(), Some(help.into())))
}

/// Labels at the authors' places, the first as the primary one, and how its file was reached.
fn place(baked: &Baked, mut diagnostic: Diagnostic, labels: &[(NagaSpan, String)]) -> Diagnostic {
    let mut chain = None;
    for (span, label) in labels {
        let Some(range) = span.to_range() else { continue };
        let Some(origin) = baked.map.origin(Span::new(range.start, range.end)) else { continue };
        let is_first = diagnostic.labels.is_empty();
        let twice =
            diagnostic.labels.iter().any(|known| known.file == origin.file && known.span == origin.span);
        if is_first {
            chain = origin.instance;
            diagnostic = diagnostic.at(origin.file, origin.span, label);
        } else if !twice {
            diagnostic = diagnostic.and(origin.file, origin.span, label);
        }
    }
    let notes = chain.map(|instance| baked.composition.chain(instance as usize)).unwrap_or_default();
    diagnostic.notes(notes)
}

/// The identifier of the text nearest to `name`, among those that something declares.
fn near_name(baked: &Baked, name: &str) -> Option<String> {
    let text = &baked.text;
    let tokens = lex(text);
    let mut declared = Vec::new();
    let mut after_keyword = false;
    for (kind, span) in tokens.iter().filter(|(kind, _)| !kind.is_trivia()) {
        let word = &text[span.range()];
        if kind == TokenKind::Ident && after_keyword && word != name {
            declared.push(word);
        }
        after_keyword = matches!(word, "fn" | "struct" | "const" | "override" | "var" | "alias" | "let")
            || after_keyword
                && matches!(kind, TokenKind::TemplateOpen | TokenKind::TemplateClose | TokenKind::Comma)
            || after_keyword && matches!(word, "private" | "storage" | "uniform" | "workgroup" | "read");
    }
    nearest(name, declared)
}
