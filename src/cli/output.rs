//! Standard output, standard error, and files that are either whole or untouched.

use std::fs;
use std::io::{Error, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::failure::{Failure, Outcome};

/// Writes to standard output. Whoever reads it may have had enough: that is no failure.
pub(super) fn print(bytes: &[u8]) -> Outcome {
    let mut out = std::io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::System(format!("standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Writes to standard error, if anybody listens.
pub(super) fn complain(text: &str) {
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

/// Writes a file as a whole. `-` is standard output.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Outcome {
    prepare(path, bytes)?.persist()
}

/// What is to be written: all that can go wrong with it has been tried, as far as that goes without writing it.
pub(super) struct Draft<'a> {
    path: &'a Path,
    way: Way<'a>,
}

enum Way<'a> {
    /// A temporary file beside the target, which then takes its place.
    Replace(NamedTempFile, PathBuf),
    /// A device or a pipe cannot be replaced, nor can standard output.
    Stream(&'a [u8]),
}

/// Writes `bytes` to a temporary file beside `path`, which is left as it is.
pub(super) fn prepare<'a>(path: &'a Path, bytes: &'a [u8]) -> Result<Draft<'a>, Failure> {
    let way = if path == Path::new("-") { Ok(Way::Stream(bytes)) } else { way(path, bytes) };
    way.map(|way| Draft { path, way }).map_err(|error| fault(path, &error))
}

impl Draft<'_> {
    /// Puts it where it belongs.
    pub(super) fn persist(self) -> Outcome {
        let done = match self.way {
            Way::Replace(file, target) => file.persist(target).map(drop).map_err(Error::from),
            Way::Stream(bytes) if self.path == Path::new("-") => return print(bytes),
            Way::Stream(bytes) => fs::write(self.path, bytes),
        };
        done.map_err(|error| fault(self.path, &error))
    }
}

fn fault(path: &Path, error: &Error) -> Failure {
    Failure::System(format!("`{}` cannot be written: {error}", path.display()))
}

fn way<'a>(path: &Path, bytes: &'a [u8]) -> std::io::Result<Way<'a>> {
    let old = fs::metadata(path).ok();
    if old.as_ref().is_some_and(fs::Metadata::is_dir) {
        return Err(Error::other("it is a folder"));
    }
    if old.as_ref().is_some_and(|meta| !meta.is_file()) {
        return Ok(Way::Stream(bytes));
    }
    let target = followed(path)?;
    let mut file = beside(&target)?;
    file.as_file_mut().write_all(bytes)?; // not through `file`, whose errors tell the temporary name
    if let Some(meta) = old {
        file.as_file().set_permissions(meta.permissions())?;
    }
    file.as_file().sync_all()?;
    Ok(Way::Replace(file, target))
}

/// Where `path` leads: a link stays a link, also one to a file that is yet to be written.
fn followed(path: &Path) -> std::io::Result<PathBuf> {
    const MOST_LINKS: usize = 40; // as Linux has it
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&target) else { return Ok(target) };
        target = folder_of(&target).join(next); // an absolute one replaces all of it
    }
    Err(Error::other("its links lead in a circle"))
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// An empty temporary file in the folder of `target`.
fn beside(target: &Path) -> std::io::Result<NamedTempFile> {
    let folder = folder_of(target);
    let shown = folder.display();
    if !folder.exists() {
        return Err(Error::other(format!("the folder `{shown}` does not exist")));
    }
    if !folder.is_dir() {
        return Err(Error::other(format!("`{shown}` is not a folder")));
    }
    let mut builder = tempfile::Builder::new();
    builder.prefix(".orogen-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666)); // less the user's mask
    builder.tempfile_in(folder).map_err(|error| error.kind().into()) // the rest of it tells the temporary name
}
