//! What can be wrong with an expression and its points, and how each is told.

use crate::diagnostic::{Diagnostic, Error};
use crate::source::{Files, Span};

/// A fault of an expression, its includes or its points.
#[derive(Debug, Clone, thiserror::Error)]
pub enum SampleError {
    /// `OR0920`
    #[error("{why}")]
    Expression {
        /// What is wrong with it.
        why: String,
        /// The whole expression.
        text: String,
        /// Where.
        span: Span,
    },
    /// `OR0921`
    #[error("there cannot be a column `{name}`: {why}")]
    Column {
        /// The column.
        name: String,
        /// What is wrong with it.
        why: String,
    },
    /// `OR0922`
    #[error("the points are wrong: {why}")]
    Points {
        /// What is wrong with them.
        why: String,
    },
    /// `OR0923`
    #[error("{what} cannot be put into a table")]
    Type {
        /// What the expression is.
        what: String,
        /// The whole expression.
        text: String,
    },
    /// `OR0925`
    #[error("the value is ({value}), which is not {asked} f32")]
    Results {
        /// How many f32 the caller wants of each point.
        asked: usize,
        /// What there is: each component with its type.
        value: String,
    },
    /// `OR0924`
    #[error("`{text}` cannot be included: {why}")]
    Include {
        /// As it was given.
        text: String,
        /// What is wrong with it.
        why: &'static str,
    },
}

impl From<SampleError> for Error {
    fn from(error: SampleError) -> Self {
        use SampleError as E;
        let message = error.to_string();
        let d = |code, help: &str| Diagnostic::error(code, message.clone()).help(Some(help.to_owned()));
        match error {
            E::Expression { text, span, .. } => {
                let mut files = Files::default();
                let file = files.add(super::text::NAME, text);
                let help = "write one WGSL expression, as in `perlin_noise2(p, 7u)`; functions of your own go into a \
                            fragment that `--include` names";
                Self::new(vec![d("OR0920", help).at(file, span, "here")], files)
            }
            E::Column { .. } => Self::bare(d(
                "OR0921",
                "a column is a WGSL name, with its type behind a colon unless it is f32: `x`, `seed:u32`, `cell:i32`",
            )),
            E::Points { .. } => {
                Self::bare(d("OR0922", "every row gives each column one value, of the column's type"))
            }
            E::Type { text, .. } => {
                let mut files = Files::default();
                let span = Span::new(0, text.len());
                let file = files.add(super::text::NAME, text);
                let help = "scalars, vectors, matrices, and arrays and structures of them can be";
                Self::new(vec![d("OR0923", help).at(file, span, "")], files)
            }
            E::Results { .. } => Self::bare(d(
                "OR0925",
                "ask for rows of as many f32 as the value has components, as in `Vec<[f32; 3]>` for a vec3f; `table` takes \
                 components of every type",
            )),
            E::Include { .. } => {
                Self::bare(d("OR0924", "write it as behind `#include`: `--include '<noise/perlin.wgsl>'`"))
            }
        }
    }
}
