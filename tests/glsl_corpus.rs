//! All WGSL that lies around, also what was never meant for a fragment shader: each file either becomes GLSL that glslang
//! accepts, or is refused with a code and a place. Nothing panics, and nothing invalid is written.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod harness;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use harness::corpus::{Numbers, edited, of_our_tests, texts, tree};
use harness::glsl::{composed, folder, glslang};
use naga::{Module, Scalar, ScalarKind, TypeInner};
use orogen::export::{Target, export_entry};
use orogen::source::preset_names;
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

/// Codes without a place in the text: naga names none, or panics itself, or there is no fragment entry point.
const WITHOUT_A_PLACE: [&str; 3] = ["OR0701", "OR0703", "OR0805"];

/// What is wrong with how a refusal is told.
fn badly_told(error: &Error) -> Option<String> {
    let first = error.diagnostics().first()?;
    let told = error.render(false);
    if matches!(first.code, "OR0811" | "OR0812") {
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
            wrong
                .extend(why.map(|why| format!("{name}{}:\n{why}", entry.map_or("", |_| ", every function"))));
        }
    }
    assert!(wrong.is_empty(), "{} are wrong:\n\n{}", wrong.len(), wrong.join("\n\n"));
    assert!(written >= at_least, "{written} files were written, and at least {at_least} should be");
}

#[test]
fn wgsl_of_the_dependency_tree_becomes_glsl_or_is_refused() {
    let all = tree();
    judge("glsl-tree", &all, 3);
}

#[test]
fn wgsl_of_our_tests_becomes_glsl_or_is_refused() {
    judge("glsl-tests", &of_our_tests(), 40);
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
