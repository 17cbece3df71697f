//! The land: its slope is that of its height, in every relief, and its ceiling is one.

use orogen::Preset;
use truth::points::Random;

use crate::harness::{Report, Scope, values};

/// Reliefs by the settings that make them.
const RELIEFS: [(&str, &[&str]); 12] = [
    ("fBm", &["terrain.relief=fbm", "terrain.eroded=false", "terrain.rough=false"]),
    ("fBm of value noise", &["terrain.relief=fbm", "terrain.basis=value"]),
    ("fBm of simplex noise", &["terrain.relief=fbm", "terrain.basis=simplex"]),
    ("billow", &["terrain.relief=billow"]),
    ("ridged", &["terrain.relief=ridged"]),
    ("ridged, not eroded", &["terrain.relief=ridged", "terrain.eroded=false"]),
    ("hybrid", &["terrain.relief=hybrid"]),
    ("damped", &["terrain.relief=damped"]),
    ("dual", &["terrain.dual=true"]),
    ("distorted", &["terrain.distorted=true"]),
    ("dunes", &["terrain.relief=dunes"]),
    ("terraces", &["terrain.relief=terraces"]),
];

/// The preset of a relief with three octaves of forms and two of roughness; its finest octave is hundreds of metres wide, so that differences over metres tell its slope
/// in spite of what f32 rounds off heights of a thousand.
fn land(settings: &[&str]) -> Preset {
    let mut preset = Preset::of_module("terrain/height.wgsl");
    for setting in [&["terrain.octaves=5", "terrain.forms=3"], settings].concat() {
        preset.set(setting).unwrap();
    }
    preset
}

#[test]
fn the_land_s_slope_is_that_of_its_height() {
    let mut report = Report::new("Terrain", "the_land_s_slope_is_that_of_its_height");
    let points: Vec<[f32; 2]> = Random::new(31).points(20_000, 2_000.0);
    // Fourth-order differences on a ring of eight neighbours.
    let fragment = "#include <terrain/height.wgsl>
         fn slope_by_differences(p: vec2f, step: f32) -> vec2f {
             var sum = vec2f(0.0);
             for (var i = 0; i < 8; i++) {
                 let axis = select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), i < 4);
                 let far = (i & 1) == 1;
                 let side = select(1.0, -1.0, (i & 2) == 2);
                 let offset = side * select(step, 2.0 * step, far);
                 sum += axis * side * select(8.0, -1.0, far) * terrain_height(p + offset * axis);
             }
             return sum / (12.0 * step);
         }";
    for (name, settings) in RELIEFS {
        let preset = land(settings);
        let scope = Scope { fragment, preset: Some(&preset), ..Scope::default() };
        let step = if name == "dunes" { 2.0 } else { 6.0 }; // a slip face of dunes is some 20 m wide
        let expression = format!("vec4f(terrain_height_grad(p).yz, slope_by_differences(p, {step:?}))");
        let rows = values(&expression, &scope, ["x", "y"], &points);
        let mean = rows.iter().map(|row| row[0].hypot(row[1])).sum::<f64>() / rows.len() as f64;
        let mut errors: Vec<f64> =
            rows.iter().map(|row| (row[0] - row[2]).hypot(row[1] - row[3]) / mean).collect();
        errors.sort_by(f64::total_cmp);
        let median = errors[errors.len() / 2];
        let p95 = errors[errors.len() * 95 / 100];
        report.at_most(
            &format!("{name}: slope against differences over {step} m, relative to the mean slope, median"),
            median,
            1e-3,
        );
        if matches!(name, "dunes" | "terraces") {
            report.told(&format!("{name}: the same, 95 % (the rest are creases)"), p95);
        } else {
            report.at_most(&format!("{name}: the same, 95 %"), p95, 2e-2);
        }
    }
    report.finish();
}

#[test]
fn the_land_stays_between_its_floor_and_its_ceiling() {
    let mut report = Report::new("Terrain", "the_land_stays_between_its_floor_and_its_ceiling");
    let fragment = "#include <terrain/height.wgsl>
         fn lowest_and_highest_around(p: vec2f) -> vec2f {
             var bounds = vec2f(1e9, -1e9);
             for (var i = 0; i < 64; i++) {
                 let height = terrain_height(p + vec2f(f32(i % 8), f32(i / 8)) * 137.7);
                 bounds = vec2f(min(bounds.x, height), max(bounds.y, height));
             }
             return bounds;
         }";
    let points: Vec<[f32; 2]> = Random::new(32).points(2_000, 200_000.0);
    for (name, settings) in RELIEFS {
        let mut preset = land(settings);
        preset.set("terrain.octaves=13").unwrap();
        preset.set("terrain.forms=4").unwrap();
        let scope = Scope { fragment, preset: Some(&preset), ..Scope::default() };
        let expression = "vec4f(lowest_and_highest_around(p), terrain_floor(), terrain_ceiling())";
        let rows = values(expression, &scope, ["x", "y"], &points);
        let highest = rows.iter().map(|row| row[1] / row[3]).fold(f64::MIN, f64::max);
        report.at_most(&format!("{name}: highest of 128,000 places, as a part of the ceiling"), highest, 1.0);
        // Some floors are 0: how far above it, as a part of all the height there may be.
        let above = rows.iter().map(|row| (row[0] - row[2]) / (row[3] - row[2])).fold(f64::MAX, f64::min);
        report.at_least(&format!("{name}: lowest of 128,000 places over the floor, likewise"), above, 0.0);
    }
    report.finish();
}
