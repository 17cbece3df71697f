//! What `--minify` writes: as valid as before, the same module to naga but for names, and less than half of the bytes.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod harness;

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use harness::corpus::{Numbers, edited, of_our_tests, texts, tree};
use harness::glsl::folder;
use naga::compact::{KeepUnused, compact};
use orogen::export::{Minified, Target, export, minify, source_map};
use orogen::source::preset_names;
use orogen::syntax::{TokenKind, lex};
use orogen::{Bake, Compose, Error, Library, Preset, Shader, Templates};

fn composed(preset: &Preset, target: Target, bake: Bake, keep_unused: bool) -> Result<Shader, Error> {
    let mut compose = Compose::default();
    compose.stage = target.stage(None)?;
    compose.keep_unused = keep_unused;
    compose.run(&Library::standard(), preset, &target.bake(bake))
}

fn minified(shader: &Shader) -> Minified {
    minify(shader, &Templates::standard()).unwrap_or_else(|error| panic!("{}", error.render(false)))
}

/// naga's module without what nothing reaches, and without a name but those of entry points, overrides and bindings.
fn nameless(shader: &Shader, keep: KeepUnused) -> String {
    let mut module = shader.checked().module.clone();
    compact(&mut module, keep);
    module.diagnostic_filters = naga::Arena::new(); // their debug text has spans in it
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
    let text = format!("{module:?}");
    let mut pieces = text.split("Span { start: ");
    let mut without_spans = pieces.next().unwrap().to_owned();
    pieces.for_each(|piece| without_spans.push_str(&piece[piece.find('}').unwrap()..]));
    without_spans
}

/// Minifies, holds the result against what it was, and gives it back.
fn holds(name: &str, shader: &Shader, keep: KeepUnused) -> Minified {
    let small = minified(shader);
    let (before, after) = (nameless(shader, keep), nameless(small.shader(), keep));
    if before != after {
        let at = before.bytes().zip(after.bytes()).take_while(|(before, after)| before == after).count();
        let around = |text: &str| text.chars().skip(at.saturating_sub(200)).take(400).collect::<String>();
        let (before, after, text) = (around(&before), around(&after), small.shader().wgsl());
        panic!("{name}: naga reads\n{after}\ninstead of\n{before}\nfrom\n{text}");
    }
    assert_eq!(small.shader().interface(), shader.interface(), "{name}: the host sees what it saw");
    small
}

/// How many bytes gzip makes of `bytes`.
fn gzipped(bytes: &[u8]) -> usize {
    let mut gzip =
        Command::new("gzip").args(["-9", "-c"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let (mut input, bytes) = (gzip.stdin.take().unwrap(), bytes.to_vec());
    let writer = std::thread::spawn(move || input.write_all(&bytes));
    let output = gzip.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    output.stdout.len()
}

/// The least share of the bytes that goes. naga's GLSL has no comments to begin with, and names of its own for every step.
fn least_cut(target: Target) -> f64 {
    if target == Target::Wgsl { 0.7 } else { 0.5 }
}

#[test]
fn every_preset_loses_more_than_half_of_its_bytes_and_stays_valid() {
    let folder = folder("minified");
    let page = include_str!("../xtask/src/shadertoy.frag");
    let mut files: Vec<PathBuf> = Vec::new();
    println!("preset                   target  before   after    cut  gzipped");
    for name in preset_names() {
        let preset = Preset::named(name).unwrap();
        for target in [Target::Wgsl, Target::Glsl, Target::Shadertoy] {
            let shader = composed(&preset, target, Bake::default(), false).unwrap();
            let before = export(&shader, target, &Templates::standard()).unwrap();
            let small =
                if target == Target::Glsl { minified(&shader) } else { holds(name, &shader, KeepUnused::No) };
            let after = small.export(target, None, &Templates::standard()).unwrap();
            let cut = 1.0 - after.len() as f64 / before.len() as f64;
            let zipped = gzipped(&after);
            println!(
                "{name:20} {:>10} {:7} {:7} {:5.1}% {zipped:8}",
                target.name(),
                before.len(),
                after.len(),
                100.0 * cut
            );
            assert!(cut >= least_cut(target), "{name} as {target} loses only {:.1} %", 100.0 * cut);
            let text = String::from_utf8(after).unwrap();
            let comments: Vec<&str> = text.lines().filter(|line| line.contains("//")).collect();
            assert_eq!(comments.len(), 1, "{comments:?}");
            assert!(
                comments[0].contains("MIT OR Apache-2.0") && comments[0].contains(env!("CARGO_PKG_VERSION"))
            );
            if target != Target::Wgsl {
                let path = folder.join(format!("{name}.{target}.frag"));
                let page = if target == Target::Shadertoy { page } else { "" };
                std::fs::write(&path, page.to_owned() + &text).unwrap();
                files.push(path);
            }
        }
    }
    let output = Command::new("glslangValidator").args(["-S", "frag"]).args(&files).output();
    let output = output.expect("glslangValidator is here: `cargo xtask test` installs it");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}

#[test]
fn live_parameters_and_overrides_keep_their_names_and_the_module_is_the_same() {
    let bakes = [Bake::constants().with_overrides(["*"]), Bake::live(["*"])];
    for (index, name) in preset_names().into_iter().enumerate() {
        let preset = Preset::named(name).unwrap();
        let shader = composed(&preset, Target::Wgsl, bakes[index % 2].clone(), false).unwrap();
        let small = holds(name, &shader, KeepUnused::No);
        let (before, after) = (shader.uniform_bytes(&preset), small.shader().uniform_bytes(&preset));
        assert_eq!(before.unwrap(), after.unwrap());
    }
}

/// Composes each text in both ways, and holds it; gives how many naga accepts.
fn hold_all(all: &[(String, String)]) -> usize {
    let mut count = 0;
    for (name, text) in all {
        for keep_unused in [false, true] {
            let preset = Preset::of_text("corpus.wgsl", text);
            if let Ok(shader) = composed(&preset, Target::Wgsl, Bake::default(), keep_unused) {
                holds(name, &shader, KeepUnused::Yes);
                count += 1;
            }
        }
    }
    count
}

#[test]
fn every_module_alone_keeps_the_names_that_it_is_there_for() {
    for path in Library::standard().modules() {
        let shader = composed(&Preset::of_module(&path), Target::Wgsl, Bake::default(), true).unwrap();
        let small = holds(&path, &shader, KeepUnused::Yes);
        let names = |shader: &Shader| {
            let functions = shader.checked().module.functions.iter();
            functions.map(|(_, function)| function.name.clone()).collect::<Vec<_>>()
        };
        if shader.interface().entry_points.is_empty() {
            assert_eq!(names(&shader), names(small.shader()), "{path}");
        }
    }
}

#[test]
fn wgsl_of_our_tests_and_of_the_matrix_is_the_same_module_but_for_names() {
    assert!(hold_all(&of_our_tests()) >= 100);
    let matrix = texts(Path::new("tests/glsl"));
    assert!(hold_all(&matrix) >= 390); // naga refuses some that Tint takes
}

#[test]
fn wgsl_of_the_dependency_tree_is_the_same_module_but_for_names() {
    assert!(hold_all(&tree()) >= 6);
}

/// naga's own tests are Rust: every string in them that naga parses is one of its inputs.
#[test]
fn the_inputs_in_nagas_own_tests_are_the_same_modules_but_for_names() {
    let inputs: Vec<_> =
        harness::corpus::strings_in_naga().into_iter().map(|text| (text.clone(), text)).collect();
    let count = hold_all(&inputs);
    println!("{count} of {} strings twice over", inputs.len());
    assert!(count >= 50, "{count}");
}

#[test]
fn small_edits_of_the_matrix_that_naga_accepts_are_the_same_module_but_for_names() {
    let times = std::env::var("CASES").ok().and_then(|times| times.parse::<usize>().ok()).unwrap_or(1);
    let (all, mut numbers) = (texts(Path::new("tests/glsl")), Numbers(11));
    let edits: Vec<_> = (0..4 * times)
        .flat_map(|_| &all)
        .map(|(name, text)| (name.clone(), edited(text, &mut numbers)))
        .collect();
    let count = hold_all(&edits);
    assert!(count > edits.len() / 12, "only {count} of {} edits are WGSL", edits.len());
}

#[test]
fn the_map_of_a_minified_shader_leads_from_every_name_to_the_authors() {
    let preset = Preset::named("alpine").unwrap();
    let shader = composed(&preset, Target::Wgsl, Bake::live(["sun.*"]), false).unwrap();
    let small = minified(&shader);
    let baked = &small.shader().checked().baked;
    let (mut names, mut others) = (0, 0);
    for (kind, span) in lex(&baked.text).iter().filter(|(kind, _)| !kind.is_trivia()) {
        let Some(segment) = baked.map.segments().iter().find(|one| one.out == span) else { continue };
        let source = baked.composition.files.get(segment.file).slice(segment.from);
        let token = &baked.text[span.range()];
        if segment.copied {
            assert_eq!(source, token);
        } else if kind == TokenKind::Ident {
            assert!(
                source.starts_with(|c: char| c.is_alphabetic() || "_#/".contains(c)),
                "`{token}` from `{source}`"
            );
            names += 1;
        }
        others += 1;
    }
    assert!(names > 1000 && others > 10_000, "{names} names, {others} tokens");
    // A declaration's new name leads to its old one, in the file that declares it.
    let main = shader.wgsl().lines().find(|line| line.starts_with("fn terrain_height(")).unwrap();
    assert!(!small.shader().wgsl().contains("terrain_height("), "{main}");
    let found = baked.map.segments().iter().any(|one| {
        let file = baked.composition.files.get(one.file);
        file.slice(one.from) == "terrain_height" && !one.copied && &*file.name == "terrain/height.wgsl"
    });
    assert!(found, "nothing leads to terrain_height");
    let json: serde_json::Value = serde_json::from_str(&source_map(small.shader(), "small.wgsl")).unwrap();
    assert!(json["mappings"].as_str().unwrap().len() > 10_000);
}

#[cfg(feature = "render")]
#[test]
fn minified_alpine_is_the_same_picture_to_the_last_bit() {
    use orogen::render::{Gpu, Shot, render};
    let gpu = Gpu::new(None).expect("the tests run on lavapipe: `cargo xtask test`");
    let preset = Preset::named("alpine").unwrap();
    let shader = composed(&preset, Target::Wgsl, Bake::default(), false).unwrap();
    let drawn = |shader: &Shader| render(&gpu, shader, &preset, &Shot::new(96, 54), &mut |_, _| {}).unwrap();
    let (before, after) = (drawn(&shader), drawn(minified(&shader).shader()));
    assert_eq!(before.pixels.len(), after.pixels.len());
    assert!(before.pixels == after.pixels, "the pictures differ");
}

#[test]
fn a_target_that_is_no_text_for_a_compiler_is_refused() {
    let text = "fn main_image(p: vec2f) -> vec4f { return p.xyxy; }";
    let shader =
        composed(&Preset::of_text("scene.wgsl", text), Target::Wgsl, Bake::default(), false).unwrap();
    for target in Target::ALL.into_iter().filter(|target| !target.is_minified()) {
        let error =
            minified(&shader).export(target, None, &Templates::standard()).expect_err("makes no sense");
        assert_eq!(error.diagnostics()[0].code, "OR0820", "{error}");
    }
}

/// Time of the largest preset, release build: `cargo test --release --test minify -- --nocapture fast`.
#[test]
fn minifying_is_fast_and_linear() {
    let mut times = Vec::new();
    let largest = preset_names().into_iter().map(|name| {
        let preset = Preset::named(name).unwrap();
        composed(&preset, Target::Wgsl, Bake::default(), false).unwrap()
    });
    let largest = largest.max_by_key(|shader| shader.wgsl().len()).unwrap();
    for copies in [1, 4] {
        let text: String = (0..copies).map(|copy| copied(largest.wgsl(), copy)).collect();
        let best = (0..5).map(|_| {
            let start = cpu_time::ThreadTime::now();
            assert!(orogen::export::minify_text(&text).len() < text.len() / 2);
            start.elapsed().as_secs_f64()
        });
        times.push(best.fold(f64::INFINITY, f64::min));
    }
    println!(
        "{} bytes: {:.2} ms; four times as many: {:.2} ms",
        largest.wgsl().len(),
        1e3 * times[0],
        1e3 * times[1]
    );
    assert!(times[1] < 8.0 * times[0], "{times:?}");
    assert!(cfg!(debug_assertions) || times[0] < 0.01, "{times:?}");
}

/// `text` under names of its own: every identifier that it declares gets a number behind it.
fn copied(text: &str, copy: usize) -> String {
    let tokens = lex(text);
    let module = naga::front::wgsl::parse_str(text).unwrap();
    let functions = module.functions.iter().filter_map(|(_, function)| function.name.clone());
    let own: std::collections::HashSet<String> = functions.collect();
    let words = tokens.iter().map(|(kind, span)| {
        let word = &text[span.range()];
        if kind == TokenKind::Ident && own.contains(word) {
            format!("{word}_{copy}")
        } else {
            word.to_owned()
        }
    });
    words.collect()
}
