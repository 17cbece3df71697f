//! Renders a template, strictly: an undefined name is an error that points into the template.

use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{Environment, UndefinedBehavior};
use serde::Serialize;

use crate::diagnostic::{Diagnostic, Error};
use crate::source::{Files, Span, Templates};

/// The template `name` filled with `context`.
///
/// # Errors
/// Where it cannot be read or rendered.
pub(crate) fn render(templates: &Templates, name: &str, context: impl Serialize) -> Result<String, Error> {
    let (shown, text) =
        templates.get(name).map_err(|why| Error::bare(Diagnostic::error("OR0801", why.to_string())))?;
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.set_auto_escape_callback(|_| minijinja::AutoEscape::None);
    let mut syntax = SyntaxConfig::builder();
    syntax.trim_blocks(true).lstrip_blocks(true).keep_trailing_newline(true);
    if let Ok(syntax) = syntax.build() {
        environment.set_syntax(syntax); // it fails for odd delimiters only, and these are the usual ones
    }
    environment.add_filter("wrapped", wrapped);
    environment.set_fuel(Some(50_000_000)); // a template that does not end is an error
    let rendered = environment
        .template_from_named_str(&shown, &text)
        .and_then(|template| template.render(Serde(context)));
    rendered.map_err(|error| {
        let why =
            error.detail().map_or_else(|| error.kind().to_string(), |d| format!("{}: {d}", error.kind()));
        let mut diagnostic = Diagnostic::error("OR0802", format!("the template cannot be rendered: {why}"));
        let mut files = Files::default();
        let file = files.add(shown.as_str(), text.as_str());
        if let Some(line) = error.line() {
            let starts = files.get(file).line_starts().to_vec();
            let start = starts.get(line.saturating_sub(1)).map_or(0, |start| *start as usize);
            let end = starts.get(line).map_or(text.len(), |end| *end as usize - 1);
            diagnostic = diagnostic.at(file, Span::new(start, end.max(start)), "in this line");
        }
        Error::new(vec![diagnostic], files)
    })
}

/// How wide the lines of [`wrapped`] get, if their items let them.
const WIDTH: usize = 110;

/// The filter `wrapped`: items with commas between, `first` before the first line of them and `rest` before the others.
fn wrapped(items: Vec<String>, first: String, rest: String) -> String {
    let (mut text, mut width) = (first.clone(), first.chars().count());
    for (index, item) in items.iter().enumerate() {
        let comma = if index + 1 < items.len() { "," } else { "" };
        let more = item.chars().count() + comma.len();
        if index > 0 && width + 1 + more > WIDTH {
            text.push('\n');
            text.push_str(&rest);
            width = rest.chars().count();
        } else if index > 0 {
            text.push(' ');
            width += 1;
        }
        text.push_str(item);
        text.push_str(comma);
        width += more;
    }
    text
}
