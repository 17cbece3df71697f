//! An expression, compiled once → its values at any points, batch after batch.

use super::super::adapter::Gpu;
use super::super::draw::only_bound_here;
use super::dispatch::Kernel;
use super::error::SampleError;
use super::layout::Leaf;
use super::value::{self, Column, Kind, Points, Scalar, Table};
use super::{Query, composed, expression, layout, preset, text};
use crate::diagnostic::Error;
use crate::preset::Preset;
use crate::shader::Compose;
use crate::source::{Library, Templates};

/// An expression that is ready to be evaluated, as often as is wanted: composing and compiling are done.
///
/// A host makes one for the heights that its physics asks for, and one for the normals that its meshes stand on:
///
/// ```
/// use orogen::render::Gpu;
/// use orogen::sample::Sampler;
/// use orogen::{Library, Preset};
///
/// # fn device() -> Result<(wgpu::Device, wgpu::Queue), Box<dyn std::error::Error>> {
/// #     let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
/// #     let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
/// #     Ok(pollster::block_on(adapter.request_device(&Default::default()))?)
/// # }
/// let (device, queue) = device()?; // the host's own
/// let (library, preset) = (Library::standard(), Preset::named("alpine")?);
///
/// let gpu = Gpu::of(&device, &queue);
/// let mut land = Sampler::new(&gpu, &library, &preset, "terrain_height_grad(p)", &["x", "y"])?;
/// for [height, to_east, to_south] in land.run(&[[-9570.0, -6988.0], [0.0, 250.0]])? {
///     let normal = [-to_east, 1.0, -to_south]; // not yet of unit length
///     assert!(height > -500.0 && height < 4000.0 && normal[1] > 0.0);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Sampler {
    gpu: Gpu,
    kernel: Kernel,
    columns: Vec<Column>,
    leaves: Vec<Leaf>,
}

impl Sampler {
    /// Compiles `expression` over f32 columns of these names, with the values of `preset`. Every name of the preset's scene
    /// is known to it; columns `x`, `y` (and `z`, `w`) also make the vector `p`.
    ///
    /// # Errors
    /// What is wrong with the expression, the preset or the columns' names; and what wgpu or the driver refuses.
    pub fn new(
        gpu: &Gpu,
        library: &Library,
        preset: &Preset,
        expression: &str,
        columns: &[&str],
    ) -> Result<Self, Error> {
        let columns = columns.iter().map(|name| Column { name: (*name).to_owned(), kind: Kind::F32 });
        let points = Points { columns: columns.collect(), values: Vec::new() };
        let query = Query { expression, includes: &[], preset: Some(preset), points: &points };
        Self::of(gpu, library, &Templates::standard(), &query)
    }

    /// Compiles the expression of `query` over the columns of its points. The points themselves are left alone.
    ///
    /// # Errors
    /// As [`Sampler::new`].
    pub fn of(gpu: &Gpu, library: &Library, templates: &Templates, query: &Query<'_>) -> Result<Self, Error> {
        expression::check(query.expression)?;
        text::check_includes(query.includes)?;
        value::check(query.points)?;
        let mut compose = Compose::default();
        compose.templates = templates.clone();
        let probe = text::root(query, None);
        let shader = composed(&mut compose, library, query, &probe)?;
        let leaves = layout::leaves(shader.checked(), text::ENTRY, text::VALUE)
            .map_err(|error| text::whole(query.expression, error))?;
        let root = text::root(query, Some(&leaves));
        let shader = composed(&mut compose, library, query, &root)?;
        let uniform = shader.uniform_bytes(&preset(query, &root))?;
        let columns = query.points.columns.clone();
        let kernel = gpu.guarded(|| {
            let entries = shader.interface().entry_points.iter();
            let used: Vec<_> = entries.enumerate().filter(|(_, entry)| entry.name == text::ENTRY).collect();
            let used: Vec<_> = used.into_iter().map(|(index, _)| index).collect();
            only_bound_here(&shader, &used, &[text::INPUT, text::OUTPUT])?;
            Kernel::new(gpu, &shader, &uniform, columns.len(), leaves.len())
        })?;
        Ok(Self { gpu: gpu.clone(), kernel, columns, leaves })
    }

    /// The values at `points`, one for each, in their order. Waits for the GPU.
    ///
    /// A point has a number for each column. A value has one for each component: 1 for an f32, 3 for a vec3f.
    ///
    /// # Errors
    /// Where the columns are not `N` f32 ones, or the value is not made of `M` f32 components; and what wgpu or the driver
    /// refuses.
    pub fn run<const N: usize, const M: usize>(
        &mut self,
        points: &[[f32; N]],
    ) -> Result<Vec<[f32; M]>, Error> {
        let names = |names: &mut dyn Iterator<Item = String>| names.collect::<Vec<_>>().join(", ");
        if N != self.columns.len() || self.columns.iter().any(|column| column.kind != Kind::F32) {
            let columns = names(&mut self.columns.iter().map(|c| format!("{}: {}", c.name, c.kind.name())));
            let why = format!("each is {N} f32, and the expression takes ({columns})");
            return Err(SampleError::Points { why }.into());
        }
        if M != self.leaves.len() || self.leaves.iter().any(|leaf| leaf.kind != Kind::F32) {
            let value = names(&mut self.leaves.iter().map(|l| format!("{}: {}", l.name, l.kind.name())));
            return Err(SampleError::Results { asked: M, value }.into());
        }
        let words: Vec<u32> = points.iter().flatten().map(|number| number.to_bits()).collect();
        let found = self.bits(&words)?;
        let value = |bits: &[u32]| std::array::from_fn(|index| f32::from_bits(bits[index]));
        Ok(match (N, M) {
            (_, 0) => vec![[0.0; M]; points.len()],
            (0, _) => vec![value(&found); points.len()],
            _ => found.chunks_exact(M).map(value).collect(),
        })
    }

    /// The values at `points`, of whatever types; without columns, there is one evaluation. Waits for the GPU.
    ///
    /// # Errors
    /// Where the points have other columns than the expression was compiled for, or do not fill them; and what wgpu or the
    /// driver refuses.
    pub fn table(&mut self, points: &Points) -> Result<Table, Error> {
        value::check(points)?;
        if points.columns != self.columns {
            let why = "their columns are not those that the expression was compiled for".into();
            return Err(SampleError::Points { why }.into());
        }
        let words: Vec<u32> = points.values.iter().map(|value| value.bits()).collect();
        let found = self.bits(&words)?;
        let kinds = self.leaves.iter().map(|leaf| leaf.kind).cycle();
        Ok(Table {
            columns: self.leaves.iter().map(|leaf| leaf.name.clone()).collect(),
            values: found.into_iter().zip(kinds).map(|(bits, kind)| Scalar::from_bits(kind, bits)).collect(),
        })
    }

    fn bits(&mut self, words: &[u32]) -> Result<Vec<u32>, Error> {
        let (gpu, kernel) = (&self.gpu, &mut self.kernel);
        Ok(gpu.guarded(|| kernel.run(gpu, words))?)
    }
}
