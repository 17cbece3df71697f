//! Embed: a host's own compute shader, in the host's own folder, includes Orogen's land and draws a map of it as text.
//!
//! `cargo run --example host_shader` needs a GPU adapter; a software one (lavapipe) will do.

#![allow(clippy::print_stdout, reason = "an example shows what it does")]

use orogen::{Bake, Library, Preset};
use wgpu::util::DeviceExt;

const COLUMNS: usize = 72;
const ROWS: usize = 28;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let here = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/host");
    let preset = Preset::file(format!("{here}/relief.json"))?;
    let bake = Bake::live(["map.*"]); // the rest is baked in; the uniform buffer is at group 0, binding 0
    let shader = orogen::compose(&Library::standard(), &preset, &bake)?;

    let (device, queue) = device()?;
    let module = device.create_shader_module(shader.descriptor());
    let params = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: None,
        contents: &shader.uniform_bytes(&preset)?,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
    });

    // From here on, nothing knows of Orogen.
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("map"),
        layout: None,
        module: &module,
        entry_point: Some("measure"),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });
    let size = (COLUMNS * ROWS * 8) as u64;
    let buffer = |usage| {
        device.create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false })
    };
    let cells = buffer(wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
    let readback = buffer(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
    let bind = |group, buffer: &wgpu::Buffer| {
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(group),
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }],
        })
    };
    let groups = [bind(0, &params), bind(1, &cells)];
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&pipeline);
        for (index, group) in groups.iter().enumerate() {
            pass.set_bind_group(index as u32, group, &[]);
        }
        pass.dispatch_workgroups((COLUMNS * ROWS).div_ceil(64) as u32, 1, 1);
    }
    encoder.copy_buffer_to_buffer(&cells, 0, &readback, 0, size);
    queue.submit([encoder.finish()]);
    readback.slice(..).map_async(wgpu::MapMode::Read, |_| {});
    device.poll(wgpu::PollType::wait_indefinitely())?;

    let bytes = readback.slice(..).get_mapped_range()?;
    let numbers: Vec<f32> =
        bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
    let heights = || numbers.iter().step_by(2).copied();
    let (low, high) = (heights().fold(f32::MAX, f32::min), heights().fold(f32::MIN, f32::max));
    for row in numbers.chunks(COLUMNS * 2) {
        let shades: Vec<char> = " .:-=+*#%@".chars().collect();
        let shade = |light: f32| shades[((light * 0.999).clamp(0.0, 0.999) * shades.len() as f32) as usize];
        println!("{}", row.chunks(2).map(|cell| shade(cell[1])).collect::<String>());
    }
    println!("from {low:.0} m to {high:.0} m");
    if high > low { Ok(()) } else { Err("the land is flat".into()) }
}

fn device() -> Result<(wgpu::Device, wgpu::Queue), Box<dyn std::error::Error>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
    Ok(pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))?)
}
