//! The comment at the top of a file: what it is, what is set, whose it is.

use crate::bake::Facts;
use crate::diagnostic::Error;
use crate::shader::Shader;
use crate::source::Templates;
use crate::template;

/// For the languages with a preprocessor: no line ends in a backslash, which would join the next one to the comment.
pub(super) fn header(shader: &Shader, templates: &Templates) -> Result<String, Error> {
    let facts = Facts::of(&shader.baked().composition);
    let text = template::render(templates, "header.jinja", facts)?;
    let lines = text.trim_end().lines().map(|line| line.trim_end().trim_end_matches('\\'));
    Ok(lines.collect::<Vec<_>>().join("\n"))
}
