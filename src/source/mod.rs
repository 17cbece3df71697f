//! Where text comes from: the embedded library, folders laid over it, single files, strings in memory.
//!
//! A path like `noise/perlin.wgsl` → [`Source`]: the text, its name for people, and its identity, so that a file that
//! is reached by two ways is read once. Everything here is bounded: 16 MiB a file, and no path out of its root.

mod files;
mod path;
mod span;
mod templates;

pub use files::{File, FileId, Files, Place};
pub use path::{PathError, folder, join};
pub use span::Span;
pub use templates::Templates;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use include_dir::{Dir, include_dir};

/// The largest file that is read.
pub const MAX_FILE_BYTES: u64 = 16 << 20;

static WGSL: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/wgsl");
static PRESETS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/presets");
static TEMPLATES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/templates");

/// Why a text could not be read.
#[derive(Debug, Clone, thiserror::Error)]
pub enum SourceError {
    /// Nothing of that name is in any place that was looked into.
    #[error("`{path}` was not found")]
    NotFound {
        /// As it was asked for.
        path: String,
        /// Every place that was looked into, in order.
        tried: Vec<String>,
    },
    /// The path cannot be followed inside its root.
    #[error("`{path}`: {why}")]
    Path {
        /// As it was asked for.
        path: String,
        /// What is wrong with it.
        why: PathError,
    },
    /// The file is larger than [`MAX_FILE_BYTES`].
    #[error("`{path}` is larger than 16 MiB")]
    TooLarge {
        /// The file.
        path: String,
    },
    /// The file is no UTF-8 text.
    #[error("`{path}` is not UTF-8 text (byte {at})")]
    NotText {
        /// The file.
        path: String,
        /// The first byte that is no text.
        at: usize,
    },
    /// The system would not give the file.
    #[error("`{path}` cannot be read: {why}")]
    Unreadable {
        /// The file.
        path: String,
        /// The system's reason.
        why: String,
    },
}

/// A text and where it is from.
#[derive(Debug, Clone)]
pub struct Source {
    /// For people: as the library or the command line names it.
    pub name: Arc<str>,
    /// All of it.
    pub text: Arc<str>,
    /// Equal for the same file, by whichever way it was reached.
    pub(crate) identity: Arc<str>,
    /// The file on disk, without links; none of what came from elsewhere.
    pub(crate) on_disk: Option<Arc<Path>>,
    /// What `"…"` includes are relative to.
    home: Home,
    /// The path inside `home`.
    path: Arc<str>,
}

/// The root that a source lies in.
#[derive(Debug, Clone)]
enum Home {
    Layer(usize),
    Folder(Arc<Folder>),
    Nowhere,
}

/// A folder on disk.
#[derive(Debug, Clone)]
struct Folder {
    /// Real path: no symbolic links.
    real: PathBuf,
    /// As the user wrote it.
    shown: String,
}

#[derive(Debug, Clone)]
enum Layer {
    Embedded,
    Folder(Arc<Folder>),
    Memory(BTreeMap<String, Arc<str>>),
}

/// The fragments that `#include <…>` finds: the embedded ones, and what is laid over them.
#[derive(Debug, Clone)]
pub struct Library {
    /// Later layers win.
    layers: Vec<Layer>,
}

impl Library {
    /// Orogen's own fragments.
    pub fn standard() -> Self {
        Self { layers: vec![Layer::Embedded] }
    }

    /// No fragment at all: for a host that brings all of its own.
    pub fn empty() -> Self {
        Self { layers: Vec::new() }
    }

    /// Lays a folder over what is there: a file in it hides the one of the same path below.
    ///
    /// # Errors
    /// Where `folder` is no readable folder.
    pub fn with_folder(mut self, folder: impl AsRef<Path>) -> Result<Self, SourceError> {
        self.layers.push(Layer::Folder(Arc::new(Folder::open(folder.as_ref())?)));
        Ok(self)
    }

    /// Lays one text over what is there, under `path` (`terrain/height.wgsl`).
    #[must_use]
    pub fn with_file(mut self, path: impl Into<String>, text: impl Into<Arc<str>>) -> Self {
        let (path, text) = (path.into(), text.into());
        match self.layers.last_mut() {
            Some(Layer::Memory(files)) => drop(files.insert(path, text)),
            _ => self.layers.push(Layer::Memory(BTreeMap::from([(path, text)]))),
        }
        self
    }

    /// The folders on disk that are laid over it, without links.
    #[cfg(feature = "watch")]
    pub(crate) fn folders(&self) -> Vec<PathBuf> {
        let folders = self.layers.iter().filter_map(|layer| match layer {
            Layer::Folder(folder) => Some(folder.real.clone()),
            Layer::Embedded | Layer::Memory(_) => None,
        });
        folders.collect()
    }

    /// The paths of all fragments, sorted. Folders on disk are walked at most 16 levels deep; links are not followed.
    pub fn modules(&self) -> Vec<String> {
        let mut paths = BTreeSet::new();
        for layer in &self.layers {
            match layer {
                Layer::Embedded => embedded_paths(&WGSL, &mut paths),
                Layer::Memory(files) => paths.extend(files.keys().cloned()),
                Layer::Folder(folder) => folder.walk(&mut paths),
            }
        }
        paths.into_iter().filter(|path| path.ends_with(".wgsl")).collect()
    }

    /// The fragment at `path`, counted from the library's root.
    ///
    /// # Errors
    /// Where there is none, or it cannot be read.
    pub fn find(&self, path: &str) -> Result<Source, SourceError> {
        let inside = join("", path).map_err(|why| SourceError::Path { path: path.into(), why })?;
        self.find_in_layers(path, &inside, Vec::new())
    }

    /// The fragment at `path`, beside `from` where there is one, else from the library's root.
    ///
    /// # Errors
    /// Where there is none, or it cannot be read, or the path leads out of the root that `from` lies in.
    pub fn find_beside(&self, from: &Source, path: &str) -> Result<Source, SourceError> {
        let inside =
            join(folder(&from.path), path).map_err(|why| SourceError::Path { path: path.into(), why })?;
        let mut tried = Vec::new();
        match &from.home {
            Home::Nowhere => {}
            Home::Folder(folder) => {
                if let Some(source) = folder.read(&inside, &mut tried)? {
                    return Ok(source);
                }
            }
            Home::Layer(index) => {
                if let Some(source) = self.read_from(*index, &inside, &mut tried)? {
                    return Ok(source);
                }
            }
        }
        match join("", path) {
            Ok(inside) => self.find_in_layers(path, &inside, tried),
            Err(_) => Err(SourceError::NotFound { path: path.into(), tried }),
        }
    }

    fn find_in_layers(
        &self,
        path: &str,
        inside: &str,
        mut tried: Vec<String>,
    ) -> Result<Source, SourceError> {
        for index in (0..self.layers.len()).rev() {
            if let Some(source) = self.read_from(index, inside, &mut tried)? {
                return Ok(source);
            }
        }
        let mut seen = BTreeSet::new();
        tried.retain(|place| seen.insert(place.clone())); // beside the file may be the root
        Err(SourceError::NotFound { path: path.into(), tried })
    }

    fn read_from(
        &self,
        index: usize,
        inside: &str,
        tried: &mut Vec<String>,
    ) -> Result<Option<Source>, SourceError> {
        let (text, layer): (Arc<str>, _) = match &self.layers[index] {
            Layer::Folder(folder) => return folder.read_as(inside, tried, Home::Layer(index)),
            Layer::Embedded => {
                let Some(text) = WGSL.get_file(inside).and_then(|file| file.contents_utf8()) else {
                    tried.push(format!("<{inside}>"));
                    return Ok(None);
                };
                (text.into(), "library")
            }
            Layer::Memory(files) => {
                let Some(text) = files.get(inside) else {
                    tried.push(format!("{inside} (in memory)"));
                    return Ok(None);
                };
                (text.clone(), "memory")
            }
        };
        if text.len() as u64 > MAX_FILE_BYTES {
            return Err(SourceError::TooLarge { path: inside.into() });
        }
        let identity = format!("{layer}{index}:{inside}").into();
        Ok(Some(Source {
            name: inside.into(),
            text,
            identity,
            on_disk: None,
            home: Home::Layer(index),
            path: inside.into(),
        }))
    }
}

impl Source {
    /// A text that stands in no folder.
    pub fn text(name: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> Self {
        let name = name.into();
        Self {
            identity: format!("text:{name}").into(),
            on_disk: None,
            path: name.clone(),
            name,
            text: text.into(),
            home: Home::Nowhere,
        }
    }

    /// A text of Orogen's own, that stands in no folder.
    pub(crate) fn ours(name: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> Self {
        let mut source = Self::text(name, text);
        source.identity = format!("library:{}", source.name).into();
        source
    }

    /// A file on disk. Its `"…"` includes are looked for in its folder and below.
    ///
    /// # Errors
    /// Where it cannot be read, is larger than 16 MiB, or is no UTF-8 text.
    pub fn file(path: &Path) -> Result<Self, SourceError> {
        let parent = match path.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        let shown = path.display().to_string();
        let name = path
            .file_name()
            .and_then(|name| name.to_str())
            .ok_or_else(|| SourceError::NotFound { path: shown.clone(), tried: Vec::new() })?;
        if !path.exists() {
            return Err(SourceError::NotFound { path: shown.clone(), tried: vec![shown] });
        }
        let folder = Arc::new(Folder::open(parent)?);
        let text = read_text(path, &shown)?;
        let real = path.canonicalize().map_err(|why| unreadable(&shown, &why))?;
        Ok(Self {
            name: shown.into(),
            text,
            identity: format!("file:{}", real.display()).into(),
            on_disk: Some(real.into()),
            home: Home::Folder(folder),
            path: name.into(),
        })
    }
}

impl Source {
    /// The file `inside` the folder at `folder`, which its includes cannot leave.
    ///
    /// # Errors
    /// As [`Source::file`].
    pub(crate) fn file_in(folder: &Path, inside: &str) -> Result<Self, SourceError> {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let mut tried = Vec::new();
        let found = Arc::new(Folder::open(folder)?).read(inside, &mut tried)?;
        found.ok_or_else(|| SourceError::NotFound { path: inside.into(), tried })
    }

    /// Its path inside the root that it lies in; of a text that lies nowhere, its name.
    pub(crate) fn path(&self) -> &Arc<str> {
        &self.path
    }

    /// The licence that the text states (`SPDX-License-Identifier: …`); for the library's own fragments, ours.
    pub(crate) fn licence(&self) -> Option<String> {
        const MARK: &str = "SPDX-License-Identifier:";
        let head = &self.text[..self.text.floor_char_boundary(2048)]; // it stands at the top, or not at all
        let stated = head.find(MARK).and_then(|at| head[at + MARK.len()..].lines().next());
        let ours = self.identity.starts_with("library").then(|| env!("CARGO_PKG_LICENSE").to_owned());
        stated.map(|licence| licence.trim().trim_end_matches("*/").trim().to_owned()).or(ours)
    }
}

impl Folder {
    fn open(path: &Path) -> Result<Self, SourceError> {
        let shown = path.display().to_string();
        let real = path.canonicalize().map_err(|why| unreadable(&shown, &why))?;
        if !real.is_dir() {
            return Err(SourceError::Unreadable { path: shown, why: "it is not a folder".into() });
        }
        Ok(Self { real, shown })
    }

    fn read(self: &Arc<Self>, inside: &str, tried: &mut Vec<String>) -> Result<Option<Source>, SourceError> {
        self.read_as(inside, tried, Home::Folder(self.clone()))
    }

    fn read_as(
        &self,
        inside: &str,
        tried: &mut Vec<String>,
        home: Home,
    ) -> Result<Option<Source>, SourceError> {
        let shown = if self.shown == "." {
            inside.to_owned()
        } else {
            format!("{}/{inside}", self.shown.trim_end_matches('/'))
        };
        let Ok(real) = self.real.join(inside).canonicalize() else {
            tried.push(shown);
            return Ok(None);
        };
        if !real.starts_with(&self.real) {
            return Err(SourceError::Path { path: shown, why: PathError::Outside }); // a symbolic link out
        }
        let text = read_text(&real, &shown)?;
        let identity = format!("file:{}", real.display()).into();
        let on_disk = Some(real.into());
        Ok(Some(Source { name: shown.into(), text, identity, on_disk, home, path: inside.into() }))
    }

    fn walk(&self, paths: &mut BTreeSet<String>) {
        let mut open = vec![(self.real.clone(), String::new(), 0)];
        while let Some((folder, prefix, depth)) = open.pop() {
            for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
                let (Ok(kind), Ok(name)) = (entry.file_type(), entry.file_name().into_string()) else {
                    continue;
                };
                if kind.is_dir() && depth < 16 {
                    open.push((entry.path(), format!("{prefix}{name}/"), depth + 1));
                } else if kind.is_file() {
                    paths.insert(format!("{prefix}{name}"));
                }
            }
        }
    }
}

/// The whole of a regular file, at most 16 MiB of it, as text.
pub(crate) fn read_text(path: &Path, shown: &str) -> Result<Arc<str>, SourceError> {
    let meta = fs::metadata(path).map_err(|why| unreadable(shown, &why))?;
    if !meta.is_file() {
        return Err(SourceError::Unreadable { path: shown.into(), why: "it is not a regular file".into() });
    }
    let file = fs::File::open(path).map_err(|why| unreadable(shown, &why))?;
    let mut bytes = Vec::with_capacity(meta.len().min(MAX_FILE_BYTES) as usize + 1);
    // The length may grow between the look and the reading.
    file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes).map_err(|why| unreadable(shown, &why))?;
    if bytes.len() as u64 > MAX_FILE_BYTES {
        return Err(SourceError::TooLarge { path: shown.into() });
    }
    if bytes.starts_with(b"\xef\xbb\xbf") {
        bytes.drain(..3); // the mark that some editors start a file with says nothing
    }
    String::from_utf8(bytes)
        .map(Into::into)
        .map_err(|why| SourceError::NotText { path: shown.into(), at: why.utf8_error().valid_up_to() })
}

/// The path without symbolic links: the same for the same file. None where there is no such file.
pub(crate) fn real_path(path: &Path) -> Option<PathBuf> {
    path.canonicalize().ok()
}

fn unreadable(path: &str, why: &std::io::Error) -> SourceError {
    SourceError::Unreadable { path: path.into(), why: why.to_string() }
}

fn embedded_paths(dir: &Dir<'_>, paths: &mut BTreeSet<String>) {
    for file in dir.files() {
        paths.extend(file.path().to_str().map(|path| path.replace('\\', "/")));
    }
    for inner in dir.dirs() {
        embedded_paths(inner, paths);
    }
}

/// The names of the built-in presets, sorted.
pub fn preset_names() -> Vec<&'static str> {
    let mut names: Vec<_> = PRESETS
        .files()
        .filter(|file| file.path().extension().is_some_and(|extension| extension == "json"))
        .filter_map(|file| file.path().file_stem()?.to_str())
        .collect();
    names.sort_unstable();
    names
}

/// The text of the built-in preset `name`.
pub(crate) fn preset_text(name: &str) -> Option<&'static str> {
    PRESETS.get_file(format!("{name}.json"))?.contents_utf8()
}

/// The text of the built-in template `name`.
pub(crate) fn template_text(name: &str) -> Option<&'static str> {
    TEMPLATES.get_file(name)?.contents_utf8()
}
