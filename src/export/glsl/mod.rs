//! GLSL ES 3.00 that people read: the author's program with its names, comments and loops, as a Shadertoy file, as a complete
//! fragment shader, or as what Interactive Shader Format wants.

mod emit;
mod entry;
mod evaluation;
mod helpers;
mod host;
mod isf;
mod names;
mod order;
mod spelling;
mod tabs;
mod values;
mod write;
mod write_call;
mod write_decl;
mod write_expr;
mod write_stmt;

use naga::{Binding, BuiltIn, Module, ShaderStage, TypeInner};
use rustc_hash::FxHashMap;
use serde::Serialize;

use self::emit::{Emitted, Request, emit};
use super::error::ExportError;
use super::header::header;
use super::target::Target;
use crate::check::guarded;
use crate::diagnostic::Error;
use crate::shader::Shader;
use crate::source::{Span, Templates};
use crate::template;

pub use tabs::{Tabs, shadertoy_tabs};

/// The entry point of a scene for targets that call `main_image`.
const WRAPPER: &str = "templates/entry_main_image.wgsl";

/// A file in GLSL, and what became of names in it.
#[derive(Debug, Clone)]
pub struct Glsl {
    /// The file.
    pub text: String,
    /// Every name that is spelled otherwise than its author did, with its new spelling, in the order of the alphabet: what
    /// GLSL or the file's host keep for themselves.
    pub renamed: Vec<(String, String)>,
}

#[derive(Serialize)]
struct Context {
    header: String,
    code: String,
    /// What stands inside of the function that the host calls, line by line.
    main: Vec<String>,
    /// Uniforms, inputs and outputs.
    declarations: Vec<String>,
    /// What ISF wants to know of the file.
    json: String,
}

/// The file for `target`, which is one of the GLSL targets, with what became of names in it.
///
/// # Errors
/// As [`export_entry`](super::export_entry).
pub fn glsl(
    shader: &Shader,
    target: Target,
    entry: Option<&str>,
    templates: &Templates,
) -> Result<Glsl, Error> {
    written(shader, target, entry, templates)?.map_err(|error| error.told(shader))
}

fn written(
    shader: &Shader,
    target: Target,
    entry: Option<&str>,
    templates: &Templates,
) -> Result<Result<Glsl, ExportError>, Error> {
    let entry =
        match fragment(shader, entry).and_then(|entry| allowed(shader, target, &entry).map(|()| entry)) {
            Ok(entry) => entry,
            Err(error) => return Ok(Err(error)),
        };
    let emitted = match emitted(shader, target, &entry, templates)? {
        Ok(emitted) => emitted,
        Err(error) => return Ok(Err(error)),
    };
    let context = Context {
        header: header(shader, templates)?,
        main: main_lines(&emitted, target, is_scene(shader)),
        declarations: declarations(&emitted, target),
        json: if target == Target::Isf { isf::json(shader, &emitted.read) } else { String::new() },
        code: super::back::airy(emitted.text.trim()),
    };
    let name = match target {
        Target::Shadertoy => "shadertoy.jinja",
        Target::Isf => "isf.jinja",
        _ => "glsl.jinja",
    };
    let text = template::render(templates, name, context)?;
    Ok(Ok(Glsl { text, renamed: emitted.renamed }))
}

fn emitted(
    shader: &Shader,
    target: Target,
    entry: &str,
    templates: &Templates,
) -> Result<Result<Emitted, ExportError>, Error> {
    let checked = shader.checked();
    let baked = &checked.baked;
    let own_header = template::render(templates, "header.jinja", crate::bake::Facts::of(&baked.composition))?;
    let own_header = own_header.trim_end();
    let start = if baked.text.starts_with(own_header) { own_header.len() } else { 0 };
    let modules = baked.map.segments().iter().find(|segment| segment.instance.is_some());
    let flipped = is_scene(shader) || target != Target::Glsl;
    let instead = instead(shader, target);
    let inputs = if target == Target::Isf { isf::inputs(shader) } else { Vec::new() };
    let own = inputs.iter().flat_map(|input| input.names.iter().map(String::as_str));
    let reserved: Vec<&str> = host::reserved(target).iter().copied().chain(own).collect();
    let request = Request {
        text: &baked.text,
        start,
        modules: modules.map_or(0, |segment| segment.out.start as usize),
        module: &checked.module,
        entry,
        is_scene: is_scene(shader),
        reserved: &reserved,
        instead,
        flipped,
        scene: scene(shader),
    };
    let outcome = guarded(|| emit(&request));
    Ok(match outcome {
        Ok(Ok(emitted)) => Ok(emitted),
        Ok(Err(refusal)) => Err(ExportError::NotInEs300 { what: refusal.what, span: Some(refusal.span) }),
        Err(panicked) => Err(ExportError::Fault { target, why: panicked.0 }),
    })
}

/// Where the scene's own fragment stands in the text: it comes last, but for its entry point.
fn scene(shader: &Shader) -> std::ops::Range<usize> {
    let baked = shader.baked();
    let scene = baked.composition.parts.iter().rfind(|part| !part.name.ends_with(WRAPPER));
    let own = |segment: &&crate::bake::Segment| {
        scene.is_some_and(|scene| {
            segment.file == scene.file && segment.instance == Some(scene.instance as u32)
        })
    };
    let mut segments = baked.map.segments().iter().filter(own);
    let start = segments.next().map_or(0, |segment| segment.out.start as usize);
    let end = segments.next_back().map_or(start, |segment| segment.out.end as usize);
    start..end
}

/// Whether the entry point is the one that a scene gets.
fn is_scene(shader: &Shader) -> bool {
    shader.checked().baked.composition.parts.iter().any(|part| part.name.ends_with(WRAPPER))
}

/// What is written for variables that the host has in its own way: the parameters of `frame`, and the inputs of ISF.
fn instead(shader: &Shader, target: Target) -> FxHashMap<String, String> {
    let composition = &shader.checked().baked.composition;
    let of_frame = composition.parameters.iter().filter(|parameter| parameter.decl.key.group == "frame");
    let mut instead: FxHashMap<String, String> = of_frame
        .filter_map(|parameter| {
            let flat = parameter.decl.key.flat();
            let (_, read, _) = host::frame(target).iter().find(|(name, ..)| *name == flat)?;
            Some((composition.flat(&parameter.decl.key), (*read).to_owned()))
        })
        .collect();
    if target == Target::Isf {
        instead.extend(isf::inputs(shader).into_iter().map(|input| (input.variable, input.read)));
    }
    instead
}

/// What stands in the function that the host calls.
fn main_lines(emitted: &Emitted, target: Target, is_scene: bool) -> Vec<String> {
    let interface = &emitted.interface;
    let position = match (target, is_scene) {
        (Target::Shadertoy, true) => "fragCoord",
        (_, true) => "gl_FragCoord.xy",
        (Target::Shadertoy, false) => "vec4(fragCoord.x, iResolution.y - fragCoord.y, 0.0, 1.0)",
        (Target::Isf, false) => "vec4(gl_FragCoord.x, RENDERSIZE.y - gl_FragCoord.y, 0.0, 1.0)",
        (_, false) => "gl_FragCoord",
    };
    let arguments: Vec<&str> =
        interface.arguments.iter().map(|argument| argument.as_deref().unwrap_or(position)).collect();
    let call = format!("{}({})", emitted.function, arguments.join(", "));
    match (&interface.output, &interface.outputs) {
        _ if target == Target::Shadertoy => vec![format!("fragColor = {call};")],
        _ if target == Target::Isf => vec![format!("gl_FragColor = {call};")],
        (Some((output, _)), _) => vec![format!("{output} = {call};")],
        (None, Some((ty, outputs))) => {
            let mut lines = vec![format!("{ty} outputs_ = {call};")];
            lines.extend(outputs.iter().map(|(variable, member)| format!("{variable} = outputs_.{member};")));
            lines
        }
        (None, None) => vec![format!("{call};")],
    }
}

fn declarations(emitted: &Emitted, target: Target) -> Vec<String> {
    if target != Target::Glsl {
        return Vec::new();
    }
    let is_read = |text: &str| emitted.read.iter().any(|read| read == text);
    let uniforms = host::frame(target).iter().filter(|(_, read, line)| !line.is_empty() && is_read(read));
    let uniforms = uniforms.map(|(_, _, line)| (*line).to_owned());
    uniforms.chain(emitted.interface.declarations.iter().cloned()).collect()
}

/// The fragment entry point `wanted`, or the first.
fn fragment(shader: &Shader, wanted: Option<&str>) -> Result<String, ExportError> {
    let all = &shader.checked().module.entry_points;
    let mut names = all.iter().filter(|one| one.stage == ShaderStage::Fragment).map(|one| one.name.clone());
    let known: Vec<_> = names.clone().collect();
    match wanted {
        None => names.next().ok_or(ExportError::NoEntryPoint { what: "fragment entry point".into(), known }),
        Some(wanted) => names.find(|name| name == wanted).ok_or_else(|| ExportError::NoEntryPoint {
            what: format!("fragment entry point named `{wanted}`"),
            known,
        }),
    }
}

/// Whether `target` can call `entry`, and bind what it reads.
fn allowed(shader: &Shader, target: Target, entry: &str) -> Result<(), ExportError> {
    if target == Target::Glsl {
        return Ok(());
    }
    let checked = shader.checked();
    wrappable(&checked.module, target, entry)?;
    let index = checked
        .module
        .entry_points
        .iter()
        .position(|one| one.stage == ShaderStage::Fragment && one.name == entry);
    unbound(shader, target, index.unwrap_or(0))
}

/// Shadertoy and ISF call with a position, and want a colour.
fn wrappable(module: &Module, target: Target, name: &str) -> Result<(), ExportError> {
    let Some(entry) =
        module.entry_points.iter().find(|one| one.stage == ShaderStage::Fragment && one.name == name)
    else {
        return Ok(());
    };
    let is_position =
        |binding: &Option<Binding>| matches!(binding, Some(Binding::BuiltIn(BuiltIn::Position { .. })));
    let gives = entry.function.result.as_ref().filter(|result| {
        matches!(result.binding, Some(Binding::Location { location: 0, .. }))
            && matches!(
                module.types[result.ty].inner,
                TypeInner::Vector { size: naga::VectorSize::Quad, scalar } if scalar == naga::Scalar::F32
            )
    });
    let why = if !entry.function.arguments.iter().all(|argument| is_position(&argument.binding)) {
        "it takes more than `@builtin(position)`"
    } else if gives.is_none() {
        "it does not return one `@location(0) vec4f`"
    } else {
        return Ok(());
    };
    // An entry point has no place of its own in naga's module; what it is made of does.
    let spans = entry
        .function
        .expressions
        .iter()
        .filter_map(|(handle, _)| entry.function.expressions.get_span(handle).to_range());
    let span = spans.map(|range| Span::new(range.start, range.end)).min_by_key(|span| span.start);
    Err(ExportError::Unwrappable { target, name: name.to_owned(), why, span })
}

/// They have no buffers, and textures only by names of their own.
fn unbound(shader: &Shader, target: Target, entry: usize) -> Result<(), ExportError> {
    let checked = shader.checked();
    let ours = shader.interface().uniform.as_ref().map(|uniform| uniform.name.as_str());
    let info = checked.info.get_entry_point(entry);
    let module = &checked.module;
    let mut bound = module
        .global_variables
        .iter()
        .filter(|(handle, variable)| variable.binding.is_some() && !info[*handle].is_empty());
    let Some((handle, variable)) = bound.next() else { return Ok(()) };
    let name = variable.name.clone().unwrap_or_default();
    let ours = ours == Some(name.as_str());
    let range = module.global_variables.get_span(handle).to_range();
    let span = range.map(|range| Span::new(range.start, range.end));
    Err(ExportError::Binding { target, ours, span: span.filter(|_| !ours), name })
}
