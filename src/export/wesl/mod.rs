//! A WESL package: [`Shader`] → [`Package`], a folder with one module for each fragment that is in.
//!
//! Folders become paths (`sky/atmosphere.wgsl` is the module `sky::atmosphere`), an instance is a module below its fragment's
//! (`fractal::fbm::relief`). Modules import by name exactly what they use, by paths relative to themselves, so that the folder
//! may lie anywhere. Parameters, options and open slots are declarations of the module `parameters`.

mod imports;
mod library;
mod paths;

use std::fmt::Write;

use rustc_hash::FxHashMap;

use crate::bake::{Baked, Facts, apart, directive_text};
use crate::compose::Part;
use crate::diagnostic::Error;
use crate::shader::Shader;
use crate::source::Templates;
use crate::template;
use imports::{Names, names, with_imports};
pub use library::{LibraryStyle, library_features, library_package};
use paths::Paths;

/// The module of parameters, options and open slots.
const PARAMETERS: &str = "parameters";

/// The module of the entry point that Orogen gives to a scene.
const MAIN: &str = "main";

/// What the first line of a package's `wesl.toml` starts with.
const MARK: &str = "# Written by Orogen";

/// A folder of files.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Package {
    /// Each file's path inside the folder, with `/`, and its text.
    pub files: Vec<(String, String)>,
    /// The module to compile, as a path inside the package: `main`, or the fragment that the composition started from.
    pub root: String,
}

impl Package {
    /// The text of the file at `path`.
    pub fn file(&self, path: &str) -> Option<&str> {
        self.files.iter().find(|(known, _)| known == path).map(|(_, text)| text.as_str())
    }

    /// The paths of the modules, without the extension.
    pub fn modules(&self) -> impl Iterator<Item = &str> {
        self.files.iter().filter_map(|(path, _)| path.strip_suffix(".wesl"))
    }

    /// The modules that the `wesl.toml` of an earlier package lists; none where Orogen has not written it.
    pub fn listed(wesl_toml: &str) -> Option<Vec<String>> {
        let lines = wesl_toml.starts_with(MARK).then(|| wesl_toml.lines())?;
        let listed =
            lines.filter_map(|line| line.trim().strip_prefix('"')?.strip_suffix("\",")).map(str::to_owned);
        Some(listed.collect())
    }
}

/// A module while it is being made.
struct Module {
    path: Vec<String>,
    text: String,
}

/// The package of `shader`, whose options and slots are decided.
///
/// # Errors
/// Where a template cannot be rendered.
pub fn package(shader: &Shader, templates: &Templates) -> Result<Package, Error> {
    let baked = shader.baked();
    let composition = &baked.composition;
    let (parameters, parts) = apart(baked, templates)?;
    let mut paths = Paths::default();
    let mut modules = vec![Module { path: paths.take(&[PARAMETERS]), text: parameters }];
    let directives: Vec<_> = composition.hoisted.iter().map(directive_text).collect();
    for (part, text) in composition.parts.iter().zip(parts) {
        modules.push(Module { path: module_path(&mut paths, part), text });
    }
    let root = modules.last().map_or_else(String::new, |module| module.path.join("/"));
    let files = linked(modules, &directives);
    let has_parameters = composition.parameters.iter().any(|parameter| parameter.read);
    let readme = Readme { about: About::of(baked, &root), has_parameters };
    let readme = template::render(templates, "wesl_readme.jinja", readme)?;
    Ok(finished(files, root, readme))
}

/// Where the module of `part` lies.
fn module_path(paths: &mut Paths, part: &Part) -> Vec<String> {
    if part.path.starts_with("templates/") {
        return paths.take(&[MAIN]);
    }
    let file = part.path.strip_suffix(".wgsl").unwrap_or(&part.path);
    let instance = Some(&*part.prefix).filter(|prefix| !prefix.is_empty());
    paths.take(&file.split('/').chain(instance).collect::<Vec<_>>())
}

/// The modules' files: each with the imports of what others declare and it uses. What nothing is declared in is left out.
fn linked(modules: Vec<Module>, directives: &[String]) -> Vec<(String, String)> {
    let named: Vec<Names> = modules.iter().map(|module| names(&module.text)).collect();
    let mut declared_in: FxHashMap<&str, usize> = FxHashMap::default();
    for (index, names) in named.iter().enumerate() {
        declared_in.extend(names.declared.iter().map(|name| (name.as_str(), index)));
    }
    let is_in = |names: &Names| !names.declared.is_empty() || names.asserts;
    let in_order = modules.iter().zip(&named).enumerate().filter(|(_, (_, names))| is_in(names));
    let file = |(index, (module, names)): (usize, (&Module, &Names))| {
        let mut from: Vec<(usize, Vec<&str>)> = Vec::new();
        for name in &names.used {
            let Some(owner) = declared_in.get(name.as_str()).copied().filter(|owner| *owner != index) else {
                continue;
            };
            match from.iter_mut().find(|(known, _)| *known == owner) {
                Some((_, names)) => names.push(name),
                None => from.push((owner, vec![name])),
            }
        }
        let mut lines: Vec<_> = from
            .into_iter()
            .map(|(owner, names)| imports::line(&paths::relative(&module.path, &modules[owner].path), names))
            .collect();
        lines.sort();
        if !names.has_directives {
            lines.extend(directives.iter().cloned());
        }
        (format!("{}.wesl", module.path.join("/")), with_imports(&module.text, &lines))
    };
    in_order.map(file).collect()
}

/// The package with its `wesl.toml` and its README.
fn finished(mut files: Vec<(String, String)>, root: String, readme: String) -> Package {
    let mut toml =
        format!("{MARK} {}. Exporting again overwrites what is listed here.\n", env!("CARGO_PKG_VERSION"));
    toml.push_str("edition = \"2026_pre\"\nroot = \".\"\ninclude = [\n");
    files.sort();
    for (path, _) in &files {
        let _ = writeln!(toml, "    \"{path}\","); // writing to a String cannot fail
    }
    toml.push_str("]\n");
    files.insert(0, ("README.md".into(), readme));
    files.insert(1, ("wesl.toml".into(), toml));
    Package { files, root }
}

/// What both READMEs are told.
#[derive(serde::Serialize)]
struct About {
    #[serde(flatten)]
    facts: Facts,
    /// `main`, or nothing.
    root: String,
    /// Group and binding of the buffer of live parameters, if there is one.
    uniform: Option<(u32, u32)>,
}

impl About {
    fn of(baked: &Baked, root: &str) -> Self {
        let uniform = baked.interface.uniform.as_ref();
        Self {
            facts: Facts::of(&baked.composition),
            root: root.replace('/', "::"),
            uniform: uniform.map(|uniform| (uniform.group, uniform.binding)),
        }
    }
}

/// What `wesl_readme.jinja` is told.
#[derive(serde::Serialize)]
struct Readme {
    #[serde(flatten)]
    about: About,
    has_parameters: bool,
}
