//! Rays against land and distance fields: what the marches find, held against where the rays do meet them.

use std::sync::LazyLock;

use truth::march::{DUAL, Errors, FAR, RELIEFS, Ray, Relief};
use truth::points::Random;

use crate::harness::{Report, Scope, values};

const SIDE: usize = 32;
const TOLERANCE: f64 = 0.05;
const RAY: [&str; 6] = ["x", "y", "z", "dx", "dy", "dz"];

/// A land, the rays of a small picture of it, and where they meet it.
struct Scene {
    relief: Relief,
    rays: Vec<Ray>,
    crossings: Vec<Option<f64>>,
}

static SCENES: LazyLock<Vec<Scene>> = LazyLock::new(|| {
    let scene = |relief: Relief| {
        let rays = relief.rays(SIDE);
        let crossings = rays.iter().map(|ray| relief.first_crossing(ray, FAR)).collect();
        Scene { relief, rays, crossings }
    };
    RELIEFS.into_iter().chain([DUAL]).map(scene).collect()
});

/// What `march`, an expression of x, y, z and `d`, found.
struct Found {
    errors: Errors,
    evaluations: f64,
    most_steps: f64,
}

fn found(scene: &Scene, march: &str) -> Found {
    let rows = evaluate(&scene.relief, march, &scene.rays);
    let hits: Vec<Option<f64>> = rows.iter().map(|row| (row[1] != 0.0).then_some(row[0])).collect();
    Found {
        errors: Errors::of(&scene.relief, &scene.rays, &scene.crossings, &hits),
        evaluations: rows.iter().map(|row| row[3]).sum::<f64>() / rows.len() as f64,
        most_steps: rows.iter().map(|row| row[2]).fold(0.0, f64::max),
    }
}

/// An expression of the rays' origins `p` and directions `vec3f(dx, dy, dz)` over a land.
fn evaluate(relief: &Relief, expression: &str, rays: &[Ray]) -> Vec<Vec<f64>> {
    let numbers: Vec<[f32; 6]> = rays.iter().map(Ray::numbers).collect();
    let fragment = relief.wgsl();
    values(expression, &Scope { fragment: &fragment, ..Scope::default() }, RAY, &numbers)
}

#[test]
fn a_bounded_march_misses_nothing() {
    let mut report = Report::new("Marches over a heightfield", "a_bounded_march_misses_nothing");
    for scene in SCENES.iter() {
        let march =
            format!("bounded_march(p, vec3f(dx, dy, dz), 0.0, {FAR:?}, relief_bounded({TOLERANCE:?}, 0.0))");
        let Found { errors, evaluations, most_steps } = found(scene, &march);
        let name = scene.relief.name;
        report.at_most(
            &format!("bounded, {name}: crossings missed of {}", SIDE * SIDE),
            errors.missed as f64,
            0.0,
        );
        report.at_most(&format!("bounded, {name}: hits where there is nothing"), errors.phantoms as f64, 1.0);
        report.at_most(&format!("bounded, {name}: too far at most (m)"), errors.late, 4.0 * TOLERANCE);
        report.at_most(&format!("bounded, {name}: IDE p95 (m)"), errors.ide95, 0.02);
        report.at_most(&format!("bounded, {name}: HDE p95 (m)"), errors.hde95, 0.02);
        report.told(&format!("bounded, {name}: octaves a ray"), evaluations);
        report.at_most(&format!("bounded, {name}: most steps"), most_steps, 799.0);
    }
    report.finish();
}

#[test]
fn detail_may_fade_with_distance() {
    let mut report = Report::new("Marches over a heightfield", "detail_may_fade_with_distance");
    let scene = &SCENES[0];
    let march = |pixel: f64| {
        format!("bounded_march(p, vec3f(dx, dy, dz), 0.0, {FAR:?}, relief_bounded({TOLERANCE:?}, {pixel:?}))")
    };
    let pixel = 0.01; // a coarse picture: the finest octaves fade from 2 km on
    let rows = evaluate(&scene.relief, &march(pixel), &scene.rays);
    let whole = evaluate(&scene.relief, &march(0.0), &scene.rays);
    // What fades is finer than a pixel: it moves hits by a few of them, unless a crest is only just met or missed.
    let pairs = rows.iter().zip(&scene.crossings);
    let mut pixels: Vec<f64> = pairs
        .filter_map(|(row, crossing)| crossing.map(|crossing| (row[0] - crossing).abs() / (pixel * crossing)))
        .collect();
    pixels.sort_by(f64::total_cmp);
    report.at_most("bounded, octaves fading: IDE p50, in pixels", pixels[pixels.len() / 2], 1.0);
    report.told("bounded, octaves fading: IDE p95, in pixels", pixels[pixels.len() * 95 / 100]);
    let sum = |rows: &[Vec<f64>]| rows.iter().map(|row| row[3]).sum::<f64>() / rows.len() as f64;
    report.at_most(
        "bounded, octaves fading: octaves a ray over those without",
        sum(&rows) / sum(&whole),
        0.95,
    );
    report.finish();
}

#[test]
fn the_other_marches_err_as_they_say() {
    let mut report = Report::new("Marches over a heightfield", "the_other_marches_err_as_they_say");
    for scene in &SCENES[..3] {
        let ceiling = scene.relief.ceiling();
        let marches = [
            ("adaptive", "adaptive_Adaptive(0.5, 0.0005, 0.5, 800, 6, 0.0)".to_owned(), 0.05),
            ("relaxed", "0.5, 0.0001, 0.02, 800".to_owned(), 1.0),
            ("fixed", "1000, 0.0".to_owned(), 20.0),
        ];
        for (name, how, ide) in marches {
            let march = format!("{name}_march(p, vec3f(dx, dy, dz), {ceiling:?}, {FAR:?}, {how})");
            let Found { errors, evaluations, .. } = found(scene, &march);
            let row = format!("{name}, {}", scene.relief.name);
            report.told(&format!("{row}: crossings missed of {}", SIDE * SIDE), errors.missed as f64);
            report.told(&format!("{row}: hits where there is nothing"), errors.phantoms as f64);
            report.at_most(&format!("{row}: IDE p95 (m)"), errors.ide95, ide);
            report.told(&format!("{row}: HDE p95 (m)"), errors.hde95);
            report.told(&format!("{row}: octaves a ray"), evaluations * scene.relief.octaves as f64);
        }
    }
    report.finish();
}

/// Rays from two metres above the ground to a light so many degrees high.
fn to_light(relief: &Relief, degrees: f64, count: usize) -> Vec<Ray> {
    let mut random = Random::new(5);
    let (sin, cos) = degrees.to_radians().sin_cos();
    (0..count)
        .map(|_| {
            let [x, z] = random.point::<2>(6000.0).map(f64::from);
            Ray::new([x, relief.height(x, z) + 2.0, z], [0.6 * cos, sin, 0.8 * cos])
        })
        .collect()
}

#[test]
fn hard_shadows_are_where_the_land_is_in_the_way() {
    let mut report =
        Report::new("Marches over a heightfield", "hard_shadows_are_where_the_land_is_in_the_way");
    let relief = RELIEFS[0];
    let rays = to_light(&relief, 12.0, 1000);
    let shadow = format!(
        "bounded_shadow_hard(p, vec3f(dx, dy, dz), 0.0, {FAR:?}, relief_bounded({TOLERANCE:?}, 0.0))"
    );
    let stepped = format!(
        "land_shadow_hard(p, vec3f(dx, dy, dz), 0.1, {FAR:?}, {:?}, 0.0, 0.4, 0.2, 1000)",
        relief.ceiling()
    );
    let lit: Vec<f64> = evaluate(&relief, &shadow, &rays).iter().map(|row| row[0]).collect();
    let lit_stepped: Vec<f64> = evaluate(&relief, &stepped, &rays).iter().map(|row| row[0]).collect();
    let blocked: Vec<bool> = rays.iter().map(|ray| relief.first_crossing(ray, FAR).is_some()).collect();
    // A ray lowered by twice the tolerance: where that is free, there is no doubt.
    let doubtful: Vec<bool> = rays
        .iter()
        .map(|ray| {
            let [x, y, z] = ray.origin;
            relief.first_crossing(&Ray { origin: [x, y - 2.0 * TOLERANCE, z], ..*ray }, FAR).is_some()
        })
        .collect();
    let count = |wrong: &dyn Fn(usize) -> bool| (0..rays.len()).filter(|&i| wrong(i)).count() as f64;
    report.at_most(
        "bounded: lit though the land is in the way, of 1000",
        count(&|i| lit[i] == 1.0 && blocked[i]),
        0.0,
    );
    report.at_most(
        "bounded: dark though nothing is near, of 1000",
        count(&|i| lit[i] == 0.0 && !doubtful[i]),
        0.0,
    );
    report.at_least("in shadow, of 1000", count(&|i| blocked[i]), 100.0);
    report.told(
        "hard, stepped: lit though the land is in the way, of 1000",
        count(&|i| lit_stepped[i] == 1.0 && blocked[i]),
    );
    report.finish();
}

#[test]
fn soft_shadows_lighten_as_the_sun_climbs() {
    let mut report = Report::new("Marches over a heightfield", "soft_shadows_lighten_as_the_sun_climbs");
    let relief = RELIEFS[0];
    let mut before = vec![0.0; 300];
    let (mut lowest, mut highest, mut darker) = (f64::MAX, f64::MIN, 0.0_f64);
    let mut shares = Vec::new();
    let climb: Vec<Ray> = (0..12).flat_map(|step| to_light(&relief, f64::from(step) * 2.0, 300)).collect();
    let shadow =
        format!("land_shadow_soft(p, vec3f(dx, dy, dz), 0.02, 0.5, 9000.0, {:?}, 0.5, 96)", relief.ceiling());
    let all: Vec<f64> = evaluate(&relief, &shadow, &climb).iter().map(|row| row[0]).collect();
    for seen in all.chunks(300) {
        lowest = seen.iter().copied().fold(lowest, f64::min);
        highest = seen.iter().copied().fold(highest, f64::max);
        darker = seen.iter().zip(&before).map(|(now, then)| then - now).fold(darker, f64::max);
        shares.push(seen.iter().sum::<f64>() / 300.0);
        before = seen.to_vec();
    }
    report.at_least("soft: least part seen", lowest, 0.0);
    report.at_most("soft: greatest part seen", highest, 1.0);
    report.at_most("soft: most that 2 degrees more darken a place", darker, 0.02);
    report.told("soft: part of the places lit, sun 4 degrees high", shares[2]);
    report.told("soft: part of the places lit, sun 22 degrees high", shares[11]);
    report.finish();
}

#[test]
fn no_ray_breaks_a_march() {
    let mut report = Report::new("Marches over a heightfield", "no_ray_breaks_a_march");
    for relief in [RELIEFS[0], DUAL] {
        let places = [
            [0.0, -3000.0, 0.0],
            [10.0, 1.0, 7.0],
            [-5e4, 1e5, 9e4],
            [3e5, 300.0, -2e5],
            [0.5, 1e6, 0.5],
            [0.0; 3],
        ];
        let directions = [
            [0.0, 1.0, 0.0],
            [0.0, -1.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 0.0, -1.0],
            [1.0, -1e-4, 0.0],
            [1e-5, -1.0, 1e-5],
            [0.6, 1e-7, 0.8],
            [0.5, 0.5, -0.7],
        ];
        let rays: Vec<Ray> =
            places.iter().flat_map(|place| directions.iter().map(|d| Ray::new(*place, *d))).collect();
        let (d, top) = ("vec3f(dx, dy, dz)", relief.ceiling());
        let expressions = [
            format!("bounded_march(p, {d}, 0.0, 45000.0, relief_bounded(0.05, 0.001))"),
            format!("bounded_march(p, {d}, 0.0, 0.0, relief_bounded(0.0, 0.0))"),
            format!(
                "adaptive_march(p, {d}, {top:?}, 45000.0, adaptive_Adaptive(0.5, 0.001, 0.5, 200, 8, 0.001))"
            ),
            format!("adaptive_march(p, {d}, {top:?}, 0.0, adaptive_Adaptive(0.0, 0.0, 0.0, 9, 0, 0.0))"),
            format!("relaxed_march(p, {d}, {top:?}, 45000.0, 0.5, 0.001, 0.01, 200)"),
            format!("fixed_march(p, {d}, {top:?}, 45000.0, 50, 0.001)"),
            format!("fixed_march(p, {d}, {top:?}, 0.0, 0, 0.0)"),
            format!("land_shadow_soft(p, {d}, 0.005, 0.3, 9000.0, {top:?}, 0.5, 40)"),
            format!("land_shadow_soft(p, {d}, 0.005, 0.0, 0.0, {top:?}, 0.0, 40)"),
            format!("land_shadow_hard(p, {d}, 0.0, 9000.0, {top:?}, 0.5, 0.5, 0.5, 100)"),
        ];
        let mut broken = 0;
        for expression in &expressions {
            let rows = evaluate(&relief, expression, &rays);
            broken += rows.iter().flatten().filter(|number| !number.is_finite()).count();
            if expression.contains("_march") {
                broken += rows.iter().filter(|row| row[0] < 0.0).count();
                // From below the ground a march ends at once.
                let inside = rays.iter().zip(&rows).filter(|(ray, _)| ray.origin[1] == -3000.0);
                broken += inside.filter(|(_, row)| row[1] == 0.0 || row[0] > 0.0).count();
            } else {
                broken += rows.iter().filter(|row| !(0.0..=1.0).contains(&row[0])).count();
            }
        }
        report.at_most(
            &format!("{}: marches and shadows not finite or out of range", relief.name),
            broken as f64,
            0.0,
        );
    }
    report.finish();
}

const SPHERES: &str = "#include <march/sphere.wgsl> as ball with sdf = test_ball

fn test_ball(p: vec3f) -> f32 {
    return length(p - vec3f(0.0, 0.0, 10.0)) - 2.0;
}
";

#[test]
fn a_sphere_is_traced_to_where_it_is() {
    let mut report = Report::new("Sphere tracing", "a_sphere_is_traced_to_where_it_is");
    let mut random = Random::new(9);
    let rays: Vec<Ray> = (0..20_000)
        .map(|_| {
            let [x, y, z] = random.point::<3>(0.25).map(f64::from);
            Ray::new([0.0, 0.0, -10.0 * (z + 0.25)], [x, y, 1.0])
        })
        .collect();
    let numbers: Vec<[f32; 6]> = rays.iter().map(Ray::numbers).collect();
    let scope = Scope { fragment: SPHERES, ..Scope::default() };
    let rows =
        values("ball_march(p, vec3f(dx, dy, dz), 0.0, 100.0, 1.0, 1e-4, 0.0, 200)", &scope, RAY, &numbers);
    let (mut error, mut wrong, mut grazing) = (0.0_f64, 0, 0);
    for (ray, row) in rays.iter().zip(&rows) {
        let to_centre: [f64; 3] = std::array::from_fn(|i| [0.0, 0.0, 10.0][i] - ray.origin[i]);
        let along: f64 = to_centre.iter().zip(ray.direction).map(|(a, b)| a * b).sum();
        let aside2 = to_centre.iter().map(|a| a * a).sum::<f64>() - along * along;
        let aside = aside2.sqrt();
        if (aside - 2.0).abs() < 1e-3 {
            grazing += 1; // the last millimetre before the silhouette may be either
        } else if (row[1] != 0.0) != (aside < 2.0) {
            wrong += 1;
        } else if aside < 1.9 {
            error = error.max((row[0] - (along - (4.0 - aside2).sqrt())).abs());
        }
    }
    report.at_most("hits and misses mistaken, of 20000", f64::from(wrong), 0.0);
    report.at_most("rays within a millimetre of the silhouette, of 20000", f64::from(grazing), 100.0);
    report.at_most("largest error of the distance, up to .95 of the radius (m)", error, 1e-3);
    report.finish();
}

#[test]
fn a_sphere_throws_a_soft_shadow() {
    let mut report = Report::new("Sphere tracing", "a_sphere_throws_a_soft_shadow");
    // From far below the ball's edge outwards: the angle between the ray and the silhouette grows.
    let rays: Vec<[f32; 6]> = (0..400)
        .map(|i| {
            let sin = 0.17 + 0.06 * f64::from(i) / 400.0; // the silhouette is at .2
            Ray::new([0.0; 3], [sin, 0.0, (1.0 - sin * sin).sqrt()]).numbers()
        })
        .collect();
    let scope = Scope { fragment: SPHERES, ..Scope::default() };
    let soft =
        values("ball_shadow_soft(p, vec3f(dx, dy, dz), 0.01, 0.01, 100.0, 1.0, 300)", &scope, RAY, &rays);
    let hard =
        values("ball_shadow_hard(p, vec3f(dx, dy, dz), 0.01, 100.0, 1.0, 1e-4, 300)", &scope, RAY, &rays);
    let fall = soft.windows(2).map(|pair| pair[0][0] - pair[1][0]).fold(0.0, f64::max);
    report.at_most("soft: umbra, .03 rad within the silhouette", soft[0][0], 0.0);
    report.at_least("soft: full light, .03 rad outside", soft[399][0], 1.0);
    report.at_most("soft: most that it darkens outwards", fall, 0.01);
    report.near("soft: on the silhouette", soft[200][0], 0.5, 0.1);
    let mistaken = hard.iter().enumerate().filter(|(i, row)| (row[0] == 0.0) != (*i < 200)).count();
    report.at_most("hard: mistaken, of 400", mistaken as f64, 1.0);
    report.finish();
}
