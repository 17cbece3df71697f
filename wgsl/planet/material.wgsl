// What covers a planet's ground: by latitude and height, with ragged borders.

#include <math/precise.wgsl>
#include <noise/perlin.wgsl>
#include <planet/globe.wgsl>
#include <planet/height.wgsl>

/// What the ground is covered with: forests, deserts and snow, or dust and polar caps.
#option planet.cover = biomes { biomes, dust }
/// Albedo of bare rock.
#param planet.rock: vec3f = (0.20, 0.17, 0.14), color
/// Albedo of snow and ice.
#param planet.snow: vec3f = (0.83, 0.85, 0.88), color
/// Steepest slope that is not bare rock.
#param planet.steepest: f32 = 34.0, range 0 .. 90, unit deg

#if planet.cover == biomes
/// Temperature at sea level on the equator.
#param planet.equator: f32 = 28.0, range -100 .. 100
/// How much colder the poles are.
#param planet.cooling: f32 = 44.0, range 0 .. 200
/// How much of the land is dry: -1 none, 1 all.
#param planet.dryness: f32 = 0.0, range -1 .. 1
/// Albedo of forests in the tropics.
#param planet.jungle: vec3f = (0.022, 0.045, 0.016), color
/// Albedo of forests of the north.
#param planet.forest: vec3f = (0.030, 0.044, 0.022), color
/// Albedo of grassland.
#param planet.grass: vec3f = (0.13, 0.115, 0.048), color
/// Albedo of deserts.
#param planet.desert: vec3f = (0.40, 0.33, 0.22), color
/// Albedo of cold ground without snow.
#param planet.tundra: vec3f = (0.14, 0.12, 0.085), color
#else
/// Albedo of dust.
#param planet.dust: vec3f = (0.32, 0.16, 0.075), color
/// Albedo of plains from which the wind has blown it.
#param planet.bare: vec3f = (0.11, 0.065, 0.045), color
/// Latitude from which ice lies.
#param planet.cap: f32 = 78.0, range 0 .. 90, unit deg
#endif

/// Ground as light finds it.
struct PlanetCover {
    /// Part of the light that is scattered.
    albedo: vec3f,
    /// Part of the sea that is frozen there.
    frozen: f32,
}

const COVER_COARSEST: f32 = 2000000.0; // m
// Noises of each kind: halving down to 2 km; a quarter as wide as the one before down to 8 km; from 31 km down to 2 m.
const COVER_RAGGED: i32 = 11;
const COVER_WIDE: i32 = 5;
const COVER_FINE: i32 = 8;

/// Three sums of noise at `p` (m), about -1 .. 1 each: (ragged, from 2,000 km down to 2 km; fine, from 31 km down to two
/// metres; wide and unlike the first), of what a pixel `footprint` (m) wide shows.
fn planet_mottle(p: vec3f, footprint: f32) -> vec3f {
    let unit = planet_grain();
    let place = planet_place(p, unit);
    let top = i32(log2(COVER_COARSEST / unit));
    let finest = max(log2(2.0 * footprint / unit), 0.0);
    var sum = vec3f(0.0);
    var strength = vec3f(0.8, 0.7, 0.8);
    for (var i = 0; i < COVER_RAGGED + COVER_WIDE + COVER_FINE; i++) {
        var level = top - i;
        if i >= COVER_RAGGED + COVER_WIDE {
            level = top - 6 - 2 * (i - COVER_RAGGED - COVER_WIDE);
        } else if i >= COVER_RAGGED {
            level = top - 2 * (i - COVER_RAGGED);
        }
        let presence = clamp(f32(level) - finest, 0.0, 1.0);
        if level < 0 || presence <= 0.0 {
            continue;
        }
        let scaled = precise_coarser(place, u32(level));
        let n = presence * perlin_noise3_at(scaled.cell, scaled.fraction, planet.seed + 701u + u32(i));
        if i < COVER_RAGGED {
            sum.x += strength.x * n;
            strength.x *= 0.7;
        } else if i < COVER_RAGGED + COVER_WIDE {
            sum.z += strength.z * n;
            strength.z *= 0.6;
        } else {
            sum.y += strength.y * n;
            strength.y *= 0.85;
        }
    }
    return sum;
}

/// What covers the ground at `p` (m), whose `height` is above sea level (m) and whose normal is tilted against the unit
/// `up` by the slope (rise over run) of length `steepness`. Up to 24 noises.
fn planet_cover_at(p: vec3f, up: vec3f, height: f32, steepness: f32, footprint: f32) -> PlanetCover {
    let mottle = planet_mottle(p, footprint);
    let pole = abs(dot(up, vec3f(planet_axes()[0].y, planet_axes()[1].y, planet_axes()[2].y))); // sine of the latitude
    let bare_from = tan(planet.steepest);
    let steep = smoothstep(0.8 * bare_from, 1.25 * bare_from, steepness * (1.0 + 0.3 * mottle.y));
#if planet.cover == biomes
    let latitude = asin(min(pole, 1.0));
    let ragged = 0.7 * mottle.x + 0.2 * mottle.y;
    let warmth = planet.equator - planet.cooling * pole * pole - 0.0062 * max(height, 0.0) + 5.0 * mottle.z + 5.0 * ragged;
    // Rain falls on the equator, little around the tropics, again in the westerlies, and more in the lowlands.
    let belts = 0.08 + 0.72 * exp(-latitude * latitude / 0.05) + 0.58 * smoothstep(0.48, 0.76, latitude);
    let lowland = 0.10 * exp(-max(height, 0.0) / 400.0);
    let wet = belts + lowland + 0.50 * mottle.z + 0.60 * ragged - 0.6 * planet.dryness;
    let sand = mix(planet.rock, planet.desert, smoothstep(-0.35, 0.15, mottle.x - mottle.z + 0.3 * mottle.y))
        * (1.0 + 0.2 * mottle.y);
    var open = mix(sand, planet.grass * (1.0 + 0.45 * mottle.y), smoothstep(0.16, 0.36, wet));
    open = mix(planet.tundra * (1.0 + 0.3 * mottle.y), open, smoothstep(-4.0, 2.0, warmth));
    let wooded = smoothstep(0.34, 0.58, wet) * smoothstep(-5.0, 0.0, warmth);
    let woods = mix(planet.forest, planet.jungle, smoothstep(10.0, 20.0, warmth)) * (1.0 + 0.5 * mottle.y);
    var albedo = mix(open, woods, wooded);
    albedo = mix(albedo, planet.rock * (1.0 + 0.3 * mottle.y), max(steep, smoothstep(3200.0, 5200.0, height) * 0.6));
    let beach = 1.0 - smoothstep(2.0, 7.0, height + 2.0 * mottle.y);
    albedo = mix(albedo, planet.desert, beach * (1.0 - steep));
    let snowy = smoothstep(-7.0, -10.0, warmth) * (1.0 - 0.8 * steep);
    albedo = mix(albedo, planet.snow * (1.0 + 0.08 * mottle.y), snowy);
    let frozen = smoothstep(-12.0, -14.0, warmth);
#else
    let dusty = smoothstep(-0.35, 0.35, mottle.x + 0.35 * mottle.y + 0.00006 * height);
    var albedo = mix(planet.bare, planet.dust, dusty) * (1.0 + 0.18 * mottle.y + 0.12 * mottle.z);
    albedo = mix(albedo, planet.rock * (1.0 + 0.3 * mottle.y), 0.6 * steep);
    let icy = pole + 0.022 * mottle.x + 0.008 * mottle.y + 0.012 * mottle.z - sin(planet.cap);
    let snowy = smoothstep(-0.004, 0.006, icy) * (1.0 - 0.5 * steep);
    albedo = mix(albedo, planet.snow * (1.0 + 0.08 * mottle.y), snowy);
    let frozen = snowy;
#endif
    return PlanetCover(clamp(albedo, vec3f(0.0), vec3f(0.95)), frozen);
}
