//! Diagnostics for people, drawn by the renderer that naga uses.

use codespan_reporting::diagnostic as codespan;
use codespan_reporting::term;

use super::{Diagnostic, Label, Severity};
use crate::source::{File, Files};

/// Several faults in a big input say little more than the first few.
const MOST: usize = 50;

/// Lines longer than this (generated, minified) are not drawn: the place is named instead.
const LONGEST_LINE: usize = 1000;

pub(super) fn render(diagnostics: &[Diagnostic], files: &Files, colour: bool) -> String {
    let config = term::Config::default();
    let mut plain = String::new();
    let mut coloured = term::termcolor::Ansi::new(Vec::new());
    for diagnostic in diagnostics.iter().take(MOST) {
        let shown = convert(diagnostic, files);
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

fn convert(diagnostic: &Diagnostic, files: &Files) -> codespan::Diagnostic<crate::source::FileId> {
    let severity = match diagnostic.severity {
        Severity::Error => codespan::Severity::Error,
        Severity::Warning => codespan::Severity::Warning,
    };
    let (drawn, named): (Vec<_>, Vec<_>) =
        diagnostic.labels.iter().partition(|label| fits(label, files.get(label.file)));
    let labels = drawn.into_iter().map(|label| {
        let style =
            if label.primary { codespan::LabelStyle::Primary } else { codespan::LabelStyle::Secondary };
        codespan::Label::new(style, label.file, label.span.range()).with_message(&label.message)
    });
    let places = named.into_iter().map(|label| {
        let file = files.get(label.file);
        let place = file.place(label.span.start as usize);
        format!("{}:{}:{}: {}", file.name, place.line, place.column, label.message)
    });
    let notes = diagnostic.notes.iter().map(|note| format!("note: {note}"));
    let help = diagnostic.help.iter().map(|help| format!("help: {help}"));
    codespan::Diagnostic::new(severity)
        .with_code(diagnostic.code)
        .with_message(&diagnostic.message)
        .with_labels(labels.collect())
        .with_notes(places.chain(notes).chain(help).collect())
}

/// Whether the first and the last line of a label are short enough to be drawn.
fn fits(label: &Label, file: &File) -> bool {
    let starts = file.line_starts();
    let short = |offset: u32| {
        let line = file.line_of(offset as usize);
        let end = starts.get(line + 1).map_or(file.text.len(), |end| *end as usize);
        end - starts[line] as usize <= LONGEST_LINE
    };
    short(label.span.start) && short(label.span.end)
}
