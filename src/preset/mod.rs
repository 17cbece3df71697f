//! Presets: reading them, extending one by another, holding them against what the scene declares.

mod error;
mod json;
pub mod listing;
mod read;
mod settle;

pub use error::{PresetError, PresetErrorKind};
pub use read::Preset;
pub(crate) use read::Scene;
pub use settle::{Declarations, Declared, Knob, Settings, settle};
