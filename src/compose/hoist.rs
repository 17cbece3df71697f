//! `enable`, `requires` and `diagnostic` of all that is in → the top of the result, each once.

use rustc_hash::FxHashMap;

use super::emit::{self, Hoisted};
use super::error::ComposeError;
use super::names::Names;
use super::shake;
use crate::syntax::DeclarationKind;

/// The directives that the result starts with.
pub(super) fn hoist(names: &Names<'_>, kept: &shake::Kept, errors: &mut Vec<ComposeError>) -> Vec<Hoisted> {
    let mut hoisted: Vec<Hoisted> = Vec::new();
    let mut by_rule: FxHashMap<String, usize> = FxHashMap::default();
    for instance in names.order {
        let Some(active) = &names.active[*instance] else { continue };
        let is_root = names.graph.roots.contains(instance);
        // A file of nothing but directives is included for their sake.
        let only_directives = active.module.declarations.iter().all(|d| emit::is_directive(d.kind));
        if !is_root && !only_directives && !kept.declarations[*instance].contains(&true) {
            continue;
        }
        for declaration in active.module.declarations.iter().filter(|d| emit::is_directive(d.kind)) {
            let text = active.text[declaration.span.range()].trim_end_matches(';');
            let body: String = text
                .split_once(|c: char| !c.is_ascii_alphabetic())
                .map_or("", |(keyword, _)| &text[keyword.len()..])
                .trim()
                .into();
            let file = names.graph.file(*instance);
            let new =
                Hoisted { instance: *instance, file, span: declaration.span, kind: declaration.kind, body };
            let twin = *by_rule.entry(subject(&new)).or_insert(hoisted.len());
            match hoisted.get(twin) {
                None => hoisted.push(new),
                Some(known) if plain(&known.body) != plain(&new.body) => {
                    let value = |body: &str| {
                        body.trim_matches(['(', ')']).split(',').next().unwrap_or("").trim().to_owned()
                    };
                    let rule =
                        plain(&new.body).split_once(',').map_or(String::new(), |(_, rule)| rule.into());
                    errors.push(ComposeError::DiagnosticConflict {
                        name: rule.trim_end_matches(')').into(),
                        value: value(&new.body),
                        first_value: value(&known.body),
                        at: (names.graph.file(*instance), new.span),
                        first: (names.graph.file(known.instance), known.span),
                    });
                }
                Some(_) => {}
            }
        }
    }
    // WGSL wants `diagnostic`, `enable` and `requires` before all else, in any order.
    hoisted.sort_by_key(|directive| directive.kind != DeclarationKind::Enable);
    hoisted
}

fn plain(body: &str) -> String {
    body.chars().filter(|c| !c.is_whitespace()).collect()
}

/// What a directive says something about: there is one of each.
fn subject(directive: &Hoisted) -> String {
    let body = plain(&directive.body);
    match (directive.kind, body.split_once(',')) {
        (DeclarationKind::Diagnostic, Some((_, rule))) => format!("diagnostic {rule}"),
        (kind, _) => format!("{kind:?} {body}"),
    }
}
