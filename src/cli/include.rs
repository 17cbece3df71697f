//! `--include FILE`: a file on disk → a fragment of the library.

use std::path::Path;

use orogen::Library;

use super::failure::Failure;

/// Lays the folders of the files among `includes` over the library, so that their `"…"` includes are found as well, and
/// says each as `<file name>`. What is no file stays as it is.
pub(super) fn on_disk(mut library: Library, includes: &[String]) -> Result<(Library, Vec<String>), Failure> {
    let mut files = Vec::new();
    let mut told = Vec::new();
    for include in includes {
        let (path, clauses) = parts(include);
        if !path.is_file() {
            told.push(include.clone());
            continue;
        }
        let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
            return Err(Failure::System(format!("`{}`: its name is not UTF-8 text", path.display())));
        };
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        library = library.with_folder(folder).map_err(|why| Failure::System(why.to_string()))?;
        told.push(format!("<{name}>{clauses}"));
        files.push((path, name));
    }
    for (path, name) in files {
        see_found(&library, path, name)?;
    }
    Ok((library, told))
}

/// `mine.wgsl as rough with …` → `mine.wgsl` and the rest. A file whose name holds ` as ` is that file.
fn parts(include: &str) -> (&Path, &str) {
    let include = include.trim();
    let clauses = [" as ", " with "].iter().filter_map(|word| include.find(word)).min();
    match clauses {
        Some(at) if !Path::new(include).is_file() => (Path::new(&include[..at]), &include[at..]),
        _ => (Path::new(include), ""),
    }
}

/// The folder of another file may hold one of the same name.
fn see_found(library: &Library, path: &Path, name: &str) -> Result<(), Failure> {
    let found = library.find(name).map_err(|why| Failure::System(why.to_string()))?;
    let is_it = match (Path::new(&*found.name).canonicalize(), path.canonicalize()) {
        (Ok(found), Ok(path)) => found == path,
        _ => false,
    };
    if is_it {
        return Ok(());
    }
    let (path, other) = (path.display(), &found.name);
    Err(Failure::System(format!(
        "`{path}` is hidden by `{other}`, which has the same name: rename one of them"
    )))
}
