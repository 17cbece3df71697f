//! The files that a shader is made of are not what it is written to.

use std::path::Path;

use orogen::Shader;

use super::failure::{Failure, Outcome};

/// Refuses `output` where it is a file that `shader` was read from.
pub(super) fn spare(shader: &Shader, output: &Path) -> Outcome {
    let Ok(target) = output.canonicalize() else { return Ok(()) }; // what is not there yet is nobody's source
    let files = &shader.checked().baked.composition.files;
    // The library's own fragments have names like paths, too: only a file of the same text was read.
    let is_source = files.iter().any(|(_, file)| {
        Path::new(&*file.name).canonicalize().is_ok_and(|source| source == target)
            && std::fs::read(&target).is_ok_and(|bytes| without_mark(&bytes) == file.text.as_bytes())
    });
    if is_source {
        let shown = output.display();
        let why = format!("`{shown}` is one of the files that the shader is made of; nothing was written");
        return Err(Failure::System(why));
    }
    Ok(())
}

/// A byte order mark is left out when a file is read.
fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}
