//! What shines behind the air, and how light it is below: sun, moon, stars, twilight.

use std::f64::consts::{PI, TAU};

use orogen::Preset;
use truth::moon;
use truth::points::Random;
use truth::twilight;

use crate::harness::{Report, Scope, value, values};

fn preset<S: AsRef<str>>(settings: &[S]) -> Preset {
    let mut preset = Preset::of_text("none", "");
    for setting in settings {
        preset.set(setting.as_ref()).unwrap();
    }
    preset
}

fn greatest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(f64::NEG_INFINITY, |a, b| if b.is_nan() { b } else { a.max(b) })
}

// ---- discs ----

/// Light of a disc in all, over its irradiance as stated, in red, green and blue: summed over a fine grid of directions.
fn light_of_disc(disc: &str, middle: &str, light: &str, settings: &[&str]) -> Vec<f64> {
    let fragment = format!(
        "#include <math/rotation.wgsl>
        #include <sky/beyond.wgsl>
        const STEP: f32 = 2.4 / 500.0 * 0.0046; // a little more than the disc
        fn row_of_disc(row: f32) -> vec3f {{
            let middle = {middle};
            let right = normalize(cross(middle, vec3f(0.0, 1.0, 0.0)));
            let up = cross(right, middle);
            var sum = vec3f(0.0);
            for (var i = 0; i < 500; i++) {{
                let off = STEP * (right * (f32(i) - 249.5) + up * (row - 249.5));
                sum += {disc}(normalize(middle + off));
            }}
            return sum * STEP * STEP / {light};
        }}"
    );
    let preset = preset(settings);
    let scope = Scope { fragment: &fragment, preset: Some(&preset), ..Scope::default() };
    let rows: Vec<[f32; 1]> = (0..500).map(|row| [row as f32]).collect();
    let rows = values("row_of_disc(row)", &scope, ["row"], &rows);
    (0..3).map(|i| rows.iter().map(|row| row[i]).sum()).collect()
}

#[test]
fn the_discs_of_sun_and_moon_give_the_light_that_they_state() {
    let mut report = Report::new("Night", "the_discs_of_sun_and_moon_give_the_light_that_they_state");
    let lens = ["camera.focal_length=1200", "frame.resolution=[4000, 2000]"]; // a 250th of the disc a pixel
    let sun = light_of_disc("sun_disc", "sun_direction()", "sun_light()", &lens);
    let off = |light: &[f64]| greatest(light.iter().map(|part| (part - 1.0).abs()));
    report.at_most("`sun_disc`: light in all, off `sun_light`", off(&sun), 0.01);
    for (name, azimuth) in [("full", 180), ("gibbous, 60°", 120), ("half", 90), ("crescent, 130°", 50)] {
        let sun = format!("sun.azimuth={azimuth}");
        let mut settings = vec!["moon.shines=true", "moon.elevation=0", "moon.azimuth=0", "sun.elevation=0"];
        settings.extend(["moon.earthshine=0", sun.as_str()]);
        settings.extend(lens);
        let smooth = [settings.clone(), vec!["moon.seas=0"]].concat();
        let light = light_of_disc("moon_disc", "moon_direction()", "moon_light()", &smooth);
        report.at_most(
            &format!("`moon_disc` without seas, {name}: light in all, off `moon_light`"),
            off(&light),
            0.01,
        );
        let light = light_of_disc("moon_disc", "moon_direction()", "moon_light()", &settings);
        report.at_most(&format!("`moon_disc`, {name}: light in all, off `moon_light`"), off(&light), 0.2);
    }
    report.finish();
}

#[test]
fn the_sun_darkens_toward_its_limb_as_measured() {
    let scope = Scope { includes: &["<light/disc.wgsl>"], ..Scope::default() };
    let rings: Vec<[f32; 1]> = (0..2000).map(|i| [((i as f32 + 0.5) / 2000.0).sqrt()]).collect(); // of one area each
    let limb = values("sun_limb(mu)", &scope, ["mu"], &rings);
    let mut report = Report::new("Night", "the_sun_darkens_toward_its_limb_as_measured");
    // Hestroffer & Magnan 1998: I(mu) / I(1) = mu^(.292 / wavelength - .023).
    let middle = values("sun_limb(mu)", &scope, ["mu"], &[[1.0]]).remove(0);
    for (i, (color, wavelength)) in [("red", 0.68), ("green", 0.55), ("blue", 0.44)].into_iter().enumerate() {
        let exponent = 0.292 / wavelength - 0.023;
        let off = limb
            .iter()
            .zip(&rings)
            .map(|(limb, ring)| (limb[i] / middle[i] - f64::from(ring[0]).powf(exponent)).abs());
        report.at_most(&format!("`sun_limb`, {color}: off the power law"), greatest(off), 1e-4);
        let mean = limb.iter().map(|limb| limb[i]).sum::<f64>() / limb.len() as f64;
        report.near(&format!("`sun_limb`, {color}: mean over the disc"), mean, 1.0, 1e-3);
    }
    report.finish();
}

#[test]
fn the_moon_is_as_light_as_its_phase() {
    let mut report = Report::new("Night", "the_moon_is_as_light_as_its_phase");
    let scope = Scope { includes: &["<light/disc.wgsl>"], ..Scope::default() };
    let angles: Vec<[f32; 1]> = (0..=180).map(|i| [(f64::from(i) * PI / 180.0) as f32]).collect();
    let law = values("moon_phase_law(angle)", &scope, ["angle"], &angles);
    let off = law.iter().zip(&angles).map(|(law, angle)| law[0] / moon::phase_law(f64::from(angle[0])) - 1.0);
    report.at_most("`moon_phase_law` off Allen's", greatest(off.map(f64::abs)), 1e-4);
    // Over the disc, cell by cell: what is lit, and how much light it gives in all.
    for degrees in [0.0_f64, 45.0, 90.0, 135.0, 160.0] {
        let angle = degrees.to_radians();
        let (points, inside) = moon::disc(400, angle);
        let points: Vec<[f32; 3]> =
            points.iter().map(|[sun, eye]| [*sun as f32, *eye as f32, angle as f32]).collect();
        let light = values("moon_scattering(sun, eye, angle)", &scope, ["sun", "eye", "angle"], &points);
        let lit = light.iter().filter(|light| light[0] > 0.0).count() as f64 / inside;
        report.near(
            &format!("`moon_scattering`, {degrees}°: part of the disc that is lit"),
            lit,
            0.5 + 0.5 * angle.cos(),
            0.004,
        );
        let mean = light.iter().map(|light| light[0]).sum::<f64>() / inside;
        let ratio = mean / moon::phase_law(angle);
        report.near(
            &format!("`moon_scattering`, {degrees}°: light in all over `moon_phase_law`"),
            ratio,
            1.0,
            0.02,
        );
    }
    // The angle between sun and moon, wherever they stand.
    let mut random = Random::new(3);
    let mut off = 0.0_f64;
    for place in [[10.0, 20.0, 190.0, -20.0], [0.0, 5.0, 0.01, 5.0]].into_iter().chain(
        (0..10)
            .map(|_| [random.within(0.0, 360.0), random.within(-80.0, 80.0), random.within(0.0, 360.0), 9.0]),
    ) {
        let names = ["moon.azimuth", "moon.elevation", "sun.azimuth", "sun.elevation"];
        let settings: Vec<String> =
            names.iter().zip(place).map(|(name, degrees)| format!("{name}={degrees}")).collect();
        let preset = preset(&settings);
        let scope = Scope { includes: &["<sun/moon.wgsl>"], preset: Some(&preset), ..Scope::default() };
        let found = value("moon_phase_angle()", &scope)[0];
        let [moon_azimuth, moon_elevation, sun_azimuth, sun_elevation] =
            place.map(|degrees: f32| f64::from(degrees).to_radians());
        let truth = moon::phase_angle([moon_azimuth, moon_elevation], [sun_azimuth, sun_elevation]);
        off = off.max((found - truth).abs());
    }
    report.at_most("`moon_phase_angle` off f64 (rad)", off, 5e-6);
    report.finish();
}

// ---- stars ----

#[test]
fn stars_are_as_many_as_in_the_real_sky() {
    // Every cell of the first three layers: those up to magnitude 6.5.
    let grids = [6_u32, 18, 58];
    let cells: Vec<[f32; 4]> = grids
        .into_iter()
        .enumerate()
        .flat_map(|(layer, grid)| {
            (0..6 * grid * grid).map(move |i| {
                [i % grid, i / grid % grid, i / (grid * grid), layer as u32].map(|index| index as f32)
            })
        })
        .collect();
    let fragment = "
        #include <sky/stars.wgsl>
        fn star_as_numbers(x: f32, y: f32, face: u32, layer: i32) -> vec4f {
            let star = star_in(vec2f(x, y), face, layer);
            return vec4f(star.place, star.magnitude);
        }";
    let mut report = Report::new("Night", "stars_are_as_many_as_in_the_real_sky");
    let mut all = Vec::new();
    for seed in ["stars.seed=7", "stars.seed=8"] {
        let preset = preset(&[seed]);
        let scope = Scope { fragment, preset: Some(&preset), ..Scope::default() };
        all.extend(values(
            "star_as_numbers(x, y, face, layer)",
            &scope,
            ["x", "y", "face:u32", "layer:i32"],
            &cells,
        ));
    }
    // Two skies: N ± √(.6 N / 2) is one deviation, since two cells of five hold a star.
    for (magnitude, deviations) in [(2.5, 3.0), (4.5, 3.0), (5.5, 3.0), (6.5, 3.0)] {
        let count = all.iter().filter(|star| star[3] <= magnitude).count() as f64 / 2.0;
        let law = 10.0_f64.powf(0.51 * magnitude + 0.64);
        let bound = deviations * (0.3 * law).sqrt() / law;
        report.near(
            &format!("stars up to magnitude {magnitude}, over 10^(.51 m + .64)"),
            count / law,
            1.0,
            bound,
        );
    }
    // As many on each part of a side: its middle ninth (by angles) covers a known part of the sphere.
    let stars: Vec<&Vec<f64>> = all.iter().filter(|star| star[3] < 90.0).collect();
    let third = (PI / 12.0).tan();
    let middle =
        stars.iter().filter(|s| s[0].abs() < third * s[2] && s[1].abs() < third * s[2]).count() as f64;
    let part = 6.0 * 4.0 * (third * third / (1.0 + third * third)).asin() / (2.0 * TAU);
    report.near(
        "stars in the middle of the cube's sides, over an even share",
        middle / stars.len() as f64 / part,
        1.0,
        0.06,
    );
    let length = |s: &Vec<f64>| (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]).sqrt() - 1.0;
    report.at_most(
        "directions of stars: off length 1",
        greatest(stars.iter().map(|s| length(s).abs())),
        1e-6,
    );
    report.finish();
}

#[test]
fn a_star_is_as_bright_wherever_it_stands_between_the_pixels() {
    // The brightest stars in a window of the sky, each summed over the 13×13 pixels around it, for 64 places of the grid.
    let fragment = "
        #include <math/rotation.wgsl>
        #include <sky/stars.wgsl>
        fn star_at(x: f32, y: f32) -> f32 {
            let p = camera_pixel_angle();
            return star_radiance(normalize(direction_from_angles(2.0 + x * p, 0.3 + y * p))).y;
        }
        fn star_window(x: f32, y: f32) -> f32 {
            let middle = direction_from_angles(2.0 + x * camera_pixel_angle(), 0.3 + y * camera_pixel_angle());
            let right = normalize(cross(middle, vec3f(0.0, 1.0, 0.0)));
            let up = cross(right, middle);
            var sum = 0.0;
            for (var i = 0; i < 169; i++) {
                let off = vec2f(f32(i % 13), f32(i / 13)) - 6.0;
                sum += star_radiance(normalize(middle + camera_pixel_angle() * (off.x * right + off.y * up))).y;
            }
            return sum;
        }";
    let preset = preset(&["stars.limit=4.5", "stars.seed=7"]);
    let scope = Scope { fragment, preset: Some(&preset), ..Scope::default() };
    let side = 260;
    let grid: Vec<[f32; 2]> = (0..side * side).map(|i| [(i % side) as f32, (i / side) as f32]).collect();
    let seen: Vec<f64> = values("star_at(x, y)", &scope, ["x", "y"], &grid).concat();
    let at = |x: i32, y: i32| seen[(y * side + x) as usize];
    // Brightest of its neighbourhood, and with nothing near.
    let mut stars = Vec::new();
    for y in 12..side - 12 {
        for x in 12..side - 12 {
            let around = || (-12..=12).flat_map(move |j| (-12..=12).map(move |i| (i, j)));
            let is_top = around().all(|(i, j)| at(x + i, y + j) <= at(x, y)) && at(x, y) > 0.0;
            let alone =
                around().filter(|(i, j)| i.abs() > 4 || j.abs() > 4).all(|(i, j)| at(x + i, y + j) == 0.0);
            if is_top && alone {
                stars.push([x as f32, y as f32]);
            }
        }
    }
    let mut report = Report::new("Night", "a_star_is_as_bright_wherever_it_stands_between_the_pixels");
    report.at_least("stars looked at", stars.len() as f64, 3.0);
    let shift = |star: &[f32; 2], i: usize| [star[0] + (i % 8) as f32 / 8.0, star[1] + (i / 8) as f32 / 8.0];
    let points: Vec<[f32; 2]> = stars.iter().flat_map(|star| (0..64).map(move |i| shift(star, i))).collect();
    let windows: Vec<f64> = values("star_window(x, y)", &scope, ["x", "y"], &points).concat();
    let ratio =
        |window: &[f64]| greatest(window.iter().copied()) / -greatest(window.iter().map(|v| -v)) - 1.0;
    report.at_most(
        "a star's light, brightest over dimmest place",
        greatest(windows.chunks_exact(64).map(ratio)),
        0.01,
    );
    // The same star in a picture of twice the pixels: as much light in all.
    let finer = self::preset(&["stars.limit=4.5", "stars.seed=7", "frame.resolution=[1920,1080]"]);
    let scope = Scope { preset: Some(&finer), fragment, ..Scope::default() };
    let points: Vec<[f32; 2]> = stars.iter().map(|star| star.map(|v| 2.0 * v)).collect();
    let fine: Vec<f64> = values("star_window(x, y)", &scope, ["x", "y"], &points).concat();
    let off =
        fine.iter().zip(windows.chunks_exact(64)).map(|(fine, window)| (fine / 4.0 / window[0] - 1.0).abs());
    report.at_most("a star's light in a picture of four times the pixels, off", greatest(off), 0.01);
    report.finish();
}

// ---- all of it ----

#[test]
fn what_shines_behind_the_air_is_a_number_everywhere() {
    let mut random = Random::new(19);
    let unit = |v: [f32; 3]| {
        let length = v.iter().map(|v| v * v).sum::<f32>().sqrt().max(1e-9);
        v.map(|part| part / length)
    };
    let mut directions: Vec<[f32; 3]> = (0..30_000).map(|_| unit(random.point::<3>(1.0))).collect();
    for x in [-1.0, 0.0, 1.0] {
        for y in [-1.0, 0.0, 1.0] {
            directions.extend(
                [-1.0, 0.0, 1.0]
                    .into_iter()
                    .filter(|z| x != 0.0 || y != 0.0 || *z != 0.0)
                    .map(|z| unit([x, y, z])),
            );
        }
    }
    let mut report = Report::new("Night", "what_shines_behind_the_air_is_a_number_everywhere");
    let cases: [&[&str]; 4] = [
        &["sun.elevation=-30"],
        &["sun.elevation=90", "moon.elevation=-90", "stars.latitude=90", "stars.turn=0"],
        &["sun.elevation=20", "sun.azimuth=0", "moon.elevation=20", "moon.azimuth=0", "stars.latitude=20"],
        &[
            "sun.elevation=-35",
            "sun.azimuth=-30",
            "moon.elevation=35",
            "moon.azimuth=150",
            "stars.limit=8.5",
            "camera.focal_length=8",
            "frame.resolution=[16,9]",
        ],
    ];
    let mut bad = 0;
    for case in cases {
        let preset = preset(&[case, &["moon.shines=true", "stars.shine=true"]].concat());
        let scope = Scope { includes: &["<sky/beyond.wgsl>"], preset: Some(&preset), ..Scope::default() };
        let at_lights = ["sun_direction()", "moon_direction()", "-moon_direction()"];
        let light = values("sky_beyond(p)", &scope, ["x", "y", "z"], &directions).concat();
        let there = at_lights.iter().flat_map(|at| value(&format!("sky_beyond({at})"), &scope));
        bad += light.into_iter().chain(there).filter(|v| !v.is_finite() || *v < 0.0).count();
    }
    report.at_most("`sky_beyond`: numbers that are none, or below 0", bad as f64, 0.0);
    report.finish();
}

#[test]
fn the_key_light_goes_from_sun_to_moon_without_a_jump() {
    let mut report = Report::new("Night", "the_key_light_goes_from_sun_to_moon_without_a_jump");
    let at = |elevation: f64| {
        let sun = format!("sun.elevation={elevation}");
        let preset = preset(&[
            sun.as_str(),
            "sun.azimuth=300",
            "moon.shines=true",
            "moon.azimuth=100",
            "moon.elevation=30",
        ]);
        let scope = Scope { includes: &["<sun/key.wgsl>"], preset: Some(&preset), ..Scope::default() };
        value("vec4f(key_light(), key_direction().y)", &scope)
    };
    let (sun, moon) = (at(-3.9), at(-6.1));
    report.near("`key_light` above -4°, over `sun_light`", sun[1], 4.0 * 0.84, 1e-5);
    report.near("`key_direction` above -5°: the sun's height", sun[3], (-3.9_f64).to_radians().sin(), 1e-6);
    report.near("`key_direction` below -5°: the moon's height", moon[3], 30.0_f64.to_radians().sin(), 1e-6);
    let full = moon[1];
    report.at_least("`key_light` below -6°: moonlight over sunlight", full / sun[1], 1e-7);
    report.at_most("`key_light` just above the change, over sunlight", at(-4.9999)[1] / sun[1], 1e-4);
    report.at_most("`key_light` just below the change, over moonlight", at(-5.0001)[1] / full, 1e-4);
    let steps: Vec<f64> = (0..=26).map(|i| at(-3.7 - 0.05 * f64::from(i))[1] / sun[1]).collect();
    let jump = greatest(steps.windows(2).map(|pair| (pair[1] - pair[0]).abs()));
    report.at_most("`key_light` of the sun: greatest change over .05°, of it", jump, 0.08);
    let steps: Vec<f64> = (0..=26).map(|i| at(-5.0 - 0.05 * f64::from(i))[1] / full).collect();
    let jump = greatest(steps.windows(2).map(|pair| (pair[1] - pair[0]).abs()));
    report.at_most("`key_light` of the moon: greatest change over .05°, of it", jump, 0.08);
    report.finish();
}

#[test]
fn twilight_falls_as_the_naval_observatory_has_it() {
    let mut report = Report::new("Night", "twilight_falls_as_the_naval_observatory_has_it");
    let scope = Scope { includes: &["<light/illuminance.wgsl>"], ..Scope::default() };
    let heights: Vec<[f32; 1]> =
        (-2500..=9000).map(|i| [(f64::from(i) / 100.0).to_radians() as f32]).collect();
    let found = values("daylight_illuminance(elevation)", &scope, ["elevation"], &heights).concat();
    let off = found.iter().zip(&heights).map(|(found, height)| {
        // Where two polynomials meet either will do: the angle is rounded.
        let truths = [-1e-5, 1e-5].map(|off| twilight::illuminance(f64::from(height[0]).to_degrees() + off));
        truths.map(|truth| (found / truth - 1.0).abs()).into_iter().fold(f64::INFINITY, f64::min)
    });
    report.at_most("`daylight_illuminance` off f64, of it", greatest(off), 1e-4);
    let falls = greatest(found.windows(2).map(|pair| pair[0] / pair[1] - 1.0));
    report.at_most("`daylight_illuminance`: greatest fall as the sun rises, of it", falls, 0.01);
    // Bond & Henderson 1963, "The conjunction of the sun, moon and sky": at the ends of civil, nautical and astronomical
    // twilight, and of day.
    for (degrees, lux, tolerance) in
        [(0.0, 732.0, 0.15), (-6.0, 3.4, 0.1), (-12.0, 8.3e-3, 0.1), (-18.0, 6.5e-4, 0.1)]
    {
        let found = values(
            "daylight_illuminance(elevation)",
            &scope,
            ["elevation"],
            &[[f64::to_radians(degrees) as f32]],
        )[0][0];
        report.near(
            &format!("`daylight_illuminance` at {degrees}°, over {lux} lx"),
            found / lux,
            1.0,
            tolerance,
        );
    }
    report.finish();
}

#[test]
fn automatic_exposure_follows_the_light_down() {
    let mut report = Report::new("Night", "automatic_exposure_follows_the_light_down");
    let stops = |degrees: f64, more: &[&str]| {
        let sun = format!("sun.elevation={degrees}");
        let preset =
            preset(&[&[sun.as_str(), "display.auto_exposure=true", "display.exposure=0.5"], more].concat());
        let scope = Scope { includes: &["<camera/display.wgsl>"], preset: Some(&preset), ..Scope::default() };
        value("display_stops()", &scope)[0]
    };
    report.near(
        "`display_stops` with the sun at 45°, less `display.exposure` (EV)",
        stops(45.0, &[]) - 0.5,
        0.0,
        0.01,
    );
    for degrees in [20.0, 5.0, 0.0, -6.0, -12.0, -18.0] {
        let told = stops(degrees, &[]) - 0.5;
        let truth = 0.9 * (twilight::illuminance(45.0) / twilight::illuminance(degrees)).log2();
        report.near(&format!("`display_stops` at {degrees}° (EV)"), told, truth, 0.02);
    }
    report.near("`display_stops` below twilight", stops(-40.0, &[]) - stops(-18.0, &[]), 0.0, 1e-4);
    report.finish();
}
