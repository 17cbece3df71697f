//! Orogen beside what a user would pick instead, in one run: `cargo xtask bench`.
//!
//! Each part of the suite writes its section of `docs/benchmarks.md`.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a bench prints its tables")]

mod baking;
mod child;
mod composing;
mod elements;
mod faults;
mod gate;
mod gpu;
mod graph;
mod growth;
mod guard;
mod machine;
mod noise;
mod packages;
mod page;
mod plot;
mod time;
mod tool;

use std::path::Path;

use gpu::Lab;
use page::Section;

/// A result, or what went wrong in words: a bench stops at the first fault and says it.
pub(crate) type Outcome<T = ()> = Result<T, Box<dyn std::error::Error>>;

const HELP: &str = "\
usage: peers [PART…] [--quick [--accept]]

Without anything, measures all parts and writes docs/benchmarks.md; with parts, those of its sections alone.

  --quick    instead holds a few ratios against peers/baseline.json, and fails where one is worse by a fifth
  --accept   with --quick: writes that file
";

/// A part of the suite.
struct Part {
    name: &'static str,
    title: &'static str,
    measure: fn(&Lab) -> Outcome<Section>,
}

/// All parts, in the order of the page.
const PARTS: [Part; 6] = [
    Part { name: "composing", title: composing::TITLE, measure: composing::measure },
    Part { name: "faults", title: faults::TITLE, measure: |_| faults::measure() },
    Part { name: "noise", title: noise::TITLE, measure: noise::measure },
    Part { name: "baking", title: baking::TITLE, measure: baking::measure },
    Part { name: "elements", title: elements::TITLE, measure: elements::measure },
    Part { name: "growth", title: growth::TITLE, measure: growth::measure },
];

fn main() -> Outcome {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [first, rest @ ..] = arguments.as_slice()
        && first == "child"
    {
        return child::be(rest);
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().ok_or("peers has no folder above it")?;
    let has = |flag: &str| arguments.iter().any(|argument| argument == flag);
    let names: Vec<&str> =
        arguments.iter().map(String::as_str).filter(|name| !name.starts_with('-')).collect();
    let is_known = |name: &&&str| PARTS.iter().any(|part| part.name == **name);
    let wrong = arguments
        .iter()
        .find(|argument| argument.starts_with('-') && *argument != "--quick" && *argument != "--accept");
    if let Some(wrong) =
        wrong.map(String::as_str).or_else(|| names.iter().find(|name| !is_known(name)).copied())
    {
        let parts: Vec<&str> = PARTS.iter().map(|part| part.name).collect();
        return Err(format!("there is no `{wrong}`; parts are {}\n\n{HELP}", parts.join(", ")).into());
    }
    if has("--quick") {
        return guard::guard(&root.join("peers/baseline.json"), has("--accept"));
    }
    let lab = Lab::open()?;
    let machine = machine::line(&lab)?;
    let mut sections = Vec::new();
    for part in PARTS.iter().filter(|part| names.is_empty() || names.contains(&part.name)) {
        eprintln!("── {}", part.name);
        let mut section = (part.measure)(&lab)?;
        section.text = format!("{machine}\n\n{}", section.text);
        println!("\n## {}\n\n{}", section.title, section.text);
        sections.push(section);
    }
    let page = root.join("docs/benchmarks.md");
    page::write(&page, &head(), &PARTS.map(|part| part.title), sections)?;
    println!("docs/benchmarks.md is written");
    Ok(())
}

fn head() -> String {
    "# Benchmarks

Orogen beside what one would pick instead, each part measured in one run. `cargo xtask bench` runs everything and writes this page,
`cargo xtask bench PART…` some of its sections anew.

The contestants of a row take turns, run by run, so that a busy machine slows all of them. Times are medians of CPU time of the
process in milliseconds, with quartiles in brackets and wall time beside them. Take ratios from here, not milliseconds: machines
differ. Every contestant is the newest version that builds with this project's Rust.
"
    .to_owned()
}
