//! All orders of scattering against traced paths: the sky's radiance, the ground's irradiance, energy, and no surprises.

use orogen::Preset;
use truth::points::Random;

use crate::atmosphere::MARS;
use crate::harness::{Report, Scope, values};

const SECTION: &str = "Sky, all orders of scattering";
const SKY: &[&str] = &["<sky/scattering.wgsl>"];
const ORDERS: &[&str] = &["<sky/orders.wgsl>"];

/// `reference/sky_all_orders.json`: the eye's height (m), zenith angles of sun and view, azimuth between them; radiance.
const REFERENCE: [([f64; 4], [f64; 3]); 4] = [
    ([500.0, 45.0, 0.0, 0.0], [0.005_474, 0.011_982, 0.028_805]),
    ([500.0, 65.0, 80.0, 90.0], [0.017_705, 0.034_663, 0.064_707]),
    ([500.0, 85.0, 80.0, 90.0], [0.011_542, 0.016_486, 0.022_818]),
    ([500.0, 94.0, 60.0, 0.0], [0.000_401_94, 0.000_263_53, 0.000_521_64]),
];

/// A row of a traced table: what it is of, three colours, and their standard errors.
struct Row {
    key: Vec<f64>,
    light: [f64; 3],
}

/// The rows of a table under `tests/accuracy/orders/`, which `truth`'s example `orders` prints.
fn table(text: &str, name: &str) -> Vec<Row> {
    let rows = text.lines().skip(1).filter(|line| name.is_empty() || line.split(',').next() == Some(name));
    rows.map(|line| {
        let cells: Vec<f64> =
            line.split(',').skip(usize::from(!name.is_empty())).map(|x| x.parse().unwrap()).collect();
        let (key, light) = cells.split_at(cells.len() - 6);
        Row { key: key.to_vec(), light: [light[0], light[1], light[2]] }
    })
    .collect()
}

fn preset(settings: &[&str]) -> Preset {
    let mut preset = Preset::of_text("none", "");
    for setting in settings {
        preset.set(setting).unwrap();
    }
    preset
}

fn direction(zenith: f64, azimuth: f64) -> [f32; 3] {
    let (sine, cosine) = zenith.to_radians().sin_cos();
    let (across, ahead) = azimuth.to_radians().sin_cos();
    [sine * ahead, cosine, sine * across].map(|x| x as f32)
}

/// Relative errors of the sky's radiance, row for row.
fn radiance_errors(rows: &[Row], settings: &[&str]) -> Vec<[f64; 3]> {
    let preset = preset(settings);
    let scope = Scope { includes: SKY, preset: Some(&preset), ..Scope::default() };
    let points: Vec<[f32; 7]> = rows
        .iter()
        .map(|row| {
            let [x, y, z] = direction(row.key[2], row.key[3]);
            let [sun_x, sun_y, sun_z] = direction(row.key[1], 0.0);
            [row.key[0] as f32, x, y, z, sun_x, sun_y, sun_z]
        })
        .collect();
    let columns = ["h", "x", "y", "z", "a", "b", "c"];
    let got = values("atmosphere_radiance(h, vec3f(x, y, z), vec3f(a, b, c))", &scope, columns, &points);
    rows.iter().zip(got).map(|(row, value)| relative(&value, row.light)).collect()
}

fn relative(value: &[f64], truth: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|channel| value[channel] / truth[channel] - 1.0)
}

/// The worst error of any colour among rows whose sun is in a range (degrees from the zenith); NaN is the worst of all.
fn worst(rows: &[Row], errors: &[[f64; 3]], low: f64, high: f64) -> f64 {
    let inside = rows.iter().zip(errors).filter(|(row, _)| (low..=high).contains(&row.key[1]));
    let mut worst: f64 = -1.0;
    for (_, error) in inside {
        for x in error {
            worst = if x.is_nan() { f64::NAN } else { worst.max(x.abs()) };
        }
    }
    assert!(worst != -1.0, "no sun between {low} and {high}");
    worst
}

#[test]
fn the_sky_is_that_of_traced_paths() {
    let mut report = Report::new(SECTION, "the_sky_is_that_of_traced_paths");
    let reference: Vec<Row> =
        REFERENCE.iter().map(|&(key, light)| Row { key: key.to_vec(), light }).collect();
    let errors = radiance_errors(&reference, &[]);
    report.at_most(
        "reference/sky_all_orders.json, suns to 85°: relative error",
        worst(&reference, &errors, 0.0, 85.0),
        0.05,
    );
    report.at_most("the same, sun at 94°", worst(&reference, &errors, 94.0, 94.0), 0.25);

    let rows = table(include_str!("orders/views.csv"), "");
    assert_eq!(rows.len(), 180);
    let errors = radiance_errors(&rows, &[]);
    let classes = [
        ("20° to 85°", 0.0, 85.0, 0.05),
        ("88° to 90°", 88.0, 90.0, 0.1),
        ("92°", 92.0, 92.0, 0.25),
        ("94°", 94.0, 94.0, 0.25),
        ("96°", 96.0, 96.0, 0.25),
    ];
    for (name, low, high, bound) in classes {
        let what = format!("180 views from .5 m to 10 km, zenith to horizon, suns at {name}: relative error");
        report.at_most(&what, worst(&rows, &errors, low, high), bound);
    }
    report.finish();
}

#[test]
fn other_air_is_lit_as_it_should_be() {
    let mut report = Report::new(SECTION, "other_air_is_lit_as_it_should_be");
    let text = include_str!("orders/others.csv");
    let hazy = |times: f64| {
        let each = |x: f64| format!("[{x},{x},{x}]");
        [
            format!("sky.mie_scattering={}", each(3.996 * times)),
            format!("sky.mie_absorption={}", each(0.444 * times)),
        ]
    };
    let (hazy4, hazy10) = (hazy(4.0), hazy(10.0));
    let airs: [(&str, &str, Vec<&str>, [f64; 2]); 3] = [
        ("haze4", "four times Earth's aerosols", hazy4.iter().map(String::as_str).collect(), [0.05, 0.12]),
        ("haze10", "ten times Earth's aerosols", hazy10.iter().map(String::as_str).collect(), [0.08, 0.2]),
        ("mars", "Mars", MARS.to_vec(), [0.13, 0.4]),
    ];
    for (key, name, settings, [usual, bound]) in airs {
        let mut rows = table(text, key);
        rows.retain(|row| row.key[1] <= 90.0);
        assert_eq!(rows.len(), 40);
        let errors = radiance_errors(&rows, &settings);
        let squares: f64 = errors.iter().flatten().map(|x| x * x).sum();
        let mean = (squares / (3 * errors.len()) as f64).sqrt();
        report.at_most(&format!("{name}, suns to 90°, 40 views: root mean square error"), mean, usual);
        report.at_most("the same: worst error", worst(&rows, &errors, 0.0, 90.0), bound);
    }
    report.finish();
}

#[test]
fn level_ground_gets_what_traced_paths_bring() {
    let mut report = Report::new(SECTION, "level_ground_gets_what_traced_paths_bring");
    let rows = table(include_str!("orders/irradiance.csv"), "");
    assert_eq!(rows.len(), 36);
    let points: Vec<[f32; 2]> =
        rows.iter().map(|row| [row.key[0] as f32, row.key[1].to_radians().cos() as f32]).collect();
    let scope = Scope { includes: ORDERS, ..Scope::default() };
    let got = values("orders_irradiance(h, mu)", &scope, ["h", "mu"], &points);
    let errors: Vec<[f64; 3]> = rows.iter().zip(&got).map(|(row, v)| relative(v, row.light)).collect();
    let classes =
        [("0° to 85°", 0.0, 85.0, 0.05), ("88° and 90°", 88.0, 90.0, 0.1), ("92° to 96°", 92.0, 96.0, 0.25)];
    for (name, low, high, bound) in classes {
        let what =
            format!("irradiance by the sky from 0 to 10 km, suns at {name} from the zenith: relative error");
        report.at_most(&what, worst(&rows, &errors, low, high), bound);
    }
    report.finish();
}

/// Light that comes back out of the air at its top, over all directions, and light that the ground keeps, of what comes in:
/// (reflected, kept) with `steps` × `steps` directions, the sun at `mu`.
const FURNACE: &str = "
#include <sky/scattering.wgsl>
fn furnace(mu: f32, steps: u32) -> array<vec3f, 2> {
    let to_sun = vec3f(sqrt(1.0 - mu * mu), mu, 0.0);
    let top = sky.air_height;
    var out = vec3f(0.0);
    for (var k = 0u; k < steps * steps; k++) {
        // Directions that meet the planet, which fill the disc evenly; what leaves, per area of the planet's ground.
        let low = 1.0 - pow(sky.ground_radius / (sky.ground_radius + top), 2.0);
        let squared = mix(low, 1.0, (f32(k / steps) + 0.5) / f32(steps));
        let azimuth = 3.14159265 * (f32(k % steps) + 0.5) / f32(steps);
        let sine = sqrt(1.0 - squared);
        let view = vec3f(sine * cos(azimuth), -sqrt(squared), sine * sin(azimuth));
        out += atmosphere_radiance(top, view, to_sun) * 3.14159265 / f32(steps * steps);
    }
    let kept = (1.0 - sky.ground_albedo) * (mu * atmosphere_transmittance(0.0, mu) + orders_irradiance(0.0, mu));
    return array<vec3f, 2>(out / mu, kept / mu);
}
";

/// Airs that absorb nothing, over white ground: parameters of `sky`.
const WHITE: &[&str] =
    &["sky.mie_absorption=[0,0,0]", "sky.ozone_absorption=[0,0,0]", "sky.ground_albedo=[1,1,1]"];

#[test]
fn no_air_gives_back_more_light_than_it_gets() {
    let mut report = Report::new(SECTION, "no_air_gives_back_more_light_than_it_gets");
    let airs: [(&str, &[&str], f64); 5] = [
        ("Earth's air that absorbs nothing", &["sky.ground_albedo=[0.3,0.3,0.3]"], 0.97),
        ("the same over white ground", &[], 0.94),
        ("the same over black ground", &["sky.ground_albedo=[0,0,0]"], 0.97),
        (
            "ten times the aerosols",
            &["sky.ground_albedo=[0.3,0.3,0.3]", "sky.mie_scattering=[40,40,40]"],
            0.97,
        ),
        ("the same over white ground", &["sky.mie_scattering=[40,40,40]"], 0.9),
    ];
    for (name, settings, bound) in airs {
        let preset = preset(&[WHITE, settings].concat());
        let scope = Scope { fragment: FURNACE, preset: Some(&preset), ..Scope::default() };
        let points: Vec<[f32; 1]> = [0.3, 0.5, 0.7, 0.85, 1.0_f32].map(|mu| [mu]).to_vec();
        let back = values("furnace(mu, 16u)[0]", &scope, ["mu"], &points);
        let kept = values("furnace(mu, 16u)[1]", &scope, ["mu"], &points);
        let sums = || (0..points.len()).flat_map(|i| (0..3).map(move |c| (i, c)));
        let most = sums().map(|(i, c)| back[i][c] + kept[i][c]).fold(0.0, f64::max);
        let least = sums().map(|(i, c)| back[i][c] + kept[i][c]).fold(f64::MAX, f64::min);
        report.at_most(
            &format!("{name}: what leaves and what the ground keeps, of what comes in"),
            most,
            1.001,
        );
        report.at_least("the same, at least", least, bound);
    }
    report.finish();
}

/// What is seen in a sky of radiance 1 all around: the air's own light out of it, and what shows through from behind.
const SURROUNDED: &str = "
#include <sky/scattering.wgsl>
fn surrounded(height: f32, view_mu: f32, steps: u32) -> vec3f {
    let view = vec3f(sqrt(1.0 - view_mu * view_mu), view_mu, 0.0);
    let way = atmosphere_way(AirPlace(height, view_mu), RAY_FAR);
    var seen = vec3f(0.0);
    if !way.grounded {
        seen = exp(-medium_extinction(air_path_between(atmosphere_shells(), way.start, way.length)));
    }
    // Suns over one half of the sphere, the other being its mirror image; densest on the horizon.
    for (var k = 0u; k < 4u * steps * steps; k++) {
        let u = (f32(k / steps) + 0.5) / f32(2u * steps) - 1.0;
        let turn = 3.14159265 * (f32(k % steps) + 0.5) / f32(steps);
        let mu = u * abs(u);
        let level = sqrt(1.0 - mu * mu);
        let to_sun = vec3f(level * cos(turn), mu, level * sin(turn));
        seen += atmosphere_radiance(height, view, to_sun) * (6.2831853 * abs(u) / f32(steps * steps));
    }
    return seen;
}
";

#[test]
fn air_and_white_ground_vanish_in_a_white_furnace() {
    let mut report = Report::new(SECTION, "air_and_white_ground_vanish_in_a_white_furnace");
    let airs: [(&str, &[&str], f64); 6] = [
        ("Earth's air", &[], 0.8),
        ("molecules alone", &["sky.mie_scattering=[0,0,0]"], 0.8),
        ("ten times the aerosols", &["sky.mie_scattering=[40,40,40]"], 0.7),
        ("three times the molecules", &["sky.rayleigh_scattering=[17.4,40.7,99.3]"], 0.75),
        ("a sixth of the molecules", &["sky.rayleigh_scattering=[0.97,2.26,5.52]"], 0.8),
        ("Mars's", &[MARS, WHITE].concat(), 0.5),
    ];
    for (name, settings, bound) in airs {
        let preset = preset(&[WHITE, settings].concat());
        let scope = Scope { fragment: SURROUNDED, preset: Some(&preset), ..Scope::default() };
        let heights = [0.5, 2000.0, 10_000.0, 40_000.0, 300_000.0];
        let views = [-1.0, -0.5, -0.15, -0.02, 0.02, 0.15, 0.5, 1.0_f32];
        let points: Vec<[f32; 2]> =
            heights.iter().flat_map(|&height| views.map(|view| [height, view])).collect();
        let seen = values("surrounded(h, v, 24u)", &scope, ["h", "v"], &points);
        let most = seen.iter().flatten().copied().fold(0.0, f64::max);
        let least = seen.iter().flatten().copied().fold(f64::MAX, f64::min);
        report.at_most(&format!("{name}: most of what is seen, of a radiance of 1 all around"), most, 1.001);
        report.at_least(&format!("{name}: least"), least, bound);
    }
    report.finish();
}

#[test]
fn light_of_all_orders_is_light_everywhere() {
    let mut report = Report::new(SECTION, "light_of_all_orders_is_light_everywhere");
    let mut random = Random::new(94);
    let mut points: Vec<[f32; 4]> = (0..20_000)
        .map(|_| {
            let height = 10.0_f32.powf(random.within(-3.0, 6.0)) - random.within(0.0, 1.0);
            [height, random.within(-1.0, 1.0), random.within(-1.0, 1.0), random.within(-1.0, 1.0)]
        })
        .collect();
    for height in [-12_000.0, 0.0, 1e5, 2e7] {
        for sun in [-1.0, -1e-7, 0.0, 1.0] {
            for view in [-1.0, 0.0, 1.0] {
                points.extend([-1.0, 0.0, 1.0].map(|cosine| [height, sun, view, cosine]));
            }
        }
    }
    let thick = ["sky.mie_scattering=[9999,9999,9999]", "sky.rayleigh_scattering=[9999,9999,9999]"];
    let thin = ["sky.mie_scattering=[0,0,0]", "sky.rayleigh_scattering=[0,0,0]", "sky.ground_albedo=[1,1,1]"];
    let small = ["sky.ground_radius=1000", "sky.mie_asymmetry=-0.98", "sky.air_height=100"];
    let wide = ["sky.ground_radius=100000000", "sky.rayleigh_height=10", "sky.mie_asymmetry=0.98"];
    let airs: [(&str, &[&str]); 6] = [
        ("Earth", &[]),
        ("Mars", MARS),
        ("the thickest air", &thick),
        ("no air over white ground", &thin),
        ("a planet of a kilometre", &small),
        ("thin air around a giant", &wide),
    ];
    for (name, settings) in airs {
        let preset = preset(settings);
        let scope = Scope { includes: ORDERS, preset: Some(&preset), ..Scope::default() };
        let source = values("orders_source(h, s, v, c)", &scope, ["h", "s", "v", "c"], &points);
        let level = values("orders_irradiance(h, s)", &scope, ["h", "s", "v", "c"], &points);
        let dark = source.iter().chain(&level).flatten().filter(|x| !(x.is_finite() && **x >= 0.0)).count();
        report.at_most(&format!("{name}: values that are no light, of 120,864"), dark as f64, 0.0);
        let most = level.iter().flatten().copied().fold(0.0, f64::max);
        // Net flux is (1 - albedo) times what falls on the ground, and no more than what comes in.
        report.at_most(&format!("{name}: greatest irradiance by the sky, of the sun's"), most, 1.0 / 0.7);
    }
    report.finish();
}

#[test]
fn the_sun_goes_under_without_a_step() {
    let mut report = Report::new(SECTION, "the_sun_goes_under_without_a_step");
    let scope = Scope { includes: ORDERS, ..Scope::default() };
    // From overhead to straight below, by hundredths of a degree.
    let points: Vec<[f32; 2]> = [0.0, 3000.0, 20_000.0]
        .iter()
        .flat_map(|&height| (0..=18_000).map(move |i| [height, (f64::from(i) / 100.0).to_radians() as f32]))
        .collect();
    for (name, call) in [
        ("light scattered per metre", "orders_source(h, cos(a), 0.1, 0.2)"),
        ("irradiance", "orders_irradiance(h, cos(a))"),
    ] {
        let light = values(call, &scope, ["h", "a"], &points);
        let (mut step, mut bend) = (0.0_f64, 0.0_f64);
        for rows in light.chunks(18_001) {
            for three in rows.windows(3) {
                for channel in 0..3 {
                    let [a, b, c] = [0, 1, 2].map(|i| three[i][channel]);
                    let (first, second) = ((b / a).ln(), (c / b).ln());
                    if b > 1e-9 * rows[0][channel] {
                        step = step.max(first.abs());
                        bend = bend.max((second - first).abs());
                    }
                }
            }
        }
        report.at_most(&format!("{name}: part that it changes by in a hundredth of a degree"), step, 0.02);
        report.at_most("the same: change of that part", bend, 0.005);
        let night = light.chunks(18_001).flat_map(|rows| (0..3).map(|c| rows[12_000][c] / rows[0][c]));
        report.at_most(
            "the same, sun 30° under the horizon, of the light at noon",
            night.fold(0.0, f64::max),
            1e-6,
        );
    }
    report.finish();
}
