//! Diagnostics for tools: one JSON object a line.

use serde::Serialize;

use super::{Diagnostic, Severity};
use crate::source::Files;

#[derive(Serialize)]
struct Line<'a> {
    severity: &'static str,
    code: &'a str,
    message: &'a str,
    spans: Vec<SpanLine<'a>>,
    notes: &'a [String],
    help: Option<&'a str>,
}

#[derive(Serialize)]
struct SpanLine<'a> {
    file: &'a str,
    line: usize,
    column: usize,
    end_line: usize,
    end_column: usize,
    label: &'a str,
    primary: bool,
}

pub(super) fn lines(diagnostics: &[Diagnostic], files: &Files) -> String {
    let mut text = String::new();
    for diagnostic in diagnostics {
        let spans = diagnostic.labels.iter().map(|label| {
            let file = files.get(label.file);
            let (start, end) = (file.place(label.span.start as usize), file.place(label.span.end as usize));
            SpanLine {
                file: &file.name,
                line: start.line,
                column: start.column,
                end_line: end.line,
                end_column: end.column,
                label: &label.message,
                primary: label.primary,
            }
        });
        let line = Line {
            severity: match diagnostic.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
            },
            code: diagnostic.code,
            message: &diagnostic.message,
            spans: spans.collect(),
            notes: &diagnostic.notes,
            help: diagnostic.help.as_deref(),
        };
        // Strings, numbers and lists always serialise.
        text.push_str(&serde_json::to_string(&line).unwrap_or_default());
        text.push('\n');
    }
    text
}
