//! Part 4: one preset as constants, as overrides, as uniforms. What a frame takes, what compiling takes, and what specialisation
//! buys.

use std::panic::{AssertUnwindSafe, catch_unwind};

use orogen::{Bake, Library, Preset, compose};

use super::gpu::{Lab, Painting};
use crate::Outcome;
use crate::contest::number;
use crate::page::{Section, table};
use crate::time::quartiles;

pub(crate) const TITLE: &str = "Baking";

const PRESETS: [&str; 4] = ["alpine", "cumulus", "dunes", "lake"];
const SIZE: (u32, u32) = (320, 180);
const ROUNDS: usize = 5;

pub(crate) fn measure(lab: &Lab) -> Outcome<Section> {
    let mut rows = Vec::new();
    for name in PRESETS {
        eprintln!("baking: {name}");
        let preset = Preset::named(name)?;
        let bakes = [Bake::constants(), Bake::constants().with_overrides(["*"]), Bake::live(["*"])];
        let shaders = bakes.map(|bake| compose(&Library::standard(), &preset, &bake));
        let [constants, overrides, uniforms] = shaders;
        let shaders = [constants?, overrides?, uniforms?];
        // On a device of its own each time, so that no driver knows the shader already; they take turns. naga's writers end
        // the process at some shaders whose constants are overrides: such a one is out, and the page says so.
        let labs = [Lab::open()?, Lab::open()?, Lab::open()?];
        let mut paintings = Vec::new();
        for (shader, lab) in shaders.iter().zip(&labs) {
            let made = catch_unwind(AssertUnwindSafe(|| Painting::new(lab, shader, &preset, SIZE)));
            paintings.push(made.ok().transpose()?);
        }
        let mut frames = [const { Vec::new() }; 3];
        for _ in 0..ROUNDS {
            for (painting, times) in paintings.iter().zip(&mut frames) {
                if let Some((painting, _)) = painting {
                    times.push(painting.draw(None)?);
                }
            }
        }
        let frame = frames.map(|times| quartiles(times.into_iter()).median);
        let drawn = |index: usize| paintings[index].as_ref().map(|(_, compile)| (frame[index], *compile));
        let buys = |other: usize| match (drawn(0), drawn(other)) {
            (Some((constant, _)), Some((frame, _))) => format!("{:+.0} %", 100.0 * (frame / constant - 1.0)),
            _ => "–".to_owned(),
        };
        let cell = |index: usize| match drawn(index) {
            Some((frame, compile)) => format!("{} / {}", number(frame), number(compile)),
            None => "naga panics".to_owned(),
        };
        rows.push([name.to_owned(), cell(0), cell(1), cell(2), buys(1), buys(2)]);
    }
    let text = format!(
        "The same preset with all parameters constant, with all as pipeline overrides, and with all in one uniform buffer (`frame.*` is \
         always uniform, options never are): {} for a frame of {}×{} / for compiling, from WGSL to the first pixel, with a device of its \
         own. Frames are medians of {ROUNDS} that take turns; a compilation is one. The last two columns: how much longer a frame takes than \
         with constants.\n\n{}",
        lab.clock(),
        SIZE.0,
        SIZE.1,
        table(["preset", "constant", "override", "uniform", "override", "uniform"], &rows),
    );
    Ok(Section { title: TITLE, text })
}
