// The map of a planet with oceans, continents, chains of mountains and hills.

#include <math/precise.wgsl>
#include <planet/forms.wgsl>

/// Part of the planet that lies below sea level, on average over many planets.
#param planet.ocean: f32 = 0.68, range 0.02 .. 0.98
/// Depth of the sea floor beyond the shelf.
#param planet.sea_floor: f32 = 3800.0, range 0 .. 20000, unit m
/// How wide the chains of mountains are, as a part of the distance between them.
#param planet.chains: f32 = 0.16, range 0.02 .. 1
/// How high the hills beside the chains are, as a part of `planet.peak_height`.
#param planet.hills: f32 = 0.10, range 0 .. 1

const CONTINENT_OCTAVES: i32 = 9;
const CONTINENT_GAIN: f32 = 0.58;
const CONTINENT_DEVIATION: f32 = 0.373; // of their sum: 0.304 sqrt(1 + gain² + …)
const RIDGE_COARSEST: i32 = 7; // octaves below the largest forms
const RIDGE_MEAN: f32 = 0.56; // of (1 - sqrt(n² + 0.004))²
// One list of noises for all parts, so that software GPUs, which copy what is called, copy one noise:
// two that bend, two of the chains, the continents, then ridges until what is left is too small.
const CONTINENT_CHAINS: i32 = 2;
const CONTINENT_FIRST: i32 = 4;
const CONTINENT_RIDGES: i32 = CONTINENT_FIRST + CONTINENT_OCTAVES;
const CONTINENT_TURNS: i32 = CONTINENT_RIDGES + 24;

/// (height in m, its slope per grain) at the place `cell` + `fraction` (grains) of the map's plane, x and y of them; no
/// octaves below level `finest`, which may be fractional.
fn planet_map(cell: vec3i, fraction: vec3f, finest: f32) -> vec3f {
    let top = i32(planet.octaves);
    let straight = Precise(cell, fraction);
    var place = straight;
    var bent_x = vec3f(0.0);
    var bent_y = vec3f(0.0);
    var land = vec3f(0.0); // value, slope per grain
    var chain = vec3f(0.0);
    var ridges = vec3f(RIDGE_MEAN, 0.0, 0.0);
    var rough = vec3f(1.0, 0.0, 0.0); // ridges grow on ridges
    var strength = 1.0;
    for (var i = 0; i < CONTINENT_TURNS; i++) {
        var level = top;
        if i >= CONTINENT_RIDGES {
            level = top - RIDGE_COARSEST - (i - CONTINENT_RIDGES);
        } else if i >= CONTINENT_FIRST {
            level = top - (i - CONTINENT_FIRST);
        } else if i >= CONTINENT_CHAINS {
            level = top - (i - CONTINENT_CHAINS);
        }
        let presence = clamp(f32(level) - finest, 0.0, 1.0);
        if level < 0 || presence <= 0.0 {
            if i >= CONTINENT_RIDGES {
                break;
            }
            continue;
        }
        if i == CONTINENT_RIDGES {
            place = straight; // a bend is thousands of kilometres long, and would blur what is a metre wide
        }
        let n = forms_octave(place, level, i);
        let noise = presence * n;
        if i == 0 {
            bent_x = planet.bend * exp2(f32(top)) * noise;
        } else if i == 1 {
            bent_y = planet.bend * exp2(f32(top)) * noise;
            place = precise_moved(straight, vec3f(bent_x.x, bent_y.x, 0.0));
        } else if i < CONTINENT_FIRST {
            chain += select(1.0, 0.45, i > CONTINENT_CHAINS) * noise;
        } else if i < CONTINENT_RIDGES {
            land += strength * noise;
            strength *= CONTINENT_GAIN;
        } else {
            // A ridge with a rounded crest: 1 - sqrt(n² + r²), squared.
            let round = sqrt(n.x * n.x + 0.004);
            let crest = 1.0 - round;
            let ridge = vec3f(crest * crest, -2.0 * crest * n.x / round * n.yz);
            let grown = vec3f(rough.x * ridge.x, rough.x * ridge.yz + ridge.x * rough.yz);
            // Centred: leaving one out does not sink the land.
            ridges += strength * presence * (grown - RIDGE_MEAN * rough);
            strength *= planet.gain;
            rough = select(1.8 * grown, vec3f(1.0, 0.0, 0.0), 1.8 * grown.x >= 1.0);
        }
        if i == CONTINENT_RIDGES - 1 {
            strength = 1.0;
        }
    }
    ridges *= 1.0 - planet.gain; // about 0 .. 1

    // From the sum of the continents' octaves to height: the shelf's edge, the shore, the land.
    let shore = CONTINENT_DEVIATION * normal_quantile(planet.ocean);
    let rise = land.x - shore;
    let shelf = smooth_rise(-0.34, -0.05, rise);
    let inland = smooth_rise(-0.03, 0.22, rise);
    var height = planet.swell * rise - planet.sea_floor * (1.0 - shelf.x);
    var slope = (planet.swell + planet.sea_floor * shelf.y) * land.yz;

    // The chains run along the zero line of their noise.
    let across = chain.x / planet.chains;
    let inside = exp(-min(across * across, 60.0));
    let inside_slope = -2.0 * across / planet.chains * inside * chain.yz;
    let share = planet.hills + (1.0 - planet.hills) * inside;
    let reach = inland.x * share;
    let reach_slope = inland.y * share * land.yz + inland.x * (1.0 - planet.hills) * inside_slope;
    let peak = 1.5 * planet.peak_height;
    height += peak * reach * ridges.x;
    slope += peak * ridges.x * reach_slope;

    // Back through the bend: the transposed Jacobian.
    slope += slope.x * bent_x.yz + slope.y * bent_y.yz;
    return vec3f(height, slope + peak * reach * ridges.yz);
}

/// (smoothstep from `low` to `high`, its derivative).
fn smooth_rise(low: f32, high: f32, value: f32) -> vec2f {
    let t = clamp((value - low) / (high - low), 0.0, 1.0);
    return vec2f(t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / (high - low));
}

/// Where the standard normal distribution has `part` (0.02 .. 0.98) below; error below 4.5e-4 (Abramowitz & Stegun
/// 26.2.23).
fn normal_quantile(part: f32) -> f32 {
    let tail = min(part, 1.0 - part);
    let t = sqrt(-2.0 * log(tail));
    let above = t - (2.515517 + t * (0.802853 + t * 0.010328))
        / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    return select(-above, above, part > 0.5);
}

/// A height (m) that the ground nowhere exceeds.
fn planet_ceiling() -> f32 {
    return 3.0 * planet.swell + 1.5 * planet.peak_height;
}
