// Weather over the open sea: clouds from below, from among them, from above.

#include <camera/camera.wgsl>
#include <camera/display.wgsl>
#include <frame.wgsl>
#include <geometry/globe.wgsl>
#include <geometry/ray.wgsl>
#include <light/daylight.wgsl>
#include <noise/interleaved_gradient.wgsl>
#include <scene/weather.wgsl>
#include <sky/air.wgsl>
#include <sky/beyond.wgsl>
#include <sky/medium.wgsl>
#include <water/shade.wgsl>

/// What a ray sees.
struct Traced {
    /// Linear sRGB radiance.
    radiance: vec3f,
    /// How far the ray went (m); `RAY_FAR` for the sky.
    distance: f32,
}

/// What is seen from `origin` (m) in the unit `direction`.
fn scene_trace(origin: vec3f, direction: vec3f) -> Traced {
    return cloudscape_trace(origin, direction, 0.5);
}

/// As `scene_trace`; `jitter` is where in their first steps the marches through clouds begin, 0 .. 1: another one for each
/// pixel turns bands into fine noise.
///
/// A loop over the ray and what the sea mirrors of it, so that weather is asked for in one place. The sea follows the
/// planet's curve: its horizon lies where it does from an aeroplane.
fn cloudscape_trace(origin: vec3f, direction: vec3f, jitter: f32) -> Traced {
    var start = origin;
    var toward = direction;
    var distance = RAY_FAR;
    var radiance = vec3f(0.0);
    var passed = vec3f(1.0);
    for (var bounce = 0; bounce < 2; bounce++) {
        let height = globe_height(start, sky.ground_radius) - water.level;
        let sea_ahead = globe_span(start, toward, sky.ground_radius, water.level);
        let ends = bounce == 0 && height > 0.0 && ray_meets(sea_ahead);
        let way = select(RAY_FAR, max(sea_ahead.near, 0.0), ends);
        let end = start + select(0.0, way, ends) * toward;
        let day = weather_daylight(end);
        let air = weather_air(start, toward, way, jitter, day);
        radiance += passed * (air.from_sun + air.from_sky);
        passed *= air.transmittance;
        if !ends {
            // The sun's image in the sea is its glint.
            if bounce == 0 {
                radiance += passed * sky_beyond(toward);
            }
            break;
        }
        distance = way;
        let sun_seen = weather_sun_seen(end, day);
        let covered = water_footprint(way, toward);
        let deep = water_deep_radiance(water_irradiance(day, sun_seen));
        let sea = water_seen_from_above(end, toward, covered, deep, 1e3, 1e3, 0.03, day, sun_seen);
        radiance += passed * sea.own;
        passed *= sea.passed;
        // From high up a pixel holds waves of all slopes: they mirror the whole sky.
        let mingled = smoothstep(800.0, 3000.0, height);
        radiance += mingled * passed * day.sky / 3.14159265;
        passed *= 1.0 - mingled;
        start = vec3f(end.x, max(water.level, 0.0) + 2.0, end.z);
        toward = sea.direction;
        if max(max(passed.x, passed.y), passed.z) < 0.06 {
            radiance += passed * day.sky / 3.14159265; // looked at from above the sea mirrors little: its mean will do
            break;
        }
    }
    return Traced(radiance, distance);
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

/// The picture's sRGB colour at `frag_coord` (pixels from the bottom left), alpha 1.
fn main_image(frag_coord: vec2f) -> vec4f {
    let ray = camera_ray(frag_coord, 0.0);
    let jitter = interleaved_gradient_noise(frag_coord, frame.index);
    let seen = cloudscape_trace(ray.origin, ray.direction, jitter);
    return vec4f(display_color(seen.radiance, frag_coord), 1.0);
}
