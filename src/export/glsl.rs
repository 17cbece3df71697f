//! GLSL ES 3.00, and the Shadertoy file made of it: naga's GLSL with the author's names.

use std::sync::LazyLock;

use naga::back::glsl;
use naga::proc::BoundsCheckPolicies;
use naga::{Binding, BuiltIn, Module, ShaderStage, TypeInner};
use rustc_hash::FxHashSet;
use serde::Serialize;

use super::back::{airy, failed, settled, written};
use super::error::ExportError;
use super::es300;
use super::header::header;
use super::names::{self, Shown};
use super::target::Target;
use crate::bake::Storage;
use crate::diagnostic::Error;
use crate::shader::Shader;
use crate::source::{Span, Templates};
use crate::template;

/// Keywords, reserved words and built-in functions of every version of GLSL.
static WORDS: LazyLock<FxHashSet<&str>> =
    LazyLock::new(|| include_str!("glsl_words.txt").split_whitespace().collect());

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

/// naga's name of what a fragment entry point returns.
const NAGA_OUTPUT: &str = "_fs2p_location0";

/// What of the composition's `frame` group Shadertoy knows by which name.
const FRAME: [(&str, &str); 6] = [
    ("frame_resolution", "iResolution.xy"),
    ("frame_time", "iTime"),
    ("frame_delta", "iTimeDelta"),
    ("frame_index", "uint(iFrame)"),
    ("frame_mouse", "iMouse"),
    ("frame_jitter", "vec2(0.0)"),
];

type Text = Result<Result<String, ExportError>, Error>;

#[derive(Serialize)]
struct GlslContext {
    version_line: &'static str,
    header: String,
    code: String,
}

/// A fragment shader in GLSL ES 3.00.
pub(super) fn file(shader: &Shader, entry: Option<&str>, templates: &Templates) -> Text {
    let name = match fragment(shader, entry) {
        Ok(name) => name,
        Err(error) => return Ok(Err(error)),
    };
    let shown = match code(shader, Target::Glsl, &name, |word| WORDS.contains(word), &[]) {
        Ok(shown) => shown,
        Err(error) => return Ok(Err(error)),
    };
    const VERSION: &str = "#version 300 es";
    let code = shown.text.trim_start().strip_prefix(VERSION).unwrap_or(&shown.text).trim().to_owned();
    let header = header(shader, templates)?;
    template::render(templates, "glsl.jinja", GlslContext { version_line: VERSION, header, code }).map(Ok)
}

#[derive(Serialize)]
struct ShadertoyContext {
    header: String,
    /// Parameters that are variables.
    live: Vec<Live>,
    code: String,
    /// What is copied from Shadertoy's variables every frame.
    frame: Vec<String>,
    /// The rest of `mainImage`.
    main: String,
}

#[derive(Serialize)]
struct Live {
    doc: Vec<String>,
    code: String,
    /// Unit and range.
    remark: String,
}

/// A file for Shadertoy's editor.
pub(super) fn shadertoy(shader: &Shader, entry: Option<&str>, templates: &Templates) -> Text {
    match shadertoy_parts(shader, entry) {
        Ok(mut context) => {
            context.header = header(shader, templates)?;
            template::render(templates, "shadertoy.jinja", context).map(Ok)
        }
        Err(error) => Ok(Err(error)),
    }
}

fn shadertoy_parts(shader: &Shader, entry: Option<&str>) -> Result<ShadertoyContext, ExportError> {
    let name = fragment(shader, entry)?;
    let module = &shader.checked().module;
    wrappable(module, &name)?;
    // A scene's wrapper counts pixels as Shadertoy does; WGSL itself counts them from the top.
    let is_scene = shader.checked().baked.composition.parts.iter().any(|part| part.name.ends_with(WRAPPER));
    let position = if is_scene {
        "vec4(fragCoord, 0.0, 1.0)"
    } else {
        "vec4(fragCoord.x, iResolution.y - fragCoord.y, 0.0, 1.0)"
    };
    let reserved = |word: &str| WORDS.contains(word) || SHADERTOY.contains(&word);
    let fixed = [("gl_FragCoord", position), (NAGA_OUTPUT, "fragColor")];
    let shown = code(shader, Target::Shadertoy, &name, reserved, &fixed)?;
    let is_ours =
        |line: &&str| !["#version", "precision ", "layout("].iter().any(|start| line.starts_with(start));
    let mut lines: Vec<&str> = shown.text.lines().filter(is_ours).collect();
    let main = lines.iter().position(|line| *line == "void main() {").unwrap_or(lines.len());
    let body: Vec<&str> = lines.split_off(main);
    let body = body.iter().skip(1).take_while(|line| **line != "}").filter(|line| line.trim() != "return;");
    let main = body.copied().collect::<Vec<_>>().join("\n");
    let frame = FRAME.iter().filter_map(|(name, value)| {
        Some(format!("{} = {value};", shown.global(name).filter(|_| is_variable(shader, name))?))
    });
    let frame = frame.collect();
    let live = live(shader, &shown, &mut lines);
    Ok(ShadertoyContext { header: String::new(), live, code: airy(lines.join("\n").trim()), frame, main })
}

/// The entry point of a scene for targets that call `main_image`.
const WRAPPER: &str = "templates/entry_main_image.wgsl";

fn is_variable(shader: &Shader, flat: &str) -> bool {
    let baked = &shader.checked().baked;
    let mut all = baked.composition.parameters.iter().zip(&baked.storage);
    all.any(|(parameter, storage)| *storage == Storage::Variable && parameter.decl.key.flat() == flat)
}

/// Takes the declarations of live parameters out of `lines`.
fn live(shader: &Shader, shown: &Shown, lines: &mut Vec<&str>) -> Vec<Live> {
    let baked = &shader.checked().baked;
    let variables = baked.composition.parameters.iter().zip(&baked.storage);
    let variables = variables
        .filter(|(parameter, storage)| **storage == Storage::Variable && parameter.decl.key.group != "frame");
    let declares = |line: &str, name: &str| {
        let head = line.split_once(" = ").map(|(head, _)| head);
        !line.starts_with(' ')
            && head.and_then(|head| head.split_once(' ')).is_some_and(|(_, own)| own == name)
    };
    variables
        .filter_map(|(parameter, _)| {
            let decl = &parameter.decl;
            let name = shown.global(&decl.key.flat())?;
            let at = lines.iter().position(|line| declares(line, name))?;
            let angle = decl.unit.as_deref() == Some("deg");
            let degrees = |value: f64| if angle { format!("{value} deg") } else { value.to_string() };
            let unit = decl.unit.as_deref().map(|unit| if angle { "rad" } else { unit }.to_owned());
            let range = decl.range.map(|(low, high)| format!("{low} .. {}", degrees(high)));
            let remark = unit.into_iter().chain(range).collect::<Vec<_>>().join(", ");
            // A backslash at the end would join the next line to the comment.
            let plain = |text: &str| crate::bake::clean(text).trim_end().trim_end_matches('\\').to_owned();
            let doc = decl.doc.lines().map(plain).collect();
            Some(Live { doc, code: lines.remove(at).to_owned(), remark: plain(&remark) })
        })
        .collect()
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

/// naga's GLSL of one entry point, with names.
fn code(
    shader: &Shader,
    target: Target,
    name: &str,
    is_reserved: impl Fn(&str) -> bool,
    fixed: &[(&str, &str)],
) -> Result<Shown, ExportError> {
    let checked = shader.checked();
    let (text, words) = written(target, || {
        let (mut module, info) = settled(target, &checked.module, &checked.info, Some(name))?;
        es300::refuse(&module, &info)?;
        if target == Target::Shadertoy {
            unbound(shader, &module)?;
        }
        let words = names::hide(&mut module);
        let options = glsl::Options {
            version: glsl::Version::Embedded { version: 300, is_webgl: true },
            writer_flags: glsl::WriterFlags::empty(),
            ..glsl::Options::default()
        };
        let pipeline = glsl::PipelineOptions {
            shader_stage: ShaderStage::Fragment,
            entry_point: name.to_owned(),
            multiview: None,
        };
        let mut text = String::new();
        glsl::Writer::new(&mut text, &module, &info, &options, &pipeline, BoundsCheckPolicies::default())
            .and_then(|mut writer| writer.write())
            .map_err(|error| failed(target, &error))?;
        Ok((text, words))
    })?;
    Ok(names::show(&text, &words, is_reserved, fixed))
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
fn unbound(shader: &Shader, module: &Module) -> Result<(), ExportError> {
    let ours = shader.interface().uniform.as_ref().map(|uniform| uniform.name.as_str());
    let mut bound = module.global_variables.iter().filter(|(_, variable)| variable.binding.is_some());
    let Some((handle, variable)) = bound.next() else { return Ok(()) };
    let name = variable.name.clone().unwrap_or_default();
    let ours = ours == Some(name.as_str());
    let range = module.global_variables.get_span(handle).to_range();
    let span = range.map(|range| Span::new(range.start, range.end));
    Err(ExportError::Binding { ours, span: span.filter(|_| !ours), name })
}
