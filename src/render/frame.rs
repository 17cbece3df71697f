//! What the host tells a shader every frame: [`Shot`] → the `frame_*` fields of the uniform buffer.

use crate::bake::Uniform;

/// One picture to be taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shot {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// How many jittered frames are averaged; at least 1. A shader that does not read `frame.jitter` is drawn once.
    pub samples: u32,
    /// `frame.time`, in seconds.
    pub time: f32,
    /// `frame.delta`, in seconds; none leaves what the preset says.
    pub delta: Option<f32>,
    /// `frame.index`
    pub index: u32,
    /// `frame.mouse`, in pixels from the bottom left; none leaves what the preset says.
    pub mouse: Option<[f32; 4]>,
    /// The side of the squares that are drawn one submission each, so that each is short; none for what suits the adapter.
    pub tile: Option<u32>,
}

impl Shot {
    /// The picture at time 0, one sample a pixel.
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, samples: 1, time: 0.0, delta: None, index: 0, mouse: None, tile: None }
    }
}

/// Writes the fields of `frame` into the bytes of a uniform buffer, as far as it has them.
///
/// `bytes` are [`Shader::uniform_bytes`](crate::Shader::uniform_bytes), `uniform` their layout; `jitter` in pixels.
pub fn set_frame(bytes: &mut [u8], uniform: &Uniform, shot: &Shot, jitter: [f32; 2]) {
    let resolution = [shot.width as f32, shot.height as f32];
    let delta = shot.delta.map(f32::to_le_bytes);
    let mouse = shot.mouse.map(|mouse| mouse.map(f32::to_le_bytes));
    set(bytes, uniform, "frame.resolution", &pair(resolution));
    set(bytes, uniform, "frame.time", &shot.time.to_le_bytes());
    set(bytes, uniform, "frame.delta", delta.as_ref().map_or(&[], |bytes| bytes));
    set(bytes, uniform, "frame.index", &shot.index.to_le_bytes());
    set(bytes, uniform, "frame.mouse", mouse.as_ref().map_or(&[], |mouse| mouse.as_flattened()));
    set(bytes, uniform, "frame.jitter", &pair(jitter));
}

/// Whether the shader reads `frame.jitter`.
pub(super) fn has_jitter(uniform: Option<&Uniform>) -> bool {
    uniform.is_some_and(|uniform| uniform.fields.iter().any(|field| field.parameter == "frame.jitter"))
}

/// A field that a host's own fragment declares with another type is left as it is.
fn set(bytes: &mut [u8], uniform: &Uniform, parameter: &str, value: &[u8]) {
    let fits =
        |field: &&crate::bake::Field| field.parameter == parameter && field.size as usize == value.len();
    if let Some(field) = uniform.fields.iter().find(fits) {
        let at = field.offset as usize;
        if let Some(place) = bytes.get_mut(at..at + value.len()) {
            place.copy_from_slice(value);
        }
    }
}

fn pair(value: [f32; 2]) -> [u8; 8] {
    let [a, b] = value.map(f32::to_le_bytes);
    [a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]]
}

/// Where inside its pixel sample number `index` is taken, -0.5 .. 0.5 each way. The first is the centre.
///
/// The R2 sequence (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"), in 32-bit fixed point: any
/// number of samples covers the pixel evenly.
pub fn jitter(index: u32) -> [f32; 2] {
    const STEP: [u32; 2] = [3_242_174_889, 2_447_445_414]; // 2³² / g and 2³² / g², g³ = g + 1
    STEP.map(|step| {
        let at = index.wrapping_mul(step).wrapping_add(1 << 31);
        (at >> 8) as f32 / 16_777_216.0 - 0.5
    })
}
