// The map of a dry planet: highlands and lowlands, struck by impacts of all sizes.

#include <math/precise.wgsl>
#include <planet/forms.wgsl>

/// Part of the places for a crater that have one.
#param planet.craters: f32 = 0.45, range 0 .. 1
/// Depth of the craters over that of fresh ones.
#param planet.crater_depth: f32 = 0.7, range 0 .. 2
/// Width of the places for the largest craters, as a part of `planet.scale`, in halvings.
#param planet.crater_coarsest: u32 = 3, range 0 .. 12

const CRATER_FORMS: i32 = 5; // octaves of the large forms, after two that bend
const CRATER_GAIN: f32 = 0.5;
const CRATER_ROUGH: i32 = 2 + CRATER_FORMS;
const CRATER_TURNS: i32 = CRATER_ROUGH + 24;
const CRATER_SCALES: i32 = 7; // each a quarter of the one before

/// (height in m, its slope per grain) at the place `cell` + `fraction` (grains) of the map's plane, x and y of them; no
/// forms below level `finest`, which may be fractional.
fn planet_map(cell: vec3i, fraction: vec3f, finest: f32) -> vec3f {
    let top = i32(planet.octaves);
    let straight = Precise(cell, fraction);
    var place = straight;
    var bent_x = vec3f(0.0);
    var bent_y = vec3f(0.0);
    var land = vec3f(0.0); // value, slope per grain
    var ridges = vec3f(0.0);
    var strength = 1.0;
    for (var i = 0; i < CRATER_TURNS; i++) {
        let level = select(top - (i - 2), top, i < 2);
        let presence = clamp(f32(level) - finest, 0.0, 1.0);
        if level < 0 || presence <= 0.0 {
            break;
        }
        if i == CRATER_ROUGH {
            place = straight; // a bend is thousands of kilometres long, and would blur what is a metre wide
        }
        let noise = presence * forms_octave(place, level, i);
        if i == 0 {
            bent_x = planet.bend * exp2(f32(top)) * noise;
        } else if i == 1 {
            bent_y = planet.bend * exp2(f32(top)) * noise;
            place = precise_moved(straight, vec3f(bent_x.x, bent_y.x, 0.0));
        } else if i < CRATER_ROUGH {
            land += strength * noise;
            strength = select(CRATER_GAIN * strength, 1.0, i + 1 == CRATER_ROUGH);
        } else {
            ridges += strength * noise;
            strength *= planet.gain;
        }
    }
    // Lowlands and highlands with a slope between them.
    let step = crater_rise(-0.15, 0.35, land.x);
    var height = planet.swell * (0.5 * land.x + 1.2 * (step.x - 0.5));
    var slope = planet.swell * (0.5 + 1.2 * step.y) * land.yz;
    let rough = planet.peak_height * (1.0 - planet.gain) * (0.25 + 0.75 * step.x);
    height += rough * ridges.x;
    slope += 0.75 * planet.peak_height * (1.0 - planet.gain) * ridges.x * step.y * land.yz;
    slope += slope.x * bent_x.yz + slope.y * bent_y.yz; // back through the bend: the transposed Jacobian
    let struck = crater_sum(cell, fraction, finest);
    return vec3f(height + struck.x, slope + rough * ridges.yz + struck.yz);
}

/// All craters: (height in m, slope per grain). Four places for each size.
fn crater_sum(cell: vec3i, fraction: vec3f, finest: f32) -> vec3f {
    var sum = vec3f(0.0);
    var scaled = Precise(cell, fraction);
    for (var i = 0; i < 4 * CRATER_SCALES; i++) {
        let level = i32(planet.octaves) - i32(planet.crater_coarsest) - 2 * (i / 4);
        // A crater is about a third of its place wide.
        let presence = clamp(f32(level) - 1.0 - finest, 0.0, 1.0);
        if level < 0 || presence <= 0.0 {
            break;
        }
        let width = exp2(f32(level)); // grains
        if (i & 3) == 0 {
            scaled = precise_coarser(Precise(cell, fraction), u32(level));
        }
        // The four places whose middles are nearest.
        let t = scaled.fraction.xy;
        let toward = vec2i(select(vec2f(-1.0), vec2f(1.0), t >= vec2f(0.5)));
        let step = vec2i(i & 1, (i >> 1) & 1) * toward;
        let bits = pcg_cell2(scaled.cell.xy + step, planet.seed + 977u + u32(level));
        let where_in = unit_float2(pcg2d(vec2u(bits, 5u)));
        let kind = unit_float2(pcg2d(vec2u(bits, 6u)));
        if kind.x >= planet.craters {
            continue;
        }
        // Many small ones, few large ones.
        let radius = 0.09 + 0.28 * kind.y * kind.y * kind.y;
        let middle = vec2f(step) + 0.25 + 0.5 * where_in;
        let from_middle = t - middle;
        let reach = length(from_middle) / radius;
        if reach >= 2.0 {
            continue;
        }
        let profile = crater_profile(reach);
        let depth = presence * planet.crater_depth * crater_fresh_depth(2.0 * radius * width * planet_grain());
        sum += depth * vec3f(profile.x, profile.y * from_middle / max(reach * radius * radius * width, 1e-6));
    }
    return sum;
}

/// Depth (m) of a fresh crater `diameter` (m) wide, from floor to rim: bowls up to about 7 km, flatter ones beyond (Garvin
/// et al. 2003, of Mars).
fn crater_fresh_depth(diameter: f32) -> f32 {
    let km = max(0.001 * diameter, 1e-4);
    return 1000.0 * min(0.21 * pow(km, 0.81), 0.36 * pow(km, 0.49));
}

/// A crater of depth 1 at `reach` radii from its middle: (height over the plain, its derivative). A flat floor, a wall, a
/// rim that falls off over one radius; 0 from 2 on, with continuous slope.
fn crater_profile(reach: f32) -> vec2f {
    let wall = crater_rise(0.35, 1.0, reach);
    let u = clamp((reach - 1.0) / select(1.0, 0.45, reach < 1.0), -1.0, 1.0);
    let bump = (1.0 - u * u) * (1.0 - u * u);
    let bump_slope = -4.0 * u * (1.0 - u * u) / select(1.0, 0.45, reach < 1.0);
    return vec2f(0.8 * (wall.x - 1.0) + 0.2 * bump, 0.8 * wall.y + 0.2 * bump_slope);
}

/// (smoothstep from `low` to `high`, its derivative).
fn crater_rise(low: f32, high: f32, value: f32) -> vec2f {
    let t = clamp((value - low) / (high - low), 0.0, 1.0);
    return vec2f(t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / (high - low));
}

/// A height (m) that the ground nowhere exceeds.
fn planet_ceiling() -> f32 {
    // Rims of all sizes on one another, each at most a fifth of its depth: half of the next larger size's.
    let largest = crater_fresh_depth(0.74 * planet.scale * exp2(-f32(planet.crater_coarsest)));
    return 1.7 * planet.swell + planet.peak_height + 0.6 * planet.crater_depth * largest;
}
