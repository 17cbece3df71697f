//! What is said when something is wrong: `tests/errors/<a sentence>/` in, the whole of what is said beside it, for people
//! in `expected.txt` and for tools in `expected.json`.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod harness;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use harness::{Case, cases};
use libtest_mimic::{Arguments, Failed, Trial};
use orogen::{Error, Library, Shader};

/// Makes what a case needs.
type Made = fn(&Case) -> Library;

/// Cases whose files cannot lie in a repository: they are made when the test runs.
const MADE: [(&str, Made); 6] = [
    ("a-file-over-16-mib-is-refused", |case| {
        case.library().with_file("large.wgsl", " ".repeat((16 << 20) + 1))
    }),
    ("a-link-out-of-the-root-is-not-followed", linked),
    ("includes-nested-deeper-than-1024-are-refused", |case| {
        (0..1100).fold(case.library(), |library, n| {
            library.with_file(format!("level{n}.wgsl"), format!("#include <level{}.wgsl>\n", n + 1))
        })
    }),
    ("more-than-65536-instances-are-refused", |case| {
        // A binary tree: every level includes the next one twice, each time as an instance of its own.
        let library = case.library().with_file("tree17.wgsl", "const LEAF = 1;\n");
        (0..17).fold(library, |library, n| {
            let next = n + 1;
            let text = format!("#include <tree{next}.wgsl> as l\n#include <tree{next}.wgsl> as r\n");
            library.with_file(format!("tree{n}.wgsl"), text)
        })
    }),
    ("fragments-over-256-mib-together-are-refused", |case| {
        let includes: String = (0..40).map(|n| format!("#include <big.wgsl> as n{n}\n")).collect();
        case.library().with_file("all.wgsl", includes).with_file("big.wgsl", "\n".repeat(8 << 20))
    }),
    ("a-file-that-is-no-text-is-refused", |case| {
        let folder = scratch(case);
        fs::write(folder.join("bytes.wgsl"), b"// caf\xe9\n").unwrap();
        case.library().with_folder(folder).unwrap()
    }),
];

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let mut trials: Vec<_> = cases("errors")
        .into_iter()
        .map(|case| Trial::test(case.name(), move || run(&case).map_err(Failed::from)))
        .collect();
    trials.push(Trial::test("every_code_has_a_case", || every_code_has_a_case().map_err(Failed::from)));
    libtest_mimic::run(&arguments, trials).exit_code()
}

fn run(case: &Case) -> Result<(), String> {
    let name = case.path.file_name().unwrap();
    let library = match MADE.iter().find(|(made, _)| name == *made) {
        Some((_, make)) => make(case),
        None => case.library(),
    };
    let said: Result<Shader, Error> = case.compose_with(&library, None);
    let Err(error) = said else { return Err("there was nothing to complain about".into()) };
    points_inside(&error)?;
    // Only tests see this path, and each machine another one.
    let hide = |text: String| text.replace(&*scratch_path(case).to_string_lossy(), "SCRATCH");
    case.expect("expected.txt", &hide(error.render(false)))?;
    case.expect("expected.json", &hide(error.json_lines()))
}

/// Labels lie inside of their texts, at characters, and one of them says where the fault is.
fn points_inside(error: &Error) -> Result<(), String> {
    for diagnostic in error.diagnostics() {
        for label in &diagnostic.labels {
            let text = &error.files().get(label.file).text;
            if text.get(label.span.range()).is_none() {
                return Err(format!("{} points outside of its text: {label:?}", diagnostic.code));
            }
        }
    }
    Ok(())
}

fn scratch_path(case: &Case) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("errors").join(case.path.file_name().unwrap())
}

fn scratch(case: &Case) -> PathBuf {
    let path = scratch_path(case);
    let _ = fs::remove_dir_all(&path); // of an earlier run
    fs::create_dir_all(&path).unwrap();
    path
}

#[cfg(unix)]
fn linked(case: &Case) -> Library {
    let folder = scratch(case);
    fs::write(folder.join("secret.wgsl"), "const SECRET = 7;\n").unwrap();
    fs::create_dir(folder.join("root")).unwrap();
    std::os::unix::fs::symlink("../secret.wgsl", folder.join("root/link.wgsl")).unwrap();
    case.library().with_folder(folder.join("root")).unwrap()
}

#[cfg(not(unix))]
fn linked(case: &Case) -> Library {
    case.library()
}

/// A code that stands in the source must stand in an expectation too.
fn every_code_has_a_case() -> Result<(), String> {
    let mut in_source = BTreeSet::new();
    codes(Path::new("src"), &mut in_source);
    let mut shown = BTreeSet::new();
    for case in cases("errors") {
        codes(&case.path.join("expected.txt"), &mut shown);
    }
    for folder in ["eval", "faults", "render"] {
        codes(&Path::new("tests").join(folder), &mut shown);
    }
    let missing: Vec<_> = in_source.difference(&shown).collect();
    if missing.is_empty() { Ok(()) } else { Err(format!("no expected text shows {missing:?}")) }
}

fn codes(path: &Path, codes: &mut BTreeSet<String>) {
    if path.is_dir() {
        for entry in fs::read_dir(path).unwrap() {
            self::codes(&entry.unwrap().path(), codes);
        }
        return;
    }
    let text = fs::read_to_string(path).unwrap_or_default();
    for (at, _) in text.match_indices("OR0") {
        let code: String = text[at..].chars().take(6).collect();
        if code.len() == 6 && code[2..].bytes().all(|byte| byte.is_ascii_digit()) {
            codes.insert(code);
        }
    }
}
