// What the weather puts between the eye and what it sees, and between the sun and what it lights: air and clouds.

#include <camera/camera.wgsl>
#include <geometry/ray.wgsl>
#include <light/daylight.wgsl>
#include <quality.wgsl>
#include <sky/air.wgsl>
#include <sky/medium.wgsl>
#include <sky/sky.wgsl>

/// Whether a layer of clouds is in the sky: the group `clouds`.
#option weather.clouds = false
/// Whether a second layer is: the group `cirrus`.
#option weather.second_layer = false
/// Whether, without a second layer, thin clouds lie on a plane: the group `veil`.
#option weather.veil = false
/// Whether wisps of ice are painted on the sky: `sky.cirrus_cover` and its like.
#option weather.cirrus = false
/// Whether the clouds' shadows are seen in the air, as shafts of light through their gaps.
#option weather.shafts = false

#if weather.clouds
#include <clouds/layer.wgsl>
#endif
#if weather.second_layer
#include <clouds/layer.wgsl> as cirrus
#elif weather.veil
#include <clouds/planar.wgsl>
#endif
#if weather.cirrus
#include <sky/cirrus.wgsl>
#endif

#if weather.clouds && (weather.second_layer || weather.veil)
const WEATHER_LAYERS: i32 = 2;
#elif weather.clouds || weather.second_layer || weather.veil
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
#if weather.second_layer
    day.sky = mix(cirrus_clouds_irradiance(day), day.sky, clamp(cirrus_cloud_height_fraction(position), 0.0, 1.0));
#endif
#if weather.clouds
    let above = clamp(cloud_height_fraction(position), 0.0, 1.0);
    day.sky = mix(clouds_irradiance(day), day.sky, above);
#endif
    return day;
}

/// Part of the sun that the clouds leave to `position` (m), 0 .. 1; none at all where it is hardly to be seen.
fn weather_sun_seen(position: vec3f, day: Daylight) -> f32 {
    var seen = 1.0;
#if weather.clouds
    seen *= clouds_shadow(position, day.to_sun);
#endif
#if weather.second_layer
    seen *= cirrus_clouds_shadow(position, day.to_sun);
#elif weather.veil
    seen *= planar_clouds_shadow(position, day.to_sun);
#endif
#if weather.clouds || weather.second_layer
    seen = max(1.004 * seen - 0.004, 0.0);
#endif
    return seen;
}

/// Air and clouds on the way from `origin` to `distance` (m) along the unit `direction`, from `RAY_FAR` on all the way out,
/// in the light of `day`. `jitter`: 0 .. 1, another one for each pixel.
fn weather_air(origin: vec3f, direction: vec3f, distance: f32, jitter: f32, day: Daylight) -> SkyAir {
    return weather_air_blurred(origin, direction, distance, jitter, 0.0, day);
}

/// As `weather_air`, of the ray that a rough mirror reflects, for the mean over an angle of about `blur` (rad): the clouds
/// of the group `clouds` are blurred into their mean from .03 on, and not marched from .09 on.
fn weather_air_blurred(
    origin: vec3f,
    direction: vec3f,
    distance: f32,
    jitter: f32,
    blur: f32,
    day: Daylight,
) -> SkyAir {
    var first = WeatherLayer(vec3f(0.0), 1.0, distance);
    var second = first; // the farther one
#if weather.clouds
    let blurred = smoothstep(0.03, 0.09, blur);
    var low = CloudsSeen(vec3f(0.0), 1.0, distance);
    if blurred < 1.0 {
        low = clouds_found(origin, direction, 0.0, distance, jitter, max(camera_pixel_angle(), blur));
    }
    // They are lit where they are: from orbit it may be night there.
    let above = vec3f(origin.x, clouds.base + 0.5 * clouds.thickness, origin.z);
    let low_place = select(origin + min(low.distance, 1e9) * direction, above, low.transmittance > 0.9999);
    var at_low = sky_daylight(low_place);
#if weather.second_layer
    // The other layer's shadow falls on this one, if it is the higher.
    at_low.sun *= cirrus_clouds_shadow(low_place, at_low.to_sun);
    at_low.sky = mix(cirrus_clouds_irradiance(at_low), at_low.sky, clamp(cirrus_cloud_height_fraction(low_place), 0.0, 1.0));
#elif weather.veil
    at_low.sun *= planar_clouds_shadow(low_place, at_low.to_sun);
#endif
    low.radiance = clouds_lit(low.radiance, low_place, at_low);
    if blurred > 0.0 {
        let mean = clouds_mean(origin, direction, distance, at_low);
        low.radiance = mix(low.radiance, mean.radiance, blurred);
        low.transmittance = mix(low.transmittance, mean.transmittance, blurred);
        low.distance = mix(low.distance, mean.distance, blurred);
    }
    first = WeatherLayer(low.radiance, low.transmittance, low.distance);
#endif
#if weather.second_layer
    let high = cirrus_clouds_found(origin, direction, 0.0, distance, jitter, camera_pixel_angle());
    let high_place = origin + min(high.distance, 1e9) * direction;
    let high_radiance = cirrus_clouds_lit(high.radiance, high_place, sky_daylight(high_place));
    second = WeatherLayer(high_radiance, high.transmittance, high.distance);
#elif weather.veil
    let high = planar_clouds_trace(origin, direction, 0.0, distance, camera_pixel_angle(), sky_daylight(origin));
    second = WeatherLayer(high.radiance, high.transmittance, high.distance);
#endif
    if second.distance < first.distance {
        let nearer = second;
        second = first;
        first = nearer;
    }

    // The air up to each layer counts by how much is seen of that layer, and all of it by what shows behind them.
    var seen = SkyAir(vec3f(0.0), vec3f(0.0), vec3f(0.0));
    var from_clouds = vec3f(0.0);
    var veil = vec3f(0.0); // part of what is seen that is air
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
        seen.from_sky += share * air.from_sky;
        from_clouds += left * air.transmittance * met.radiance;
        veil += share * (1.0 - air.transmittance);
        if i == 2 {
            seen.transmittance = left * air.transmittance;
        }
        left *= met.transmittance;
    }
#if weather.clouds
    // Under the clouds the air scatters what they let through, and what the ground throws back, alike in all directions.
    let reach = mix(first.distance, min(distance, 1e5), first.transmittance);
    let under = weather_share_below(origin.y, direction.y, reach, clouds.base + 0.3 * clouds.thickness);
    var sunny = 1.0 - clouds.coverage * (0.8 + 0.2 * clouds.coverage);
#if weather.shafts
    sunny = weather_sunny_air(origin, direction, reach, jitter, day);
#endif
    let covered = under * clouds.coverage;
    let around = clouds_irradiance(sky_daylight(origin)) * (0.5 + 0.5 * clouds.ground) / 3.14159265;
    seen.from_sun *= 1.0 - under * (1.0 - sunny);
    seen.from_sky = mix(seen.from_sky, veil * around, covered);
#endif
    seen.from_sky += from_clouds;
#if weather.cirrus
    if distance >= RAY_FAR {
        return cirrus_in(seen, origin, direction, day);
    }
#endif
    return seen;
}

#if weather.clouds

// Height over which the air thins by e, as far as clouds darken it: between the haze's and the molecules'.
const WEATHER_AIR_HEIGHT: f32 = 3000.0; // m

/// Part of the air along a ray that lies below `ceiling` (m), 0 .. 1: `y` (m) is the origin's height, `climb` the
/// direction's, `distance` (m) the ray's length. Over a round planet a ray that goes down comes up again.
fn weather_share_below(y: f32, climb: f32, distance: f32, ceiling: f32) -> f32 {
    let way = min(distance, 1e7);
    var last = y + climb * way;
#if sky.model == atmosphere
    let lowest = clamp(-climb * sky.ground_radius, 0.0, way); // where it does
    last = select(last, y + climb * lowest + 0.5 * lowest * lowest / sky.ground_radius, climb < 0.0);
#endif
    let start = clamp(y / WEATHER_AIR_HEIGHT, -3.0, 30.0);
    let end = clamp(last / WEATHER_AIR_HEIGHT, -3.0, 30.0);
    let edge = ceiling / WEATHER_AIR_HEIGHT;
    // A little of the air at the start stands in for all of it where a ray runs level.
    let all = abs(exp(-start) - exp(-end)) + 1e-4;
    let below = abs(exp(-min(start, edge)) - exp(-min(end, edge))) + select(0.0, 1e-4, start < edge);
    return clamp(below / all, 0.0, 1.0);
}

#endif
#if weather.clouds && weather.shafts

#if quality == low
const SHAFT_SAMPLES: vec2i = vec2i(4, 6); // places along the ray, and samples from each to the sun: too few let it shine through
#elif quality == medium
const SHAFT_SAMPLES: vec2i = vec2i(8, 6);
#elif quality == high
const SHAFT_SAMPLES: vec2i = vec2i(24, 8);
#else
const SHAFT_SAMPLES: vec2i = vec2i(48, 12);
#endif

/// Mean part of the sun that reaches the air below the clouds along a ray.
fn weather_sunny_air(origin: vec3f, direction: vec3f, distance: f32, jitter: f32, day: Daylight) -> f32 {
    let ceiling = clouds.base + 0.3 * clouds.thickness;
    let span = ray_slab(origin.y, direction.y, -1e5, ceiling);
    let near = clamp(span.near, 0.0, clouds.far);
    let far = min(min(span.far, distance), clouds.far);
    let thinning = 1.0 / WEATHER_VISIBILITY + direction.y / WEATHER_AIR_HEIGHT;
    return cloud_volume_shafts(
        origin, direction, near, far, thinning, day.to_sun, jitter, SHAFT_SAMPLES.x, SHAFT_SAMPLES.y,
    );
}

// Distance over which haze hides haze behind it, as far as shafts are concerned.
const WEATHER_VISIBILITY: f32 = 25000.0; // m

#endif
