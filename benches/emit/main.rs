//! Writing GLSL and minifying: what a checked shader takes to become a file.
//!
//! Medians of the process's CPU time. Bars: 20 ms for the largest preset, and four times the text in at most 5 times the
//! time.

#![allow(clippy::print_stdout, missing_docs, reason = "a bench prints its table")]

use std::fmt::Write;
use std::hint::black_box;

use cpu_time::ProcessTime;
use orogen::export::{Target, export, minify};
use orogen::{Bake, Compose, Library, Preset, Shader, Templates};

const ROUNDS: usize = 15;
/// What writing a preset may take (ms).
const BAR: f64 = 20.0;

fn main() {
    println!("CPU time, medians of {ROUNDS} rounds\n");
    println!("{:<20}{:>8}{:>14}{:>12}{:>12}", "preset", "KiB", "Shadertoy ms", "GLSL ms", "minify ms");
    let mut worst = 0.0f64;
    for name in orogen::source::preset_names() {
        let preset = Preset::named(name).expect("it is built in");
        worst = worst.max(row(name, &preset));
    }
    println!("\nthe slowest takes {worst:.1} ms (bar {BAR}){}", verdict(worst <= BAR));

    println!("\n{:<20}{:>8}{:>14}{:>12}{:>12}", "functions", "KiB", "Shadertoy ms", "GLSL ms", "minify ms");
    let times: Vec<f64> = [500, 1000, 2000, 4000]
        .map(|count| row(&count.to_string(), &Preset::of_text("many.wgsl", &many(count))))
        .to_vec();
    let ratio = times[3] / times[1];
    println!("\nfour times the text takes {ratio:.2} times as long (bar 5){}", verdict(ratio <= 5.0));
}

/// A scene of `count` functions, each calling the one before.
fn many(count: usize) -> String {
    let mut text = String::from("fn step0(p: vec2f) -> f32 { return p.x; }\n");
    for index in 1..count {
        let _ = write!(
            text,
            "\n/// The sum of what came before, and {index}.\nfn step{index}(p: vec2f) -> f32 {{\n    \
             let before = step{}(p * 0.5);\n    var sum = 0.0;\n    for (var i = 0u; i < 4u; i++) {{\n        \
             sum += select(before, f32(i) + 1, p.x > 0.5); // one of both\n    }}\n    return saturate(sum) % 3.0;\n}}\n",
            index - 1,
        );
    }
    let _ = write!(text, "\nfn main_image(p: vec2f) -> vec4f {{ return vec4f(step{}(p)); }}\n", count - 1);
    text
}

fn composed(preset: &Preset, target: Target) -> Shader {
    let mut composer = Compose::default();
    composer.stage = target.stage(None).expect("it has one");
    composer.run(&Library::standard(), preset, &target.bake(Bake::default())).expect("it composes")
}

/// Prints what `preset` takes; gives the Shadertoy file's time.
fn row(name: &str, preset: &Preset) -> f64 {
    let templates = Templates::standard();
    let [toy, glsl] = [Target::Shadertoy, Target::Glsl].map(|target| (target, composed(preset, target)));
    let mut times = [const { Vec::new() }; 3];
    for _ in 0..ROUNDS {
        for (at, (target, shader)) in [&toy, &glsl].into_iter().enumerate() {
            times[at].push(time(|| export(shader, *target, &templates).expect("it is written")));
        }
        times[2].push(time(|| minify(&toy.1, &templates).expect("it is minified")));
    }
    let [toy_time, glsl_time, minified] = times.map(median);
    let kib = toy.1.wgsl().len() / 1024;
    println!("{name:<20}{kib:>8}{toy_time:>14.2}{glsl_time:>12.2}{minified:>12.2}");
    toy_time
}

fn verdict(holds: bool) -> &'static str {
    if holds { " ok" } else { " MISSED" }
}

fn time<T>(work: impl FnOnce() -> T) -> f64 {
    let start = ProcessTime::now();
    black_box(work());
    start.elapsed().as_secs_f64() * 1e3
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
