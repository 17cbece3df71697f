//! naga's back ends: the checked module, overrides replaced → SPIR-V, HLSL, MSL.
//!
//! Everything that naga writes is written under guard: its writers panic on some valid inputs.

use std::collections::{BTreeMap, BTreeSet};

use naga::back::pipeline_constants::process_overrides;
use naga::back::{hlsl as naga_hlsl, msl as naga_msl, spv};
use naga::valid::{ModuleInfo, ValidationFlags, Validator};
use naga::{AddressSpace, Module, ResourceBinding, ShaderStage, StorageAccess, TypeInner};

use super::error::ExportError;
use super::header::header;
use super::target::Target;
use crate::check::{capabilities, guarded};
use crate::diagnostic::Error;
use crate::shader::Shader;
use crate::source::Templates;
use crate::template;

/// What `work` writes for `target`, or why it cannot.
pub(super) fn written<T: Send>(
    target: Target,
    work: impl FnOnce() -> Result<T, ExportError> + Send,
) -> Result<T, ExportError> {
    guarded(work).unwrap_or_else(|panicked| Err(ExportError::Panic { target, why: panicked.0 }))
}

/// naga's own reason, with all that led to it.
pub(super) fn failed(target: Target, error: &dyn std::error::Error) -> ExportError {
    let mut why = error.to_string();
    let mut source = error.source();
    while let Some(inner) = source {
        why = format!("{why}: {inner}");
        source = inner.source();
    }
    ExportError::Writer { target, why }
}

/// The module with overrides at their defaults. With `entry`, of what that fragment entry point reaches, and no more.
pub(super) fn settled(
    target: Target,
    module: &Module,
    info: &ModuleInfo,
    entry: Option<&str>,
) -> Result<(Module, ModuleInfo), ExportError> {
    let (mut module, mut info) = (module.clone(), info.clone());
    if let Some(name) = entry {
        module.entry_points.retain(|one| one.stage == ShaderStage::Fragment && one.name == name);
        naga::compact::compact(&mut module, naga::compact::KeepUnused::No);
        info = Validator::new(ValidationFlags::all(), capabilities())
            .validate(&module)
            .map_err(|error| failed(target, error.as_inner()))?;
    }
    let (settled, settled_info) = process_overrides(&module, &info, None, &Default::default())
        .map_err(|error| ExportError::Overrides { why: error.to_string() })?;
    Ok((settled.into_owned(), settled_info.into_owned()))
}

/// SPIR-V 1.3, for Vulkan 1.1, as little-endian bytes.
pub(super) fn spirv(shader: &Shader) -> Result<Vec<u8>, ExportError> {
    let checked = shader.checked();
    let words = written(Target::Spirv, || {
        let (module, info) = settled(Target::Spirv, &checked.module, &checked.info, None)?;
        let options = spv::Options {
            lang_version: (1, 3),
            // Names are for those who debug and reflect; naga's default would depend on how Orogen was built.
            flags: spv::WriterFlags::ADJUST_COORDINATE_SPACE
                | spv::WriterFlags::LABEL_VARYINGS
                | spv::WriterFlags::CLAMP_FRAG_DEPTH
                | spv::WriterFlags::DEBUG,
            ..spv::Options::default()
        };
        spv::write_vec(&module, &info, &options, None).map_err(|error| failed(Target::Spirv, &error))
    })?;
    Ok(words.into_iter().flat_map(u32::to_le_bytes).collect())
}

#[derive(serde::Serialize)]
struct Context {
    header: String,
    code: String,
}

type Text = Result<Result<String, ExportError>, Error>;

fn file(shader: &Shader, templates: &Templates, name: &str, code: Result<String, ExportError>) -> Text {
    let code = match code {
        Ok(code) => airy(code.trim()),
        Err(error) => return Ok(Err(error)),
    };
    template::render(templates, name, Context { header: header(shader, templates)?, code }).map(Ok)
}

/// `code` with at most one empty line in a row.
pub(super) fn airy(code: &str) -> String {
    let mut last_empty = false;
    let keep = |line: &&str| !std::mem::replace(&mut last_empty, line.is_empty()) || !line.is_empty();
    code.lines().filter(keep).collect::<Vec<_>>().join("\n")
}

/// HLSL for shader model 6.0. `@group(g) @binding(b)` is register `b` in space `g`.
pub(super) fn hlsl(shader: &Shader, templates: &Templates) -> Text {
    let checked = shader.checked();
    let code = written(Target::Hlsl, || {
        let (module, info) = settled(Target::Hlsl, &checked.module, &checked.info, None)?;
        let options = naga_hlsl::Options {
            shader_model: naga_hlsl::ShaderModel::V6_0,
            ..naga_hlsl::Options::default()
        };
        let mut code = String::new();
        naga_hlsl::Writer::new(&mut code, &options, &naga_hlsl::PipelineOptions::default())
            .write(&module, &info, None)
            .map_err(|error| failed(Target::Hlsl, &error))?;
        Ok(code)
    });
    file(shader, templates, "hlsl.jinja", code)
}

/// Metal 2.1. Buffers, textures and samplers are numbered each from 0, in the order of group and binding.
pub(super) fn msl(shader: &Shader, templates: &Templates) -> Text {
    let checked = shader.checked();
    let code = written(Target::Msl, || {
        let (module, info) = settled(Target::Msl, &checked.module, &checked.info, None)?;
        let resources = msl_slots(&module);
        let per_entry_point_map =
            module.entry_points.iter().map(|entry| (entry.name.clone(), resources.clone())).collect();
        let options = naga_msl::Options {
            lang_version: (2, 1),
            per_entry_point_map,
            fake_missing_bindings: false,
            ..naga_msl::Options::default()
        };
        naga_msl::write_string(&module, &info, &options, &naga_msl::PipelineOptions::default())
            .map(|(code, _)| code)
            .map_err(|error| failed(Target::Msl, &error))
    });
    file(shader, templates, "msl.jinja", code)
}

fn msl_slots(module: &Module) -> naga_msl::EntryPointResources {
    let bound = |places: &mut BTreeSet<ResourceBinding>, place: Option<ResourceBinding>| places.extend(place);
    let mut places = BTreeSet::new();
    module.global_variables.iter().for_each(|(_, variable)| bound(&mut places, variable.binding));
    let (mut buffers, mut textures, mut samplers) = (0u8, 0u8, 0u8);
    let next = |count: &mut u8| {
        *count = count.saturating_add(1); // Metal itself has far fewer
        Some(*count - 1)
    };
    let mut resources = BTreeMap::new();
    for place in places {
        let variable = module.global_variables.iter().find(|(_, variable)| variable.binding == Some(place));
        let Some((_, variable)) = variable else { continue };
        let mut target = naga_msl::BindTarget::default();
        match module.types[variable.ty].inner {
            TypeInner::Image { class, .. } => {
                target.texture = next(&mut textures);
                target.mutable = matches!(class, naga::ImageClass::Storage { access, .. } if access.contains(StorageAccess::STORE));
            }
            TypeInner::Sampler { .. } => {
                target.sampler = next(&mut samplers).map(naga_msl::BindSamplerTarget::Resource);
            }
            _ => {
                target.buffer = next(&mut buffers);
                target.mutable = matches!(variable.space, AddressSpace::Storage { access } if access.contains(StorageAccess::STORE));
            }
        }
        resources.insert(place, target);
    }
    naga_msl::EntryPointResources {
        resources,
        immediates_buffer: None,
        sizes_buffer: next(&mut buffers), // lengths of runtime-sized arrays, where there are any
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_of_nagas_is_an_error_of_ours() {
        let outcome = written::<()>(Target::Hlsl, || panic!("internal error: entered unreachable code"));
        let error = crate::Error::from(outcome.expect_err("it panicked"));
        assert_eq!(error.diagnostics()[0].code, "OR0811");
        assert_eq!(error.diagnostics()[0].notes, ["naga says: internal error: entered unreachable code"]);
    }

    #[test]
    fn of_several_empty_lines_one_is_left() {
        assert_eq!(airy("a\n\n\n\nb\nc\n\nd"), "a\n\nb\nc\n\nd");
    }
}
