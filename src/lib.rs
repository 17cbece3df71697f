//! Composes WGSL shader fragments for natural environments, bakes a preset in, proves the result valid, hands it over.
//!
//! ```
//! let library = orogen::Library::standard();
//! let preset = orogen::Preset::named("alpine")?;
//! let shader = orogen::compose(&library, &preset, &orogen::Bake::live(["sun.*"]))?;
//! assert!(shader.wgsl().contains("fn terrain_height"));
//! assert_eq!(shader.uniform_bytes(&preset)?.len(), shader.interface().uniform.as_ref().map_or(0, |u| u.size as usize));
//! # Ok::<(), orogen::Error>(())
//! ```
//!
//! Data flows one way through the modules: [`source`] → [`syntax`] → [`preset`] → [`compose`](mod@compose) → [`bake`] →
//! [`check`] → [`export`] and [`render`]. Most hosts need only what stands at the crate's root.

pub mod bake;
pub mod build;
#[cfg(feature = "check")]
pub mod check;
pub mod compose;
pub mod diagnostic;
pub mod export;
mod module;
mod ordered;
pub mod preset;
#[cfg(feature = "render")]
pub mod render;
mod shader;
pub mod source;
pub mod syntax;
mod template;
#[cfg(feature = "watch")]
pub mod watch;

pub use bake::{Bake, Interface};
pub use compose::Prefix;
pub use diagnostic::{Diagnostic, Error};
pub use module::Module;
pub use preset::Preset;
#[cfg(feature = "render")]
pub use render::sample;
pub use shader::{Compose, Shader, compose};
pub use source::{Library, Templates};

/// The README's snippets, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
