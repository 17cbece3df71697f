//! What is wrong, where, and what to do about it: as data, as text for people, as JSON for tools.
//!
//! Every stage has its own typed errors; each of them turns into a [`Diagnostic`] in one place. An [`Error`] is one or
//! more diagnostics together with the texts that they point into.

mod json;
mod nearest;
mod text;

pub use nearest::{choices, nearest};

use std::sync::Arc;

use crate::source::{FileId, Files, Span};

/// After so many faults a stage looks for no more: each may cost a search through all names for the nearest.
pub(crate) const ENOUGH: usize = 100;

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// Nothing is produced.
    Error,
    /// Something is produced, and probably not what was meant.
    Warning,
}

/// A place in a text and what is to be said about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// Which text.
    pub file: FileId,
    /// Which stretch of it.
    pub span: Span,
    /// What is there; may be empty.
    pub message: String,
    /// Whether this is the place of the fault itself.
    pub primary: bool,
}

/// One thing that is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// Stable: `OR0103`. The first two digits name the stage.
    pub code: &'static str,
    /// One sentence.
    pub message: String,
    /// Places, the primary one first.
    pub labels: Vec<Label>,
    /// How the place was reached, and the like.
    pub notes: Vec<String>,
    /// What to do.
    pub help: Option<String>,
}

impl Diagnostic {
    /// An error without a place yet.
    pub fn error(code: &'static str, message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Error,
            code,
            message: message.into(),
            labels: Vec::new(),
            notes: Vec::new(),
            help: None,
        }
    }

    /// The place of the fault.
    #[must_use]
    pub fn at(mut self, file: FileId, span: Span, message: impl Into<String>) -> Self {
        self.labels.push(Label { file, span, message: message.into(), primary: true });
        self
    }

    /// Another place that has to do with it.
    #[must_use]
    pub fn and(mut self, file: FileId, span: Span, message: impl Into<String>) -> Self {
        self.labels.push(Label { file, span, message: message.into(), primary: false });
        self
    }

    /// One more note.
    #[must_use]
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.notes.push(note.into());
        self
    }

    /// More notes.
    #[must_use]
    pub fn notes(mut self, notes: impl IntoIterator<Item = String>) -> Self {
        self.notes.extend(notes);
        self
    }

    /// What to do, if there is something to say.
    #[must_use]
    pub fn help(mut self, help: impl Into<Option<String>>) -> Self {
        self.help = help.into();
        self
    }
}

/// Why there is no result: diagnostics, and the texts that they point into.
///
/// `Display` renders them for people, each with its code, the author's line and a help where there is one.
#[derive(Clone)]
pub struct Error {
    inner: Box<Inner>,
}

#[derive(Clone)]
struct Inner {
    diagnostics: Vec<Diagnostic>,
    files: Arc<Files>,
}

impl Error {
    pub(crate) fn new(diagnostics: Vec<Diagnostic>, files: impl Into<Arc<Files>>) -> Self {
        Self { inner: Box::new(Inner { diagnostics, files: files.into() }) }
    }

    /// An error that points into no text.
    pub(crate) fn bare(diagnostic: Diagnostic) -> Self {
        Self::new(vec![diagnostic], Files::default())
    }

    /// What is wrong; never empty.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.inner.diagnostics
    }

    /// The texts that the labels point into.
    pub fn files(&self) -> &Files {
        &self.inner.files
    }

    /// For people, with or without terminal colours.
    pub fn render(&self, colour: bool) -> String {
        text::render(&self.inner.diagnostics, &self.inner.files, colour)
    }

    /// For tools: one JSON object a line.
    ///
    /// Each is `{"severity","code","message","spans":[{"file","line","column","end_line","end_column","label",
    /// "primary"}],"notes":[],"help"}`, lines and columns from 1, columns in characters.
    pub fn json_lines(&self) -> String {
        json::lines(&self.inner.diagnostics, &self.inner.files)
    }
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.render(false).trim_end())
    }
}

impl std::fmt::Debug for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f) // what `unwrap` and a test's `?` print
    }
}

impl std::error::Error for Error {}
