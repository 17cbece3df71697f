//! Where templates come from: the embedded ones, and a folder laid over them.

use std::path::PathBuf;

use super::{SourceError, read_text, template_text};

/// Templates by name.
#[derive(Debug, Clone, Default)]
pub struct Templates {
    folder: Option<PathBuf>,
}

impl Templates {
    /// Orogen's own.
    pub fn standard() -> Self {
        Self::default()
    }

    /// Orogen's own, with the files in `folder` laid over them.
    ///
    /// # Errors
    /// Where `folder` is no folder.
    pub fn with_folder(folder: impl Into<PathBuf>) -> Result<Self, SourceError> {
        let folder = folder.into();
        if !folder.is_dir() {
            let path = folder.display().to_string();
            return Err(SourceError::Unreadable { path, why: "it is not a folder".into() });
        }
        Ok(Self { folder: Some(folder) })
    }

    /// Whether the folder has a `name` of its own.
    pub(crate) fn overlays(&self, name: &str) -> bool {
        self.folder.as_ref().is_some_and(|folder| folder.join(name).exists())
    }

    /// The text of the template `name`, and what its author calls it.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub(crate) fn get(&self, name: &str) -> Result<(String, String), SourceError> {
        if let Some(path) = self.folder.as_ref().map(|folder| folder.join(name)).filter(|path| path.exists())
        {
            let shown = path.display().to_string();
            return Ok((shown.clone(), read_text(&path, &shown)?.to_string()));
        }
        let shown = format!("templates/{name}");
        match template_text(name) {
            Some(text) => Ok((shown, text.to_owned())),
            None => Err(SourceError::NotFound { path: shown, tried: Vec::new() }),
        }
    }
}
