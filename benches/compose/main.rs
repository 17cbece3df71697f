//! Composing and checking, side by side with naga alone, in one run.
//!
//! The contestants of a row take turns, so that a busy machine slows all of them; what is printed is the median of the
//! process's CPU time (steadier than wall time), and ratios of medians, which are what the project promises something
//! about: see the bars beside them.

#![allow(clippy::print_stdout, missing_docs, reason = "a bench prints its table")]

mod graphs;

use std::hint::black_box;
use std::time::Duration;

use cpu_time::ProcessTime;
use graphs::{Shape, graph, module};
use naga::valid::{ValidationFlags, Validator};
use orogen::{Bake, Compose, Library, Preset, check, compose};

const ROUNDS: usize = 15;

fn main() {
    println!("CPU time, medians of {ROUNDS} rounds; naga: parse + validate of the same composed text\n");
    println!(
        "{:<18}{:>8}{:>11}{:>11}{:>11}{:>11}{:>16}{:>16}",
        "graph", "KiB", "naga ms", "compose", "c. + check", "leaf", "c. + ch. / naga", "leaf / compose"
    );
    let mut linear = Vec::new();
    for (modules, functions) in [(8, 8), (32, 16), (100, 20), (400, 20)] {
        for shape in [Shape::Chain, Shape::Diamond, Shape::Wide] {
            if modules > 250 && matches!(shape, Shape::Chain) {
                continue; // deeper than includes may nest
            }
            let graph = graph(shape, modules, functions);
            let leaf = (graph.leaf.as_str(), functions, modules - 1);
            let row = measure(&graph.library, &graph.root, Some(leaf));
            let name = format!("{shape:?} {modules}x{functions}");
            print(&name, &row, modules == 100);
            linear.push((shape, modules, row.compose));
        }
    }
    let library = Library::standard();
    for name in orogen::source::preset_names() {
        let preset = Preset::named(name).expect("it is built in");
        print(name, &measure(&library, &preset, None), false);
    }
    changes(&library);
    println!("\ncomposing, 400x20 against 100x20 (four times the text; bar 4.5):");
    for shape in ["Diamond", "Wide"] {
        let time =
            |size| linear.iter().find(|(s, m, _)| format!("{s:?}") == shape && *m == size).map(|row| row.2);
        let (Some(small), Some(large)) = (time(100), time(400)) else { continue };
        let ratio = large / small;
        println!("  {shape:<10}{ratio:>6.2}{}", verdict(ratio <= 4.5));
    }
}

/// Prints what it takes to change one parameter of `alpine`: a live one, which is a range of bytes, and a constant one,
/// for which what depends on it is composed again.
fn changes(library: &Library) {
    let suns = ["sun.elevation=4", "sun.elevation=5"];
    let [mut preset, mut other] = [(); 2].map(|()| Preset::named("alpine").expect("it is built in"));
    other.set(suns[0]).expect("it is a parameter");
    let shader = compose(library, &preset, &Bake::live(["sun.*"])).expect("it composes and is valid");
    let mut bytes = shader.uniform_bytes(&preset).expect("it has a block");
    let bake = Bake::constants();
    let mut warm = Compose::default();
    let _ = warm.bake(library, &preset, &bake);
    let mut written = 0;
    let mut times = [const { Vec::new() }; 3];
    for round in 0..ROUNDS {
        let constant = [&preset, &other][round % 2].clone();
        times[1].push(time(|| warm.bake(library, &constant, &bake).expect("it composes")));
        times[2].push(time(|| Compose::default().bake(library, &constant, &bake).expect("it composes")));
        preset.set(suns[round % 2]).expect("it is a parameter");
        times[0].push(time(|| {
            written = shader.update_uniform(&mut bytes, &preset).expect("it is of that preset").len();
        }));
    }
    let [live, constant, cold] = times.map(|times| median(times).unwrap_or(0.0));
    println!("\none parameter of alpine changed:");
    println!("  live       {live:>8.3} ms, nothing is composed: {written} bytes for the uniform buffer");
    println!(
        "  constant   {constant:>8.3} ms, {:.0} % of composing it from nothing",
        100.0 * constant / cold
    );
}

struct Row {
    bytes: usize,
    naga: f64,
    compose: f64,
    compose_and_check: f64,
    leaf: Option<f64>,
}

fn measure(library: &Library, preset: &Preset, leaf: Option<(&str, usize, usize)>) -> Row {
    let bake = Bake::constants();
    let text = Compose::default().bake(library, preset, &bake).expect("it composes").text;
    // Two versions of one leaf take turns, so that every composition finds exactly it changed.
    let versions = leaf.map(|(path, functions, index)| {
        [1, 2].map(|salt| library.clone().with_file(path, module(index, functions, &[], salt)))
    });
    let mut warm = Compose::default();
    let _ = warm.bake(library, preset, &bake);
    let mut times = [const { Vec::new() }; 4];
    for round in 0..ROUNDS {
        times[0].push(time(|| {
            let module = naga::front::wgsl::parse_str(&text).expect("it parses");
            Validator::new(ValidationFlags::all(), check::capabilities())
                .validate(&module)
                .expect("it is valid")
        }));
        times[1].push(time(|| Compose::default().bake(library, preset, &bake).expect("it composes")));
        times[2].push(time(|| compose(library, preset, &bake).expect("it composes and is valid")));
        if let Some(versions) = &versions {
            times[3].push(time(|| warm.bake(&versions[round % 2], preset, &bake).expect("it composes")));
        }
    }
    let [naga, compose, compose_and_check, leaf] = times.map(median);
    Row {
        bytes: text.len(),
        naga: naga.unwrap_or(0.0),
        compose: compose.unwrap_or(0.0),
        compose_and_check: compose_and_check.unwrap_or(0.0),
        leaf,
    }
}

fn print(name: &str, row: &Row, judged: bool) {
    let ratio = row.compose_and_check / row.naga;
    let judge = |holds| if judged { verdict(holds) } else { "" };
    let leaf = row.leaf.map_or(["–".into(), "–".into()], |leaf| {
        let share = leaf / row.compose;
        [format!("{leaf:.3}"), format!("{:.1} %{}", share * 100.0, judge(share <= 0.15))]
    });
    println!(
        "{name:<18}{:>8}{:>11.3}{:>11.3}{:>11.3}{:>11}{:>16}{:>16}",
        row.bytes / 1024,
        row.naga,
        row.compose,
        row.compose_and_check,
        leaf[0],
        format!("{ratio:.2}{}", judge(ratio <= 1.25)),
        leaf[1],
    );
}

fn verdict(holds: bool) -> &'static str {
    if holds { " ok" } else { " MISSED" }
}

fn time<T>(work: impl FnOnce() -> T) -> Duration {
    let start = ProcessTime::now();
    let result = work();
    let taken = start.elapsed();
    black_box(result);
    taken
}

fn median(mut times: Vec<Duration>) -> Option<f64> {
    times.sort();
    times.get(times.len() / 2).map(|time| time.as_secs_f64() * 1e3)
}
