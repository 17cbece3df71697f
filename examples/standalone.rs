//! Generate: a preset becomes one standalone WGSL file, and a table of what a host can still set in it.
//!
//! `cargo run --example standalone [PRESET] [FILE]`

#![allow(clippy::print_stdout, reason = "an example shows what it does")]

use orogen::{Bake, Library, Preset};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_else(|| "alpine".into());

    let library = Library::standard();
    let preset = Preset::named(&name)?;
    let shader = orogen::compose(&library, &preset, &Bake::live(["sun.*"]))?;

    if let Some(path) = arguments.next() {
        std::fs::write(&path, shader.wgsl())?;
    }
    println!("{}: {} lines of WGSL", preset.name(), shader.wgsl().lines().count());
    for entry in &shader.interface().entry_points {
        println!("  {:<9} {}", entry.stage, entry.name);
    }
    let uniform = shader.interface().uniform.as_ref();
    for field in uniform.map(|uniform| uniform.fields.as_slice()).unwrap_or_default() {
        println!("  {:>4} {:<6} {} = {}", field.offset, field.ty, field.name, field.value);
    }
    // What a host writes into its buffer when the sun moves.
    let mut evening = preset.clone();
    evening.set("sun.elevation=4")?;
    let (before, after) = (shader.uniform_bytes(&preset)?, shader.uniform_bytes(&evening)?);
    let changed = before.iter().zip(&after).filter(|(a, b)| a != b).count();
    println!("a lower sun changes {changed} of {} bytes, and recomposes nothing", after.len());
    Ok(())
}
