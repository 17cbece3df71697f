//! `cargo xtask demo`: one preset as a shader for programs, a shader for Shadertoy and a picture.

use crate::install::{Install, lavapipe};
use crate::run::{Failure, Outcome, cargo, check, create_folder, orogen, output, root, run, shown};

/// `orogen`'s exit status where no GPU adapter answers.
const NO_ADAPTER: i32 = 3;

/// Builds Orogen, finds a Vulkan adapter or installs one, and makes the three files.
pub(crate) fn demo(install: Install) -> Outcome {
    println!("Building Orogen. The first time this takes minutes, later seconds.");
    run(&mut cargo("build --release"))?;
    see_to_adapter(install)?;
    create_folder(&root().join("out"))?;
    run(&mut orogen(&["export", "alpine", "-o", "out/alpine.wgsl"])?)?;
    run(&mut orogen(&["export", "alpine", "--target", "shadertoy", "-o", "out/alpine.shadertoy.glsl"])?)?;
    run(&mut orogen(&["render", "alpine", "--size", "960x540", "--samples", "4", "-o", "out/alpine.png"])?)?;
    tell_what_now()
}

fn tell_what_now() -> Outcome {
    let out = root().join("out");
    let orogen = shown(&orogen(&[])?);
    println!(
        "
In {}:

alpine.wgsl
    The whole landscape as one WGSL module with nothing to include, the preset's values as constants at its
    top: change one and see. Hand it to createShaderModule in a browser, or to wgpu;
    `{orogen} export alpine --target json` names its entry points and bindings.
alpine.shadertoy.glsl
    The same for Shadertoy. Open shadertoy.com/new, paste it over what is there, press Alt+Enter.
alpine.png
    Its picture, drawn on this machine.

What to try next:
    {orogen} list presets
    {orogen} params alpine
    {orogen} render alpine --set sun.elevation=8 --samples 16 -o out/evening.png",
        out.display()
    );
    Ok(())
}

/// Sees to it that `orogen` finds a GPU adapter. Any adapter will do, lavapipe is for machines that have none.
pub(crate) fn see_to_adapter(install: Install) -> Outcome {
    println!("\nLooking for a GPU adapter…");
    if adapter_answers()? {
        return Ok(());
    }
    if !cfg!(target_os = "linux") {
        let remedy = "this system comes with one: please look at the graphics driver".to_owned();
        return Err(Failure::Missing { what: "a GPU adapter".to_owned(), remedy });
    }
    println!("None answers. A software one will do.");
    lavapipe(install)?;
    if adapter_answers()? {
        return Ok(());
    }
    Err(Failure::Check("lavapipe is installed, yet `orogen eval 1.0` still finds no adapter".to_owned()))
}

/// Whether the smallest job for a GPU succeeds.
fn adapter_answers() -> Outcome<bool> {
    let mut probe = orogen(&["eval", "1.0"])?;
    println!("$ {}", shown(&probe));
    let answer = output(&mut probe)?;
    if answer.status.code() == Some(NO_ADAPTER) {
        return Ok(false);
    }
    check(&probe, answer.status, String::from_utf8_lossy(&answer.stderr).into_owned())?;
    Ok(true)
}
