//! What a library has: its fragments, its scenes, the options that they declare.

use super::cache::Cache;
use super::error::ComposeError;
use crate::diagnostic::nearest;
use crate::source::{Library, Source, SourceError};
use crate::syntax::DirectiveKind;

/// Names, each with one line about it; sorted.
#[derive(Debug, Clone, Default)]
pub struct Catalogue {
    /// All fragments, by path.
    pub modules: Vec<(String, String)>,
    /// The fragments that are whole pictures: those with `fn main_image`, but for the debug [`views`].
    pub scenes: Vec<(String, String)>,
    /// The options that any of them declares, each with its choices.
    pub options: Vec<(String, String)>,
}

/// Reads all fragments of `library`. One that cannot be read is listed without a word about it.
pub fn catalogue(library: &Library) -> Catalogue {
    let mut cache = Cache::default();
    let mut all = Catalogue::default();
    for path in library.modules() {
        let Ok(source) = library.find(&path) else {
            all.modules.push((path, String::new()));
            continue;
        };
        let fragment = cache.fragment(&source);
        let about = about(&source.text);
        if fragment.has_main_image && view_name(&path).is_none() {
            all.scenes.push((path.clone(), about.clone()));
        }
        all.modules.push((path, about));
        for placed in &fragment.directives {
            if let DirectiveKind::Option(decl) = &placed.directive.kind {
                let doc = decl.doc.split_whitespace().collect::<Vec<_>>().join(" ");
                all.options
                    .push((decl.key.to_string(), format!("{doc} {}", decl.possible()).trim().to_owned()));
            }
        }
    }
    all.options.sort();
    all.options.dedup();
    all
}

/// The folder of the library that the debug views lie in: whole pictures, and what they have in common.
const VIEWS: &str = "inspect/";

/// The group of the parameters that debug views have for themselves.
pub(super) const OF_VIEWS: &str = "inspect";

/// `inspect/steps.wgsl` → `steps`
fn view_name(path: &str) -> Option<&str> {
    let name = path.strip_prefix(VIEWS)?.strip_suffix(".wgsl")?;
    (!name.contains('/')).then_some(name)
}

/// The debug views of `library`, by the names that [`Compose::view`](crate::Compose::view) takes, each with one line about
/// it; sorted.
pub fn views(library: &Library) -> Vec<(String, String)> {
    let mut cache = Cache::default();
    let mut views = Vec::new();
    for path in library.modules() {
        if let Some(name) = view_name(&path)
            && let Ok(source) = library.find(&path)
            && cache.fragment(&source).has_main_image
        {
            views.push((name.to_owned(), about(&source.text)));
        }
    }
    views
}

/// The debug view called `name`.
pub(super) fn view(library: &Library, name: &str) -> Result<Source, ComposeError> {
    let path = format!("{VIEWS}{name}.wgsl");
    match view_name(&path).map(|_| library.find(&path)) {
        Some(Ok(source)) if Cache::default().fragment(&source).has_main_image => Ok(source),
        None | Some(Ok(_) | Err(SourceError::NotFound { .. } | SourceError::Path { .. })) => {
            let views: Vec<String> = views(library).into_iter().map(|(name, _)| name).collect();
            let nearest = nearest(name, views.iter().map(String::as_str));
            Err(ComposeError::UnknownView { name: name.to_owned(), nearest, views })
        }
        Some(Err(error)) => Err(ComposeError::Scene { error, at: None, nearest: None }),
    }
}

/// The comment at the top of a fragment, its first paragraph on one line.
fn about(text: &str) -> String {
    let lines = text.lines().map_while(|line| line.strip_prefix("//"));
    let words = lines.map(|line| line.trim_start_matches('/').trim()).take_while(|line| !line.is_empty());
    words.collect::<Vec<_>>().join(" ")
}
