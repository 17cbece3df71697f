//! Bind group layouts and pipelines of the engine.

use wgpu::{BindingType, CompareFunction, ShaderStages};

use crate::tower::Vertex;

/// Light, before the display.
pub(crate) const LIGHT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Whose a pixel is: 0 the land's, else 1 + the thing's number.
pub(crate) const THING: wgpu::TextureFormat = wgpu::TextureFormat::R32Uint;
/// Reversed: 1 near, 0 far.
pub(crate) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// What is bound where, and the one pipeline that has nothing to do with the world.
pub(crate) struct Layouts {
    /// Group 0.
    pub view: wgpu::BindGroupLayout,
    /// Group 1: Orogen's.
    pub land: wgpu::BindGroupLayout,
    /// Group 2.
    pub shadow: wgpu::BindGroupLayout,
    display: wgpu::BindGroupLayout,
    pub display_pipeline: wgpu::RenderPipeline,
    compare: wgpu::Sampler,
}

/// The pipelines of the world, which are made anew when its shaders are.
pub(crate) struct Pipelines {
    pub shadow: wgpu::RenderPipeline,
    pub things: wgpu::RenderPipeline,
    pub land: wgpu::RenderPipeline,
}

impl Layouts {
    pub(crate) fn new(device: &wgpu::Device, display_format: wgpu::TextureFormat) -> Self {
        let layout = |label, types: &[BindingType]| {
            let entries: Vec<_> = (0..)
                .zip(types)
                .map(|(binding, ty)| wgpu::BindGroupLayoutEntry {
                    binding,
                    visibility: ShaderStages::VERTEX_FRAGMENT,
                    ty: *ty,
                    count: None,
                })
                .collect();
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some(label),
                entries: &entries,
            })
        };
        let uniform = BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        };
        let texture = |sample_type, view_dimension| BindingType::Texture {
            sample_type,
            view_dimension,
            multisampled: false,
        };
        let shadow = [
            texture(wgpu::TextureSampleType::Depth, wgpu::TextureViewDimension::D2Array),
            BindingType::Sampler(wgpu::SamplerBindingType::Comparison),
        ];
        let unfiltered = wgpu::TextureSampleType::Float { filterable: false };
        let display = layout("display", &[texture(unfiltered, wgpu::TextureViewDimension::D2), uniform]);
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("display"),
            source: wgpu::ShaderSource::Wgsl(include_str!("../wgsl/display.wgsl").into()),
        });
        let display_pipeline = pipeline(
            device,
            &Draw {
                label: "display",
                module: &module,
                vertex: "display_vertex",
                fragment: Some("display_fragment"),
                groups: &[&display],
                targets: &[display_format],
                depth: None,
                has_mesh: false,
            },
        );
        let compare = device.create_sampler(&wgpu::SamplerDescriptor {
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            compare: Some(CompareFunction::LessEqual),
            ..Default::default()
        });
        Self {
            view: layout("view", &[uniform]),
            land: layout("land", &[uniform]),
            shadow: layout("shadow", &shadow),
            display,
            display_pipeline,
            compare,
        }
    }

    pub(crate) fn bind_buffer(
        &self,
        device: &wgpu::Device,
        layout: &wgpu::BindGroupLayout,
        buffer: &wgpu::Buffer,
    ) -> wgpu::BindGroup {
        bind(device, layout, &[buffer.as_entire_binding()])
    }

    pub(crate) fn bind_shadow(&self, device: &wgpu::Device, map: &wgpu::Texture) -> wgpu::BindGroup {
        let view = map.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2Array),
            ..Default::default()
        });
        let resources =
            [wgpu::BindingResource::TextureView(&view), wgpu::BindingResource::Sampler(&self.compare)];
        bind(device, &self.shadow, &resources)
    }

    pub(crate) fn bind_display(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        light: &wgpu::Texture,
        exposure: f32,
        [samples, block]: [u32; 2],
    ) -> wgpu::BindGroup {
        let settings = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("display"),
            size: 12,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&settings, 0, bytemuck::cast_slice(&[exposure.to_bits(), samples, block]));
        let view = light.create_view(&Default::default());
        bind(
            device,
            &self.display,
            &[wgpu::BindingResource::TextureView(&view), settings.as_entire_binding()],
        )
    }
}

impl Pipelines {
    pub(crate) fn new(device: &wgpu::Device, layouts: &Layouts, module: &wgpu::ShaderModule) -> Self {
        let all = [&layouts.view, &layouts.land, &layouts.shadow];
        let world = Draw {
            label: "things",
            module,
            vertex: "thing_vertex",
            fragment: Some("thing_fragment"),
            groups: &all,
            targets: &[LIGHT, THING],
            depth: Some(CompareFunction::Greater),
            has_mesh: true,
        };
        let land = Draw {
            label: "land",
            vertex: "land_vertex",
            fragment: Some("land_fragment"),
            has_mesh: false,
            ..world
        };
        let shadow = Draw {
            label: "shadow",
            vertex: "thing_shadow_vertex",
            fragment: None,
            groups: &all[..1],
            targets: &[],
            depth: Some(CompareFunction::Less),
            ..world
        };
        Self {
            shadow: pipeline(device, &shadow),
            things: pipeline(device, &world),
            land: pipeline(device, &land),
        }
    }
}

struct Draw<'a> {
    label: &'a str,
    module: &'a wgpu::ShaderModule,
    vertex: &'a str,
    fragment: Option<&'a str>,
    groups: &'a [&'a wgpu::BindGroupLayout],
    targets: &'a [wgpu::TextureFormat],
    depth: Option<CompareFunction>,
    has_mesh: bool,
}

fn pipeline(device: &wgpu::Device, draw: &Draw<'_>) -> wgpu::RenderPipeline {
    let groups: Vec<_> = draw.groups.iter().map(|group| Some(*group)).collect();
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(draw.label),
        bind_group_layouts: &groups,
        immediate_size: 0,
    });
    let attributes = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Uint32];
    let mesh = [Some(wgpu::VertexBufferLayout {
        array_stride: size_of::<Vertex>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &attributes,
    })];
    let targets: Vec<_> = draw.targets.iter().map(|format| Some((*format).into())).collect();
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(draw.label),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: draw.module,
            entry_point: Some(draw.vertex),
            compilation_options: Default::default(),
            buffers: if draw.has_mesh { &mesh } else { &[] },
        },
        primitive: wgpu::PrimitiveState {
            cull_mode: (draw.has_mesh && draw.fragment.is_some()).then_some(wgpu::Face::Back),
            ..Default::default()
        },
        depth_stencil: draw.depth.map(|compare| wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(compare),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: Default::default(),
        fragment: draw.fragment.map(|entry_point| wgpu::FragmentState {
            module: draw.module,
            entry_point: Some(entry_point),
            compilation_options: Default::default(),
            targets: &targets,
        }),
        multiview_mask: None,
        cache: None,
    })
}

fn bind(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    resources: &[wgpu::BindingResource<'_>],
) -> wgpu::BindGroup {
    let entries: Vec<_> = (0..)
        .zip(resources)
        .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource: resource.clone() })
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
}
