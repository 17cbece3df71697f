//! What can be wrong with a heightmap that is asked for, and how each is told.

use crate::diagnostic::{Diagnostic, Error};

/// A fault of a heightmap's preset, tile, range or file.
#[derive(Debug, Clone, thiserror::Error)]
pub enum HeightmapError {
    /// `OR0930`
    #[error("the scene of `{preset}` has no land: it declares no `terrain.relief`")]
    NoLand {
        /// The preset.
        preset: String,
    },
    /// `OR0931`
    #[error("{why}")]
    Tile {
        /// What is wrong with it.
        why: String,
        /// What to do.
        help: &'static str,
    },
    /// `OR0932`
    #[error(
        "{at} m from the world's origin, f32 tells places {digit} m apart: too coarse for samples every {spacing} m"
    )]
    TooFar {
        /// How far out the tile reaches (m).
        at: f32,
        /// From one f32 to the next, there (m).
        digit: f32,
        /// From one sample to the next (m).
        spacing: f64,
    },
    /// `OR0933`
    #[error("heights from {low} m to {high} m are no range")]
    Range {
        /// The height of 0 (m).
        low: f32,
        /// The height of 65,535 (m).
        high: f32,
    },
    /// `OR0934`
    #[error("the land of `{preset}` has no lowest and no highest place that is known beforehand")]
    NoBounds {
        /// The preset.
        preset: String,
    },
    /// `OR0935`
    #[error("`{file}` does not say which format the heights shall have")]
    Format {
        /// The file.
        file: String,
    },
}

impl From<HeightmapError> for Error {
    fn from(error: HeightmapError) -> Self {
        use HeightmapError as E;
        let message = error.to_string();
        let d = |code, help: &str| Diagnostic::error(code, message.clone()).help(Some(help.to_owned()));
        Self::bare(match error {
            E::NoLand { .. } => d(
                "OR0930",
                "choose a preset with land, such as alpine; `orogen eval` gives the values of any function over points",
            ),
            E::Tile { help, .. } => d("OR0931", help),
            E::TooFar { .. } => d("OR0932", "take fewer samples, or a tile nearer to the origin"),
            E::Range { .. } => d("OR0933", "give the lower height first, as in `--range -200,3000`"),
            E::NoBounds { .. } => d(
                "OR0934",
                "give the heights of black and white with `--range LOW,HIGH`, the same for all tiles; EXR needs none",
            ),
            E::Format { .. } => d(
                "OR0935",
                "end its name in `.png` or `.r16` (16 bits over a range), or in `.exr` (metres, 32-bit float)",
            ),
        })
    }
}
