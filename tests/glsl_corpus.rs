//! All WGSL that lies around, also what was never meant for a fragment shader: each file either becomes GLSL that glslang
//! accepts, or is refused with a code and a place. Nothing panics, and nothing invalid is written.
//!
//! The files of the dependency tree are read where cargo keeps them; none of them is copied here. With `CORPUS=FOLDER` in the
//! environment, those of that folder are judged as well.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod harness;

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use harness::glsl::{composed, folder, glslang};
use naga::{Module, Scalar, ScalarKind, TypeInner};
use orogen::export::{Target, export_entry};
use orogen::source::preset_names;
use orogen::syntax::lex;
use orogen::{Bake, Error, Preset, Templates};

/// What becomes of one text.
enum Outcome {
    Written(String),
    Refused(Error),
}

/// Converts the fragment entry point `entry` of `text`, or the first.
fn convert(name: &str, text: &str, entry: Option<&str>) -> Outcome {
    let templates = Templates::standard();
    let written =
        composed(name, text).and_then(|shader| export_entry(&shader, Target::Glsl, entry, &templates));
    match written {
        Ok(bytes) => Outcome::Written(String::from_utf8(bytes).unwrap()),
        Err(error) => Outcome::Refused(error),
    }
}

/// Codes without a place in the text: naga itself panics on it, there is no fragment entry point, or naga names no place.
const WITHOUT_A_PLACE: [&str; 4] = ["OR0703", "OR0805", "OR0809", "OR0810"];

/// What is wrong with how a refusal is told.
fn badly_told(error: &Error) -> Option<String> {
    let first = error.diagnostics().first()?;
    let told = error.render(false);
    if first.code == "OR0811" {
        return Some(format!("something panicked:\n{told}"));
    }
    if first.labels.is_empty() && !WITHOUT_A_PLACE.contains(&first.code) {
        return Some(format!("the refusal points nowhere:\n{told}"));
    }
    for label in error.diagnostics().iter().flat_map(|one| &one.labels) {
        if error.files().get(label.file).text.get(label.span.range()).is_none() {
            return Some(format!("{label:?} lies outside of its text:\n{told}"));
        }
    }
    None
}

/// An entry point that calls every function of `text` whose parameters have a zero: what no fragment entry point reaches
/// is converted as well.
fn calling_all(text: &str) -> Option<String> {
    let module = naga::front::wgsl::parse_str(text).ok()?;
    let mut calls = String::new();
    for (_, function) in module.functions.iter() {
        let name = function.name.as_deref()?;
        let zeros: Option<Vec<_>> = function.arguments.iter().map(|one| spelled(&module, one.ty)).collect();
        if let Some(zeros) = zeros {
            let zeros: Vec<_> = zeros.iter().map(|ty| format!("{ty}()")).collect();
            let value = if function.result.is_some() { "_ = " } else { "" };
            let _ = writeln!(calls, "    {value}{name}({});", zeros.join(", "));
        }
    }
    let entry = "@fragment fn calls_all_of_them() -> @location(0) vec4<f32>";
    (!calls.is_empty()).then(|| format!("{text}\n{entry} {{\n{calls}    return vec4<f32>();\n}}\n"))
}

/// How a constructible type is written.
fn spelled(module: &Module, ty: naga::Handle<naga::Type>) -> Option<String> {
    let scalar = |scalar: Scalar| match (scalar.kind, scalar.width) {
        (ScalarKind::Float, 4) => Some("f32"),
        (ScalarKind::Sint, 4) => Some("i32"),
        (ScalarKind::Uint, 4) => Some("u32"),
        (ScalarKind::Bool, _) => Some("bool"),
        _ => None,
    };
    let ty = &module.types[ty];
    Some(match ty.inner {
        TypeInner::Scalar(one) => scalar(one)?.into(),
        TypeInner::Vector { size, scalar: one } => format!("vec{}<{}>", size as u32, scalar(one)?),
        TypeInner::Matrix { columns, rows, scalar: one } => {
            format!("mat{}x{}<{}>", columns as u32, rows as u32, scalar(one)?)
        }
        TypeInner::Array { base, size: naga::ArraySize::Constant(count), .. } => {
            format!("array<{}, {count}>", spelled(module, base)?)
        }
        TypeInner::Struct { ref members, .. } => {
            members.iter().try_for_each(|member| spelled(module, member.ty).map(drop))?;
            ty.name.clone()?
        }
        _ => return None,
    })
}

/// Converts each text, as it is and with all its functions called, and has glslang judge what is written.
fn judge(name: &str, texts: &[(String, String)], at_least: usize) {
    let folder = folder(name);
    let mut wrong = Vec::new();
    let mut written = 0;
    for (index, (name, text)) in texts.iter().enumerate() {
        let all = calling_all(text);
        let entries = [(Some(text), None), (all.as_ref(), Some("calls_all_of_them"))];
        for (text, entry) in entries {
            let Some(text) = text else { continue };
            let why = match convert("corpus.wgsl", text, entry) {
                Outcome::Refused(error) => badly_told(&error),
                Outcome::Written(glsl) => {
                    written += 1;
                    let path = folder.join(format!("{index}{}.frag", entry.map_or("", |_| ".all")));
                    fs::write(&path, glsl).unwrap();
                    glslang(&path).err()
                }
            };
            wrong.extend(why.map(|why| format!("{name}{}:\n{why}", entry.map_or("", |_| ", every function"))));
        }
    }
    println!("{written} GLSL files of {} texts", texts.len());
    assert!(wrong.is_empty(), "{} are wrong:\n\n{}", wrong.len(), wrong.join("\n\n"));
    assert!(written >= at_least, "{written} files were written, and at least {at_least} should be");
}

/// The `.wgsl` files in `root` and the folders in it.
fn wgsl_in(root: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(root).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            wgsl_in(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "wgsl") {
            found.push(path);
        }
    }
}

fn texts(root: &Path) -> Vec<(String, String)> {
    let mut paths = Vec::new();
    wgsl_in(root, &mut paths);
    paths.sort();
    // What is no UTF-8 is no WGSL.
    let read = |path: PathBuf| Some((path.display().to_string(), fs::read_to_string(&path).ok()?));
    paths.into_iter().filter_map(read).collect()
}

#[test]
fn wgsl_of_the_dependency_tree_becomes_glsl_or_is_refused() {
    let metadata = Command::new(env!("CARGO")).args(["metadata", "--format-version", "1", "--locked"]).output();
    let metadata: serde_json::Value = serde_json::from_slice(&metadata.unwrap().stdout).unwrap();
    let mut all = Vec::new();
    for package in metadata["packages"].as_array().unwrap() {
        let manifest = Path::new(package["manifest_path"].as_str().unwrap());
        if !package["source"].is_null() {
            all.extend(texts(manifest.parent().unwrap()));
        }
    }
    all.extend(std::env::var_os("CORPUS").into_iter().flat_map(|folder| texts(Path::new(&folder))));
    let named = |package: &str| all.iter().any(|(name, _)| name.contains(package));
    assert!(named("naga-30") && named("wgpu-core-30"), "cargo's folder of packages was not found");
    judge("glsl-tree", &all, 3);
}

#[test]
fn wgsl_of_our_tests_becomes_glsl_or_is_refused() {
    let mut all = texts(Path::new("tests/export/passthrough"));
    all.extend(texts(Path::new("tests/compose")).into_iter().filter(|(name, _)| name.ends_with("expected.wgsl")));
    judge("glsl-tests", &all, 40);
}

#[test]
fn wgsl_of_every_preset_becomes_glsl_with_all_its_functions() {
    let composed = |name: &str| {
        let preset = Preset::named(name).unwrap();
        orogen::compose(&orogen::Library::standard(), &preset, &Bake::default()).unwrap().wgsl().to_owned()
    };
    let all: Vec<_> = preset_names().into_iter().map(|name| (name.to_owned(), composed(name))).collect();
    judge("glsl-presets", &all, all.len());
}

#[test]
fn every_function_of_the_matrix_becomes_glsl() {
    let all = texts(Path::new("tests/glsl"));
    judge("glsl-matrix", &all, all.len());
}

/// A generator of numbers (SplitMix64): the same edits on every run.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % end as u64) as usize
    }
}

/// `text` with one token removed, doubled, exchanged with another, or replaced by another.
fn edited(text: &str, numbers: &mut Numbers) -> String {
    let tokens = lex(text);
    let mut words: Vec<&str> = tokens.iter().map(|(_, span)| &text[span.range()]).collect();
    let solid: Vec<usize> = (0..tokens.len()).filter(|at| !tokens.kind(*at).is_trivia()).collect();
    if solid.is_empty() {
        return text.to_owned();
    }
    let (a, b) = (solid[numbers.below(solid.len())], solid[numbers.below(solid.len())]);
    match numbers.below(4) {
        0 => drop(words.remove(a)),
        1 => words.insert(a, words[a]),
        2 => words.swap(a, b),
        _ => words[a] = words[b],
    }
    words.concat()
}

/// So many edits of each file; with `CASES=20` in the environment, twenty times as many.
const EDITS: usize = 12;

/// The edits end after this long on a slow machine, having tried every file about as often.
const PATIENCE: Duration = Duration::from_secs(60);

#[test]
fn small_edits_of_the_matrix_panic_nowhere_and_give_no_wrong_glsl() {
    let times = std::env::var("CASES").ok().and_then(|times| times.parse::<usize>().ok()).unwrap_or(1);
    let (all, folder, start) = (texts(Path::new("tests/glsl")), folder("glsl-edits"), Instant::now());
    let mut numbers = Numbers(5);
    let mut wrong = Vec::new();
    let mut written = 0;
    for _ in 0..EDITS * times {
        if start.elapsed() > PATIENCE * times as u32 {
            break;
        }
        for (name, text) in &all {
            let edited = edited(text, &mut numbers);
            match convert("edited.wgsl", &edited, None) {
                Outcome::Refused(error) => {
                    wrong.extend(badly_told(&error).map(|why| format!("{name}:\n{why}\nof\n{edited}")));
                }
                Outcome::Written(glsl) => {
                    fs::write(folder.join(format!("{written}.frag")), &glsl).unwrap();
                    fs::write(folder.join(format!("{written}.wgsl")), &edited).unwrap();
                    written += 1;
                }
            }
        }
    }
    // All at once: a process for each would take longer than the rest.
    let files: Vec<_> = (0..written).map(|index| folder.join(format!("{index}.frag"))).collect();
    for some in files.chunks(200) {
        let output = Command::new("glslangValidator").args(["-S", "frag"]).args(some).output();
        let output = output.expect("glslangValidator is here: `cargo xtask test` installs it");
        if !output.status.success() {
            wrong.extend(some.iter().filter_map(|path| {
                let said = glslang(path).err()?;
                Some(format!("{said}\nof\n{}", fs::read_to_string(path.with_extension("wgsl")).unwrap()))
            }));
        }
    }
    println!("{written} edited files were written as GLSL");
    assert!(written > all.len() / 4, "only {written} edits were written: this proves little");
    assert!(wrong.is_empty(), "{} are wrong:\n\n{}", wrong.len(), wrong.join("\n\n"));
}
