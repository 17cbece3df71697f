//! All that this engine has for Orogen's sake: its shaders, composed with Orogen's land, and the land's live parameters.

use orogen::render::{Gpu, Shot, set_frame};
use orogen::sample::Sampler;
use orogen::{Bake, Error, Library, Preset, Shader};

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

/// The engine's shader module, and the uniform buffer of what the land lets be turned while it runs.
pub struct Landscape {
    pub module: wgpu::ShaderModule,
    pub params: wgpu::Buffer,
    pub shader: Shader,
    pub preset: Preset,
}

/// The engine's own folder of shaders, laid over Orogen's.
pub fn library() -> Fallible<Library> {
    Ok(Library::standard().with_folder(concat!(env!("CARGO_MANIFEST_DIR"), "/wgsl"))?)
}

/// The sun can be turned; the rest is baked in. Group 0 is the engine's.
pub fn bake() -> Bake {
    Bake::live(["sun.*", "camera.focal_length"]).at_binding(1, 0)
}

impl Landscape {
    pub fn new(device: &wgpu::Device, shader: Shader, preset: Preset) -> Self {
        let module = device.create_shader_module(shader.descriptor());
        let params = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("land"),
            size: shader.interface().uniform.as_ref().map_or(16, |uniform| uniform.size.into()),
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Self { module, params, shader, preset }
    }

    /// Tells the land how large the picture is (how small a detail can be seen), and what its live parameters are now.
    pub fn write(&self, queue: &wgpu::Queue, size: [u32; 2], live: &[(&str, f32)]) -> Result<(), Error> {
        let mut preset = self.preset.clone();
        live.iter().try_for_each(|(name, value)| preset.set(&format!("{name}={value}")))?;
        let mut bytes = self.shader.uniform_bytes(&preset)?;
        if let Some(uniform) = &self.shader.interface().uniform {
            set_frame(&mut bytes, uniform, &Shot::new(size[0], size[1]), [0.0, 0.0]);
        }
        queue.write_buffer(&self.params, 0, &bytes);
        Ok(())
    }

    /// The land's answers on the engine's own device: where the ground is, which way the sun.
    pub fn sampler(&self, gpu: &Gpu, what: &str, columns: &[&str]) -> Fallible<Sampler> {
        Ok(Sampler::new(gpu, &library()?, &self.preset, what, columns)?)
    }
}
