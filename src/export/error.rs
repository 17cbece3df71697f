//! Why there is no file: [`ExportError`] → [`Diagnostic`].

use super::Target;
use crate::diagnostic::{Diagnostic, Error, choices, nearest};
use crate::shader::Shader;
use crate::source::Span;

/// Why a shader cannot be written for a target.
#[derive(Debug, Clone, thiserror::Error)]
pub enum ExportError {
    /// `OR0803`
    #[error("there is no target named `{name}`")]
    UnknownTarget {
        /// What was asked for.
        name: String,
    },
    /// `OR0804`
    #[error("the target `{target}` has no compute shaders")]
    Stage {
        /// The target.
        target: Target,
    },
    /// `OR0805`
    #[error("the shader has no {what}")]
    NoEntryPoint {
        /// Which one is missing.
        what: String,
        /// The fragment entry points that it has.
        known: Vec<String>,
    },
    /// `OR0806`
    #[error("{what} does not exist in GLSL ES 3.00")]
    NotInEs300 {
        /// The built-in.
        what: String,
        /// Where it stands in the composed text.
        span: Option<Span>,
    },
    /// `OR0807`
    #[error("the entry point `{name}` cannot be wrapped for `{target}`: {why}")]
    Unwrappable {
        /// The target.
        target: Target,
        /// Its name.
        name: String,
        /// What is in the way.
        why: &'static str,
        /// Where it stands in the composed text.
        span: Option<Span>,
    },
    /// `OR0808`
    #[error("a host of `{target}` cannot bind `{name}`")]
    Binding {
        /// The target.
        target: Target,
        /// The variable.
        name: String,
        /// Whether it is the buffer of live parameters.
        ours: bool,
        /// Where it stands in the composed text.
        span: Option<Span>,
    },
    /// `OR0809`
    #[error("the overrides cannot be replaced by their defaults")]
    Overrides {
        /// naga's words.
        why: String,
    },
    /// `OR0810`
    #[error("the shader cannot be written as `{target}`")]
    Writer {
        /// The target.
        target: Target,
        /// naga's words.
        why: String,
    },
    /// `OR0812`
    #[error("Orogen itself failed while writing `{target}`")]
    Fault {
        /// The target.
        target: Target,
        /// What went wrong.
        why: String,
    },
    /// `OR0814`
    #[error("the target `{target}` takes no prefix")]
    Prefix {
        /// The target.
        target: Target,
    },
    /// `OR0811`
    #[error("naga panicked while writing `{target}`")]
    Panic {
        /// The target.
        target: Target,
        /// What it said.
        why: String,
    },
    /// `OR0820`
    #[error("the target `{target}` cannot be minified")]
    NotMinified {
        /// The target.
        target: Target,
    },
    /// `OR0821`
    #[error("the minified shader is not valid")]
    Minifier {
        /// What the check says.
        why: String,
    },
    /// `OR0822`
    #[error("the target `{target}` is a folder of files, not one")]
    NotOneFile {
        /// The target.
        target: Target,
    },
}

/// Told without a place.
impl From<ExportError> for Error {
    fn from(error: ExportError) -> Self {
        Self::bare(error.diagnostic())
    }
}

impl ExportError {
    /// Told at the author's place, where there is one.
    pub(super) fn told(self, shader: &Shader) -> Error {
        let baked = shader.baked();
        let (span, label) = match &self {
            Self::NotInEs300 { span, .. } => (*span, "used here"),
            Self::Unwrappable { span, .. } => (*span, "this entry point"),
            Self::Binding { span, .. } => (*span, "bound here"),
            _ => (None, ""),
        };
        let mut diagnostic = self.diagnostic();
        if let Some(origin) = span.and_then(|span| baked.map.origin(span)) {
            diagnostic = diagnostic.at(origin.file, origin.span, label);
            let chain = origin.instance.map(|instance| baked.composition.chain(instance as usize));
            diagnostic = diagnostic.notes(chain.unwrap_or_default());
        }
        Error::new(vec![diagnostic], baked.composition.files.clone())
    }

    fn diagnostic(self) -> Diagnostic {
        use ExportError as E;
        let d = |code| Diagnostic::error(code, self.to_string());
        match &self {
            E::UnknownTarget { name } => {
                let names = Target::ALL.map(Target::name);
                let near = nearest(name, names).map(|near| format!("did you mean `{near}`?"));
                d("OR0803").help(near.or_else(|| Some(format!("choose {}", choices(names)))))
            }
            E::Stage { .. } => d("OR0804")
                .help(Some("ask for the fragment stage, or for wgsl, spirv, hlsl or msl".into())),
            E::NoEntryPoint { known, .. } if known.is_empty() => d("OR0805").help(Some(
                "write one, or `fn main_image(frag_coord: vec2f) -> vec4f`, and Orogen adds the entry point".into(),
            )),
            E::NoEntryPoint { known, .. } => {
                d("OR0805").help(Some(format!("choose {}", choices(known.iter().map(String::as_str)))))
            }
            E::NotInEs300 { .. } => d("OR0806")
                .help(Some("leave it out of what the entry point reaches, or export another target".into())),
            E::Unwrappable { .. } => d("OR0807").help(Some(
                "let it take `@builtin(position)` alone and return one `vec4f`, or write `main_image` instead".into(),
            )),
            E::Binding { ours: true, .. } => d("OR0808")
                .help(Some("compose with `target.bake(…)`, which makes variables of live parameters".into())),
            E::Binding { .. } => {
                d("OR0808").help(Some("leave buffers, textures and samplers out of what `main_image` calls".into()))
            }
            E::NotMinified { .. } => {
                let names = Target::ALL.into_iter().filter(|target| target.is_minified()).map(Target::name);
                d("OR0820").help(Some(format!("leave `--minify` out, or choose {}", choices(names))))
            }
            E::Minifier { why } => d("OR0821").note(why.clone()).help(Some(
                "this is a fault of Orogen: export without `--minify`, and report the shader".into(),
            )),
            E::NotOneFile { .. } => d("OR0822").help(Some(
                "call `orogen::export::package`, or say on the command line which folder with `-o DIR`".into(),
            )),
            E::Overrides { why } => d("OR0809").note(why.clone()).help(Some(
                "give every `override` a default: `override name: f32 = 1.0;`".into(),
            )),
            E::Writer { why, .. } => d("OR0810")
                .note(format!("naga says: {why}"))
                .help(Some("the target lacks what the shader uses: leave that out, or export another target".into())),
            E::Prefix { .. } => d("OR0814")
                .help(Some("a file for Shadertoy is all that its shader has: nothing collides with it".into())),
            E::Fault { why, .. } => d("OR0812").note(why.clone()).help(Some(
                "this is a fault of Orogen; a smaller shader that shows it is worth a report".into(),
            )),
            E::Panic { why, .. } => d("OR0811").note(format!("naga says: {why}")).help(Some(
                "this is a fault of naga; export wgsl, which does not go through it, and report a smaller shader there"
                    .into(),
            )),
        }
    }
}
