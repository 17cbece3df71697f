//! Shaders, and the Rust that fits them.

use std::error::Error;

use orogen::build::Bindings;
use orogen::export::Types;
use orogen::{Bake, Preset};

fn main() -> Result<(), Box<dyn Error>> {
    let out = std::env::var("OUT_DIR")?;

    // What the README shows.
    let mut preset = Preset::named("alpine")?;
    preset.set("quality=low")?;
    let bake = Bake::live(["sun.*"]).with_overrides(["ground.*"]);
    let built = Bindings::new(preset).with_bake(bake).write_to(&out, "alpine")?;
    print!("{}", built.cargo());

    // Everything live, at another binding.
    let bake = Bake::live(["*"]).at_binding(1, 2);
    let earth = Bindings::new(Preset::named("earth")?).with_bake(bake).with_types(Types::Glam);
    earth.write_to(&out, "earth")?;

    // A shader of one's own, with everything that bindings can be made of.
    let own = Preset::file("shaders/own.json")?;
    for (types, name) in [(Types::Arrays, "own_arrays"), (Types::Glam, "own_glam")] {
        let bindings = Bindings::new(own.clone()).with_bake(Bake::live(["*"])).with_types(types);
        print!("{}", bindings.write_to(&out, name)?.cargo());
    }
    Ok(())
}
