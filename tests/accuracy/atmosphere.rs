//! The air of a planet: optical paths, transmittance, first-order light, from the ground up to space.

use orogen::Preset;
use truth::atmosphere::Air;
use truth::points::Random;

use crate::harness::{Report, Scope, values};

const SECTION: &str = "Atmosphere";
const INCLUDES: &[&str] = &["<sky/scattering.wgsl>"];

/// `reference/atmosphere.json`: height (m), mu, transmittance.
pub(crate) const TRANSMITTANCE: [(f32, f32, [f64; 3]); 3] = [
    (0.0, 1.0, [0.940_358_774, 0.867_615_595, 0.762_309_979]),
    (0.0, 0.5, [0.884_783_652, 0.753_857_926, 0.582_282_395]),
    (0.0, 0.1, [0.579_071_814, 0.287_179_084, 0.085_378_677_2]),
];

/// `reference/atmosphere.json`: the eye's height (m; the table's are km), zenith angles of sun and view, azimuth between
/// them, single scattering.
pub(crate) const RADIANCE: [([f32; 4], [f64; 3]); 3] = [
    ([500.0, 45.0, 0.0, 0.0], [0.003_837_449_59, 0.007_907_140_21, 0.016_565_177_2]),
    ([500.0, 65.0, 80.0, 90.0], [0.011_845_405_1, 0.020_930_170_3, 0.031_083_149_1]),
    ([500.0, 85.0, 80.0, 90.0], [0.009_289_349_03, 0.011_681_415_1, 0.011_695_150_7]),
];

/// The air of Mars.
pub(crate) const MARS: &[&str] = &[
    "sky.ground_radius=3389500",
    "sky.air_height=120000",
    "sky.rayleigh_scattering=[19.918,13.57,5.75]",
    "sky.rayleigh_height=10430",
    "sky.mie_scattering=[53.618,53.618,53.618]",
    "sky.mie_absorption=[0.553,0.553,0.553]",
    "sky.mie_height=3095",
    "sky.mie_asymmetry=0.85",
    "sky.ozone_absorption=[0,0,0]",
];

/// A planet's air in the truth and in a preset.
fn planet(name: &str) -> (Air, &'static [&'static str]) {
    if name == "Earth" { (Air::earth(), &[]) } else { (Air::mars(), MARS) }
}

fn preset(settings: &[&str], samples: usize) -> Preset {
    let mut preset = Preset::of_text("none", "");
    for setting in settings {
        preset.set(setting).unwrap();
    }
    preset.set("sky.multiple_scattering=false").unwrap();
    preset.set(&format!("sky.samples={samples}")).unwrap();
    preset
}

#[test]
fn transmittance_is_that_of_the_integral() {
    let mut report = Report::new(SECTION, "transmittance_is_that_of_the_integral");
    for name in ["Earth", "Mars"] {
        let (air, settings) = planet(name);
        let preset = preset(settings, 8);
        let scope = Scope { includes: INCLUDES, preset: Some(&preset), ..Scope::default() };
        let call =
            |points: &[[f32; 2]]| values("atmosphere_transmittance(h, mu)", &scope, ["h", "mu"], points);
        if name == "Earth" {
            let got = call(&TRANSMITTANCE.map(|row| [row.0, row.1]));
            let off =
                TRANSMITTANCE.iter().zip(&got).map(|(row, v)| relative(v, row.2, 0.0)).fold(0.0, f64::max);
            report.at_most("Earth: off reference/atmosphere.json, relative", off, 0.003);
        }
        let mut points = Vec::new();
        for height in
            [0.0, 0.5, 2.0, 50.0, 500.0, 1.5e3, 4e3, 9e3, 12e3, 20e3, 27e3, 36e3, 50e3, 70e3, 90e3_f32]
        {
            points.extend((0..=200).map(|i| [height, i as f32 / 100.0 - 1.0]));
            points.extend((-150..=150).map(|i| [height, i as f32 / 1000.0]));
        }
        for height in [110e3, 300e3, 2e6, 2e7_f32] {
            let tangent = |low: f64| {
                let sine = (air.ground + low) / (air.ground + f64::from(height));
                [height, -(1.0 - sine * sine).sqrt() as f32]
            };
            points.extend((1..100).map(|i| tangent(1e3 * f64::from(i))));
            points.push([height, 0.5]);
        }
        let got = call(&points);
        let (mut off, mut shadow, mut space) = (0.0_f64, 0.0_f64, 0.0_f64);
        for ([height, mu], v) in points.iter().zip(&got) {
            let (h, mu) = (f64::from(*height), f64::from(*mu));
            let foot = (air.ground + h) * (1.0 - mu * mu).max(0.0).sqrt() - air.ground;
            let exact = air.transmittance(h, mu);
            if mu < 0.0 && foot < -5.0 {
                shadow = shadow.max(v[0].max(v[1]).max(v[2]));
            } else if mu >= 0.0 || foot > 5.0 {
                let row = relative(v, exact, 1e-7);
                if h > 1e5 { space = space.max(row) } else { off = off.max(row) }
            }
        }
        report.at_most(
            &format!("{name}: off the integral, 0 to 90 km, all directions, relative"),
            off,
            0.003,
        );
        report.at_most(
            &format!("{name}: off the integral, limbs from 110 to 20,000 km, relative"),
            space,
            0.003,
        );
        report.at_most(&format!("{name}: greatest where the planet is in the way"), shadow, 0.0);
    }
    report.finish();
}

#[test]
fn optical_paths_are_those_of_the_integral() {
    let mut report = Report::new(SECTION, "optical_paths_are_those_of_the_integral");
    let scope = Scope { includes: &["<light/optical_depth.wgsl>"], ..Scope::default() };
    let shells = "AirShells(6360000.0, vec2f(8000.0, 1200.0), 25000.0, 15000.0)";
    let air = Air::earth();
    let mut random = Random::new(40);
    let mut points: Vec<[f32; 3]> = Vec::new();
    while points.len() < 4000 {
        let height = [0.5, 100.0, 3e3, 12e3, 24e3, 39e3, 60e3][points.len() % 7];
        let mu = if points.len().is_multiple_of(3) {
            random.within(-0.04, 0.04)
        } else {
            random.within(-1.0, 1.0)
        };
        let distance = 10_f32.powf(random.within(0.0, 6.0));
        let end = {
            let r = air.ground + f64::from(height);
            let (mu, t) = (f64::from(mu), f64::from(distance));
            let lowest = if mu < 0.0 { t.min(-r * mu) } else { 0.0 };
            (r * r + 2.0 * r * mu * lowest + lowest * lowest).sqrt() - air.ground
        };
        if end >= 0.0 {
            points.push([height, mu, distance]);
        }
    }
    let call = format!("air_path_between({shells}, AirPlace(h, mu), d)");
    let got = values(&call, &scope, ["h", "mu", "d"], &points);
    let names = ["molecules", "aerosols", "ozone"];
    let mut worst = [0.0_f64; 3];
    for (point, v) in points.iter().zip(&got) {
        let [height, mu, distance] = point.map(f64::from);
        let from = [0.0, air.ground + height, 0.0];
        let exact = air.path(from, [(1.0 - mu * mu).sqrt(), mu, 0.0], distance);
        for kind in 0..3 {
            // f32 holds a path of 300 km to .03 m, and a short one is the difference of several such numbers: a metre
            // of air is let pass, 4e-5 of optical depth at most.
            worst[kind] = worst[kind].max((v[kind] - exact[kind]).abs() / (exact[kind] + 1000.0));
        }
    }
    for kind in 0..3 {
        let what = format!("{}: off over (path + 1 km), 4,000 ways of 1 m to 1,000 km", names[kind]);
        report.at_most(&what, worst[kind], 1e-3);
    }
    report.finish();
}

/// An eye's height (m), the sun's and the view's zenith angles and the azimuth between them (degrees).
type Look = [f32; 4];

fn direction(zenith: f32, azimuth: f32) -> [f32; 3] {
    let (zenith, azimuth) = (f64::from(zenith).to_radians(), f64::from(azimuth).to_radians());
    [zenith.sin() * azimuth.cos(), zenith.cos(), zenith.sin() * azimuth.sin()].map(|x| x as f32)
}

/// Largest relative error of a channel over `looks`, which the GPU and the truth take in turn.
fn single_off(air: &Air, settings: &[&str], samples: usize, looks: &[Look], truths: &[[f64; 3]]) -> f64 {
    let preset = preset(settings, samples);
    let scope = Scope { includes: INCLUDES, preset: Some(&preset), ..Scope::default() };
    let points: Vec<[f32; 7]> = looks.iter().map(look).collect();
    let call = "atmosphere_radiance(h, vec3f(a, b, c), vec3f(d, e, f))";
    let got = values(call, &scope, ["h", "a", "b", "c", "d", "e", "f"], &points);
    let floor = 1e-7 * air.rayleigh[1].max(air.mie) / 1e-5; // of light that nobody sees
    got.iter().zip(truths).map(|(v, exact)| relative(v, *exact, floor)).fold(0.0, f64::max)
}

fn look(look: &Look) -> [f32; 7] {
    let [height, sun_zenith, view_zenith, azimuth] = *look;
    let (view, sun) = (direction(view_zenith, azimuth), direction(sun_zenith, 0.0));
    [height, view[0], view[1], view[2], sun[0], sun[1], sun[2]]
}

fn truths(air: &Air, looks: &[Look]) -> Vec<[f64; 3]> {
    let single = |at: &Look| {
        let [height, a, b, c, d, e, f] = look(at).map(f64::from);
        air.single(height, [a, b, c], [d, e, f], f64::INFINITY)
    };
    looks.iter().map(single).collect()
}

/// Views from the ground and from the air: up, level and down.
fn looks(count: usize, seed: u32, suns: [f32; 2]) -> Vec<Look> {
    const ZENITHS: [f32; 14] =
        [0.0, 15.0, 40.0, 60.0, 75.0, 83.0, 87.0, 89.0, 89.9, 90.1, 91.0, 94.0, 110.0, 180.0];
    let mut random = Random::new(seed);
    let mut look = |i: usize| {
        let height = [0.5, 100.0, 500.0, 2e3, 1e4][i % 5];
        let view = if i.is_multiple_of(2) { ZENITHS[(i / 5) % 14] } else { random.within(0.0, 100.0) };
        [height, random.within(suns[0], suns[1]), view, random.within(0.0, 180.0)]
    };
    (0..count).map(&mut look).collect()
}

#[test]
fn a_sky_by_day_needs_eight_samples() {
    let mut report = Report::new(SECTION, "a_sky_by_day_needs_eight_samples");
    let rows: Vec<Look> = RADIANCE.iter().map(|row| row.0).collect();
    let exact: Vec<[f64; 3]> = RADIANCE.iter().map(|row| row.1).collect();
    let (earth, _) = planet("Earth");
    let own = truths(&earth, &rows);
    let apart = own.iter().zip(&exact).map(|(a, b)| relative(a, *b, 0.0)).fold(0.0, f64::max);
    report.at_most("Earth: the truth off reference/atmosphere.json, relative", apart, 1e-4);
    for (samples, bound) in [(8, 0.01), (12, 0.005)] {
        let off = single_off(&earth, &[], samples, &rows, &exact);
        report.at_most(
            &format!("Earth: off reference/atmosphere.json at {samples} samples, relative"),
            off,
            bound,
        );
    }
    for name in ["Earth", "Mars"] {
        let (air, settings) = planet(name);
        let looks = looks(420, 41, [0.0, 87.0]);
        let exact = truths(&air, &looks);
        for (samples, bound) in [(4, f64::INFINITY), (6, f64::INFINITY), (8, 0.01), (12, 0.005)] {
            let off = single_off(&air, settings, samples, &looks, &exact);
            let what =
                format!("{name}: suns of 0 to 87°, from .5 m to 10 km, {samples} samples: off, relative");
            if bound.is_finite() { report.at_most(&what, off, bound) } else { report.told(&what, off) }
        }
    }
    report.finish();
}

#[test]
fn a_sky_at_twilight_needs_twelve_samples() {
    let mut report = Report::new(SECTION, "a_sky_at_twilight_needs_twelve_samples");
    for name in ["Earth", "Mars"] {
        let (air, settings) = planet(name);
        let looks = looks(420, 42, [88.0, 92.0]);
        let exact = truths(&air, &looks);
        for (samples, bound) in [(8, f64::INFINITY), (12, 0.03), (16, 0.03)] {
            let off = single_off(&air, settings, samples, &looks, &exact);
            let what =
                format!("{name}: suns of 88 to 92°, from .5 m to 10 km, {samples} samples: off, relative");
            if bound.is_finite() { report.at_most(&what, off, bound) } else { report.told(&what, off) }
        }
    }
    report.finish();
}

#[test]
fn a_planet_from_space_needs_sixteen_samples() {
    let mut report = Report::new(SECTION, "a_planet_from_space_needs_sixteen_samples");
    for name in ["Earth", "Mars"] {
        let (air, settings) = planet(name);
        let mut random = Random::new(43);
        let mut looks = Vec::new();
        for i in 0..360 {
            let height = [1.2e5, 3e5, 1e6, 2e7_f32][i % 4];
            let tangent = |low: f64| {
                let sine = (air.ground + low) / (air.ground + f64::from(height));
                180.0 - sine.asin().to_degrees() as f32
            };
            let view = match i % 3 {
                0 => random.within(tangent(0.9 * air.height), tangent(1e3)), // the limb
                1 => random.within(tangent(-2e3), tangent(-1e5)),            // the ground near it
                _ => random.within(tangent(-1e5), 180.0),
            };
            let sun = if i % 5 == 0 { random.within(80.0, 100.0) } else { random.within(0.0, 120.0) };
            looks.push([height, sun, view, random.within(0.0, 180.0)]);
        }
        let exact = truths(&air, &looks);
        for (samples, bound) in [(8, f64::INFINITY), (12, f64::INFINITY), (16, 0.02)] {
            let off = single_off(&air, settings, samples, &looks, &exact);
            let what = format!(
                "{name}: limb, ground and terminator from 120 km up, {samples} samples: off, relative"
            );
            if bound.is_finite() { report.at_most(&what, off, bound) } else { report.told(&what, off) }
        }
    }
    report.finish();
}

#[test]
fn aerial_perspective_holds_at_every_distance() {
    let mut report = Report::new(SECTION, "aerial_perspective_holds_at_every_distance");
    let air = Air::earth();
    let mut random = Random::new(44);
    let (mut light, mut left): (f64, f64) = (0.0, 0.0);
    let mut metre: f64 = 0.0;
    for elevation in [60.0, 20.0, 3.0_f32] {
        let mut preset = preset(&["sun.irradiance=1", "sun.color=[1,1,1]", "sun.azimuth=90"], 8);
        preset.set(&format!("sun.elevation={elevation}")).unwrap();
        let scope = Scope { includes: INCLUDES, preset: Some(&preset), ..Scope::default() };
        let mut points: Vec<[f32; 5]> = Vec::new();
        while points.len() < 120 {
            let height = [2.0, 300.0, 1500.0, 10e3][points.len() % 4];
            let distance =
                if points.len().is_multiple_of(6) { 1.0 } else { 10_f32.powf(random.within(2.0, 5.3)) };
            let view = direction(random.within(75.0, 105.0), random.within(0.0, 360.0));
            let r = air.ground + f64::from(height);
            let (mu, t) = (f64::from(view[1]), f64::from(distance));
            if (r * r + 2.0 * r * mu * t + t * t).sqrt() > air.ground + 1.0 {
                points.push([height, view[0], view[1], view[2], distance]);
            }
        }
        let columns = ["h", "a", "b", "c", "d"];
        let call = |what: &str| {
            let call = format!("atmosphere_air(vec3f(0.0, h, 0.0), vec3f(a, b, c), d).{what}");
            values(&call, &scope, columns, &points)
        };
        let (lights, lefts) = (call("from_sun"), call("transmittance"));
        let sun = direction(90.0 - elevation, 0.0).map(f64::from);
        for (point, (from_sun, transmittance)) in points.iter().zip(lights.iter().zip(&lefts)) {
            let [height, a, b, c, distance] = point.map(f64::from);
            let exact = air.single(height, [a, b, c], sun, distance);
            let path = air.path([0.0, air.ground + height, 0.0], [a, b, c], distance);
            left = left.max(relative(transmittance, air.dimmed(path), 1e-5));
            if distance == 1.0 {
                metre = metre.max(relative(from_sun, exact, 0.0));
            } else {
                light = light.max(relative(from_sun, exact, 1e-6));
            }
        }
    }
    report.at_most("100 m to 200 km, sun 3 to 60° high: light off, relative", light, 0.01);
    report.at_most("one metre: light off, relative", metre, 0.001);
    report.at_most("transmittance off, relative", left, 0.003);
    report.finish();
}

#[test]
fn the_sky_has_no_seams() {
    let mut report = Report::new(SECTION, "the_sky_has_no_seams");
    let preset = preset(&[], 8);
    let scope = Scope { includes: INCLUDES, preset: Some(&preset), ..Scope::default() };
    for (height, sun) in [(2.0, 60.0), (1e4, 80.0), (1e4, 91.0), (200.0, 91.5), (3e5, 70.0_f32)] {
        // From well above the horizon to well below it, in steps of a 250th of a degree, and through the zenith.
        let dip = (6.36e6 / (6.36e6 + f64::from(height))).acos().to_degrees() as f32;
        let mut worst: f64 = 0.0;
        for (first, step) in [(90.0 + dip - 2.8, 0.004), (-5.0, 0.01_f32)] {
            let views: Vec<[f32; 7]> =
                (0..1400).map(|i| look(&[height, sun, first + step * i as f32, 40.0])).collect();
            let call = "atmosphere_radiance(h, vec3f(a, b, c), vec3f(d, e, f))";
            let got = values(call, &scope, ["h", "a", "b", "c", "d", "e", "f"], &views);
            for (i, three) in got.windows(4).enumerate() {
                // The horizon itself is an edge, and just below it the ground comes near fast.
                let angle = first + step * (i as f32 + 1.5);
                if (angle - 90.0 - dip).abs() < 0.1 {
                    continue;
                }
                for c in 0..3 {
                    // The third difference over the value: 0 for what is smooth.
                    let jump = three[3][c] - 3.0 * three[2][c] + 3.0 * three[1][c] - three[0][c];
                    let size = three.iter().map(|v| v[c].abs()).fold(1e-4, f64::max);
                    worst = worst.max(jump.abs() / size);
                }
            }
        }
        report.at_most(
            &format!("eye at {height} m, sun {sun}° from the zenith: greatest jump"),
            worst,
            0.004,
        );
    }
    report.finish();
}

#[test]
fn air_of_a_flat_world_is_that_of_the_integral() {
    let mut report = Report::new(SECTION, "air_of_a_flat_world_is_that_of_the_integral");
    let scope = Scope { includes: &["<sky/planar.wgsl>"], ..Scope::default() };
    let mut random = Random::new(45);
    let mut points: Vec<[f32; 3]> = Vec::new();
    while points.len() < 3000 {
        let (height, climb) = (10_f32.powf(random.within(0.0, 4.8)), random.within(-1.0, 1.0).powi(3));
        let distance = 10_f32.powf(random.within(1.0, 5.5));
        if (0.0..80e3).contains(&(height + climb * distance)) {
            points.push([height, climb, distance]);
        }
    }
    let got = values("planar_depth(y, c, d)", &scope, ["y", "c", "d"], &points);
    let air = Air::earth();
    let mut off: f64 = 0.0;
    for (point, v) in points.iter().zip(&got) {
        let [height, climb, distance] = point.map(f64::from);
        let mut path = [0.0; 3];
        let steps = 4000;
        for i in 0..steps {
            let y = height + climb * distance * (f64::from(i) + 0.5) / f64::from(steps);
            for (sum, scale) in path.iter_mut().zip([8e3, 1.2e3]) {
                *sum += distance / f64::from(steps) * (-y / scale).exp() * (80e3 - y) / 80e3;
            }
        }
        let exact = air.dimmed(path);
        off = off.max(relative(&[0, 1, 2].map(|c| (-v[c]).exp()), exact, 1e-6));
    }
    report.at_most("transmittance of 3,000 ways off, relative", off, 0.003);
    report.finish();
}

#[test]
fn air_is_light_from_everywhere() {
    let mut report = Report::new(SECTION, "air_is_light_from_everywhere");
    let mut random = Random::new(46);
    let mut points: Vec<[f32; 7]> = Vec::new();
    for i in 0..3000 {
        let reach = 10_f32.powf(random.within(-1.0, 7.5));
        let mut from: [f32; 3] = random.point(reach);
        match i % 4 {
            0 => from = [0.0, [-12e3, -1.0, 0.0, 2.0, 1e5, 100_000.1, 2e7][i / 4 % 7], 0.0],
            1 => from[1] = from[1].abs(),
            _ => {}
        }
        let aim: [f32; 3] = random.point(1.0);
        let sun = [0.866_025_4, 0.5, 0.0_f32];
        let aim = match i / 3 % 7 {
            0 => [0.0, 1.0, 0.0],
            1 => [0.0, -1.0, 0.0],
            2 => [1.0, 0.0, 0.0],
            3 => sun,
            4 => sun.map(|x| -x),
            _ => aim,
        };
        let distance = [1e30, 1e30, 0.0, 1e-3, 1.0, 1e4, 1e6, 1e8][i % 8];
        points.push([from[0], from[1], from[2], aim[0], aim[1], aim[2], distance]);
    }
    for model in ["atmosphere", "planar"] {
        for elevation in [90.0, 30.0, 0.0, -0.5, -12.0, -90.0] {
            let mut preset = Preset::of_text("none", "");
            preset.set(&format!("sky.model={model}")).unwrap();
            preset.set(&format!("sun.elevation={elevation}")).unwrap();
            preset.set("sun.azimuth=90").unwrap();
            let scope = Scope {
                includes: &["<sky/sky.wgsl>"],
                fragment: "#include <sky/sky.wgsl>\nfn seen(o: vec3f, d: vec3f, t: f32) -> array<vec3f, 3> {\n    \
                    let air = sky_air(o, normalize(d), t);\n    let day = sky_daylight(o);\n    \
                    return array<vec3f, 3>(air.from_sun + air.from_sky, air.transmittance, day.sun + day.sky);\n}\n",
                preset: Some(&preset),
            };
            let mut wrong = 0;
            let columns = ["a", "b", "c", "d", "e", "f", "t"];
            for part in 0..3 {
                let call = format!("seen(vec3f(a, b, c), vec3f(d, e, f), t)[{part}]");
                let most = if part == 1 { 1.000_001 } else { 20.0 };
                let got = values(&call, &scope, columns, &points);
                wrong += got.iter().filter(|v| v.iter().any(|x| !(0.0..=most).contains(x))).count();
            }
            let what = format!("{model}, sun at {elevation}°: rays of 3,000 that see what is no light");
            report.at_most(&what, wrong as f64, 0.0);
        }
    }
    report.finish();
}

/// Largest error of a channel, over its value or over `floor`, whichever is larger.
fn relative(got: &[f64], exact: [f64; 3], floor: f64) -> f64 {
    (0..3)
        .map(|c| (got[c] - exact[c]).abs() / exact[c].abs().max(floor))
        .fold(0.0, |a, b| if b.is_nan() { b } else { a.max(b) })
}
