// Thin ice clouds, high up: combed by the wind, too thin to throw shadows.

#include <fractal/fbm.wgsl> as cirrus with noise2 = perlin_noise2_grad
#include <frame.wgsl>
#include <light/daylight.wgsl>
#include <math/rotation.wgsl>
#include <noise/perlin.wgsl>
#include <sky/air.wgsl>

/// How much of the sky thin clouds veil: 0 none.
#param sky.cirrus_cover: f32 = 0.0, range 0 .. 1
/// Opacity of the thickest of them.
#param sky.cirrus_opacity: f32 = 0.5, range 0 .. 1
/// Where the wind up there blows to, clockwise from north.
#param sky.cirrus_heading: f32 = 70.0, range -360 .. 360, unit deg
/// How fast it blows.
#param sky.cirrus_speed: f32 = 25.0, range 0 .. 200, unit m/s
/// Which clouds: another seed, another sky.
#param sky.cirrus_seed: u32 = 1

const CIRRUS_HEIGHT: f32 = 9000.0; // m
const CIRRUS_LENGTH: f32 = 14000.0; // m: of the largest wisps, along the wind
// What bends wisps, and where they may be, lag behind them: they curl, form and dissolve as they go.
const CIRRUS_BEND_LAG: f32 = 0.03;
const CIRRUS_FIELDS_LAG: f32 = 0.15;

/// All of the `air` along a ray that meets nothing, with the cirrus in it, in the light of `day`. Seen from above or below
/// alike.
fn cirrus_in(air: SkyAir, origin: vec3f, direction: vec3f, day: Daylight) -> SkyAir {
    let climb = CIRRUS_HEIGHT - origin.y;
    if sky.cirrus_cover <= 0.0 || climb * direction.y <= 0.0 {
        return air;
    }
    let distance = climb / max(abs(direction.y), 0.01) * sign(direction.y);
    let over_ground = rotate2(origin.xz + abs(distance) * direction.xz, -sky.cirrus_heading) / CIRRUS_LENGTH;
    let blown = vec2f(0.0, sky.cirrus_speed * frame.time / CIRRUS_LENGTH); // so turned, the wind blows along -y
    let place = over_ground + blown;
    let bend = cirrus_fbm2(1.3 * (place - CIRRUS_BEND_LAG * blown), sky.cirrus_seed, 2.0, 0.5, 2.0);
    let combed = vec2f(2.6 * place.x, 0.8 * place.y) + 0.28 * bend.xy;
    let wisps = cirrus_fbm2(combed, sky.cirrus_seed + 17u, 6.0, 0.56, 2.1).x;
    let fields = perlin_noise2(0.7 * (place - CIRRUS_FIELDS_LAG * blown) + vec2f(4.2, 1.9), sky.cirrus_seed + 31u);
    let threshold = 0.75 - 1.3 * sky.cirrus_cover;
    let thickness = smoothstep(threshold, threshold + 1.1, wisps + 0.8 * fields);
    let near = smoothstep(0.03, 0.22, abs(direction.y)); // at the horizon the haze hides them
    let toward_sun = max(dot(direction, day.to_sun), 0.0);
    let light = 0.16 * day.sun * (0.7 + 1.6 * pow(toward_sun, 8.0)) + 0.25 * day.sky;
    let veiled = near * sky.cirrus_opacity * thickness;
    let clear = 1.0 - veiled;
    return SkyAir(clear * air.from_sun, clear * air.from_sky + veiled * light, clear * air.transmittance);
}
