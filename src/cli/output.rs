//! Standard output, standard error, and files that are either whole or untouched.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

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

/// Writes a file as a whole: to a temporary file beside it, which then takes its place. `-` is standard output.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Outcome {
    if path == Path::new("-") {
        return print(bytes);
    }
    replace(path, bytes)
        .map_err(|error| Failure::System(format!("`{}` cannot be written: {error}", path.display())))
}

fn replace(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let target = match fs::metadata(path) {
        Ok(meta) if meta.is_dir() => return Err(std::io::Error::other("it is a folder")),
        Ok(meta) if !meta.is_file() => return fs::write(path, bytes), // a device or a pipe cannot be replaced
        Ok(_) => path.canonicalize()?,                                // a link stays a link
        Err(_) => path.to_owned(),
    };
    let folder = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".orogen-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666)); // less the user's mask
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(target)?;
    Ok(())
}
