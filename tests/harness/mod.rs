//! Turns a folder of cases into named tests.
//!
//! A case is a folder. Its `.wgsl` files are the library, in memory and by their paths in the folder; `input.wgsl` is the
//! scene, or `preset.json` names one. What is different from the defaults is said in `settings.txt`, a `key: value` a line:
//!
//! ```text
//! live: sun.*, quality          parameters that stay live
//! overrides: *                  parameters that become pipeline overrides
//! set: terrain.basis=simplex    as `--set`; may repeat
//! keep_unused: true
//! variables: true               live parameters are module-scope variables
//! library: standard             Orogen's own fragments lie below those of the case
//! root: text                    `input.wgsl` is a text of the host's, in no folder
//! preset: alpine                a built-in preset
//! module: lib.wgsl              a fragment in the scene's place, on its own
//! only: f, g                    of the root's declarations, these
//! prefix: og_                   what all names start with
//! view: steps                   a debug view in the scene's place: the library's `inspect/steps.wgsl`
//! ```
//!
//! A folder `overlay/` is laid over the library, a folder `templates/` over Orogen's templates. With `UPDATE=1` in the
//! environment the expectations are written anew; read the change before you commit it.

#![allow(dead_code, reason = "each test binary uses its part")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

pub(crate) mod corpus;
pub(crate) mod glsl;

use std::fs;
use std::path::{Path, PathBuf};

use orogen::{Bake, Compose, Error, Library, Prefix, Preset, Shader, Templates};
use similar::TextDiff;

/// Every case under `tests/<folder>`, sorted.
pub(crate) fn cases(folder: &str) -> Vec<Case> {
    let root = Path::new("tests").join(folder);
    let mut names: Vec<_> = fs::read_dir(&root)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_dir() && path.file_name().unwrap() != "templates")
        .collect();
    names.sort();
    names.into_iter().map(|path| Case { path }).collect()
}

/// One folder.
pub(crate) struct Case {
    /// Relative to the package.
    pub(crate) path: PathBuf,
}

impl Case {
    /// Its sentence.
    pub(crate) fn name(&self) -> String {
        self.path.file_name().unwrap().to_str().unwrap().replace('-', "_")
    }

    /// The values of `key` in `settings.txt`.
    pub(crate) fn setting(&self, key: &str) -> Vec<String> {
        let text = fs::read_to_string(self.path.join("settings.txt")).unwrap_or_default();
        let pairs = text.lines().filter_map(|line| line.split_once(':'));
        pairs.filter(|(name, _)| name.trim() == key).map(|(_, value)| value.trim().to_owned()).collect()
    }

    fn list(&self, key: &str) -> Vec<String> {
        let values = self.setting(key);
        values.iter().flat_map(|value| value.split(',')).map(|item| item.trim().to_owned()).collect()
    }

    fn is(&self, key: &str) -> bool {
        self.setting(key) == ["true"]
    }

    /// The fragments of the case.
    pub(crate) fn library(&self) -> Library {
        let standard = self.setting("library") == ["standard"];
        let mut library = if standard { Library::standard() } else { Library::empty() };
        let mut files = Vec::new();
        walk(&self.path, "", &mut files);
        for inside in files {
            let text = String::from_utf8(fs::read(self.path.join(&inside)).unwrap()).unwrap();
            library = library.with_file(inside, text);
        }
        let overlay = self.path.join("overlay");
        if overlay.is_dir() {
            library = library.with_folder(overlay).unwrap();
        }
        library
    }

    fn preset(&self) -> Result<Preset, Error> {
        let json = self.path.join("preset.json");
        let mut preset = if let [name] = self.setting("preset").as_slice() {
            Preset::named(name)?
        } else if json.exists() {
            Preset::file(json)?
        } else if self.setting("root") == ["text"] {
            Preset::of_text("input.wgsl", &fs::read_to_string(self.path.join("input.wgsl")).unwrap())
        } else {
            Preset::of_module("input.wgsl")
        };
        for assignment in self.setting("set") {
            preset.set(&assignment)?;
        }
        Ok(preset)
    }

    fn bake(&self) -> Bake {
        let bake = Bake::live(self.list("live")).with_overrides(self.list("overrides"));
        if self.is("variables") { bake.as_variables() } else { bake }
    }

    /// Composes the case, with `templates` or the folder of its own.
    pub(crate) fn compose(&self, templates: Option<&Path>) -> Result<Shader, Error> {
        self.compose_with(&self.library(), templates)
    }

    /// Composes the case out of `library`.
    pub(crate) fn compose_with(&self, library: &Library, templates: Option<&Path>) -> Result<Shader, Error> {
        let own = self.path.join("templates");
        let folder = if own.is_dir() { Some(own.as_path()) } else { templates };
        let templates = folder.map_or(Templates::standard(), |at| Templates::with_folder(at).unwrap());
        let keep_unused = self.is("keep_unused");
        let mut compose = Compose::default();
        (compose.keep_unused, compose.templates) = (keep_unused, templates);
        compose.view = self.setting("view").first().cloned();
        compose.module = self.setting("module").first().cloned();
        compose.only = self.list("only");
        compose.prefix = Prefix::new(self.setting("prefix").first().map_or("", String::as_str))?;
        compose.run(library, &self.preset()?, &self.bake())
    }

    /// Holds `text` against the file `name` of the case.
    pub(crate) fn expect(&self, name: &str, text: &str) -> Result<(), String> {
        expect(&self.path.join(name), text)
    }
}

/// Holds `text` against the file at `path`.
pub(crate) fn expect(path: &Path, text: &str) -> Result<(), String> {
    let known = fs::read_to_string(path).ok();
    if known.as_deref() == Some(text) {
        return Ok(());
    }
    if std::env::var_os("UPDATE").is_some_and(|value| value == "1") {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
        return Ok(());
    }
    let shown = path.display();
    let Some(known) = known else { return Err(format!("{shown} is missing; UPDATE=1 writes it:\n{text}")) };
    let diff = TextDiff::from_lines(known.as_str(), text);
    let diff = diff.unified_diff().context_radius(3).header("expected", "found").to_string();
    Err(format!("{shown} differs; UPDATE=1 writes it anew:\n{diff}"))
}

/// The `.wgsl` files of a case, but its expectation and its overlay.
fn walk(root: &Path, inside: &str, files: &mut Vec<String>) {
    for entry in fs::read_dir(root.join(inside)).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let path = if inside.is_empty() { name.clone() } else { format!("{inside}/{name}") };
        if root.join(&path).is_dir() {
            if path != "overlay" && path != "templates" {
                walk(root, &path, files);
            }
        } else if name.ends_with(".wgsl") && path != "expected.wgsl" {
            files.push(path);
        }
    }
}
