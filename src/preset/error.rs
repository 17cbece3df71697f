//! What can be wrong with a preset.

use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span};

/// A fault in a preset, and its place.
#[derive(Debug, Clone, PartialEq)]
pub struct PresetError {
    /// What is wrong.
    pub kind: PresetErrorKind,
    /// The preset.
    pub file: FileId,
    /// The place in it.
    pub span: Span,
    /// JSON pointer to the place: `/set/sun/azimuth`.
    pub pointer: String,
}

/// What can be wrong with a preset.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PresetErrorKind {
    /// `OR0501`
    #[error("this is not JSON: {0}")]
    Json(String),
    /// `OR0502`
    #[error("a preset has no key `{key}`")]
    Key {
        /// What stands there.
        key: String,
        /// The key that was probably meant.
        nearest: Option<String>,
    },
    /// `OR0503`
    #[error("`{key}` is set twice")]
    Twice {
        /// The key.
        key: String,
        /// Where it was set first.
        first: Span,
    },
    /// `OR0504`
    #[error("this preset is of version {found}; this is a reader of version 1")]
    Version {
        /// The number that stands there.
        found: String,
    },
    /// `OR0505`
    #[error("the preset does not say `\"orogen\": 1`")]
    NoVersion,
    /// `OR0506`
    #[error("expected {expected}, found {found}")]
    Type {
        /// What should stand there.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// `OR0507`
    #[error("there is no parameter or option named `{key}`")]
    Unknown {
        /// What stands there.
        key: String,
        /// The name that was probably meant.
        nearest: Option<String>,
    },
    /// `OR0508`
    #[error("{value} is outside of {low} .. {high}")]
    Range {
        /// The number that stands there.
        value: String,
        /// The least.
        low: f64,
        /// The greatest.
        high: f64,
        /// The unit of both.
        unit: String,
        /// Where the parameter or the option is declared.
        declared: (FileId, Span),
    },
    /// `OR0509`
    #[error("`{found}` is not among the choices of `{key}`")]
    Choice {
        /// What stands there.
        found: String,
        /// The option.
        key: String,
        /// What could stand there.
        choices: String,
        /// The choice that was probably meant.
        nearest: Option<String>,
        /// Where the option is declared.
        declared: (FileId, Span),
    },
    /// `OR0510`
    #[error("the preset extends itself: {}", chain.join(" → "))]
    Cycle {
        /// From the first preset back to itself.
        chain: Vec<String>,
    },
    /// `OR0511`
    #[error("`{what}` does not fit in `{ty}`")]
    TooLarge {
        /// The number.
        what: String,
        /// The type.
        ty: &'static str,
    },
    /// `OR0515`
    #[error("`{key}` holds a dot")]
    Dotted {
        /// What stands there.
        key: String,
    },
    /// `OR0512`
    #[error("{why}")]
    NotFound {
        /// What was looked for and where.
        why: String,
        /// What there is.
        help: Option<String>,
    },
}

impl PresetErrorKind {
    /// Counts the file of the declaration on by `offset`.
    pub(crate) fn shift_declared(&mut self, offset: u32) {
        if let Self::Range { declared, .. } | Self::Choice { declared, .. } = self {
            declared.0 = FileId(declared.0.0 + offset);
        }
    }
}

impl From<PresetError> for Diagnostic {
    fn from(error: PresetError) -> Self {
        use PresetErrorKind as K;
        let did_you_mean =
            |nearest: &Option<String>| nearest.as_ref().map(|name| format!("did you mean `{name}`?"));
        let message = error.kind.to_string();
        let d = |code| Diagnostic::error(code, message.clone());
        let at = |d: Diagnostic, label: &str| {
            let d = d.at(error.file, error.span, label);
            if error.pointer.is_empty() { d } else { d.note(format!("at `{}`", error.pointer)) }
        };
        match &error.kind {
            K::Json(_) => at(d("OR0501"), "here"),
            K::Key { nearest, .. } => {
                at(d("OR0502"), "unknown key").help(did_you_mean(nearest).or_else(|| {
                    Some(
                        "a preset is made of `orogen`, `about`, `extends`, `scene`, `set` and `$schema`"
                            .into(),
                    )
                }))
            }
            K::Twice { first, .. } => at(d("OR0503"), "set again").and(error.file, *first, "set here first"),
            K::Version { .. } => {
                at(d("OR0504"), "not 1").help(Some("update orogen, or write `\"orogen\": 1`".into()))
            }
            K::NoVersion => at(d("OR0505"), "in this object").help(Some("add `\"orogen\": 1`".into())),
            K::Type { .. } => at(d("OR0506"), "wrong type"),
            K::Unknown { nearest, .. } => at(d("OR0507"), "unknown").help(
                did_you_mean(nearest).or_else(|| Some("`orogen params` lists what the scene has".into())),
            ),
            K::Range { low, high, unit, declared, .. } => {
                let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
                at(d("OR0508"), "out of range")
                    .and(declared.0, declared.1, "declared here")
                    .help(Some(format!("give a value from {low} to {high}{unit}")))
            }
            K::Choice { choices, nearest, declared, .. } => at(d("OR0509"), "not a choice")
                .and(declared.0, declared.1, "declared here")
                .help(did_you_mean(nearest).or_else(|| Some(format!("choose {choices}")))),
            K::Cycle { .. } => at(d("OR0510"), "leads back"),
            K::Dotted { key } => {
                let (group, name) = key.split_once('.').unwrap_or((key, ""));
                let help = format!("write `\"{group}\": {{ \"{name}\": … }}`");
                at(d("OR0515"), "a group and a name in one").help(Some(help))
            }
            K::TooLarge { ty, .. } => at(d("OR0511"), "does not fit").help(Some(match *ty {
                "i32" => "a whole number from -2147483648 to 2147483647 does".into(),
                "u32" => "a whole number from 0 to 4294967295 does".into(),
                _ => "a number from -3.4e38 to 3.4e38 does".into(),
            })),
            K::NotFound { help, .. } => at(d("OR0512"), "extended here").help(help.clone()),
        }
    }
}
