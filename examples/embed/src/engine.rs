//! The engine: a frame of shadow map, meshes, land and display, over one depth buffer.

use bytemuck::{Pod, Zeroable, bytes_of, cast_slice};
use glam::camera::rh::proj::directx::orthographic;
use glam::camera::rh::view::look_to_mat4;
use glam::{Mat4, Quat, Vec2, Vec3};
use orogen::render::Gpu;
use orogen::sample::Sampler;
use orogen::{Preset, Shader};

use crate::camera::Camera;
use crate::landscape::Landscape;
use crate::pipelines::{DEPTH, LIGHT, Layouts, Pipelines, THING};
use crate::tower::{self, Vertex};

/// A thing in the world: the engine's mesh, somewhere.
#[derive(Debug, Clone, Copy)]
pub struct Thing {
    /// Its foot (m).
    pub foot: Vec3,
    /// Which way its door looks, clockwise from south (rad).
    pub heading: f32,
    /// How many times its mesh it is large.
    pub scale: f32,
}

/// As many as the shaders take.
pub const THINGS: usize = 2;
/// Pixels of the shadow map, each way.
const SHADOW: u32 = 2048;

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct ThingUniform {
    foot: Vec3,
    scale: f32,
    turn: Vec2,
    _pad: [f32; 2],
    sun: Mat4,
}

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct ViewUniform {
    clip_from_eye: Mat4,
    eye_from_clip: Mat4,
    eye: Vec3,
    _pad: f32,
    size: Vec2,
    _pad2: [f32; 2],
    things: [ThingUniform; THINGS],
}

/// What a frame is drawn into.
pub struct Targets {
    pub light: wgpu::Texture,
    pub thing: wgpu::Texture,
    pub depth: wgpu::Texture,
    display: wgpu::BindGroup,
    /// Pixels of light: those of the display, times the samples, or fewer where several share one.
    pub size: [u32; 2],
    samples: u32,
}

/// Device, shaders, meshes and things.
pub struct Engine {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
    pub gpu: Gpu,
    landscape: Landscape,
    layouts: Layouts,
    pipelines: Pipelines,
    mesh: wgpu::Buffer,
    corners: u32,
    view: wgpu::Buffer,
    shadow: wgpu::Texture,
    view_group: wgpu::BindGroup,
    land_group: wgpu::BindGroup,
    shadow_group: wgpu::BindGroup,
    pub things: [Thing; THINGS],
    ground: Sampler,
    to_sun: Vec3,
    /// The sun's, clockwise from north (degrees), once it was turned.
    azimuth: Option<f32>,
}

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

impl Engine {
    /// `display` is the format of what is drawn onto. The things are put up by [`Engine::stand`].
    pub fn new(
        device: wgpu::Device,
        queue: wgpu::Queue,
        landscape: Landscape,
        display: wgpu::TextureFormat,
    ) -> Fallible<Self> {
        use wgpu::BufferUsages as Usage;
        let layouts = Layouts::new(&device, display);
        let pipelines = Pipelines::new(&device, &layouts, &landscape.module);
        let tower = tower::tower();
        let buffer = |size: usize, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: size as u64,
                usage: usage | Usage::COPY_DST,
                mapped_at_creation: false,
            })
        };
        let mesh = buffer(size_of::<Vertex>() * tower.len(), Usage::VERTEX);
        queue.write_buffer(&mesh, 0, cast_slice(&tower));
        let view = buffer(size_of::<ViewUniform>(), Usage::UNIFORM);
        let shadow = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("shadow map"),
            size: wgpu::Extent3d { width: SHADOW, height: SHADOW, depth_or_array_layers: THINGS as u32 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: DEPTH,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let view_group = layouts.bind_buffer(&device, &layouts.view, &view);
        let land_group = layouts.bind_buffer(&device, &layouts.land, &landscape.params);
        let shadow_group = layouts.bind_shadow(&device, &shadow);
        let gpu = Gpu::of(&device, &queue);
        let corners = tower.len() as u32;
        let things = [Thing { foot: Vec3::ZERO, heading: 0.0, scale: 1.0 }; THINGS];
        let (ground, to_sun) = asked(&gpu, &landscape)?;
        Ok(Self {
            device,
            queue,
            gpu,
            landscape,
            layouts,
            pipelines,
            mesh,
            corners,
            view,
            shadow,
            view_group,
            land_group,
            shadow_group,
            things,
            ground,
            to_sun,
            azimuth: None,
        })
    }

    /// Puts another landscape in: the shaders are new, the meshes are not. One whose shaders do not fit the engine changes
    /// nothing.
    pub fn set_landscape(&mut self, landscape: Landscape) -> Fallible<()> {
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let pipelines = Pipelines::new(&self.device, &self.layouts, &landscape.module);
        if let Some(error) = pollster::block_on(scope.pop()) {
            return Err(error.to_string().into());
        }
        self.pipelines = pipelines;
        self.land_group = self.layouts.bind_buffer(&self.device, &self.layouts.land, &landscape.params);
        self.landscape = landscape;
        self.settle()
    }

    /// Draws with a preset's other values from now on, where `shader` is the one that is drawn with already: nothing is
    /// compiled for them. Whether it is; ground and sun are to be asked for anew then, by [`Engine::settle`].
    pub fn retune(&mut self, shader: &Shader, preset: &Preset) -> bool {
        let is_same = self.landscape.shader.wgsl() == shader.wgsl();
        if is_same {
            self.landscape.preset = preset.clone();
        }
        is_same
    }

    /// Asks the landscape anew where the ground and the sun are.
    pub fn settle(&mut self) -> Fallible<()> {
        (self.ground, self.to_sun) = asked(&self.gpu, &self.landscape)?;
        self.azimuth = None;
        Ok(())
    }

    /// Moves the sun so far around the horizon (degrees).
    pub fn turn_sun(&mut self, by: f32) {
        self.to_sun = Quat::from_rotation_y(-by.to_radians()) * self.to_sun;
        self.azimuth = Some(self.to_sun.x.atan2(-self.to_sun.z).to_degrees());
    }

    /// Unit vector to the sun.
    pub fn to_sun(&self) -> Vec3 {
        self.to_sun
    }

    /// Heights of the ground (m) at these places, east and south.
    pub fn ground(&mut self, places: &[[f32; 2]]) -> Fallible<Vec<f32>> {
        let found: Vec<[f32; 1]> = self.ground.run(places)?;
        Ok(found.into_iter().flatten().collect())
    }

    /// Stands a thing on the ground: as deep in it as its lowest corner needs.
    pub fn stand(&mut self, index: usize, at: [f32; 2], heading: f32, scale: f32) -> Fallible<()> {
        let half = 3.0 * scale;
        let around = [[0.0, 0.0], [half, half], [-half, half], [half, -half], [-half, -half]];
        let heights = self.ground(&around.map(|[x, z]| [at[0] + x, at[1] + z]))?;
        let lowest = heights.iter().copied().fold(f32::MAX, f32::min);
        let y = (heights[0] - 0.5 * scale).max(lowest).min(heights[0]);
        self.things[index] = Thing { foot: Vec3::new(at[0], y, at[1]), heading, scale };
        Ok(())
    }

    /// Room for pictures of `size` on the display, each pixel of it the mean of `samples`² of light.
    pub fn targets(&self, size: [u32; 2], samples: u32, exposure: f32) -> Targets {
        self.targets_of(size.map(|side| side * samples), [samples, 1], exposure)
    }

    /// Room for pictures of `size` on the display, where blocks of `block`² pixels show the same light.
    pub fn rough_targets(&self, size: [u32; 2], block: u32, exposure: f32) -> Targets {
        self.targets_of(size.map(|side| side.div_ceil(block)), [1, block], exposure)
    }

    fn targets_of(&self, [width, height]: [u32; 2], share: [u32; 2], exposure: f32) -> Targets {
        let texture = |label, format| {
            self.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                    | wgpu::TextureUsages::TEXTURE_BINDING
                    | wgpu::TextureUsages::COPY_SRC,
                view_formats: &[],
            })
        };
        let light = texture("light", LIGHT);
        let display = self.layouts.bind_display(&self.device, &self.queue, &light, exposure, share);
        let (thing, depth) = (texture("things", THING), texture("depth", DEPTH));
        Targets { light, thing, depth, display, size: [width, height], samples: share[0] }
    }

    /// Draws a frame into `targets`, and brings it onto `display`.
    pub fn draw(&self, camera: &Camera, targets: &Targets, display: &wgpu::TextureView) -> Fallible<()> {
        self.queue.write_buffer(&self.view, 0, bytes_of(&self.view(camera, targets.size)));
        let mut live = vec![("camera.focal_length", camera.focal_length)];
        live.extend(self.azimuth.map(|azimuth| ("sun.azimuth", azimuth)));
        self.landscape.write(&self.queue, targets.size, &live)?;
        let mut commands = self.device.create_command_encoder(&Default::default());
        self.draw_shadows(&mut commands);
        self.draw_world(&mut commands, targets);
        self.draw_display(&mut commands, targets, display);
        self.queue.submit([commands.finish()]);
        Ok(())
    }

    /// The things, as the sun sees each of them.
    fn draw_shadows(&self, commands: &mut wgpu::CommandEncoder) {
        for index in 0..THINGS as u32 {
            let layer = self.shadow.create_view(&wgpu::TextureViewDescriptor {
                dimension: Some(wgpu::TextureViewDimension::D2),
                base_array_layer: index,
                array_layer_count: Some(1),
                ..Default::default()
            });
            let mut pass = commands.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("shadows"),
                color_attachments: &[],
                depth_stencil_attachment: Some(depth(&layer, 1.0)),
                timestamp_writes: None,
                occlusion_query_set: None,
                multiview_mask: None,
            });
            pass.set_pipeline(&self.pipelines.shadow);
            pass.set_bind_group(0, &self.view_group, &[]);
            pass.set_vertex_buffer(0, self.mesh.slice(..));
            pass.draw(0..self.corners, index..index + 1);
        }
    }

    /// The things and then the land: whoever is nearer stays, whichever comes first.
    fn draw_world(&self, commands: &mut wgpu::CommandEncoder, targets: &Targets) {
        let [light, thing, deep] = [&targets.light, &targets.thing, &targets.depth]
            .map(|texture| texture.create_view(&Default::default()));
        let mut pass = commands.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("world"),
            color_attachments: &[Some(color(&light)), Some(color(&thing))],
            depth_stencil_attachment: Some(depth(&deep, 0.0)),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        for (index, group) in [&self.view_group, &self.land_group, &self.shadow_group].into_iter().enumerate()
        {
            pass.set_bind_group(index as u32, group, &[]);
        }
        pass.set_pipeline(&self.pipelines.things);
        pass.set_vertex_buffer(0, self.mesh.slice(..));
        pass.draw(0..self.corners, 0..THINGS as u32);
        pass.set_pipeline(&self.pipelines.land);
        pass.draw(0..3, 0..1);
    }

    fn draw_display(
        &self,
        commands: &mut wgpu::CommandEncoder,
        targets: &Targets,
        display: &wgpu::TextureView,
    ) {
        let mut pass = commands.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("display"),
            color_attachments: &[Some(color(display))],
            depth_stencil_attachment: None,
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        pass.set_pipeline(&self.layouts.display_pipeline);
        pass.set_bind_group(0, &targets.display, &[]);
        pass.draw(0..3, 0..1);
    }

    fn view(&self, camera: &Camera, size: [u32; 2]) -> ViewUniform {
        let size = Vec2::new(size[0] as f32, size[1] as f32);
        let (clip_from_eye, eye_from_clip) = camera.clip_from_eye(size.x / size.y);
        let things = self.things.map(|thing| {
            let radius = 9.0 * thing.scale;
            let middle = Vec3::Y * 0.5 * tower::HEIGHT * thing.scale;
            let up = if self.to_sun.y.abs() > 0.99 { Vec3::X } else { Vec3::Y };
            let from_sun = look_to_mat4(middle + radius * self.to_sun, -self.to_sun, up);
            let sun = orthographic(-radius, radius, -radius, radius, 0.0, 2.0 * radius) * from_sun;
            let turn = Vec2::new(thing.heading.cos(), thing.heading.sin());
            ThingUniform { foot: thing.foot, scale: thing.scale, turn, _pad: [0.0; 2], sun }
        });
        ViewUniform {
            clip_from_eye,
            eye_from_clip,
            eye: camera.eye,
            _pad: 0.0,
            size,
            _pad2: [0.0; 2],
            things,
        }
    }
}

/// The ground, to be asked for heights, and where the sun is.
fn asked(gpu: &Gpu, landscape: &Landscape) -> Fallible<(Sampler, Vec3)> {
    let ground = landscape.sampler(gpu, "terrain_height(p)", &["x", "y"])?;
    let [to_sun] = landscape.sampler(gpu, "key_direction()", &[])?.run(&[[]])?[..] else {
        return Err("there is one sun".into());
    };
    Ok((ground, Vec3::from_array(to_sun)))
}

impl Targets {
    /// Pixels of light for each of the display's, each way.
    pub fn samples(&self) -> u32 {
        self.samples
    }
}

fn color(view: &wgpu::TextureView) -> wgpu::RenderPassColorAttachment<'_> {
    let ops =
        wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT), store: wgpu::StoreOp::Store };
    wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops }
}

fn depth(view: &wgpu::TextureView, far: f32) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    let ops = wgpu::Operations { load: wgpu::LoadOp::Clear(far), store: wgpu::StoreOp::Store };
    wgpu::RenderPassDepthStencilAttachment { view, depth_ops: Some(ops), stencil_ops: None }
}
