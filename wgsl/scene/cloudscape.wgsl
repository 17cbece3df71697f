// Clouds: from below, from among them, from above, over a level sea.

#include <camera/camera.wgsl>
#include <camera/display.wgsl>
#include <clouds/layer.wgsl>
#include <frame.wgsl>
#include <geometry/ray.wgsl>
#include <noise/interleaved_gradient.wgsl>
#include <sky/medium.wgsl>
#include <sky/sky.wgsl>

/// Whether a second layer drifts above the first: thin, in the group `cirrus`.
#option cloudscape.second_layer = false
/// What lies beneath.
#option cloudscape.ground = sea { nothing, sea }

#if cloudscape.second_layer
#include <clouds/layer.wgsl> as cirrus
#endif

/// What a ray sees.
struct Traced {
    /// Linear sRGB radiance.
    radiance: vec3f,
    /// How far the ray went (m); `RAY_FAR` for the sky.
    distance: f32,
}

/// What is seen from `origin` (m) in the unit `direction`; `jitter` (0 .. 1): another one for each pixel.
fn cloudscape_trace(origin: vec3f, direction: vec3f, jitter: f32) -> Traced {
    let day = sky_daylight(origin);
    var way = RAY_FAR;
    var behind = sky_beyond(direction);
#if cloudscape.ground == sea
    let sea = ray_first(ray_half_space(origin, direction, vec3f(0.0, 1.0, 0.0), 0.0));
    if sea < 1e7 {
        way = sea;
        let spot = origin + way * direction;
        let lit = clouds_shadow(spot, day.to_sun);
        let mirrored = pow(1.0 - abs(direction.y), 5.0);
        behind = (0.02 + 0.3 * mirrored) / 3.14159265 * (day.sky + 0.1 * lit * day.to_sun.y * day.sun);
    }
#endif
    let seen = clouds_trace(origin, direction, 0.0, way, jitter, camera_pixel_angle(), day);
    // Air before the clouds, and air all the way: two turns around one call.
    var radiance = vec3f(0.0);
    for (var i = 0; i < 2; i++) {
        let is_cloud = i == 0;
        let air = sky_air(origin, direction, select(way, seen.distance, is_cloud));
        let scattered = air.from_sun + air.from_sky;
        if is_cloud {
            radiance = (1.0 - seen.transmittance) * scattered + air.transmittance * seen.radiance;
        } else {
            radiance += seen.transmittance * (scattered + air.transmittance * behind);
        }
    }
    return Traced(radiance, select(way, seen.distance, seen.transmittance < 0.5));
}

/// What is seen from `origin` (m) in the unit `direction`.
fn scene_trace(origin: vec3f, direction: vec3f) -> Traced {
    return cloudscape_trace(origin, direction, 0.5);
}

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let ray = camera_ray(frag_coord, 0.0);
    let jitter = interleaved_gradient_noise(frag_coord, frame.index);
    let seen = cloudscape_trace(ray.origin, ray.direction, jitter);
    return vec4f(display_color(seen.radiance, frag_coord), 1.0);
}
