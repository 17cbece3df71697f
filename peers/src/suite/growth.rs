//! Part 6: what grows with what. Composing with the size of the source, pictures with octaves and with steps.

use std::time::Duration;

use orogen::{Bake, Library, Preset, compose};

use super::gpu::{Lab, Painting};
use crate::Outcome;
use crate::child::{self, End};
use crate::contest::{Entrant, Work, number};
use crate::graph::{Dialect, Plan, Settings, Shape};
use crate::page::{Section, table};
use crate::time::{interleaved, quartiles, timed};
use crate::tool::{Session, Tool, validated};

pub(crate) const TITLE: &str = "Growth";

const FUNCTIONS: usize = 20;
/// Modules: from a tenth of a megabyte of source to ten.
const MODULES: [usize; 5] = [8, 25, 80, 250, 1000];
const MOST: Duration = Duration::from_secs(60);
const SIZE: (u32, u32) = (240, 135);

/// What one contestant takes at one size; none where it is out.
struct Taken {
    cpu: f64,
    mib: f64,
}

pub(crate) fn measure(lab: &Lab) -> Outcome<Section> {
    let tools = [Tool::Orogen, Tool::NagaOil, Tool::NagaOilLean, Tool::Wesl];
    let mut rows: Vec<[String; 7]> = Vec::new();
    let mut points: Vec<Vec<(f64, f64, f64)>> = vec![Vec::new(); tools.len()];
    let mut floors = Vec::new();
    let mut still_in = tools.to_vec();
    for modules in MODULES {
        let plan = Plan { shape: Shape::Wide, modules, functions: FUNCTIONS };
        let bytes: usize = plan.graph(Dialect::Orogen).modules.iter().map(|file| file.text.len()).sum();
        eprintln!("growth: {modules} modules, {bytes} bytes");
        let mut peaks = Vec::new();
        for tool in still_in.clone() {
            match child::run(Some(tool), plan, tool, MOST)? {
                End::Done(peak) => peaks.push((tool, peak.kib / 1024.0)),
                End::TooLong | End::Failed(_) => still_in.retain(|other| *other != tool),
            }
        }
        let entrants: Vec<Entrant> = still_in.iter().map(|tool| Entrant::new(*tool, plan)).collect();
        // The floor under all of them: naga, given the whole text at once.
        let graph = plan.graph(Dialect::Orogen);
        let whole =
            Session::open(Tool::Orogen, &graph)?.compose_once(Settings::default())?.wgsl()?.into_owned();
        let mut turns =
            entrants.iter().map(|entrant| entrant.turn(Work::Cold)).collect::<Outcome<Vec<_>>>()?;
        turns.push(Box::new(|_| timed(|| checked(&whole))));
        let runs = interleaved(&mut turns, (2, 7), Duration::from_secs(10))?;
        let taken = |tool: &Tool| {
            let index = still_in.iter().position(|other| other == tool)?;
            let mib = peaks.iter().find(|(other, _)| other == tool)?.1;
            Some(Taken { cpu: runs[index].cpu().median, mib })
        };
        let cell = |tool: &Tool| {
            taken(tool).map_or("–".to_owned(), |t| format!("{} / {:.0}", number(t.cpu), t.mib))
        };
        for (tool, points) in tools.iter().zip(&mut points) {
            points.extend(taken(tool).map(|taken| (bytes as f64, taken.cpu, taken.mib)));
        }
        let floor = runs.last().map_or(f64::NAN, |runs| runs.cpu().median);
        floors.push((bytes as f64, floor));
        let [ours, oil, lean, wesl] = [0, 1, 2, 3].map(|index| cell(&tools[index]));
        let size = format!("{:.2}", bytes as f64 / 1e6);
        rows.push([modules.to_string(), size, ours, oil, lean, wesl, number(floor)]);
    }
    let exponents = points.iter().map(|points| {
        let slope =
            |of: fn(&(f64, f64, f64)) -> f64| exponent(points.iter().map(|point| (point.0, of(point))));
        format!("{:.2} / {:.2}", slope(|point| point.1), slope(|point| point.2))
    });
    let exponents: Vec<String> = exponents.collect();
    let [ours, oil, lean, wesl] = [0, 1, 2, 3].map(|index| exponents[index].clone());
    let floor = format!("{:.2}", exponent(floors.into_iter()));
    rows.push(["**exponent**".to_owned(), String::new(), ours, oil, lean, wesl, floor]);
    let names = tools.map(Tool::name);
    let mut text = format!(
        "Composing cold, all modules included by the root, {FUNCTIONS} functions a module: CPU ms / peak MiB. The last column is naga \
         alone, which parses and validates the text that orogen makes: nobody who validates gets below it. The last row is the slope on \
         log-log paper: 1 is linear. A contestant that needs more than {} s for one composition is out from there on.\n\n{}",
        MOST.as_secs(),
        table(["modules", "MB", names[0], names[1], names[2], names[3], "naga alone"], &rows),
    );
    text += &pictures(lab)?;
    Ok(Section { title: TITLE, text })
}

/// `text`, parsed and validated.
fn checked(text: &str) -> Outcome<(naga::Module, naga::valid::ModuleInfo)> {
    let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
    let info = validated(&module)?;
    Ok((module, info))
}

/// The slope of a line of least squares through the logarithms.
fn exponent(points: impl Iterator<Item = (f64, f64)>) -> f64 {
    line(points.map(|(x, y)| (x.ln(), y.ln()))).0
}

/// Slope, intercept and R² of a line of least squares.
pub(crate) fn line(points: impl Iterator<Item = (f64, f64)>) -> (f64, f64, f64) {
    let points: Vec<(f64, f64)> = points.collect();
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let sum = |of: &dyn Fn(f64, f64) -> f64| points.iter().map(|p| of(p.0 - x, p.1 - y)).sum::<f64>();
    let slope = sum(&|dx, dy| dx * dy) / sum(&|dx, _| dx * dx);
    let left = sum(&|dx, dy| (dy - slope * dx).powi(2));
    (slope, y - slope * x, 1.0 - left / sum(&|_, dy| dy * dy))
}

/// How long pictures take by octaves, and by steps.
fn pictures(lab: &Lab) -> Outcome<String> {
    let mut text = format!(
        "\n### Pictures\n\n{}×{} pixels of land alone, {} a frame (medians of 5), on {}. The number of octaves is a parameter, \
         and those too fine for a pixel are left out: from some number on more of them cost nothing. Steps are those of a \
         march of even steps over one octave of Perlin noise. R² is that of a line.\n\n",
        SIZE.0,
        SIZE.1,
        lab.clock(),
        lab.name
    );
    let octaves = [2, 4, 6, 8, 10, 12, 14];
    let by_octaves = octaves.map(|octaves| {
        let mut preset = Preset::named("ridges")?;
        for assignment in
            ["landscape.trees=false", "sky.model=gradient", "weather.clouds=false", "weather.cirrus=false"]
        {
            preset.set(assignment)?;
        }
        preset.set(&format!("terrain.octaves={octaves}"))?;
        frame(lab, &preset)
    });
    text += &counted("octaves", &octaves, by_octaves)?;
    text.push('\n');
    let steps = [32, 64, 128, 256, 512, 1024];
    let by_steps = steps.map(|steps| {
        let scene = STEPS.replace("STEPS", &steps.to_string());
        frame(lab, &Preset::of_text("steps.wgsl", &scene))
    });
    text += &counted("steps", &steps, by_steps)?;
    Ok(text)
}

/// A march of even steps, which never ends early: every ray looks at the land as often as it is told.
/// One noise and no loop inside: software GPUs end an invocation's loops after 65,535 turns in all.
const STEPS: &str = "#include <noise/perlin.wgsl>

fn main_image(frag_coord: vec2f) -> vec4f {
    let direction = normalize(vec3f(frag_coord.x / 240.0 - 0.5, frag_coord.y / 240.0 - 0.4, 1.0));
    var nearest = 1e9;
    for (var step = 1; step <= STEPS; step += 1) {
        let p = vec3f(0.0, 2500.0, 0.0) + direction * (20000.0 * f32(step) / f32(STEPS));
        nearest = min(nearest, abs(p.y - 800.0 * perlin_noise2(p.xz / 1000.0, 1u)));
    }
    return vec4f(vec3f(nearest / 1000.0), 1.0);
}
";

fn counted<const N: usize>(what: &str, counts: &[i32; N], times: [Outcome<f64>; N]) -> Outcome<String> {
    let mut rows = Vec::new();
    let mut points = Vec::new();
    for (count, time) in counts.iter().zip(times) {
        let time = time?;
        points.push((f64::from(*count), time));
        rows.push([count.to_string(), number(time), format!("{:.3}", time / f64::from(*count))]);
    }
    let (slope, _, r2) = line(points.into_iter());
    rows.push(["**a line**".to_owned(), format!("R² {r2:.4}"), format!("{slope:.3}")]);
    Ok(table([what, "a frame", "each"], &rows))
}

/// How long a frame takes (ms): the median of five.
fn frame(lab: &Lab, preset: &Preset) -> Outcome<f64> {
    let shader = compose(&Library::standard(), preset, &Bake::constants())?;
    let (painting, _) = Painting::new(lab, &shader, preset, SIZE)?;
    let times = (0..5).map(|_| painting.draw(None)).collect::<Outcome<Vec<f64>>>()?;
    Ok(quartiles(times.into_iter()).median)
}
