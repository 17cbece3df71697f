//! For a host's `build.rs`: preset → a shader and the Rust that fits it, in files.
//!
//! ```no_run
//! // build.rs, with `orogen = { version = "0.1", default-features = false }` among the build-dependencies
//! use orogen::{Bake, Preset, build::Bindings};
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let bindings = Bindings::new(Preset::named("alpine")?).with_bake(Bake::live(["sun.*"]));
//!     let built = bindings.write_to(std::env::var("OUT_DIR")?, "alpine")?; // alpine.rs, with the WGSL in it
//!     print!("{}", built.cargo()); // build again when a file of yours changes
//!     Ok(())
//! }
//! ```
//!
//! and in the host, `mod alpine { include!(concat!(env!("OUT_DIR"), "/alpine.rs")); }`.

use std::path::{Path, PathBuf};

use crate::bake::Bake;
use crate::diagnostic::{Diagnostic, Error};
use crate::export::{RustStyle, Types, bindings};
use crate::preset::Preset;
use crate::shader::{Compose, Shader};
use crate::source::Library;

/// Rust bindings that are to be generated.
pub struct Bindings {
    library: Library,
    preset: Preset,
    bake: Bake,
    compose: Compose,
    style: RustStyle,
}

/// What was generated.
pub struct Built {
    /// The shader.
    pub shader: Shader,
    /// The Rust file's text.
    pub rust: String,
    /// The files on disk that it was made of.
    pub sources: Vec<PathBuf>,
}

impl Bindings {
    /// For the scene of `preset`, with all parameters constant.
    pub fn new(preset: Preset) -> Self {
        Self {
            library: Library::standard(),
            preset,
            bake: Bake::constants(),
            compose: Compose::default(),
            style: RustStyle::default(),
        }
    }

    /// With fragments of the host's own over the library.
    #[must_use]
    pub fn with_library(mut self, library: Library) -> Self {
        self.library = library;
        self
    }

    /// Which parameters are live, and where their buffer is bound.
    #[must_use]
    pub fn with_bake(mut self, bake: Bake) -> Self {
        self.bake = bake;
        self
    }

    /// With more of how to compose than a preset says: a prefix, a module of its own, a compute entry point.
    #[must_use]
    pub fn with_compose(mut self, compose: Compose) -> Self {
        self.compose = compose;
        self
    }

    /// `glam`'s vectors instead of arrays.
    #[must_use]
    pub fn with_types(mut self, types: Types) -> Self {
        self.style.types = types;
        self
    }

    /// Without the layouts of bind groups, for a host that does not use `wgpu`.
    #[must_use]
    pub fn without_layouts(mut self) -> Self {
        self.style.layouts = false;
        self
    }

    /// Composes the shader and writes the Rust for it, in memory.
    ///
    /// # Errors
    /// As [`compose`](crate::compose()).
    pub fn generate(mut self) -> Result<Built, Error> {
        let shader = self.compose.run(&self.library, &self.preset, &self.bake)?;
        let rust = bindings(&shader, &self.style, &self.compose.templates)?;
        let sources = shader.baked().composition.files.on_disk();
        Ok(Built { shader, rust, sources })
    }

    /// As [`Bindings::generate`], and writes `NAME.rs` into `folder`.
    ///
    /// # Errors
    /// As [`Bindings::generate`], and where the file cannot be written.
    pub fn write_to(self, folder: impl AsRef<Path>, name: &str) -> Result<Built, Error> {
        let built = self.generate()?;
        let path = folder.as_ref().join(format!("{name}.rs"));
        std::fs::write(&path, &built.rust).map_err(|why| {
            let message = format!("`{}` cannot be written: {why}", path.display());
            Error::bare(Diagnostic::error("OR0813", message))
        })?;
        Ok(built)
    }
}

impl Built {
    /// What a `build.rs` prints for cargo: build again when one of the sources changes.
    pub fn cargo(&self) -> String {
        let line = |path: &PathBuf| format!("cargo::rerun-if-changed={}\n", path.display());
        // Naming any file turns off cargo's habit of looking at all of them.
        "cargo::rerun-if-changed=build.rs\n".to_owned() + &self.sources.iter().map(line).collect::<String>()
    }
}
