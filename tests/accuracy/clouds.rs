//! Clouds: what they are made of, where they surely are not, how much of the sky they cover.

use orogen::Preset;
use truth::clouds::{perlin3_slope, puff3, stops, trapezoid};
use truth::points::Random;

use crate::harness::{Report, Scope, values};

const SECTION: &str = "Clouds";
const LAYER: &[&str] = &["<clouds/layer.wgsl>"];

/// A sky with these values over the defaults.
fn sky(assignments: &[&str]) -> Preset {
    let text =
        r#"{ "orogen": 1, "about": "", "scene": "scene/cloudscape.wgsl", "set": { "quality": "high" } }"#;
    let mut preset = Preset::parse("sky.json", text).unwrap();
    for assignment in assignments {
        preset.set(assignment).unwrap();
    }
    preset
}

/// The kinds of layers: heaps, broken by regions, a sheet, a box, each as a slab, and heaps around the planet.
fn kinds() -> Vec<(&'static str, Preset)> {
    vec![
        ("cumulus", sky(&["clouds.coverage=0.4"])),
        (
            "stratus, another place, a storm",
            sky(&["clouds.type=0.2", "clouds.coverage=0.5", "clouds.shear=1", "frame.time=5000"]),
        ),
        ("apart, in regions", sky(&["clouds.clumping=2", "clouds.variety=1", "clouds.coverage=0.3"])),
        ("a sheet of fBm", sky(&["clouds.form=plain"])),
        ("in a box", sky(&["clouds.form=boxed", "clouds.coverage=0.8"])),
        ("around the planet", sky(&["clouds.shape=shell", "clouds.coverage=0.4"])),
        (
            "around a small planet",
            sky(&["clouds.shape=shell", "clouds.coverage=0.3", "sky.ground_radius=60000"]),
        ),
    ]
}

fn places(seed: u32, count: usize, reach: f32, low: f32, high: f32) -> Vec<[f32; 3]> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|_| [random.within(-reach, reach), random.within(low, high), random.within(-reach, reach)])
        .collect()
}

fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers
        .fold(f64::NEG_INFINITY, |most, x| if most.is_nan() || x.is_nan() { f64::NAN } else { most.max(x) })
}

fn least(numbers: impl Iterator<Item = f64>) -> f64 {
    -largest(numbers.map(|x| -x))
}

#[test]
fn puffs_are_the_largest_of_all_puffs_around() {
    let mut report = Report::new(SECTION, "puffs_are_the_largest_of_all_puffs_around");
    let points: Vec<[f32; 3]> = Random::new(1).points(100_000, 90.0);
    let scope = Scope { includes: &["<noise/puffs.wgsl>"], ..Scope::default() };
    let found = values(
        "vec2f(puff_noise3(p, 9u), puff_noise3(p + vec3f(0.01, 0.0, 0.0), 9u))",
        &scope,
        ["x", "y", "z"],
        &points,
    );
    let error =
        largest(found.iter().zip(&points).map(|(row, p)| (row[0] - puff3(p.map(f64::from), 9)).abs()));
    report.at_most("puff noise: error against all puffs within two cells", error, 2e-5);
    report.at_least("puff noise: least of 100,000", least(found.iter().map(|row| row[0])), 0.0);
    report.at_most("puff noise: largest", largest(found.iter().map(|row| row[0])), 1.0);
    let mean = found.iter().map(|row| row[0]).sum::<f64>() / found.len() as f64;
    report.near("puff noise: mean", mean, 0.462, 0.002);
    // Points 90 from the origin stand on a grid of 8e-6: a hundredth is known to a thousandth of itself.
    let slope = largest(found.iter().map(|row| (row[1] - row[0]).abs() / 0.01));
    report.at_most("puff noise: steepest, over a hundredth of a cell", slope, 2.8572 * 1.002);
    report.finish();
}

#[test]
fn perlin_noise_in_space_is_nowhere_steeper_than_stated() {
    let mut report = Report::new(SECTION, "perlin_noise_in_space_is_nowhere_steeper_than_stated");
    report.near(
        "3D Perlin: slope in the middle of a cell along x",
        perlin3_slope([0.5; 3], [1.0, 0.0, 0.0]),
        3.616_875,
        1e-6,
    );
    // From many places uphill, in ever smaller steps.
    let mut random = Random::new(3);
    let mut steepest = 0.0_f64;
    for _ in 0..3000 {
        let mut at: [f64; 3] = std::array::from_fn(|_| f64::from(random.within(0.0, 1.0)));
        let mut toward: [f64; 3] = std::array::from_fn(|_| f64::from(random.within(-1.0, 1.0)));
        let mut best = 0.0;
        let mut size = 0.3;
        for _ in 0..200 {
            let place: [f64; 3] =
                std::array::from_fn(|i| (at[i] + size * f64::from(random.within(-1.0, 1.0))).clamp(0.0, 1.0));
            let way: [f64; 3] =
                std::array::from_fn(|i| toward[i] + size * f64::from(random.within(-1.0, 1.0)));
            let length = way.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-9);
            let way = way.map(|x| x / length);
            let slope = perlin3_slope(place, way);
            if slope > best {
                (best, at, toward) = (slope, place, way);
            } else {
                size *= 0.97;
            }
        }
        steepest = steepest.max(best);
    }
    report.at_most("3D Perlin: steepest that 3,000 climbs find", steepest, 3.6169);
    report.finish();
}

#[test]
fn profiles_cover_and_erosion_are_what_they_are_defined_as() {
    let mut report = Report::new(SECTION, "profiles_cover_and_erosion_are_what_they_are_defined_as");
    let mut random = Random::new(5);
    let points: Vec<[f32; 2]> =
        (0..100_000).map(|_| [random.within(-0.2, 1.2), random.within(0.0, 1.0)]).collect();
    let scope = Scope { includes: &["<clouds/forms.wgsl>"], ..Scope::default() };
    let found = values("cloud_gradient(x, cloud_stops(y))", &scope, ["x", "y"], &points);
    let error = largest(
        found
            .iter()
            .zip(&points)
            .map(|(row, p)| (row[0] - trapezoid(f64::from(p[0]), stops(f64::from(p[1])))).abs()),
    );
    report.at_most("profile over height and type: error", error, 2e-5);
    report.at_least("profile: least", least(found.iter().map(|row| row[0])), 0.0);
    report.at_most("profile: largest", largest(found.iter().map(|row| row[0])), 1.0);

    let points: Vec<[f32; 2]> =
        (0..100_000).map(|_| [random.within(0.0, 1.0), random.within(0.0, 1.0)]).collect();
    let expression =
        "vec4f(cloud_lift(x, y), cloud_cover(x, y), cloud_erode(x, min(y, 0.99)), cloud_bite(x, y))";
    let found = values(expression, &scope, ["x", "y"], &points);
    let mut error = 0.0_f64;
    let mut beyond = f64::NEG_INFINITY;
    for (row, p) in found.iter().zip(&points) {
        let [x, y] = p.map(f64::from);
        let remap = |v: f64, a: f64| (v - a) / (1.0 - a);
        let bite = y.min(0.99);
        // cover: remap(base, 1 - c, 1, 0, 1) · c.
        let truth = [
            remap(x, y - 1.0),
            (remap(x, 1.0 - y.max(1e-9)) * y).max(0.0),
            remap(x, bite).clamp(0.0, 1.0),
            x + (1.0 - 2.0 * x) * (10.0 * y).min(1.0),
        ];
        for (found, truth) in row.iter().zip(truth) {
            error = error.max((found - truth).abs());
        }
        let outside =
            [x - row[0], row[0] - 1.0, -row[1], row[1] - y, -row[2], row[2] - x, -row[3], row[3] - 1.0];
        beyond = largest(outside.into_iter().chain([beyond]));
    }
    report.at_most("lift, cover, erosion, bite: error", error, 2e-5);
    report.at_most("lift, cover, erosion, bite: beyond their stated ranges", beyond, 2e-7);
    report.finish();
}

#[test]
fn the_density_is_between_0_and_1_everywhere() {
    let mut report = Report::new(SECTION, "the_density_is_between_0_and_1_everywhere");
    for (name, preset) in kinds() {
        let mut points = places(7, 40_000, 3000.0, 500.0, 3500.0);
        points.extend(places(8, 20_000, 60_000.0, 1100.0, 2700.0));
        points.extend(places(9, 2000, 2e7, -2e7, 2e7));
        points.extend([
            [0.0, -12_000.0, 0.0],
            [0.0, 0.0, 0.0],
            [1e9, 1500.0, -1e9],
            [0.0, 1e12, 0.0],
            [0.0, -6_360_000.0, 0.0],
        ]);
        let scope = Scope { includes: LAYER, preset: Some(&preset), ..Scope::default() };
        let found = values(
            "vec2f(cloud_density(p), cloud_density_filtered(p, 100.0))",
            &scope,
            ["x", "y", "z"],
            &points,
        );
        report.at_least(&format!("{name}: least density"), least(found.iter().map(|row| row[0])), 0.0);
        report.at_most(&format!("{name}: largest density"), largest(found.iter().map(|row| row[0])), 1.0);
        report.at_least(
            &format!("{name}: least density without fine puffs"),
            least(found.iter().map(|row| row[1])),
            0.0,
        );
        report.at_most(
            &format!("{name}: largest density without fine puffs"),
            largest(found.iter().map(|row| row[1])),
            1.0,
        );
        let (full, coarse) = found.iter().fold((0.0, 0.0), |sum, row| (sum.0 + row[0], sum.1 + row[1]));
        report.near(
            &format!("{name}: mean density without puffs under 100 m over that with them"),
            coarse / full,
            1.0,
            0.1,
        );
        let filled = found.iter().filter(|row| row[0] > 0.0).count() as f64 / found.len() as f64;
        report.at_least(&format!("{name}: part of the places that is in clouds"), filled, 0.005);
    }
    report.finish();
}

#[test]
fn there_is_no_cloud_within_the_certified_distance() {
    let mut report = Report::new(SECTION, "there_is_no_cloud_within_the_certified_distance");
    for (name, preset) in kinds() {
        let mut random = Random::new(11);
        let points: Vec<[f32; 7]> = (0..100_000)
            .map(|i| {
                let reach = if i % 3 == 0 { 4000.0 } else { 80_000.0 };
                let y =
                    if i % 5 == 0 { random.within(-3000.0, 12_000.0) } else { random.within(1000.0, 2800.0) };
                let toward: [f32; 3] = random.point(1.0);
                let long = (toward.iter().map(|x| x * x).sum::<f32>()).sqrt().max(1e-6);
                let far = random.within(0.0, 1.0).powf(0.2); // most near the border
                let [u, v, w] = toward.map(|x| far * x / long);
                [random.within(-reach, reach), y, random.within(-reach, reach), u, v, w, 0.0]
            })
            .collect();
        let scope = Scope { includes: LAYER, preset: Some(&preset), ..Scope::default() };
        let expression = "vec3f(cloud_vacancy(vec3f(px, py, pz)), \
            cloud_density(vec3f(px, py, pz) + cloud_vacancy(vec3f(px, py, pz)) * vec3f(u, v, w)), \
            cloud_density(vec3f(px, py, pz)))";
        let found = values(expression, &scope, ["px", "py", "pz", "u", "v", "w", "unused"], &points);
        let certified: Vec<_> = found.iter().filter(|row| row[0] > 0.0).collect();
        let broken = certified.iter().filter(|row| row[1] != 0.0 || row[2] != 0.0).count();
        report.at_most(&format!("{name}: clouds within the distance, of 100,000 places"), broken as f64, 0.0);
        let within: Vec<_> =
            found.iter().zip(&points).filter(|(_, p)| (1100.0..2700.0).contains(&p[1])).collect();
        let empty = within.iter().filter(|(row, _)| row[2] == 0.0).count().max(1);
        let known = within.iter().filter(|(row, _)| row[0] > 0.0).count();
        report.told(
            &format!("{name}: part of the layer's gaps that is certified"),
            known as f64 / empty as f64,
        );
        let sum: f64 = within.iter().map(|(row, _)| row[0]).sum();
        report.told(&format!("{name}: mean distance certified there (m)"), sum / known.max(1) as f64);
    }
    report.finish();
}

const COLUMN: &str = "
#include <clouds/layer.wgsl>

// Optical depth of the clouds above a place: by sums, and as estimated.
fn column_depths(x: f32, z: f32) -> vec2f {
    var depth = 0.0;
    let step = clouds.thickness / 64.0;
    for (var i = 0; i < 64; i++) {
        depth += clouds.extinction * step * cloud_density(vec3f(x, clouds.base + step * (f32(i) + 0.5), z));
    }
    let estimate = cloud_depths(vec3f(x, clouds.base, z));
    return vec2f(depth, estimate.x + estimate.y);
}
";

#[test]
fn the_cover_follows_its_parameter() {
    let mut report = Report::new(SECTION, "the_cover_follows_its_parameter");
    let points: Vec<[f32; 2]> = Random::new(13).points(3000, 150_000.0);
    for (name, more) in [
        ("cumulus", "clouds.type=1"),
        ("stratocumulus", "clouds.type=0.5"),
        ("a sheet of fBm", "clouds.form=plain"),
    ] {
        let mut before = 0.0;
        let mut rises = f64::INFINITY;
        for coverage in ["0", "0.1", "0.25", "0.5", "0.75", "0.9", "1"] {
            let preset = sky(&[more, &format!("clouds.coverage={coverage}")]);
            let scope = Scope { fragment: COLUMN, preset: Some(&preset), ..Scope::default() };
            let found = values("column_depths(x, z)", &scope, ["x", "z"], &points);
            let covered = found.iter().filter(|row| row[0] > 0.5).count() as f64 / found.len() as f64;
            let asked: f64 = coverage.parse().unwrap();
            report.near(
                &format!("{name}: cover (optical depth above .5) at {coverage}"),
                covered,
                asked,
                0.12,
            );
            if asked > 0.0 {
                rises = rises.min(covered - before);
            }
            before = covered;
            if name == "cumulus" && asked > 0.05 {
                let depth = found.iter().map(|row| row[0]).sum::<f64>();
                let estimate = found.iter().map(|row| row[1]).sum::<f64>();
                report.near(
                    &format!("{name}: estimated over true optical depth at {coverage}"),
                    estimate / depth,
                    1.0,
                    0.4,
                );
            }
        }
        report.at_least(&format!("{name}: least rise of the cover from row to row"), rises, 0.02);
    }
    report.finish();
}

#[test]
fn wind_carries_the_clouds_along() {
    let mut report = Report::new(SECTION, "wind_carries_the_clouds_along");
    let wind = ["clouds.wind_speed=10", "clouds.wind_heading=90", "clouds.rise=0"];
    let scope_of = |time: &str| {
        let mut preset = sky(&wind);
        preset.set(&format!("frame.time={time}")).unwrap();
        preset
    };
    let points = places(15, 30_000, 6000.0, 1100.0, 2700.0);
    let (now, later) = (scope_of("0"), scope_of("64"));
    let xyz = ["x", "y", "z"];
    let at = |expression: &str, preset: &Preset| {
        values(expression, &Scope { includes: LAYER, preset: Some(preset), ..Scope::default() }, xyz, &points)
    };
    let before = at("cloud_density(p)", &now);
    let after = at("cloud_density(p + vec3f(640.0, 0.0, 0.0))", &later);
    let mut errors: Vec<f64> = before.iter().zip(&after).map(|(a, b)| (a[0] - b[0]).abs()).collect();
    errors.sort_by(f64::total_cmp);
    let rms = (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt();
    report.at_most("density 640 m downwind after 64 s at 10 m/s: rms difference", rms, 1e-3);
    let still = at("cloud_density(p)", &later);
    let change =
        before.iter().zip(&still).map(|(a, b)| (a[0] - b[0]).powi(2)).sum::<f64>() / before.len() as f64;
    report.at_least("density in one place, 64 s later: rms difference", change.sqrt(), 0.1);
    report.finish();
}

#[test]
fn the_density_has_no_jumps() {
    let mut report = Report::new(SECTION, "the_density_has_no_jumps");
    for (name, preset) in kinds() {
        let points = places(17, 100_000, 4000.0, 1050.0, 2750.0);
        let scope = Scope { includes: LAYER, preset: Some(&preset), ..Scope::default() };
        let expression = "vec2f(cloud_density(p + vec3f(0.05, 0.0, 0.0)), cloud_density(p + vec3f(0.0, 0.05, 0.0))) \
            - cloud_density(p)";
        let found = values(expression, &scope, ["x", "y", "z"], &points);
        let worst = largest(found.iter().map(|row| row[0].abs().max(row[1].abs())));
        report.at_most(&format!("{name}: largest change over 5 cm, of 200,000"), worst, 0.01);
    }
    report.finish();
}

const SPAN: &str = "
#include <clouds/layer.wgsl>

// Largest density at 64 places of the ray outside of its span (x) and inside of it (y).
fn along(origin: vec3f, toward: vec3f, reach: f32) -> vec2f {
    let direction = normalize(toward);
    let span = cloud_span(origin, direction);
    var most = vec2f(0.0);
    for (var i = 0; i < 64; i++) {
        let t = reach * (f32(i) + 0.5) / 64.0;
        let density = cloud_density(origin + t * direction);
        // A metre for the rounding of places so far away.
        if t < span.near - 1.0 || t > span.far + 1.0 {
            most.x = max(most.x, density);
        } else {
            most.y = max(most.y, density);
        }
    }
    return most;
}
";

#[test]
fn rays_meet_clouds_nowhere_but_in_their_span() {
    let mut report = Report::new(SECTION, "rays_meet_clouds_nowhere_but_in_their_span");
    for (name, preset) in kinds() {
        let mut random = Random::new(19);
        // From below, from inside, from above; rays that end before the ground.
        let rays: Vec<[f32; 7]> = (0..20_000)
            .map(|i| {
                let y = [5.0, 800.0, 1500.0, 2400.0, 6000.0, 11_000.0][i % 6];
                let [u, v, w]: [f32; 3] = random.point(1.0);
                let v = if i % 2 == 0 { v } else { 0.1 * v };
                let length = (u * u + v * v + w * w).sqrt().max(1e-6);
                let down = -v / length;
                let reach = if down > 1e-3 { (y / down).min(60_000.0) } else { 60_000.0 };
                [random.within(-3000.0, 3000.0), y, random.within(-3000.0, 3000.0), u, v, w, reach]
            })
            .collect();
        let scope = Scope { fragment: SPAN, preset: Some(&preset), ..Scope::default() };
        let columns = ["px", "py", "pz", "u", "v", "w", "reach"];
        let found = values("along(vec3f(px, py, pz), vec3f(u, v, w), reach)", &scope, columns, &rays);
        report.at_most(
            &format!("{name}: densest outside of the span, 20,000 rays"),
            largest(found.iter().map(|r| r[0])),
            0.0,
        );
        let met = found.iter().filter(|row| row[1] > 0.0).count() as f64 / found.len() as f64;
        report.at_least(&format!("{name}: part of the rays that meet clouds"), met, 0.02);
    }
    report.finish();
}

#[test]
fn clouds_on_a_plane_cover_what_they_are_told_to() {
    let mut report = Report::new(SECTION, "clouds_on_a_plane_cover_what_they_are_told_to");
    let points: Vec<[f32; 2]> = Random::new(23).points(20_000, 300_000.0);
    let mut before = -1.0;
    for coverage in ["0", "0.1", "0.25", "0.5", "0.75", "0.9", "1"] {
        let mut preset = Preset::parse(
            "plane.json",
            r#"{ "orogen": 1, "about": "", "scene": "clouds/planar.wgsl", "set": { "veil": { "depth": 2 } } }"#,
        )
        .unwrap();
        preset.set(&format!("veil.coverage={coverage}")).unwrap();
        let scope = Scope { includes: &["<clouds/planar.wgsl>"], preset: Some(&preset), ..Scope::default() };
        let found = values("planar_clouds_depth(vec2f(x, y), 0.0)", &scope, ["x", "y"], &points);
        let covered = found.iter().filter(|row| row[0] > 0.0).count() as f64 / found.len() as f64;
        report.near(&format!("cover at {coverage}"), covered, coverage.parse().unwrap(), 0.06);
        report.at_least(&format!("rise of the cover at {coverage}"), covered - before, 0.05);
        before = covered;
        report.at_least(&format!("least depth at {coverage}"), least(found.iter().map(|row| row[0])), 0.0);
        report.at_most(
            &format!("largest depth of at most 2, at {coverage}"),
            largest(found.iter().map(|row| row[0])),
            2.0,
        );
    }
    report.finish();
}

/// The sun through the layer in `count` even samples of full detail, how many a shadow's march takes, and the march's.
const SHADOW: &str = "
#include <clouds/layer.wgsl>
var<private> shade_asked: f32;
fn shade_density(p: vec3f, footprint: f32) -> f32 { shade_asked += 1.0; return cloud_extinction(p, footprint); }
fn shade_source(p: vec3f, direction: vec3f, extinction: f32, depth: f32) -> vec3f { return vec3f(0.0); }
#include <march/volume.wgsl> as shade with density = shade_density, vacancy = cloud_vacancy, span = cloud_ahead, source = shade_source

fn shade(p: vec3f, elevation: f32, count: i32) -> vec3f {
    let to_sun = vec3f(0.0, sin(elevation), cos(elevation));
    let way = cloud_ahead(p, to_sun);
    var depth = 0.0;
    for (var i = 0; i < count; i++) {
        let step = (way.y - way.x) / f32(count);
        depth += step * cloud_extinction(p + (way.x + step * (f32(i) + 0.5)) * to_sun, 0.0);
    }
    shade_asked = 0.0;
    let marched = shade_shadow(p, to_sun, way.x, way.y, CLOUD_SHADOW_SAMPLES);
    return vec3f(exp(-depth), shade_asked, marched);
}
";

#[test]
fn shadows_of_clouds_are_as_deep_as_the_clouds() {
    let mut report = Report::new(SECTION, "shadows_of_clouds_are_as_deep_as_the_clouds");
    let points = places(29, 3000, 30_000.0, 0.0, 1.0);
    for (name, more) in [
        ("cumulus", &["clouds.coverage=0.42"][..]),
        ("stratocumulus", &["clouds.type=0.5", "clouds.coverage=0.8", "clouds.scale=1500"]),
    ] {
        let preset = sky(more);
        let scope = Scope { fragment: SHADOW, preset: Some(&preset), ..Scope::default() };
        for degrees in [20.0_f32, 45.0] {
            let call = format!("shade(p, {:?}, 400)", degrees.to_radians());
            let rows = values(&call, &scope, ["x", "y", "z"], &points);
            let mean = |f: &dyn Fn(&Vec<f64>) -> f64| rows.iter().map(f).sum::<f64>() / rows.len() as f64;
            let what = format!("{name}, sun {degrees}° high");
            let truth = mean(&|row| row[0]);
            report.near(
                &format!("{what}: mean light on the ground, of 400 samples"),
                mean(&|row| row[2]),
                truth,
                0.02,
            );
            let rms = mean(&|row| (row[2] - row[0]).powi(2)).sqrt();
            report.at_most(&format!("{what}: rms difference to that"), rms, 0.1);
            report.at_most(&format!("{what}: evaluations in the mean"), mean(&|row| row[1]), 32.0);
        }
    }
    report.finish();
}
