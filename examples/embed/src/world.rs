//! The world that is shown: a device, the landscape of `valley.json`, two towers, and where they are seen from.

use glam::Vec3;
use orogen::{Bake, Preset};

use crate::camera::Camera;
use crate::engine::Engine;
use crate::landscape::{self, Landscape};

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

/// The preset that says what the land is like.
pub const PRESET: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/valley.json");
/// The display's factor on light, of which 1 is white.
pub const EXPOSURE: f32 = 2.0;
/// Where the towers stand (m, east and south), which way their doors look (degrees, clockwise from south), and how large.
const TOWERS: [([f32; 2], f32, f32); 2] = [([-9480.0, -6980.0], 20.0, 1.0), ([-9706.0, -7987.0], 30.0, 2.0)];
/// The eye (m: east, over the ground, south), what it looks at (m over the first tower's foot), and the lens (mm).
const EYE: ([f32; 3], f32, f32) = ([-9440.0, 8.0, -6920.0], 8.0, 35.0);

/// A GPU, or a software one, that can draw onto `surface` if there is one.
pub fn device(
    instance: &wgpu::Instance,
    surface: Option<&wgpu::Surface<'_>>,
) -> Fallible<(wgpu::Adapter, wgpu::Device, wgpu::Queue)> {
    let options = wgpu::RequestAdapterOptions { compatible_surface: surface, ..Default::default() };
    let adapter = pollster::block_on(instance.request_adapter(&options))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))?;
    Ok((adapter, device, queue))
}

/// The preset as it is now, with what the command line sets.
pub fn preset(set: &[String]) -> Result<Preset, orogen::Error> {
    let mut preset = Preset::file(PRESET)?;
    set.iter().try_for_each(|assignment| preset.set(assignment))?;
    Ok(preset)
}

/// The engine with its world baked in as `bake` says, for a display of this format.
pub fn engine(
    device: wgpu::Device,
    queue: wgpu::Queue,
    display: wgpu::TextureFormat,
    set: &[String],
    bake: &Bake,
) -> Fallible<Engine> {
    let preset = preset(set)?;
    let shader = orogen::compose(&landscape::library()?, &preset, bake)?;
    let landscape = Landscape::new(&device, shader, preset);
    let mut engine = Engine::new(device, queue, landscape, display)?;
    stand(&mut engine)?;
    Ok(engine)
}

/// Puts the towers where they belong, on the ground as it is now.
pub fn stand(engine: &mut Engine) -> Fallible<()> {
    for (index, (at, heading, scale)) in TOWERS.into_iter().enumerate() {
        engine.stand(index, at, heading.to_radians(), scale)?;
    }
    Ok(())
}

/// Where the first picture is taken from.
pub fn camera(engine: &mut Engine) -> Fallible<Camera> {
    let ([east, above, south], height, focal_length) = EYE;
    let ground = engine.ground(&[[east, south]])?;
    let eye = Vec3::new(east, ground.first().ok_or("there is ground everywhere")? + above, south);
    Ok(Camera::looking_at(eye, engine.things[0].foot + height * Vec3::Y, focal_length))
}
