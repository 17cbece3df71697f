//! Clouds: the library's march against a plain one in even steps, on the same layer, held against a march of 512 steps
//! with 32 toward the light from each.
//!
//! Four pictures of 480x270, of which every fourth pixel of every fourth row is taken (`--full`: all). `evals` are
//! evaluations of the density a ray, those toward the light included. The plain march skips nothing along the ray, but
//! marches toward the light only from where there is cloud, or it would be worse off than it need be (from everywhere it
//! is 64 + 64 · 12 a ray). PSNR is over the three channels, of linear radiance cut at 1 and of display values
//! (1 - e^(-1.2 x), then sRGB). The bars are in display values, as pictures are compared: at a quarter of the plain march's
//! evaluations as near to the reference as that one; at as many evaluations 40 dB. Linear radiance, which shows little but
//! the brightest edges, is told.
//! Steps are jittered only in the rows that say so, there each pixel's by its own number. Times are the process's CPU
//! time, as lavapipe runs on the CPU, without compiling.

#![allow(clippy::print_stdout, missing_docs, reason = "a bench prints its table")]

use cpu_time::ProcessTime;
use orogen::render::Gpu;
use orogen::render::sample::{Column, Points, Query, Scalar, evaluate};
use orogen::{Error, Library, Preset, Templates};

const WIDTH: usize = 480;
const HEIGHT: usize = 270;
const LENS: f64 = 50.0;
const REFERENCE: (i32, i32) = (512, 32);
const PLAIN: (i32, i32) = (64, 12);
/// Steps of the reference that one invocation takes: lavapipe ends loops at 65,535 turns in all, the density's included.
const SLICE: i32 = 64;
/// How many times more the rays are marched for the time.
const TIMES: usize = 2;
const EQUAL_BAR: f64 = 40.0;

struct Scene {
    name: &'static str,
    clouds: &'static [&'static str],
    height: f64,
    pitch: f64,
}

const CUMULUS: &[&str] = &["clouds.coverage=0.14", "sun.elevation=35", "sun.azimuth=60"];
const STRATOCUMULUS: &[&str] = &[
    "clouds.coverage=0.4",
    "clouds.type=0.5",
    "clouds.variety=0.2",
    "clouds.thickness=1400",
    "clouds.scale=1800",
    "sun.elevation=35",
    "sun.azimuth=60",
];
const SCENES: [Scene; 4] = [
    Scene { name: "scattered cumulus from below", clouds: CUMULUS, height: 2.0, pitch: 14.0 },
    Scene { name: "scattered cumulus from above", clouds: CUMULUS, height: 4200.0, pitch: -24.0 },
    Scene { name: "broken stratocumulus from below", clouds: STRATOCUMULUS, height: 2.0, pitch: 16.0 },
    Scene { name: "broken stratocumulus from above", clouds: STRATOCUMULUS, height: 3500.0, pitch: -28.0 },
];

/// Settings of our march, from the fastest on: part, light_part, light_samples, probe, growth, shortest, max_steps,
/// opaque.
#[derive(Debug, Clone, Copy)]
struct Setting {
    name: &'static str,
    part: f32,
    light_part: f32,
    light_samples: i32,
    probe: f32,
    growth: f32,
    shortest: f32,
    max_steps: i32,
    opaque: f32,
}

#[rustfmt::skip]
const SETTINGS: [Setting; 7] = [
    Setting { name: "a", part: 0.5, light_part: 1.0, light_samples: 8, probe: 60.0, growth: 0.01, shortest: 12.0, max_steps: 64, opaque: 0.06 },
    Setting { name: "b", part: 0.4, light_part: 1.0, light_samples: 9, probe: 48.0, growth: 0.0095, shortest: 7.5, max_steps: 64, opaque: 0.055 },
    Setting { name: "c", part: 0.2, light_part: 0.5, light_samples: 8, probe: 45.0, growth: 0.007, shortest: 4.0, max_steps: 96, opaque: 0.02 },
    Setting { name: "d", part: 0.2, light_part: 0.5, light_samples: 10, probe: 34.0, growth: 0.005, shortest: 4.0, max_steps: 128, opaque: 0.02 },
    Setting { name: "e", part: 0.2, light_part: 0.5, light_samples: 10, probe: 30.0, growth: 0.004, shortest: 4.0, max_steps: 128, opaque: 0.02 },
    Setting { name: "f", part: 0.1, light_part: 0.25, light_samples: 12, probe: 25.0, growth: 0.003, shortest: 3.0, max_steps: 192, opaque: 0.01 },
    Setting { name: "g", part: 0.1, light_part: 0.2, light_samples: 16, probe: 18.0, growth: 0.0016, shortest: 2.0, max_steps: 256, opaque: 0.004 },
];

/// What of a picture is drawn.
struct Ray {
    direction: [f64; 3],
    /// Interleaved gradient noise of its pixel.
    noise: f64,
}

/// What one contestant saw.
struct Outcome {
    picture: Vec<[f64; 3]>,
    steps: f64,
    evaluations: f64,
    milliseconds: f64,
}

struct Bench {
    gpu: Gpu,
    library: Library,
    templates: Templates,
    /// Every so many pixels one is drawn, each way.
    every: usize,
}

fn main() -> Result<(), String> {
    let told = |error: Error| error.render(false);
    let full = std::env::args().any(|argument| argument == "--full");
    let text = include_str!("march.wgsl");
    let bench = Bench {
        gpu: Gpu::new(None).map_err(told)?,
        library: Library::standard().with_file("bench/march.wgsl", text),
        templates: Templates::standard(),
        every: if full { 1 } else { 4 },
    };
    let mut holds = true;
    for scene in &SCENES {
        holds &= bench.scene(scene).map_err(told)?;
    }
    if holds { Ok(()) } else { Err("a scene is below its bar".to_owned()) }
}

impl Bench {
    /// Prints the table of a scene; whether it keeps the bars.
    fn scene(&self, scene: &Scene) -> Result<bool, Error> {
        let rays = scene.rays(self.every);
        println!("{}: {} of {WIDTH}x{HEIGHT} pixels\n", scene.name, rays.len());
        println!(
            "  {:<44}{:>8}{:>10}{:>12}{:>14}{:>15}",
            "", "steps", "evals", "CPU ms", "PSNR linear", "PSNR display"
        );
        let reference = self.plain(scene, &rays, REFERENCE, false)?;
        row("reference, 512 x 32", &reference, None);
        let plain = self.plain(scene, &rays, PLAIN, false)?;
        let bar = psnr(&plain, &reference);
        row("plain, 64 x 12", &plain, Some(bar));
        let jittered = self.plain(scene, &rays, PLAIN, true)?;
        row("plain, 64 x 12, jittered", &jittered, Some(psnr(&jittered, &reference)));
        let mut ours = Vec::new();
        for setting in &SETTINGS {
            let outcome = self.ours(scene, &rays, setting, false)?;
            let quality = psnr(&outcome, &reference);
            row(&setting.text(), &outcome, Some(quality));
            ours.push((outcome, quality));
        }
        let middle = &SETTINGS[3];
        let outcome = self.ours(scene, &rays, middle, true)?;
        row(&format!("{}, jittered", middle.name), &outcome, Some(psnr(&outcome, &reference)));
        // Of those that do not ask more often than the plain march times `part`, the one nearest to the reference.
        let best = |part: f64| {
            ours.iter()
                .filter(|(outcome, _)| outcome.evaluations <= part * plain.evaluations)
                .map(|(outcome, quality)| (outcome.evaluations / plain.evaluations, *quality))
                .max_by(|(_, one), (_, other)| one.1.total_cmp(&other.1))
        };
        let quarter = best(0.25).is_some_and(|(_, (_, display))| display >= bar.1);
        let equal = best(1.0).is_some_and(|(_, (_, display))| display >= EQUAL_BAR);
        let said = |holds: bool| if holds { "ok" } else { "BELOW THE BAR" };
        if let Some((part, (linear, display))) = best(0.25) {
            println!(
                "\n  At {part:.3} of the plain march's evaluations {linear:.1} and {display:.1} dB against {:.1} and {:.1}  {}",
                bar.0,
                bar.1,
                said(quarter)
            );
        }
        if let Some((part, (linear, display))) = best(1.0) {
            println!(
                "  At {part:.3} of them {linear:.1} and {display:.1} dB, the latter against {EQUAL_BAR}  {}",
                said(equal)
            );
        }
        println!();
        Ok(quarter && equal)
    }

    fn ours(&self, scene: &Scene, rays: &[Ray], setting: &Setting, jitter: bool) -> Result<Outcome, Error> {
        let Setting { part, light_part, light_samples, probe, growth, shortest, max_steps, opaque, .. } =
            *setting;
        let march = format!(
            "bench_ours({}, vec3f(dx, dy, dz), jitter, ours_Volume({part:?}, {light_part:?}, {light_samples}, {probe:?}, \
             {growth:?}, {shortest:?}, {max_steps}, {opaque:?}, {:?}))",
            scene.origin(),
            pixel_angle()
        );
        let points = |rays: &[Ray]| rays.iter().flat_map(|ray| ray.scalars(jitter)).collect();
        let (rows, milliseconds) =
            self.timed(scene, &march, &["dx", "dy", "dz", "jitter"], rays, points, TIMES)?;
        Ok(outcome(rays, &rows, milliseconds))
    }

    /// The plain march, in slices that are put together here.
    fn plain(
        &self,
        scene: &Scene,
        rays: &[Ray],
        (steps, lights): (i32, i32),
        jitter: bool,
    ) -> Result<Outcome, Error> {
        let slice = SLICE.min(steps);
        let times = if steps == PLAIN.0 { TIMES } else { 0 }; // the reference is not timed: it would take minutes
        let march = format!(
            "bench_plain({}, vec3f(dx, dy, dz), jitter, {:?}, start, {slice}, {steps}, {lights})",
            scene.origin(),
            pixel_angle()
        );
        let mut whole = vec![[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]; rays.len()];
        let mut milliseconds = 0.0;
        for start in (0..steps).step_by(slice as usize) {
            let points = |rays: &[Ray]| {
                let scalars = |ray: &Ray| ray.scalars(jitter).into_iter().chain([Scalar::I32(start)]);
                rays.iter().flat_map(scalars).collect()
            };
            let columns = ["dx", "dy", "dz", "jitter", "start:i32"];
            let (rows, spent) = self.timed(scene, &march, &columns, rays, points, times)?;
            milliseconds += spent;
            for (whole, row) in whole.iter_mut().zip(&rows) {
                for channel in 0..3 {
                    whole[channel] += whole[3] * row[channel];
                }
                whole[3] *= row[3];
                whole[5] += row[5];
                whole[6] += row[6];
            }
        }
        let rows: Vec<Vec<f64>> = whole.iter().map(|row| row.to_vec()).collect();
        Ok(outcome(rays, &rows, milliseconds))
    }

    /// The numbers of each ray, and the CPU time they took (ms): what more of the same rays took, so that compiling and the
    /// way over the bus at its start do not count.
    fn timed(
        &self,
        scene: &Scene,
        march: &str,
        columns: &[&str],
        rays: &[Ray],
        points: impl Fn(&[Ray]) -> Vec<Scalar>,
        times: usize,
    ) -> Result<(Vec<Vec<f64>>, f64), Error> {
        let mut preset = Preset::parse(
            "bench.json",
            r#"{ "orogen": 1, "about": "", "scene": "bench/march.wgsl", "set": { "quality": "high" } }"#,
        )?;
        for assignment in scene.clouds {
            preset.set(assignment)?;
        }
        let columns = columns.iter().map(|name| Column::parse(name)).collect::<Result<Vec<_>, _>>()?;
        let includes = ["<bench/march.wgsl>".to_owned()];
        let once: Vec<Scalar> = points(rays);
        let run = |times: usize| {
            let points = Points { columns: columns.clone(), values: once.repeat(times) };
            let query =
                Query { expression: march, includes: &includes, preset: Some(&preset), points: &points };
            let start = ProcessTime::now();
            let table = evaluate(&self.gpu, &self.library, &self.templates, &query)?;
            let spent = start.elapsed().as_secs_f64() * 1e3;
            Ok::<_, Error>((
                table.rows().map(|row| row.iter().copied().map(number).collect()).collect(),
                spent,
            ))
        };
        let (rows, _): (Vec<Vec<f64>>, f64) = run(1)?; // compiles it
        if times == 0 {
            return Ok((rows, 0.0));
        }
        let (_, first) = run(1)?;
        let (_, many) = run(1 + times)?;
        Ok((rows, (many - first) / times as f64))
    }
}

impl Scene {
    fn origin(&self) -> String {
        format!("vec3f(0.0, {:?}, 0.0)", self.height)
    }

    /// Through the middle of every so many pixels, looking north.
    fn rays(&self, every: usize) -> Vec<Ray> {
        let (sin, cos) = self.pitch.to_radians().sin_cos();
        let scale = 2.0 * (0.5 * LENS.to_radians()).tan() / HEIGHT as f64;
        let mut rays = Vec::new();
        for row in (every / 2..HEIGHT).step_by(every) {
            for column in (every / 2..WIDTH).step_by(every) {
                let (x, y) = (column as f64, row as f64);
                let u = (x + 0.5 - 0.5 * WIDTH as f64) * scale;
                let v = (y + 0.5 - 0.5 * HEIGHT as f64) * scale;
                let ray = [u, sin + v * cos, v * sin - cos];
                let length = ray.iter().map(|axis| axis * axis).sum::<f64>().sqrt();
                let noise = (52.982_918_9 * (0.067_110_56 * x + 0.005_837_15 * y).fract()).fract();
                rays.push(Ray { direction: ray.map(|axis| axis / length), noise });
            }
        }
        rays
    }
}

impl Ray {
    fn scalars(&self, jitter: bool) -> [Scalar; 4] {
        let [x, y, z] = self.direction;
        [x, y, z, if jitter { self.noise } else { 0.5 }].map(|number| Scalar::F32(number as f32))
    }
}

impl Setting {
    fn text(&self) -> String {
        let Self { name, part, light_part, light_samples, probe, growth, shortest, max_steps, opaque } =
            *self;
        format!(
            "{name}: {part} {light_part} {light_samples} {probe} {growth} {shortest} {max_steps} {opaque}"
        )
    }
}

fn pixel_angle() -> f64 {
    2.0 * (0.5 * LENS.to_radians()).tan() / HEIGHT as f64
}

/// Rows are radiance by sun, sky and ground, transmittance, distance, steps and evaluations.
fn outcome(rays: &[Ray], rows: &[Vec<f64>], milliseconds: f64) -> Outcome {
    // Of the sunlit cloud about 1; a blue sky behind, a dark sea below.
    const LIGHTS: [[f64; 3]; 3] = [[6.0, 5.64, 5.1], [0.58, 0.81, 1.26], [0.3, 0.33, 0.27]];
    let pixel = |(row, ray): (&Vec<f64>, &Ray)| {
        let up = ray.direction[1];
        let near_horizon = (1.0 - up.clamp(0.0, 1.0)).powi(3);
        [0, 1, 2].map(|channel| {
            let sky = [0.25, 0.42, 0.8][channel] * near_horizon
                + [0.12, 0.25, 0.62][channel] * (1.0 - near_horizon);
            let behind = if up < 0.0 { [0.06, 0.08, 0.1][channel] } else { sky };
            let cloud: f64 = LIGHTS.iter().zip(row).map(|(light, part)| light[channel] * part).sum();
            cloud + row[3] * behind
        })
    };
    let mean = |column: usize| rows.iter().map(|row| row[column]).sum::<f64>() / rows.len() as f64;
    Outcome {
        picture: rows.iter().zip(rays).map(pixel).collect(),
        steps: mean(5),
        evaluations: mean(6),
        milliseconds,
    }
}

/// Of linear radiance and of display values (dB).
fn psnr(one: &Outcome, other: &Outcome) -> (f64, f64) {
    let linear = |radiance: f64| radiance.clamp(0.0, 1.0);
    let display = |radiance: f64| {
        let light = 1.0 - (-1.2 * radiance.max(0.0)).exp();
        if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
    };
    let decibels = |shown: &dyn Fn(f64) -> f64| {
        let pairs = one.picture.as_flattened().iter().zip(other.picture.as_flattened());
        let sum: f64 = pairs.map(|(one, other)| (shown(*one) - shown(*other)).powi(2)).sum();
        -10.0 * (sum / (3 * one.picture.len()) as f64).log10()
    };
    (decibels(&linear), decibels(&display))
}

fn row(what: &str, outcome: &Outcome, quality: Option<(f64, f64)>) {
    let Outcome { steps, evaluations, milliseconds, .. } = outcome;
    let time = if *milliseconds > 0.0 { format!("{milliseconds:.0}") } else { "-".to_owned() };
    print!("  {what:<44}{steps:>8.1}{evaluations:>10.1}{time:>12}");
    match quality {
        Some((linear, display)) => println!("{linear:>14.1}{display:>15.1}"),
        None => println!(),
    }
}

fn number(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F32(value) => f64::from(value),
        Scalar::I32(value) => f64::from(value),
        Scalar::U32(value) => f64::from(value),
        Scalar::Bool(value) => f64::from(u8::from(value)),
    }
}
