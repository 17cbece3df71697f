//! What a file's host has: names that it keeps for itself, and what it calls the parameters of `frame`.

use crate::export::target::Target;

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

/// Uniforms of a complete fragment shader: the names that glslCanvas sets, where it has one.
const WEBGL: [&str; 5] = ["u_resolution", "u_time", "u_delta", "u_frame", "u_mouse"];

/// What an Interactive Shader Format host puts before a shader.
const ISF: [&str; 17] = [
    "DATE",
    "FRAMEINDEX",
    "IMG_NORM_PIXEL",
    "IMG_NORM_THIS_PIXEL",
    "IMG_PIXEL",
    "IMG_SIZE",
    "IMG_THIS_NORM_PIXEL",
    "IMG_THIS_PIXEL",
    "PASSINDEX",
    "RENDERSIZE",
    "TIME",
    "TIMEDELTA",
    "isf_FragColor",
    "isf_FragNormCoord",
    "isf_vertShaderInit",
    "vv_FragNormCoord",
    "vv_vertShaderInit",
];

/// A parameter of `frame`: its name, what is written in its place, and the uniform that this reads, if it is ours to declare.
type Frame = (&'static str, &'static str, &'static str);

const SHADERTOY_FRAME: [Frame; 6] = [
    ("frame_resolution", "iResolution.xy", ""),
    ("frame_time", "iTime", ""),
    ("frame_delta", "iTimeDelta", ""),
    ("frame_index", "uint(iFrame)", ""),
    ("frame_mouse", "iMouse", ""),
    ("frame_jitter", "vec2(0.0)", ""),
];

const WEBGL_FRAME: [Frame; 6] = [
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

/// ISF knows no mouse.
const ISF_FRAME: [Frame; 6] = [
    ("frame_resolution", "RENDERSIZE", ""),
    ("frame_time", "TIME", ""),
    ("frame_delta", "TIMEDELTA", ""),
    ("frame_index", "uint(FRAMEINDEX)", ""),
    ("frame_mouse", "vec4(0.0)", ""),
    ("frame_jitter", "vec2(0.0)", ""),
];

/// Names that `target`'s host keeps for itself.
pub(super) fn reserved(target: Target) -> &'static [&'static str] {
    match target {
        Target::Shadertoy => &SHADERTOY,
        Target::Isf => &ISF,
        _ => &WEBGL,
    }
}

/// The parameters of `frame` in `target`.
pub(super) fn frame(target: Target) -> &'static [Frame] {
    match target {
        Target::Shadertoy => &SHADERTOY_FRAME,
        Target::Isf => &ISF_FRAME,
        _ => &WEBGL_FRAME,
    }
}
