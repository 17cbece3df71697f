// The engine's world: Orogen's land, marched, and the engine's things, rasterised, in one frame and one depth buffer.

#include <scene/landscape.wgsl>
#include "view.wgsl"
#include "things.wgsl"

/// What a pixel of the land is: light, nobody's, and how deep it lies.
struct Drawn {
    @location(0) radiance: vec4f,
    @location(1) thing: u32,
    @builtin(frag_depth) depth: f32,
}

@vertex
fn land_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

/// The land and the sky, as deep as the ray went: the engine's own projection says how deep that is.
@fragment
fn land_fragment(@builtin(position) pixel: vec4f) -> Drawn {
    let direction = view_ray(pixel.xy);
    let jitter = interleaved_gradient_noise(pixel.xy, 0u);
    let seen = landscape_trace(view.eye, direction, jitter);
    let clip = view.clip_from_eye * vec4f(seen.distance * direction, 1.0);
    return Drawn(vec4f(seen.radiance, 1.0), 0u, clip.z / clip.w);
}
