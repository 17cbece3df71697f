//! Pictures and numbers from a GPU: [`Shader`](crate::Shader) → [`Picture`] → PNG, JPEG or EXR, and one expression over many
//! points → [`Table`](sample::Table).
//!
//! Headless: nothing here opens a window. Every call waits for the GPU, runs on a thread of its own with a deep stack, and
//! gives back what wgpu has to say as an [`Error`](crate::Error).
//!
//! ```no_run
//! use orogen::render::{Format, Gpu, Shot, encode, render};
//!
//! let preset = orogen::Preset::named("alpine")?;
//! let shader = orogen::compose(&orogen::Library::standard(), &preset, &orogen::Bake::constants())?;
//! let shot = Shot { samples: 8, ..Shot::new(960, 540) };
//! let picture = render(&Gpu::new(None)?, &shader, &preset, &shot, &mut |done, of| eprintln!("{done} of {of}"))?;
//! let file = encode(&picture, Format::of("alpine.png")?)?;
//! # Ok::<(), orogen::Error>(())
//! ```

mod adapter;
mod device;
mod draw;
mod encode;
mod error;
mod frame;
mod heightmap;
mod picture;
mod projection;
pub mod sample;

pub use adapter::Gpu;
pub use draw::{Progress, render};
pub use encode::{Format, encode, to_srgb8};
pub use error::{RenderError, is_no_adapter};
pub use frame::{Shot, jitter, set_frame};
pub use heightmap::{
    HeightFormat, Heightmap, HeightmapError, MOST_PIXELS, Range, Tile, encode_heights, heightmap,
    heights_about,
};
pub use picture::{Picture, srgb_decode, srgb_encode};
pub use projection::{FACES, Projection, faces};
