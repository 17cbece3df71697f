//! A shader and its points → the bits of the results, in as many dispatches as bounded buffers take.

use super::super::adapter::Gpu;
use super::super::draw::bound;
use super::super::error::RenderError;
use super::text::{ENTRY, GROUP, WORKGROUP};
use crate::shader::Shader;

/// The most points that one dispatch takes.
const MOST_POINTS: usize = 1 << 18;
/// The most bytes that a buffer takes.
const MOST_BYTES: usize = 32 << 20;

/// A compiled expression: for each point it takes `columns` words, and gives `width`.
pub(super) struct Kernel {
    columns: usize,
    width: usize,
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
    uniform: Option<(wgpu::BindGroup, u32)>,
    /// As large as the largest batch yet.
    buffers: Option<Buffers>,
}

struct Buffers {
    /// How many points they have room for.
    points: usize,
    input: wgpu::Buffer,
    output: wgpu::Buffer,
    readback: wgpu::Buffer,
}

impl Kernel {
    /// Compiles `shader`, with these bytes in its uniform buffer.
    pub(super) fn new(
        gpu: &Gpu,
        shader: &Shader,
        uniform: &[u8],
        columns: usize,
        width: usize,
    ) -> Result<Self, RenderError> {
        gpu.scoped(|| {
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
            let uniform = parameters.map(|(_, _, group, number)| (group, number));
            Ok(Self { columns, width, pipeline, layout, uniform, buffers: None })
        })
    }

    /// The results' words at the points whose words these are; without columns, those of one evaluation.
    pub(super) fn run(&mut self, gpu: &Gpu, words: &[u32]) -> Result<Vec<u32>, RenderError> {
        let (columns, width) = (self.columns, self.width);
        let count = words.len().checked_div(columns).unwrap_or(1);
        if width == 0 || count == 0 {
            return Ok(Vec::new());
        }
        let widest = columns.max(width);
        let batch = MOST_POINTS.min(MOST_BYTES / (4 * widest)).min(count).max(1);
        if self.buffers.as_ref().is_none_or(|buffers| buffers.points < batch) {
            self.buffers = Some(gpu.scoped(|| Ok(buffers(gpu, batch, columns, width)))?);
        }
        let Some(buffers) = &self.buffers else { return Ok(Vec::new()) };
        let mut results = Vec::new();
        results.try_reserve_exact(count * width).map_err(|_| RenderError::OutOfMemory)?;
        for first in (0..count).step_by(batch) {
            let here = batch.min(count - first);
            let points: Vec<u8> = words[first * columns..(first + here) * columns]
                .iter()
                .flat_map(|word| word.to_le_bytes())
                .collect();
            let len = (here * width * 4) as u64;
            let commands = gpu.scoped(|| Ok(self.commands(gpu, buffers, &points, here, len)))?;
            gpu.submit_and_read(commands, &buffers.readback, len, |bytes| {
                let words = bytes.chunks_exact(4);
                results.extend(words.map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])));
            })?;
        }
        Ok(results)
    }

    /// The dispatch for `count` points with these bytes, `len` bytes of results, and their copy to where they are read.
    fn commands(
        &self,
        gpu: &Gpu,
        buffers: &Buffers,
        points: &[u8],
        count: usize,
        len: u64,
    ) -> wgpu::CommandEncoder {
        gpu.queue.write_buffer(&buffers.input, 0, points);
        let results =
            wgpu::BufferBinding { buffer: &buffers.output, offset: 0, size: wgpu::BufferSize::new(len) };
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("points"),
            layout: &self.layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: buffers.input.as_entire_binding() },
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
        commands.copy_buffer_to_buffer(&buffers.output, 0, &buffers.readback, 0, len);
        commands
    }
}

fn buffers(gpu: &Gpu, points: usize, columns: usize, width: usize) -> Buffers {
    use wgpu::BufferUsages as Usage;
    let buffer = |words: usize, usage| {
        let size = (points * words).max(1) as u64 * 4;
        let mapped_at_creation = false;
        gpu.device.create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation })
    };
    Buffers {
        points,
        input: buffer(columns, Usage::STORAGE | Usage::COPY_DST),
        output: buffer(width, Usage::STORAGE | Usage::COPY_SRC),
        readback: buffer(width, Usage::MAP_READ | Usage::COPY_DST),
    }
}
