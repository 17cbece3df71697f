//! A program of somebody who knows wgpu and has read Orogen's README: it draws a landscape, turns its sun, and looks whether
//! the picture is one. No window: it runs wherever a Vulkan driver is.

#![deny(warnings, missing_docs)]

use std::error::Error;

/// The landscape: its parameters, its layouts and its WGSL, as `build.rs` had them written.
pub mod alpine {
    include!(concat!(env!("OUT_DIR"), "/alpine.rs"));
}

/// A planet, with glam's vectors.
pub mod earth {
    include!(concat!(env!("OUT_DIR"), "/earth.rs"));
}

/// A shader of our own.
pub mod own_arrays {
    include!(concat!(env!("OUT_DIR"), "/own_arrays.rs"));
}

/// The same with glam's vectors.
pub mod own_glam {
    include!(concat!(env!("OUT_DIR"), "/own_glam.rs"));
}

const WIDTH: u32 = 64;
const HEIGHT: u32 = 36;

fn main() -> Result<(), Box<dyn Error>> {
    bytes_are_those_of_the_preset()?;
    let gpu = Gpu::new()?;
    gpu.layouts_fit();

    let mut params = alpine::Params::default();
    params.frame.resolution = [WIDTH as f32, HEIGHT as f32];
    let day = gpu.draw(&params)?;
    params.sun = alpine::Sun { elevation: -0.2, ..params.sun }; // radians
    let night = gpu.draw(&params)?;

    let mean = |picture: &[[u8; 4]], rows: std::ops::Range<u32>| {
        let pixels = &picture[(rows.start * WIDTH) as usize..(rows.end * WIDTH) as usize];
        let sum = pixels.iter().fold([0.0; 3], |sum, p| std::array::from_fn(|i| sum[i] + f64::from(p[i])));
        sum.map(|channel| channel / pixels.len() as f64)
    };
    let (sky, land) = (mean(&day, 0..6), mean(&day, 24..HEIGHT));
    println!(
        "by day the sky is {sky:.0?} and the land {land:.0?}; at night the land is {:.0?}",
        mean(&night, 24..HEIGHT)
    );
    if sky.iter().sum::<f64>() <= 1.2 * land.iter().sum::<f64>() {
        return Err("the sky is no brighter than the land".into());
    }
    if mean(&night, 24..HEIGHT)[1] >= 0.7 * land[1] {
        return Err("the land is as bright at night as by day".into());
    }
    Ok(())
}

/// `Default` of the generated structs and `uniform_bytes` are two ways to the same bytes.
fn bytes_are_those_of_the_preset() -> Result<(), Box<dyn Error>> {
    use orogen::{Bake, Library, Preset, compose};
    let library = Library::standard();

    let mut preset = Preset::named("alpine")?;
    preset.set("quality=low")?;
    let bake = Bake::live(["sun.*"]).with_overrides(["ground.*"]);
    let shader = compose(&library, &preset, &bake)?;
    same("alpine", alpine::Params::default().as_bytes(), &shader.uniform_bytes(&preset)?)?;
    if alpine::WGSL != shader.wgsl() {
        return Err("the WGSL in the generated file is another".into());
    }
    let overrides = shader.interface().overrides.iter().map(|one| (one.name.as_str(), one.default.as_f64()));
    let generated = alpine::overrides::VALUES.iter().map(|(name, value)| (*name, Some(*value)));
    if overrides.map(|(name, _)| name).ne(generated.map(|(name, _)| name)) {
        return Err("the overrides in the generated file are others".into());
    }

    let preset = Preset::named("earth")?;
    let shader = compose(&library, &preset, &Bake::live(["*"]).at_binding(1, 2))?;
    same("earth", earth::Params::default().as_bytes(), &shader.uniform_bytes(&preset)?)?;
    assert_eq!((earth::Params::GROUP, earth::Params::BINDING), (1, 2));

    let own = Preset::file(concat!(env!("CARGO_MANIFEST_DIR"), "/shaders/own.json"))?;
    let shader = compose(&library, &own, &Bake::live(["*"]))?;
    let bytes = shader.uniform_bytes(&own)?;
    same("own, arrays", own_arrays::Params::default().as_bytes(), &bytes)?;
    same("own, glam", own_glam::Params::default().as_bytes(), &bytes)?;
    let own = own_glam::Params::default();
    assert_eq!((own.r#type.on, own.r#type.count, own.r#type.self_), (1, 7, -4));
    assert_eq!(own.two_words.bend, std::f32::consts::FRAC_PI_2);
    assert_eq!(own.r#type.r#move, glam::Vec3::new(1.0, 2.0, 3.0));
    Ok(())
}

fn same(name: &str, ours: &[u8], theirs: &[u8]) -> Result<(), String> {
    if ours == theirs { Ok(()) } else { Err(format!("{name}: {ours:?} is not {theirs:?}")) }
}

struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

impl Gpu {
    fn new() -> Result<Self, Box<dyn Error>> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
        let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))?;
        Ok(Self { device, queue })
    }

    /// What is generated of a shader with a binding of every kind makes a pipeline of it.
    fn layouts_fit(&self) {
        let layout = |entries: &[wgpu::BindGroupLayoutEntry]| {
            self.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries })
        };
        let (params, others) = (layout(&own_arrays::BIND_GROUP_0), layout(&own_arrays::BIND_GROUP_1));
        let module = self.module(own_arrays::WGSL);
        let layout = self.layout(&[Some(&params), Some(&others)]);
        let _ = self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("own"),
            layout: Some(&layout),
            module: &module,
            entry_point: Some(own_arrays::entry_points::MEASURE),
            compilation_options: Default::default(),
            cache: None,
        });
        assert_eq!(own_arrays::BIND_GROUP_1.len(), 8);
    }

    fn module(&self, wgsl: &str) -> wgpu::ShaderModule {
        self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(wgsl.into()),
        })
    }

    fn layout(&self, groups: &[Option<&wgpu::BindGroupLayout>]) -> wgpu::PipelineLayout {
        self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: groups,
            immediate_size: 0,
        })
    }

    /// A picture of the landscape.
    fn draw(&self, params: &alpine::Params) -> Result<Vec<[u8; 4]>, Box<dyn Error>> {
        let device = &self.device;
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("params"),
            size: alpine::Params::SIZE,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        self.queue.write_buffer(&buffer, 0, params.as_bytes());
        let bind_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: None,
            entries: &alpine::BIND_GROUP_0,
        });
        let entries =
            [wgpu::BindGroupEntry { binding: alpine::Params::BINDING, resource: buffer.as_entire_binding() }];
        let bind = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &bind_layout,
            entries: &entries,
        });
        let module = self.module(alpine::WGSL);
        let overrides = wgpu::PipelineCompilationOptions {
            constants: &[(alpine::overrides::GROUND_SNOW_LINE, 1200.0)],
            ..Default::default()
        };
        let format = wgpu::TextureFormat::Rgba8Unorm;
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&self.layout(&[Some(&bind_layout)])),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some(alpine::entry_points::VERTEX_MAIN),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: Default::default(),
            depth_stencil: None,
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some(alpine::entry_points::FRAGMENT_MAIN),
                compilation_options: overrides,
                targets: &[Some(format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let size = wgpu::Extent3d { width: WIDTH, height: HEIGHT, depth_or_array_layers: 1 };
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let readback = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(WIDTH * 4 * HEIGHT),
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        {
            let view = texture.create_view(&Default::default());
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: None,
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                        store: wgpu::StoreOp::Store,
                    },
                })],
                depth_stencil_attachment: None,
                timestamp_writes: None,
                occlusion_query_set: None,
                multiview_mask: None,
            });
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(alpine::Params::GROUP, &bind, &[]);
            pass.draw(0..3, 0..1);
        }
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &readback,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(WIDTH * 4),
                    rows_per_image: None,
                },
            },
            size,
        );
        self.queue.submit([encoder.finish()]);
        readback.slice(..).map_async(wgpu::MapMode::Read, |_| {});
        device.poll(wgpu::PollType::wait_indefinitely())?;
        let bytes = readback.slice(..).get_mapped_range()?;
        Ok(bytes.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect())
    }
}
