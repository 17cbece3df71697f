//! A GPU, real or software, that runs what the contestants have composed and says how long it took.
//!
//! Real hardware is timed by its own timestamps; what a software GPU does is CPU time of this process.

use std::sync::mpsc;
use std::time::Instant;

use cpu_time::ProcessTime;
use orogen::render::{Shot, set_frame};
use orogen::{Preset, Shader};
use wgpu::util::DeviceExt;

use crate::Outcome;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// An adapter with a device open on it.
pub(crate) struct Lab {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    pub(crate) name: String,
    pub(crate) driver: String,
    pub(crate) software: bool,
    timestamps: bool,
}

impl Lab {
    /// The adapter whose name contains what the environment variable `WGPU_ADAPTER_NAME` says; without it, the fastest kind
    /// there is.
    pub(crate) fn open() -> Outcome<Self> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
            flags: wgpu::InstanceFlags::empty(),
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        });
        let wanted = std::env::var("WGPU_ADAPTER_NAME").unwrap_or_default().trim().to_lowercase();
        let mut adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
        adapters.retain(|adapter| adapter.get_info().name.to_lowercase().contains(&wanted));
        let rank = |kind| {
            use wgpu::DeviceType as Kind;
            [Kind::DiscreteGpu, Kind::IntegratedGpu, Kind::VirtualGpu, Kind::Other]
                .iter()
                .position(|k| *k == kind)
        };
        let fastest =
            adapters.into_iter().min_by_key(|adapter| rank(adapter.get_info().device_type).unwrap_or(4));
        let adapter = fastest.ok_or_else(|| format!("there is no adapter named `{wanted}`"))?;
        let info = adapter.get_info();
        let inside = wgpu::Features::TIMESTAMP_QUERY;
        let software = info.device_type == wgpu::DeviceType::Cpu;
        let has_timestamps = adapter.features().contains(inside);
        let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("peers"),
            required_features: adapter.features() & inside,
            ..Default::default()
        }))?;
        let driver = format!("{} {}", info.driver, info.driver_info).trim().to_owned();
        Ok(Self { device, queue, name: info.name, driver, software, timestamps: has_timestamps && !software })
    }

    /// Which clock [`Lab::timed`] reads.
    pub(crate) fn clock(&self) -> &'static str {
        match (self.software, self.timestamps) {
            (true, _) => "CPU ms",
            (_, true) => "GPU ms",
            _ => "ms by the clock",
        }
    }

    /// Runs `make`; whatever wgpu has to say against it is the result.
    pub(crate) fn scoped<T>(&self, make: impl FnOnce() -> Outcome<T>) -> Outcome<T> {
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let made = make();
        match pollster::block_on(scope.pop()) {
            Some(error) => Err(error.to_string().into()),
            None => made,
        }
    }

    /// Waits for all that was submitted.
    pub(crate) fn wait(&self) -> Outcome {
        self.device.poll(wgpu::PollType::wait_indefinitely())?;
        Ok(())
    }

    /// Records by `record`, submits, waits, and tells how long that took (ms), by the adapter's own clock.
    ///
    /// `record` is to hand the timestamps on to its one pass.
    pub(crate) fn timed(
        &self,
        record: impl FnOnce(&mut wgpu::CommandEncoder, Option<&wgpu::QuerySet>),
    ) -> Outcome<f64> {
        let mut commands = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let queries = self.timestamps.then(|| {
            self.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: None,
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            })
        });
        record(&mut commands, queries.as_ref());
        let Some(queries) = queries else {
            let (cpu, wall) = (ProcessTime::now(), Instant::now());
            self.queue.submit([commands.finish()]);
            self.wait()?;
            let spent = if self.software { cpu.elapsed() } else { wall.elapsed() };
            return Ok(spent.as_secs_f64() * 1e3);
        };
        let size = 16;
        let resolved = self.buffer(size, wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC);
        let readback = self.buffer(size, wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
        commands.resolve_query_set(&queries, 0..2, &resolved, 0);
        commands.copy_buffer_to_buffer(&resolved, 0, &readback, 0, size);
        self.queue.submit([commands.finish()]);
        let bytes = self.read(&readback)?;
        let ticks: &[u64] = bytemuck::cast_slice(&bytes);
        Ok((ticks[1] - ticks[0]) as f64 * f64::from(self.queue.get_timestamp_period()) / 1e6)
    }

    /// The bytes of a buffer that can be mapped.
    fn read(&self, buffer: &wgpu::Buffer) -> Outcome<Vec<u8>> {
        let (sender, receiver) = mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |outcome| drop(sender.send(outcome)));
        self.wait()?;
        receiver.recv()??;
        let bytes = buffer.get_mapped_range(..)?.to_vec();
        buffer.unmap();
        Ok(bytes)
    }

    fn buffer(&self, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
        let descriptor = wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
        self.device.create_buffer(&descriptor)
    }
}

/// A compute shader over one array of floats, `@group(0) @binding(0)`, entry point `main`.
pub(crate) struct Program<'a> {
    lab: &'a Lab,
    pipeline: wgpu::ComputePipeline,
    values: wgpu::Buffer,
    group: wgpu::BindGroup,
}

impl<'a> Program<'a> {
    /// Compiles `wgsl`, which writes `count` values.
    pub(crate) fn new(lab: &'a Lab, wgsl: &str, count: u64) -> Outcome<Self> {
        lab.scoped(|| {
            let module = lab.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: None,
                source: wgpu::ShaderSource::Wgsl(wgsl.into()),
            });
            let pipeline = lab.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: None,
                layout: None,
                module: &module,
                entry_point: Some("main"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            });
            let values = lab.buffer(count * 4, wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
            let group = lab.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &pipeline.get_bind_group_layout(0),
                entries: &[wgpu::BindGroupEntry { binding: 0, resource: values.as_entire_binding() }],
            });
            Ok(Self { lab, pipeline, values, group })
        })
    }

    /// Runs it over as many workgroups; how long it took (ms).
    pub(crate) fn run(&self, workgroups: u32) -> Outcome<f64> {
        self.lab.timed(|commands, queries| {
            let mut pass = commands.begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: None,
                timestamp_writes: queries.map(|query_set| wgpu::ComputePassTimestampWrites {
                    query_set,
                    beginning_of_pass_write_index: Some(0),
                    end_of_pass_write_index: Some(1),
                }),
            });
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &self.group, &[]);
            pass.dispatch_workgroups(workgroups, 1, 1);
        })
    }

    /// What it has written.
    pub(crate) fn values(&self) -> Outcome<Vec<f32>> {
        let size = self.values.size();
        let readback = self.lab.buffer(size, wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
        let mut commands = self.lab.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        commands.copy_buffer_to_buffer(&self.values, 0, &readback, 0, size);
        self.lab.queue.submit([commands.finish()]);
        Ok(bytemuck::cast_slice(&self.lab.read(&readback)?).to_vec())
    }
}

/// A scene's picture, drawn into a texture that nobody reads.
pub(crate) struct Painting<'a> {
    lab: &'a Lab,
    pipeline: wgpu::RenderPipeline,
    uniform: Option<(u32, wgpu::BindGroup)>,
    view: wgpu::TextureView,
}

impl<'a> Painting<'a> {
    /// The picture of `preset` at a size; everything is compiled, drivers that wait for the first picture included, and how long
    /// that took (ms of CPU time, or by the clock on a GPU) stands beside it.
    pub(crate) fn new(
        lab: &'a Lab,
        shader: &Shader,
        preset: &Preset,
        size: (u32, u32),
    ) -> Outcome<(Self, f64)> {
        let uniform = shader.interface().uniform.as_ref();
        let mut bytes = shader.uniform_bytes(preset)?;
        if let Some(uniform) = uniform {
            set_frame(&mut bytes, uniform, &Shot::new(size.0, size.1), [0.0, 0.0]);
        }
        let (cpu, wall) = (ProcessTime::now(), Instant::now());
        let painting = lab.scoped(|| {
            let device = &lab.device;
            let module = device.create_shader_module(shader.descriptor());
            let entry = |stage| {
                let of = shader.interface().entry_points.iter().find(|entry| entry.stage == stage);
                of.map(|entry| entry.name.as_str())
            };
            let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: None,
                layout: None,
                vertex: wgpu::VertexState {
                    module: &module,
                    entry_point: entry("vertex"),
                    compilation_options: Default::default(),
                    buffers: &[],
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: None,
                multisample: wgpu::MultisampleState::default(),
                fragment: Some(wgpu::FragmentState {
                    module: &module,
                    entry_point: entry("fragment"),
                    compilation_options: Default::default(),
                    targets: &[Some(FORMAT.into())],
                }),
                multiview_mask: None,
                cache: None,
            });
            let uniform = uniform.map(|uniform| {
                let contents = bytes.as_slice();
                let usage = wgpu::BufferUsages::UNIFORM;
                let buffer = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                    label: None,
                    contents,
                    usage,
                });
                let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
                    label: None,
                    layout: &pipeline.get_bind_group_layout(uniform.group),
                    entries: &[wgpu::BindGroupEntry {
                        binding: uniform.binding,
                        resource: buffer.as_entire_binding(),
                    }],
                });
                (uniform.group, group)
            });
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d { width: size.0, height: size.1, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: FORMAT,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
            Ok(Self { lab, pipeline, uniform, view })
        })?;
        painting.draw(Some([0, 0, 1, 1]))?;
        let spent = if lab.software { cpu.elapsed() } else { wall.elapsed() };
        Ok((painting, spent.as_secs_f64() * 1e3))
    }

    /// Draws it once; how long that took (ms). With `part` (x, y, width, height), those pixels alone.
    pub(crate) fn draw(&self, part: Option<[u32; 4]>) -> Outcome<f64> {
        self.lab.timed(|commands, queries| {
            let mut pass = commands.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: None,
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &self.view,
                    resolve_target: None,
                    depth_slice: None,
                    ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
                })],
                depth_stencil_attachment: None,
                timestamp_writes: queries.map(|query_set| wgpu::RenderPassTimestampWrites {
                    query_set,
                    beginning_of_pass_write_index: Some(0),
                    end_of_pass_write_index: Some(1),
                }),
                occlusion_query_set: None,
                multiview_mask: None,
            });
            pass.set_pipeline(&self.pipeline);
            if let Some((group, bound)) = &self.uniform {
                pass.set_bind_group(*group, bound, &[]);
            }
            if let Some([x, y, width, height]) = part {
                pass.set_scissor_rect(x, y, width, height);
            }
            pass.draw(0..3, 0..1);
        })
    }
}

#[cfg(test)]
mod tests {
    use std::time::Instant;

    use super::*;

    /// Software GPUs have timestamps, too: the clock of real hardware is tried on them.
    #[test]
    fn timestamps_tell_most_of_what_passes_by_the_clock() {
        let mut lab = Lab::open().expect("there is an adapter");
        assert!(
            lab.device.features().contains(wgpu::Features::TIMESTAMP_QUERY),
            "{} has no timestamps",
            lab.name
        );
        lab.timestamps = true;
        let wgsl = "@group(0) @binding(0) var<storage, read_write> values: array<f32>;
            @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
                var x = f32(id.x);
                for (var i = 0; i < 20000; i++) { x = fract(1.7 * x + 0.3); }
                values[id.x] = x;
            }";
        let program = Program::new(&lab, wgsl, 64 * 256).expect("it compiles");
        program.run(1).expect("it runs"); // drivers compile while they run it first
        let clock = Instant::now();
        let told = program.run(256).expect("it runs");
        let passed = clock.elapsed().as_secs_f64() * 1e3;
        assert!(told > 0.3 * passed && told < 1.1 * passed, "{told} ms of {passed} ms");
    }
}
