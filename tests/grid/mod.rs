//! WGSL → what it puts out over a grid of pixels on wgpu's adapter, bit by bit.
//!
//! No part of Orogen has a hand in it: the author's own text goes to wgpu.

use wgpu::TextureFormat as Format;

/// Pixels in either direction; a row of them is as long as rows in buffers must be.
pub(crate) const SIDE: u32 = 64;

/// Bytes of a pixel: four channels of 32 bits.
const PIXEL: u32 = 16;

const TRIANGLE: &str = "@vertex fn corner(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(i & 1u), f32(i >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}";

/// What the four channels are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Channels {
    Float,
    Signed,
    Unsigned,
}

impl Channels {
    /// Those of the colour at location 0 that the fragment entry point returns.
    pub(crate) fn of(module: &naga::Module) -> Result<Self, String> {
        let entry = module.entry_points.iter().find(|one| one.stage == naga::ShaderStage::Fragment);
        let result =
            entry.and_then(|entry| entry.function.result.as_ref()).ok_or("there is no fragment output")?;
        let mut inner = &module.types[result.ty].inner;
        if let naga::TypeInner::Struct { members, .. } = inner {
            inner = &module.types[members[0].ty].inner;
        }
        match inner {
            naga::TypeInner::Vector { size: naga::VectorSize::Quad, scalar } => match scalar.kind {
                naga::ScalarKind::Float => Ok(Self::Float),
                naga::ScalarKind::Sint => Ok(Self::Signed),
                naga::ScalarKind::Uint => Ok(Self::Unsigned),
                _ => Err("the colour is of no type for a target".into()),
            },
            _ => Err("the colour has not four channels".into()),
        }
    }

    fn format(self) -> Format {
        match self {
            Self::Float => Format::Rgba32Float,
            Self::Signed => Format::Rgba32Sint,
            Self::Unsigned => Format::Rgba32Uint,
        }
    }
}

/// An adapter, opened: the one that `WGPU_ADAPTER_NAME` names, else the first.
pub(crate) struct Device {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

impl Device {
    pub(crate) fn open() -> Result<Self, String> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
            flags: wgpu::InstanceFlags::empty(),
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        });
        let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
        let wanted = std::env::var("WGPU_ADAPTER_NAME").unwrap_or_default().to_lowercase();
        let adapter = adapters
            .iter()
            .find(|adapter| adapter.get_info().name.to_lowercase().contains(&wanted))
            .ok_or("there is no adapter to draw on: `cargo xtask test` installs lavapipe")?;
        let descriptor = wgpu::DeviceDescriptor { label: Some("grid"), ..Default::default() };
        let opened = pollster::block_on(adapter.request_device(&descriptor));
        let (device, queue) = opened.map_err(|why| why.to_string())?;
        device.on_uncaptured_error(std::sync::Arc::new(|_| {})); // the scope below has them
        Ok(Self { device, queue })
    }

    /// The four words of each pixel, row by row, in ascending order of the position's `y`.
    pub(crate) fn draw(&self, wgsl: &str, channels: Channels) -> Result<Vec<[u32; 4]>, String> {
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let pipeline = self.pipeline(wgsl, channels);
        let texture = self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: SIDE, height: SIDE, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: channels.format(),
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(SIDE * SIDE * PIXEL),
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let mut commands = self.device.create_command_encoder(&Default::default());
        let view = texture.create_view(&Default::default());
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
        pass.set_pipeline(&pipeline);
        pass.draw(0..3, 0..1);
        drop(pass);
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(SIDE * PIXEL),
            rows_per_image: None,
        };
        let size = texture.size();
        let to = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        commands.copy_texture_to_buffer(texture.as_image_copy(), to, size);
        self.queue.submit([commands.finish()]);
        buffer.map_async(wgpu::MapMode::Read, .., |_| {});
        self.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|why| why.to_string())?;
        if let Some(error) = pollster::block_on(scope.pop()) {
            return Err(error.to_string());
        }
        let bytes = buffer.get_mapped_range(..).map_err(|why| why.to_string())?;
        Ok(pixels(&bytes))
    }

    fn pipeline(&self, wgsl: &str, channels: Channels) -> wgpu::RenderPipeline {
        let module = |text: &str| {
            let source = wgpu::ShaderSource::Wgsl(text.into());
            self.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source })
        };
        let target = wgpu::ColorTargetState {
            format: channels.format(),
            blend: None,
            write_mask: wgpu::ColorWrites::ALL,
        };
        self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: None,
            vertex: wgpu::VertexState {
                module: &module(TRIANGLE),
                entry_point: None,
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module(wgsl),
                entry_point: None,
                compilation_options: Default::default(),
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// Four little-endian words each.
pub(crate) fn pixels(bytes: &[u8]) -> Vec<[u32; 4]> {
    let words: Vec<u32> =
        bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect();
    words.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect()
}
