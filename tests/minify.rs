//! What `--minify` writes: as valid as before, the same module to naga but for names, and less than half of the bytes.

#![expect(clippy::panic, reason = "a test says what it found")]

mod harness;

use std::path::{Path, PathBuf};

use orogen::export::{Minified, Target, export, minify, source_map};
use orogen::source::{Span, preset_names};
use orogen::syntax::{TokenKind, lex};
use orogen::{Bake, Compose, Library, Preset, Shader, Templates};

fn composed(preset: &Preset, target: Target, bake: Bake, keep_unused: bool) -> Result<Shader, orogen::Error> {
    let mut compose = Compose::default();
    compose.stage = target.stage(None).expect("every target has a stage");
    compose.keep_unused = keep_unused;
    compose.run(&Library::standard(), preset, &target.bake(bake))
}

fn minified(shader: &Shader) -> Minified {
    minify(shader, &Templates::standard()).unwrap_or_else(|error| panic!("{}", error.render(false)))
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).expect("is text")
}

/// naga's module without what nothing reaches, and without a name but those of entry points, overrides and bindings.
fn nameless(shader: &Shader, keep: naga::compact::KeepUnused) -> String {
    let mut module = shader.checked().module.clone();
    naga::compact::compact(&mut module, keep);
    module.diagnostic_filters = naga::Arena::new(); // their debug text has spans in it
    module.doc_comments = None;
    let types: Vec<_> = module.types.iter().map(|(handle, ty)| (handle, ty.clone())).collect();
    for (index, (handle, mut ty)) in types.into_iter().enumerate() {
        if ty.name.is_none() {
            continue;
        }
        ty.name = Some(format!("type{index}"));
        if let naga::TypeInner::Struct { members, .. } = &mut ty.inner {
            members.iter_mut().for_each(|member| member.name = None);
        }
        module.types.replace(handle, ty);
    }
    module.constants.iter_mut().for_each(|(_, constant)| constant.name = None);
    let globals = module.global_variables.iter_mut().filter(|(_, global)| global.binding.is_none());
    globals.for_each(|(_, global)| global.name = None);
    let entries = module.entry_points.iter_mut().map(|entry| &mut entry.function);
    for function in entries.chain(module.functions.iter_mut().map(|(_, function)| function)) {
        function.name = None;
        function.arguments.iter_mut().for_each(|argument| argument.name = None);
        function.local_variables.iter_mut().for_each(|(_, local)| local.name = None);
        function.named_expressions.iter_mut().for_each(|(_, name)| name.clear());
    }
    let text = format!("{module:#?}");
    let is_span = |line: &&str| ["start: ", "end: "].iter().any(|field| line.trim_start().starts_with(field));
    text.lines().filter(|line| !is_span(line)).collect::<Vec<_>>().join("\n")
}

/// Minifies, holds the result against what it was, and gives it back.
fn holds(name: &str, shader: &Shader) -> Minified {
    let small = minified(shader);
    for keep in [naga::compact::KeepUnused::Yes, naga::compact::KeepUnused::No] {
        let (before, after) = (nameless(shader, keep), nameless(small.shader(), keep));
        let difference = before.lines().zip(after.lines()).find(|(before, after)| before != after);
        assert_eq!(difference, None, "{name}:\n{}", small.shader().wgsl());
        assert_eq!(before.len(), after.len(), "{name}");
    }
    assert_eq!(small.shader().interface(), shader.interface(), "{name}: the host sees what it saw");
    small
}

fn bakes() -> [Bake; 3] {
    [Bake::constants(), Bake::constants().with_overrides(["*"]), Bake::live(["*"])]
}

#[test]
fn every_preset_loses_more_than_half_of_its_bytes() {
    println!("{:20} {:>9} {:>7} {:>7} {:>5}", "preset", "target", "before", "after", "cut");
    let mut least = 1.0f64;
    for name in preset_names() {
        let preset = Preset::named(name).expect("is built in");
        for target in [Target::Wgsl, Target::Glsl, Target::Shadertoy] {
            let shader = composed(&preset, target, Bake::default(), false).expect("is valid");
            let before = export(&shader, target, &Templates::standard()).expect("is written");
            let after = minified(&shader).export(target, None, &Templates::standard()).expect("is written");
            let cut = 1.0 - after.len() as f64 / before.len() as f64;
            println!("{name:20} {target:>9} {:7} {:7} {:4.1}%", before.len(), after.len(), 100.0 * cut);
            least = least.min(cut);
        }
    }
    assert!(least >= 0.55, "{least}");
}

#[test]
fn every_preset_is_the_same_module_but_for_names() {
    for name in preset_names() {
        let preset = Preset::named(name).expect("is built in");
        for bake in bakes() {
            for target in [Target::Wgsl, Target::Shadertoy] {
                holds(name, &composed(&preset, target, bake.clone(), false).expect("is valid"));
            }
        }
    }
}
