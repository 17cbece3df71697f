// A clear sky painted with two colours and a glow around the sun, and the haze that veils what is far.

#include <light/fog.wgsl>
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

/// Radiance of the sky, without the sun's disc. Below the horizon it is that of the haze there.
fn sky_radiance(direction: vec3f) -> vec3f {
    let up = clamp(direction.y, 0.0, 1.0);
    let base = mix(sky.zenith, sky.horizon, pow(1.0 - up, sky.falloff));
    let toward_sun = clamp(dot(direction, sun_direction()), 0.0, 1.0);
    let wide = pow(toward_sun, sky.glow_focus);
    let narrow = pow(toward_sun, 16.0 * sky.glow_focus);
    return base + sky.glow * (0.45 * wide + 0.55 * narrow) * (1.0 - 0.6 * up);
}

/// Irradiance of level ground under the whole sky: pi times its cosine-weighted mean, in closed form, the glow
/// left out.
fn sky_irradiance() -> vec3f {
    let horizon_part = 2.0 / ((sky.falloff + 1.0) * (sky.falloff + 2.0));
    return 3.14159265 * mix(sky.zenith, sky.horizon, horizon_part);
}

/// `radiance` as it is seen from `distance` (m) away along a ray: dimmed by the haze and veiled by the light it
/// scatters.
///
/// The veil tends to the sky's colour at the horizon in that direction, so the farthest land melts into the sky.
fn sky_veil(radiance: vec3f, origin: vec3f, direction: vec3f, distance: f32) -> vec3f {
    let air = air_mass(origin.y, direction.y, distance, sky.haze_height);
    let transmittance = exp(-3.912 / sky.visibility * air * sky.haze_tint);
    let level = max(length(direction.xz), 1e-4);
    let veil = sky_radiance(vec3f(direction.x / level, 0.0, direction.z / level));
    return radiance * transmittance + veil * (1.0 - transmittance);
}

/// Radiance of the sun's disc, to be added to the sky where nothing hides it; 0 outside of the disc.
///
/// At most 200: a real disc is brighter, but more would only make edges that no number of samples smooths.
fn sun_disc(direction: vec3f) -> vec3f {
    let edge = cos(sun.radius);
    let toward = dot(direction, sun_direction());
    let inside = smoothstep(edge - 0.2 * (1.0 - edge), edge + 0.2 * (1.0 - edge), toward);
    let solid_angle = 6.2831853 * (1.0 - edge);
    let risen = smoothstep(-0.01, 0.0, direction.y); // the world is flat: nothing shines through it
    return risen * inside * min(sun_light() / solid_angle, vec3f(200.0));
}
