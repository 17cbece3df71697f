//! Water: reflectance, transmittance, waves, waterline.

use orogen::Preset;
use truth::geometry::{along, distance, length, unit};
use truth::light as exact;
use truth::points::Random;

use crate::harness::{Report, Scope, value, values};
use crate::light::FRESNEL;

const SECTION: &str = "Water";

fn preset(settings: &[&str]) -> Preset {
    let mut preset = Preset::of_text("none", "");
    for setting in settings {
        preset.set(setting).unwrap();
    }
    preset
}

const MIRROR: &str = "
    #include <sky/sky.wgsl>
    #include <water/surface.wgsl>
    fn looked_at(elevation: f32, variance: f32, east: f32, south: f32) -> vec4f {
        let direction = vec3f(cos(elevation), -sin(elevation), 0.0);
        let mirror = water_mirror(direction, Waves(0.0, vec2f(east, south), variance, 0.0), sky_daylight(vec3f(0.0)), 1.0);
        return vec4f(mirror.direction, mirror.reflectance);
    }";

#[test]
fn water_reflects_as_fresnel_says() {
    let scope = Scope { fragment: MIRROR, ..Scope::default() };
    let mut report = Report::new(SECTION, "water_reflects_as_fresnel_says");
    let rows: Vec<[f32; 4]> =
        FRESNEL.iter().map(|row| [(90.0 - row.0).to_radians() as f32, 0.0, 0.0, 0.0]).collect();
    let got = values("looked_at(e, v, x, z)", &scope, ["e", "v", "x", "z"], &rows);
    let off = FRESNEL.iter().zip(&got).map(|(row, v)| (row.1 - v[3]).abs()).fold(0.0, f64::max);
    report.at_most("smooth water: off reference/fresnel.json", off, 1e-5);

    // Rough water: one facet stands for all; how far is its reflectance from the mean over all that are seen?
    for deviation in [0.02_f32, 0.05, 0.1, 0.2] {
        let rows: Vec<[f32; 4]> =
            (1..=90).map(|d| [(d as f32).to_radians(), deviation * deviation, 0.0, 0.0]).collect();
        let got = values("looked_at(e, v, x, z)", &scope, ["e", "v", "x", "z"], &rows);
        let (mut off, mut smooth) = (0.0_f64, 0.0_f64);
        for (row, v) in rows.iter().zip(&got) {
            let elevation = f64::from(row[0]);
            let truth = exact::facets(elevation.tan(), f64::from(deviation)).reflectance;
            off = off.max((v[3] - truth).abs());
            let level = exact::fresnel(std::f64::consts::FRAC_PI_2 - elevation, 1.333);
            smooth = smooth.max((level - truth).abs());
        }
        report.at_most(
            &format!("slopes of {deviation}: off the mean over all facets seen, 1° to 90°"),
            off,
            0.08,
        );
        report.told(&format!("slopes of {deviation}: what smooth water would be off"), smooth);
    }
    report.finish();
}

#[test]
fn water_mirrors_nothing_below_the_horizon() {
    let mut random = Random::new(31);
    let mut rows: Vec<[f32; 4]> = (0..50_000)
        .map(|_| {
            let roughness = random.within(0.0, 0.3);
            [
                random.within(0.0, 1.57),
                roughness * roughness,
                random.within(-1.0, 1.0),
                random.within(-1.0, 1.0),
            ]
        })
        .collect();
    rows.extend([
        [0.0, 0.0, 0.0, 0.0],
        [std::f32::consts::FRAC_PI_2, 0.0, 0.0, 0.0],
        [0.0, 0.1, 5.0, -5.0],
        [1e-6, 1e-9, -20.0, 0.0],
    ]);
    let scope = Scope { fragment: MIRROR, ..Scope::default() };
    let got = values("looked_at(e, v, x, z)", &scope, ["e", "v", "x", "z"], &rows);
    let bad = got.iter().flatten().filter(|v| !v.is_finite()).count();
    let lowest = got.iter().map(|v| v[1]).fold(1.0, f64::min);
    let stretched = got.iter().map(|v| (length([v[0], v[1], v[2]]) - 1.0).abs()).fold(0.0, f64::max);
    let most = got.iter().map(|v| v[3]).fold(0.0, f64::max);
    let mut report = Report::new(SECTION, "water_mirrors_nothing_below_the_horizon");
    report.at_most("NaN or infinite, of 50,000 views of waves as steep as 1", bad as f64, 0.0);
    report.at_least("upward part of the direction mirrored: least", lowest, 1e-4);
    report.at_most("its length off 1", stretched, 1e-6);
    report.at_most("largest reflectance", most, 1.0);
    report.finish();
}

#[test]
fn light_fades_in_water_exponentially() {
    let preset = preset(&["water.absorption=[0.5, 0.17, 0.02]"]);
    let scope = Scope { includes: &["<water/optics.wgsl>"], preset: Some(&preset), ..Scope::default() };
    let paths: Vec<[f32; 1]> = (0..20_000).map(|i| [i as f32 * 0.005]).collect();
    let got = values("water_transmittance(l)", &scope, ["l"], &paths);
    let mut off: f64 = 0.0;
    for (path, v) in paths.iter().zip(&got) {
        for (channel, k) in [0.5_f32, 0.17, 0.02].into_iter().enumerate() {
            let truth = (-f64::from(k) * f64::from(path[0])).exp();
            off = off.max((v[channel] - truth).abs());
        }
    }
    let mut report = Report::new(SECTION, "light_fades_in_water_exponentially");
    report.at_most("transmittance over 0 .. 100 m: off exp(-k l)", off, 1e-6);

    let angles: Vec<[f32; 1]> = (0..=900).map(|i| [(f64::from(i) * 0.1).to_radians() as f32]).collect();
    let got = values("water_refracted_down(vec3f(sin(a), -cos(a), 0.0))", &scope, ["a"], &angles);
    let snell = angles.iter().zip(&got).map(|(a, v)| {
        let truth = f64::from(a[0]).sin() / f64::from(1.333_f32);
        distance([v[0], v[1], v[2]], [truth, -(1.0 - truth * truth).sqrt(), 0.0])
    });
    report.at_most("refracted direction: off Snell's law", snell.fold(0.0, f64::max), 1e-6);
    report.finish();
}

const GERSTNER: [&str; 5] =
    ["water.wave_length=60", "water.slope=0.3", "water.chop=1", "water.swell_depth=8", "frame.time=7.5"];

#[test]
fn gerstner_waves_run_and_do_not_fold() {
    let preset = preset(&GERSTNER);
    let scope = Scope { includes: &["<water/gerstner.wgsl>"], preset: Some(&preset), ..Scope::default() };
    let mut report = Report::new(SECTION, "gerstner_waves_run_and_do_not_fold");
    let numbers: Vec<[f32; 2]> = (0..2_000)
        .map(|i| [(f64::from(i) * 0.005 - 5.0).exp2() as f32, 0.1 + 0.05 * (i % 400) as f32])
        .collect();
    let got = values("gerstner_pulsation(k, depth)", &scope, ["k", "depth"], &numbers);
    let off = numbers.iter().zip(&got).map(|(row, v)| {
        let (k, depth) = (f64::from(row[0]), f64::from(row[1]));
        v[0] * v[0] / (9.81 * k * (k * depth).tanh()) - 1.0
    });
    report.at_most("ω² off g k tanh(k depth), relative", off.map(f64::abs).fold(0.0, f64::max), 5e-6);

    let waves: Vec<[f32; 1]> = (0..24).map(|i| [i as f32]).collect();
    let got = values("gerstner_wave(i)", &scope, ["i:i32"], &waves);
    let width = value("gerstner_width()", &scope)[0];
    let sum: f64 = got.iter().map(|wave| width * wave[2] * wave[3]).sum();
    report.at_most("Σ Q k a at chop 1", sum, 1.0 + 1e-6);
    report.at_least("Σ Q k a at chop 1: as sharp as can be", sum, 0.999);
    let reach = value("gerstner_reach()", &scope)[0];
    let heights: f64 = got.iter().map(|wave| wave[3]).sum();
    report.at_most("sum of the amplitudes over the height that is said to bound it", heights / reach, 1.0);
    let squares: f64 = got.iter().map(|wave| 0.5 * (wave[2] * wave[3]).powi(2)).sum();
    report.near(
        "root mean square slope of all waves (set: .3, half of its square theirs)",
        squares.sqrt(),
        0.212_132,
        1e-4,
    );

    // Jacobian of the way from rest to place: positive everywhere is no fold anywhere.
    let points: Vec<[f32; 2]> = Random::new(32).points(100_000, 500.0);
    let area = values(
        "cross(gerstner_point(p, 0.0).southward, gerstner_point(p, 0.0).eastward).y",
        &scope,
        ["x", "y"],
        &points,
    );
    report.at_least(
        "least area over area at rest, 100,000 points",
        area.iter().map(|v| v[0]).fold(9.0, f64::min),
        0.0,
    );
    report.finish();
}

#[test]
fn gerstner_normals_are_the_surface_s() {
    let preset = preset(&GERSTNER);
    let scope = Scope { includes: &["<water/gerstner.wgsl>"], preset: Some(&preset), ..Scope::default() };
    let rest: Vec<[f32; 2]> = Random::new(33).points(5_000, 60.0);
    // The surface again, in f64, of the waves that the GPU has.
    let waves: Vec<[f32; 1]> = (0..24).map(|i| [i as f32]).collect();
    let waves = values("gerstner_wave(i)", &scope, ["i:i32"], &waves);
    let width = value("gerstner_width()", &scope)[0];
    let surface = |x: f64, z: f64| {
        waves.iter().fold([x, 0.0, z], |p, w| {
            let angle = w[2] * (w[0] * x + w[1] * z) - w[4] * 7.5 + w[5];
            let turned = [width * w[0] * angle.cos(), angle.sin(), width * w[1] * angle.cos()];
            along(p, w[3], turned)
        })
    };
    let got = values("gerstner_point(p, 0.0)", &scope, ["x", "y"], &rest);
    let (mut place, mut tilt) = (0.0_f64, 0.0_f64);
    for (p, v) in rest.iter().zip(&got) {
        let (x, z) = (f64::from(p[0]), f64::from(p[1]));
        place = place.max(distance(surface(x, z), [x + v[0], v[1], z + v[2]]));
        let e = 1e-4;
        let east = along(surface(x + e, z), -1.0, surface(x - e, z));
        let south = along(surface(x, z + e), -1.0, surface(x, z - e));
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let truth = unit(cross(south, east));
        let own = unit(cross([v[6], v[7], v[8]], [v[3], v[4], v[5]]));
        tilt = tilt.max(distance(truth, own));
    }
    let mut report = Report::new(SECTION, "gerstner_normals_are_the_surface_s");
    report.at_most("Gerstner's surface: off f64 (m; waves of 60 m)", place, 1e-5);
    report.at_most("normal: off the central difference of the displaced surface", tilt, 1e-5);

    let preset =
        self::preset(&["water.wave_length=60", "water.slope=0.15", "water.chop=0.8", "frame.time=7.5"]);
    let scope = Scope { includes: &["<water/gerstner.wgsl>"], preset: Some(&preset), ..Scope::default() };
    let fragment = "
        #include <water/gerstner.wgsl>
        fn missed(p: vec2f) -> vec2f {
            let seen = gerstner_at(p, 0.0);
            let back = gerstner_point(p - seen.offset.xz, 0.0).offset;
            return vec2f(length(back.xz - seen.offset.xz), abs(back.y - seen.offset.y));
        }";
    let got = values("missed(p)", &Scope { fragment, includes: &[], ..scope }, ["x", "y"], &rest);
    report.at_most(
        "point found above a place: how far from above it (m)",
        got.iter().map(|v| v[0]).fold(0.0, f64::max),
        0.01,
    );
    report.finish();
}

#[test]
fn ripples_have_the_slope_that_was_asked_for() {
    let preset = preset(&["water.lanes=0"]);
    let scope = Scope { includes: &["<water/ripples.wgsl>"], preset: Some(&preset), ..Scope::default() };
    let points: Vec<[f32; 2]> = Random::new(34).points(40_000, 400.0);
    let mut report = Report::new(SECTION, "ripples_have_the_slope_that_was_asked_for");
    for footprint in ["0.0", "0.05", "0.2", "0.7", "10.0"] {
        let got = values(&format!("ripples(p, {footprint}, 2.0, 0.1)"), &scope, ["x", "y"], &points);
        let squares: f64 = got.iter().map(|v| v[1] * v[1] + v[2] * v[2] + 2.0 * v[3]).sum();
        let name = format!("rms slope, seen and not, pixel of {footprint} m (set: .1)");
        report.near(&name, (squares / points.len() as f64).sqrt(), 0.1, 2e-3);
    }
    report.finish();
}

#[test]
fn the_waterline_has_no_step() {
    let preset = preset(&["water.waves=noise", "water.slope=0.05", "water.foam=1", "water.lanes=0.5"]);
    // What is seen, with a mirrored radiance of 1, as the ground goes down by a tenth a metre.
    let fragment = "
        #include <sky/sky.wgsl>
        #include <water/shade.wgsl>
        fn shore(depth: f32, elevation: f32, footprint: f32) -> vec3f {
            let direction = vec3f(cos(elevation), -sin(elevation), 0.0);
            let place = vec3f(3.0 + depth, 0.0, 7.0);
            let seen = water_seen_from_above(
                place, direction, footprint, vec3f(0.3, 0.25, 0.2), depth, 1.1 * depth, water_edge(footprint, 0.1), sky_daylight(place), 1.0,
            );
            return seen.own + seen.passed;
        }";
    let scope = Scope { fragment, preset: Some(&preset), ..Scope::default() };
    let mut report = Report::new(SECTION, "the_waterline_has_no_step");
    let bed = [0.3_f32, 0.25, 0.2].map(f64::from);
    let (mut step, mut steepest) = (0.0_f64, [0.0_f64; 2]);
    for elevation in [0.02_f32, 0.2, 1.0] {
        for footprint in [0.01_f32, 1.0] {
            let at = |depth: f32| [depth, elevation, footprint];
            let columns = ["depth", "elevation", "footprint"];
            let edge = values("shore(depth, elevation, footprint)", &scope, columns, &[at(0.0), at(1e-5)]);
            for i in 0..3 {
                step = step.max((edge[0][i] - bed[i]).abs()).max((edge[1][i] - bed[i]).abs());
            }
            // A curve that is continuous halves its steps with its spacing; one with a jump does not.
            for (kind, spacing) in [(0, 4e-4_f32), (1, 1e-4)] {
                let count = (0.4 / spacing) as i32;
                let rows: Vec<[f32; 3]> = (0..count).map(|i| at(i as f32 * spacing)).collect();
                let got = values("shore(depth, elevation, footprint)", &scope, columns, &rows);
                let jumps = got.windows(2).flat_map(|pair| (0..3).map(|i| (pair[1][i] - pair[0][i]).abs()));
                steepest[kind] = jumps.fold(steepest[kind], f64::max);
            }
        }
    }
    report.at_most("at depth 0 and .01 mm: off the dry ground", step, 1e-4);
    report.told("largest change of radiance from depth to depth, .4 mm apart", steepest[0]);
    report.at_most(
        "the same .1 mm apart, over that: a quarter, as for every smooth curve",
        steepest[1] / steepest[0],
        0.3,
    );
    report.finish();
}

#[test]
fn from_below_water_shows_a_window() {
    let preset = preset(&["water.waves=none", "water.absorption=[0, 0, 0]"]);
    let fragment = "
        #include <sky/sky.wgsl>
        #include <water/shade.wgsl>
        fn window(zenith: f32) -> vec4f {
            let direction = vec3f(sin(zenith), cos(zenith), 0.0);
            let seen = water_seen_from_below(vec3f(0.0), direction, 5.0, -5.0, sky_daylight(vec3f(0.0)));
            return vec4f(seen.direction, seen.passed.x);
        }";
    let scope = Scope { fragment, preset: Some(&preset), ..Scope::default() };
    let angles: Vec<[f32; 1]> = (0..900).map(|i| [(f64::from(i) * 0.1).to_radians() as f32]).collect();
    let got = values("window(a)", &scope, ["a"], &angles);
    let (mut inside, mut outside) = (0.0_f64, 0.0_f64);
    for (a, v) in angles.iter().zip(&got) {
        let sine = 1.333 * f64::from(a[0]).sin();
        if sine < 0.99 {
            let truth = 1.0 - exact::fresnel(f64::from(a[0]), 1.0 / 1.333);
            inside = inside.max((v[3] - truth).abs()).max((v[0] - sine).abs());
        } else if sine > 1.0 {
            outside = outside.max(v[3]);
        }
    }
    let mut report = Report::new(SECTION, "from_below_water_shows_a_window");
    report.at_most("inside of Snell's window: transmittance and direction off", inside, 2e-5);
    report.at_most("outside of it: what comes through", outside, 0.0);
    report.finish();
}

#[test]
fn water_is_seen_from_a_hundred_kilometres() {
    let mut report = Report::new(SECTION, "water_is_seen_from_a_hundred_kilometres");
    let mut preset = Preset::of_module("scene/landscape.wgsl");
    for setting in ["landscape.water=true", "terrain.relief=fbm", "terrain.peak_height=60", "water.level=500"]
    {
        preset.set(setting).unwrap();
    }
    let scope = Scope { preset: Some(&preset), ..Scope::default() };
    let eyes: Vec<[f32; 1]> = [600.0, 5e3, 44e3, 50e3, 100e3].map(|y| [y]).into();
    let seen = values("scene_trace(vec3f(300.0, y, -200.0), vec3f(0.0, -1.0, 0.0))", &scope, ["y"], &eyes);
    let error =
        eyes.iter().zip(&seen).map(|([y], row)| (row[3] - f64::from(y - 500.0)).abs()).fold(0.0, f64::max);
    report.at_most("looking straight down on it from .1 to 100 km: error of the distance, m", error, 0.01);
    report.finish();
}
