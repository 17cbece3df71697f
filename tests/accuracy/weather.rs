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
