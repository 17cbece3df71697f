//! What a library has: its fragments, its scenes, the options that they declare.

use super::cache::Cache;
use crate::source::Library;
use crate::syntax::DirectiveKind;

/// Names, each with one line about it; sorted.
#[derive(Debug, Clone, Default)]
pub struct Catalogue {
    /// All fragments, by path.
    pub modules: Vec<(String, String)>,
    /// The fragments that are whole pictures: those with `fn main_image`.
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
        if fragment.has_main_image {
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

/// The comment at the top of a fragment, its first paragraph on one line.
fn about(text: &str) -> String {
    let lines = text.lines().map_while(|line| line.strip_prefix("//"));
    let words = lines.map(|line| line.trim_start_matches('/').trim()).take_while(|line| !line.is_empty());
    words.collect::<Vec<_>>().join(" ")
}
