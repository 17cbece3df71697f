//! What each element of a landscape costs: CPU seconds a frame at four sizes, the elements switched on one after the other.
//!
//! `cargo bench --bench elements -- lake forest` takes other presets than the usual one. Each row has one element more than
//! the row above; what it costs itself is the difference. A frame's cost must be a line over its pixels: a row whose R² is
//! below .99 fails the bench. `-- --qualities` compares `quality=low` with `high` instead, of all presets or of those named:
//! a preset of which low takes a quarter of high's time or more fails it. Compiling is left out: a small picture is drawn before, and what is told is the difference
//! between a picture averaged out of two frames and one out of one, which share all the rest. On a GPU, where the CPU only
//! waits, it is time by the clock.

#![allow(clippy::print_stdout, missing_docs, reason = "a bench prints its table")]

use std::time::Instant;

use cpu_time::ProcessTime;
use orogen::render::{Gpu, Shot, render};
use orogen::source::preset_names;
use orogen::{Bake, Error, Library, Preset, Shader, compose};

/// The presets that are measured, where none are named.
const PRESETS: [&str; 1] = ["lake"];

/// The elements, in the order in which they are switched on, each with what that takes. The first row is what is there
/// when all are off.
const ELEMENTS: [Element; 5] = [
    Element { name: "terrain", off: &[], on: &[] },
    Element { name: "trees", off: &["landscape.trees=false"], on: &["landscape.trees=true"] },
    Element { name: "water", off: &["landscape.water=false"], on: &["landscape.water=true"] },
    Element { name: "atmosphere", off: &["sky.model=gradient"], on: &["sky.model=atmosphere"] },
    Element { name: "clouds", off: &["weather.clouds=false"], on: &["weather.clouds=true"] },
];

const SIZES: [(u32, u32); 4] = [(240, 135), (480, 270), (720, 405), (960, 540)];
const LEAST_R2: f64 = 0.99;

/// Where two qualities are compared.
const COMPARED: (u32, u32) = (480, 270);
const COMPARED_ROUNDS: usize = 2;
const MOST_OF_HIGH: f64 = 0.25;

/// What is measured by itself.
struct Element {
    name: &'static str,
    /// Assignments, as of `--set`, that leave it out.
    off: &'static [&'static str],
    /// And that put it in.
    on: &'static [&'static str],
}

fn main() -> Result<(), String> {
    let named: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let is_named = !named.is_empty();
    let presets = if !is_named { PRESETS.map(str::to_owned).to_vec() } else { named };
    let told = |error: Error| error.render(false);
    let gpu = Gpu::new(None).map_err(told)?;
    let mut holds = true;
    if std::env::args().any(|argument| argument == "--qualities") {
        let presets =
            if is_named { presets } else { preset_names().into_iter().map(str::to_owned).collect() };
        println!(
            "quality low beside high at {}×{}, seconds a frame on {}\n",
            COMPARED.0,
            COMPARED.1,
            gpu.name()
        );
        for preset in presets {
            holds &= qualities(&gpu, &preset).map_err(told)?;
        }
        return if holds { Ok(()) } else { Err("low takes a quarter of high's time or more".to_owned()) };
    }
    for preset in presets {
        holds &= measure(&gpu, &preset).map_err(told)?;
    }
    if holds { Ok(()) } else { Err(format!("a row is no line over the pixels: its R² is below {LEAST_R2}")) }
}

/// Prints what a preset costs at low and at high quality; whether low takes less than a quarter.
fn qualities(gpu: &Gpu, name: &str) -> Result<bool, Error> {
    let made = |quality: &str| {
        let mut preset = Preset::named(name)?;
        preset.set(&format!("quality={quality}"))?;
        let shader = compose(&Library::standard(), &preset, &Bake::constants())?;
        frame(gpu, &shader, &preset, (32, 18), 1)?; // compiles: drivers keep that from one picture to the next
        Ok::<_, Error>((preset, shader))
    };
    let (low, high) = (made("low")?, made("high")?);
    // In turn, and the least of each: what else the machine does only adds.
    let mut spent = [f64::INFINITY; 2];
    for _ in 0..COMPARED_ROUNDS {
        for (spent, ((preset, shader), frames)) in spent.iter_mut().zip([(&low, 8), (&high, 2)]) {
            *spent = spent.min(frame(gpu, shader, preset, COMPARED, frames)?);
        }
    }
    let [low, high] = spent;
    let keeps = low < MOST_OF_HIGH * high;
    let verdict = if keeps { "" } else { "  ABOVE THE BAR" };
    println!("  {name:<20}{low:>9.3}{high:>9.3}{:>8.2}{verdict}", low / high);
    Ok(keeps)
}

/// Prints the table of a preset; whether every row keeps the bar.
fn measure(gpu: &Gpu, name: &str) -> Result<bool, Error> {
    let clock = if gpu.is_software() { "CPU seconds" } else { "seconds" };
    println!("{name} at quality high on {}: {clock} a frame\n", gpu.name());
    print!("  {:<14}", "with");
    for (width, height) in SIZES {
        print!("{:>11}", format!("{width}×{height}"));
    }
    println!("{:>13}{:>9}{:>17}", "a megapixel", "R²", "the last alone");
    let mut rows: Vec<Line> = Vec::new();
    for count in 1..=ELEMENTS.len() {
        let mut preset = Preset::named(name)?;
        preset.set("quality=high")?;
        let (on, off) = ELEMENTS.split_at(count);
        let assignments =
            on.iter().flat_map(|element| element.on).chain(off.iter().flat_map(|element| element.off));
        assignments.into_iter().try_for_each(|assignment| preset.set(assignment))?;
        let shader = compose(&Library::standard(), &preset, &Bake::constants())?;
        let element = ELEMENTS[count - 1].name;
        print!("  {:<14}", if count == 1 { element.to_owned() } else { format!("+ {element}") });
        frame(gpu, &shader, &preset, (32, 18), 1)?; // compiles: drivers keep that from one picture to the next
        let mut points = Vec::new();
        for (width, height) in SIZES {
            let seconds = frame(gpu, &shader, &preset, (width, height), 1)?;
            print!("{seconds:>11.3}");
            points.push((f64::from(width * height) / 1e6, seconds));
        }
        let line = Line::through(&points);
        let own = line.slope - rows.last().map_or(0.0, |before| before.slope);
        let keeps = line.r2 >= LEAST_R2;
        let verdict = if keeps { "" } else { "  BELOW THE BAR" };
        println!("{:>13.3}{:>9.4}{own:>17.3}{verdict}", line.slope, line.r2);
        rows.push(line);
    }
    let whole = rows.last().map_or(0.0, |line| line.slope);
    println!("\n  of the whole: {}\n", shares(&rows, whole).join(", "));
    Ok(rows.iter().all(|line| line.r2 >= LEAST_R2))
}

/// `terrain 61 %`, …
fn shares(rows: &[Line], whole: f64) -> Vec<String> {
    let mut before = 0.0;
    let share = |(element, line): (&Element, &Line)| {
        let own = line.slope - std::mem::replace(&mut before, line.slope);
        format!("{} {:.0} %", element.name, 100.0 * own / whole)
    };
    ELEMENTS.iter().zip(rows).map(share).collect()
}

/// Seconds that one more frame takes, the mean of `frames`.
fn frame(
    gpu: &Gpu,
    shader: &Shader,
    preset: &Preset,
    (width, height): (u32, u32),
    frames: u32,
) -> Result<f64, Error> {
    let draw = |samples| {
        let shot = Shot { samples, ..Shot::new(width, height) };
        let (cpu, clock) = (ProcessTime::now(), Instant::now());
        render(gpu, shader, preset, &shot, &mut |_, _| {})?;
        let spent = if gpu.is_software() { cpu.elapsed() } else { clock.elapsed() };
        Ok::<f64, Error>(spent.as_secs_f64())
    };
    let once = draw(1)?;
    Ok((draw(1 + frames)? - once) / f64::from(frames))
}

/// A line of least squares.
struct Line {
    slope: f64,
    /// The part of the variance that the line explains.
    r2: f64,
}

impl Line {
    fn through(points: &[(f64, f64)]) -> Self {
        let count = points.len() as f64;
        let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
        let (x, y) = (mean(|point| point.0), mean(|point| point.1));
        let sum = |of: &dyn Fn(f64, f64) -> f64| points.iter().map(|p| of(p.0 - x, p.1 - y)).sum::<f64>();
        let slope = sum(&|dx, dy| dx * dy) / sum(&|dx, _| dx * dx);
        let left = sum(&|dx, dy| (dy - slope * dx).powi(2));
        Self { slope, r2: 1.0 - left / sum(&|_, dy| dy * dy) }
    }
}
