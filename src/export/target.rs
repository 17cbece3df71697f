//! What can be written, and how each wants the shader composed: name → [`Target`] → [`Stage`], [`Bake`].

#[cfg(feature = "check")]
use std::{fmt, str::FromStr};

#[cfg(feature = "check")]
use super::error::ExportError;
#[cfg(feature = "check")]
use crate::bake::Bake;

/// The stage of the entry point that a scene gets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Stage {
    /// A triangle over the whole target, and a fragment entry point.
    #[default]
    Fragment,
    /// A compute entry point that writes a storage texture.
    Compute,
    /// `main_image` itself is what the target calls. The origin of its pixels is at the bottom left, as in OpenGL.
    MainImage,
}

/// A kind of file.
#[cfg(feature = "check")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Target {
    /// The composed WGSL itself.
    #[default]
    Wgsl,
    /// One file to paste into Shadertoy's editor.
    Shadertoy,
    /// GLSL ES 3.00, as WebGL 2 compiles it: one fragment shader.
    Glsl,
    /// Interactive Shader Format: GLSL with a JSON header, whose inputs are the live parameters.
    Isf,
    /// WGSL for compute.toys' editor.
    ComputeToys,
    /// SPIR-V 1.3, as Vulkan 1.1 takes it, little-endian: all entry points.
    Spirv,
    /// HLSL for shader model 6.0: all entry points.
    Hlsl,
    /// Metal's language, version 2.1: all entry points.
    Msl,
    /// What a host needs to know of the shader.
    Json,
    /// Rust for the shader's host: its parameters as structs, with the WGSL in it.
    Rust,
    /// A WESL package: a folder with a module for each fragment. [`package`](super::package) writes it.
    Wesl,
}

#[cfg(feature = "check")]
impl Target {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Wgsl,
        Self::Shadertoy,
        Self::Glsl,
        Self::Isf,
        Self::ComputeToys,
        Self::Spirv,
        Self::Hlsl,
        Self::Msl,
        Self::Json,
        Self::Rust,
        Self::Wesl,
    ];

    /// Its name: `wgsl`, `shadertoy`, `glsl`, `isf`, `compute-toys`, `spirv`, `hlsl`, `msl`, `json`, `rust`, `wesl`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wgsl => "wgsl",
            Self::Shadertoy => "shadertoy",
            Self::Glsl => "glsl",
            Self::Isf => "isf",
            Self::ComputeToys => "compute-toys",
            Self::Spirv => "spirv",
            Self::Hlsl => "hlsl",
            Self::Msl => "msl",
            Self::Json => "json",
            Self::Rust => "rust",
            Self::Wesl => "wesl",
        }
    }

    /// What its files are called after the dot: `alpine.shadertoy.glsl`.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Wgsl => "wgsl",
            Self::Shadertoy => "shadertoy.glsl",
            Self::Glsl => "frag",
            Self::Isf => "fs",
            Self::ComputeToys => "compute.wgsl",
            Self::Spirv => "spv",
            Self::Hlsl => "hlsl",
            Self::Msl => "metal",
            Self::Json => "json",
            Self::Rust => "rs",
            Self::Wesl => "wesl",
        }
    }

    /// Which entry point a scene gets, for [`Compose::stage`](crate::Compose::stage); `requested` is the user's wish.
    ///
    /// GLSL, Shadertoy and their like call `main_image`, since their pixels count from the bottom left as its do.
    ///
    /// # Errors
    /// Where the target has no such stage.
    pub fn stage(self, requested: Option<Stage>) -> Result<Stage, crate::Error> {
        match (self, requested) {
            (Self::Glsl | Self::Shadertoy | Self::Isf, Some(Stage::Compute)) => {
                Err(ExportError::Stage { target: self }.into())
            }
            (Self::Glsl | Self::Shadertoy | Self::Isf | Self::ComputeToys, _) => Ok(Stage::MainImage),
            (_, requested) => Ok(requested.unwrap_or_default()),
        }
    }

    /// Whether its files can be minified: those that are text which others compile.
    pub fn is_minified(self) -> bool {
        matches!(self, Self::Wgsl | Self::Shadertoy | Self::Glsl)
    }

    /// Whether it is written as one file, by [`export`](super::export()): a WESL package is a folder.
    pub fn is_one_file(self) -> bool {
        self != Self::Wesl
    }

    /// How parameters are to be baked: on Shadertoy and its like, live ones are global variables, since no host sets uniforms
    /// there. In GLSL the group `frame` is uniforms of their own, beside the buffer of the live ones.
    #[must_use]
    pub fn bake(self, bake: Bake) -> Bake {
        match self {
            Self::Shadertoy | Self::Isf | Self::ComputeToys => bake.as_variables(),
            Self::Glsl => bake.with_frame_as_variables(),
            _ => bake,
        }
    }
}

#[cfg(feature = "check")]
impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(feature = "check")]
impl FromStr for Target {
    type Err = crate::Error;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let found = Self::ALL.into_iter().find(|target| target.name() == name);
        found.ok_or_else(|| ExportError::UnknownTarget { name: name.to_owned() }.into())
    }
}
