//! Marches over heightfields: errors, misses and noise evaluations a ray on the GPU, against dense f64 truth.
//!
//! First the experiments over the adaptive march's step (a + b · distance + c · height above ground, k bisections): each of
//! the four alone, around one setting. Then the adaptive march at the best of many settings that misses nothing, against
//! the bounded march, which cannot miss, at the same error. Contestants that are timed take turns; times are the
//! process's CPU time, as lavapipe runs on the CPU, per ray and without compiling.

#![allow(clippy::print_stdout, missing_docs, reason = "a bench prints its table")]

use cpu_time::ProcessTime;
use orogen::render::Gpu;
use orogen::render::sample::{Column, Points, Query, Scalar, evaluate};
use orogen::{Error, Library, Templates};
use truth::march::{Errors, FAR, RELIEFS, Ray, Relief};

const SIDE: usize = 64;
const ROUNDS: usize = 5;
/// Settings that go over the bus at once.
const BATCH: usize = 128;

/// Of the adaptive march.
#[derive(Debug, Clone, Copy)]
struct Setting {
    a: f32,
    b: f32,
    c: f32,
    k: i32,
}

/// What a march did on all rays of a land.
#[derive(Debug, Clone, Copy)]
struct Outcome {
    errors: Errors,
    /// Octaves a ray.
    octaves: f64,
}

struct Bench {
    gpu: Gpu,
    library: Library,
    templates: Templates,
}

/// A land, the rays of its picture, and where they meet it.
struct Scene {
    relief: Relief,
    rays: Vec<Ray>,
    crossings: Vec<Option<f64>>,
}

fn main() -> Result<(), String> {
    let told = |error: Error| error.render(false);
    let bench = Bench {
        gpu: Gpu::new(None).map_err(told)?,
        library: Library::standard(),
        templates: Templates::standard(),
    };
    let mut holds = true;
    for relief in RELIEFS {
        let rays = relief.rays(SIDE);
        let crossings: Vec<_> = rays.iter().map(|ray| relief.first_crossing(ray, FAR)).collect();
        let hits = crossings.iter().flatten().count();
        println!(
            "{}: {} octaves of gain {}, {hits} of {} rays meet the land\n",
            relief.name,
            relief.octaves,
            relief.gain,
            rays.len()
        );
        holds &= bench.scene(&Scene { relief, rays, crossings }).map_err(told)?;
    }
    if holds { Ok(()) } else { Err("a row is above its bar".to_owned()) }
}

impl Bench {
    /// Prints the tables of a scene; whether every row of the comparison keeps the bar.
    fn scene(&self, scene: &Scene) -> Result<bool, Error> {
        println!("The four experiments: one of a, b, c, k at a time, the others as in the first row");
        heading("a (m)     b       c     k");
        let middle = Setting { a: 1.0, b: 0.001, c: 0.6, k: 4 };
        let mut rows = vec![middle];
        rows.extend([0.1, 0.5, 2.0, 5.0, 10.0, 20.0].map(|a| Setting { a, ..middle }));
        rows.extend([0.0, 0.003, 0.01, 0.02, 0.05].map(|b| Setting { b, ..middle }));
        rows.extend([0.2, 0.4, 0.8, 1.0, 1.5].map(|c| Setting { c, ..middle }));
        rows.extend([0, 2, 6, 8, 12].map(|k| Setting { k, ..middle }));
        for (setting, outcome) in rows.iter().zip(self.adaptive(scene, &rows)?) {
            row(&setting.text(), &outcome);
        }

        let mut settings = Vec::new();
        for a in [0.1, 0.5, 1.0, 2.0, 4.0, 8.0] {
            for b in [0.0, 0.001, 0.003, 0.006, 0.01] {
                for c in [0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2] {
                    settings.extend([0, 2, 4, 7, 10].map(|k| Setting { a, b, c, k }));
                }
            }
        }
        let adaptive = self.adaptive(scene, &settings)?;
        let safe = || adaptive.iter().zip(&settings).filter(|(outcome, _)| outcome.errors.missed == 0);
        let tolerances = [0.5_f32, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005];
        println!("\nBounded, by tolerance");
        heading("m");
        let mut bounded = Vec::new();
        for tolerance in tolerances {
            let outcome = self.bounded(scene, tolerance)?;
            row(&format!("{tolerance}"), &outcome);
            bounded.push((tolerance, outcome));
        }
        println!(
            "\nAdaptive at the best of {} settings of which {} miss nothing, and bounded, at the same IDE p95",
            settings.len(),
            safe().count()
        );
        println!(
            "{:>9}{:>30}{:>10}{:>10}{:>12}{:>10}{:>9}{:>12}{:>12}{:>9}",
            "IDE ≤ m",
            "a, b, c, k",
            "octaves",
            "IDE",
            "tolerance",
            "octaves",
            "ratio",
            "adapt. ns",
            "bounded ns",
            "ratio"
        );
        let mut holds = true;
        for level in [0.3, 0.1, 0.03, 0.01] {
            let best = safe()
                .filter(|(outcome, _)| outcome.errors.ide95 <= level)
                .min_by(|(one, _), (other, _)| one.octaves.total_cmp(&other.octaves));
            // As exact as the adaptive march is there, not only as the level asks.
            let Some((outcome, setting)) = best else {
                println!("{level:>9}  no setting of the adaptive march misses nothing and is as exact");
                continue;
            };
            let equal = |(_, bounded): &&(f32, Outcome)| {
                bounded.errors.missed == 0 && bounded.errors.ide95 <= outcome.errors.ide95
            };
            let Some((tolerance, ours)) = bounded.iter().find(equal) else {
                println!("{level:>9}  no tolerance of the bounded march is as exact");
                holds = false;
                continue;
            };
            let (slow, fast) = self.times(scene, *setting, *tolerance)?;
            let (fewer, faster) = (ours.octaves / outcome.octaves, fast / slow);
            let keeps = fewer <= 0.5 && faster < 1.0;
            holds &= keeps;
            println!(
                "{level:>9}{:>30}{:>10.1}{:>10.4}{tolerance:>12}{:>10.1}{fewer:>9.2}{slow:>12.0}{fast:>12.0}{faster:>9.2}{}",
                setting.text(),
                outcome.octaves,
                outcome.errors.ide95,
                ours.octaves,
                if keeps { "  ok" } else { "  ABOVE THE BAR (.50, 1)" }
            );
        }
        println!();
        Ok(holds)
    }

    /// The adaptive march at each of `settings`.
    fn adaptive(&self, scene: &Scene, settings: &[Setting]) -> Result<Vec<Outcome>, Error> {
        let ceiling = scene.relief.ceiling();
        let march = format!(
            "adaptive_march(p, vec3f(dx, dy, dz), {ceiling:?}, {FAR:?}, adaptive_Adaptive(a, b, c, 3000, k, 0.0))"
        );
        let mut outcomes = Vec::new();
        for batch in settings.chunks(BATCH) {
            let mut values = Vec::new();
            for setting in batch {
                let tail = [setting.a, setting.b, setting.c].map(Scalar::F32);
                for ray in &scene.rays {
                    values.extend(ray.numbers().map(Scalar::F32));
                    values.extend(tail);
                    values.push(Scalar::I32(setting.k));
                }
            }
            let columns = ["x", "y", "z", "dx", "dy", "dz", "a", "b", "c", "k:i32"];
            let rows = self.rows(scene, &march, &columns, values)?;
            let octaves = scene.relief.octaves as f64;
            outcomes.extend(rows.chunks(scene.rays.len()).map(|rows| outcome(scene, rows, octaves)));
        }
        Ok(outcomes)
    }

    fn bounded(&self, scene: &Scene, tolerance: f32) -> Result<Outcome, Error> {
        let march =
            format!("bounded_march(p, vec3f(dx, dy, dz), 0.0, {FAR:?}, relief_bounded({tolerance:?}, 0.0))");
        let rows = self.rows(scene, &march, &RAY, numbers(&scene.rays))?;
        Ok(outcome(scene, &rows, 1.0))
    }

    /// Nanoseconds a ray of the adaptive and of the bounded march.
    fn times(&self, scene: &Scene, setting: Setting, tolerance: f32) -> Result<(f64, f64), Error> {
        const MANY: i32 = 33;
        let Setting { a, b, c, k } = setting;
        let ceiling = scene.relief.ceiling();
        let ray = "p, vec3f(dx, dy, dz)";
        let adaptive = format!(
            "repeat_adaptive({ray}, {FAR:?}, {ceiling:?}, adaptive_Adaptive({a:?}, {b:?}, {c:?}, 3000, {k}, 0.0), times)"
        );
        let bounded = format!("repeat_bounded({ray}, {FAR:?}, relief_bounded({tolerance:?}, 0.0), times)");
        let mut spent = [Vec::new(), Vec::new()];
        for _ in 0..ROUNDS {
            for (march, spent) in [&adaptive, &bounded].into_iter().zip(&mut spent) {
                let time = |times: i32| {
                    let values = scene.rays.iter().flat_map(|ray| {
                        ray.numbers().map(Scalar::F32).into_iter().chain([Scalar::I32(times)])
                    });
                    let columns = ["x", "y", "z", "dx", "dy", "dz", "times:i32"];
                    let values = values.collect();
                    let start = ProcessTime::now();
                    self.rows(scene, march, &columns, values)?;
                    Ok::<f64, Error>(start.elapsed().as_secs_f64())
                };
                let (once, many) = (time(1)?, time(MANY)?);
                spent.push((many - once) * 1e9 / f64::from(MANY - 1) / scene.rays.len() as f64);
            }
        }
        let [adaptive, bounded] = spent.map(median);
        Ok((adaptive, bounded))
    }

    /// The numbers of each value of an expression over the land.
    fn rows(
        &self,
        scene: &Scene,
        expression: &str,
        columns: &[&str],
        values: Vec<Scalar>,
    ) -> Result<Vec<Vec<f64>>, Error> {
        let columns = columns.iter().map(|name| Column::parse(name)).collect::<Result<_, _>>()?;
        let text = format!("{}{}", scene.relief.wgsl(), include_str!("repeat.wgsl"));
        let library = self.library.clone().with_file("bench/relief.wgsl", text);
        let includes = ["<bench/relief.wgsl>".to_owned()];
        let points = Points { columns, values };
        let query = Query { expression, includes: &includes, preset: None, points: &points };
        let table = evaluate(&self.gpu, &library, &self.templates, &query)?;
        Ok(table.rows().map(|row| row.iter().copied().map(number).collect()).collect())
    }
}

const RAY: [&str; 6] = ["x", "y", "z", "dx", "dy", "dz"];

impl Setting {
    fn text(&self) -> String {
        format!("{:<6}{:>7}{:>7}{:>5}", self.a, self.b, self.c, self.k)
    }
}

fn numbers(rays: &[Ray]) -> Vec<Scalar> {
    rays.iter().flat_map(|ray| ray.numbers().map(Scalar::F32)).collect()
}

/// `rows`: distance, hit, steps, evaluations of each ray; `octaves`: of each evaluation.
fn outcome(scene: &Scene, rows: &[Vec<f64>], octaves: f64) -> Outcome {
    let hits: Vec<Option<f64>> = rows.iter().map(|row| (row[1] != 0.0).then_some(row[0])).collect();
    Outcome {
        errors: Errors::of(&scene.relief, &scene.rays, &scene.crossings, &hits),
        octaves: octaves * rows.iter().map(|row| row[3]).sum::<f64>() / rows.len() as f64,
    }
}

fn heading(what: &str) {
    println!(
        "  {what:<28}{:>8}{:>9}{:>11}{:>11}{:>11}{:>11}",
        "missed", "phantom", "IDE p50", "IDE p95", "HDE p95", "octaves"
    );
}

fn row(what: &str, outcome: &Outcome) {
    let Outcome { errors, octaves } = outcome;
    println!(
        "  {what:<28}{:>8}{:>9}{:>11.4}{:>11.4}{:>11.4}{octaves:>11.1}",
        errors.missed, errors.phantoms, errors.ide50, errors.ide95, errors.hde95
    );
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn number(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F32(value) => f64::from(value),
        Scalar::I32(value) => f64::from(value),
        Scalar::U32(value) => f64::from(value),
        Scalar::Bool(value) => f64::from(u8::from(value)),
    }
}
