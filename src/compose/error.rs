//! What can go wrong while fragments are put together, and how each is told.

use std::sync::Arc;

use crate::diagnostic::{Diagnostic, choices};
use crate::source::{FileId, PathError, SourceError, Span};
use crate::syntax::{DirectiveError, nearest_directive};

/// A place in a file.
pub type At = (FileId, Span);

/// A fault of the fragments.
#[derive(Debug, Clone, thiserror::Error)]
pub enum ComposeError {
    /// `OR0101` … `OR0105`
    #[error("{1}")]
    Directive(FileId, DirectiveError),
    /// `OR0201`
    #[error("there is no option named `{name}`")]
    UnknownOption {
        /// What stands in the condition.
        name: String,
        /// The name that was probably meant.
        nearest: Option<String>,
        /// Where.
        at: At,
    },
    /// `OR0202`
    #[error("`{name}` is a parameter, and conditions read options")]
    ParameterInCondition {
        /// The parameter.
        name: String,
        /// Where.
        at: At,
        /// Where it is declared.
        declared: At,
    },
    /// `OR0203`
    #[error("{left} and {right} cannot be compared")]
    Mismatch {
        /// What stands on the left.
        left: String,
        /// What stands on the right.
        right: String,
        /// The operator.
        at: At,
    },
    /// `OR0204`
    #[error("`{found}` is not among the choices of `{option}`")]
    UnknownChoice {
        /// What stands in the condition.
        found: String,
        /// The option that it is compared to.
        option: String,
        /// What could stand there.
        choices: String,
        /// The choice that was probably meant.
        nearest: Option<String>,
        /// Where.
        at: At,
    },
    /// `OR0205`
    #[error("expected a condition, found {found}")]
    NotBool {
        /// What stands there.
        found: String,
        /// Where.
        at: At,
    },
    /// `OR0301`
    #[error("{error}")]
    Include {
        /// What the library said.
        error: SourceError,
        /// The path in the directive.
        at: At,
        /// The path of the library that was probably meant.
        nearest: Option<String>,
    },
    /// `OR0302`
    #[error("the scene cannot be read: {error}")]
    Scene {
        /// What the library said.
        error: SourceError,
        /// Where the preset names it.
        at: Option<At>,
        /// The path of the library that was probably meant.
        nearest: Option<String>,
    },
    /// `OR0309`
    #[error("the module cannot be read: {error}")]
    Module {
        /// What the library said.
        error: SourceError,
        /// The path of the library that was probably meant.
        nearest: Option<String>,
    },
    /// `OR0303`
    #[error("includes are nested deeper than {limit}")]
    TooDeep {
        /// How deep they may be.
        limit: usize,
        /// The include that goes too far.
        at: At,
    },
    /// `OR0304`
    #[error("there are more than {limit} instances of fragments")]
    TooMany {
        /// How many there may be.
        limit: usize,
        /// The include that goes too far.
        at: At,
    },
    /// `OR0305`
    #[error("the fragments are larger than {limit} MiB together, every instance counted")]
    TooLarge {
        /// How large they may be.
        limit: usize,
        /// The include that goes too far.
        at: At,
    },
    /// `OR0306`
    #[error("the preset names no scene")]
    NoScene,
    /// `OR0307`
    #[error("there is no debug view named `{name}`")]
    UnknownView {
        /// What was asked for.
        name: String,
        /// The name that was probably meant.
        nearest: Option<String>,
        /// Those that there are.
        views: Vec<String>,
    },
    /// `OR0308`
    #[error("the view `{view}` shows what the scene `{scene}` does not have: {}", listed(.groups))]
    NotInScene {
        /// The view.
        view: String,
        /// The scene.
        scene: Arc<str>,
        /// What the view reads: groups of parameters.
        groups: Vec<String>,
    },
    /// `OR0401`
    #[error("`{name}` is declared twice")]
    Duplicate {
        /// The name.
        name: String,
        /// The second place.
        at: At,
        /// The first place.
        first: At,
        /// What would mend it.
        help: &'static str,
    },
    /// `OR0402`
    #[error("the slot `{slot}` of `{fragment}` is not filled")]
    SlotMissing {
        /// The slot.
        slot: String,
        /// The fragment that declares it.
        fragment: String,
        /// What it takes.
        signature: String,
        /// The include.
        at: At,
        /// Where the slot is declared.
        declared: At,
    },
    /// `OR0403`
    #[error("`{fragment}` has no slot named `{slot}`")]
    SlotUnknown {
        /// What stands there.
        slot: String,
        /// The included fragment.
        fragment: String,
        /// The slots that it has.
        slots: String,
        /// Where.
        at: At,
    },
    /// `OR0404`
    #[error("`{target}` does not fit the slot `{slot}`")]
    SlotType {
        /// What was given.
        target: String,
        /// The slot.
        slot: String,
        /// What the slot takes.
        expected: String,
        /// What was given is of this type.
        found: String,
        /// The include.
        at: At,
        /// Where the slot is declared.
        declared: At,
        /// Where the target is declared.
        target_at: At,
    },
    /// `OR0405`
    #[error("there is no function named `{target}` to fill the slot `{slot}`")]
    SlotTarget {
        /// What was given.
        target: String,
        /// The slot.
        slot: String,
        /// The name that was probably meant.
        nearest: Option<String>,
        /// Where.
        at: At,
    },
    /// `OR0406`
    #[error("`{fragment}` is included twice with different slots")]
    SlotConflict {
        /// The fragment, with its instance's name.
        fragment: String,
        /// The second include.
        at: At,
        /// The first include.
        first: At,
    },
    /// `OR0407`
    #[error("the local name `{name}` hides {what}")]
    Hidden {
        /// The name.
        name: String,
        /// What it hides.
        what: String,
        /// Where.
        at: At,
    },
    /// `OR0408`
    #[error("there is no parameter or option named `{key}`")]
    UnknownMember {
        /// What stands there.
        key: String,
        /// The name that was probably meant.
        nearest: Option<String>,
        /// Where.
        at: At,
    },
    /// `OR0409`
    #[error("`{key}` is a choice among names, which has no value in code")]
    ChoiceInCode {
        /// The option.
        key: String,
        /// Where.
        at: At,
        /// Where it is declared.
        declared: At,
    },
    /// `OR0410`
    #[error("`{group}` is a group of parameters, not a value")]
    GroupAsValue {
        /// The group.
        group: String,
        /// Where.
        at: At,
    },
    /// `OR0411`
    #[error("a fragment with parameters of more than one group cannot be included `as` something")]
    SeveralGroups {
        /// The include.
        at: At,
        /// The first parameter.
        first: At,
        /// A parameter of another group.
        second: At,
    },
    /// `OR0412`
    #[error("`{name}` is set to both `{first_value}` and `{value}`")]
    DiagnosticConflict {
        /// The diagnostic's rule.
        name: String,
        /// The second severity.
        value: String,
        /// The first severity.
        first_value: String,
        /// The second place.
        at: At,
        /// The first place.
        first: At,
    },
    /// `OR0414`
    #[error("`main_image` is {found}, and a scene's is `fn(vec2f) -> vec4f`")]
    MainImage {
        /// What it is.
        found: String,
        /// Where its name stands.
        at: At,
    },
    /// `OR0415`
    #[error("no name of WGSL can start with `{prefix}`")]
    Prefix {
        /// What was asked for.
        prefix: String,
    },
    /// `OR0416`
    #[error("with the prefix `{prefix}`, `{name}` becomes `{becomes}`, which WGSL keeps for itself")]
    PrefixTaken {
        /// What was asked for.
        prefix: String,
        /// The name in the fragment.
        name: String,
        /// The name in the result.
        becomes: String,
        /// Where it is declared.
        at: At,
    },
    /// `OR0417`
    #[error("the module declares no `{name}`")]
    NotDeclared {
        /// What was asked for.
        name: String,
        /// The name that was probably meant.
        nearest: Option<String>,
        /// What it declares.
        known: String,
    },
    /// `OR0418`
    #[error("{what}")]
    NotOpen {
        /// What cannot be left open, and why.
        what: String,
        /// What to do.
        help: &'static str,
        /// Where.
        at: At,
    },
    /// `OR0413`
    #[error("`{name}` is the name of Orogen's uniform buffer")]
    Reserved {
        /// The name.
        name: String,
        /// Where.
        at: At,
    },
}

impl From<ComposeError> for Diagnostic {
    fn from(error: ComposeError) -> Self {
        use ComposeError as E;
        let message = error.to_string();
        let d = |code, (file, span): At, label: &str| {
            Diagnostic::error(code, message.clone()).at(file, span, label)
        };
        let also = |d: Diagnostic, (file, span): At, label: &str| d.and(file, span, label);
        let did_you_mean = |nearest: Option<String>| nearest.map(|name| format!("did you mean `{name}`?"));
        match error {
            E::Directive(file, error) => directive(file, error),
            E::UnknownOption { nearest, at, .. } => d("OR0201", at, "unknown")
                .help(did_you_mean(nearest).or_else(|| Some("declare it: `#option group.name = …`".into()))),
            E::ParameterInCondition { at, declared, .. } => {
                also(d("OR0202", at, "a parameter"), declared, "declared here").help(Some(
                    "a parameter may change while the shader runs; declare it as `#option`".into(),
                ))
            }
            E::Mismatch { at, .. } => d("OR0203", at, "cannot be compared").help(Some(
                "compare numbers with numbers, an option with its choices, and booleans with `==` or `!=`"
                    .into(),
            )),
            E::UnknownChoice { choices, nearest, at, .. } => d("OR0204", at, "not a choice")
                .help(did_you_mean(nearest).or_else(|| Some(format!("choose {choices}")))),
            E::NotBool { at, .. } => {
                d("OR0205", at, "not a condition").help(Some("compare it with something".into()))
            }
            E::Include { error, at, nearest } => {
                let label = match &error {
                    SourceError::NotFound { .. } => "not found",
                    SourceError::Path { .. } => "not allowed",
                    SourceError::TooLarge { .. } => "too large",
                    SourceError::NotText { .. } | SourceError::Unreadable { .. } => "cannot be read",
                };
                let is_outside = matches!(&error, SourceError::Path { why: PathError::Outside, .. });
                let mut d = d("OR0301", at, label);
                if let SourceError::NotFound { tried, .. } = error {
                    d = d.notes(tried.iter().map(|place| format!("looked for {place}")));
                }
                let root =
                    "a root is the folder of the file named on the command line, or one given with `-I DIR`";
                d.help(
                    did_you_mean(nearest.map(|path| format!("<{path}>"))).or(is_outside.then(|| root.into())),
                )
            }
            E::Scene { error, at, nearest } => {
                let mut d = match at {
                    Some((file, span)) => {
                        Diagnostic::error("OR0302", message.clone()).at(file, span, "named here")
                    }
                    None => Diagnostic::error("OR0302", message.clone()),
                };
                if let SourceError::NotFound { tried, .. } = error {
                    d = d.notes(tried.iter().map(|place| format!("looked for {place}")));
                }
                // On the command line a module stands in angle brackets, in a preset it does not.
                let module = nearest.map(|path| if at.is_some() { path } else { format!("<{path}>") });
                d.help(did_you_mean(module))
            }
            E::Module { error, nearest } => {
                let mut d = Diagnostic::error("OR0309", message.clone());
                if let SourceError::NotFound { tried, .. } = error {
                    d = d.notes(tried.iter().map(|place| format!("looked for {place}")));
                }
                d.help(did_you_mean(nearest).or_else(|| Some("`orogen list modules` names them all".into())))
            }
            E::TooDeep { at, .. } => d("OR0303", at, "one level too many")
                .help(Some("does a fragment include itself `as` something?".into())),
            E::TooMany { at, .. } => d("OR0304", at, "one instance too many")
                .help(Some("does a fragment include itself `as` something?".into())),
            E::TooLarge { at, .. } => d("OR0305", at, "too much with this one"),
            E::NoScene => Diagnostic::error("OR0306", message)
                .help(Some("add `\"scene\": \"scene/landscape.wgsl\"` to it, or to what it extends".into())),
            E::UnknownView { nearest, views, .. } => Diagnostic::error("OR0307", message)
                .help(did_you_mean(nearest).or_else(|| Some(one_of_the_views(&views)))),
            E::NotInScene { .. } => Diagnostic::error("OR0308", message).help(Some(
                "choose another view, or switch off what it can do without: `orogen params PRESET --view NAME` lists its options"
                    .into(),
            )),
            E::Duplicate { at, first, help, .. } => {
                also(d("OR0401", at, "declared again"), first, "declared here first").help(Some(help.into()))
            }
            E::SlotMissing { slot, signature, at, declared, .. } => {
                also(d("OR0402", at, "included here"), declared, "the slot is declared here")
                    .help(Some(format!("add `with {slot} = NAME`, where NAME is a `{signature}`")))
            }
            E::SlotUnknown { slots, at, .. } => {
                d("OR0403", at, "no such slot").help(Some(format!("it has {slots}")))
            }
            E::SlotType { expected, found, at, declared, target_at, .. } => also(
                also(d("OR0404", at, "given here"), target_at, &format!("this is {found}")),
                declared,
                &format!("the slot takes `{expected}`"),
            ),
            E::SlotTarget { nearest, at, .. } => d("OR0405", at, "unknown").help(did_you_mean(nearest)),
            E::SlotConflict { at, first, .. } => {
                also(d("OR0406", at, "with other slots"), first, "included here first")
                    .help(Some("give one of them a name of its own: `as NAME`".into()))
            }
            E::Hidden { at, .. } => {
                d("OR0407", at, "hides it").help(Some("give the local another name".into()))
            }
            E::UnknownMember { nearest, at, .. } => d("OR0408", at, "unknown").help(
                did_you_mean(nearest).or_else(|| Some("declare it: `#param group.name: type = …`".into())),
            ),
            E::ChoiceInCode { at, declared, .. } => {
                also(d("OR0409", at, "used as a value"), declared, "declared here")
                    .help(Some("use it in an `#if`".into()))
            }
            E::GroupAsValue { at, .. } => d("OR0410", at, "a group").help(Some("write `group.name`".into())),
            E::SeveralGroups { at, first, second } => {
                also(also(d("OR0411", at, "included here"), first, "one group"), second, "another group")
                    .help(Some("split the fragment, one group a file".into()))
            }
            E::DiagnosticConflict { at, first, .. } => also(d("OR0412", at, "set here"), first, "and here"),
            E::MainImage { at, .. } => d("OR0414", at, "not what calls it expects")
                .help(Some("write `fn main_image(frag_coord: vec2f) -> vec4f`".into())),
            E::Prefix { .. } => Diagnostic::error("OR0415", message)
                .help(Some("start it with a letter, and go on with letters, digits and `_`: `og_`".into())),
            E::PrefixTaken { at, .. } => {
                d("OR0416", at, "declared here").help(Some("choose a longer prefix: `og_`".into()))
            }
            E::NotDeclared { nearest, known, .. } => Diagnostic::error("OR0417", message)
                .help(did_you_mean(nearest).or_else(|| Some(format!("choose {known}")))),
            E::NotOpen { help, at, .. } => d("OR0418", at, "here").help(Some(help.into())),
            E::Reserved { at, .. } => d("OR0413", at, "reserved").help(Some("give it another name".into())),
        }
    }
}

/// `terrain`, `ground`
fn listed(groups: &[String]) -> String {
    groups.iter().map(|group| format!("`{group}`")).collect::<Vec<_>>().join(", ")
}

fn one_of_the_views(views: &[String]) -> String {
    if views.is_empty() {
        return "a view is a fragment of the library, `inspect/NAME.wgsl`, and this library has none".into();
    }
    format!("choose {}", choices(views.iter().map(String::as_str)))
}

fn directive(file: FileId, error: DirectiveError) -> Diagnostic {
    use DirectiveError as E;
    let message = error.to_string();
    let d = |code, span, label: &str| Diagnostic::error(code, message.clone()).at(file, span, label);
    match error {
        E::Unknown { name, span } => d("OR0101", span, "unknown").help(
            nearest_directive(&name).map(|near| format!("did you mean `#{near}`?")).or_else(|| {
                Some("there are #include, #param, #option, #slot, #if, #elif, #else and #endif".into())
            }),
        ),
        E::Syntax { span, usage, .. } => d("OR0102", span, "here").help(Some(format!("write `{usage}`"))),
        E::Value { span, .. } => d("OR0103", span, "here"),
        E::Unbalanced { span, other, .. } => {
            let d = d("OR0104", span, "here");
            match other {
                Some(other) => d.and(file, other, "it comes after this one"),
                None => d,
            }
        }
        E::Operators { span } => {
            d("OR0106", span, "here").help(Some("write them as one, or in steps".into()))
        }
        E::Inside { span, .. } => d("OR0105", span, "here")
            .help(Some("only conditions may stand there; move it between two declarations".into())),
    }
}
