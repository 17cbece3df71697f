//! Text → GLSL ES 3.00, and what glslang says of it.

use std::path::{Path, PathBuf};
use std::process::Command;

use orogen::export::{Target, export};
use orogen::{Bake, Compose, Error, Library, Preset, Shader, Templates};

/// `text`, composed as the target `glsl` wants it.
pub(crate) fn composed(name: &str, text: &str) -> Result<Shader, Error> {
    let mut compose = Compose::default();
    compose.stage = Target::Glsl.stage(None)?;
    let bake = Target::Glsl.bake(Bake::default());
    compose.run(&Library::standard(), &Preset::of_text(name, text), &bake)
}

/// `shader` as a complete fragment shader.
pub(crate) fn emitted(shader: &Shader) -> Result<String, Error> {
    let bytes = export(shader, Target::Glsl, &Templates::standard())?;
    Ok(String::from_utf8(bytes).expect("GLSL is text"))
}

/// A new folder of this test's.
pub(crate) fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if path.exists() {
        std::fs::remove_dir_all(&path).expect("the test's folder can be emptied");
    }
    std::fs::create_dir_all(&path).expect("the test's folder can be made");
    path
}

/// What glslang has against the fragment shader at `path`.
pub(crate) fn glslang(path: &Path) -> Result<(), String> {
    let output = Command::new("glslangValidator").args(["-S", "frag"]).arg(path).output().map_err(|why| {
        format!("`glslangValidator` cannot be run ({why}): install glslang-tools, or run `cargo xtask test`")
    })?;
    if output.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&output.stdout);
    Err(format!("glslang refuses {}:\n{said}{}", path.display(), String::from_utf8_lossy(&output.stderr)))
}
