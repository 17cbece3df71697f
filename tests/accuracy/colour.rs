//! Colours: tone maps, dither, what glows, and colours that stand for numbers.

use truth::blackbody;
use truth::oklab::oklab;
use truth::points::Random;

use crate::harness::{Report, Scope, values};

#[test]
fn heat_is_as_light_as_it_is_hot() {
    let scope = Scope { includes: &["<color/heat.wgsl>"], ..Scope::default() };
    let parts: Vec<[f32; 1]> = (0..=1000).map(|i| [i as f32 / 1000.0]).collect();
    let colors = values("heat_color(part)", &scope, ["part"], &parts);
    let labs: Vec<[f64; 3]> = colors.iter().map(|c| oklab([c[0], c[1], c[2]])).collect();
    let mut report = Report::new("Colour", "heat_is_as_light_as_it_is_hot");
    let off = labs.iter().zip(&parts).map(|(lab, part)| (lab[0] - (0.20 + 0.76 * f64::from(part[0]))).abs());
    report.at_most("`heat_color`: lightness off the line 0.20 to 0.96", off.fold(0.0, f64::max), 1e-5);
    // Were a colour outside of sRGB, it would be clipped, and its channels exactly 0 or 1.
    let scalars = || colors.iter().flatten().copied();
    report.at_least("`heat_color`: the least channel", scalars().fold(1.0, f64::min), 1e-4);
    report.at_most("`heat_color`: the greatest channel", scalars().fold(0.0, f64::max), 0.999);
    let step = |pair: &[[f64; 3]]| (0..3).map(|i| (pair[1][i] - pair[0][i]).powi(2)).sum::<f64>().sqrt();
    let steps: Vec<f64> = labs.windows(2).map(step).collect();
    let ratio = steps.iter().copied().fold(0.0, f64::max) / steps.iter().copied().fold(1.0, f64::min);
    report.at_most("`heat_color`: the greatest step of colour over the least", ratio, 1.1);
    report.finish();
}

#[test]
fn oklab_is_there_and_back_again() {
    let scope = Scope { includes: &["<color/oklab.wgsl>"], ..Scope::default() };
    let mut random = Random::new(3);
    let colors: Vec<[f32; 3]> = (0..100_000).map(|_| [0; 3].map(|_| random.within(0.0, 1.0))).collect();
    let labs = values("oklab_from_linear(p)", &scope, ["x", "y", "z"], &colors);
    let back = values("oklab_to_linear(oklab_from_linear(p))", &scope, ["x", "y", "z"], &colors);
    let (mut off, mut lost) = (0.0_f64, 0.0_f64);
    for ((color, lab), back) in colors.iter().zip(&labs).zip(&back) {
        let exact = oklab(color.map(f64::from));
        off = (0..3).map(|i| (lab[i] - exact[i]).abs()).fold(off, f64::max);
        lost = (0..3).map(|i| (back[i] - f64::from(color[i])).abs()).fold(lost, f64::max);
    }
    let mut report = Report::new("Colour", "oklab_is_there_and_back_again");
    report.at_most("`oklab_from_linear` against f64", off, 5e-6);
    report.at_most("`oklab_to_linear` of `oklab_from_linear`", lost, 2e-5);
    report.finish();
}

/// A tone map, what it makes of .18 and of how much light its white is (infinite: none is ever white).
struct Map {
    name: &'static str,
    of_mid_grey: f64,
}

const MAPS: [Map; 6] = [
    Map { name: "tone_map_exponential(p)", of_mid_grey: 0.164_730 },
    Map { name: "tone_map_reinhard(p)", of_mid_grey: 0.152_542 },
    Map { name: "tone_map_reinhard_white(p, 4.0)", of_mid_grey: 0.154_258 },
    Map { name: "tone_map_aces(p)", of_mid_grey: 0.105_591 },
    Map { name: "tone_map_agx(p)", of_mid_grey: 0.18 },
    Map { name: "tone_map_neutral(p)", of_mid_grey: 0.14 },
];

const TONE_MAPS: Scope<'static> = Scope { includes: &["<color/tone_map.wgsl>"], fragment: "", preset: None };

#[test]
fn tone_maps_go_up_from_black_to_white() {
    let mut report = Report::new("Colour", "tone_maps_go_up_from_black_to_white");
    // 0, and from 1e-6 to 1e6 in steps of 1 %; greys.
    let levels = (0..2778).map(|i| 1e-6_f64 * 1.01_f64.powi(i)).chain([1e6]);
    let greys: Vec<[f32; 3]> = [0.0].into_iter().chain(levels).map(|level| [level as f32; 3]).collect();
    let mut random = Random::new(11);
    let colors: Vec<[f32; 3]> =
        (0..50_000).map(|_| [0; 3].map(|_| 10.0_f32.powf(random.within(-6.0, 6.0)))).collect();
    for map in &MAPS {
        let name = map.name;
        let shown = values(name, &TONE_MAPS, ["x", "y", "z"], &greys);
        let step = |pair: &[Vec<f64>]| pair[1][1] - pair[0][1];
        let least_step = shown.windows(2).map(step).fold(f64::INFINITY, f64::min);
        report.at_least(
            &format!("`{name}`: the least step, from a grey to one 1 % lighter"),
            least_step,
            -2e-7,
        );
        let tint = |c: &Vec<f64>| c.iter().map(|v| (v - c[1]).abs()).fold(0.0, f64::max);
        report.at_most(&format!("`{name}`: a grey's tint"), shown.iter().map(tint).fold(0.0, f64::max), 2e-5);
        report.at_most(&format!("`{name}`: of black"), shown[0][1].abs(), 1e-6);
        report.at_least(&format!("`{name}`: of light 1e6"), shown[greys.len() - 1][1], 0.999);
        let grey = values(name, &TONE_MAPS, ["x", "y", "z"], &[[0.18; 3]]);
        report.near(&format!("`{name}`: of .18"), grey[0][1], map.of_mid_grey, 2e-5);
        // NaN would break both.
        let all: Vec<f64> = values(name, &TONE_MAPS, ["x", "y", "z"], &colors).concat();
        let inside = all.iter().filter(|v| (0.0..=1.0).contains(*v)).count();
        report.at_least(
            &format!("`{name}`: part of colours within 0 .. 1"),
            inside as f64 / all.len() as f64,
            1.0,
        );
    }
    report.finish();
}

#[test]
fn tone_maps_have_the_slope_in_the_dark_that_they_state() {
    let mut report = Report::new("Colour", "tone_maps_have_the_slope_in_the_dark_that_they_state");
    let stated =
        [("exponential(p)", 1.0), ("reinhard(p)", 1.0), ("reinhard_white(p, 4.0)", 1.0), ("agx(p)", 0.0)];
    for (name, slope) in stated.into_iter().chain([("neutral(p)", 0.0)]) {
        let at = 1e-5_f32;
        let shown = values(&format!("tone_map_{name}"), &TONE_MAPS, ["x", "y", "z"], &[[at; 3]])[0][1];
        report.near(&format!("`tone_map_{name}`: slope at 0"), shown / f64::from(at), slope, 0.01);
    }
    let ends =
        values("tone_map_aces(p)", &TONE_MAPS, ["x", "y", "z"], &[[0.0032; 3], [0.0035; 3], [0.0036; 3]]);
    report.at_most("`tone_map_aces`: of .0032", ends[0][1], 0.0);
    report.near("`tone_map_aces`: slope at .0035", (ends[2][1] - ends[1][1]) / 1e-4, 0.13, 0.005);
    report.finish();
}

/// The specification of Khronos PBR Neutral, as it is written there.
fn neutral(color: [f64; 3]) -> [f64; 3] {
    let (f90, desaturation) = (0.04, 0.15);
    let start = 0.8 - f90;
    let least = color.into_iter().fold(f64::INFINITY, f64::min);
    let f = if least <= 2.0 * f90 { least - least * least / (4.0 * f90) } else { f90 };
    let peak = color.map(|c| c - f).into_iter().fold(0.0, f64::max);
    if peak <= start {
        return color.map(|c| c - f);
    }
    let pressed = 1.0 - (1.0 - start).powi(2) / (peak + 1.0 - 2.0 * start);
    let g = 1.0 / (desaturation * (peak - pressed) + 1.0);
    color.map(|c| (c - f) * pressed / peak * g + pressed * (1.0 - g))
}

#[test]
fn neutral_keeps_base_colours_and_presses_lights_as_specified() {
    let mut random = Random::new(5);
    let base: Vec<[f32; 3]> = (0..20_000).map(|_| [0; 3].map(|_| random.within(0.08, 0.8))).collect();
    let bright: Vec<[f32; 3]> =
        (0..20_000).map(|_| [0; 3].map(|_| 10.0_f32.powf(random.within(-3.0, 3.0)))).collect();
    let off = |shown: &[Vec<f64>], colors: &[[f32; 3]], truth: &dyn Fn([f64; 3]) -> [f64; 3]| {
        let off = |(shown, color): (&Vec<f64>, &[f32; 3])| {
            let truth = truth(color.map(f64::from));
            (0..3).map(|i| (shown[i] - truth[i]).abs()).fold(0.0, f64::max)
        };
        shown.iter().zip(colors).map(off).fold(0.0, f64::max)
    };
    let mut report = Report::new("Colour", "neutral_keeps_base_colours_and_presses_lights_as_specified");
    let shown = values("tone_map_neutral(p)", &TONE_MAPS, ["x", "y", "z"], &base);
    let kept = off(&shown, &base, &|color| color.map(|c| c - 0.04));
    report.at_most("`tone_map_neutral`: base colours off themselves less .04", kept, 1e-6);
    let shown = values("tone_map_neutral(p)", &TONE_MAPS, ["x", "y", "z"], &bright);
    report.at_most("`tone_map_neutral` against the specification", off(&shown, &bright, &neutral), 2e-6);
    report.finish();
}

#[test]
fn dither_makes_up_for_the_steps() {
    // Every 1/20 of a step near black, in the middle and near white, each over 64×64 pixels of 4 frames.
    let scope = Scope {
        includes: &["<color/dither.wgsl>"],
        fragment: "
            fn mean_and_reach(steps: f32, number: u32) -> vec4f {
                var sum = vec3f(0.0);
                var furthest = 0.0;
                for (var i = 0; i < 4096; i++) {
                    let pixel = vec2f(f32(i % 64), f32(i / 64)) + 0.5;
                    let noisy = 255.0 * dither_255(vec3f(steps / 255.0), pixel, number);
                    sum += round(clamp(noisy, vec3f(0.0), vec3f(255.0)));
                    furthest = max(furthest, max(max(abs(noisy.x - steps), abs(noisy.y - steps)), abs(noisy.z - steps)));
                }
                return vec4f(sum / 4096.0 - steps, furthest);
            }",
        ..Scope::default()
    };
    let levels =
        [0.0_f32, 119.0, 253.0].into_iter().flat_map(|start| (0..=40).map(move |i| start + i as f32 / 20.0));
    let points: Vec<[f32; 2]> =
        levels.flat_map(|level| (0..4).map(move |frame| [level, frame as f32])).collect();
    let frames = values("mean_and_reach(steps, number)", &scope, ["steps", "number:u32"], &points);
    let over_frames = |rows: &[Vec<f64>]| -> Vec<f64> {
        (0..4).map(|i| rows.iter().map(|row| row[i]).sum::<f64>() / 4.0).collect()
    };
    let off: Vec<Vec<f64>> = frames.chunks_exact(4).map(over_frames).collect();
    let mut report = Report::new("Colour", "dither_makes_up_for_the_steps");
    let mean = off.iter().flat_map(|row| &row[..3]).map(|v| v.abs()).fold(0.0, f64::max);
    report.at_most("`dither_255`, rounded: mean off the value, in steps", mean, 0.02);
    report.at_most(
        "`dither_255`: noise, in steps",
        frames.iter().map(|row| row[3]).fold(0.0, f64::max),
        1.0001,
    );
    let ends = [&off[0], &off[off.len() - 1]].map(|row| row[..3].iter().map(|v| v.abs()).sum::<f64>());
    report.at_most("`dither_255`: black and white off themselves", ends[0] + ends[1], 0.0);
    report.finish();
}

#[test]
fn what_glows_has_the_colour_that_planck_gives_it() {
    let scope = Scope { includes: &["<color/blackbody.wgsl>"], ..Scope::default() };
    let temperatures: Vec<[f32; 1]> = (0..=200).map(|i| [2000.0 * 20.0_f32.powf(i as f32 / 200.0)]).collect();
    let colors = values("blackbody_color(t)", &scope, ["t"], &temperatures);
    let (mut off, mut part) = (0.0_f64, 0.0_f64);
    for (color, [temperature]) in colors.iter().zip(&temperatures) {
        let truth = blackbody::linear_srgb(f64::from(*temperature));
        for i in 0..3 {
            let error = (color[i] - truth[i]).abs();
            off = off.max(error);
            if *temperature > 3000.0 {
                part = part.max(error / truth[i]);
            }
        }
    }
    let mut report = Report::new("Colour", "what_glows_has_the_colour_that_planck_gives_it");
    report.at_most("`blackbody_color` against f64", off, 0.025);
    report.at_most("`blackbody_color` against f64, in parts of it, above 3,000 K", part, 0.03);
    report.finish();
}
