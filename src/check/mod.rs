//! Proof: [`Baked`] → naga's typed module, or diagnostics in the authors' own files.

mod guard;
mod overrides;
mod report;
mod statement;

pub(crate) use guard::guarded;
pub use guard::{Panicked, is_guarded};

use naga::front::wgsl;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::bake::{Baked, Binding, EntryPoint, Interface, Resource};
use crate::diagnostic::{Diagnostic, Error};

/// A shader that naga has parsed and validated.
pub struct Checked {
    /// The text, its map and its composition.
    pub baked: Baked,
    /// The interface, entry points and bindings included.
    pub interface: Interface,
    /// naga's module.
    pub module: naga::Module,
    /// What validation found out about it.
    pub info: ModuleInfo,
}

/// What WebGPU offers without any optional feature.
pub fn capabilities() -> Capabilities {
    // `pack2x16float` and its kin are core WGSL; naga counts them as an extra for the sake of old GL.
    Capabilities::default() | Capabilities::SHADER_FLOAT16_IN_FLOAT32
}

/// Parses and validates with WebGPU's default capabilities.
///
/// # Errors
/// What naga says, told at the author's place.
pub fn check(baked: Baked) -> Result<Checked, Error> {
    let text = &baked.text;
    let outcome = guarded(|| {
        let options = wgsl::Options { parse_doc_comments: false, capabilities: capabilities() };
        let module = wgsl::Frontend::new_with_options(options).parse(text).map_err(Fault::Parse)?;
        match Validator::new(ValidationFlags::all(), capabilities()).validate(&module) {
            Ok(info) => match overrides::settle(&module, &info) {
                Ok(()) => Ok((module, info)),
                Err(why) => Err(Fault::Unsettled(why)),
            },
            Err(error) => Err(Fault::Invalid(Box::new(error), Box::new(module))),
        }
    });
    match outcome {
        Ok(Ok((module, info))) => {
            let interface = complete(baked.interface.clone(), &module, &info);
            Ok(Checked { baked, interface, module, info })
        }
        Ok(Err(fault)) => {
            let diagnostic = match &fault {
                Fault::Parse(error) => report::parse_error(&baked, error),
                Fault::Invalid(error, module) => report::validation_error(&baked, module, error),
                Fault::Unsettled(why) => report::unsettled(&baked, why),
            };
            Err(Error::new(vec![diagnostic], baked.composition.files.clone()))
        }
        Err(panicked) => Err(panicked.into()),
    }
}

impl From<Panicked> for Error {
    fn from(Panicked(why): Panicked) -> Self {
        let help = "this is a fault of naga; a smaller shader that shows it is worth a report there";
        let diagnostic = Diagnostic::error("OR0703", format!("naga panicked while checking: {why}"));
        Self::bare(diagnostic.help(Some(help.into())))
    }
}

enum Fault {
    Parse(wgsl::ParseError),
    Invalid(Box<naga::WithSpan<naga::valid::ValidationError>>, Box<naga::Module>),
    Unsettled(overrides::Unsettled),
}

/// Entry points and bindings, from naga's module.
fn complete(mut interface: Interface, module: &naga::Module, info: &ModuleInfo) -> Interface {
    interface.entry_points = module
        .entry_points
        .iter()
        .map(|entry| EntryPoint {
            name: entry.name.clone(),
            stage: stage_name(entry.stage),
            workgroup_size: (entry.stage == naga::ShaderStage::Compute).then_some(entry.workgroup_size),
        })
        .collect();
    let ours = interface.uniform.as_ref();
    let bound = module.global_variables.iter().filter_map(|(handle, variable)| {
        let place = variable.binding.as_ref()?;
        Some(Binding {
            group: place.group,
            binding: place.binding,
            name: variable.name.clone().unwrap_or_default(),
            kind: kind(module, variable).to_owned(),
            stages: stages(module, info, handle),
            // Ours is a whole number of 16 bytes, which suits every back end.
            resource: ours
                .filter(|ours| variable.name.as_ref() == Some(&ours.name))
                .map_or_else(|| resource(module, variable), |ours| Resource::Uniform { size: ours.size }),
        })
    });
    interface.bindings = bound.collect();
    interface
}

/// As WGSL names the stage.
pub(crate) fn stage_name(stage: naga::ShaderStage) -> &'static str {
    match stage {
        naga::ShaderStage::Vertex => "vertex",
        naga::ShaderStage::Fragment => "fragment",
        naga::ShaderStage::Compute => "compute",
        _ => "other",
    }
}

/// The stages of the entry points that read a variable, each once.
fn stages(
    module: &naga::Module,
    info: &ModuleInfo,
    variable: naga::Handle<naga::GlobalVariable>,
) -> Vec<&'static str> {
    let reads = |(index, _): &(usize, &naga::EntryPoint)| !info.get_entry_point(*index)[variable].is_empty();
    let mut stages: Vec<_> = module
        .entry_points
        .iter()
        .enumerate()
        .filter(reads)
        .map(|(_, entry)| stage_name(entry.stage))
        .collect();
    stages
        .sort_unstable_by_key(|stage| ["vertex", "fragment", "compute"].iter().position(|one| one == stage));
    stages.dedup();
    stages
}

/// What a layout has to say of a variable.
fn resource(module: &naga::Module, variable: &naga::GlobalVariable) -> Resource {
    use naga::{AddressSpace as Space, ImageClass as Class, StorageAccess as Access, TypeInner};
    let inner = &module.types[variable.ty].inner;
    let size = inner.size(module.to_ctx());
    match (&variable.space, inner) {
        (Space::Uniform, _) => Resource::Uniform { size },
        (Space::Storage { access }, _) => {
            Resource::Storage { read_only: !access.contains(Access::STORE), size }
        }
        (_, TypeInner::Sampler { comparison }) => Resource::Sampler { comparison: *comparison },
        (_, TypeInner::Image { dim, arrayed, class }) => {
            let dimension = dimension(*dim, *arrayed);
            match class {
                Class::Sampled { kind, multi } => {
                    let sample = match kind {
                        naga::ScalarKind::Sint => "sint",
                        naga::ScalarKind::Uint => "uint",
                        _ => "float",
                    };
                    Resource::Texture { sample, dimension, multisampled: *multi }
                }
                Class::Depth { multi } => {
                    Resource::Texture { sample: "depth", dimension, multisampled: *multi }
                }
                Class::Storage { format, access } => {
                    let access = match (access.contains(Access::LOAD), access.contains(Access::STORE)) {
                        (true, true) => "ReadWrite",
                        (true, false) => "ReadOnly",
                        _ => "WriteOnly",
                    };
                    Resource::StorageTexture { format: format!("{format:?}"), access, dimension }
                }
                Class::External => Resource::Other,
            }
        }
        _ => Resource::Other,
    }
}

fn dimension(dim: naga::ImageDimension, arrayed: bool) -> &'static str {
    match (dim, arrayed) {
        (naga::ImageDimension::D1, _) => "D1",
        (naga::ImageDimension::D2, false) => "D2",
        (naga::ImageDimension::D2, true) => "D2Array",
        (naga::ImageDimension::D3, _) => "D3",
        (naga::ImageDimension::Cube, false) => "Cube",
        (naga::ImageDimension::Cube, true) => "CubeArray",
    }
}

fn kind(module: &naga::Module, variable: &naga::GlobalVariable) -> &'static str {
    match (&variable.space, &module.types[variable.ty].inner) {
        (naga::AddressSpace::Uniform, _) => "uniform",
        (naga::AddressSpace::Storage { access }, _) if access.contains(naga::StorageAccess::STORE) => {
            "storage"
        }
        (naga::AddressSpace::Storage { .. }, _) => "read-only-storage",
        (_, naga::TypeInner::Sampler { .. }) => "sampler",
        (_, naga::TypeInner::Image { class: naga::ImageClass::Storage { .. }, .. }) => "storage-texture",
        (_, naga::TypeInner::Image { .. }) => "texture",
        _ => "other",
    }
}
