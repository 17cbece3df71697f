//! Weather as scenes see it: through `clouds_trace` and `weather_air`, with the layer's own light.

use orogen::Preset;
use truth::points::Random;

use crate::harness::{Report, Scope, value, values};

const SECTION: &str = "Weather";

fn preset(settings: &[&str]) -> Preset {
    let mut preset = Preset::of_module("scene/sky.wgsl");
    for setting in settings {
        preset.set(setting).unwrap();
    }
    preset
}

#[test]
fn clouds_vanish_in_a_white_furnace() {
    let fragment = "
        #include <scene/weather.wgsl>
        fn furnace(height: f32, turn: f32, rise: f32, jitter: f32) -> f32 {
            let day = Daylight(vec3f(0.0, 0.7071, 0.7071), 0.005, vec3f(0.0), vec3f(3.14159265));
            let toward = vec3f(cos(rise) * sin(turn), sin(rise), -cos(rise) * cos(turn));
            let seen = clouds_trace(vec3f(100.0 * turn, height, 0.0), toward, 0.0, 1e30, jitter, 0.001, day);
            return seen.radiance.x + seen.transmittance;
        }";
    let mut report = Report::new(SECTION, "clouds_vanish_in_a_white_furnace");
    let mut random = Random::new(5);
    for form in ["weather", "plain", "boxed"] {
        let form_set = format!("clouds.form={form}");
        let preset = preset(&[
            "weather.clouds=true",
            &form_set,
            "clouds.ground=[1,1,1]",
            "clouds.albedo=1",
            "clouds.coverage=0.6",
        ]);
        let scope = Scope { fragment, preset: Some(&preset), ..Scope::default() };
        let points: Vec<[f32; 4]> = (0..600)
            .map(|_| {
                let height = [100.0, 1900.0, 5000.0][random.bits() as usize % 3];
                [height, random.within(-3.1, 3.1), random.within(-1.5, 1.5), random.within(0.0, 1.0)]
            })
            .collect();
        let seen = values("furnace(h, a, e, j)", &scope, ["h", "a", "e", "j"], &points);
        let (least, most) = seen
            .iter()
            .fold((f64::MAX, f64::MIN), |(least, most), row| (least.min(row[0]), most.max(row[0])));
        report.at_most(
            &format!("`{form}`: most of what is seen, of a radiance of 1 all around"),
            most,
            1.001,
        );
        report.at_least(&format!("`{form}`: least"), least, 0.99);
    }
    report.finish();
}

#[test]
fn clouds_are_dark_where_it_is_night() {
    // From 1,000 km above a place where the sun stands `elevation` (rad) over the horizon, straight down.
    let fragment = "
        #include <scene/weather.wgsl>
        fn from_space(elevation: f32) -> vec3f {
            let to_sun = sun_direction();
            let beside = normalize(cross(to_sun, vec3f(1.0, 0.0, 0.0)));
            let up = sin(elevation) * to_sun + cos(elevation) * beside;
            let eye = up * (sky.ground_radius + 1e6) - vec3f(0.0, sky.ground_radius, 0.0);
            let air = weather_air(eye, -up, RAY_FAR, 0.5, weather_daylight(eye));
            return air.from_sun + air.from_sky;
        }";
    let preset = preset(&[
        "weather.clouds=true",
        "sky.model=atmosphere",
        "clouds.shape=shell",
        "clouds.coverage=1",
        "clouds.scale=20000",
        "sun.color=[1,1,1]",
        "sun.elevation=30",
        "sun.azimuth=0",
    ]);
    let scope = Scope { fragment, preset: Some(&preset), ..Scope::default() };
    let mut report = Report::new(SECTION, "clouds_are_dark_where_it_is_night");
    let elevations = [60.0_f32, 10.0, -12.0, -30.0].map(|degrees| [degrees.to_radians()]);
    let seen = values("from_space(e)", &scope, ["e"], &elevations);
    let green: Vec<f64> = seen.iter().map(|row| row[1]).collect();
    report.at_least(
        "radiance under a sun at 60°, of an irradiance of pi",
        green[0] * std::f64::consts::PI / 4.0,
        0.3,
    );
    report.at_most("sun 10° high, over that", green[1] / green[0], 0.6);
    report.at_most("sun 12° below the horizon, over that", green[2] / green[0], 0.01);
    report.at_most("sun 30° below, over that", green[3] / green[0], 0.001);
    report.finish();
}

#[test]
fn a_layer_above_darkens_the_layer_below() {
    let fragment = "
        #include <scene/weather.wgsl>
        fn bases() -> f32 {
            let eye = vec3f(0.0, 2.0, 0.0);
            let air = weather_air(eye, vec3f(0.0, 1.0, 0.0), RAY_FAR, 0.5, weather_daylight(eye));
            return air.from_sky.y;
        }
        fn ground() -> f32 {
            return weather_daylight(vec3f(0.0)).sky.y;
        }";
    let mut report = Report::new(SECTION, "a_layer_above_darkens_the_layer_below");
    let both = |second: &str| {
        let preset = preset(&[
            "weather.clouds=true",
            second,
            "clouds.form=plain",
            "clouds.coverage=1",
            "cirrus.form=plain",
            "cirrus.base=6000",
            "cirrus.coverage=1",
        ]);
        let scope = Scope { fragment, preset: Some(&preset), ..Scope::default() };
        (value("bases()", &scope)[0], value("ground()", &scope)[0])
    };
    let (alone, under) = (both("weather.second_layer=false"), both("weather.second_layer=true"));
    report.at_most(
        "the lower layer's base under a closed upper one, over that without",
        under.0 / alone.0,
        0.7,
    );
    report.at_most("level ground under both, over that under the lower one", under.1 / alone.1, 0.9);
    report.finish();
}

/// Root mean square difference of two tables' first columns.
fn apart(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    (a.iter().zip(b).map(|(a, b)| (a[0] - b[0]).powi(2)).sum::<f64>() / a.len() as f64).sqrt()
}

#[test]
fn clouds_seen_from_orbit_drift_and_evolve() {
    let mut report = Report::new(SECTION, "clouds_seen_from_orbit_drift_and_evolve");
    let mut random = Random::new(31);
    let points: Vec<[f32; 3]> = (0..20_000)
        .map(|_| {
            let up: f32 = random.within(-1.0, 1.0);
            let (sine, cosine) = random.within(-3.15, 3.15).sin_cos();
            [(1.0 - up * up).sqrt() * cosine, up, (1.0 - up * up).sqrt() * sine]
        })
        .collect();
    let seen = |call: &str, settings: &[&str]| {
        let preset = preset(settings);
        let scope = Scope { includes: &["<planet/clouds.wgsl>"], preset: Some(&preset), ..Scope::default() };
        values(call, &scope, ["x", "y", "z"], &points)
    };
    let here = "shell_at(p, 1e-3)";
    let start = seen(here, &[]);
    let windless = seen(here, &["shell.wind_speed=0", "shell.evolution=0"]);
    report.at_most("at time 0 wind and evolution make no difference", apart(&start, &windless), 0.0);
    let still = seen(here, &["shell.wind_speed=0", "shell.evolution=0", "frame.time=1e6"]);
    report.at_most("nor do they, both 0, at any time", apart(&start, &still), 0.0);
    // 20 m/s for 50,000 s over the equator: 1,000 km to the east.
    let wind = ["shell.wind_speed=20", "shell.evolution=0", "frame.time=50000"];
    let downwind =
        seen("shell_at(turned_about(p, vec3f(0.0, 1.0, 0.0), 1e6 / sky.ground_radius), 1e-3)", &wind);
    report.at_most(
        "1,000 km downwind after 50,000 s at 20 m/s: rms difference",
        apart(&start, &downwind),
        2e-3,
    );
    report.at_least("in one place: rms difference", apart(&start, &seen(here, &wind)), 0.1);
    let day = ["shell.wind_speed=0", "frame.time=86400"];
    let hour = ["shell.wind_speed=0", "frame.time=3600"];
    let after_hour = apart(&start, &seen(here, &hour));
    report.at_most("without wind, after an hour: rms difference", after_hour, 0.15);
    report.at_least(
        "after a day: rms difference over that",
        apart(&start, &seen(here, &day)) / after_hour,
        1.5,
    );
    report.finish();
}

#[test]
fn painted_cirrus_drifts_and_evolves() {
    let fragment = "
        #include <scene/weather.wgsl>
        fn cirrus_seen(x: f32, z: f32) -> f32 {
            let day = Daylight(vec3f(0.0, 0.7071, 0.7071), 0.005, vec3f(0.0), vec3f(4.0));
            let behind = SkyAir(vec3f(0.0), vec3f(0.0), vec3f(1.0));
            return cirrus_in(behind, vec3f(x, 0.0, z), vec3f(0.0, 1.0, 0.0), day).from_sky.x;
        }";
    let mut report = Report::new(SECTION, "painted_cirrus_drifts_and_evolves");
    let points: Vec<[f32; 2]> = Random::new(33).points(10_000, 40_000.0);
    let seen = |call: &str, settings: &[&str]| {
        let mut preset = preset(&["weather.cirrus=true", "sky.cirrus_cover=0.6", "sky.cirrus_heading=90"]);
        for setting in settings {
            preset.set(setting).unwrap();
        }
        values(call, &Scope { fragment, preset: Some(&preset), ..Scope::default() }, ["x", "z"], &points)
    };
    let start = seen("cirrus_seen(x, z)", &[]);
    let mean = start.iter().map(|row| row[0]).sum::<f64>() / start.len() as f64;
    let windless = seen("cirrus_seen(x, z)", &["sky.cirrus_speed=0", "frame.time=5000"]);
    report.at_least("mean light of the cirrus", mean, 0.05);
    report.at_most("at time 0 the wind makes no difference", apart(&start, &windless), 0.0);
    let wind = ["sky.cirrus_speed=25", "frame.time=40"];
    report.at_least(
        "in one place, after 40 s at 25 m/s: rms difference, over the mean",
        apart(&start, &seen("cirrus_seen(x, z)", &wind)) / mean,
        0.1,
    );
    let downwind = apart(&start, &seen("cirrus_seen(x + 1000.0, z)", &wind)) / mean;
    report.at_most("1 km downwind: the same", downwind, 0.12);
    let later = ["sky.cirrus_speed=25", "frame.time=1600"];
    let evolved = apart(&start, &seen("cirrus_seen(x + 40000.0, z)", &later)) / mean;
    report.at_least("40 km downwind, after 1,600 s: the same, over that", evolved / downwind, 2.0);
    report.finish();
}
