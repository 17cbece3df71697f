//! How much of the world a picture shows: [`Projection`] → the camera's option, a size, and the six faces of a cube.

use super::error::RenderError;
use super::frame::Shot;
use super::picture::Picture;
use crate::diagnostic::Error;
use crate::preset::{Declarations, Knob, Preset};
use crate::shader::Shader;
use crate::syntax::{OptionKind, OptionValue};

const OPTION: &str = "camera.projection";

/// What the option `camera.projection` of the library's camera can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Projection {
    /// What is ahead, as a lens shows it.
    #[default]
    Perspective,
    /// Everything around, twice as wide as high.
    Equirectangular,
    /// Everything around, on the six faces of a cube, one below the other: [`faces`] takes them apart.
    Cube,
}

/// How the six faces of a cube texture are called, in the order of its layers: +X −X +Y −Y +Z −Z.
pub const FACES: [&str; 6] = ["px", "nx", "py", "ny", "pz", "nz"];

impl Projection {
    /// All of them, in the order of the option's choices.
    pub const ALL: [Self; 3] = [Self::Perspective, Self::Equirectangular, Self::Cube];

    /// As the option has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Perspective => "perspective",
            Self::Equirectangular => "equirectangular",
            Self::Cube => "cube",
        }
    }

    /// The one that `shader` was composed with; perspective where its scene has no such option.
    pub fn of(shader: &Shader) -> Self {
        let options = &shader.checked().baked.composition.options;
        let found = options.iter().find(|option| option.decl.key.to_string() == OPTION);
        let chosen = found.and_then(|option| match (&option.decl.kind, option.value) {
            (OptionKind::Choice(choices), OptionValue::Choice(index)) => choices.get(index),
            _ => None,
        });
        let named = |name: &String| Self::ALL.into_iter().find(|one| one.name() == name);
        chosen.and_then(named).unwrap_or_default()
    }

    /// Sets the option in `preset`, whose scene has `declarations`.
    ///
    /// # Errors
    /// Where the scene has no such option.
    pub fn set(self, preset: &mut Preset, declarations: &Declarations) -> Result<(), Error> {
        match declarations.find(OPTION) {
            Some(Knob::Option(_)) => preset.set(&format!("{OPTION}={}", self.name())),
            _ => Err(RenderError::Projection { name: self.name() }.into()),
        }
    }

    /// The picture's size where nothing else is said; of a cube, the size of a face. Pictures of everything around have the
    /// same resolution, and two to three times the pixels.
    pub fn default_size(self) -> (u32, u32) {
        match self {
            Self::Perspective => (960, 540),
            Self::Equirectangular => (2048, 1024),
            Self::Cube => (512, 512),
        }
    }

    /// `shot`, of `width` × `height` pixels; of a cube, six faces of that size below each other.
    ///
    /// # Errors
    /// Where a cube's faces would not be square.
    pub fn shot(self, shot: Shot, width: u32, height: u32) -> Result<Shot, Error> {
        if self != Self::Cube {
            return Ok(Shot { width, height, ..shot });
        }
        if width != height {
            return Err(RenderError::Shot {
                why: "the faces of a cube are square",
                help: "give the size of one face, as in `--size 512x512`",
            }
            .into());
        }
        Ok(Shot { width, height: height.saturating_mul(FACES.len() as u32), ..shot })
    }
}

/// The faces of a cube, in the order of [`FACES`], out of the `picture` that has them below each other.
pub fn faces(picture: &Picture) -> [Picture; 6] {
    let height = picture.height / FACES.len() as u32;
    let pixels = picture.width as usize * height as usize;
    std::array::from_fn(|face| Picture {
        width: picture.width,
        height,
        pixels: picture.pixels[face * pixels..(face + 1) * pixels].to_vec(),
    })
}
