//! [`Query`] → the fragment that evaluates it; and errors in that fragment → errors in what the user wrote.

use std::ops::Range;

use super::Query;
use super::error::SampleError;
use super::layout::Leaf;
use super::value::Kind;
use crate::diagnostic::{Diagnostic, Error, Label};
use crate::source::{FileId, Files, Span};

/// What the expression is called in errors.
pub(super) const NAME: &str = "<expression>";
/// The entry point.
pub(super) const ENTRY: &str = "orogen_evaluate";
/// The expression's value.
pub(super) const VALUE: &str = "orogen_value";
/// The buffer of points.
pub(super) const INPUT: &str = "orogen_in";
/// The buffer of results.
pub(super) const OUTPUT: &str = "orogen_out";
/// The bind group of both, in this order. The parameters' own is group 0.
pub(super) const GROUP: u32 = 1;
/// Points a workgroup.
pub(super) const WORKGROUP: u32 = 64;

const FLAG: &str = "--include";

/// A generated fragment, and where in it the user's own text stands.
pub(super) struct Root {
    pub(super) text: String,
    expression: Range<usize>,
    includes: Vec<Range<usize>>,
}

/// Refuses includes that would be more than one line of the fragment.
pub(super) fn check_includes(includes: &[String]) -> Result<(), SampleError> {
    for include in includes {
        let fault = |why| Err(SampleError::Include { text: include.clone(), why });
        if include.contains(|c: char| crate::syntax::is_line_break(c) || c.is_control()) {
            return fault("it is more than one line");
        }
        if include.trim().is_empty() {
            return fault("it names nothing");
        }
    }
    Ok(())
}

/// The fragment. Without `leaves` it only names the value, so that its type can be asked for.
pub(super) fn root(query: &Query<'_>, leaves: Option<&[Leaf]>) -> Root {
    let mut text = String::new();
    let mut includes = Vec::new();
    for include in query.includes {
        text.push_str("#include ");
        let include = include.trim();
        let start = text.len();
        let is_bare = !include.starts_with(['<', '"']);
        let shown = if is_bare { format!("<{include}>") } else { include.to_owned() };
        text.push_str(&shown);
        includes.push(start..text.len());
        text.push('\n');
    }
    let (columns, count) = (&query.points.columns, leaves.map_or(1, <[Leaf]>::len));
    text += &format!(
        "@group({GROUP}) @binding(0) var<storage, read> {INPUT}: array<u32>;
@group({GROUP}) @binding(1) var<storage, read_write> {OUTPUT}: array<u32>;
@compute @workgroup_size({WORKGROUP})
fn {ENTRY}(@builtin(global_invocation_id) orogen_id: vec3u) {{
let orogen_at = orogen_id.x;
if orogen_at >= arrayLength(&{OUTPUT}) / {count}u {{ return; }}
"
    );
    for (index, column) in columns.iter().enumerate() {
        let (name, kind, width) = (&column.name, column.kind.name(), columns.len());
        text += &format!("let {name} = bitcast<{kind}>({INPUT}[orogen_at * {width}u + {index}u]);\n");
    }
    let is_axis = |axis: &&str| columns.iter().any(|c| c.name == *axis && c.kind == Kind::F32);
    let axes: Vec<_> = ["x", "y", "z", "w"].into_iter().take_while(is_axis).collect();
    if axes.len() >= 2 {
        text += &format!("let p = vec{}f({});\n", axes.len(), axes.join(", "));
    }
    text += &format!("let {VALUE} =\n");
    let start = text.len();
    text.push_str(query.expression);
    let expression = start..text.len();
    text.push_str("\n;\n"); // on a line of its own: the expression may end in a comment
    for (index, Leaf { access, kind, .. }) in leaves.unwrap_or_default().iter().enumerate() {
        let bits = match kind {
            Kind::Bool => format!("select(0u, 1u, {VALUE}{access})"),
            _ => format!("bitcast<u32>({VALUE}{access})"),
        };
        text += &format!("{OUTPUT}[orogen_at * {count}u + {index}u] = {bits};\n");
    }
    text.push_str("}\n");
    Root { text, expression, includes }
}

/// An error about the whole expression.
pub(super) fn whole(expression: &str, what: String) -> Error {
    SampleError::Type { what, text: expression.to_owned() }.into()
}

impl Root {
    /// `error`, with places in the generated fragment told in what the user wrote, or left out.
    pub(super) fn told(&self, error: Error, query: &Query<'_>) -> Error {
        let mut files = Files::default();
        let mut generated = None;
        for (id, file) in error.files().iter() {
            if *file.name == *NAME && *file.text == *self.text {
                generated = Some(id);
                files.add(NAME, query.expression);
            } else {
                files.add(file.name.clone(), file.text.clone());
            }
        }
        let Some(generated) = generated else { return error };
        let mut windows = vec![(self.expression.clone(), generated)];
        for range in &self.includes {
            windows.push((range.clone(), files.add(FLAG, &self.text[range.clone()])));
        }
        let told = error.diagnostics().iter().map(|diagnostic| {
            let labels = diagnostic.labels.iter().filter_map(|label| {
                if label.file == generated { seen(label, &windows) } else { Some(label.clone()) }
            });
            let notes = diagnostic.notes.iter().filter_map(|note| self.note(note));
            Diagnostic { labels: labels.collect(), notes: notes.collect(), ..diagnostic.clone() }
        });
        Error::new(told.collect(), files)
    }

    /// A note without the generated fragment: `… is included at <expression>:2:1` names what asked for it instead.
    fn note(&self, note: &str) -> Option<String> {
        if note.contains(ENTRY) {
            return None;
        }
        let place = format!(" is included at {NAME}:");
        let Some((what, place)) = note.split_once(&place) else { return Some(note.to_owned()) };
        let line = place.split(':').next().and_then(|line| line.parse::<usize>().ok());
        let range = line.and_then(|line| self.includes.get(line.checked_sub(1)?))?;
        Some(format!("{what} is included by `{FLAG} '{}'`", &self.text[range.clone()]))
    }
}

/// The part of a label that lies in a window, as a label there.
fn seen(label: &Label, windows: &[(Range<usize>, FileId)]) -> Option<Label> {
    let (start, end) = (label.span.start as usize, label.span.end as usize);
    windows.iter().find_map(|(window, file)| {
        // What is missing at the end of the expression is found missing where the next line starts.
        let is_after = start > window.end && start <= window.end + 1;
        if is_after || start == window.end {
            let at = Span::new(window.len(), window.len());
            return Some(Label { file: *file, span: at, ..label.clone() });
        }
        let (start, end) = (start.max(window.start), end.min(window.end));
        (start < end).then(|| {
            let span = Span::new(start - window.start, end - window.start);
            Label { file: *file, span, ..label.clone() }
        })
    })
}
