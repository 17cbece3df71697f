//! The march through a volume: what comes through, what is gathered, that no step count makes energy.

use truth::volume::{Seen, seen, through};

use crate::harness::{Report, Scope, values};

const SECTION: &str = "March through a volume";

/// Rays run along x; y is the extinction, so that one shader serves all of it, and z says how it is spread over x.
const FIELDS: &str = "
#include <march/volume.wgsl> as lit with density = test_density, vacancy = test_vacancy, span = test_span, source = test_lit
#include <march/volume.wgsl> as white with density = test_density, vacancy = test_vacancy, span = test_span, source = test_white

fn test_density(p: vec3f, footprint: f32) -> f32 {
    if p.z < 0.5 {
        return p.y;
    }
    if p.z < 1.5 {
        return p.y * select(0.0, select(3.0, 1.0, p.x < 200.0), p.x >= 100.0 && p.x < 260.0);
    }
    if p.z < 2.5 {
        return p.y * exp(-p.x / 300.0);
    }
    let q = (p.x - 500.0) / 120.0;
    return p.y * max(1.0 - q * q, 0.0);
}

fn test_vacancy(p: vec3f) -> f32 {
    return select(0.0, max(abs(p.x - 500.0) - 120.0, 0.0), p.z > 2.5);
}

fn test_span(origin: vec3f, direction: vec3f) -> vec2f {
    return vec2f(0.0, max(select(origin.x, 1000.0 - origin.x, direction.x > 0.0), 0.0));
}

fn test_lit(p: vec3f, direction: vec3f, extinction: f32, light_depth: f32) -> vec3f {
    return vec3f(exp(-light_depth), 1.0, 0.5);
}

fn test_white(p: vec3f, direction: vec3f, extinction: f32, light_depth: f32) -> vec3f {
    return vec3f(1.0);
}
";

/// The same fields: constant, two layers, exponential, a blob.
fn field(kind: usize, sigma: f64) -> impl Fn(f64) -> f64 {
    move |x| {
        sigma
            * match kind {
                0 => 1.0,
                1 if (100.0..200.0).contains(&x) => 1.0,
                1 if (200.0..260.0).contains(&x) => 3.0,
                1 => 0.0,
                2 => (-x / 300.0).exp(),
                _ => (1.0 - ((x - 500.0) / 120.0).powi(2)).max(0.0),
            }
    }
}

const KINDS: [&str; 4] = ["constant", "two layers", "exponential", "a blob"];
const SIGMAS: [f64; 5] = [1e-4, 3e-3, 0.02, 0.05, 0.4];

/// Settings from coarse to fine, without the number of steps.
const COARSE: &str = "0.3, 0.5, 6, 80.0, 0.01, 8.0, 64, 0.02, 0.0";
const MIDDLE: &str = "0.1, 0.2, 8, 40.0, 0.005, 2.0, 128, 0.005, 0.0";
const FINE: &str = "0.03, 0.05, 24, 10.0, 0.0, 0.25, 512, 0.0005, 0.0";

/// Light from behind the field, from x = 1000, and from before it, from x = 0: along x or against it.
const BEHIND: f64 = 1.0;
const BEFORE: f64 = -1.0;

/// The numbers of a march along x from `near` to `far`, light going to `light` along x: radiance, transmittance, distance,
/// steps, evaluations.
fn marched(name: &str, how: &str, (near, far): (f64, f64), light: f64, points: &[[f32; 3]]) -> Vec<Vec<f64>> {
    let march = format!(
        "{name}_march(vec3f(0.0, y, z), vec3f(1.0, 0.0, 0.0), {near:?}, {far:?}, vec3f({light:?}, 0.0, 0.0), jitter, \
         {name}_Volume({how}))"
    );
    let scope = Scope { fragment: FIELDS, ..Scope::default() };
    values(&march, &scope, ["y", "z", "jitter"], points)
}

#[test]
fn a_homogeneous_slab_lets_through_what_beers_law_says() {
    let mut report = Report::new(SECTION, "a_homogeneous_slab_lets_through_what_beers_law_says");
    let points: Vec<[f32; 3]> = SIGMAS.iter().map(|&sigma| [sigma as f32, 0.0, 0.5]).collect();
    for steps in [1, 4, 16, 64] {
        let how = format!("0.1, 0.3, 6, 40.0, 0.01, 1.0, {steps}, 0.0, 0.0");
        let rows = marched("white", &how, (40.0, 740.0), BEHIND, &points);
        let errors = rows.iter().zip(SIGMAS).map(|(row, sigma)| (row[3] - (-sigma * 700.0).exp()).abs());
        report.at_most(
            &format!("transmittance of a slab, {steps} steps: error"),
            errors.fold(0.0, f64::max),
            1e-4,
        );
        let most = rows.iter().map(|row| row[5]).fold(0.0, f64::max);
        report.at_most(&format!("steps of {steps}"), most, f64::from(steps));
    }
    report.finish();
}

#[test]
fn a_white_furnace_stays_white() {
    let mut report = Report::new(SECTION, "a_white_furnace_stays_white");
    let mut points = Vec::new();
    for kind in 0..4 {
        for sigma in SIGMAS {
            for jitter in [0.0, 0.3, 0.5, 0.77, 1.0] {
                points.push([sigma as f32, kind as f32, jitter]);
            }
        }
    }
    let (mut highest, mut lowest) = (0.0_f64, 2.0_f64);
    let mut gain = f64::MIN;
    let few = "0.3, 0.5, 6, 80.0, 0.01, 8.0, 5, 0.02, 0.0";
    for how in [COARSE, MIDDLE, FINE, few] {
        for row in marched("white", how, (0.0, 1000.0), BEHIND, &points) {
            highest = highest.max(row[0] + row[3]);
            lowest = lowest.min(row[0] + row[3]);
        }
        for row in marched("lit", how, (0.0, 1000.0), BEHIND, &points) {
            // Half of the light of each depth, and what the darker light leaves.
            gain = gain.max(row[2] - 0.5 * (1.0 - row[3])).max(row[0] - (1.0 - row[3]));
        }
    }
    report.at_most("albedo 1, all around 1: brightest", highest, 1.0 + 1e-3);
    report.at_least("albedo 1, all around 1: darkest", lowest, 1.0 - 1e-3);
    report.at_most("scattered beyond what came in", gain, 1e-5);
    report.finish();
}

#[test]
fn layers_and_blobs_come_near_the_truth() {
    let mut report = Report::new(SECTION, "layers_and_blobs_come_near_the_truth");
    // Bounds: transmittance, radiance lit from before, from behind, distance (m). The worst case are layers with edges like
    // knives and a mean free path as short as the shortest step, or shorter: they are lit at a depth that is not known.
    for (name, how, bounds, layers) in [
        ("coarse", COARSE, [0.005, 0.16, 0.02, 10.0], [0.06, 0.5, 0.15, 30.0]),
        ("middle", MIDDLE, [0.005, 0.035, 0.01, 5.0], [0.05, 0.2, 0.03, 30.0]),
        ("fine", FINE, [5e-4, 0.008, 1e-3, 0.3], [0.01, 0.02, 0.03, 1.5]),
    ] {
        for (kind, called) in KINDS.iter().enumerate() {
            let bounds = if kind == 1 { layers } else { bounds };
            let points: Vec<[f32; 3]> =
                SIGMAS.iter().map(|&sigma| [sigma as f32, kind as f32, 0.5]).collect();
            let behind = marched("lit", how, (0.0, 900.0), BEHIND, &points);
            let before = marched("lit", how, (0.0, 900.0), BEFORE, &points);
            let mut errors = [0.0_f64; 4];
            for ((behind, before), sigma) in behind.iter().zip(&before).zip(SIGMAS) {
                let Seen { transmittance, radiance, distance } = seen(field(kind, sigma), 0.0, 900.0, 1000.0);
                let from_before = 0.5 * (1.0 - transmittance * transmittance); // in and out again by the same way
                errors[0] = errors[0].max((behind[3] - transmittance).abs());
                errors[1] = errors[1].max((before[0] - from_before).abs());
                errors[2] = errors[2].max((behind[0] - radiance).abs());
                errors[3] = errors[3].max((behind[4] - distance).abs());
            }
            let what =
                ["transmittance", "radiance, lit from before", "radiance, lit from behind", "distance (m)"];
            for ((what, error), bound) in what.into_iter().zip(errors).zip(bounds) {
                report.at_most(&format!("{called}, {name}: error of {what}"), error, bound);
            }
            let evaluations = behind.iter().map(|row| row[6]).sum::<f64>() / behind.len() as f64;
            report.told(&format!("{called}, {name}: evaluations"), evaluations);
        }
    }
    report.finish();
}

#[test]
fn jitter_leaves_the_mean_where_it_is() {
    let mut report = Report::new(SECTION, "jitter_leaves_the_mean_where_it_is");
    for (kind, called) in KINDS.iter().enumerate() {
        let points: Vec<[f32; 3]> = (0..256).map(|i| [0.01, kind as f32, (i as f32 + 0.5) / 256.0]).collect();
        let rows = marched("lit", MIDDLE, (0.0, 900.0), BEFORE, &points);
        let mean = |column: usize| rows.iter().map(|row| row[column]).sum::<f64>() / rows.len() as f64;
        let truth = seen(field(kind, 0.01), 0.0, 900.0, 1000.0).transmittance;
        report.near(&format!("{called}: mean transmittance"), mean(3), truth, 0.005);
        report.near(&format!("{called}: mean radiance"), mean(0), 0.5 * (1.0 - truth * truth), 0.02);
    }
    report.finish();
}

#[test]
fn shadows_of_a_volume_are_as_deep_as_it_is() {
    let mut report = Report::new(SECTION, "shadows_of_a_volume_are_as_deep_as_it_is");
    let scope = Scope { fragment: FIELDS, ..Scope::default() };
    for (kind, called) in KINDS.iter().enumerate() {
        let points: Vec<[f32; 2]> = SIGMAS.iter().map(|&sigma| [sigma as f32, kind as f32]).collect();
        for (samples, bound) in [(12, 0.15), (64, 0.02)] {
            let shadow =
                format!("lit_shadow(vec3f(20.0, y, z), vec3f(1.0, 0.0, 0.0), 30.0, 880.0, {samples})");
            let rows = values(&shadow, &scope, ["y", "z"], &points);
            let error = rows
                .iter()
                .zip(SIGMAS)
                .map(|(row, sigma)| (row[0] - through(field(kind, sigma), 50.0, 900.0)).abs())
                .fold(0.0, f64::max);
            report.at_most(&format!("{called}, {samples} samples: error of a shadow"), error, bound);
        }
    }
    // Air in front of the two layers, lit from behind them, and air behind them: 100 m shadowed, 160 in them, 740 free.
    let light = (-0.05_f64 * 280.0).exp();
    let shafts = "lit_shafts(vec3f(0.0, 0.05, 1.0), vec3f(1.0, 0.0, 0.0), near, far, thinning, \
                  vec3f(1.0, 0.0, 0.0), 0.5, 64, 64)";
    let rows = values(
        shafts,
        &scope,
        ["near", "far", "thinning"],
        &[
            [0.0, 90.0, 0.0],
            [300.0, 900.0, 0.001],
            [0.0, 1000.0, 0.0],
            [0.0, 1000.0, 0.01],
            [0.0, 1000.0, -0.01],
        ],
    );
    let weighed = |thinning: f64| {
        let whole = (1.0 - (-thinning * 1000.0).exp()) / thinning;
        ((-thinning * 260.0).exp() - (-thinning * 1000.0).exp()) / thinning / whole
    };
    report.near("shafts in the shadow", rows[0][0], light, 1e-3);
    report.near("shafts in the open", rows[1][0], 1.0, 1e-6);
    report.near("shafts on both sides", rows[2][0], 0.74, 0.05);
    report.near("shafts on both sides, thinning", rows[3][0], weighed(0.01), 0.05);
    report.near("shafts on both sides, thickening", rows[4][0], weighed(-0.01), 0.05);
    report.finish();
}

/// Counts what is asked: along the ray (z = 0) and toward the light (z > 0).
const COUNTED: &str = "
#include <march/volume.wgsl> as counted with density = count_density, vacancy = count_vacancy, span = count_span, source = count_source

var<private> count_ray: i32;
var<private> count_light: i32;
var<private> count_sources: i32;

fn count_density(p: vec3f, footprint: f32) -> f32 {
    if p.z > 0.0 {
        count_light++;
    } else {
        count_ray++;
    }
    return p.y * max(sin(p.x * 0.01), 0.0);
}

fn count_vacancy(p: vec3f) -> f32 {
    return 0.0;
}

fn count_span(origin: vec3f, direction: vec3f) -> vec2f {
    return vec2f(0.0, 500.0);
}

fn count_source(p: vec3f, direction: vec3f, extinction: f32, light_depth: f32) -> vec3f {
    count_sources++;
    return vec3f(1.0);
}

fn count(y: f32, jitter: f32, how: counted_Volume) -> array<i32, 5> {
    let seen = counted_march(
        vec3f(0.0, y, 0.0), vec3f(1.0, 0.0, 0.0), 0.0, 3000.0, vec3f(0.0, 0.0, 1.0), jitter, how,
    );
    return array<i32, 5>(seen.steps, seen.evaluations, count_ray, count_light, count_sources);
}
";

#[test]
fn steps_and_evaluations_are_counted_as_made() {
    let mut report = Report::new(SECTION, "steps_and_evaluations_are_counted_as_made");
    let scope = Scope { fragment: COUNTED, ..Scope::default() };
    let points: Vec<[f32; 2]> = [0.0, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 1e6]
        .iter()
        .flat_map(|&y| (0..8).map(move |i| [y, i as f32 / 7.0]))
        .collect();
    for (name, how, samples, most) in [("coarse", COARSE, 6.0, 64.0), ("middle", MIDDLE, 8.0, 128.0)] {
        let rows =
            values(&format!("count(y, jitter, counted_Volume({how}))"), &scope, ["y", "jitter"], &points);
        let worst = |wrong: &dyn Fn(&[f64]) -> f64| rows.iter().map(|row| wrong(row)).fold(0.0, f64::max);
        report.at_most(
            &format!("{name}: evaluations told less those made"),
            worst(&|row| (row[1] - row[2] - row[3]).abs()),
            0.0,
        );
        // One evaluation a step and one at the start, but for steps that end where one was made before.
        report.at_most(
            &format!("{name}: evaluations along the ray beyond steps"),
            worst(&|row| row[2] - row[0]),
            1.0,
        );
        report.at_most(&format!("{name}: steps"), worst(&|row| row[0]), most);
        report.at_most(
            &format!("{name}: evaluations toward the light that are no whole march"),
            worst(&|row| row[3] % samples),
            0.0,
        );
        report.at_most(
            &format!("{name}: marches toward the light beyond sources"),
            worst(&|row| row[3] / samples - row[4]),
            0.0,
        );
        report.at_least(
            &format!("{name}: most marches toward the light"),
            worst(&|row| row[3] / samples),
            2.0,
        );
    }
    report.finish();
}

#[test]
fn nothing_breaks_a_march_through_a_volume() {
    let mut report = Report::new(SECTION, "nothing_breaks_a_march_through_a_volume");
    let mut points = Vec::new();
    for kind in 0..4 {
        for sigma in [0.0, 1e-30, 1e-6, 0.05, 3.0, 1e6, 1e20] {
            for jitter in [0.0, 0.5, 1.0] {
                points.push([sigma, kind as f32, jitter]);
            }
        }
    }
    let mut broken = 0;
    let mut marches = 0;
    for (near, far) in
        [(0.0, 1000.0), (900.0, 100.0), (5.0, 5.0), (-300.0, 900.0), (0.0, 1e8), (999_000.0, 1e6)]
    {
        for how in [
            COARSE,
            MIDDLE,
            "0.0, 0.0, 0, 0.0, 0.0, 0.0, 40, 0.0, 0.0",
            "1.0, 1.0, 1, 1e9, 1.0, 1e9, 3, 1.0, 1.0",
            "0.1, 0.2, 4, 30.0, 0.01, 1.0, 0, 0.01, 0.001",
        ] {
            for row in marched("lit", how, (near, far), BEHIND, &points) {
                let in_range = row[3] >= 0.0 && row[3] <= 1.0 && row[..3].iter().all(|&light| light >= 0.0);
                broken += usize::from(!in_range || row.iter().any(|number| !number.is_finite()));
                marches += 1;
            }
        }
    }
    report.at_most("marches that are not finite or out of range", broken as f64, 0.0);
    report.told("marches", marches as f64);
    report.finish();
}
