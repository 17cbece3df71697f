// The stars, the Milky Way, and the faint light of the air itself.
//
// Brightness is that of the real sky beside the sun's, so that one exposure serves a moonlit land and its stars. A star of
// magnitude m has 10^(-0.4 (m + 26.74)) of the sun's irradiance.

#include <camera/camera.wgsl>
#include <color/blackbody.wgsl>
#include <fractal/fbm3.wgsl> as galaxy with noise3 = perlin_noise3_grad
#include <noise/pcg.wgsl>
#include <noise/perlin.wgsl>
#include <sky/celestial.wgsl>
#include <sun/sun.wgsl>

/// Whether stars, Milky Way and airglow shine.
#option stars.shine = false
/// Magnitude of the faintest stars: 6.5 is what eyes see. Fainter ones only join the others.
#param stars.limit: f32 = 6.5, range -1.5 .. 8.5
/// How many stars there are, beside the real sky.
#param stars.density: f32 = 1.0, range 0 .. 2
/// How much brighter than the real ones the stars are.
#param stars.brightness: f32 = 1.0, range 0 .. 1000, log
/// Another seed, another sky.
#param stars.seed: u32 = 7
/// Brightness of the Milky Way beside the real one.
#param stars.milky_way: f32 = 1.0, range 0 .. 1000
/// Brightness of the air's own glow beside that of a dark night.
#param stars.airglow: f32 = 1.0, range 0 .. 1000

const STAR_OF_MAGNITUDE_0: f32 = 2.0137e-11; // of the sun's irradiance
const SKY_OF_MAGNITUDE_22: f32 = 1.358e-9; // radiance of 22 magnitudes a square second of arc, over the sun's irradiance
// Layers of magnitudes: from 2.5 + 2 (layer - 1) to 2.5 + 2 layer, the first from the brightest on; and so many cells
// along a side of the cube on which they lie that two of five hold a star.
const STAR_GRID: vec4f = vec4f(6.0, 18.0, 58.0, 188.0);
const STAR_COUNT: vec4f = vec4f(82.2, 778.5, 8155.0, 85390.0); // of 10^(0.51 m + 0.64) up to magnitude m
const STAR_FACE: f32 = 0.985; // of a side of the cube that stars stand on: none is cut at its edge

/// A star of the real sky's kind.
struct Star {
    /// Where it stands on its side of the cube: unit vector, z outward.
    place: vec3f,
    /// Its magnitude, -1.5 at the least; 99 where there is no star.
    magnitude: f32,
    /// Temperature of its light (K).
    temperature: f32,
}

/// The star in `cell` (whole numbers, from 0 to less than the layer's grid) of the cube's `face` (0 .. 5) in `layer`
/// (0 .. 3). Two cells of five hold one.
fn star_in(cell: vec2f, face: u32, layer: i32) -> Star {
    let grid = STAR_GRID[layer];
    let bits = pcg3d(vec3u(vec2u(cell), face + 6u * (4u * stars.seed + u32(layer))));
    let more = pcg3d(bits + vec3u(1u, 2u, 3u));
    // Larger cells hold one more often. The cell's solid angle, over that of a face's middle:
    let middle = tan(1.57079633 * STAR_FACE * ((cell + 0.5) / grid - 0.5));
    let away2 = 1.0 + dot(middle, middle);
    let stretch = (1.0 + middle.x * middle.x) * (1.0 + middle.y * middle.y) / (away2 * sqrt(away2));
    let share = STAR_COUNT[layer] * 0.19634954 / (grid * grid) * stretch; // (pi / 2)² / 4 pi
    if unit_float(bits.z) >= stars.density * share {
        return Star(vec3f(0.0, 0.0, 1.0), 99.0, 6000.0);
    }
    // By the law of counts: between two magnitudes the fainter are the more.
    let brightest = select(0.0955, 0.0, layer == 0); // 10^(-.51 * 2): the part of the stars up to here that are not of here
    let rank = max(mix(brightest, 1.0, unit_float(more.x)), 1e-9);
    let magnitude = max(2.5 + 2.0 * f32(layer) + log2(rank) * 0.59025, -1.5);
    let tangent = tan(1.57079633 * STAR_FACE * ((cell + unit_float2(bits.xy)) / grid - 0.5));
    let inverse = mix(0.0714, 0.285, unit_float(more.y));
    return Star(normalize(vec3f(tangent, 1.0)), magnitude, 1000.0 / inverse);
}

/// Radiance of the stars in the unit `direction`, linear sRGB.
///
/// Each is a normal distribution .6 pixels wide (its standard deviation), so that its light is the same to one percent
/// wherever it stands between the pixels' centres. Numbers follow the real count of 10^(.51 m + .64) stars up to
/// magnitude m, temperatures go from 3,500 to 14,000 K. In pictures so coarse that a pixel covers more than .3° (.09° for
/// stars fainter than 6.5) they are cut narrower than that and may twinkle.
fn star_radiance(direction: vec3f) -> vec3f {
    let at = celestial_direction(direction);
    let size = abs(at);
    // The side of the cube, and the place on it: by angles, so that cells are alike.
    var side = 0u;
    var on_side = vec3f(at.y, at.z, at.x);
    if size.y > size.x && size.y >= size.z {
        side = 1u;
        on_side = vec3f(at.z, at.x, at.y);
    } else if size.z > size.x && size.z > size.y {
        side = 2u;
        on_side = vec3f(at.x, at.y, at.z);
    }
    let face = side + select(0u, 3u, on_side.z < 0.0);
    on_side.z = abs(on_side.z);
    let place = 0.5 + 0.63661977 / STAR_FACE * atan(on_side.xy / on_side.z);
    let pixel = camera_pixel_angle();
    var sum = vec3f(0.0);
    for (var i = 0; i < 16; i++) { // layers, and of each the four nearest cells
        let layer = i >> 2u;
        if layer > 0 && 0.5 + 2.0 * f32(layer) >= stars.limit {
            break; // all that follow are fainter
        }
        let grid = STAR_GRID[layer];
        let cell = floor(place * grid - 0.5) + vec2f(f32(i & 1), f32((i >> 1u) & 1));
        if any(cell < vec2f(0.0)) || any(cell >= vec2f(grid)) {
            continue;
        }
        let star = star_in(cell, face, layer);
        let off = on_side - star.place;
        let spread = min(0.6 * pixel, 0.17 / grid); // 3.5 of them are less than half a cell
        let away = dot(off, off) / (spread * spread);
        if away > 12.25 || star.magnitude > stars.limit {
            continue;
        }
        let light = exp2(-1.3287712 * star.magnitude) / (6.2831853 * spread * spread);
        sum += light * exp(-0.5 * away) * blackbody_color(star.temperature);
    }
    return stars.brightness * STAR_OF_MAGNITUDE_0 * sun.irradiance * sum;
}

/// Radiance of the Milky Way in the unit `direction`, linear sRGB: a band of 21 magnitudes a square second of arc, brighter
/// toward its middle in Sagittarius, with dark clouds before it.
fn milky_way_radiance(direction: vec3f) -> vec3f {
    if stars.milky_way <= 0.0 {
        return vec3f(0.0);
    }
    let at = celestial_direction(direction);
    let latitude = dot(at, vec3f(-0.86766, 0.45598, 0.19808)); // sine: north is at 12h 51m, 27°
    let inward = dot(at, vec3f(-0.05487, -0.48383, 0.87344)); // the middle is at 17h 46m, -29°
    let clouds = galaxy_fbm3(3.0 * at, stars.seed + 91u, 5.0, 0.55, 2.1).x;
    let wide = latitude / (0.17 + 0.06 * inward);
    let band = (0.5 + 0.3 * inward) * exp(-wide * wide) * (1.0 + 0.6 * clouds);
    let bulge = 0.9 * exp(-12.0 * (1.0 - inward)) * exp(-latitude * latitude * 18.0);
    let rift = (latitude - 0.02 + 0.10 * clouds) / 0.055;
    let dust = 1.0 - 0.75 * smoothstep(-0.3, 0.6, inward) * exp(-rift * rift);
    let light = max((band + bulge) * dust, 0.0);
    return stars.milky_way * 2.5 * SKY_OF_MAGNITUDE_22 * sun.irradiance * light * vec3f(1.05, 0.99, 0.95);
}

/// Radiance of the air's own glow in the unit `direction`, linear sRGB: 22 magnitudes a square second of arc overhead and up
/// to five times as much at the horizon, since it shines from a layer 90 km up (van Rhijn 1921).
fn airglow_radiance(direction: vec3f) -> vec3f {
    let up = max(direction.y, 0.0);
    let path = inverseSqrt(1.0 - 0.97 * (1.0 - up * up));
    return stars.airglow * SKY_OF_MAGNITUDE_22 * sun.irradiance * path * vec3f(0.90, 1.04, 0.85);
}

/// Irradiance of level ground by a whole sky of stars and airglow, linear sRGB: that of 21.5 magnitudes a square second
/// of arc all over.
fn starlight_irradiance() -> vec3f {
    let part = 0.4 * stars.brightness + 0.2 * stars.milky_way + stars.airglow;
    return 3.14159265 * SKY_OF_MAGNITUDE_22 * sun.irradiance * part * vec3f(0.92, 1.03, 0.88);
}
