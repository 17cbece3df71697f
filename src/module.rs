//! A fragment of the library on its own, for a host's shader: path + values → [`Shader`].

use crate::bake::Bake;
use crate::compose::Prefix;
use crate::diagnostic::Error;
use crate::preset::Preset;
use crate::shader::{Compose, Shader};
use crate::source::Library;

/// A fragment of the library that is to be composed on its own: WGSL to paste into any program.
///
/// ```
/// let air = orogen::Library::standard()
///     .module("sky/atmosphere.wgsl")
///     .with_prefix("og_")?                                        // collides with nothing
///     .with_bake(orogen::Bake::live(["sky.*"]).at_binding(2, 0))  // the parameters' buffer is yours to place
///     .compose()?;
/// assert!(air.wgsl().contains("fn og_atmosphere_transmittance"));
/// assert!(air.wgsl().contains("@group(2) @binding(0) var<uniform> og_orogen"));
/// # Ok::<(), orogen::Error>(())
/// ```
pub struct Module {
    library: Library,
    path: String,
    preset: Preset,
    bake: Bake,
    compose: Compose,
}

impl Library {
    /// The fragment at `path`, with all that it reads and nothing else, and the defaults of its parameters.
    ///
    /// Whether there is one is told by [`Module::compose`].
    pub fn module(&self, path: &str) -> Module {
        Module {
            library: self.clone(),
            path: path.to_owned(),
            preset: Preset::of_module(path),
            bake: Bake::constants(),
            compose: Compose::default(),
        }
    }
}

impl Module {
    /// What every name of module scope starts with: functions, types, constants, parameters.
    ///
    /// # Errors
    /// Where no name can start with it.
    pub fn with_prefix(mut self, prefix: &str) -> Result<Self, Error> {
        self.compose.prefix = Prefix::new(prefix)?;
        Ok(self)
    }

    /// Which parameters stay live or become overrides, and where the uniform buffer is bound. By default all are constants.
    #[must_use]
    pub fn with_bake(mut self, bake: Bake) -> Self {
        self.bake = bake;
        self
    }

    /// The values of `preset`, as far as the fragment reads them: the land of `alpine`.
    #[must_use]
    pub fn with_preset(mut self, preset: Preset) -> Self {
        self.compose.module = Some(self.path.clone());
        self.preset = preset;
        self
    }

    /// Sets `group.name=value` over that.
    ///
    /// # Errors
    /// As [`Preset::set`].
    pub fn set(mut self, assignment: &str) -> Result<Self, Error> {
        self.preset.set(assignment)?;
        Ok(self)
    }

    /// Only these declarations of the fragment, and what they reach.
    #[must_use]
    pub fn only(mut self, names: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.compose.only = names.into_iter().map(Into::into).collect();
        self
    }

    /// Composes it, and checks it (feature `check`).
    ///
    /// # Errors
    /// As [`compose`](crate::compose()), and where there is no such fragment.
    pub fn compose(mut self) -> Result<Shader, Error> {
        self.compose.run(&self.library, &self.preset, &self.bake)
    }
}
