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

struct ThingVertex {
    @builtin(position) clip: vec4f,
    /// Relative to the eye (m).
    @location(0) relative: vec3f,
    /// In the mesh's own metres.
    @location(1) local: vec3f,
    @location(2) local_normal: vec3f,
    @location(3) normal: vec3f,
    @location(4) @interpolate(flat) material: u32,
    @location(5) @interpolate(flat) index: u32,
}

@vertex
fn thing_vertex(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) material: u32,
    @builtin(instance_index) index: u32,
) -> ThingVertex {
    let thing = view.things[index];
    let relative = thing.foot + thing.scale * thing_turned(position, thing.turn) - view.eye;
    let clip = view.clip_from_eye * vec4f(relative, 1.0);
    return ThingVertex(clip, relative, position, normal, thing_turned(normal, thing.turn), material, index);
}

/// The same, as the sun sees it.
@vertex
fn thing_shadow_vertex(@location(0) position: vec3f, @builtin(instance_index) index: u32) -> @builtin(position) vec4f {
    let thing = view.things[index];
    return thing.sun * vec4f(thing.scale * thing_turned(position, thing.turn), 1.0);
}

/// What a pixel of a thing is: light, and whose; its depth is the rasteriser's.
struct Shown {
    @location(0) radiance: vec4f,
    @location(1) thing: u32,
}

@fragment
fn thing_fragment(in: ThingVertex) -> Shown {
    let normal = normalize(in.normal);
    let seen = thing_radiance(in.index, in.relative, normal, in.local, in.local_normal, in.material);
    return Shown(vec4f(seen, 1.0), in.index + 1u);
}
