//! A package → WGSL, through the `wesl` crate; WGSL → a picture, on a wgpu of its own.

use orogen::export::Package;
use orogen::render::{Picture, Shot, srgb_decode};
use wesl::syntax::{ModulePath, PathOrigin};
use wesl::{CompileOptions, EscapeMangler, Feature, VirtualResolver};

/// For fragments that stand alone.
const TRIANGLE: &str = "
struct Vertex { @builtin(position) position: vec4f, @location(0) world: vec4f }
@vertex fn vertex_main(@builtin(vertex_index) i: u32) -> Vertex {
    let at = vec2f(f32(i & 1u), f32(i >> 1u)) * 4.0 - 1.0;
    return Vertex(vec4f(at, 0.0, 1.0), vec4f(at.x, 2.0 + at.y, -1.0, 1.0));
}";

/// Path of the module in the file `name`, which has no extension.
pub(crate) fn module(name: &str) -> ModulePath {
    ModulePath::new(PathOrigin::Absolute, name.split('/').map(str::to_owned).collect())
}

/// The modules of a package, at the root.
pub(crate) fn add(resolver: &mut VirtualResolver<'_>, package: &Package) {
    for (path, text) in &package.files {
        if let Some(name) = path.strip_suffix(".wesl") {
            resolver.add_module(module(name), text.clone().into());
        }
    }
}

/// Compiles the module `root` with `features` on: its entry points, or with `whole` all that it declares.
pub(crate) fn compile(
    resolver: &VirtualResolver<'_>,
    root: &str,
    features: &[String],
    whole: bool,
) -> Result<String, String> {
    let mut options = CompileOptions { keep_root: whole, ..CompileOptions::default() };
    options.features.flags = features.iter().map(|name| (name.clone(), Feature::Enable)).collect();
    wesl::compile(&module(root), resolver, &EscapeMangler, &options)
        .map(|compiled| compiled.to_string())
        .map_err(|error| format!("{root}: {error}"))
}

/// What naga says against `wgsl`.
pub(crate) fn validate(wgsl: &str) -> Result<(), String> {
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|error| error.emit_to_string(wgsl))?;
    let mut validator = naga::valid::Validator::new(naga::valid::ValidationFlags::all(), Default::default());
    validator.validate(&module).map(drop).map_err(|error| error.emit_to_string(wgsl))
}

/// A software adapter, or whichever there is.
pub(crate) struct Device {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

impl Device {
    /// Opens it.
    pub(crate) fn new() -> Self {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
        let wanted = std::env::var("WGPU_ADAPTER_NAME").unwrap_or_default().to_lowercase();
        let is_wanted = |adapter: &wgpu::Adapter| adapter.get_info().name.to_lowercase().contains(&wanted);
        let adapter = adapters.into_iter().find(is_wanted).expect("there is an adapter");
        let descriptor = wgpu::DeviceDescriptor::default();
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).expect("it opens");
        Self { device, queue }
    }

    /// The same device, for Orogen.
    pub(crate) fn gpu(&self) -> orogen::render::Gpu {
        orogen::render::Gpu::of(&self.device, &self.queue)
    }

    /// What the fragment entry point `entry` of `wgsl` draws, in linear light. `buffers` are uniform, each with its group and
    /// its binding. Without a `vertex_main` of its own it gets a triangle over the picture, and at location 0 a place on the
    /// wall 1 m ahead of the world's origin.
    pub(crate) fn draw(
        &self,
        wgsl: &str,
        entry: &str,
        buffers: &[(u32, u32, Vec<u8>)],
        shot: &Shot,
    ) -> Picture {
        let pipeline = self.pipeline(wgsl, entry);
        let mut groups: Vec<u32> = buffers.iter().map(|(group, ..)| *group).collect();
        groups.dedup();
        let bound: Vec<_> = buffers
            .iter()
            .map(|(group, binding, bytes)| {
                let usage = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST;
                let buffer = self.buffer(bytes.len() as u64, usage);
                self.queue.write_buffer(&buffer, 0, bytes);
                (*group, *binding, buffer)
            })
            .collect();
        let texture = self.texture(shot);
        let mut commands = self.device.create_command_encoder(&Default::default());
        let view = texture.create_view(&Default::default());
        let mut pass = commands.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations::default(),
            })],
            ..Default::default()
        });
        pass.set_pipeline(&pipeline);
        for group in groups {
            let entries = bound.iter().filter(|(known, ..)| *known == group).map(|(_, binding, buffer)| {
                wgpu::BindGroupEntry { binding: *binding, resource: buffer.as_entire_binding() }
            });
            let bind_group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &pipeline.get_bind_group_layout(group),
                entries: &entries.collect::<Vec<_>>(),
            });
            pass.set_bind_group(group, &bind_group, &[]);
        }
        pass.draw(0..3, 0..1);
        drop(pass);
        self.read(commands, &texture, shot)
    }

    fn pipeline(&self, wgsl: &str, entry: &str) -> wgpu::RenderPipeline {
        let module = |text: &str| {
            let source = wgpu::ShaderSource::Wgsl(text.into());
            self.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source })
        };
        let vertex = if wgsl.contains("fn vertex_main(") { wgsl } else { TRIANGLE };
        let (vertex, module) = (module(vertex), module(wgsl));
        let target = wgpu::ColorTargetState {
            format: wgpu::TextureFormat::Rgba32Float,
            blend: None,
            write_mask: wgpu::ColorWrites::ALL,
        };
        self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: None,
            vertex: wgpu::VertexState {
                module: &vertex,
                entry_point: Some("vertex_main"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(entry),
                compilation_options: Default::default(),
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        })
    }

    fn buffer(&self, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
        self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size,
            usage,
            mapped_at_creation: false,
        })
    }

    fn texture(&self, shot: &Shot) -> wgpu::Texture {
        self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: shot.width, height: shot.height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Float,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        })
    }

    fn read(&self, mut commands: wgpu::CommandEncoder, texture: &wgpu::Texture, shot: &Shot) -> Picture {
        let row = (shot.width * 16).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let size = u64::from(row) * u64::from(shot.height);
        let buffer = self.buffer(size, wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
        let to = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        commands.copy_texture_to_buffer(texture.as_image_copy(), to, texture.size());
        self.queue.submit([commands.finish()]);
        buffer.map_async(wgpu::MapMode::Read, .., |outcome| outcome.expect("it is mapped"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the work is done");
        let bytes = buffer.get_mapped_range(..).expect("it is mapped");
        let value = |bytes: &[u8]| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
        let pixel = |bytes: &[u8]| {
            let encoded: [f32; 4] = std::array::from_fn(|i| value(&bytes[4 * i..]));
            [srgb_decode(encoded[0]), srgb_decode(encoded[1]), srgb_decode(encoded[2]), encoded[3]]
        };
        let rows = bytes.chunks_exact(row as usize);
        let pixels = rows
            .flat_map(|row| row[..16 * shot.width as usize].chunks_exact(16).map(pixel).collect::<Vec<_>>());
        Picture { width: shot.width, height: shot.height, pixels: pixels.collect() }
    }
}

/// The buffer that `parameters`, the module of that name, declares for what is live: the frame alone.
pub(crate) fn frame(parameters: &str, shot: &Shot) -> Vec<u8> {
    let fields = parameters.split_once("struct OrogenParams {").expect("the frame is live").1;
    let fields = fields.split_once("\n}").expect("it ends").0;
    let mut bytes = Vec::new();
    for line in fields.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//")) {
        let (name, ty) = line.split_once(": ").expect("it is a field");
        let ty = ty.split(',').next().unwrap_or_default();
        let (align, size) = match ty {
            "f32" | "u32" => (4, 4),
            "vec2f" => (8, 8),
            "vec4f" => (16, 16),
            other => panic!("what is the layout of `{other}`?"),
        };
        let at = bytes.len().next_multiple_of(align);
        bytes.resize(at + size, 0);
        if name == "frame_resolution" {
            bytes[at..at + 4].copy_from_slice(&(shot.width as f32).to_le_bytes());
            bytes[at + 4..at + 8].copy_from_slice(&(shot.height as f32).to_le_bytes());
        }
    }
    bytes.resize(bytes.len().next_multiple_of(16), 0);
    bytes
}

/// How alike two pictures are when shown (dB, of sRGB values cut to 0 .. 1); infinite where they are the same.
pub(crate) fn psnr(a: &Picture, b: &Picture) -> f64 {
    let shown = |value: f32| f64::from(orogen::render::srgb_encode(value).clamp(0.0, 1.0));
    let pairs = a.pixels.iter().zip(&b.pixels).flat_map(|(a, b)| (0..3).map(|i| (shown(a[i]), shown(b[i]))));
    let sum: f64 = pairs.map(|(a, b)| (a - b).powi(2)).sum();
    let mean = sum / (3 * a.pixels.len()) as f64;
    if mean == 0.0 { f64::INFINITY } else { -10.0 * mean.log10() }
}
