// What shines behind the air: the sun's disc, and by option the moon and the stars.

#include <camera/camera.wgsl>
#include <light/disc.wgsl>
#include <sky/moon.wgsl>
#include <sky/stars.wgsl>
#include <sun/moon.wgsl>
#include <sun/sun.wgsl>

/// Radiance from beyond the air in the unit `direction`.
fn sky_beyond(direction: vec3f) -> vec3f {
    var radiance = sun_disc(direction);
#if stars.shine
    radiance += star_radiance(direction) + milky_way_radiance(direction) + airglow_radiance(direction);
#endif
#if moon.shines
    let behind = step(2.0 * sin(0.5 * moon.radius), length(direction - moon_direction())); // the moon hides the stars
    radiance = behind * radiance + moon_disc(direction);
#endif
    return radiance;
}

/// Irradiance of level ground by what shines behind the air all over the sky: stars and airglow, not sun and moon.
fn sky_beyond_irradiance() -> vec3f {
#if stars.shine
    return starlight_irradiance();
#else
    return vec3f(0.0);
#endif
}

/// Radiance of the sun's disc, darker and redder toward its limb; 0 outside of it.
///
/// The disc gives `sun_light` in all: some 15,000 times its radiance, which only a low sun's air makes small enough for a
/// picture; its edge fades over a pixel on a logarithmic ramp, so that it is smooth on a display. Where a pixel is wider
/// than the disc's radius the disc is drawn larger, and as much darker.
fn sun_disc(direction: vec3f) -> vec3f {
    let pixel = camera_pixel_angle();
    let radius = max(sun.radius, 0.75 * pixel);
    let chord = 2.0 * sin(0.5 * radius); // of the disc's edge: for small angles it keeps its digits
    let away = length(direction - sun_direction()) / chord;
    let shown = disc_coverage(away, pixel / radius, 16.0);
    if shown <= 0.0 {
        return vec3f(0.0);
    }
    let mu = sqrt(max(1.0 - away * away, 0.0025)); // at the very limb the power law would end in black
    return shown * sun_limb(mu) * sun_light() / (3.14159265 * chord * chord);
}
