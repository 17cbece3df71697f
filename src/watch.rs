//! Files being saved → the shader that is made of them, composed again.
//!
//! What is watched follows from what was read: the folders of the preset, of all that it extends and of every fragment on
//! disk, and the folders laid over the library. Folders and not files, so that editors may save as they like: in place, or by
//! writing a second file and renaming it. Nothing here runs by itself: a host asks from its own loop, or from a thread.
//!
//! ```no_run
//! use orogen::watch::{Recipe, Watch};
//! use std::time::Duration;
//!
//! let library = orogen::Library::standard().with_folder("shaders").map_err(|why| why.to_string())?;
//! let recipe = Recipe::file(library, orogen::Bake::live(["sun.*"]), "world.json");
//! std::thread::spawn(move || {
//!     let mut watch = Watch::new(recipe)?;
//!     while let Some(news) = watch.next(Duration::MAX) {
//!         match news {
//!             Ok(made) => println!("{} bytes of WGSL, {:?} after the save", made.shader.wgsl().len(), made.took),
//!             Err(error) => eprintln!("{error}"), // and the host goes on with what it has
//!         }
//!     }
//!     Ok::<(), orogen::Error>(())
//! });
//! # Ok::<(), String>(())
//! ```

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use notify::event::{AccessKind, AccessMode, CreateKind, EventKind};
use notify::{RecommendedWatcher, RecursiveMode, Watcher};

use crate::bake::Bake;
use crate::diagnostic::{Diagnostic, Error};
use crate::preset::Preset;
use crate::shader::{Compose, Shader};
use crate::source::{Files, Library, real_path};

/// So long after the last word about a save the file is taken to be whole: editors first empty it, then write it.
const QUIET: Duration = Duration::from_millis(8);
/// But no save keeps us longer.
const LONGEST: Duration = Duration::from_millis(48);

type ReadPreset = Box<dyn FnMut(&Library, &mut Compose) -> Result<Preset, Error> + Send>;

/// What is to be made of which files.
pub struct Recipe {
    /// The fragments. Folders that are laid over it are watched, with all below them.
    pub library: Library,
    /// Which parameters become what.
    pub bake: Bake,
    /// How to compose. What it has read once it reads again only after a change.
    pub compose: Compose,
    /// Files that are watched even while nothing can be read of them.
    pub files: Vec<PathBuf>,
    /// Reads the preset anew.
    preset: ReadPreset,
}

/// What was made.
pub struct Made {
    /// The preset, as it is now.
    pub preset: Preset,
    /// Its shader.
    pub shader: Shader,
    /// From the first word about the save to the shader, composed and checked.
    pub took: Duration,
}

/// Watches the files of a recipe.
pub struct Watch {
    recipe: Recipe,
    watcher: RecommendedWatcher,
    events: Receiver<notify::Result<notify::Event>>,
    /// Folders that are watched.
    folders: BTreeSet<PathBuf>,
    /// Files that were read.
    read: BTreeSet<PathBuf>,
    /// What the host was told last: a shader's text and uniform bytes, or an error.
    told: Option<Result<(String, Vec<u8>), String>>,
}

impl Recipe {
    /// Of the preset in a file (`.json`), or of a scene with the defaults of its parameters (`.wgsl`).
    pub fn file(library: Library, bake: Bake, path: impl Into<PathBuf>) -> Self {
        let path: PathBuf = path.into();
        let files = vec![path.clone()];
        let read = move |_: &Library, _: &mut Compose| {
            let is_scene = path.extension().is_some_and(|extension| extension == "wgsl");
            if is_scene { Ok(Preset::of_file(&path)) } else { Preset::file(&path) }
        };
        Self { files, ..Self::new(library, bake, read) }
    }

    /// Of whatever preset the host comes up with. `preset` is called after each save.
    pub fn new(
        library: Library,
        bake: Bake,
        preset: impl FnMut(&Library, &mut Compose) -> Result<Preset, Error> + Send + 'static,
    ) -> Self {
        Self { library, bake, compose: Compose::default(), files: Vec::new(), preset: Box::new(preset) }
    }

    fn make(&mut self) -> Result<(Preset, Shader), Error> {
        let preset = (self.preset)(&self.library, &mut self.compose)?;
        let shader = self.compose.run(&self.library, &preset, &self.bake)?;
        Ok((preset, shader))
    }
}

impl Watch {
    /// Begins to watch what `recipe` names by itself; what is read besides is found as it is read.
    ///
    /// # Errors
    /// Where the system cannot watch files, or not these.
    pub fn new(recipe: Recipe) -> Result<Self, Error> {
        let (sender, events) = channel();
        let watcher = notify::recommended_watcher(move |event| {
            let _ = sender.send(event); // nobody listens any more: the watch is being dropped
        })
        .map_err(|why| unwatched(None, &why))?;
        let (folders, read) = Default::default();
        let mut watch = Self { recipe, watcher, events, folders, read, told: None };
        for folder in watch.recipe.library.folders() {
            watch.folder(&folder, RecursiveMode::Recursive)?;
        }
        for file in watch.recipe.files.clone() {
            watch.file(&file)?;
        }
        Ok(watch)
    }

    /// The next news, within so much time: at first what there is, then what comes of each save. Waits; with no time at all it
    /// only looks.
    ///
    /// A save that changes nothing in the shader is no news. After an error the host keeps what it has, and hears of the
    /// repair, even where it leads back to what was before.
    pub fn next(&mut self, within: Duration) -> Option<Result<Made, Error>> {
        let start = Instant::now();
        if self.told.is_none() {
            return self.made(start);
        }
        loop {
            let saved = self.saved(within.saturating_sub(start.elapsed()))?;
            if let Some(news) = self.made(saved) {
                return Some(news);
            }
        }
    }

    /// Makes it; none where it is what the host has been told.
    fn made(&mut self, saved: Instant) -> Option<Result<Made, Error>> {
        let outcome = self.recipe.make().and_then(|(preset, shader)| {
            let bytes = shader.uniform_bytes(&preset)?;
            Ok((Made { preset, shader, took: saved.elapsed() }, bytes))
        });
        let now = match &outcome {
            Ok((made, bytes)) => Ok((made.shader.wgsl().to_owned(), bytes.clone())),
            Err(error) => Err(error.to_string()),
        };
        let watched = match &outcome {
            Ok((made, _)) => self.files(&made.shader.checked().baked.composition.files.clone()),
            Err(error) => self.files(error.files()),
        };
        if self.told.as_ref() == Some(&now) {
            return None;
        }
        self.told = Some(now);
        Some(watched.and_then(|()| outcome.map(|(made, _)| made)))
    }

    /// Waits for a save of something that was read, or that may be: when it was first heard of.
    fn saved(&mut self, within: Duration) -> Option<Instant> {
        let start = Instant::now();
        loop {
            let event = self.events.recv_timeout(within.saturating_sub(start.elapsed())).ok()?;
            if self.is_save(&event) {
                break;
            }
        }
        let heard = Instant::now();
        while heard.elapsed() < LONGEST && self.events.recv_timeout(QUIET).is_ok() {}
        Some(heard)
    }

    fn is_save(&self, event: &notify::Result<notify::Event>) -> bool {
        let Ok(event) = event else { return true }; // something was missed
        let is_change = match event.kind {
            EventKind::Access(kind) => kind == AccessKind::Close(AccessMode::Write), // not our own reading
            _ => true,
        };
        let is_ours = |path: &PathBuf| {
            let extension = path.extension().unwrap_or_default();
            extension == "wgsl" || extension == "json" || self.read.contains(path)
        };
        // What is in a new folder may have been there before its watch was.
        let is_folder = event.kind == EventKind::Create(CreateKind::Folder);
        event.need_rescan() || is_folder || is_change && event.paths.iter().any(is_ours)
    }

    fn files(&mut self, files: &Files) -> Result<(), Error> {
        let paths: Vec<PathBuf> =
            files.iter().filter_map(|(_, file)| Some(file.path.as_ref()?.to_path_buf())).collect();
        paths.iter().try_for_each(|path| self.file(path))
    }

    /// Watches the folder of a file; a file that is gone will be back.
    fn file(&mut self, path: &Path) -> Result<(), Error> {
        if let Some(real) = real_path(path) {
            if let Some(folder) = real.parent() {
                self.folder(folder, RecursiveMode::NonRecursive)?;
            }
            self.read.insert(real);
        }
        // Where it is a link, that may be made to lead elsewhere.
        let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        match real_path(parent) {
            Some(folder) => self.folder(&folder, RecursiveMode::NonRecursive),
            None => Ok(()),
        }
    }

    fn folder(&mut self, folder: &Path, mode: RecursiveMode) -> Result<(), Error> {
        if self.folders.contains(folder) {
            return Ok(());
        }
        self.watcher.watch(folder, mode).map_err(|why| unwatched(Some(folder), &why))?;
        self.folders.insert(folder.to_owned());
        Ok(())
    }
}

fn unwatched(folder: Option<&Path>, why: &notify::Error) -> Error {
    let what = folder.map_or("files".into(), |folder| format!("`{}`", folder.display()));
    let reason = match &why.kind {
        notify::ErrorKind::MaxFilesWatch => "the system watches as many files as it can already".to_owned(),
        notify::ErrorKind::Io(why) => why.to_string(),
        _ => why.to_string(),
    };
    let help = "on Linux `sysctl fs.inotify.max_user_watches` says how many; or do without, and compose again by hand";
    let diagnostic = Diagnostic::error("OR0940", format!("{what} cannot be watched: {reason}"));
    Error::bare(diagnostic.help(Some(help.to_owned())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_that_watches_no_more_is_told_as_such() {
        let error =
            unwatched(Some(Path::new("shaders")), &notify::Error::new(notify::ErrorKind::MaxFilesWatch));
        let expected = include_str!("../tests/faults/a-folder-cannot-be-watched.txt");
        assert_eq!(error.render(false), expected);
        let other = notify::Error::io(std::io::Error::other("no such device"));
        assert!(unwatched(None, &other).to_string().contains("files cannot be watched: no such device"));
    }
}
