//! A kernel and its points → the bits of the results, in as many dispatches as bounded buffers take.

use super::super::adapter::Gpu;
use super::super::draw::bound;
use super::super::error::RenderError;
use super::text::{ENTRY, GROUP, WORKGROUP};
use super::value::Points;
use crate::shader::Shader;

/// The most points that one dispatch takes.
const MOST_POINTS: usize = 1 << 18;
/// The most bytes that a buffer takes.
const MOST_BYTES: usize = 32 << 20;

/// Runs the kernel over all points; `width` scalars come of each.
pub(super) fn run(
    gpu: &Gpu,
    shader: &Shader,
    uniform: &[u8],
    points: &Points,
    width: usize,
) -> Result<Vec<u32>, RenderError> {
    let columns = points.columns.len();
    let count = points.values.len().checked_div(columns).unwrap_or(1);
    let widest = columns.max(width).max(1);
    let batch = MOST_POINTS.min(MOST_BYTES / (4 * widest)).min(count).max(1);
    if width == 0 || count == 0 {
        return Ok(Vec::new());
    }
    let kernel = gpu.scoped(|| Ok(Kernel::new(gpu, shader, uniform, batch * columns, batch * width)))?;
    let mut results = Vec::with_capacity(count * width);
    for first in (0..count).step_by(batch) {
        let here = batch.min(count - first);
        let values = points.values[first * columns..(first + here) * columns].iter();
        let bytes: Vec<u8> = values.flat_map(|value| value.bits().to_le_bytes()).collect();
        let len = (here * width * 4) as u64;
        let commands = gpu.scoped(|| Ok(kernel.commands(gpu, &bytes, here, len)))?;
        gpu.submit_and_read(commands, &kernel.readback, len, |bytes| {
            let words =
                bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]));
            results.extend(words);
        })?;
    }
    Ok(results)
}

struct Kernel {
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
    uniform: Option<(wgpu::BindGroup, u32)>,
    input: wgpu::Buffer,
    output: wgpu::Buffer,
    readback: wgpu::Buffer,
}

impl Kernel {
    /// With room for so many words of points and of results.
    fn new(gpu: &Gpu, shader: &Shader, uniform: &[u8], inputs: usize, outputs: usize) -> Self {
        let device = &gpu.device;
        let storage = |binding, read_only| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("points"),
            entries: &[storage(0, true), storage(1, false)],
        });
        let parameters = shader.interface().uniform.as_ref().map(|layout| bound(gpu, layout));
        if let Some((_, buffer, ..)) = &parameters {
            gpu.queue.write_buffer(buffer, 0, uniform);
        }
        let groups = [parameters.as_ref().map(|(layout, ..)| layout), Some(&layout)];
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &groups,
            immediate_size: 0,
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("expression"),
            layout: Some(&pipeline_layout),
            module: &device.create_shader_module(shader.descriptor()),
            entry_point: Some(ENTRY),
            compilation_options: Default::default(),
            cache: None,
        });
        let buffer = |words: usize, usage| {
            let size = words.max(1) as u64 * 4;
            device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        use wgpu::BufferUsages as Usage;
        let input = buffer(inputs, Usage::STORAGE | Usage::COPY_DST);
        let output = buffer(outputs, Usage::STORAGE | Usage::COPY_SRC);
        let readback = buffer(outputs, Usage::MAP_READ | Usage::COPY_DST);
        let uniform = parameters.map(|(_, _, group, number)| (group, number));
        Self { pipeline, layout, uniform, input, output, readback }
    }

    /// The dispatch for `count` points with these bytes, `len` bytes of results, and their copy to where they are read.
    fn commands(&self, gpu: &Gpu, points: &[u8], count: usize, len: u64) -> wgpu::CommandEncoder {
        gpu.queue.write_buffer(&self.input, 0, points);
        let results =
            wgpu::BufferBinding { buffer: &self.output, offset: 0, size: wgpu::BufferSize::new(len) };
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("points"),
            layout: &self.layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: self.input.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Buffer(results) },
            ],
        });
        let mut commands = gpu.device.create_command_encoder(&Default::default());
        let mut pass = commands.begin_compute_pass(&Default::default());
        pass.set_pipeline(&self.pipeline);
        if let Some((group, number)) = &self.uniform {
            pass.set_bind_group(*number, group, &[]);
        }
        pass.set_bind_group(GROUP, &group, &[]);
        pass.dispatch_workgroups(count.div_ceil(WORKGROUP as usize) as u32, 1, 1);
        drop(pass);
        commands.copy_buffer_to_buffer(&self.output, 0, &self.readback, 0, len);
        commands
    }
}
