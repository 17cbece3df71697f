//! Diagnostics for people, drawn by the renderer that naga uses.

use codespan_reporting::diagnostic as codespan;
use codespan_reporting::term;

use super::{Diagnostic, Severity};
use crate::source::Files;

/// Several faults in a big input say little more than the first few.
const MOST: usize = 50;

pub(super) fn render(diagnostics: &[Diagnostic], files: &Files, colour: bool) -> String {
    let config = term::Config::default();
    let mut plain = String::new();
    let mut coloured = term::termcolor::Ansi::new(Vec::new());
    for diagnostic in diagnostics.iter().take(MOST) {
        let shown = convert(diagnostic);
        // Both writers are memory and every label is inside its text: nothing can fail but the formatter itself, and then
        // the sentence still comes through.
        let drawn = if colour {
            term::emit_to_write_style(&mut coloured, &config, files, &shown)
        } else {
            term::emit_to_string(&mut plain, &config, files, &shown)
        };
        if drawn.is_err() {
            plain.push_str(&format!("error[{}]: {}\n", diagnostic.code, diagnostic.message));
        }
    }
    let mut text = String::from_utf8_lossy(coloured.get_ref()).into_owned() + &plain;
    if diagnostics.len() > MOST {
        text.push_str(&format!("… and {} more\n", diagnostics.len() - MOST));
    }
    text
}

fn convert(diagnostic: &Diagnostic) -> codespan::Diagnostic<crate::source::FileId> {
    let severity = match diagnostic.severity {
        Severity::Error => codespan::Severity::Error,
        Severity::Warning => codespan::Severity::Warning,
    };
    let labels = diagnostic.labels.iter().map(|label| {
        let style =
            if label.primary { codespan::LabelStyle::Primary } else { codespan::LabelStyle::Secondary };
        codespan::Label::new(style, label.file, label.span.range()).with_message(&label.message)
    });
    let notes = diagnostic.notes.iter().map(|note| format!("note: {note}"));
    let help = diagnostic.help.iter().map(|help| format!("help: {help}"));
    codespan::Diagnostic::new(severity)
        .with_code(diagnostic.code)
        .with_message(&diagnostic.message)
        .with_labels(labels.collect())
        .with_notes(notes.chain(help).collect())
}
