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

pub(crate) fn measure(lab: &Lab) -> Outcome<Section> {
    let mut rows = Vec::new();
    let mut compiled_anew = Vec::new();
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
        if live > 2.0 * constant && live > 0.5 * compiling[2] {
            compiled_anew.push(name);
        }
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
    let mut text = format!(
        "The same preset with all parameters constant, with all as pipeline overrides, and with all in one uniform buffer (`frame.*` is \
         always uniform, options never are): {} for a frame of {}×{} / for compiling, from WGSL to the first pixel, with a device of its \
         own. Frames are medians of {ROUNDS} that take turns; a compilation is one. The last two columns: how much longer a frame takes than \
         with constants.\n\n{}",
        lab.clock(),
        SIZE.0,
        SIZE.1,
        table(["preset", "constant", "override", "uniform", "override", "uniform"], &rows),
    );
    if !compiled_anew.is_empty() {
        text += &format!(
            "\nWith a uniform, a frame of {} takes about what compiling takes: there the driver seems to compile anew for every draw, \
             and for this section it keeps nothing on disk.\n",
            compiled_anew.join(", "),
        );
    }
    Ok(Section { title: TITLE, text })
}
