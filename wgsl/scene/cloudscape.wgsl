// Clouds: from below, from among them, from above, over a level sea.

#include <camera/camera.wgsl>
#include <camera/display.wgsl>
#include <clouds/layer.wgsl>
#include <frame.wgsl>
#include <geometry/ray.wgsl>
#include <light/fresnel.wgsl>
#include <math/rotation.wgsl>
#include <noise/interleaved_gradient.wgsl>
#include <sky/medium.wgsl>
#include <sky/sky.wgsl>

/// Whether a second layer drifts above the first: thin, in the group `cirrus`.
#option cloudscape.second_layer = false
/// What lies beneath.
#option cloudscape.ground = sea { nothing, sea }
/// Albedo of the sea: what comes back out of the water, linear sRGB.
#param cloudscape.water: vec3f = (0.008, 0.030, 0.048), color

#if cloudscape.second_layer
#include <clouds/layer.wgsl> as cirrus
#endif

#if cloudscape.second_layer
const CLOUDSCAPE_PARTS: i32 = 3; // two layers and what is behind
#else
const CLOUDSCAPE_PARTS: i32 = 2;
#endif

/// Up at `p`.
fn cloudscape_up(p: vec3f) -> vec3f {
#if clouds.shape == shell
    return normalize_or(p + vec3f(0.0, sky.ground_radius, 0.0), vec3f(0.0, 1.0, 0.0));
#else
    return vec3f(0.0, 1.0, 0.0);
#endif
}

/// How far the sea is; `RAY_FAR` where it is not ahead.
fn cloudscape_sea(origin: vec3f, direction: vec3f) -> f32 {
#if clouds.shape == shell
    let span = cloud_sphere(origin, direction, cloud_altitude(origin), 0.0);
    return select(RAY_FAR, span.near, span.near <= span.far && span.near > 0.0);
#else
    return select(RAY_FAR, max(-origin.y / min(direction.y, -1e-6), 0.0), direction.y < -1e-6 && origin.y > 0.0);
#endif
}

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
    let sea = cloudscape_sea(origin, direction);
    if sea < RAY_FAR {
        way = sea;
        let spot = origin + way * direction;
        let sunlit = clouds_shadow(spot, day.to_sun) * max(day.to_sun.y, 0.0) * day.sun;
        let from_above = clouds_irradiance(day);
        let up = cloudscape_up(spot);
        // Waves tilt what is seen at a grazing angle: it never mirrors all.
        let mirrored = fresnel_schlick(max(-dot(direction, up), 0.22), vec3f(0.02));
        let glint = normalize_or(day.to_sun - direction, up);
        let facing = dot(glint, up);
        let slopes = (1.0 - facing * facing) / max(facing * facing, 1e-4);
        let glitter = 0.02 * exp(-slopes / 0.03) / 0.03 * sunlit;
        behind = 0.31830989 * (cloudscape.water * (sunlit + from_above) + mirrored * from_above) + 0.25 * glitter;
    }
#endif
    var front = clouds_trace(origin, direction, 0.0, way, jitter, camera_pixel_angle(), day);
#if cloudscape.second_layer
    let other = cirrus_clouds_trace(origin, direction, 0.0, way, jitter, camera_pixel_angle(), day);
    var back = CloudsSeen(other.radiance, other.transmittance, other.distance);
    if back.distance < front.distance {
        let nearer = back;
        back = front;
        front = nearer;
    }
#endif
    // Air before each of the clouds, and air all the way: turns around one call.
    var radiance = vec3f(0.0);
    var left = 1.0; // part of what is farther that shows
    for (var i = 0; i < CLOUDSCAPE_PARTS; i++) {
        var part = front;
#if cloudscape.second_layer
        if i == 1 {
            part = back;
        }
#endif
        if i == CLOUDSCAPE_PARTS - 1 {
            part = CloudsSeen(behind, 0.0, way);
        }
        if part.transmittance >= 1.0 || left <= 0.0 {
            continue;
        }
        let air = sky_air(origin, direction, part.distance);
        let hidden = 1.0 - part.transmittance;
        radiance += left * (hidden * (air.from_sun + air.from_sky) + air.transmittance * part.radiance);
        left *= part.transmittance;
    }
    return Traced(radiance, select(way, front.distance, front.transmittance < 0.5));
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
    return vec4f(display_color(seen.radiance), 1.0);
}
