//! Sums of octaves: their values, gradients, bounds and spectra.

use crate::harness::{Report, Scope, values};
use truth::erosion::{Erosion, erosion2};
use truth::fractal::{Octaves, billow2, damped2, fbm2, fbm2_turned, fbm3, hybrid2, ridged2, warp2};
use truth::noise::{self, gradient};
use truth::points::Random;
use truth::spectrum::{log_power_of_rings, slope_of_line};

const SECTION: &str = "Fractals";

/// Instances over gradient noise, and one function with a plain signature for each fractal.
const INSTANCES: &str = "
#include <noise/perlin.wgsl>
#include <noise/value.wgsl>
#include <noise/pcg.wgsl>
#include <fractal/fbm.wgsl> as plain with noise2 = perlin_noise2_grad
#include <fractal/fbm.wgsl> as blocky with noise2 = value_noise2_grad
#include <fractal/fbm3.wgsl> as space with noise3 = value_noise3_grad
#include <fractal/billow.wgsl> as hills with noise2 = perlin_noise2_grad
#include <fractal/ridged.wgsl> as range with noise2 = perlin_noise2_grad
#include <fractal/hybrid.wgsl> as mixed with noise2 = perlin_noise2_grad
#include <fractal/damped.wgsl> as eased with noise2 = perlin_noise2_jet
#include <fractal/warp.wgsl> as bent with relief = bent_relief, drift = bent_drift
#include <fractal/jets.wgsl> as jets with noise2 = perlin_noise2_jet
#include <fractal/erosion.wgsl>
#include <fractal/octaves.wgsl>
fn bent_relief(p: vec2f, seed: u32) -> vec3f { return plain_fbm2(p, seed, 4.5, 0.5, 2.0); }
fn bent_drift(p: vec2f, seed: u32) -> vec3f { return plain_fbm2(p, seed, 2.5, 0.4, 2.0); }
fn normalized(p: vec2f) -> vec3f { return plain_fbm2_normalized(p, 3u, 4.3, 0.5, 2.03); }
fn fbm(p: vec2f, octaves: f32) -> vec3f { return plain_fbm2(p, 3u, octaves, 0.5, 2.03); }
fn value_fbm(p: vec2f, octaves: f32) -> vec3f { return blocky_fbm2(p, 3u, octaves, 0.5, 2.03); }
fn turned(p: vec2f, octaves: f32) -> vec3f {
    let turn = mat2x2f(vec2f(0.6, -0.8), vec2f(0.8, 0.6));
    return plain_fbm2_turned(p, 3u, octaves, 0.5, 2.03, turn, vec2f(5.25, -3.5));
}
fn billow(p: vec2f, octaves: f32) -> vec3f { return hills_billow2(p, 3u, octaves, 0.5, 2.03, 0.2); }
fn ridged(p: vec2f, octaves: f32) -> vec3f { return range_ridged2(p, 3u, octaves, 0.5, 2.03, 2.0, 0.2); }
fn hybrid(p: vec2f, octaves: f32) -> vec3f { return mixed_hybrid2(p, 3u, octaves, 0.8, 2.03, 0.7); }
fn damped(p: vec2f, octaves: f32) -> vec3f { return eased_damped2(p, 3u, octaves, 0.5, 2.03, 0.4); }
fn warp(p: vec2f, octaves: f32) -> vec3f { return bent_warp2(p, 3u, 1.7, 0.3); }
";

/// How many octaves the fractals are measured with: four whole ones and a third. The finer the octave, the farther out
/// it is taken: the fifth at some 300 cells, where f32 places a point to 3e-5 of a cell. That is most of the error
/// below.
const COUNT: f64 = 4.3;
/// Their gain and lacunarity; `hybrid` has a gain of .8.
const OCTAVES: Octaves = Octaves { count: COUNT, gain: 0.5, lacunarity: 2.03 };
/// Points of each measurement, and how far from the origin they lie.
const POINTS: usize = 100_000;
const REACH: f32 = 8.0;
/// Most that a value is off; the first octave has the strength 1.
const VALUE_ERROR: f64 = 5e-5;
/// Step of the differences, in the fractals' unit; their finest octave is 17 times as fine.
const STEP: f64 = 1e-5;

fn perlin2(p: [f64; 2], seed: u32) -> f64 {
    noise::perlin2(p, None, seed)
}

fn value2(p: [f64; 2], seed: u32) -> f64 {
    noise::value2(p, None, seed)
}

fn value3(p: [f64; 3], seed: u32) -> f64 {
    noise::value3(p, None, seed)
}

type Field<'a> = &'a dyn Fn([f64; 2]) -> f64;

fn library() -> Scope<'static> {
    Scope { fragment: INSTANCES, ..Scope::default() }
}

fn wide<const N: usize>(p: [f32; N]) -> [f64; N] {
    p.map(f64::from)
}

fn length(v: &[f64]) -> f64 {
    v.iter().map(|part| part * part).sum::<f64>().sqrt()
}

/// Measures `expression` (value, gradient) against `field` and its differences; writes three rows.
fn compare(report: &mut Report, name: &str, expression: &str, field: Field<'_>, gradient_bound: f64) {
    let points = Random::new(7).points::<2>(POINTS, REACH);
    let rows = values(expression, &library(), ["x", "y"], &points);
    let mut error = 0.0_f64;
    let mut slopes = 0.0;
    let mut errors = Vec::with_capacity(points.len());
    for (point, row) in points.iter().zip(&rows) {
        let p = wide(*point);
        error = error.max((row[0] - field(p)).abs());
        let slope = gradient(field, p, STEP);
        errors.push(length(&[row[1] - slope[0], row[2] - slope[1]]));
        slopes += slope[0] * slope[0] + slope[1] * slope[1];
    }
    let usual = (slopes / points.len() as f64).sqrt();
    let worst = errors.iter().copied().fold(0.0, f64::max);
    report.at_most(&format!("`{name}`: largest error of the value"), error, VALUE_ERROR);
    report.at_most(
        &format!("`{name}`: largest error of the gradient, over the RMS slope"),
        worst / usual,
        gradient_bound,
    );
}

#[test]
fn fbm_is_the_sum_of_its_octaves_and_so_is_its_gradient() {
    let mut report = Report::new(SECTION, "fbm_is_the_sum_of_its_octaves_and_so_is_its_gradient");
    compare(&mut report, "fbm2 (Perlin)", "fbm(p, 4.3)", &|p| fbm2(perlin2, p, 3, OCTAVES), 1e-3);
    compare(&mut report, "fbm2 (value)", "value_fbm(p, 4.3)", &|p| fbm2(value2, p, 3, OCTAVES), 1e-3);
    let angle = (-0.8_f64).atan2(0.6);
    let turned = |p| fbm2_turned(perlin2, p, 3, OCTAVES, angle, [5.25, -3.5]);
    compare(&mut report, "fbm2_turned", "turned(p, 4.3)", &turned, 1e-3);
    let normalized = |p| fbm2(perlin2, p, 3, OCTAVES) / OCTAVES.sum();
    compare(&mut report, "fbm2_normalized", "normalized(p)", &normalized, 1e-3);

    let octaves = Octaves { count: 4.3, ..OCTAVES };
    let field = |p: [f64; 3]| fbm3(value3, p, 3, octaves);
    let points = Random::new(7).points::<3>(POINTS, REACH);
    let rows = values("space_fbm3(p, 3u, 4.3, 0.5, 2.03)", &library(), ["x", "y", "z"], &points);
    let (mut value_error, mut slope_error, mut slopes) = (0.0_f64, 0.0_f64, 0.0);
    for (point, row) in points.iter().zip(&rows) {
        let p = wide(*point);
        let slope = gradient(field, p, STEP);
        value_error = value_error.max((row[0] - field(p)).abs());
        slope_error = slope_error.max(length(&[row[1] - slope[0], row[2] - slope[1], row[3] - slope[2]]));
        slopes += length(&slope).powi(2);
    }
    let usual = (slopes / points.len() as f64).sqrt();
    report.at_most("`fbm3` (value): largest error of the value", value_error, VALUE_ERROR);
    report.at_most(
        "`fbm3` (value): largest error of the gradient, over the RMS slope",
        slope_error / usual,
        1e-3,
    );
    report.finish();
}

#[test]
fn multifractals_have_their_exact_gradients() {
    let mut report = Report::new(SECTION, "multifractals_have_their_exact_gradients");
    let fewer = Octaves { count: 3.3, ..OCTAVES };
    let billow = |p| billow2(perlin2, p, 3, fewer, 0.2);
    compare(&mut report, "billow2 (roundness .2, 3.3 octaves)", "billow(p, 3.3)", &billow, 1e-3);
    let billow = |p| billow2(perlin2, p, 3, OCTAVES, 0.2);
    compare(&mut report, "billow2 (roundness .2)", "billow(p, 4.3)", &billow, 1e-3);
    let ridged = |p| ridged2(perlin2, p, 3, fewer, 2.0, 0.2);
    compare(&mut report, "ridged2 (roundness .2, 3.3 octaves)", "ridged(p, 3.3)", &ridged, 1e-3);
    // A crest turns within a fifth of the noise's range, and so tells a misplaced point more than other land does.
    let ridged = |p| ridged2(perlin2, p, 3, OCTAVES, 2.0, 0.2);
    compare(&mut report, "ridged2 (roundness .2)", "ridged(p, 4.3)", &ridged, 1e-3);
    let hybrid = |p| hybrid2(perlin2, p, 3, Octaves { gain: 0.8, ..OCTAVES }, 0.7);
    compare(&mut report, "hybrid2", "hybrid(p, 4.3)", &hybrid, 1e-3);
    report.finish();
}

#[test]
fn warped_and_damped_land_has_its_exact_gradient() {
    let mut report = Report::new(SECTION, "warped_and_damped_land_has_its_exact_gradient");
    let relief = |p, seed| fbm2(perlin2, p, seed, Octaves { count: 4.5, gain: 0.5, lacunarity: 2.0 });
    let drift = |p, seed| fbm2(perlin2, p, seed, Octaves { count: 2.5, gain: 0.4, lacunarity: 2.0 });
    compare(&mut report, "warp2", "warp(p, 0.0)", &|p| warp2(&relief, &drift, p, 3, 1.7, 0.3), 1e-3);
    let fewer = Octaves { count: 3.3, ..OCTAVES };
    let damped = |p| damped2(perlin2, p, 3, fewer, 0.4);
    compare(&mut report, "damped2 (3.3 octaves)", "damped(p, 3.3)", &damped, 1e-3);
    let damped = |p| damped2(perlin2, p, 3, OCTAVES, 0.4);
    compare(&mut report, "damped2", "damped(p, 4.3)", &damped, 1e-3);
    report.finish();
}

#[test]
fn eroded_land_has_its_exact_gradient_and_the_change_keeps_its_strength() {
    let mut report =
        Report::new(SECTION, "eroded_land_has_its_exact_gradient_and_the_change_keeps_its_strength");
    let how = Erosion {
        width: 0.5,
        strength: 0.11,
        octaves: 3.6,
        gain: 0.5,
        lacunarity: 2.0,
        assumed_slope: 0.7,
        level_slope: 0.3,
        crest_roundness: 0.1,
        gully_roundness: 0.25,
        bottom: -0.8,
        top: 0.9,
    };
    // Hills: waves of many directions, with their derivatives.
    let waves = [[0.9, 0.5, 0.3, 0.4], [-0.7, 1.1, 1.7, 0.3], [1.9, -0.4, 0.9, 0.2], [0.3, -2.3, 2.1, 0.15]];
    let land = |p: [f64; 2]| {
        let mut jet = [0.0; 6];
        for [kx, ky, phase, a] in waves {
            let (s, c) = (kx * p[0] + ky * p[1] + phase).sin_cos();
            let parts = [s, c * kx, c * ky, -s * kx * kx, -s * kx * ky, -s * ky * ky];
            jet.iter_mut().zip(parts).for_each(|(sum, part)| *sum += a * part);
        }
        jet
    };
    let field = |p| {
        let jet = land(p);
        erosion2(p, jet[0], [jet[1], jet[2]], &how, 5)
    };
    let points: Vec<[f32; 8]> = Random::new(7)
        .points::<2>(POINTS, REACH)
        .into_iter()
        .map(|[x, y]| {
            let [h, gx, gy, hxx, hxy, hyy] = land(wide([x, y])).map(|part| part as f32);
            [x, y, h, gx, gy, hxx, hxy, hyy]
        })
        .collect();
    let expression = "erosion2(vec2f(x, y), Jet2(h, vec2f(gx, gy), vec3f(hxx, hxy, hyy)), \
        Erosion(0.5, 0.11, 3.6, 0.5, 2.0, 0.7, 0.3, 0.1, 0.25, -0.8, 0.9), 5u)";
    let rows = values(expression, &library(), ["x", "y", "h", "gx", "gy", "hxx", "hxy", "hyy"], &points);
    let (mut value_error, mut highest, mut worst, mut slopes) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0);
    for (point, row) in points.iter().zip(&rows) {
        let p = wide([point[0], point[1]]);
        value_error = value_error.max((row[0] - field(p)).abs());
        let slope = gradient(field, p, STEP);
        worst = worst.max(length(&[row[1] - slope[0], row[2] - slope[1]]));
        slopes += slope[0] * slope[0] + slope[1] * slope[1];
        highest = highest.max(row[0].abs());
    }
    let usual = (slopes / points.len() as f64).sqrt();
    report.at_most(
        "`erosion2`: largest error of the value, over the strength",
        value_error / how.strength,
        1e-5,
    );
    report.at_most("`erosion2`: largest error of the gradient, over the RMS slope", worst / usual, 1e-3);
    report.at_most("`erosion2`: largest change, over the strength", highest / how.strength, 1.0);
    report.finish();
}

/// The fractals by number, and what each promises: (lowest, highest, steepest).
const NUMBERED: &str = "
fn numbered(which: u32, p: vec2f, octaves: f32) -> vec3f {
    switch which {
        case 0u: { return fbm(p, octaves); }
        case 1u: { return billow(p, octaves); }
        case 2u: { return ridged(p, octaves); }
        case 3u: { return hybrid(p, octaves); }
        case 4u: { return damped(p, octaves); }
        default: { return warp(p, octaves); }
    }
}
fn promised(which: u32, octaves: f32) -> vec3f {
    let slope = PERLIN_NOISE2_SLOPE;
    let sum = plain_fbm_bound(octaves, 0.5);
    switch which {
        case 0u: { return vec3f(-sum, sum, plain_fbm_slope_bound(octaves, 0.5, 2.03, slope)); }
        case 1u: {
            return vec3f(hills_billow_bound(octaves, 0.5), hills_billow_slope_bound(octaves, 0.5, 2.03, 0.2, slope));
        }
        case 2u: {
            return vec3f(range_ridged_bound(octaves, 0.5), range_ridged_slope_bound(octaves, 0.5, 2.03, 2.0, slope));
        }
        case 3u: {
            let range = mixed_hybrid_bound(octaves, 0.8, 0.7);
            return vec3f(range, mixed_hybrid_slope_bound(octaves, 0.8, 2.03, 0.7, slope));
        }
        case 4u: {
            let bound = eased_damped_slope_bound(octaves, 0.5, 2.03, 0.4, slope, PERLIN_NOISE2_CURVATURE);
            let most = eased_damped_bound(octaves, 0.5);
            return vec3f(-most, most, bound);
        }
        default: {
            let relief = plain_fbm_slope_bound(4.5, 0.5, 2.0, slope);
            let drift = plain_fbm_slope_bound(2.5, 0.4, 2.0, slope);
            let most = plain_fbm_bound(4.5, 0.5);
            return vec3f(-most, most, bent_warp_slope_bound(1.7, 0.3, relief, drift));
        }
    }
}
fn extremes(which: u32, k: u32) -> vec3f {
    var found = vec3f(1e9, -1e9, 0.0);
    for (var i = 0u; i < 500u; i++) {
        let p = 400.0 * unit_float2(pcg2d(vec2u(k, i))) - 200.0;
        let land = numbered(which, p, 4.3);
        found = vec3f(min(found.x, land.x), max(found.y, land.x), max(found.z, length(land.yz)));
    }
    return found;
}
/// The largest change of value and of slope from k - 1e-4 to k + 1e-4 octaves, k = 1 .. 7.
fn jump(which: u32, k: u32) -> vec2f {
    var worst = vec2f(0.0);
    for (var i = 1u; i < 8u; i++) {
        let p = 40.0 * unit_float2(pcg2d(vec2u(k, i))) - 20.0;
        let change = numbered(which, p, f32(i) + 1e-4) - numbered(which, p, f32(i) - 1e-4);
        worst = max(worst, vec2f(abs(change.x), length(change.yz)));
    }
    return worst;
}
";
const NAMES: [&str; 6] = ["fbm2", "billow2", "ridged2", "hybrid2", "damped2", "warp2"];

#[test]
fn fractals_keep_their_bounds_of_value_and_slope() {
    let mut report = Report::new(SECTION, "fractals_keep_their_bounds_of_value_and_slope");
    let fragment = format!("{INSTANCES}{NUMBERED}");
    let scope = Scope { fragment: &fragment, ..Scope::default() };
    let all: Vec<[f32; 2]> =
        (0..6).flat_map(|which| (0..2000).map(move |k| [which as f32, k as f32])).collect();
    let rows = values("extremes(which, k)", &scope, ["which:u32", "k:u32"], &all);
    let promised =
        values("promised(which, 4.3)", &scope, ["which:u32"], &[[0.0], [1.0], [2.0], [3.0], [4.0], [5.0]]);
    for (which, name) in NAMES.iter().enumerate() {
        let found = &rows[2000 * which..2000 * (which + 1)];
        let lowest = found.iter().map(|row| row[0]).fold(f64::MAX, f64::min);
        let highest = found.iter().map(|row| row[1]).fold(f64::MIN, f64::max);
        let steepest = found.iter().map(|row| row[2]).fold(0.0, f64::max);
        let [low, high, steep] = promised[which][..] else { panic!("three numbers") };
        report.at_least(&format!("`{name}`: lowest of 1e6 values"), lowest, low);
        report.at_most(&format!("`{name}`: highest of 1e6 values"), highest, high);
        report.at_most(&format!("`{name}`: steepest of 1e6 slopes"), steepest, steep);
    }
    report.finish();
}

#[test]
fn octaves_come_in_without_a_jump() {
    let mut report = Report::new(SECTION, "octaves_come_in_without_a_jump");
    let fragment = format!("{INSTANCES}{NUMBERED}");
    let scope = Scope { fragment: &fragment, ..Scope::default() };
    let all: Vec<[f32; 2]> =
        (0..5).flat_map(|which| (0..4000).map(move |k| [which as f32, k as f32])).collect();
    let rows = values("jump(which, k)", &scope, ["which:u32", "k:u32"], &all);
    for (which, name) in NAMES[..5].iter().enumerate() {
        let found = &rows[4000 * which..4000 * (which + 1)];
        let jump = found.iter().map(|row| row[0]).fold(0.0, f64::max);
        report.at_most(
            &format!("`{name}`: change of the value over 2e-4 octaves, at whole counts"),
            jump,
            4e-4,
        );
        let jump = found.iter().map(|row| row[1]).fold(0.0, f64::max);
        report.at_most(
            &format!("`{name}`: change of the slope over 2e-4 octaves, at whole counts"),
            jump,
            4e-3,
        );
    }
    report.finish();
}

#[test]
fn jets_are_the_fractals_with_their_second_derivatives() {
    let mut report = Report::new(SECTION, "jets_are_the_fractals_with_their_second_derivatives");
    let points = Random::new(9).points::<2>(POINTS, REACH);
    let rows = |expression: &str| values(expression, &library(), ["x", "y"], &points);
    let fields: [(&str, &str, &str, Field<'_>); 3] = [
        ("fbm2_jet", "jets_fbm2_jet(p, 3u, 3.3, 0.5, 2.03)", "fbm(p, 3.3)", &|p| {
            fbm2(perlin2, p, 3, Octaves { count: 3.3, ..OCTAVES })
        }),
        ("ridged2_jet", "jets_ridged2_jet(p, 3u, 3.3, 0.5, 2.03, 2.0, 0.2)", "ridged(p, 3.3)", &|p| {
            ridged2(perlin2, p, 3, Octaves { count: 3.3, ..OCTAVES }, 2.0, 0.2)
        }),
        ("hybrid2_jet", "jets_hybrid2_jet(p, 3u, 3.3, 0.8, 2.03, 0.7)", "hybrid(p, 3.3)", &|p| {
            hybrid2(perlin2, p, 3, Octaves { count: 3.3, gain: 0.8, ..OCTAVES }, 0.7)
        }),
    ];
    for (name, jet, plain, field) in fields {
        let jets = rows(jet);
        let plains = rows(plain);
        let mut apart = 0.0_f64;
        let mut steep = 0.0_f64;
        let mut errors = Vec::with_capacity(points.len());
        let mut bends = 0.0;
        for ((point, jet), plain) in points.iter().zip(&jets).zip(&plains) {
            apart = apart.max((jet[0] - plain[0]).abs());
            steep = steep.max(length(&[jet[1] - plain[1], jet[2] - plain[2]]));
            let truth = noise::hessian(field, wide(*point), 1e-4);
            errors.push(length(&[jet[3] - truth[0], jet[4] - truth[1], jet[5] - truth[2]]));
            bends += length(&truth).powi(2);
        }
        let usual = (bends / points.len() as f64).sqrt();
        errors.sort_by(f64::total_cmp);
        report.at_most(&format!("`{name}`: value, off that without derivatives"), apart, 1e-5);
        report.at_most(&format!("`{name}`: gradient, off that without second derivatives"), steep, 1e-3);
        let most = errors[errors.len() * 999 / 1000] / usual;
        report.at_most(
            &format!("`{name}`: error of the second derivatives over their RMS, 99.9 % of points"),
            most,
            0.01,
        );
        report.told(&format!("`{name}`: the same, all points"), errors[errors.len() - 1] / usual);
    }
    report.finish();
}

const ANY_LAND: &str = "
fn at_random(k: u32, i: u32, low: f32, high: f32) -> f32 {
    return mix(low, high, unit_float(pcg_cell2(vec2i(vec2u(k, i)), 11u)));
}
/// The largest change over the strength, and how many results are no numbers: any land, however wild.
fn largest_change(k: u32) -> vec2f {
    var found = vec2f(0.0);
    for (var i = 0u; i < 250u; i++) {
        let n = 20u * i;
        let p = vec2f(at_random(k, n, -99.0, 99.0), at_random(k, n + 1u, -99.0, 99.0));
        let level = select(0.0, 1.0, (i & 7u) != 0u); // an eighth of it level
        let steep = level * vec2f(at_random(k, n + 2u, -3.0, 3.0), at_random(k, n + 3u, -3.0, 3.0));
        let bend_x = vec2f(at_random(k, n + 4u, -9.0, 9.0), at_random(k, n + 5u, -9.0, 9.0));
        let bend = vec3f(bend_x, at_random(k, n + 6u, -9.0, 9.0));
        let land = Jet2(at_random(k, n + 7u, -2.0, 2.0), steep, bend);
        let how = Erosion(
            at_random(k, n + 8u, 0.1, 3.0), 0.3, at_random(k, n + 9u, 0.0, 8.0), at_random(k, n + 10u, 0.1, 0.9),
            at_random(k, n + 11u, 1.3, 3.0), at_random(k, n + 12u, 0.1, 3.0), at_random(k, n + 13u, 0.01, 1.0),
            at_random(k, n + 14u, 0.0, 1.0), at_random(k, n + 15u, 0.0, 1.0), -1.0, 1.0,
        );
        let change = erosion2(p, land, how, n);
        let sound = all(abs(change) < vec3f(1e30));
        found = vec2f(max(found.x, abs(change.x) / 0.3), found.y + select(1.0, 0.0, sound));
    }
    return found;
}
fn octave_jump(k: u32) -> vec2f {
    let p = 40.0 * unit_float2(pcg2d(vec2u(k, 3u))) - 20.0;
    let land = jets_fbm2_jet(0.3 * p, 3u, 3.0, 0.5, 2.0);
    let base = Jet2(land.value, 0.3 * land.gradient, 0.09 * land.hessian);
    let whole = f32(1u + k % 6u);
    let fewer = Erosion(0.5, 1.0, whole - 1e-4, 0.5, 2.0, 3.0, 0.3, 0.1, 0.25, -1.0, 1.0);
    var more = fewer;
    more.octaves = whole + 1e-4;
    let change = erosion2(p, base, more, 5u) - erosion2(p, base, fewer, 5u);
    return vec2f(abs(change.x), length(change.yz));
}
";

#[test]
fn erosion_stays_within_its_strength_on_any_land() {
    let mut report = Report::new(SECTION, "erosion_stays_within_its_strength_on_any_land");
    let fragment = format!("{INSTANCES}{ANY_LAND}");
    let scope = Scope { fragment: &fragment, ..Scope::default() };
    let all: Vec<[f32; 1]> = (0..4000).map(|k| [k as f32]).collect();
    let rows = values("largest_change(k)", &scope, ["k:u32"], &all);
    let largest = rows.iter().map(|row| row[0]).fold(0.0, f64::max);
    report.at_most("`erosion2`: largest of 1e6 changes, over the strength", largest, 1.0 + 1e-6);
    report.at_most(
        "`erosion2`: results that are no numbers, of 1e6",
        rows.iter().map(|row| row[1]).sum(),
        0.0,
    );
    let rows = values("octave_jump(k)", &scope, ["k:u32"], &all);
    let jump = rows.iter().map(|row| row[0]).fold(0.0, f64::max);
    report.at_most("`erosion2`: change over 2e-4 octaves at whole counts, over the strength", jump, 4e-4);
    report.finish();
}

const ROW: &str = "
/// Sixteen neighbours of a map of 2048 x 2048, `cells` of the first octave across.
fn sixteen(at: u32, cells: f32, gain: f32, blocky: u32) -> mat4x4f {
    let corner = vec2u(16u * (at & 127u), at >> 7u);
    var found: mat4x4f;
    for (var i = 0u; i < 16u; i++) {
        let p = cells / 2048.0 * (vec2f(corner + vec2u(i, 0u)) + 0.5);
        var value = 0.0;
        if blocky == 1u {
            value = blocky_fbm2(p, 3u, 8.0, gain, 2.0).x;
        } else {
            value = plain_fbm2(p, 3u, 8.0, gain, 2.0).x;
        }
        found[i / 4u][i % 4u] = value;
    }
    return found;
}
";
const SIZE: usize = 2048;

/// An octave's power has a hump, so the sum's spectrum has ripples, an octave long, on its line. Three maps a third of
/// an octave apart, 5, 6.3 and 7.94 cells of the first octave across, have them at different places; the mean of their
/// logarithms is fitted.
#[test]
fn spectra_of_fbm_fall_as_the_hurst_exponent_says() {
    let mut report = Report::new(SECTION, "spectra_of_fbm_fall_as_the_hurst_exponent_says");
    let fragment = format!("{INSTANCES}{ROW}");
    let scope = Scope { fragment: &fragment, ..Scope::default() };
    let all: Vec<[f32; 1]> = (0..SIZE * SIZE / 16).map(|at| [at as f32]).collect();
    for (blocky, name, tolerance) in [(0, "Perlin", 0.06), (1, "value", 0.1)] {
        for hurst in [0.3, 0.5, 0.8] {
            let maps = [5.0, 6.2996, 7.937].map(|cells| {
                let expression = format!("sixteen(at, {cells:.4}, fbm_gain({hurst}, 2.0), {blocky}u)");
                let map: Vec<f64> = values(&expression, &scope, ["at:u32"], &all).concat();
                log_power_of_rings(&map, SIZE, 128)
            });
            let line: Vec<_> = (32..=128)
                .map(|ring| ((ring as f64).ln(), maps.iter().map(|rings| rings[ring]).sum::<f64>() / 3.0))
                .collect();
            let what =
                format!("`fbm2` ({name}), H = {hurst}: slope of the spectrum, rings 32 .. 128 of 2048²");
            report.near(&what, slope_of_line(&line), -2.0 * hurst - 2.0, tolerance);
        }
    }
    report.finish();
}
