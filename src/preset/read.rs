//! Preset files: JSON → [`Preset`], with what it extends below it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::error::{PresetError, PresetErrorKind};
use super::json::{self, Json, JsonKind};
use crate::diagnostic::{Diagnostic, Error, choices, nearest};
use crate::source::{self, FileId, Files, Span};
use crate::syntax::{Key, Spanned};

/// How many presets may extend one another in a row.
const MAX_EXTENDS: usize = 64;

/// One `group.name` that a preset sets, not yet held against its declaration.
#[derive(Debug, Clone)]
pub(crate) struct Setting {
    pub(crate) key: Key,
    pub(crate) key_span: Span,
    pub(crate) value: Json,
    pub(crate) file: FileId,
    pub(crate) pointer: String,
}

/// Which fragment is the scene.
#[derive(Debug, Clone)]
pub(crate) enum Scene {
    /// A path counted from the library's root, or beside the preset that names it.
    Named { path: String, beside: Option<PathBuf>, file: FileId, span: Span },
    /// A file of the user's.
    File(PathBuf),
    /// A text of the host's.
    Text { name: String, text: Arc<str> },
}

/// A scene and what is set in it. Values are held against the scene's declarations when it is composed.
#[derive(Debug, Clone)]
pub struct Preset {
    name: String,
    about: String,
    pub(crate) scene: Option<Scene>,
    /// The later one wins.
    pub(crate) settings: Vec<Setting>,
    pub(crate) files: Files,
}

impl Preset {
    /// The built-in preset `name`.
    ///
    /// # Errors
    /// Where there is none of that name.
    pub fn named(name: &str) -> Result<Self, Error> {
        let Some(text) = source::preset_text(name) else {
            let names = source::preset_names();
            let found = nearest(name, names.iter().copied());
            let diagnostic =
                Diagnostic::error("OR0513", format!("there is no built-in preset named `{name}`")).help(
                    found.map(|near| format!("did you mean `{near}`?")).or_else(|| {
                        Some(format!("choose {}, or give the path of a .json or .wgsl file", choices(names)))
                    }),
                );
            return Err(Error::bare(diagnostic));
        };
        Reader::default().read(name.into(), format!("presets/{name}.json"), text.into(), None)
    }

    /// The preset in the file at `path`.
    ///
    /// # Errors
    /// Where the file, or one that it extends, cannot be read or is no preset.
    pub fn file(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        let shown = path.display().to_string();
        let text = source::read_text(path, &shown)
            .map_err(|why| Error::bare(Diagnostic::error("OR0512", why.to_string())))?;
        let name = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or("preset").to_owned();
        Reader::default().read(name, shown, text, Some(path))
    }

    /// The preset in `text`, called `name` in errors. It can extend built-in presets only.
    ///
    /// # Errors
    /// Where `text` is no preset.
    pub fn parse(name: &str, text: &str) -> Result<Self, Error> {
        Reader::default().read(name.into(), name.into(), text.into(), None)
    }

    /// Nothing set: a scene, or any fragment, with the defaults of its parameters.
    pub fn of_file(path: impl Into<PathBuf>) -> Self {
        let path = path.into();
        let name = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or("scene").to_owned();
        Self::empty(name, Scene::File(path))
    }

    /// Nothing set: the library's fragment at `path`, with the defaults of its parameters.
    pub fn of_module(path: &str) -> Self {
        let mut files = Files::default();
        let file = files.add("command line", path);
        let span = Span::new(0, path.len());
        let name = path.rsplit('/').next().unwrap_or(path);
        let name = name.strip_suffix(".wgsl").unwrap_or(name);
        let mut preset =
            Self::empty(name.into(), Scene::Named { path: path.into(), beside: None, file, span });
        preset.files = files;
        preset
    }

    /// Nothing set: a fragment in memory, called `name` in errors, with the defaults of its parameters.
    pub fn of_text(name: &str, text: &str) -> Self {
        Self::empty(name.into(), Scene::Text { name: name.into(), text: text.into() })
    }

    fn empty(name: String, scene: Scene) -> Self {
        Self { name, about: String::new(), scene: Some(scene), settings: Vec::new(), files: Files::default() }
    }

    /// Its name: of the built-in preset, or of its file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// One line about it.
    pub fn about(&self) -> &str {
        &self.about
    }

    /// The same values for another scene: a fragment in memory.
    #[must_use]
    pub fn with_scene_text(mut self, name: &str, text: &str) -> Self {
        self.scene = Some(Scene::Text { name: name.into(), text: text.into() });
        self
    }

    /// Sets `group.name=value`, as `--set` does: over the preset's own value, and in the place of what was set before. The
    /// value is JSON, or a word, or numbers with commas between.
    ///
    /// # Errors
    /// Where `assignment` has no `=`, or no name before it.
    pub fn set(&mut self, assignment: &str) -> Result<(), Error> {
        let wrong = |span: Span, why: &str| {
            let mut files = self.files.clone();
            let file = files.add("--set", assignment);
            let diagnostic = Diagnostic::error("OR0514", why)
                .at(file, span, "in this setting")
                .help(Some("write `--set group.name=value`, as in `--set sun.azimuth=215`".into()));
            Err(Error::new(vec![diagnostic], files))
        };
        let whole = Span::new(0, assignment.len());
        let Some((name, value)) = assignment.split_once('=') else {
            return wrong(whole, "there is no `=`");
        };
        let (group, own) = name.trim().rsplit_once('.').unwrap_or(("", name.trim()));
        if own.is_empty() {
            return wrong(whole, "there is no name before the `=`");
        }
        if value.trim().is_empty() {
            return wrong(whole, "there is no value after the `=`");
        }
        let start = name.len() + 1;
        let span = Span::new(start, assignment.len());
        let kind = match json::parse(value) {
            Ok(value) => value.kind,
            Err(_) => match json::parse(&format!("[{value}]")) {
                Ok(list) => list.kind,
                Err(_) => JsonKind::String(value.trim().to_owned()),
            },
        };
        let key = Key { group: group.into(), name: own.into() };
        let (key_span, value) = (Span::new(0, name.len()), Json { kind: flat_spans(kind, span), span });
        // What was set in this way before is replaced: a host may turn a parameter every frame.
        let known = self.settings.iter_mut().find(|known| known.pointer.is_empty() && known.key == key);
        if let Some(known) = known {
            self.files.replace(known.file, assignment);
            *known = Setting { key_span, value, ..known.clone() };
            return Ok(());
        }
        let file = self.files.add("--set", assignment);
        self.settings.push(Setting { key, key_span, value, file, pointer: String::new() });
        Ok(())
    }
}

/// Everything inside of a `--set` points at its whole value.
fn flat_spans(kind: JsonKind, span: Span) -> JsonKind {
    match kind {
        JsonKind::Array(items) => JsonKind::Array(
            items.into_iter().map(|item| Json { kind: flat_spans(item.kind, span), span }).collect(),
        ),
        JsonKind::Object(pairs) => JsonKind::Object(
            pairs
                .into_iter()
                .map(|(key, value)| {
                    (Spanned { value: key.value, span }, Json { kind: flat_spans(value.kind, span), span })
                })
                .collect(),
        ),
        other => other,
    }
}

#[derive(Default)]
struct Reader {
    files: Files,
    errors: Vec<PresetError>,
}

/// One file of a chain.
struct Level {
    about: Option<String>,
    scene: Option<Scene>,
    settings: Vec<Setting>,
    extends: Option<(String, FileId, Span)>,
}

impl Reader {
    fn read(
        mut self,
        name: String,
        shown: String,
        text: Arc<str>,
        path: Option<&Path>,
    ) -> Result<Preset, Error> {
        let mut levels = Vec::new();
        let mut chain = vec![identity(&name, path)];
        let own = path.and_then(|path| path.file_name()?.to_str()).unwrap_or(&name);
        let mut names = vec![own.to_owned()];
        let (mut shown, mut text, mut path) = (shown, text, path.map(Path::to_owned));
        loop {
            let level = self.level(&shown, text, path.as_deref());
            let extends = level.extends.clone();
            levels.push(level);
            let Some((base, file, span)) = extends else { break };
            let fault = |kind| PresetError { kind, file, span, pointer: "/extends".into() };
            match locate(&base, path.as_deref()) {
                Ok((base_shown, base_text, base_path)) => {
                    let id = identity(&base, base_path.as_deref());
                    names.push(base);
                    if !chain.contains(&id) && chain.len() >= MAX_EXTENDS {
                        let why = format!("presets extend one another more than {MAX_EXTENDS} deep");
                        self.errors.push(fault(PresetErrorKind::NotFound { why, help: None }));
                        break;
                    }
                    if chain.contains(&id) {
                        self.errors.push(fault(PresetErrorKind::Cycle { chain: names }));
                        break;
                    }
                    chain.push(id);
                    (shown, text, path) = (base_shown, base_text, base_path);
                }
                Err((why, help)) => {
                    self.errors.push(fault(PresetErrorKind::NotFound { why, help }));
                    break;
                }
            }
        }
        if !self.errors.is_empty() {
            let diagnostics = self.errors.into_iter().map(Into::into).collect();
            return Err(Error::new(diagnostics, self.files));
        }
        let mut preset =
            Preset { name, about: String::new(), scene: None, settings: Vec::new(), files: self.files };
        for level in levels.into_iter().rev() {
            preset.about = level.about.unwrap_or(preset.about);
            preset.scene = level.scene.or(preset.scene);
            preset.settings.extend(level.settings);
        }
        Ok(preset)
    }

    fn level(&mut self, shown: &str, text: Arc<str>, path: Option<&Path>) -> Level {
        let on_disk = path.and_then(source::real_path).map(Into::into);
        let file = self.files.add_read(shown, text.clone(), on_disk);
        let mut level = Level { about: None, scene: None, settings: Vec::new(), extends: None };
        let root = match json::parse(&text) {
            Ok(root) => root,
            Err(error) => {
                self.wrong(PresetErrorKind::Json(error.why), file, error.span, "");
                return level;
            }
        };
        let start = Span { start: root.span.start, end: root.span.start + 1 };
        let Some(pairs) = self.object(&root, file, "") else { return level };
        let mut version = false;
        for (key, value) in pairs {
            let pointer = format!("/{}", escape(&key.value));
            match key.value.as_str() {
                "$schema" => drop(self.string(value, file, &pointer)),
                "about" => level.about = self.string(value, file, &pointer),
                "extends" => {
                    level.extends = self.string(value, file, &pointer).map(|base| (base, file, value.span));
                }
                "scene" => {
                    level.scene = self.string(value, file, &pointer).map(|path_in| Scene::Named {
                        path: path_in,
                        beside: path.map(Path::to_owned),
                        file,
                        span: value.span,
                    });
                }
                "set" => self.settings(value, file, &mut level.settings),
                "orogen" => {
                    version = true;
                    match &value.kind {
                        JsonKind::Number(number) if number == "1" => {}
                        JsonKind::Number(number) => {
                            let found = number.clone();
                            self.wrong(PresetErrorKind::Version { found }, file, value.span, &pointer);
                        }
                        other => {
                            self.wrong_type("the number 1", other.describe(), file, value.span, &pointer)
                        }
                    }
                }
                other => {
                    const KEYS: [&str; 6] = ["orogen", "about", "extends", "scene", "set", "$schema"];
                    let kind = PresetErrorKind::Key { key: other.into(), nearest: nearest(other, KEYS) };
                    self.wrong(kind, file, key.span, &pointer);
                }
            }
        }
        if !version {
            self.wrong(PresetErrorKind::NoVersion, file, start, "");
        }
        level
    }

    fn settings(&mut self, value: &Json, file: FileId, settings: &mut Vec<Setting>) {
        let Some(groups) = self.object(value, file, "/set") else { return };
        for (key, value) in groups {
            let pointer = format!("/set/{}", escape(&key.value));
            if let JsonKind::Object(pairs) = &value.kind {
                self.undotted(key, file, &pointer);
                if pairs.is_empty() {
                    // Nothing is set; whether there is such a group is still asked.
                    settings.push(Setting {
                        key: Key { group: key.value.clone(), name: String::new() },
                        key_span: key.span,
                        value: value.clone(),
                        file,
                        pointer: pointer.clone(),
                    });
                }
                for (name, value) in self.object(value, file, &pointer).unwrap_or_default() {
                    self.undotted(name, file, &format!("{pointer}/{}", escape(&name.value)));
                    settings.push(Setting {
                        key: Key { group: key.value.clone(), name: name.value.clone() },
                        key_span: name.span,
                        value: value.clone(),
                        file,
                        pointer: format!("{pointer}/{}", escape(&name.value)),
                    });
                }
            } else {
                self.undotted(key, file, &pointer);
                settings.push(Setting {
                    key: Key { group: String::new(), name: key.value.clone() },
                    key_span: key.span,
                    value: value.clone(),
                    file,
                    pointer,
                });
            }
        }
    }

    /// `"sun.elevation"` would be a second spelling of `"sun": { "elevation": … }`.
    fn undotted(&mut self, key: &Spanned<String>, file: FileId, pointer: &str) {
        if key.value.contains('.') {
            self.wrong(PresetErrorKind::Dotted { key: key.value.clone() }, file, key.span, pointer);
        }
    }

    /// The pairs of an object, each key once.
    fn object<'a>(
        &mut self,
        value: &'a Json,
        file: FileId,
        pointer: &str,
    ) -> Option<Vec<&'a (Spanned<String>, Json)>> {
        let JsonKind::Object(pairs) = &value.kind else {
            self.wrong_type("an object", value.kind.describe(), file, value.span, pointer);
            return None;
        };
        let mut seen = std::collections::BTreeMap::new();
        let mut unique = Vec::with_capacity(pairs.len());
        for pair in pairs {
            if let Some(first) = seen.insert(pair.0.value.as_str(), pair.0.span) {
                let kind = PresetErrorKind::Twice { key: pair.0.value.clone(), first };
                self.wrong(kind, file, pair.0.span, &format!("{pointer}/{}", escape(&pair.0.value)));
            } else {
                unique.push(pair);
            }
        }
        Some(unique)
    }

    fn string(&mut self, value: &Json, file: FileId, pointer: &str) -> Option<String> {
        match &value.kind {
            JsonKind::String(text) => Some(text.clone()),
            other => {
                self.wrong_type("a string", other.describe(), file, value.span, pointer);
                None
            }
        }
    }

    fn wrong_type(&mut self, expected: &str, found: &str, file: FileId, span: Span, pointer: &str) {
        let kind = PresetErrorKind::Type { expected: expected.into(), found: found.into() };
        self.wrong(kind, file, span, pointer);
    }

    fn wrong(&mut self, kind: PresetErrorKind, file: FileId, span: Span, pointer: &str) {
        self.errors.push(PresetError { kind, file, span, pointer: pointer.into() });
    }
}

/// A key in a JSON pointer (RFC 6901).
fn escape(key: &str) -> String {
    key.replace('~', "~0").replace('/', "~1")
}

fn identity(name: &str, path: Option<&Path>) -> String {
    match path.and_then(source::real_path) {
        Some(real) => format!("file:{}", real.display()),
        None => format!("preset:{name}"),
    }
}

type Located = (String, Arc<str>, Option<PathBuf>);

/// What `"extends": base` names: a file beside the preset where it ends in `.json`, else a built-in preset.
fn locate(base: &str, from: Option<&Path>) -> Result<Located, (String, Option<String>)> {
    if base.ends_with(".json") {
        let Some(from) = from else {
            return Err((format!("`{base}` cannot be read from here"), None));
        };
        let folder = from.parent().unwrap_or(Path::new(""));
        let inside = source::join("", base).map_err(|why| (format!("`{base}`: {why}"), None))?;
        let found = source::Source::file_in(folder, &inside).map_err(|why| (why.to_string(), None))?;
        return Ok((found.name.to_string(), found.text, Some(folder.join(inside))));
    }
    match source::preset_text(base) {
        Some(text) => Ok((format!("presets/{base}.json"), text.into(), None)),
        None => {
            let names = source::preset_names();
            let near = nearest(base, names.iter().copied()).map(|near| format!("did you mean `{near}`?"));
            let all = format!("choose {}, or name a .json file beside this one", choices(names));
            Err((format!("there is no built-in preset named `{base}`"), near.or(Some(all))))
        }
    }
}
