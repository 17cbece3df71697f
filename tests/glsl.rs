//! The feature matrix: each `tests/glsl/<what>.wgsl` holds one construct of WGSL and fills a grid of pixels with what comes
//! of it. Its GLSL is compiled by glslang, and drawn by Chromium through WebGL2; wgpu draws the author's own text. Integers
//! must be equal, floats within 4 ulp, but where the first line states another tolerance and why:
//!
//! ```text
//! // tolerance: 1e-6 relative, since …
//! // tolerance: 5e-4 absolute, since …
//! ```
//!
//! What wgpu itself cannot draw, `tests/glsl/in-other-words/` says in words that it can.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod grid;
mod harness;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use grid::{Channels, Device, SIDE};
use harness::glsl::{composed, emitted, folder, glslang};
use libtest_mimic::{Arguments, Failed, Trial};

/// Fewer than this were not all that there are.
const AT_LEAST: usize = 150;

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let files = files();
    let mut trials: Vec<_> = files
        .iter()
        .cloned()
        .map(|file| Trial::test(name(&file).replace('-', "_"), move || compiles(&file).map_err(Failed::from)))
        .collect();
    trials
        .push(Trial::test("every_file_draws_the_same_in_webgl2", move || same(&files).map_err(Failed::from)));
    libtest_mimic::run(&arguments, trials).exit_code()
}

fn files() -> Vec<PathBuf> {
    let mut files: Vec<_> = fs::read_dir("tests/glsl").unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "wgsl"));
    files.sort();
    files
}

fn name(file: &Path) -> String {
    file.file_stem().unwrap().to_str().unwrap().to_owned()
}

fn emit(file: &Path) -> Result<String, String> {
    let text = fs::read_to_string(file).unwrap();
    composed(&name(file), &text).and_then(|shader| emitted(&shader)).map_err(|error| error.to_string())
}

/// The file's GLSL is GLSL.
fn compiles(file: &Path) -> Result<(), String> {
    let path = folder(&format!("glsl-{}", name(file))).join("shader.frag");
    fs::write(&path, emit(file)?).unwrap();
    glslang(&path).map_err(|said| format!("{said}\n{}", fs::read_to_string(&path).unwrap()))
}

/// Every file that could be written fills the grid with the same values on both sides. One browser draws them all.
fn same(files: &[PathBuf]) -> Result<(), String> {
    if files.len() < AT_LEAST {
        return Err(format!("there are {} files in tests/glsl, and at least {AT_LEAST} wanted", files.len()));
    }
    let (shaders, drawn) = (folder("glsl-shaders"), folder("glsl-drawn"));
    let mut wrong = Vec::new();
    let mut there = Vec::new();
    for file in files {
        match emit(file) {
            Ok(text) => {
                fs::write(shaders.join(format!("{}.frag", name(file))), text).unwrap();
                there.push(file);
            }
            Err(error) => wrong.push(format!("{}: is not written\n{error}", file.display())),
        }
    }
    in_browser(&shaders, &drawn)?;
    let device = Device::open()?;
    for file in &there {
        if let Err(why) = compare(&device, file, &drawn) {
            wrong.push(format!("{}: {why}", file.display()));
        }
    }
    if wrong.is_empty() {
        return Ok(());
    }
    Err(format!("{} of {} files differ:\n\n{}", wrong.len(), files.len(), wrong.join("\n\n")))
}

/// Has Chromium draw what lies in `shaders`. Its exit status tells that one was refused; which one, its `.err` files do.
fn in_browser(shaders: &Path, drawn: &Path) -> Result<(), String> {
    let mut node = Command::new("node");
    let size = format!("{SIDE}x{SIDE}");
    let output = node.arg("tests/judges/matrix.mjs").args([shaders, drawn]).arg(size).output();
    let output = output.map_err(|why| {
        format!("`node` cannot be run ({why}): `cargo xtask test` installs what this needs")
    })?;
    if fs::read_dir(drawn).unwrap().next().is_some() {
        return Ok(());
    }
    let said =
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    Err(format!("the browser drew nothing; `cargo xtask test` installs what this needs:\n{said}"))
}

/// Holds what Chromium drew of `file` against what wgpu draws.
fn compare(device: &Device, file: &Path, drawn: &Path) -> Result<(), String> {
    let text = fs::read_to_string(file).unwrap();
    let tolerance = tolerance(&text)?;
    let refused = drawn.join(format!("{}.err", name(file)));
    if let Ok(said) = fs::read_to_string(refused) {
        return Err(format!("the browser refuses it: {said}"));
    }
    let bytes =
        fs::read(drawn.join(format!("{}.bin", name(file)))).map_err(|_| "the browser did not draw it")?;
    let found = grid::pixels(&bytes);
    let module = naga::front::wgsl::parse_str(&text).map_err(|error| error.emit_to_string(&text))?;
    let channels = Channels::of(&module)?;
    // naga writes SPIR-V for the driver, and panics on some valid WGSL: that is drawn as a second file says it.
    let other = Path::new("tests/glsl/in-other-words").join(file.file_name().unwrap());
    let drawable = fs::read_to_string(other).unwrap_or(text);
    let drawn = catch_unwind(AssertUnwindSafe(|| device.draw(&drawable, channels)));
    let expected =
        drawn.map_err(|_| "wgpu panics: tests/glsl/in-other-words is for a file that says the same")??;
    if expected.len() != found.len() {
        return Err(format!("{} pixels instead of {}", found.len(), expected.len()));
    }
    if expected.iter().all(|pixel| pixel == &expected[0]) {
        return Err("every pixel is the same: this proves little".into());
    }
    let mut differing =
        expected.iter().zip(&found).enumerate().filter(|(_, (expected, found))| {
            !(0..4).all(|i| tolerance.allows(channels, expected[i], found[i]))
        });
    let Some((index, (expected, found))) = differing.next() else { return Ok(()) };
    let (x, y) = (index as u32 % SIDE, index as u32 / SIDE);
    Err(format!(
        "at {x}, {y} and {} other pixels:\n    wgpu   {}\n    WebGL2 {}",
        differing.count(),
        shown(channels, expected),
        shown(channels, found)
    ))
}

/// How far two floats may be apart.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Tolerance {
    Ulps(u32),
    Relative(f32),
    Absolute(f32),
}

/// What the first line of `text` states.
fn tolerance(text: &str) -> Result<Tolerance, String> {
    let first = text.lines().next().unwrap_or_default();
    let Some(stated) = first.strip_prefix("// tolerance: ") else { return Ok(Tolerance::Ulps(4)) };
    let bad = || format!("`{first}` is not `// tolerance: NUMBER relative|absolute, since REASON`");
    let (amount, reason) = stated.split_once(", since ").ok_or_else(bad)?;
    let (number, kind) = amount.split_once(' ').ok_or_else(bad)?;
    let number: f32 = number.parse().map_err(|_| bad())?;
    match kind {
        _ if reason.is_empty() => Err(bad()),
        "relative" => Ok(Tolerance::Relative(number)),
        "absolute" => Ok(Tolerance::Absolute(number)),
        _ => Err(bad()),
    }
}

impl Tolerance {
    fn allows(self, channels: Channels, expected: u32, found: u32) -> bool {
        if expected == found || channels != Channels::Float {
            return expected == found;
        }
        let (a, b) = (f32::from_bits(expected), f32::from_bits(found));
        if a.is_nan() || b.is_nan() {
            return a.is_nan() && b.is_nan();
        }
        // A GPU may take the smallest numbers for zero.
        let apart = f64::from(a) - f64::from(b);
        if apart.abs() < f64::from(f32::MIN_POSITIVE) {
            return true;
        }
        match self {
            Self::Ulps(ulps) => ordered(expected).abs_diff(ordered(found)) <= u64::from(ulps),
            Self::Relative(most) => apart.abs() <= f64::from(most) * f64::from(a.abs().max(b.abs())),
            Self::Absolute(most) => apart.abs() <= f64::from(most),
        }
    }
}

/// The number of floats from zero to the one of these bits.
fn ordered(bits: u32) -> i64 {
    let magnitude = i64::from(bits & 0x7FFF_FFFF);
    if bits >> 31 == 1 { -magnitude } else { magnitude }
}

fn shown(channels: Channels, pixel: &[u32; 4]) -> String {
    let values = pixel.map(|bits| match channels {
        Channels::Float => format!("{:?}", f32::from_bits(bits)),
        Channels::Signed => bits.cast_signed().to_string(),
        Channels::Unsigned => bits.to_string(),
    });
    values.join(", ")
}
