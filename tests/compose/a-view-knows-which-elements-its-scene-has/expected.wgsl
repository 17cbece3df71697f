struct OrogenParams {
    /// Size of the picture.
    frame_resolution: vec2f,
    /// Offset of this frame's rays inside the pixel, -0.5 .. 0.5 each way: for renderers that accumulate frames.
    frame_jitter: vec2f,
}
@group(0) @binding(0) var<uniform> orogen: OrogenParams;

// ---- inspect/steps.wgsl ----
// What there is.

fn main_image(p: vec2f) -> vec4f {
    var seen = vec4f(0.0);
    seen.y = 1.0;
    return seen;
}

// ---- templates/entry_fragment.wgsl ----
// The scene as a picture: one triangle over the whole target, and a fragment for each pixel.

/// A triangle that covers the target: draw 3 vertices, no buffers.
@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u));
    return vec4f(corner * 4.0 - 1.0, 0.0, 1.0);
}

/// The colour of a pixel, sRGB-encoded.
@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = position.xy + orogen.frame_jitter;
    return main_image(vec2f(pixel.x, orogen.frame_resolution.y - pixel.y));
}
