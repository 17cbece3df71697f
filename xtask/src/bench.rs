//! `cargo xtask bench`: Orogen beside what one would pick instead → docs/benchmarks.md, or a guard over a few ratios.

use crate::install::{self, Install};
use crate::run::{Outcome, cargo, run};

/// What is to be measured.
#[derive(Debug, PartialEq)]
pub(crate) enum What {
    /// These parts of the suite; all where none is named.
    Parts(Vec<String>),
    /// A few ratios, held against the committed ones; with `accept`, those are written instead.
    Quick { accept: bool },
}

/// Builds the suite and runs it.
pub(crate) fn bench(install: Install, what: &What) -> Outcome {
    match what {
        What::Quick { accept } => {
            let mut guard = cargo("run --release -p peers --no-default-features -- --quick");
            guard.args(accept.then_some("--accept"));
            run(&mut guard)
        }
        What::Parts(parts) => {
            install::driver(install)?;
            let mut suite = cargo("run --release -p peers --");
            suite.args(parts).envs(install::driver_for_tests());
            suite.env("MESA_SHADER_CACHE_DISABLE", "true"); // compiling is measured, too
            run(&mut suite)
        }
    }
}
