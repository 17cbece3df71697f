//! Part 5: what the elements of a picture cost, at four qualities, and what error that buys: pixels and settings → tables and
//! plots.

use std::path::Path;
use std::process::Command;

use orogen::render::{Gpu, Shot, render};
use orogen::{Bake, Library, Preset, compose};

use super::gpu::{Lab, Painting};
use super::growth::line;
use super::plot::{Corner, Curve, Scale, plot};
use crate::Outcome;
use crate::contest::number;
use crate::page::{Section, table};
use crate::time::quartiles;

pub(crate) const TITLE: &str = "Elements";

const SIZES: [(u32, u32); 4] = [(160, 90), (240, 135), (320, 180), (480, 270)];
const QUALITIES: [&str; 4] = ["low", "medium", "high", "ultra"];
const LEAST_R2: f64 = 0.99;
/// Frames of a size at least, and how long (ms) a size is drawn for: where frames are short there are more of them.
const ROUNDS: usize = 3;
const MOST_ROUNDS: usize = 15;
const LONG_ENOUGH: f64 = 3000.0;

/// A picture of certain elements.
struct Element {
    name: &'static str,
    preset: &'static str,
    set: &'static [&'static str],
}

const ELEMENTS: [Element; 6] = [
    Element {
        name: "terrain",
        preset: "lake",
        set: &[
            "landscape.trees=false",
            "landscape.water=false",
            "sky.model=gradient",
            "weather.clouds=false",
        ],
    },
    Element {
        name: "terrain, trees",
        preset: "lake",
        set: &["landscape.trees=true", "landscape.water=false", "sky.model=gradient", "weather.clouds=false"],
    },
    Element {
        name: "terrain, water",
        preset: "lake",
        set: &["landscape.trees=false", "landscape.water=true", "sky.model=gradient", "weather.clouds=false"],
    },
    Element {
        name: "terrain, atmosphere",
        preset: "lake",
        set: &[
            "landscape.trees=false",
            "landscape.water=false",
            "sky.model=atmosphere",
            "weather.clouds=false",
        ],
    },
    Element {
        name: "terrain, clouds",
        preset: "lake",
        set: &["landscape.trees=false", "landscape.water=false", "sky.model=gradient", "weather.clouds=true"],
    },
    Element { name: "planet", preset: "earth", set: &[] },
];

pub(crate) fn measure(lab: &Lab) -> Outcome<Section> {
    let mut rows = Vec::new();
    let mut straight = true;
    for element in &ELEMENTS {
        let mut cells = Vec::new();
        for quality in QUALITIES {
            let (slope, r2) = cost(lab, element, quality)?;
            eprintln!("elements: {} {quality}: {} ms a megapixel, R² {r2:.4}", element.name, number(slope));
            straight &= r2 >= LEAST_R2;
            cells.push(format!("{} ({r2:.4})", number(slope / 1e3)));
        }
        let [low, medium, high, ultra] = [0, 1, 2, 3].map(|index| cells[index].clone());
        rows.push([element.name.to_owned(), low, medium, high, ultra]);
    }
    let sizes: Vec<String> = SIZES.iter().map(|(width, height)| format!("{width}×{height}")).collect();
    let verdict = if straight { "kept" } else { "**missed**" };
    let [low, medium, high, ultra] = QUALITIES;
    let mut text = format!(
        "Seconds a megapixel ({}, {}), and in brackets R² of a line through {} (medians of {ROUNDS} to {MOST_ROUNDS} \
         frames, compiling left out). All but the planet are the preset `lake` with the elements named, the planet is `earth`. Bar: R² at least {LEAST_R2}: {verdict}.\n\n{}",
        lab.name,
        lab.clock(),
        sizes.join(", "),
        table(["picture", low, medium, high, ultra], &rows),
    );
    text += "\n### Error against cost\n\n";
    text += &marches()?;
    text += &sky(lab)?;
    text += &clouds()?;
    Ok(Section { title: TITLE, text })
}

/// Milliseconds a megapixel, and how straight the line is.
fn cost(lab: &Lab, element: &Element, quality: &str) -> Outcome<(f64, f64)> {
    let mut preset = Preset::named(element.preset)?;
    preset.set(&format!("quality={quality}"))?;
    element.set.iter().try_for_each(|assignment| preset.set(assignment))?;
    let shader = compose(&Library::standard(), &preset, &Bake::constants())?;
    let paintings = SIZES.map(|size| Painting::new(lab, &shader, &preset, size));
    let paintings =
        paintings.into_iter().map(|made| made.map(|(painting, _)| painting)).collect::<Outcome<Vec<_>>>()?;
    // Round by round, so that a moment in which the machine is slow falls on all sizes.
    let mut times = vec![Vec::new(); SIZES.len()];
    for round in 0..MOST_ROUNDS {
        for (painting, times) in paintings.iter().zip(&mut times) {
            if round < ROUNDS || times.iter().sum::<f64>() < LONG_ENOUGH {
                times.push(painting.draw(None)?);
            }
        }
    }
    let pixels = SIZES.map(|(width, height)| f64::from(width * height) / 1e6);
    let (slope, _, r2) =
        line(pixels.into_iter().zip(times).map(|(x, times)| (x, quartiles(times.into_iter()).median)));
    Ok((slope, r2))
}

/// What `cargo bench --bench NAME` prints.
fn bench(name: &str) -> Outcome<String> {
    eprintln!("elements: cargo bench --bench {name}");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo).args(["bench", "--quiet", "--bench", name]).output()?;
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    if !output.status.success() && said.trim().is_empty() {
        return Err(format!("the bench {name} failed: {}", String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok(said) // a bar of its own that it misses is its own affair
}

/// The numbers at the end of a line, after `skip` columns.
fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}

/// Plots of the terrain marches, out of `benches/march`: octaves a ray against the 95th percentile of the error.
fn marches() -> Outcome<String> {
    let said = bench("march")?;
    let mut text = String::new();
    for (index, land) in said.split("The four experiments").enumerate().skip(1) {
        let before = said.split("The four experiments").nth(index - 1).unwrap_or_default();
        let name = before
            .lines()
            .rev()
            .find_map(|line| line.split_once(": ").map(|(name, _)| name))
            .unwrap_or("land");
        // Rows end with missed, phantom, IDE p50, IDE p95, HDE p95, octaves. Only what misses nothing can be compared.
        let point = |line: &str, own: usize| {
            let row = numbers(line);
            let rest = row.get(own..).filter(|rest| rest.len() == 6 && rest[0] == 0.0)?;
            Some((rest[5], rest[3]))
        };
        let (adaptive, rest) =
            land.split_once("Bounded, by tolerance").ok_or("the march's bench has no bounded march")?;
        let bounded = rest.split("Adaptive at the best").next().unwrap_or_default();
        let curves = [
            Curve {
                name: "adaptive, one setting varied",
                points: adaptive.lines().filter_map(|l| point(l, 4)).collect(),
                joined: false,
            },
            Curve {
                name: "bounded, by tolerance",
                points: bounded.lines().filter_map(|l| point(l, 1)).collect(),
                joined: true,
            },
        ];
        let file = format!("march-{index}.svg");
        plot(
            &pictures()?.join(&file),
            &format!("Land: {name}"),
            ("octaves a ray", Scale::Log),
            ("error of distance, 95th percentile (m)", Scale::Log),
            Corner::UpperRight,
            &curves,
        )?;
        text += &format!("![Error against octaves: {name}](benchmarks/{file})\n\n");
    }
    if text.is_empty() {
        return Err("the march's bench printed no tables".into());
    }
    text += "Of the adaptive march, those settings that miss no land which a careful march finds. The bounded march misses none at \
             any.\n\n";
    Ok(text)
}

/// A plot of the sky's samples: milliseconds a megapixel against the error to 64 samples.
fn sky(lab: &Lab) -> Outcome<String> {
    const MOST: u32 = 64;
    let gpu = Gpu::of(&lab.device, &lab.queue);
    let mut curves = Vec::new();
    for (name, elevation) in [("sun at 45°", 45), ("sun at 5°", 5), ("sun at -4°", -4)] {
        let scene = r#"{ "orogen": 1, "about": "", "scene": "scene/sky.wgsl", "set": {} }"#;
        let mut preset = Preset::parse("sky.json", scene)?;
        for assignment in
            ["sky.model=atmosphere", "camera.elevation=20", &format!("sun.elevation={elevation}")]
        {
            preset.set(assignment)?;
        }
        let picture = |samples: u32| {
            let mut preset = preset.clone();
            preset.set(&format!("sky.samples={samples}"))?;
            let shader = compose(&Library::standard(), &preset, &Bake::constants())?;
            let shown = render(&gpu, &shader, &preset, &Shot::new(160, 90), &mut |_, _| {})?;
            let (painting, _) = Painting::new(lab, &shader, &preset, (320, 180))?;
            let times = (0..MOST_ROUNDS).map(|_| painting.draw(None)).collect::<Outcome<Vec<f64>>>()?;
            let spent = quartiles(times.into_iter()).median / (320.0 * 180.0 / 1e6);
            Ok::<_, Box<dyn std::error::Error>>((shown, spent))
        };
        let (truth, _) = picture(MOST)?;
        let mut points = Vec::new();
        for samples in [2, 4, 6, 8, 12, 16, 24, 32] {
            let (shown, spent) = picture(samples)?;
            let pairs =
                shown.pixels.iter().zip(&truth.pixels).flat_map(|(a, b)| (0..3).map(move |i| a[i] - b[i]));
            let squares: Vec<f64> = pairs.map(|difference| f64::from(difference).powi(2)).collect();
            let mean =
                truth.pixels.iter().map(|pixel| f64::from(pixel[1])).sum::<f64>() / truth.pixels.len() as f64;
            points.push((spent / 1e3, (squares.iter().sum::<f64>() / squares.len() as f64).sqrt() / mean));
        }
        curves.push(Curve { name, points, joined: true });
    }
    let x = "seconds a megapixel";
    let y = "RMS difference to 64 samples, over the mean";
    plot(
        &pictures()?.join("sky.svg"),
        "Sky: 2 to 32 samples a ray",
        (x, Scale::Linear),
        (y, Scale::Log),
        Corner::UpperRight,
        &curves,
    )?;
    Ok("![Error of the sky against cost](benchmarks/sky.svg)\n\n".to_owned())
}

/// A plot of the cloud marches, out of `benches/clouds`: evaluations of the density a ray against decibels.
fn clouds() -> Outcome<String> {
    let said = bench("clouds")?;
    let mut curves = Vec::new();
    let mut plain = Vec::new();
    let mut name = "";
    let mut points = Vec::new();
    for line in said.lines() {
        let row = numbers(line);
        if let Some((title, _)) = line.split_once(": ").filter(|(_, rest)| rest.contains(" pixels")) {
            name = title;
        } else if line.trim_start().starts_with("plain, 64 x 12 ") {
            // steps, evaluations, ms, linear, display
            let [.., evaluations, _, _, display] = row.as_slice() else { continue };
            plain.push((*evaluations, *display));
        } else if line.starts_with("  ")
            && line.trim_start().split_once(": ").is_some_and(|(setting, _)| setting.len() == 1)
        {
            let [.., evaluations, _, _, display] = row.as_slice() else { continue };
            points.push((*evaluations, *display));
        } else if line.trim_start().starts_with("At ") && !points.is_empty() {
            curves.push((name.to_owned(), std::mem::take(&mut points)));
        }
    }
    if curves.is_empty() {
        return Err("the clouds' bench printed no tables".into());
    }
    let mut of_plot: Vec<Curve<'_>> =
        curves.iter().map(|(name, points)| Curve { name, points: points.clone(), joined: true }).collect();
    of_plot.push(Curve { name: "even steps, 64 × 12 (each of the four)", points: plain, joined: false });
    plot(
        &pictures()?.join("clouds.svg"),
        "Clouds: settings of the march",
        ("evaluations of the density a ray", Scale::Log),
        ("PSNR to 512 × 32 steps (dB), more is better", Scale::Linear),
        Corner::UpperLeft,
        &of_plot,
    )?;
    Ok("![Clouds: decibels against evaluations](benchmarks/clouds.svg)\n".to_owned())
}

/// The folder of plots, which is there.
fn pictures() -> Outcome<std::path::PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().ok_or("peers has no folder above it")?;
    let folder = root.join("docs/benchmarks");
    std::fs::create_dir_all(&folder)?;
    Ok(folder)
}
