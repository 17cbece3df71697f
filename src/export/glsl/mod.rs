//! GLSL ES 3.00 that people read: the author's program with its names, comments and loops, as a Shadertoy file, as a complete
//! fragment shader, or as what Interactive Shader Format wants.

mod emit;
mod entry;
mod evaluation;
mod helpers;
mod names;
mod order;
mod spelling;
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
use crate::compose::Parameter;
use crate::diagnostic::Error;
use crate::shader::Shader;
use crate::source::{Span, Templates};
use crate::template;

/// What Shadertoy puts before a shader, or may put there.
const SHADERTOY: [&str; 28] = [
    "HW_PERFORMANCE",
    "iCh0",
    "iCh1",
    "iCh2",
    "iCh3",
    "iChannel0",
    "iChannel1",
    "iChannel2",
    "iChannel3",
    "iChannelResolution",
    "iChannelTime",
    "iDate",
    "iFrame",
    "iFrameRate",
    "iMouse",
    "iResolution",
    "iSampleRate",
    "iTime",
    "iTimeDelta",
    "iGlobalTime",
    "mainImage",
    "mainSound",
    "mainVR",
    "mainCubemap",
    "shadertoy_out_color",
    "st_assert",
    "fragColor",
    "fragCoord",
];

/// Names of our own in a complete fragment shader.
const WEBGL: [&str; 6] = ["u_resolution", "u_time", "u_delta", "u_frame", "u_mouse", "fragColor"];

/// What of the group `frame` Shadertoy knows by which name.
const SHADERTOY_FRAME: [(&str, &str); 6] = [
    ("frame_resolution", "iResolution.xy"),
    ("frame_time", "iTime"),
    ("frame_delta", "iTimeDelta"),
    ("frame_index", "uint(iFrame)"),
    ("frame_mouse", "iMouse"),
    ("frame_jitter", "vec2(0.0)"),
];

/// The same as uniforms of a complete fragment shader, with how each is declared. The names are those that glslCanvas sets.
const WEBGL_FRAME: [(&str, &str, &str); 6] = [
    ("frame_resolution", "u_resolution", "uniform vec2 u_resolution;  // pixels"),
    ("frame_time", "u_time", "uniform float u_time;  // s"),
    ("frame_delta", "u_delta", "uniform float u_delta;  // s, since the frame before"),
    ("frame_index", "uint(u_frame)", "uniform int u_frame;  // how many frames came before"),
    (
        "frame_mouse",
        "u_mouse",
        "uniform vec4 u_mouse;  // pixels: where the drag is (xy) and where it began (zw)",
    ),
    ("frame_jitter", "vec2(0.0)", ""),
];

/// The entry point of a scene for targets that call `main_image`.
const WRAPPER: &str = "templates/entry_main_image.wgsl";

type Text = Result<Result<String, ExportError>, Error>;

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
}

/// A fragment shader in GLSL ES 3.00.
pub(super) fn file(shader: &Shader, entry: Option<&str>, templates: &Templates) -> Text {
    Ok(written(shader, Target::Glsl, entry, templates)?.map(|glsl| glsl.text))
}

/// A file for Shadertoy's editor.
pub(super) fn shadertoy(shader: &Shader, entry: Option<&str>, templates: &Templates) -> Text {
    Ok(written(shader, Target::Shadertoy, entry, templates)?.map(|glsl| glsl.text))
}

/// The file for `target`, which is one of the GLSL targets.
pub(super) fn written(
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
        code: super::back::airy(emitted.text.trim()),
    };
    let name = if target == Target::Shadertoy { "shadertoy.jinja" } else { "glsl.jinja" };
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
    let flipped = is_scene(shader) || target == Target::Shadertoy;
    let instead = instead(shader, target);
    let request = Request {
        text: &baked.text,
        start,
        modules: modules.map_or(0, |segment| segment.out.start as usize),
        module: &checked.module,
        entry,
        is_scene: is_scene(shader),
        reserved: if target == Target::Shadertoy { &SHADERTOY } else { &WEBGL },
        instead,
        flipped,
    };
    let outcome = guarded(|| emit(&request));
    Ok(match outcome {
        Ok(Ok(emitted)) => Ok(emitted),
        Ok(Err(refusal)) => Err(ExportError::NotInEs300 { what: refusal.what, span: Some(refusal.span) }),
        Err(panicked) => Err(ExportError::Fault { target, why: panicked.0 }),
    })
}

/// Whether the entry point is the one that a scene gets.
fn is_scene(shader: &Shader) -> bool {
    shader.checked().baked.composition.parts.iter().any(|part| part.name.ends_with(WRAPPER))
}

/// What is written for the parameters of `frame`, where they are variables.
fn instead(shader: &Shader, target: Target) -> FxHashMap<&'static str, String> {
    let is_frame = |parameter: &Parameter, name: &str| {
        parameter.decl.key.group == "frame" && parameter.decl.key.flat() == name
    };
    let parameters = &shader.checked().baked.composition.parameters;
    let known: Vec<(&'static str, &'static str)> = if target == Target::Shadertoy {
        SHADERTOY_FRAME.to_vec()
    } else {
        WEBGL_FRAME.iter().map(|(name, read, _)| (*name, *read)).collect()
    };
    let ours =
        known.into_iter().filter(|(name, _)| parameters.iter().any(|parameter| is_frame(parameter, name)));
    ours.map(|(name, read)| (name, read.to_owned())).collect()
}

/// What stands in the function that the host calls.
fn main_lines(emitted: &Emitted, target: Target, is_scene: bool) -> Vec<String> {
    let interface = &emitted.interface;
    let position = match (target, is_scene) {
        (Target::Shadertoy, true) => "fragCoord",
        (_, true) => "gl_FragCoord.xy",
        (Target::Shadertoy, false) => "vec4(fragCoord.x, iResolution.y - fragCoord.y, 0.0, 1.0)",
        (_, false) => "gl_FragCoord",
    };
    let arguments: Vec<&str> =
        interface.arguments.iter().map(|argument| argument.as_deref().unwrap_or(position)).collect();
    let call = format!("{}({})", emitted.function, arguments.join(", "));
    match (&interface.output, &interface.outputs) {
        _ if target == Target::Shadertoy => vec![format!("fragColor = {call};")],
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
    if target == Target::Shadertoy {
        return Vec::new();
    }
    let is_read = |name: &str| emitted.read.iter().any(|read| read == name);
    let uniforms = WEBGL_FRAME.iter().filter(|(name, _, line)| !line.is_empty() && is_read(name));
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
    if target != Target::Shadertoy {
        return Ok(());
    }
    let checked = shader.checked();
    wrappable(&checked.module, entry)?;
    let index = checked
        .module
        .entry_points
        .iter()
        .position(|one| one.stage == ShaderStage::Fragment && one.name == entry);
    unbound(shader, index.unwrap_or(0))
}

/// Shadertoy calls with a position, and wants a colour.
fn wrappable(module: &Module, name: &str) -> Result<(), ExportError> {
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
    Err(ExportError::Unwrappable { name: name.to_owned(), why, span })
}

/// Shadertoy has no buffers, and textures only by its own names.
fn unbound(shader: &Shader, entry: usize) -> Result<(), ExportError> {
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
    Err(ExportError::Binding { ours, span: span.filter(|_| !ours), name })
}
