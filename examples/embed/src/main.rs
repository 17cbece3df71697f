//! `cargo run -p embed` opens a window; `cargo run -p embed -- --shot out.png` writes a picture.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "an example says what it does")]

use std::path::PathBuf;
use std::process::ExitCode;

use embed::{landscape, shot, world};

const HELP: &str = "\
A small engine with meshes of its own, that draws Orogen's landscape among them.

  embed                          opens a window: arrows or WASD walk, the mouse turns, PageUp and PageDown climb,
                                 [ and ] move the sun. Save examples/embed/valley.json or a file of
                                 examples/embed/wgsl, and the picture follows; a slip is told, and changes nothing
  embed --shot FILE.png          writes a picture instead, without any window
  --size WxH                     its size, 960x540 unless told
  --samples N                    N x N samples of light to a pixel, 2 unless told
  --set GROUP.NAME=VALUE         as orogen's own: --set sun.elevation=6 (repeatable)
";

struct Arguments {
    shot: Option<PathBuf>,
    size: [u32; 2],
    samples: u32,
    set: Vec<String>,
}

fn main() -> ExitCode {
    let arguments = match arguments(std::env::args().skip(1)) {
        Ok(Some(arguments)) => arguments,
        Ok(None) => {
            print!("{HELP}");
            return ExitCode::SUCCESS;
        }
        Err(why) => {
            eprintln!("error: {why}\n\n{HELP}");
            return ExitCode::from(2);
        }
    };
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// None where help is asked for.
fn arguments(mut words: impl Iterator<Item = String>) -> Result<Option<Arguments>, String> {
    let mut arguments = Arguments { shot: None, size: [960, 540], samples: 2, set: Vec::new() };
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or_else(|| format!("{word} needs a value"));
        match word.as_str() {
            "-h" | "--help" => return Ok(None),
            "--shot" => arguments.shot = Some(value()?.into()),
            "--samples" => {
                let samples = value()?.parse().ok().filter(|samples| (1..=8).contains(samples));
                arguments.samples = samples.ok_or("--samples is 1 to 8")?;
            }
            "--size" => {
                let size = value()?;
                let sides = size.split_once('x').and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
                let sides =
                    sides.filter(|sides: &[u32; 2]| sides.iter().all(|side| (1..=4096).contains(side)));
                arguments.size = sides.ok_or("--size is WIDTHxHEIGHT, as in 960x540")?;
            }
            "--set" => arguments.set.push(value()?),
            other => return Err(format!("`{other}` is not known here")),
        }
    }
    Ok(Some(arguments))
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn std::error::Error>> {
    let Some(path) = &arguments.shot else { return window(arguments) };
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let (_, device, queue) = world::device(&instance, None)?;
    let mut engine = world::engine(device, queue, shot::FORMAT, &arguments.set, &landscape::bake())?;
    let camera = world::camera(&mut engine)?;
    let frame = shot::frame(&engine, &camera, arguments.size, arguments.samples, world::EXPOSURE)?;
    shot::write(&frame, path)?;
    println!("{}", path.display());
    Ok(())
}

#[cfg(feature = "window")]
fn window(arguments: &Arguments) -> Result<(), Box<dyn std::error::Error>> {
    embed::window::run(arguments.size, &arguments.set)
}

#[cfg(not(feature = "window"))]
fn window(_: &Arguments) -> Result<(), Box<dyn std::error::Error>> {
    Err("this was built without a window: give --shot FILE.png, or build it with `--features window`".into())
}
