//! [`Shader`] + [`Preset`] + [`Shot`] → [`Picture`]: in tiles, and as many jittered frames as the shot asks for.
//!
//! A tile is one scissor rectangle and one submission, waited for: no driver's watchdog sees a long one, and progress can be
//! told. The shader's colour is sRGB-encoded, as on Shadertoy; frames are averaged in linear light.

use super::adapter::Gpu;
use super::error::RenderError;
use super::frame::{self, Shot};
use super::picture::{Picture, srgb_decode};
use crate::bake::Uniform;
use crate::diagnostic::Error;
use crate::preset::Preset;
use crate::shader::Shader;

/// Told after each tile: how many are done, and of how many.
pub type Progress<'a> = &'a mut (dyn FnMut(u64, u64) + Send);

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;
const PIXEL: u32 = 16;

/// A triangle over the whole target, for shaders that bring no vertex entry point.
const TRIANGLE: &str = "@vertex fn vertex_main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(i & 1u), f32(i >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}";

/// Takes a picture.
///
/// The shader's first fragment entry point is drawn, with its first vertex entry point (three vertices, no buffers) or a
/// triangle over the target. Live parameters have the values of `preset`, but for the group `frame`, which is the shot's.
///
/// # Errors
/// A shader without a fragment entry point, or one that needs something bound besides its parameters; a size that cannot be
/// drawn; a preset that does not fit the shader; and what wgpu or the driver refuses.
pub fn render(
    gpu: &Gpu,
    shader: &Shader,
    preset: &Preset,
    shot: &Shot,
    progress: Progress<'_>,
) -> Result<Picture, Error> {
    let bytes = shader.uniform_bytes(preset)?;
    gpu.guarded(|| {
        check(gpu, shot)?;
        let job = gpu.scoped(|| Job::new(gpu, shader, shot))?;
        job.run(gpu, shader.interface().uniform.as_ref(), bytes, shot, progress)
    })
    .map_err(Error::from)
}

fn check(gpu: &Gpu, shot: &Shot) -> Result<(), RenderError> {
    let (Shot { width, height, .. }, limit) = (*shot, gpu.max_size());
    if width == 0 || height == 0 || width > limit || height > limit {
        return Err(RenderError::Size { width, height, limit });
    }
    if shot.samples == 0 {
        return Err(RenderError::Shot {
            why: "no picture comes of 0 samples",
            help: "`--samples` is at least 1",
        });
    }
    if !shot.time.is_finite() || shot.delta.is_some_and(|delta| !delta.is_finite()) {
        return Err(RenderError::Shot {
            why: "the time of the picture is not a finite number",
            help: "give it in seconds, as in `--time 12.5`",
        });
    }
    if shot.mouse.is_some_and(|mouse| !mouse.iter().all(|value| value.is_finite())) {
        return Err(RenderError::Shot {
            why: "the mouse is not at finite pixels",
            help: "give where it is and where it was pressed, as in `--mouse 400,300,200,300`",
        });
    }
    Ok(())
}

/// Everything on the GPU that a picture takes.
struct Job {
    pipeline: wgpu::RenderPipeline,
    /// The uniform buffer with its bind group and the group's number.
    uniform: Option<(wgpu::Buffer, wgpu::BindGroup, u32)>,
    texture: wgpu::Texture,
    readback: wgpu::Buffer,
    tile: u32,
}

impl Job {
    fn new(gpu: &Gpu, shader: &Shader, shot: &Shot) -> Result<Self, RenderError> {
        let device = &gpu.device;
        let stages = stages(shader)?;
        let module = device.create_shader_module(shader.descriptor());
        let triangle = wgpu::ShaderSource::Wgsl(TRIANGLE.into());
        let triangle = wgpu::ShaderModuleDescriptor { label: Some("triangle"), source: triangle };
        let triangle = stages.vertex.is_none().then(|| device.create_shader_module(triangle));
        let uniform = shader.interface().uniform.as_ref().map(|uniform| bound(gpu, uniform));
        let mut layouts = vec![None; uniform.as_ref().map_or(0, |(.., group)| *group as usize + 1)];
        let layout = uniform.as_ref().map(|(layout, ..)| layout);
        if let Some(last) = layouts.last_mut() {
            *last = layout;
        }
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &layouts,
            immediate_size: 0,
        });
        let target =
            wgpu::ColorTargetState { format: FORMAT, blend: None, write_mask: wgpu::ColorWrites::ALL };
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("picture"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: triangle.as_ref().unwrap_or(&module),
                entry_point: Some(stages.vertex.unwrap_or("vertex_main")),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(stages.fragment),
                compilation_options: Default::default(),
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        });
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("picture"),
            size: wgpu::Extent3d { width: shot.width, height: shot.height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let tile = shot.tile.unwrap_or_else(|| side(gpu, shot)).clamp(16, 2048);
        let readback = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("tile"),
            size: u64::from(stride(tile)) * u64::from(tile),
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let uniform = uniform.map(|(_, buffer, group, number)| (buffer, group, number));
        Ok(Self { pipeline, uniform, texture, readback, tile })
    }

    fn run(
        &self,
        gpu: &Gpu,
        layout: Option<&Uniform>,
        mut bytes: Vec<u8>,
        shot: &Shot,
        progress: Progress<'_>,
    ) -> Result<Picture, RenderError> {
        let samples = if frame::has_jitter(layout) { shot.samples } else { 1 };
        let tiles = tiles(shot, self.tile);
        let (mut done, total) = (0, tiles.len() as u64 * u64::from(samples));
        let count = shot.width as usize * shot.height as usize;
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(count).map_err(|_| RenderError::OutOfMemory)?;
        pixels.resize(count, [0.0; 4]);
        let share = 1.0 / samples as f32;
        for tile in tiles {
            for sample in 0..samples {
                if let (Some(layout), Some((buffer, ..))) = (layout, &self.uniform) {
                    frame::set_frame(&mut bytes, layout, shot, frame::jitter(sample));
                    gpu.scoped(|| {
                        gpu.queue.write_buffer(buffer, 0, &bytes);
                        Ok(())
                    })?;
                }
                self.draw(gpu, tile, |row, drawn| {
                    let start = (tile.y + row) as usize * shot.width as usize + tile.x as usize;
                    for (pixel, drawn) in pixels[start..].iter_mut().zip(drawn) {
                        let [r, g, b, a] = drawn;
                        let linear = [srgb_decode(r), srgb_decode(g), srgb_decode(b), a];
                        *pixel = std::array::from_fn(|i| pixel[i] + linear[i] * share);
                    }
                })?;
                done += 1;
                progress(done, total);
            }
        }
        Ok(Picture { width: shot.width, height: shot.height, pixels })
    }

    /// Draws one tile, and gives each of its rows to `take`.
    fn draw<F>(&self, gpu: &Gpu, tile: Tile, mut take: F) -> Result<(), RenderError>
    where
        F: FnMut(u32, &mut dyn Iterator<Item = [f32; 4]>),
    {
        let stride = stride(tile.width);
        let commands = gpu.scoped(|| {
            let mut commands = gpu.device.create_command_encoder(&Default::default());
            let view = self.texture.create_view(&Default::default());
            let mut pass = commands.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: None,
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                        store: wgpu::StoreOp::Store,
                    },
                })],
                depth_stencil_attachment: None,
                timestamp_writes: None,
                occlusion_query_set: None,
                multiview_mask: None,
            });
            pass.set_pipeline(&self.pipeline);
            if let Some((_, group, number)) = &self.uniform {
                pass.set_bind_group(*number, group, &[]);
            }
            pass.set_scissor_rect(tile.x, tile.y, tile.width, tile.height);
            pass.draw(0..3, 0..1);
            drop(pass);
            let mut from = self.texture.as_image_copy();
            from.origin = wgpu::Origin3d { x: tile.x, y: tile.y, z: 0 };
            let layout =
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride), rows_per_image: None };
            let to = wgpu::TexelCopyBufferInfo { buffer: &self.readback, layout };
            let size = wgpu::Extent3d { width: tile.width, height: tile.height, depth_or_array_layers: 1 };
            commands.copy_texture_to_buffer(from, to, size);
            Ok(commands)
        })?;
        let len = u64::from(stride) * u64::from(tile.height);
        gpu.submit_and_read(commands, &self.readback, len, |bytes| {
            for (row, bytes) in bytes.chunks_exact(stride as usize).enumerate() {
                let row_bytes = &bytes[..(tile.width * PIXEL) as usize];
                take(row as u32, &mut row_bytes.chunks_exact(PIXEL as usize).map(pixel));
            }
        })
    }
}

type Bound = (wgpu::BindGroupLayout, wgpu::Buffer, wgpu::BindGroup, u32);

/// The uniform buffer of live parameters, ready to be bound.
pub(super) fn bound(gpu: &Gpu, uniform: &Uniform) -> Bound {
    let layout = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(&uniform.name),
        entries: &[wgpu::BindGroupLayoutEntry {
            binding: uniform.binding,
            visibility: wgpu::ShaderStages::all(),
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        }],
    });
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(&uniform.name),
        size: u64::from(uniform.size),
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(&uniform.name),
        layout: &layout,
        entries: &[wgpu::BindGroupEntry { binding: uniform.binding, resource: buffer.as_entire_binding() }],
    });
    (layout, buffer, group, uniform.group)
}

struct Stages<'a> {
    vertex: Option<&'a str>,
    fragment: &'a str,
}

/// The entry points to draw with, once all is known to be here that they read.
fn stages(shader: &Shader) -> Result<Stages<'_>, RenderError> {
    let entries = &shader.interface().entry_points;
    let find = |stage| entries.iter().position(|entry| entry.stage == stage);
    let Some(fragment) = find("fragment") else {
        let has = entries.iter().map(|entry| format!("`{}` ({})", entry.name, entry.stage)).collect();
        return Err(RenderError::NoFragment { has });
    };
    let vertex = find("vertex");
    let used: Vec<_> = [Some(fragment), vertex].into_iter().flatten().collect();
    only_bound_here(shader, &used, &[])?;
    Ok(Stages { vertex: vertex.map(|index| entries[index].name.as_str()), fragment: &entries[fragment].name })
}

/// Sees to it that the entry points numbered `used` read nothing bound but the parameters and `ours`.
pub(super) fn only_bound_here(shader: &Shader, used: &[usize], ours: &[&str]) -> Result<(), RenderError> {
    let checked = shader.checked();
    let uniform = checked.interface.uniform.as_ref().map(|uniform| uniform.name.as_str());
    let mut names = Vec::new();
    for (handle, variable) in checked.module.global_variables.iter() {
        let name = variable.name.as_deref().unwrap_or_default();
        let read = used.iter().any(|index| !checked.info.get_entry_point(*index)[handle].is_empty());
        let known = variable.binding.is_none() || uniform == Some(name) || ours.contains(&name);
        if let Some(binding) = checked.interface.bindings.iter().find(|binding| binding.name == name)
            && read
            && !known
        {
            let (group, number) = (binding.group, binding.binding);
            names.push(format!("`{name}` ({}, @group({group}) @binding({number}))", binding.kind));
        }
    }
    if names.is_empty() { Ok(()) } else { Err(RenderError::Bindings { names }) }
}

/// The side of a tile that suits the adapter. A submission clears the whole target, which a software adapter feels: it gets
/// at most 64 of them or so.
fn side(gpu: &Gpu, shot: &Shot) -> u32 {
    if !gpu.is_software() {
        return 512;
    }
    let area = u64::from(shot.width) * u64::from(shot.height);
    (area / 64).isqrt().clamp(128, 2048) as u32
}

#[derive(Clone, Copy)]
struct Tile {
    x: u32,
    y: u32,
    width: u32,
    height: u32,
}

/// The picture, cut into squares of `side` pixels, row by row.
fn tiles(shot: &Shot, side: u32) -> Vec<Tile> {
    let mut tiles = Vec::new();
    for y in (0..shot.height).step_by(side as usize) {
        for x in (0..shot.width).step_by(side as usize) {
            let (width, height) = (side.min(shot.width - x), side.min(shot.height - y));
            tiles.push(Tile { x, y, width, height });
        }
    }
    tiles
}

/// Bytes from one row of a tile to the next in the buffer that it is copied to.
fn stride(width: u32) -> u32 {
    (width * PIXEL).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT)
}

fn pixel(bytes: &[u8]) -> [f32; 4] {
    let word = |i: usize| [bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2], bytes[4 * i + 3]];
    std::array::from_fn(|i| f32::from_le_bytes(word(i)))
}
