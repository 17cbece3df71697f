// The moon as it is seen: its disc with seas, in its phase, and the light that the Earth throws on its dark side.

#include <camera/camera.wgsl>
#include <fractal/fbm3.wgsl> as lunar with noise3 = perlin_noise3_grad
#include <math/rotation.wgsl>
#include <noise/perlin.wgsl>
#include <sky/celestial.wgsl>
#include <sun/moon.wgsl>

/// How dark the moon's seas are beside its highlands.
#param moon.seas: f32 = 0.55, range 0 .. 1
/// Light that the dark side has from the Earth, beside the real one.
#param moon.earthshine: f32 = 1.0, range 0 .. 1000

/// Radiance of the moon in the unit `direction`, linear sRGB; 0 beside it.
///
/// The disc gives `moon_light` in all, give or take a sixth as its phase shows more or fewer seas. Where a pixel is wider
/// than the disc's radius the disc is drawn larger, and as much darker.
fn moon_disc(direction: vec3f) -> vec3f {
    let to_moon = moon_direction();
    let pixel = camera_pixel_angle();
    let radius = max(moon.radius, 0.75 * pixel);
    let off = direction - to_moon;
    let away = length(off) / (2.0 * sin(0.5 * radius)); // by the chord, which keeps its digits
    let shown = disc_coverage(away, pixel / radius, 10.0);
    if shown <= 0.0 {
        return vec3f(0.0);
    }
    // The place on the moon: its north is toward the pole of the stars.
    let north = vec3f(0.0, sin(stars.latitude), -cos(stars.latitude));
    let right = normalize_or(cross(to_moon, north), vec3f(1.0, 0.0, 0.0));
    let up = cross(right, to_moon);
    var on_disc = vec2f(dot(off, right), dot(off, up)) / (2.0 * sin(0.5 * radius));
    on_disc /= max(length(on_disc), 1.0);
    let outward = sqrt(max(1.0 - dot(on_disc, on_disc), 0.0));
    let normal = on_disc.x * right + on_disc.y * up - outward * to_moon;
    let lit = moon_scattering(dot(normal, sun_direction()), outward, moon_phase_angle());
    let earth = 1e-4 * moon.earthshine * (0.5 - 0.5 * cos(moon_phase_angle())); // new moon is full Earth
    let forms = lunar_fbm3(1.35 * vec3f(on_disc, outward) + vec3f(2.7, 5.1, 1.9), 3u, 5.0, 0.55, 2.2).x;
    let sea = smoothstep(-0.02, 0.22, forms);
    let shade = (1.0 - moon.seas * sea) / (1.0 - 0.45 * moon.seas);
    let solid_angle = 12.5663706 * sin(0.5 * radius) * sin(0.5 * radius);
    return shown * shade * (lit + earth) * moon_full_light() / solid_angle;
}
