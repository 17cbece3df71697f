// What the weather puts between the eye and what it sees, and between the sun and what it lights: air and clouds.

#include <camera/camera.wgsl>
#include <geometry/ray.wgsl>
#include <light/daylight.wgsl>
#include <sky/air.wgsl>
#include <sky/cirrus.wgsl>
#include <sky/sky.wgsl>

/// Whether a layer of clouds is in the sky: the group `clouds`.
#option weather.clouds = false
/// Whether a second layer is: the group `cirrus`.
#option weather.second_layer = false
/// Whether the clouds' shadows are seen in the air, as shafts of light through their gaps.
#option weather.shafts = false

#if weather.clouds
#include <clouds/layer.wgsl>
#endif
#if weather.second_layer
#include <clouds/layer.wgsl> as cirrus
#endif

#if weather.clouds && weather.second_layer
const WEATHER_LAYERS: i32 = 2;
#elif weather.clouds || weather.second_layer
const WEATHER_LAYERS: i32 = 1;
#else
const WEATHER_LAYERS: i32 = 0;
#endif

/// Clouds in front of what the air is asked for.
struct WeatherLayer {
    /// Radiance that they send toward the eye.
    radiance: vec3f,
    /// Part of what is behind that shows, 0 .. 1.
    transmittance: f32,
    /// Mean distance of what is seen of them (m).
    distance: f32,
}

/// The light at `position` (m), under the clouds if there are any: their shadows are `weather_sun_seen`'s.
fn weather_daylight(position: vec3f) -> Daylight {
    var day = sky_daylight(position);
#if weather.clouds
    // TODO clouds_irradiance
#endif
    return day;
}

/// Part of the sun that the clouds leave to `position` (m), 0 .. 1.
fn weather_sun_seen(position: vec3f, day: Daylight) -> f32 {
    var seen = 1.0;
#if weather.clouds
    seen *= clouds_shadow(position, day.to_sun);
#endif
#if weather.second_layer
    seen *= cirrus_clouds_shadow(position, day.to_sun);
#endif
    return seen;
}

/// Air and clouds on the way from `origin` to `distance` (m) along the unit `direction`, from `RAY_FAR` on all the way out,
/// in the light of `day`. `jitter`: 0 .. 1, another one for each pixel.
fn weather_air(origin: vec3f, direction: vec3f, distance: f32, jitter: f32, day: Daylight) -> SkyAir {
    var first = WeatherLayer(vec3f(0.0), 1.0, distance);
    var second = first; // the farther one
#if weather.clouds
    let low = clouds_trace(origin, direction, 0.0, distance, jitter, camera_pixel_angle(), day);
    first = WeatherLayer(low.radiance, low.transmittance, low.distance);
#endif
#if weather.second_layer
    let high = cirrus_clouds_trace(origin, direction, 0.0, distance, jitter, camera_pixel_angle(), day);
    second = WeatherLayer(high.radiance, high.transmittance, high.distance);
#endif
    if second.distance < first.distance {
        let nearer = second;
        second = first;
        first = nearer;
    }

    // The air up to each layer counts by how much is seen of that layer, and all of it by what shows behind them.
    var seen = SkyAir(vec3f(0.0), vec3f(0.0), vec3f(0.0));
    var left = 1.0;
    for (var i = 2 - WEATHER_LAYERS; i <= 2; i++) {
        var met = WeatherLayer(vec3f(0.0), 0.0, distance);
        if i < 2 {
            met = first;
            if i == 1 && WEATHER_LAYERS == 2 {
                met = second;
            }
            if met.transmittance > 0.9999 {
                continue;
            }
        } else if left < 1e-4 {
            break;
        }
        let air = sky_air(origin, direction, met.distance);
        let share = left * (1.0 - met.transmittance);
        seen.from_sun += share * air.from_sun;
        seen.from_sky += share * air.from_sky + left * air.transmittance * met.radiance;
        if i == 2 {
            seen.transmittance = left * air.transmittance;
        }
        left *= met.transmittance;
    }
    if distance < RAY_FAR {
        return seen;
    }
    return cirrus_in(seen, origin, direction, day);
}
