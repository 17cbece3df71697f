//! Sums of octaves: their values, gradients, bounds and spectra.

use crate::harness::{Report, Scope, values};
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;
use truth::erosion::{Erosion, erosion2};
use truth::fractal::{Octaves, billow2, damped2, fbm2, fbm2_turned, fbm3, hybrid2, ridged2, warp2};
use truth::noise::{self, gradient};
use truth::points::Random;

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

/// How many octaves the fractals are measured with: four whole ones and a third. The finer the octave, the farther out it is
/// taken: the fifth at a thousand cells, where f32 places a point to 6e-5 of a cell. That is most of the error below.
const COUNT: f64 = 4.3;
/// Their gain and lacunarity; `hybrid` has a gain of .8.
const OCTAVES: Octaves = Octaves { count: COUNT, gain: 0.5, lacunarity: 2.03 };
/// Points of each measurement, and how far from the origin they lie.
const POINTS: usize = 100_000;
const REACH: f32 = 8.0;
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
fn compare(report: &mut Report, name: &str, expression: &str, field: Field<'_>, value_bound: f64) {
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
    report.at_most(&format!("`{name}`: largest error of the value"), error, value_bound);
    report.at_most(
        &format!("`{name}`: largest error of the gradient, over the RMS slope"),
        worst / usual,
        1e-3,
    );
}

#[test]
fn fbm_is_the_sum_of_its_octaves_and_so_is_its_gradient() {
    let mut report = Report::new(SECTION, "fbm_is_the_sum_of_its_octaves_and_so_is_its_gradient");
    compare(&mut report, "fbm2 (Perlin)", "fbm(p, 4.3)", &|p| fbm2(perlin2, p, 3, OCTAVES), 2e-5);
    compare(&mut report, "fbm2 (value)", "value_fbm(p, 4.3)", &|p| fbm2(value2, p, 3, OCTAVES), 2e-5);
    let angle = (-0.8_f64).atan2(0.6);
    let turned = |p| fbm2_turned(perlin2, p, 3, OCTAVES, angle, [5.25, -3.5]);
    compare(&mut report, "fbm2_turned", "turned(p, 4.3)", &turned, 2e-5);
    let normalized = |p| fbm2(perlin2, p, 3, OCTAVES) / OCTAVES.sum();
    compare(&mut report, "fbm2_normalized", "normalized(p)", &normalized, 2e-5);

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
    report.at_most("`fbm3` (value): largest error of the value", value_error, 2e-5);
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
    let billow = |p| billow2(perlin2, p, 3, OCTAVES, 0.2);
    compare(&mut report, "billow2 (roundness .2)", "billow(p, 4.3)", &billow, 2e-5);
    let ridged = |p| ridged2(perlin2, p, 3, OCTAVES, 2.0, 0.2);
    compare(&mut report, "ridged2 (roundness .2)", "ridged(p, 4.3)", &ridged, 2e-5);
    let hybrid = |p| hybrid2(perlin2, p, 3, Octaves { gain: 0.8, ..OCTAVES }, 0.7);
    compare(&mut report, "hybrid2", "hybrid(p, 4.3)", &hybrid, 5e-5);
    report.finish();
}

#[test]
fn warped_and_damped_land_has_its_exact_gradient() {
    let mut report = Report::new(SECTION, "warped_and_damped_land_has_its_exact_gradient");
    let relief = |p, seed| fbm2(perlin2, p, seed, Octaves { count: 4.5, gain: 0.5, lacunarity: 2.0 });
    let drift = |p, seed| fbm2(perlin2, p, seed, Octaves { count: 2.5, gain: 0.4, lacunarity: 2.0 });
    compare(&mut report, "warp2", "warp(p, 0.0)", &|p| warp2(&relief, &drift, p, 3, 1.7, 0.3), 2e-5);
    compare(&mut report, "damped2", "damped(p, 4.3)", &|p| damped2(perlin2, p, 3, OCTAVES, 0.4), 5e-5);
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
    let (mut value_error, mut value_squares, mut values_squared) = (0.0_f64, 0.0, 0.0);
    let (mut slopes, mut highest) = (0.0, 0.0_f64);
    let mut errors = Vec::new();
    for (point, row) in points.iter().zip(&rows) {
        let p = wide([point[0], point[1]]);
        let truth = field(p);
        value_error = value_error.max((row[0] - truth).abs());
        value_squares += (row[0] - truth).powi(2);
        values_squared += truth * truth;
        let slope = gradient(field, p, 1e-5);
        errors.push(length(&[row[1] - slope[0], row[2] - slope[1]]));
        slopes += slope[0] * slope[0] + slope[1] * slope[1];
        highest = highest.max(row[0].abs());
    }
    let count = points.len() as f64;
    let usual = (slopes / count).sqrt();
    errors.sort_by(f64::total_cmp);
    report.told("usual slope", usual);
    report.told("usual slope", (values_squared / count).sqrt());
    report.told("rms value error", (value_squares / count).sqrt());
    report.at_most(
        "`erosion2`: largest error of the value, over the strength",
        value_error / how.strength,
        1e-4,
    );
    for part in [0.5, 0.9, 0.99, 0.999, 0.9999, 1.0] {
        let error = errors[((part * count) as usize).min(errors.len() - 1)];
        report.told(&format!("`erosion2`: error of the gradient, {part}"), error / usual);
    }
    report.at_most("`erosion2`: largest change, over the strength", highest / how.strength, 1.0);
    report.finish();
}
