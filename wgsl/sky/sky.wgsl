// The sky of a scene: one of three models of air behind the same functions.

#include <geometry/ray.wgsl>
#include <light/daylight.wgsl>
#include <sky/air.wgsl>
#include <sky/beyond.wgsl>
#include <sun/key.wgsl>

/// What the air is made of: two painted colours, or the scattering of a planet's air, or of a flat world's.
#option sky.model = gradient { gradient, atmosphere, planar }

#if sky.model == gradient
#include <sky/gradient.wgsl>
#elif sky.model == atmosphere
#include <sky/scattering.wgsl>
#else
#include <sky/planar.wgsl>
#endif

/// The air from `origin` (m; `origin.y` above sea level) to `distance` (m) along the unit `direction`; from `RAY_FAR`
/// on all of it.
fn sky_air(origin: vec3f, direction: vec3f, distance: f32) -> SkyAir {
#if sky.model == gradient
    return gradient_air(origin, direction, distance);
#elif sky.model == atmosphere
    return atmosphere_air(origin, direction, distance);
#else
    return planar_air(origin, direction, distance);
#endif
}

/// Radiance of the sky seen from `origin`: all that the air scatters, without what shines behind it.
fn sky_radiance(origin: vec3f, direction: vec3f) -> vec3f {
    let air = sky_air(origin, direction, RAY_FAR);
    return air.from_sun + air.from_sky;
}

/// `radiance` as it is seen from `origin`, `distance` (m) away: dimmed by the air and veiled by the light that it
/// scatters.
fn sky_veil(radiance: vec3f, origin: vec3f, direction: vec3f, distance: f32) -> vec3f {
    return sky_through(sky_air(origin, direction, distance), radiance);
}

/// The light that falls on things at `position` (m).
fn sky_daylight(position: vec3f) -> Daylight {
    let to_sun = key_direction();
#if sky.model == gradient
    return Daylight(to_sun, key_radius(), gradient_sunlight(), gradient_irradiance());
#elif sky.model == atmosphere
    return Daylight(to_sun, key_radius(), atmosphere_sunlight(position), atmosphere_irradiance(position));
#else
    return Daylight(to_sun, key_radius(), planar_sunlight(position), planar_irradiance(position));
#endif
}
