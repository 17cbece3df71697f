//! All parts of the suite, each of which writes its section of `docs/benchmarks.md`.

mod baking;
mod composing;
mod elements;
mod gate;
mod gpu;
mod growth;
mod machine;
mod noise;
mod packages;
mod plot;

use std::path::Path;

use crate::page::{self, Section};
use crate::{Outcome, faults};
use gpu::Lab;

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

/// Measures the parts that are named, or all where none is, and writes their sections of the page under `root`.
pub(crate) fn run(root: &Path, names: &[&str]) -> Outcome {
    let is_known = |name: &&&str| PARTS.iter().any(|part| part.name == **name);
    if let Some(unknown) = names.iter().find(|name| !is_known(name)) {
        let parts: Vec<&str> = PARTS.iter().map(|part| part.name).collect();
        return Err(format!("there is no part `{unknown}`; parts are {}", parts.join(", ")).into());
    }
    let lab = Lab::open()?;
    let machine = machine::line(&lab)?;
    let page = root.join("docs/benchmarks.md");
    for part in PARTS.iter().filter(|part| names.is_empty() || names.contains(&part.name)) {
        eprintln!("── {}", part.name);
        let mut section = (part.measure)(&lab)?;
        section.text = format!("{machine}\n\n{}", section.text);
        println!("\n## {}\n\n{}", section.title, section.text);
        // At once: where a later part fails, this one need not be measured again.
        page::write(&page, &head(), &PARTS.map(|part| part.title), &section)?;
    }
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
