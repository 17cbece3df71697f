//! Part 3: what a value of noise costs, ours beside others', on the GPU and on the CPU.
//!
//! On the GPU each invocation asks for many values, at places that follow from one another so that none can be left out, and an
//! empty shader's time is taken off.

use fastnoise_lite::{CellularDistanceFunction, CellularReturnType, FastNoiseLite, NoiseType};
use noise::NoiseFn;
use orogen::{Bake, Library, Preset, compose};

use super::gpu::{Lab, Program};
use super::packages;
use crate::Outcome;
use crate::contest::number;
use crate::page::{Section, table};
use crate::time::{quartiles, timed};

pub(crate) const TITLE: &str = "Noise";

const CALLS: u32 = 64;
const WORKGROUP: u32 = 64;
const ROUNDS: usize = 9;

/// Where a contestant's WGSL is from.
#[derive(Clone, Copy)]
enum From {
    /// The fragment of ours to include.
    Ours(&'static str),
    /// The crate `noisy_bevy`.
    NoisyBevy,
    /// A file of npm's `wgsl-noise`.
    WgslNoise(&'static str),
}

/// One way to make one noise.
struct Way {
    from: From,
    /// What is called; `p` is the place.
    call: &'static str,
    /// A number out of all of what came back, `found`.
    read: &'static str,
    /// What it offers.
    features: &'static str,
}

/// A noise and who makes it; ours, plain, comes first.
struct Noise {
    name: &'static str,
    dimension: usize,
    ways: &'static [Way],
}

const SEEDED: &str = "value; any seed, does not repeat, bounds proven";
const GRADIENT: &str = "value and gradient; any seed, does not repeat, bounds proven";
const PERIODIC: &str = "value; one seed, repeats after 289";
const FLOAT_SEED: &str = "value; seed added to a permutation, repeats after 289";

const NOISES: [Noise; 8] = [
    Noise {
        name: "value, plane",
        dimension: 2,
        ways: &[
            Way {
                from: From::Ours("noise/value.wgsl"),
                call: "value_noise2(p, 1u)",
                read: "found",
                features: SEEDED,
            },
            Way {
                from: From::Ours("noise/value.wgsl"),
                call: "value_noise2_grad(p, 1u)",
                read: "dot(found, vec3f(1.0, 0.3, 0.7))",
                features: GRADIENT,
            },
        ],
    },
    Noise {
        name: "value, space",
        dimension: 3,
        ways: &[
            Way {
                from: From::Ours("noise/value.wgsl"),
                call: "value_noise3(p, 1u)",
                read: "found",
                features: SEEDED,
            },
            Way {
                from: From::Ours("noise/value.wgsl"),
                call: "value_noise3_grad(p, 1u)",
                read: "dot(found, vec4f(1.0, 0.3, 0.7, 0.2))",
                features: GRADIENT,
            },
        ],
    },
    Noise {
        name: "Perlin, plane",
        dimension: 2,
        ways: &[
            Way {
                from: From::Ours("noise/perlin.wgsl"),
                call: "perlin_noise2(p, 1u)",
                read: "found",
                features: SEEDED,
            },
            Way {
                from: From::Ours("noise/perlin.wgsl"),
                call: "perlin_noise2_grad(p, 1u)",
                read: "dot(found, vec3f(1.0, 0.3, 0.7))",
                features: GRADIENT,
            },
            Way {
                from: From::WgslNoise("Classic/cnoise2D.wgsl"),
                call: "cnoise2D(p)",
                read: "found",
                features: PERIODIC,
            },
        ],
    },
    Noise {
        name: "Perlin, space",
        dimension: 3,
        ways: &[
            Way {
                from: From::Ours("noise/perlin.wgsl"),
                call: "perlin_noise3(p, 1u)",
                read: "found",
                features: SEEDED,
            },
            Way {
                from: From::Ours("noise/perlin.wgsl"),
                call: "perlin_noise3_grad(p, 1u)",
                read: "dot(found, vec4f(1.0, 0.3, 0.7, 0.2))",
                features: GRADIENT,
            },
            Way {
                from: From::WgslNoise("Classic/cnoise3D.wgsl"),
                call: "cnoise3D(p)",
                read: "found",
                features: PERIODIC,
            },
        ],
    },
    Noise {
        name: "simplex, plane",
        dimension: 2,
        ways: &[
            Way {
                from: From::Ours("noise/simplex.wgsl"),
                call: "simplex_noise2(p, 1u)",
                read: "found",
                features: SEEDED,
            },
            Way {
                from: From::Ours("noise/simplex.wgsl"),
                call: "simplex_noise2_grad(p, 1u)",
                read: "dot(found, vec3f(1.0, 0.3, 0.7))",
                features: GRADIENT,
            },
            Way { from: From::NoisyBevy, call: "simplex_noise_2d(p)", read: "found", features: PERIODIC },
            Way {
                from: From::NoisyBevy,
                call: "simplex_noise_2d_seeded(p, 1.0)",
                read: "found",
                features: FLOAT_SEED,
            },
            Way {
                from: From::WgslNoise("Simplex/snoise2D.wgsl"),
                call: "snoise2D(p)",
                read: "found",
                features: PERIODIC,
            },
        ],
    },
    Noise {
        name: "simplex, space",
        dimension: 3,
        ways: &[
            Way {
                from: From::Ours("noise/simplex.wgsl"),
                call: "simplex_noise3(p, 1u)",
                read: "found",
                features: SEEDED,
            },
            Way {
                from: From::Ours("noise/simplex.wgsl"),
                call: "simplex_noise3_grad(p, 1u)",
                read: "dot(found, vec4f(1.0, 0.3, 0.7, 0.2))",
                features: GRADIENT,
            },
            Way { from: From::NoisyBevy, call: "simplex_noise_3d(p)", read: "found", features: PERIODIC },
            Way {
                from: From::NoisyBevy,
                call: "simplex_noise_3d_seeded(p, vec3f(1.0))",
                read: "found",
                features: FLOAT_SEED,
            },
            Way {
                from: From::WgslNoise("Simplex/snoise3D.wgsl"),
                call: "snoise3D(p)",
                read: "found",
                features: PERIODIC,
            },
            Way {
                from: From::WgslNoise("Simplex/snoise3Dgrad.wgsl"),
                call: "snoise3Dgrad(p)",
                read: "found",
                features: "value (the gradient is computed and not returned); one seed, repeats after 289",
            },
        ],
    },
    Noise {
        name: "Worley, plane",
        dimension: 2,
        ways: &[
            Way {
                from: From::Ours("noise/worley.wgsl"),
                call: "worley_noise2(p, 1u)",
                read: "found.f1 + 0.5 * found.f2",
                features: "both nearest, offset, cell; exact; any seed, does not repeat",
            },
            Way {
                from: From::NoisyBevy,
                call: "worley_2d(p, 1.0)",
                read: "dot(found, vec2f(1.0, 0.5))",
                features: "both nearest of 3×3 cells, which misses some; repeats",
            },
            Way {
                from: From::WgslNoise("Cellular/cellular2D.wgsl"),
                call: "cellular2D(p)",
                read: "dot(found, vec2f(1.0, 0.5))",
                features: "both nearest of 3×3 cells, which misses some; repeats after 289",
            },
        ],
    },
    Noise {
        name: "Worley, space",
        dimension: 3,
        ways: &[
            Way {
                from: From::Ours("noise/worley.wgsl"),
                call: "worley_noise3(p, 1u)",
                read: "found.f1 + 0.5 * found.f2",
                features: "both nearest, offset, cell; exact; any seed, does not repeat",
            },
            Way {
                from: From::WgslNoise("Cellular/cellular3D.wgsl"),
                call: "cellular3D(p)",
                read: "dot(found, vec2f(1.0, 0.5))",
                features: "both nearest of 3×3×3 cells, which misses some; repeats after 289",
            },
        ],
    },
];

const WHY: &str = "\
Bar: not slower than any with the same features. Nobody else here has them: an integer seed, no period, the gradient, and bounds that \
are proven and tested. Against noises that give less:

- Simplex noise in the plane is faster in both packages. Their polynomial `(34 x + 1) x mod 289` costs three operations on floats, and \
the price is the period of 289; ours is two rounds of PCG for each corner, whose 32-bit multiplications are slow on CPUs with AVX2 \
and cheap on GPUs. Their gradients are 41 points of a diamond, made nearly unit by a line through 1/√x; ours are unit vectors of any \
direction.
- Worley noise is faster in both packages since they look at 3×3 (×3) cells and stop: a nearest point further away is missed, which \
shows as edges. Ours goes on until nothing nearer can be, and also hands over which cell it was and the way there.
- Our plain noises are the value out of the one with gradient where the compiler can drop the rest.
";

pub(crate) fn measure(lab: &Lab) -> Outcome<Section> {
    let mut rows = Vec::new();
    for noise in &NOISES {
        eprintln!("noise: {}", noise.name);
        let times = on_gpu(lab, noise)?;
        let ours = times[0];
        for (way, time) in noise.ways.iter().zip(&times) {
            let whose = match way.from {
                From::Ours(_) => "**orogen**".to_owned(),
                From::NoisyBevy => "noisy_bevy".to_owned(),
                From::WgslNoise(_) => "wgsl-noise".to_owned(),
            };
            rows.push([
                noise.name.to_owned(),
                whose,
                way.features.to_owned(),
                number(*time),
                number(1e3 / time),
                format!("{:.2}", time / ours),
            ]);
        }
    }
    let on_cpu = on_cpu()?;
    let text = format!(
        "Nanoseconds a value on {}, {}, medians of {ROUNDS} runs that take turns; {CALLS} values an invocation, an empty shader's time \
         taken off. Others' WGSL comes from their packages (`noisy_bevy` {}, npm's `{}`) when this is measured. Nobody's noise here \
         is made of sines; theirs hash by a permutation polynomial in floats, ours by integers (PCG).\n\n{}\n{WHY}\n\
         ### On the CPU\n\n\
         Nanoseconds a value, one thread. Orogen has no noise on the CPU for hosts: `orogen eval` and `Sampler` run the WGSL, and \
         without a GPU on a software one; the tests' `truth` is written from definitions in f64, to be right and not to be fast.\n\n{}",
        lab.name,
        lab.clock(),
        packages::CRATE_VERSION,
        packages::NPM,
        table(["noise", "whose", "what it gives", "ns", "million/s", "to ours"], &rows),
        table(["noise", "whose", "ns", "million/s"], &on_cpu),
    );
    Ok(Section { title: TITLE, text })
}

/// Nanoseconds a value of each way.
fn on_gpu(lab: &Lab, noise: &Noise) -> Outcome<Vec<f64>> {
    let workgroups: u32 = if lab.software { 512 } else { 16_384 };
    let invocations = u64::from(workgroups * WORKGROUP);
    let mut programs =
        vec![Program::new(lab, &shader(noise.dimension, "", "p", "found.x + found.y"), invocations)?];
    for way in noise.ways {
        let text = match way.from {
            From::Ours(path) => {
                let scene = shader(noise.dimension, &format!("#include <{path}>\n"), way.call, way.read);
                let preset = Preset::of_text("noise.wgsl", &scene);
                compose(&Library::standard(), &preset, &Bake::constants())?.wgsl().to_owned()
            }
            From::NoisyBevy => {
                shader(noise.dimension, &packages::noisy_bevy("assets/noisy_bevy.wesl")?, way.call, way.read)
            }
            From::WgslNoise(file) => {
                shader(noise.dimension, &packages::wgsl_noise(file)?, way.call, way.read)
            }
        };
        programs.push(Program::new(lab, &text, invocations)?);
    }
    let mut times = vec![Vec::new(); programs.len()];
    for program in &programs {
        program.run(workgroups)?; // compiles
    }
    for _ in 0..ROUNDS {
        for (program, times) in programs.iter().zip(&mut times) {
            times.push(program.run(workgroups)?);
        }
    }
    let medians: Vec<f64> = times.into_iter().map(|times| quartiles(times.into_iter()).median).collect();
    let values = invocations as f64 * f64::from(CALLS);
    Ok(medians[1..].iter().map(|time| (time - medians[0]) * 1e6 / values).collect())
}

/// A shader that sums many values of what `call` gives and `read` reads, after `head`.
fn shader(dimension: usize, head: &str, call: &str, read: &str) -> String {
    let (start, step) = match dimension {
        2 => ("vec2f(f32(id.x) * 0.37, f32(id.x % 97u) * 0.11)", "vec2f(0.731, 0.477)"),
        _ => ("vec3f(f32(id.x) * 0.37, f32(id.x % 97u) * 0.11, 0.5)", "vec3f(0.731, 0.477, 0.613)"),
    };
    format!(
        "{head}\n@group(0) @binding(0) var<storage, read_write> result: array<f32>;\n\n\
         @compute @workgroup_size({WORKGROUP})\n\
         fn main(@builtin(global_invocation_id) id: vec3u) {{\n    var sum = 0.0;\n    var p = {start};\n    \
         for (var call = 0u; call < {CALLS}u; call += 1u) {{\n        let found = {call};\n        sum += {read};\n        p += {step};\n    }}\n    \
         result[id.x] = sum;\n}}\n"
    )
}

/// The same on the CPU: rows of a table.
fn on_cpu() -> Outcome<Vec<[String; 4]>> {
    let lite = |kind| {
        let mut lite = FastNoiseLite::with_seed(1);
        lite.set_frequency(Some(1.0));
        lite.set_noise_type(Some(kind));
        lite.set_cellular_distance_function(Some(CellularDistanceFunction::Euclidean));
        lite.set_cellular_return_type(Some(CellularReturnType::Distance));
        lite
    };
    let (value, perlin, simplex) =
        (lite(NoiseType::Value), lite(NoiseType::Perlin), lite(NoiseType::OpenSimplex2));
    let cellular = lite(NoiseType::Cellular);
    let (fields_value, fields_perlin) = (noise::Value::new(1), noise::Perlin::new(1));
    let (fields_simplex, fields_worley) = (noise::Simplex::new(1), noise::Worley::new(1));
    let of2 = |p: [f64; 3]| [p[0], p[1]];
    let f = |p: [f64; 3]| p.map(|x| x as f32);
    type Sample<'a> = Box<dyn Fn([f64; 3]) -> f64 + 'a>;
    let ways: Vec<(&str, &str, Sample<'_>)> = vec![
        (
            "value, space",
            "fastnoise-lite",
            Box::new(|p| f64::from(value.get_noise_3d(f(p)[0], f(p)[1], f(p)[2]))),
        ),
        ("value, space", "noise", Box::new(|p| fields_value.get(p))),
        ("value, space", "truth", Box::new(|p| truth::noise::value3(p, None, 1))),
        ("Perlin, plane", "fastnoise-lite", Box::new(|p| f64::from(perlin.get_noise_2d(f(p)[0], f(p)[1])))),
        ("Perlin, plane", "noise", Box::new(|p| fields_perlin.get(of2(p)))),
        ("Perlin, plane", "truth", Box::new(|p| truth::noise::perlin2(of2(p), None, 1))),
        (
            "Perlin, space",
            "fastnoise-lite",
            Box::new(|p| f64::from(perlin.get_noise_3d(f(p)[0], f(p)[1], f(p)[2]))),
        ),
        ("Perlin, space", "noise", Box::new(|p| fields_perlin.get(p))),
        ("Perlin, space", "truth", Box::new(|p| truth::noise::perlin3(p, None, 1))),
        ("simplex, plane", "fastnoise-lite", Box::new(|p| f64::from(simplex.get_noise_2d(f(p)[0], f(p)[1])))),
        ("simplex, plane", "noise", Box::new(|p| fields_simplex.get(of2(p)))),
        ("simplex, plane", "truth", Box::new(|p| truth::noise::simplex2(of2(p), None, 1))),
        (
            "simplex, space",
            "fastnoise-lite",
            Box::new(|p| f64::from(simplex.get_noise_3d(f(p)[0], f(p)[1], f(p)[2]))),
        ),
        ("simplex, space", "noise", Box::new(|p| fields_simplex.get(p))),
        ("simplex, space", "truth", Box::new(|p| truth::noise::simplex3(p, None, 1))),
        (
            "Worley, space",
            "fastnoise-lite",
            Box::new(|p| f64::from(cellular.get_noise_3d(f(p)[0], f(p)[1], f(p)[2]))),
        ),
        ("Worley, space", "noise", Box::new(|p| fields_worley.get(p))),
        ("Worley, space", "truth", Box::new(|p| truth::noise::worley3(p, None, 1).f1)),
    ];
    let mut rows = Vec::new();
    for (name, whose, sample) in ways {
        let count = if whose == "truth" { 20_000 } else { 400_000 };
        let mut times = Vec::new();
        for _ in 0..5 {
            let spent = timed(|| {
                let (mut p, mut sum) = ([0.5; 3], 0.0);
                for _ in 0..count {
                    sum += sample(p);
                    p = [p[0] + 0.731, p[1] + 0.477, p[2] + 0.613];
                }
                Ok(sum)
            })?;
            times.push(spent.cpu * 1e6 / f64::from(count));
        }
        let ns = quartiles(times.into_iter()).median;
        rows.push([name.to_owned(), whose.to_owned(), number(ns), number(1e3 / ns)]);
    }
    Ok(rows)
}
