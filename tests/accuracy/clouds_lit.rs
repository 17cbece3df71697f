//! Light in clouds: against layers that photons were followed through, and the energy that leaves them.

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
            return cloud_source(layer.cos_theta, layer.sun_mu, layer.view_mu, sun, above, below, medium);
        }
        return cloud_source_octaves(layer.cos_theta, sun, above, below, i32(kind), medium);
    }

    /// What an eye sees that looks along a ray of elevation cosine `view_mu`, in `steps` even steps.
    fn seen(kind: u32, layer: Layer, steps: i32, medium: CloudMedium) -> f32 {
        let way = layer.tau / abs(layer.view_mu) / f32(steps);
        var through = 1.0;
        var sum = 0.0;
        for (var i = 0; i < steps; i++) {
            let into = (f32(i) + 0.5) / f32(steps) * layer.tau;
            let above = select(into, layer.tau - into, layer.view_mu > 0.0);
            sum += through * source(kind, layer, above, medium) * (1.0 - exp(-way));
            through *= exp(-way);
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
        for (row, ratio) in rows.iter().zip(&ratio) {
            if (ratio - 1.0).abs() > if row.tau < 2.0 { 0.35 } else { 0.25 } {
                let Row { albedo, tau, sun, view, above, cos_theta, .. } = row;
                println!(
                    "albedo {albedo} tau {tau} sun {sun} view {view} above {above} cos {cos_theta:.3}: {ratio:.3}"
                );
            }
        }
        let what = |tau: &str| format!("{name}, {steps} steps, thickness {tau}: radiance off, relative");
        report.at_most(&what("below 2"), worst(&|row| row.tau < 2.0), 0.35);
        report.at_most(&what("2 and more"), worst(&|row| row.tau >= 2.0 && row.albedo == 1.0), 0.25);
        if rows.iter().any(|row| row.albedo < 1.0) {
            report.at_most(&what("2 and 16, albedo .9"), worst(&|row| row.albedo < 1.0), 0.5);
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
