//! Every built-in preset looks as it did: each is held against its picture in `tests/render`, as a test of its own; a new
//! preset is held by being there.
//!
//! `UPDATE=1 cargo test --test golden` writes the pictures anew.

#![allow(clippy::panic, reason = "a test fails by panicking")]

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::LazyLock;

use libtest_mimic::{Arguments, Failed, Trial};
use orogen::render::{Format, Gpu, Picture, Shot, encode, render, to_srgb8};
use orogen::source::preset_names;
use orogen::{Bake, Library, Preset, compose};

/// One for all tests: opening a device takes longer than a small picture.
static GPU: LazyLock<Gpu> =
    LazyLock::new(|| Gpu::new(None).expect("the tests run on lavapipe: `cargo xtask test`"));

const SIZE: (u32, u32) = (256, 144);

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let trial =
        |name: &'static str| Trial::test(format!("{name}_looks_as_it_did"), move || looks_as_it_did(name));
    let metric = Trial::test("the_golden_metric_forgives_noise_and_sees_a_change_of_light", || {
        the_golden_metric_forgives_noise_and_sees_a_change_of_light();
        Ok(())
    });
    let trials = preset_names().into_iter().map(trial).chain([metric]).collect();
    libtest_mimic::run(&arguments, trials).exit_code()
}

/// With its values baked in as constants.
fn drawn(name: &str) -> Picture {
    let preset = Preset::named(name).expect("it is built in");
    let shader = compose(&Library::standard(), &preset, &Bake::constants()).expect("it composes");
    render(&GPU, &shader, &preset, &Shot::new(SIZE.0, SIZE.1), &mut |_, _| {}).expect("it can be drawn")
}

fn looks_as_it_did(name: &str) -> Result<(), Failed> {
    let picture = drawn(name);
    let path = PathBuf::from(format!("tests/render/{name}.png"));
    let file = encode(&picture, Format::Png)?;
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&path, &file)?;
    }
    let golden = std::fs::read(&path).unwrap_or_default();
    if golden.is_empty() {
        return Err(format!("{} is not there; UPDATE=1 writes it", path.display()).into());
    }
    let golden = image::load_from_memory(&golden)?.to_rgba8().into_raw();
    let drawn = to_srgb8(&picture);
    if golden.len() != drawn.len() {
        return Err("another size".into());
    }
    alike(&golden, &drawn).or_else(|why| {
        let beside = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.png"));
        std::fs::write(&beside, &file)?;
        Err(format!("{why}: compare {} with {}", path.display(), beside.display()).into())
    })
}

/// Whether two pictures look alike, at several scales: other rasterisers round silhouettes and noise differently, which a
/// mean over 4×4 and 16×16 pixels forgives and an eye does not see; a colour, a shape or the light that changed stays.
fn alike(a: &[u8], b: &[u8]) -> Result<(), String> {
    // (side of the squares, largest difference of the mean over all of them, and of any one of them but the worst 0.5 %)
    for (side, mean_most, each_most) in [(1, 2.5, 48.0), (4, 1.5, 12.0), (16, 1.0, 5.0)] {
        let (a, b) = (shrunk(a, side), shrunk(b, side));
        let mut errors: Vec<f64> = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).collect();
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        errors.sort_by(f64::total_cmp);
        let each = errors[(errors.len() - 1) * 995 / 1000];
        if mean > mean_most || each > each_most {
            return Err(format!(
                "over {side}×{side} pixels the mean error is {mean:.2}/255 (at most {mean_most}), the 99.5th percentile \
                 {each:.2}/255 (at most {each_most})"
            ));
        }
    }
    Ok(())
}

/// Means over squares, of red, green and blue.
fn shrunk(picture: &[u8], side: usize) -> Vec<f64> {
    let (width, height) = (SIZE.0 as usize, SIZE.1 as usize);
    let mut means = Vec::new();
    for y in (0..height).step_by(side) {
        for x in (0..width).step_by(side) {
            for channel in 0..3 {
                let square = (0..side * side).map(|i| (y + i / side) * width + x + i % side);
                let sum: f64 = square.map(|pixel| f64::from(picture[pixel * 4 + channel])).sum();
                means.push(sum / (side * side) as f64);
            }
        }
    }
    means
}

fn the_golden_metric_forgives_noise_and_sees_a_change_of_light() {
    let flat = vec![120_u8; (SIZE.0 * SIZE.1 * 4) as usize];
    let noisy: Vec<u8> = flat.iter().enumerate().map(|(i, v)| v + (i * 7 % 3) as u8 - 1).collect();
    let brighter: Vec<u8> = flat.iter().map(|v| v + 4).collect();
    let mut patch = flat.clone();
    for y in 40..72 {
        for x in 40..72 {
            patch[(y * SIZE.0 as usize + x) * 4] = 150;
        }
    }
    assert_eq!(alike(&flat, &noisy), Ok(()));
    assert!(alike(&flat, &brighter).is_err());
    assert!(alike(&flat, &patch).is_err());
}
