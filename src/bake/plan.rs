//! Which parameter becomes what.

use wildmatch::WildMatch;

use crate::compose::{Composition, Parameter};
use crate::diagnostic::{Diagnostic, Error, nearest};

/// How the parameters of a composition are baked. By default, all are constants.
///
/// The group `frame` is always live.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Bake {
    pub(crate) live: Vec<String>,
    pub(crate) overrides: Vec<String>,
    /// Live parameters are module-scope variables instead of fields of a uniform buffer.
    pub(crate) variables: bool,
    /// Those of the group `frame` are, whatever the others are.
    pub(crate) frame_variables: bool,
    /// Bind group and binding of the uniform buffer.
    pub(crate) binding: (u32, u32),
}

impl Bake {
    /// All parameters are constants.
    pub fn constants() -> Self {
        Self::default()
    }

    /// The parameters that a pattern matches are fields of one uniform buffer; the others, constants.
    ///
    /// Patterns are `group.name` with `*` and `?`, a group alone for all that is in it, or `default` for those declared
    /// `live`.
    pub fn live(patterns: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { live: patterns.into_iter().map(Into::into).collect(), ..Self::default() }
    }

    /// The parameters that a pattern matches are pipeline overrides, unless they are live.
    #[must_use]
    pub fn with_overrides(mut self, patterns: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.overrides = patterns.into_iter().map(Into::into).collect();
        self
    }

    /// Where the uniform buffer is bound. `@group(0) @binding(0)` unless told.
    #[must_use]
    pub fn at_binding(mut self, group: u32, binding: u32) -> Self {
        self.binding = (group, binding);
        self
    }

    /// The parameters of the group `frame` are plain module-scope variables, for targets whose hosts set each by its name.
    #[must_use]
    pub fn with_frame_as_variables(mut self) -> Self {
        self.frame_variables = true;
        self
    }

    /// Live parameters are plain module-scope variables, for targets without uniform buffers.
    #[must_use]
    pub fn as_variables(mut self) -> Self {
        self.variables = true;
        self
    }
}

/// What a parameter is in the shader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Storage {
    /// `const`
    Const,
    /// `override`; a vector is one of scalars a component.
    Override,
    /// A field of the uniform buffer.
    Uniform,
    /// `var<private>`
    Variable,
}

/// One storage a parameter, in their order.
///
/// # Errors
/// Patterns that match no parameter.
pub(super) fn plan(composition: &Composition, bake: &Bake) -> Result<Vec<Storage>, Error> {
    let mut errors = Vec::new();
    let live = matches(&bake.live, "--live", &composition.parameters, composition, &mut errors);
    let overrides =
        matches(&bake.overrides, "--overrides", &composition.parameters, composition, &mut errors);
    if !errors.is_empty() {
        return Err(Error::new(errors, composition.files.clone()));
    }
    let when_live = if bake.variables { Storage::Variable } else { Storage::Uniform };
    let storage = composition.parameters.iter().enumerate().map(|(index, parameter)| {
        let is_frame = parameter.decl.key.group == "frame";
        if is_frame && bake.frame_variables {
            Storage::Variable
        } else if live[index] || is_frame {
            when_live
        } else if overrides[index] {
            Storage::Override
        } else {
            Storage::Const
        }
    });
    Ok(storage.collect())
}

fn matches(
    patterns: &[String],
    flag: &str,
    parameters: &[Parameter],
    composition: &Composition,
    errors: &mut Vec<Diagnostic>,
) -> Vec<bool> {
    let mut hit = vec![false; parameters.len()];
    for pattern in patterns.iter().map(|pattern| pattern.trim()) {
        let whole = WildMatch::new(pattern);
        let fits = |parameter: &Parameter| {
            let key = &parameter.decl.key;
            (pattern == "default" && parameter.decl.live)
                || whole.matches(&key.to_string())
                || *pattern == key.group
        };
        let mut any = pattern == "*" || pattern == "default"; // they may match nothing
        for (index, parameter) in parameters.iter().enumerate() {
            if fits(parameter) {
                hit[index] = true;
                any = true;
            }
        }
        if !any {
            errors.push(no_match(pattern, flag, &whole, composition));
        }
    }
    hit
}

fn no_match(pattern: &str, flag: &str, whole: &WildMatch, composition: &Composition) -> Diagnostic {
    let message = format!("`{flag} {pattern}` matches no parameter");
    let diagnostic = Diagnostic::error("OR0601", message);
    let option = composition.options.iter().find(|option| whole.matches(&option.decl.key.to_string()));
    if let Some(option) = option {
        return diagnostic.and(option.at.0, option.at.1, "this is an option").help(Some(
            "options are decided when the shader is composed; set one with `--set` or in the preset".into(),
        ));
    }
    let keys: Vec<_> = composition.parameters.iter().map(|p| p.decl.key.to_string()).collect();
    let groups = composition.parameters.iter().map(|p| p.decl.key.group.as_str());
    let near = nearest(pattern, keys.iter().map(String::as_str).chain(groups));
    diagnostic.help(Some(match near {
        Some(name) => format!("did you mean `{name}`?"),
        None => "`orogen params` lists the parameters; `*` stands for any letters".into(),
    }))
}
