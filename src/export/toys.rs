//! compute.toys: the composed WGSL, with the site's time, mouse and screen in the place of the group `frame` and of an entry
//! point.
//!
//! The site puts its own declarations before a shader, calls `main_image` for each pixel and takes linear colours.

use super::error::ExportError;
use super::target::Target;
use super::typed::{Meaning, Tok, Typed, parse, type_check};
use crate::check::guarded;
use crate::shader::Shader;

/// What is written for a parameter of `frame`.
const FRAME: [(&str, &str); 6] = [
    ("frame_resolution", "vec2f(textureDimensions(screen))"),
    ("frame_time", "time.elapsed"),
    ("frame_delta", "time.delta"),
    ("frame_index", "time.frame"),
    ("frame_mouse", "toys_mouse()"),
    ("frame_jitter", "vec2f(0.0)"),
];

/// What the site declares: the shader's own declarations get other names.
const TAKEN: [&str; 34] = [
    "main_image",
    "time",
    "mouse",
    "screen",
    "dispatch",
    "custom",
    "Time",
    "Mouse",
    "DispatchInfo",
    "Custom",
    "int",
    "uint",
    "float",
    "int2",
    "int3",
    "int4",
    "uint2",
    "uint3",
    "uint4",
    "float2",
    "float3",
    "float4",
    "bool2",
    "bool3",
    "bool4",
    "keyDown",
    "passLoad",
    "passStore",
    "pass_in",
    "pass_out",
    "channel0",
    "channel1",
    "assert",
    "bilinear",
];

/// What comes behind the author's program.
const MAIN: &str = "
/// Where the mouse is (xy) and where a drag is taken to begin (zw), the middle; nothing while no button is down.
fn toys_mouse() -> vec4f {
    let size = vec2f(textureDimensions(screen));
    let at = vec2f(f32(mouse.pos.x), size.y - f32(mouse.pos.y));
    return select(vec4f(0.0), vec4f(at, 0.5 * size), mouse.click > 0);
}

/// What the site calls, once a pixel. It takes linear colours; the scene's are sRGB-encoded.
@compute @workgroup_size(16, 16)
fn main_image(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(screen);
    if all(id.xy < size) {
        let shown = toys_picture(vec2f(f32(id.x) + 0.5, f32(size.y - id.y) - 0.5));
        let linear = select(pow((shown.rgb + 0.055) / 1.055, vec3f(2.4)), shown.rgb / 12.92, shown.rgb <= vec3f(0.04045));
        textureStore(screen, id.xy, vec4f(linear, 1.0));
    }
}
";

/// The file to paste.
pub(super) fn wgsl(shader: &Shader) -> Result<String, ExportError> {
    let target = Target::ComputeToys;
    if let Some(bound) = shader.interface().bindings.first() {
        return Err(ExportError::Binding { target, name: bound.name.clone(), ours: false, span: None });
    }
    let baked = shader.baked();
    let is_scene =
        baked.composition.parts.last().is_some_and(|part| part.name.ends_with("entry_main_image.wgsl"));
    let has_picture = baked.text.contains("fn main_image");
    if !is_scene || !has_picture {
        let known = shader.interface().entry_points.iter().map(|entry| entry.name.clone()).collect();
        return Err(ExportError::NoEntryPoint { what: "function `main_image`".into(), known });
    }
    let outcome = guarded(|| parse(&baked.text).and_then(type_check).map(|typed| rewritten(shader, &typed)));
    match outcome {
        Ok(Ok(text)) => Ok(text),
        Ok(Err(unreadable)) => {
            Err(ExportError::NotInEs300 { what: unreadable.what.into_owned(), span: Some(unreadable.span) })
        }
        Err(panicked) => Err(ExportError::Fault { target, why: panicked.0 }),
    }
}

fn rewritten(shader: &Shader, typed: &Typed<'_>) -> String {
    let composition = &shader.baked().composition;
    let tree = &typed.tree;
    let frame: Vec<(String, &str)> = composition
        .parameters
        .iter()
        .filter(|parameter| parameter.decl.key.group == "frame")
        .filter_map(|parameter| {
            let flat = parameter.decl.key.flat();
            let (_, read) = FRAME.iter().find(|(name, _)| *name == flat)?;
            Some((composition.flat(&parameter.decl.key), *read))
        })
        .collect();
    let name_of = |index: u32| tree.word(tree.declarations[index as usize].name);
    let instead = |index: u32| {
        let name = name_of(index);
        let of_frame = frame.iter().find(|(own, _)| own == name).map(|(_, read)| (*read).to_owned());
        of_frame.or_else(|| match name {
            "main_image" => Some("toys_picture".to_owned()),
            _ if TAKEN.contains(&name) => Some(format!("{name}_")),
            _ => None,
        })
    };
    let mut text = String::with_capacity(tree.text.len() + MAIN.len());
    let mut reads = typed.global_names();
    reads.sort_unstable();
    let mut reads = reads.into_iter().peekable();
    let mut tok: Tok = 0;
    let mut declarations = tree.declarations.iter().enumerate().peekable();
    while (tok as usize) < tree.tokens.len() {
        if let Some((index, decl)) = declarations.next_if(|(_, decl)| decl.first == tok) {
            let is_frame = frame.iter().any(|(own, _)| own == tree.word(decl.name))
                && name_of(index as u32) == tree.word(decl.name);
            let is_entry = index + 1 == tree.declarations.len(); // the wrapper comes last
            if is_frame || is_entry {
                drop_comment(&mut text, is_entry);
                tok = decl.last + 1;
                while is_frame && (tok as usize) < tree.tokens.len() && tree.kind(tok).is_trivia() {
                    let word = tree.word(tok);
                    if word.contains(crate::syntax::is_line_break) {
                        break;
                    }
                    tok += 1; // the remark behind it
                }
                continue;
            }
            if TAKEN.contains(&tree.word(decl.name)) {
                while tok < decl.name {
                    text.push_str(tree.word(tok));
                    tok += 1;
                }
                text.push_str(&instead(index as u32).unwrap_or_default());
                tok += 1;
                continue;
            }
        }
        while reads.next_if(|(at, _)| *at < tok).is_some() {}
        match reads.next_if(|(at, _)| *at == tok).and_then(|(_, index)| instead(index)) {
            Some(other) => text.push_str(&other),
            None => text.push_str(tree.word(tok)),
        }
        tok += 1;
    }
    let text = super::back::airy(text.trim_end());
    format!("{text}\n{MAIN}")
}

/// Takes the comments off the end of `text` that stand above what is dropped; with `heading`, the module's heading as well.
fn drop_comment(text: &mut String, heading: bool) {
    loop {
        let trimmed = text.trim_end_matches([' ', '\t', '\n']).len();
        let line = text[..trimmed].rfind('\n').map_or(0, |at| at + 1);
        let is_comment = text[line..trimmed].trim_start().starts_with("//");
        let blank = text[trimmed..].matches('\n').count() > 1;
        if !is_comment || (blank && !heading) {
            return;
        }
        text.truncate(line);
    }
}

impl Typed<'_> {
    /// Every token that names a declaration of the module, with the declaration.
    fn global_names(&self) -> Vec<(Tok, u32)> {
        let all = self.tree.names();
        all.filter_map(|(id, tok)| match self.meaning(id) {
            Meaning::Global(index) => Some((tok, index)),
            _ => None,
        })
        .collect()
    }
}
