//! Orogen beside what a user would pick instead, in one run: `cargo xtask bench`.
//!
//! What the guard needs stands here and builds without a GPU stack; `suite/` has the rest, behind the feature of that name.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a bench prints its tables")]
#![cfg_attr(
    not(feature = "suite"),
    allow(dead_code, reason = "the guard asks for a part of what can be measured")
)]

mod child;
mod contest;
mod faults;
mod graph;
mod guard;
mod page;
#[cfg(feature = "suite")]
mod suite;
mod time;
mod tool;

use std::path::Path;

/// A result, or what went wrong in words: a bench stops at the first fault and says it.
pub(crate) type Outcome<T = ()> = Result<T, Box<dyn std::error::Error>>;

const HELP: &str = "\
usage: peers [PART…] [--quick [--accept]]

Without anything, measures all parts and writes docs/benchmarks.md; with parts, those of its sections alone.

  --quick    instead holds a few ratios against peers/baseline.json, and fails where one is worse by a fifth
  --accept   with --quick: writes that file
";

fn main() -> Outcome {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [first, rest @ ..] = arguments.as_slice()
        && first == "child"
    {
        return child::be(rest);
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().ok_or("peers has no folder above it")?;
    let (flags, names): (Vec<&str>, Vec<&str>) =
        arguments.iter().map(String::as_str).partition(|argument| argument.starts_with('-'));
    if let Some(unknown) = flags.iter().find(|flag| !["--quick", "--accept"].contains(flag)) {
        return Err(format!("there is no `{unknown}`\n\n{HELP}").into());
    }
    match (flags.contains(&"--quick"), flags.contains(&"--accept")) {
        (true, accept) if names.is_empty() => guard::guard(&root.join("peers/baseline.json"), accept),
        (false, false) => parts(root, &names),
        _ => Err(format!("`--accept` goes with `--quick`, and parts with neither\n\n{HELP}").into()),
    }
}

#[cfg(feature = "suite")]
fn parts(root: &Path, names: &[&str]) -> Outcome {
    suite::run(root, names)
}

#[cfg(not(feature = "suite"))]
fn parts(_: &Path, _: &[&str]) -> Outcome {
    Err("built without the feature `suite`, which all but `--quick` needs".into())
}
