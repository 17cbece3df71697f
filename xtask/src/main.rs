//! Orogen's chores: `cargo xtask demo`, `cargo xtask test` and the smaller ones.
//!
//! Every chore says each command before it runs it, so that whoever wants to can type them by hand.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a chore's job is to tell a person what it does"
)]

mod accuracy;
mod bench;
mod browser;
mod cases;
mod demo;
mod gallery;
mod install;
mod judges;
mod pictures;
mod run;
mod test;

use std::process::ExitCode;

use install::Install;
use run::Outcome;

const HELP: &str = "\
Orogen's chores

usage: cargo xtask <demo|test|judge [NAME…]|accuracy|gallery [NAME…]|bench [PART…]> [--no-install]

  demo      builds Orogen and makes out/alpine.wgsl (a shader to put into your own program),
            out/alpine.shadertoy.glsl (a shader to paste into Shadertoy) and out/alpine.png (its picture)
  test      everything that must hold before a change goes in: formatting, lints, the build without a GPU,
            all tests, the examples, the judges, the documentation
  judge     the judges alone: Tint, glslang and spirv-val on all that Orogen writes for its presets, views
            and modules, and Chromium, which draws every preset: its picture must be that of `orogen render`.
            With names, what is written for those presets only
  accuracy  measures the library and writes docs/accuracy.md: what each function promises, and what it keeps
  gallery   draws the built-in presets, or those named, into docs/gallery/ and writes docs/gallery.md

  bench     measures Orogen beside what one would pick instead, all parts or those named, and writes
            docs/benchmarks.md; takes an hour. With --quick, a few ratios in under three minutes, held against
            peers/baseline.json: one that is worse by a fifth fails; with --quick --accept, writes that file

  --no-install   install nothing: say what is missing and how to get it, and stop

Without --no-install a chore installs what it needs and the machine lacks, through the system's package
manager, and says so: Mesa's software Vulkan driver (lavapipe) and GL, glslang, SPIRV-Tools, Chromium (CHROMIUM
names another browser of its kind), Node.js. Tint and what drives the browser (playwright-core) come from npm into
tests/judges/node_modules.

Exit status: 0 all is well; 1 something failed, and the last lines say what; 2 wrong usage
";

/// What the command line asks for.
#[derive(Debug, PartialEq)]
enum Chore {
    Demo(Install),
    Test(Install),
    Judge(Install, Vec<String>),
    Accuracy(Install),
    Gallery(Install, Vec<String>),
    Bench(Install, bench::What),
    Help,
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let chore = match parse(&arguments) {
        Ok(chore) => chore,
        Err(complaint) => {
            eprintln!("error: {complaint}\n\n{HELP}");
            return ExitCode::from(2);
        }
    };
    match carry_out(&chore) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("\nerror: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn carry_out(chore: &Chore) -> Outcome {
    match chore {
        Chore::Demo(install) => demo::demo(*install),
        Chore::Test(install) => test::test(*install),
        Chore::Judge(install, names) => judges::judge_alone(*install, names),
        Chore::Accuracy(install) => accuracy::accuracy(*install),
        Chore::Gallery(install, names) => gallery::gallery(*install, names),
        Chore::Bench(install, what) => bench::bench(*install, what),
        Chore::Help => {
            print!("{HELP}");
            Ok(())
        }
    }
}

/// The chore that `arguments` (without the program's name) ask for, or what is wrong with them.
fn parse(arguments: &[String]) -> Result<Chore, String> {
    let mut install = Install::WhatIsMissing;
    let mut names = Vec::new();
    let (mut quick, mut accept) = (false, false);
    for argument in arguments {
        match argument.as_str() {
            "-h" | "--help" | "help" => return Ok(Chore::Help),
            "--no-install" => install = Install::Nothing,
            "--quick" => quick = true,
            "--accept" => accept = true,
            flag if flag.starts_with('-') => return Err(format!("there is no flag `{flag}`")),
            name => names.push(name),
        }
    }
    let owned = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    if (quick || accept) && names != ["bench"] {
        return Err("`--quick` and `--accept` are for `bench` without parts".to_owned());
    }
    match names.as_slice() {
        [] => Err("which chore?".to_owned()),
        ["demo"] => Ok(Chore::Demo(install)),
        ["test"] => Ok(Chore::Test(install)),
        ["judge", presets @ ..] => Ok(Chore::Judge(install, owned(presets))),
        ["accuracy"] => Ok(Chore::Accuracy(install)),
        ["gallery", presets @ ..] => Ok(Chore::Gallery(install, owned(presets))),
        ["bench"] if accept && !quick => Err("`--accept` goes with `--quick`".to_owned()),
        ["bench"] if quick => Ok(Chore::Bench(install, bench::What::Quick { accept })),
        ["bench", parts @ ..] => Ok(Chore::Bench(install, bench::What::Parts(owned(parts)))),
        [name] => Err(format!("there is no chore `{name}`")),
        [_, second, ..] => Err(format!("one chore at a time: `{second}` is one too many")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(line: &str) -> Result<Chore, String> {
        let arguments: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        parse(&arguments)
    }

    #[test]
    fn a_chore_installs_unless_told_not_to() {
        assert_eq!(parsed("demo"), Ok(Chore::Demo(Install::WhatIsMissing)));
        assert_eq!(parsed("test --no-install"), Ok(Chore::Test(Install::Nothing)));
        assert_eq!(parsed("--no-install judge"), Ok(Chore::Judge(Install::Nothing, Vec::new())));
        assert_eq!(parsed("accuracy"), Ok(Chore::Accuracy(Install::WhatIsMissing)));
    }

    #[test]
    fn the_gallery_and_the_judges_take_names_and_nothing_else_does() {
        let names = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
        assert_eq!(parsed("gallery"), Ok(Chore::Gallery(Install::WhatIsMissing, names(&[]))));
        let two = Chore::Gallery(Install::Nothing, names(&["alpine", "dunes"]));
        assert_eq!(parsed("gallery alpine --no-install dunes"), Ok(two));
        let one = Chore::Judge(Install::WhatIsMissing, names(&["earth"]));
        assert_eq!(parsed("judge earth"), Ok(one));
        assert!(parsed("accuracy alpine").is_err());
    }

    #[test]
    fn the_bench_takes_parts_or_is_quick() {
        let parts = |parts: &[&str]| bench::What::Parts(parts.iter().map(|&part| part.to_owned()).collect());
        let of = |what| Ok(Chore::Bench(Install::WhatIsMissing, what));
        assert_eq!(parsed("bench"), of(parts(&[])));
        assert_eq!(parsed("bench noise composing"), of(parts(&["noise", "composing"])));
        assert_eq!(parsed("bench --quick"), of(bench::What::Quick { accept: false }));
        assert_eq!(parsed("bench --accept --quick"), of(bench::What::Quick { accept: true }));
        for line in ["bench --accept", "bench noise --quick", "test --quick", "gallery alpine --accept"] {
            assert!(parsed(line).is_err(), "`{line}` passed");
        }
    }

    #[test]
    fn help_wins_over_everything_before_a_mistake() {
        assert_eq!(parsed("--help"), Ok(Chore::Help));
        assert_eq!(parsed("demo --help"), Ok(Chore::Help));
    }

    #[test]
    fn nothing_unknown_and_too_much_are_wrong_usage() {
        for line in ["", "--no-install", "tset", "test --install", "demo test"] {
            assert!(parsed(line).is_err(), "`{line}` passed");
        }
    }
}
