// Nothing but the sky, over nothing: for skyboxes, for panoramas, and to lay behind a world of one's own.

#include <camera/camera.wgsl>
#include <camera/display.wgsl>
#include <frame.wgsl>
#include <geometry/ray.wgsl>
#include <light/daylight.wgsl>
#include <noise/interleaved_gradient.wgsl>
#include <scene/weather.wgsl>
#include <sky/air.wgsl>
#include <sky/beyond.wgsl>

/// What a ray sees.
struct Traced {
    /// Linear sRGB radiance.
    radiance: vec3f,
    /// How far the ray went (m): always `RAY_FAR`, the sky has no distance.
    distance: f32,
}

/// What is seen from `origin` (m) in the unit `direction`; below the horizon what the sky's model has there.
fn scene_trace(origin: vec3f, direction: vec3f) -> Traced {
    return sky_trace(origin, direction, 0.5);
}

/// As `scene_trace`; `jitter` is where in their first steps the marches through clouds begin, 0 .. 1.
fn sky_trace(origin: vec3f, direction: vec3f, jitter: f32) -> Traced {
    let air = weather_air(origin, direction, RAY_FAR, jitter, weather_daylight(origin));
    return Traced(sky_through(air, sky_beyond(direction)), RAY_FAR);
}

/// The light that falls on a thing of a host's own at `position` (m), seen from `distance` (m) away: the sun, as far as
/// clouds leave it, and the sky.
fn scene_daylight(position: vec3f, distance: f32) -> Daylight {
    var day = weather_daylight(position);
    day.sun *= weather_sun_seen(position, day);
    return day;
}

/// Air and clouds between `origin` (m) and what a host draws `distance` (m) away in the unit `direction`; `sky_through` has a
/// radiance seen through them.
fn scene_air(origin: vec3f, direction: vec3f, distance: f32) -> SkyAir {
    return weather_air(origin, direction, distance, 0.5, weather_daylight(origin + distance * direction));
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1. Heights are counted from sea level.
fn main_image(frag_coord: vec2f) -> vec4f {
    let ray = camera_ray(frag_coord, 0.0);
    let jitter = interleaved_gradient_noise(frag_coord, frame.index);
    return vec4f(display_color(sky_trace(ray.origin, ray.direction, jitter).radiance, frag_coord), 1.0);
}
