//! What fragments become: `tests/compose/<a sentence>/` in, `expected.wgsl` beside it. Every result passes naga.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod harness;

use std::path::Path;
use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial};

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let trials = harness::cases("compose").into_iter().map(|case| {
        Trial::test(case.name(), move || {
            // The look of the result is pinned, but where a case brings templates of its own.
            let pinned = Path::new("tests/compose/templates");
            let shader = case.compose(Some(pinned)).map_err(|error| Failed::from(error.to_string()))?;
            case.expect("expected.wgsl", shader.wgsl()).map_err(Failed::from)
        })
    });
    libtest_mimic::run(&arguments, trials.collect()).exit_code()
}
