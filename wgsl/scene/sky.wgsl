// Nothing but the sky, over nothing: for skyboxes, for panoramas, and to lay behind a world of one's own.

#include <camera/camera.wgsl>
#include <camera/display.wgsl>
#include <geometry/ray.wgsl>
#include <sky/cirrus.wgsl>
#include <sky/sky.wgsl>

/// What a ray sees.
struct Traced {
    /// Linear sRGB radiance.
    radiance: vec3f,
    /// How far the ray went (m): always `RAY_FAR`, the sky has no distance.
    distance: f32,
}

/// What is seen from `origin` (m) in the unit `direction`; below the horizon what the sky's model has there.
fn scene_trace(origin: vec3f, direction: vec3f) -> Traced {
    let seen = sky_veil(sky_beyond(direction), origin, direction, RAY_FAR);
    return Traced(cirrus_veil(seen, origin, direction, sky_daylight(origin)), RAY_FAR);
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. Heights are counted from sea level.
fn main_image(frag_coord: vec2f) -> vec4f {
    let ray = camera_ray(frag_coord, 0.0);
    return vec4f(display_color(scene_trace(ray.origin, ray.direction).radiance, frag_coord), 1.0);
}
