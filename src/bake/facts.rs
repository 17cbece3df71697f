//! What a file's header says: [`Composition`] → [`Facts`].

use serde::Serialize;

use super::text::clean;
use crate::compose::Composition;

/// What a file's header says.
#[derive(Serialize)]
pub(crate) struct Facts {
    name: String,
    about: String,
    version: &'static str,
    /// `terrain.relief = ridged`
    options: Vec<String>,
    licences: Vec<Licence>,
}

/// Fragments under one licence.
#[derive(Serialize)]
struct Licence {
    licence: String,
    files: Vec<String>,
}

impl Facts {
    pub(crate) fn of(composition: &Composition) -> Self {
        let option = |option: &crate::compose::Choice| {
            clean(&format!("{} = {}", option.decl.key, option.decl.show(option.value)))
        };
        Self {
            name: clean(&composition.name),
            about: clean(&composition.about),
            version: env!("CARGO_PKG_VERSION"),
            options: composition
                .options
                .iter()
                .filter(|option| option.read || option.decides)
                .map(option)
                .collect(),
            licences: licences(composition),
        }
    }

    /// The licence that most files are under.
    #[cfg(feature = "check")]
    pub(crate) fn main_licence(&self) -> &str {
        let most = self.licences.iter().max_by_key(|entry| entry.files.len());
        most.map_or("", |entry| &entry.licence)
    }
}

/// Each file once, however many instances there are of it.
fn licences(composition: &Composition) -> Vec<Licence> {
    let mut all: Vec<Licence> = Vec::new();
    for part in &composition.parts {
        let licence = clean(part.licence.as_deref().unwrap_or("not stated"));
        let file = clean(&composition.files.get(part.file).name);
        let at = all.iter().position(|known| known.licence == licence).unwrap_or_else(|| {
            all.push(Licence { licence, files: Vec::new() });
            all.len() - 1
        });
        if !all[at].files.contains(&file) {
            all[at].files.push(file);
        }
    }
    for licence in &mut all {
        licence.files.sort_unstable();
    }
    all
}
