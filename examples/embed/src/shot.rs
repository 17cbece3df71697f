//! A frame without a window: drawn, read back, and written as a PNG.

use std::path::Path;
use std::sync::mpsc;

use crate::camera::Camera;
use crate::engine::{Engine, Targets};

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

/// The display's format where there is no window.
pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;

/// A frame, read back.
pub struct Frame {
    /// Pixels of the display, each way.
    pub size: [u32; 2],
    /// sRGB-encoded red, green, blue and alpha of each pixel, rows from the top.
    pub display: Vec<u8>,
    /// Of each sample, whose it is: 0 the land's, else 1 + the thing's number.
    pub things: Vec<u32>,
    /// Of each sample, its depth: 1 near, 0 far.
    pub depth: Vec<f32>,
}

/// Draws a frame of `size`, with `samples`² of light to each pixel.
pub fn frame(
    engine: &Engine,
    camera: &Camera,
    size: [u32; 2],
    samples: u32,
    exposure: f32,
) -> Fallible<Frame> {
    let targets: Targets = engine.targets(size, samples, exposure);
    let [width, height] = size;
    let display = engine.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("shot"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    engine.draw(camera, &targets, &display.create_view(&Default::default()))?;
    let word = |bytes: &[u8]| [bytes[0], bytes[1], bytes[2], bytes[3]];
    Ok(Frame {
        size,
        display: read(engine, &display)?,
        things: read(engine, &targets.thing)?
            .chunks_exact(4)
            .map(|bytes| u32::from_le_bytes(word(bytes)))
            .collect(),
        depth: read(engine, &targets.depth)?
            .chunks_exact(4)
            .map(|bytes| f32::from_le_bytes(word(bytes)))
            .collect(),
    })
}

/// Writes what the display shows.
pub fn write(frame: &Frame, path: &Path) -> Fallible<()> {
    let opaque: Vec<u8> =
        frame.display.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    let [width, height] = frame.size;
    image::save_buffer(path, &opaque, width, height, image::ExtendedColorType::Rgb8)?;
    Ok(())
}

/// The bytes of a texture of four bytes a pixel, rows from the top.
fn read(engine: &Engine, texture: &wgpu::Texture) -> Fallible<Vec<u8>> {
    let row = 4 * texture.width() as usize;
    let stride = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize);
    let buffer = engine.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: (stride * texture.height() as usize) as u64,
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut commands = engine.device.create_command_encoder(&Default::default());
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride as u32), rows_per_image: None };
    commands.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
        texture.size(),
    );
    engine.queue.submit([commands.finish()]);
    let (sender, receiver) = mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |outcome| drop(sender.send(outcome)));
    engine.device.poll(wgpu::PollType::wait_indefinitely())?;
    receiver.recv()??;
    let bytes = buffer.get_mapped_range(..)?;
    Ok(bytes.chunks_exact(stride).flat_map(|line| &line[..row]).copied().collect())
}
