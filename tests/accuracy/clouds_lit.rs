//! Light in clouds: against layers that photons were followed through, and the energy that leaves them.

use orogen::Preset;
use truth::points::Random;

use crate::harness::{Report, Scope, values};

const SECTION: &str = "Light";

/// Marches through layers; `medium` is g and g of the lobes, share of the first, albedo.
const LAYERS: &str = "
    #include <light/cloud.wgsl>
    struct Layer { tau: f32, sun_mu: f32, view_mu: f32, cos_theta: f32 }

    /// The source at a depth below the top. `kind`: 0 single, 1 two streams, 2 .. 8 so many octaves.
    fn source(kind: u32, layer: Layer, above: f32, medium: CloudMedium) -> f32 {
        let below = layer.tau - above;
        let sun = above / layer.sun_mu;
        if kind == 0u { return cloud_source_single(layer.cos_theta, sun, medium); }
        if kind == 1u {
            return cloud_source(layer.cos_theta, layer.sun_mu, layer.view_mu, sun, above, below, 1.0, medium);
        }
        return cloud_source_octaves(layer.cos_theta, sun, above, below, i32(kind), medium);
    }

    /// What an eye sees that looks along a ray of elevation cosine `view_mu`, in `steps` steps that grow with distance.
    fn seen(kind: u32, layer: Layer, steps: i32, medium: CloudMedium) -> f32 {
        var through = 1.0;
        var sum = 0.0;
        for (var i = 0; i < steps; i++) {
            let start = f32(i * i) / f32(steps * steps) * layer.tau;
            let end = f32((i + 1) * (i + 1)) / f32(steps * steps) * layer.tau;
            let into = 0.5 * (start + end);
            let above = select(into, layer.tau - into, layer.view_mu > 0.0);
            let clear = exp((start - end) / abs(layer.view_mu));
            sum += through * source(kind, layer, above, medium) * (1.0 - clear);
            through *= clear;
        }
        return sum;
    }

    fn slab(kind: u32, layer: Layer, steps: i32, albedo: f32) -> f32 {
        return seen(kind, layer, steps, CloudMedium(0.8, -0.3, 0.85, albedo));
    }
";

fn scope() -> Scope<'static> {
    Scope { fragment: LAYERS, ..Scope::default() }
}

/// A layer, a view of it, what was seen.
struct Row {
    albedo: f32,
    tau: f32,
    sun: f64,
    view: f64,
    above: bool,
    cos_theta: f64,
    radiance: f64,
}

fn row(numbers: &[f64]) -> Row {
    let &[albedo, tau, sun, view, azimuth, above, radiance] = numbers else {
        panic!("a row of seven numbers, not {numbers:?}");
    };
    let seen = truth::cloud_slab::View { zenith: view, azimuth, above: above > 0.5 };
    let cos_theta = seen.cosine_to_sun(sun);
    let [albedo, tau] = [albedo as f32, tau as f32];
    Row { albedo, tau, sun, view, above: seen.above, cos_theta, radiance }
}

/// As `cargo run -p truth --example cloud_slab` prints it.
fn table() -> Vec<Row> {
    let lines = include_str!("cloud_slab.csv").lines().skip(1);
    lines
        .map(|line| {
            let numbers: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            row(&numbers[..7])
        })
        .collect()
}

/// `reference/cloud_slab.json`: thickness, sun's zenith angle, view's, its azimuth, from above, radiance.
const REFERENCE: [[f64; 6]; 14] = [
    [0.5, 30.0, 0.0, 0.0, 1.0, 0.015_678],
    [0.5, 30.0, 60.0, 180.0, 1.0, 0.030_971],
    [0.5, 30.0, 30.0, 90.0, 0.0, 0.046_15],
    [0.5, 60.0, 60.0, 0.0, 0.0, 1.297_4],
    [2.0, 30.0, 60.0, 180.0, 1.0, 0.097_657],
    [2.0, 70.0, 45.0, 0.0, 1.0, 0.059_929],
    [2.0, 60.0, 60.0, 0.0, 0.0, 0.475_91],
    [8.0, 30.0, 0.0, 0.0, 1.0, 0.174_12],
    [8.0, 70.0, 45.0, 0.0, 1.0, 0.088_842],
    [8.0, 30.0, 30.0, 90.0, 0.0, 0.112_75],
    [32.0, 30.0, 0.0, 0.0, 1.0, 0.250_24],
    [32.0, 30.0, 60.0, 180.0, 1.0, 0.236_08],
    [32.0, 30.0, 30.0, 90.0, 0.0, 0.032_606],
    [32.0, 60.0, 60.0, 0.0, 0.0, 0.009_514_5],
];

/// Seen in so many steps over the truth, for each row.
fn seen(kind: u32, steps: i32, rows: &[Row]) -> Vec<f64> {
    let points: Vec<[f32; 5]> = rows
        .iter()
        .map(|row| {
            let view_mu = row.view.to_radians().cos() * if row.above { -1.0 } else { 1.0 };
            [row.tau, row.sun.to_radians().cos() as f32, view_mu as f32, row.cos_theta as f32, row.albedo]
        })
        .collect();
    let call = format!("slab({kind}u, Layer(tau, sun, view, cos_theta), {steps}, albedo)");
    let got = values(&call, &scope(), ["tau", "sun", "view", "cos_theta", "albedo"], &points);
    rows.iter().zip(&got).map(|(row, v)| v[0] / row.radiance).collect()
}

#[test]
fn clouds_shine_as_photons_say() {
    let mut report = Report::new(SECTION, "clouds_shine_as_photons_say");
    let reference: Vec<Row> = REFERENCE
        .iter()
        .map(|&[tau, sun, view, az, above, seen]| row(&[1.0, tau, sun, view, az, above, seen]))
        .collect();
    let ours = table();
    for (name, rows, steps) in
        [("reference/cloud_slab.json", &reference, 32), ("our table", &ours, 32), ("our table", &ours, 128)]
    {
        let ratio = seen(1, steps, rows);
        let worst = |pick: &dyn Fn(&Row) -> bool| {
            let picked = rows.iter().zip(&ratio).filter(|(row, _)| pick(row));
            picked.map(|(_, ratio)| (ratio - 1.0).abs()).fold(0.0, f64::max)
        };
        let what = |tau: &str| format!("{name}, {steps} steps, thickness {tau}: radiance off, relative");
        report.at_most(&what("below 2"), worst(&|row| row.tau < 2.0), 0.25);
        let offs = rows.iter().zip(&ratio).filter(|(row, _)| row.albedo == 1.0);
        let offs: Vec<f64> = offs.map(|(_, ratio)| (ratio - 1.0).abs()).collect();
        report.at_most(&what("2 and more"), worst(&|row| row.tau >= 2.0 && row.albedo == 1.0), 0.25);
        let mean = offs.iter().sum::<f64>() / offs.len() as f64;
        report.at_most(&what("any, in the mean"), mean, 0.1);
        if rows.iter().any(|row| row.albedo < 1.0) {
            report.at_most(&what("2 and 16, albedo .9"), worst(&|row| row.albedo < 1.0), 0.45);
        }
    }
    let thick: Vec<Row> = table().into_iter().filter(|row| row.tau >= 2.0).collect();
    for (name, kind) in [("single scattering", 0), ("4 octaves", 4), ("8 octaves", 8)] {
        let mut ratio = seen(kind, 32, &thick);
        ratio.sort_by(f64::total_cmp);
        report.told(
            &format!("{name}, thickness 2 and more: middle row's part of the truth"),
            ratio[ratio.len() / 2],
        );
    }
    report.finish();
}

#[test]
fn clouds_give_no_more_light_than_they_get() {
    // All that leaves a layer over what came in: 16 cosines (Gauss) × 24 azimuths on both sides, and the direct light.
    let fragment = format!("{LAYERS}{}", "
        const NODES = array<vec2f, 8>(
            vec2f(0.0950125098, 0.1894506105), vec2f(0.2816035508, 0.1826034150), vec2f(0.4580167777, 0.1691565194),
            vec2f(0.6178762444, 0.1495959888), vec2f(0.7554044084, 0.1246289713), vec2f(0.8656312024, 0.0951585117),
            vec2f(0.9445750231, 0.0622535239), vec2f(0.9894009350, 0.0271524594),
        );
        fn leaving(kind: u32, tau: f32, sun_mu: f32, medium: CloudMedium) -> f32 {
            var sum = 0.0;
            for (var i = 0; i < 32; i++) {
                let node = NODES[(i / 2) % 8];
                let mu = 0.5 + 0.5 * select(node.x, -node.x, i >= 16);
                let view_mu = select(mu, -mu, i % 2 == 0);
                var ring = 0.0;
                for (var j = 0; j < 24; j++) {
                    let azimuth = (f32(j) + 0.5) * 3.14159265 / 24.0;
                    let across = sqrt((1.0 - mu * mu) * (1.0 - sun_mu * sun_mu)) * cos(azimuth);
                    ring += seen(kind, Layer(tau, sun_mu, view_mu, across + view_mu * sun_mu), 40, medium);
                }
                sum += ring / 24.0 * mu * 0.5 * node.y;
            }
            return 6.2831853 * sum / sun_mu + exp(-tau / sun_mu);
        }
        fn furnace(tau: f32, at: f32, view_mu: f32, g: f32, albedo: f32) -> f32 {
            let ambient = cloud_ambient_source(view_mu, at * tau, (1.0 - at) * tau, CloudMedium(g, 0.0, 1.0, albedo));
            return ambient.x + ambient.y;
        }
        fn least(tau: f32, at: f32, view_mu: f32, g: f32, albedo: f32) -> f32 {
            let ambient = cloud_ambient_source(view_mu, at * tau, (1.0 - at) * tau, CloudMedium(g, 0.0, 1.0, albedo));
            return min(ambient.x, ambient.y);
        }");
    let scope = Scope { fragment: &fragment, ..Scope::default() };
    let mut report = Report::new(SECTION, "clouds_give_no_more_light_than_they_get");
    let mut points = Vec::new();
    for tau in [0.1_f32, 0.3, 0.5, 1.0, 2.0, 4.0, 8.0, 32.0, 128.0] {
        for sun in [0.0_f32, 20.0, 40.0, 50.0, 60.0, 70.0, 75.0, 80.0, 85.0] {
            points.push([tau, sun.to_radians().cos()]);
        }
    }
    for (name, medium, albedo) in [
        ("g .8 and -.3", "0.8, -0.3, 0.85", 1.0),
        ("isotropic", "0.0, 0.0, 1.0", 1.0),
        ("g .5", "0.5, 0.0, 1.0", 1.0),
        ("g .9 and -.4", "0.9, -0.4, 0.7", 1.0),
        ("g .8 and -.3, albedo .8", "0.8, -0.3, 0.85", 0.8),
    ] {
        for (kind, way) in [(1, "two streams"), (8, "8 octaves")] {
            let call = format!("leaving({kind}u, tau, mu, CloudMedium({medium}, {albedo:?}))");
            let got = values(&call, &scope, ["tau", "mu"], &points);
            let most = got.iter().map(|v| v[0]).fold(0.0, f64::max);
            let least = got.iter().map(|v| v[0]).fold(f64::MAX, f64::min);
            report.at_most(
                &format!("{way}, {name}: light out over light in, thickness .1 .. 128, suns 0 .. 85°"),
                most,
                1.001,
            );
            report.told(&format!("{way}, {name}: least of it"), least);
        }
    }
    let mut points = Vec::new();
    for tau in [0.0_f32, 0.01, 0.3, 1.0, 3.0, 10.0, 100.0, 1e4, 1e9] {
        for at in [0.0_f32, 0.1, 0.5, 0.9, 1.0] {
            for view in [-1.0_f32, -0.5, 0.0, 0.3, 1.0] {
                for g in [-0.5_f32, 0.0, 0.5, 0.8, 0.95] {
                    points.push([tau, at, view, g]);
                }
            }
        }
    }
    let all = |call: &str| -> Vec<f64> {
        values(call, &scope, ["tau", "at", "view", "g"], &points).into_iter().map(|v| v[0]).collect()
    };
    let ambient = all("furnace(tau, at, view, g, 1.0)");
    let off = ambient.iter().map(|v| (v - 1.0).abs()).fold(0.0, f64::max);
    report.at_most("white furnace (radiance 1 all around, albedo 1): off 1", off, 1e-3);
    for albedo in [0.999_99_f32, 0.99, 0.5, 0.0] {
        let ambient = all(&format!("furnace(tau, at, view, g, {albedo:?})"));
        let most = ambient.iter().copied().fold(f64::MIN, f64::max);
        report.at_most(&format!("furnace, albedo {albedo}: most"), most, 1.001);
        let least = all(&format!("least(tau, at, view, g, {albedo:?})")).into_iter().fold(f64::MAX, f64::min);
        report.at_least(&format!("furnace, albedo {albedo}: least from the sky or the ground"), least, 0.0);
    }
    report.finish();
}

/// What of the sun's light on the layer leaves it at its upper (1) or lower side (-1) near `p`, by one ray, and directly.
const HEAPS: &str = "
    #include <clouds/layer.wgsl>
    fn heap_leaving(p: vec2f, u: f32, turn: f32, side: f32) -> f32 {
        // As many rays to all parts of a level surface's view: their mean radiance times pi is its irradiance.
        let level = sqrt(u);
        let direction = normalize(vec3f(level * cos(turn), -side * max(sqrt(1.0 - u), 0.02), level * sin(turn)));
        let height = select(-10.0, clouds.thickness + 10.0, side > 0.0);
        let eye = vec3f(p.x, clouds.base + height, p.y);
        return 3.14159265 * clouds_found(eye, direction, 0.0, 1e6, 0.5, 0.0005).radiance.x;
    }
    fn heap_direct(p: vec2f) -> f32 {
        let below = vec3f(p.x, clouds.base - 10.0, p.y);
        let way = cloud_ahead(below, key_direction());
        let step = (way.y - way.x) / 300.0;
        var depth = 0.0;
        for (var i = 0; i < 300; i++) {
            depth += step * cloud_extinction(below + (way.x + step * (f32(i) + 0.5)) * key_direction(), 0.0);
        }
        return exp(-depth);
    }
";

/// Rays to each side of a layer, for each sun.
const RAYS: usize = 6000;

#[test]
fn heaps_give_no_more_light_than_they_get() {
    let mut report = Report::new(SECTION, "heaps_give_no_more_light_than_they_get");
    let mut random = Random::new(41);
    let rays: Vec<[f32; 4]> = (0..RAYS)
        .map(|i| {
            let part = (i as f32 + random.within(0.0, 1.0)) / RAYS as f32;
            [
                random.within(-6e4, 6e4),
                random.within(-6e4, 6e4),
                part,
                random.within(0.0, std::f32::consts::TAU),
            ]
        })
        .collect();
    let layers: [(&str, &[&str]); 6] = [
        ("cumulus", &["clouds.coverage=0.42"]),
        (
            "puffs",
            &["clouds.coverage=0.085", "clouds.thickness=460", "clouds.scale=720", "clouds.clumping=0.8"],
        ),
        ("heaps apart", &["clouds.coverage=0.3", "clouds.clumping=2"]),
        ("stratocumulus", &["clouds.type=0.6", "clouds.coverage=0.8", "clouds.scale=1700"]),
        (
            "a storm",
            &["clouds.coverage=0.74", "clouds.thickness=5500", "clouds.scale=7000", "clouds.extinction=0.03"],
        ),
        ("a sheet of fBm", &["clouds.form=plain"]),
    ];
    for (name, settings) in layers {
        let (mut most, mut least, mut unsure) = (0.0_f64, f64::MAX, 0.0_f64);
        for elevation in [10.0_f64, 25.0, 70.0] {
            let mut preset = Preset::of_module("clouds/layer.wgsl");
            let sun = format!("sun.elevation={elevation}");
            for setting in settings.iter().chain(&["quality=high", &sun]) {
                preset.set(setting).unwrap();
            }
            let scope = Scope { fragment: HEAPS, preset: Some(&preset), ..Scope::default() };
            let columns = ["x", "z", "u", "turn"];
            let mu = elevation.to_radians().sin();
            let sums: Vec<f64> =
                ["heap_leaving(vec2f(x, z), u, turn, 1.0)", "heap_leaving(vec2f(x, z), u, turn, -1.0)"]
                    .map(|call| values(call, &scope, columns, &rays))
                    .iter()
                    .map(|rows| rows.iter().map(|row| row[0] / mu))
                    .fold(vec![0.0; rays.len()], |sums, side| {
                        sums.iter().zip(side).map(|(a, b)| a + b).collect()
                    });
            let direct = values("heap_direct(vec2f(x, z))", &scope, columns, &rays);
            let all: Vec<f64> = sums.iter().zip(&direct).map(|(a, b)| a + b[0]).collect();
            let mean = all.iter().sum::<f64>() / all.len() as f64;
            let spread = all.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / all.len() as f64;
            most = most.max(mean);
            least = least.min(mean);
            unsure = unsure.max((spread / all.len() as f64).sqrt());
        }
        // No more than comes in, but for what so few rays can tell.
        let bound = 1.0 + unsure;
        report.at_most(&format!("{name}: light out over light in, suns 10 .. 70° high: most"), most, bound);
        report.at_least(&format!("{name}: least"), least, 0.75);
        report.told(&format!("{name}: standard error of these"), unsure);
    }
    report.finish();
}

#[test]
fn clouds_are_lit_finitely_whatever_the_numbers() {
    let depths = [0.0_f32, 1e-6, 0.02, 0.5, 3.0, 40.0, 1e4, 3e38];
    let mut points = Vec::new();
    let mut random = Random::new(7);
    let mut pick = |from: &[f32]| from[random.bits() as usize % from.len()];
    for _ in 0..20_000 {
        let sun = pick(&[-1.0, -0.3, -0.01, 0.0, 0.01, 0.05, 0.4, 1.0]);
        let view = pick(&[-1.0, -0.5, 0.0, 1e-4, 0.7, 1.0]);
        let g = pick(&[0.0, 0.3, 0.8, 0.95]);
        let albedo = pick(&[0.0, 0.3, 0.6, 0.9, 0.999, 0.999_999_9, 1.0]);
        let [to_sun, above, below] = [pick(&depths), pick(&depths), pick(&depths)];
        points.push([pick(&[-1.0, 0.0, 0.9, 1.0]), sun, view, to_sun, above, below, g, albedo]);
    }
    let columns = ["c", "sun", "view", "to_sun", "above", "below", "g", "albedo"];
    let medium = "CloudMedium(g, -0.3 * g, 0.85, albedo)";
    let mut report = Report::new(SECTION, "clouds_are_lit_finitely_whatever_the_numbers");
    for (name, call) in [
        ("two streams", format!("cloud_source(c, sun, view, to_sun, above, below, 0.3, {medium})")),
        ("octaves", format!("cloud_source_octaves(c, to_sun, above, below, 6, {medium})")),
        ("ambient", format!("cloud_ambient_source(view, above, below, {medium})")),
    ] {
        let got = values(&call, &scope(), columns, &points);
        let wrong = got.iter().flatten().filter(|v| !v.is_finite() || **v < 0.0).count();
        report.at_most(&format!("{name}: not finite or negative, of 20,000"), wrong as f64, 0.0);
        let most = got.iter().flatten().copied().fold(0.0, f64::max);
        report.told(&format!("{name}: most"), most);
    }
    report.finish();
}
