// The scene as a picture: one triangle over the whole target, and a fragment for each pixel.

#include <frame.wgsl>

/// A triangle that covers the target: draw 3 vertices, no buffers.
@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u));
    return vec4f(corner * 4.0 - 1.0, 0.0, 1.0);
}

/// The colour of a pixel, sRGB-encoded.
@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = position.xy + frame.jitter;
    return main_image(vec2f(pixel.x, frame.resolution.y - pixel.y));
}
