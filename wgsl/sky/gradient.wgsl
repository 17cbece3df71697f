// A clear sky painted with two colours and a glow around the sun, and the haze that veils what is far. As the sun sets it
// darkens the way twilight does; by night the moon may light it.

#include <geometry/ray.wgsl>
#include <light/fog.wgsl>
#include <light/illuminance.wgsl>
#include <sky/air.wgsl>
#include <sky/beyond.wgsl>
#include <sun/key.wgsl>
#include <sun/moon.wgsl>
#include <sun/sun.wgsl>

/// Radiance straight up, linear sRGB.
#param sky.zenith: vec3f = (0.09, 0.19, 0.42), color
/// Radiance at the horizon, away from the sun, linear sRGB.
#param sky.horizon: vec3f = (0.46, 0.56, 0.68), color
/// How closely the horizon's colour keeps to the horizon.
#param sky.falloff: f32 = 4.0, range 0.5 .. 32
/// Radiance added in the direction of the sun, linear sRGB: light scattered forward by haze.
#param sky.glow: vec3f = (0.60, 0.38, 0.18), color
/// How narrow the glow is.
#param sky.glow_focus: f32 = 6.0, range 1 .. 200, log
/// Distance at which 2 % of the contrast is left, at sea level.
#param sky.visibility: f32 = 120000.0, range 100 .. 1000000, log, unit m
/// Height over which the haze thins by e.
#param sky.haze_height: f32 = 1800.0, range 10 .. 20000, unit m
/// How the haze scatters the three colours: (1, 1, 1) is mist, (0.6, 0.9, 1.5) the blue of clear air.
#param sky.haze_tint: vec3f = (0.70, 0.93, 1.40), color

/// Irradiance of a surface that faces the light that throws the shadows: less of it as its disc sinks below the horizon.
fn gradient_sunlight() -> vec3f {
    return smoothstep(-key_radius(), 0.0, asin(key_direction().y)) * key_light();
}

/// How light the painted sky is: 1 by day; once the sun has set, less as in twilight, and what the moon adds.
fn gradient_dimming() -> vec3f {
    var dimming = vec3f(1.0);
    if sun.elevation < 0.0 {
        dimming = vec3f(daylight_illuminance(sun.elevation) / 758.6);
    }
#if moon.shines
    let risen = smoothstep(-0.05, 0.3, moon.elevation);
    dimming += risen * moon_light() / max(sun_light(), vec3f(1e-9));
#endif
    return dimming;
}

/// Radiance of the sky. Below the horizon it is that of the haze there.
fn gradient_radiance(direction: vec3f) -> vec3f {
    return gradient_base(direction) + gradient_glow(direction);
}

/// The sky without its glow: the two colours, mixed by height.
fn gradient_base(direction: vec3f) -> vec3f {
    return gradient_dimming() * mix(sky.zenith, sky.horizon, pow(1.0 - clamp(direction.y, 0.0, 1.0), sky.falloff));
}

/// What haze scatters forward around the sun.
fn gradient_glow(direction: vec3f) -> vec3f {
    let toward_sun = clamp(dot(direction, sun_direction()), 0.0, 1.0);
    let wide = pow(toward_sun, sky.glow_focus);
    let narrow = pow(toward_sun, 16.0 * sky.glow_focus);
    return gradient_dimming() * sky.glow * (0.45 * wide + 0.55 * narrow) * (1.0 - 0.6 * clamp(direction.y, 0.0, 1.0));
}

/// Irradiance of level ground under the whole sky: pi times its cosine-weighted mean, in closed form, the glow
/// left out.
fn gradient_irradiance() -> vec3f {
    let horizon_part = 2.0 / ((sky.falloff + 1.0) * (sky.falloff + 2.0));
    return gradient_dimming() * 3.14159265 * mix(sky.zenith, sky.horizon, horizon_part) + sky_beyond_irradiance();
}

/// The air from `origin` (m) to `distance` (m) along the unit `direction`.
///
/// Its veil tends to the sky's colour at the horizon in that direction, so the farthest land melts into the sky. All of
/// the air, from `RAY_FAR` on, is the painted sky, and hides nothing of what shines behind it but below the horizon.
fn gradient_air(origin: vec3f, direction: vec3f, distance: f32) -> SkyAir {
    if distance >= RAY_FAR {
        let risen = smoothstep(-0.01, 0.0, direction.y); // the world is flat: nothing shines through it
        return SkyAir(gradient_glow(direction), gradient_base(direction), vec3f(risen));
    }
    let air = air_mass(origin.y, direction.y, distance, sky.haze_height);
    let transmittance = exp(-3.912 / sky.visibility * air * sky.haze_tint);
    let level = max(length(direction.xz), 1e-4);
    let along = vec3f(direction.x / level, 0.0, direction.z / level);
    let veiled = 1.0 - transmittance;
    return SkyAir(gradient_glow(along) * veiled, gradient_base(along) * veiled, transmittance);
}
