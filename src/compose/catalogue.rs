//! What a library has: its fragments, its scenes, the options that they declare.

use super::cache::Cache;
use super::error::ComposeError;
use crate::diagnostic::nearest;
use crate::source::{Library, Source};
use crate::syntax::DirectiveKind;

/// Names, each with one line about it; sorted.
#[derive(Debug, Clone, Default)]
pub struct Catalogue {
    /// All fragments, by path.
    pub modules: Vec<(String, String)>,
    /// The fragments that are whole pictures: those with `fn main_image`, but for the debug views.
    pub scenes: Vec<(String, String)>,
    /// The debug views of a preset's scene, by the names that [`Compose::view`](crate::Compose::view) takes.
    pub views: Vec<(String, String)>,
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
        if fragment.has_main_image {
            match view_name(&path) {
                Some(name) => all.views.push((name.to_owned(), about.clone())),
                None => all.scenes.push((path.clone(), about.clone())),
            }
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

/// `inspect/steps.wgsl` → `steps`
fn view_name(path: &str) -> Option<&str> {
    let name = path.strip_prefix(VIEWS)?.strip_suffix(".wgsl")?;
    (!name.contains('/')).then_some(name)
}

/// The debug views of `library`, each with one line about it; sorted.
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
    let views = views(library);
    let names = || views.iter().map(|(name, _)| name.as_str());
    let unknown = || ComposeError::UnknownView {
        name: name.to_owned(),
        nearest: nearest(name, names()),
        views: names().map(str::to_owned).collect(),
    };
    if !names().any(|known| known == name) {
        return Err(unknown());
    }
    library.find(&format!("{VIEWS}{name}.wgsl")).map_err(|_| unknown())
}

/// The comment at the top of a fragment, its first paragraph on one line.
fn about(text: &str) -> String {
    let lines = text.lines().map_while(|line| line.strip_prefix("//"));
    let words = lines.map(|line| line.trim_start_matches('/').trim()).take_while(|line| !line.is_empty());
    words.collect::<Vec<_>>().join(" ")
}
