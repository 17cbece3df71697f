//! Part 4: one preset as constants, as overrides, as uniforms. What a frame takes, what compiling takes, and what specialisation
//! buys.

use orogen::source::preset_names;
use orogen::{Bake, Library, Preset, compose};

use super::gpu::{Lab, Painting};
use crate::Outcome;
use crate::contest::number;
use crate::page::{Section, table};
use crate::time::quartiles;

pub(crate) const TITLE: &str = "Baking";

const SIZE: (u32, u32) = (160, 90);
const ROUNDS: usize = 3;

/// Found with Mesa 22.3.6, by runs with and without its cache of shaders.
const NOTE: &str = "Where a frame with a uniform takes several times as long, what is added is what compiling takes: by all signs \
    llvmpipe compiles these shaders anew whenever they are drawn, for the values that their loops depend on, and in this run it keeps \
    nothing on disk. With its cache on, `canyon` took 140 ms a frame with a uniform beside 103 with constants. Differences of up to a \
    tenth are noise.";

pub(crate) fn measure(lab: &Lab) -> Outcome<Section> {
    let mut rows = Vec::new();
    for name in preset_names() {
        eprintln!("baking: {name}");
        let preset = Preset::named(name)?;
        let bakes = [Bake::constants(), Bake::constants().with_overrides(["*"]), Bake::live(["*"])];
        let shaders = bakes.map(|bake| compose(&Library::standard(), &preset, &bake));
        let [constants, overrides, uniforms] = shaders;
        let shaders = [constants?, overrides?, uniforms?];
        // On a device of its own each time, so that no driver knows the shader already; they take turns.
        let labs = [Lab::open()?, Lab::open()?, Lab::open()?];
        let paintings =
            shaders.iter().zip(&labs).map(|(shader, lab)| Painting::new(lab, shader, &preset, SIZE));
        let paintings = paintings.collect::<Outcome<Vec<_>>>()?;
        let mut frames = [const { Vec::new() }; 3];
        for _ in 0..ROUNDS {
            for ((painting, _), times) in paintings.iter().zip(&mut frames) {
                times.push(painting.draw(None)?);
            }
        }
        let [constant, overridden, live] = frames.map(|times| quartiles(times.into_iter()).median);
        let compiling: Vec<f64> = paintings.iter().map(|(_, compiling)| *compiling).collect();
        let buys = |frame: f64| format!("{:+.0} %", 100.0 * (frame / constant - 1.0));
        let cell = |frame: f64, index: usize| format!("{} / {}", number(frame), number(compiling[index]));
        rows.push([
            name.to_owned(),
            cell(constant, 0),
            cell(overridden, 1),
            cell(live, 2),
            buys(overridden),
            buys(live),
        ]);
    }
    let text = format!(
        "The same preset with all parameters constant, with all as pipeline overrides, and with all in one uniform buffer (`frame.*` is \
         always uniform, options never are): {} for a frame of {}×{} / for compiling, from WGSL to the first pixel, with a device of its \
         own. Frames are medians of {ROUNDS} that take turns; a compilation is one. The last two columns: how much longer a frame takes than \
         with constants.\n\n{}\n{NOTE}\n",
        lab.clock(),
        SIZE.0,
        SIZE.1,
        table(["preset", "constant", "override", "uniform", "override", "uniform"], &rows),
    );
    Ok(Section { title: TITLE, text })
}
