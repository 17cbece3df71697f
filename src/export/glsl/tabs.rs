//! A Shadertoy file in two tabs: the library in Common, the scene in Image.

use super::emit::Emitted;
use super::{Context, allowed, emitted, fragment, is_scene, main_lines};
use crate::diagnostic::Error;
use crate::export::export_error;
use crate::export::header::header;
use crate::export::target::Target;
use crate::shader::Shader;
use crate::source::Templates;
use crate::template;

/// What goes into which tab of Shadertoy's editor.
#[derive(Debug, Clone)]
pub struct Tabs {
    /// Common: parameters, and the functions of the library that read nothing of Shadertoy's.
    pub common: String,
    /// Image: the scene, what reads Shadertoy's variables, and `mainImage`.
    pub image: String,
}

/// The file for Shadertoy in two tabs. Common one after the other they are the whole shader: Shadertoy joins them so.
///
/// # Errors
/// As [`export`](crate::export::export) for [`Target::Shadertoy`].
pub fn shadertoy_tabs(shader: &Shader, templates: &Templates) -> Result<Tabs, Error> {
    let target = Target::Shadertoy;
    let told = |error| export_error(error, shader);
    let entry = fragment(shader, None).map_err(told)?;
    allowed(shader, target, &entry).map_err(told)?;
    let emitted = emitted(shader, target, &entry, templates)?.map_err(told)?;
    let (common, image) = split(&emitted);
    let header = header(shader, templates)?;
    let context = |code: String| Context {
        header: header.clone(),
        code: crate::export::back::airy(code.trim()),
        main: main_lines(&emitted, target, is_scene(shader)),
        declarations: Vec::new(),
        json: String::new(),
    };
    Ok(Tabs {
        common: template::render(templates, "shadertoy_common.jinja", context(common))?,
        image: template::render(templates, "shadertoy.jinja", context(image))?,
    })
}

/// The text of each tab. A heading stands in the tab where something of its module does, and in both where both have some.
fn split(emitted: &Emitted) -> (String, String) {
    let (mut common, mut image) = (String::new(), String::new());
    let (mut in_common, mut in_image) = (None, None);
    let mut heading: Option<&str> = None;
    let mut start = 0;
    for piece in &emitted.pieces {
        let text = &emitted.text[start..piece.end];
        start = piece.end;
        let own = text.lines().rfind(|line| line.starts_with("// ---- ") && line.ends_with(" ----"));
        heading = own.or(heading);
        let (tab, last) =
            if piece.of_image { (&mut image, &mut in_image) } else { (&mut common, &mut in_common) };
        if own.is_none() && *last != heading && !text.trim().is_empty() {
            tab.push_str("\n\n");
            tab.push_str(heading.unwrap_or_default());
            tab.push_str("\n\n");
            tab.push_str(text.trim_start_matches('\n'));
        } else {
            tab.push_str(text);
        }
        *last = heading;
    }
    (common, image)
}
