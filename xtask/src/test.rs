//! `cargo xtask test`: everything that must hold before a change goes in. The first failure stops it.

use std::collections::BTreeSet;

use crate::bench::{What, bench};
use crate::install::{self, Install};
use crate::judges;
use crate::run::{Failure, Outcome, Steps, built, capture, cargo, run, shown, target};

/// What must not be in the tree of a build without default features: a GPU stack, and what only the command line needs.
const ONLY_BY_FEATURE: [&str; 5] = ["wgpu", "clap", "image", "indicatif", "notify"];

/// How many crates a build without default features may have in all, Orogen itself and what macros are made of included.
const MOST_CRATES: usize = 25;

/// What is built, in every step the same: features are united over what is chosen, and another choice would build the GPU
/// stack anew. `peers` brings the contestants of `cargo xtask bench`: its guard, built by itself, pays for
/// two of them, and nobody else for any.
const ALL: &str = "--workspace --exclude peers";

/// Runs all steps and sums them up, also after a failure.
pub(crate) fn test(install: Install) -> Outcome {
    let mut steps = Steps::default();
    let outcome = all(&mut steps, install);
    steps.sum_up();
    outcome
}

/// The steps: quick ones first, so that a slip shows within seconds.
fn all(steps: &mut Steps, install: Install) -> Outcome {
    steps.step("formatting", || {
        install::formatter_and_linter(install)?;
        run(&mut cargo("fmt --all --check"))
    })?;
    steps.step("lints", || run(&mut cargo(&format!("clippy {ALL} --all-targets -- -D warnings"))))?;
    steps.step("lints without default features", || {
        run(&mut cargo("clippy -p orogen --no-default-features --lib -- -D warnings"))?;
        run(&mut cargo("clippy -p orogen --no-default-features --features check --lib -- -D warnings"))?;
        run(&mut cargo("clippy -p peers --no-default-features --all-targets -- -D warnings"))
    })?;
    steps.step("few crates and no GPU stack without default features", dependencies)?;
    steps.step("what the tests need", || {
        install::driver(install)?;
        install::judges(install)
    })?;
    let mut driver: Vec<_> = install::driver_for_tests().into_iter().collect();
    driver.extend(install::browser().map(|browser| ("CHROMIUM", browser)));
    let driver = driver; // and the browser that the feature matrix is drawn with
    steps.step("tests", || {
        if capture(&mut cargo("nextest --version")).is_ok() {
            return run(
                cargo(&format!("nextest run {ALL} --profile all --no-fail-fast")).envs(driver.clone())
            );
        }
        println!("cargo-nextest is not here: running the same tests through `cargo test`");
        let all = format!("test {ALL} --lib --bins --tests --examples --no-fail-fast");
        run(cargo(&all).envs(driver.clone()))
    })?;
    steps.step("tests in the documentation", || {
        run(cargo(&format!("test --doc {ALL}")).envs(driver.clone()))
    })?;
    steps.step("examples", || {
        run(&mut cargo(&format!("build {ALL} --examples --bins")))?;
        run(built("debug", "examples/standalone", &[])?.envs(driver.clone()))?;
        run(built("debug", "examples/host_shader", &[])?.envs(driver.clone()))?;
        let shot = ["--size", "96x54", "--samples", "1", "--shot", "target/tmp/embed.png"];
        run(built("debug", "embed", &shot)?.envs(driver.clone()))
    })?;
    steps.step("a newcomer's crate", || {
        let mut newcomer =
            cargo("run --quiet --locked --manifest-path tests/newcomer/Cargo.toml --target-dir");
        run(newcomer.arg(target()?).envs(driver.clone()))
    })?;
    steps.step("judges", || judges::judge(&[]))?;
    steps.step("no slower beside the others", || bench(install, &What::Quick { accept: false }))?;
    steps.step("documentation", || {
        run(cargo(&format!("doc {ALL} --lib --no-deps")).env("RUSTDOCFLAGS", "-D warnings"))
    })
}

/// Checks that nothing of `ONLY_BY_FEATURE` is in the tree without default features, on any platform, nor with `check`
/// alone; that the former is small; and that it has no naga.
fn dependencies() -> Outcome {
    let tree = |features: &str, of: &str| {
        let line = format!(
            "tree -p orogen --no-default-features{features} -e normal{of} --prefix none --format {{p}}"
        );
        let mut tree = cargo(&line);
        println!("$ {}", shown(&tree));
        capture(&mut tree)
    };
    let everywhere = tree("", " --target all")?;
    let mut found = unwanted(&everywhere);
    found.extend(unwanted(&tree(" --features check", " --target all")?));
    if crates(&everywhere).iter().any(|name| name.starts_with("naga ")) {
        found.push("naga");
    }
    if !found.is_empty() {
        let what = format!("in the tree of `orogen` without default features: {}", found.join(", "));
        return Err(Failure::Check(what));
    }
    let here = tree("", "")?;
    let count = crates(&here).len();
    println!("{count} crates, and none of {}", ONLY_BY_FEATURE.join(", "));
    if count > MOST_CRATES {
        return Err(Failure::Check(format!(
            "{count} crates without default features, and at most {MOST_CRATES} were promised"
        )));
    }
    Ok(())
}

/// The packages in `tree`, one a line, each once: name and version.
fn crates(tree: &str) -> BTreeSet<String> {
    let name = |line: &str| line.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    tree.lines().filter(|line| !line.trim().is_empty()).map(name).collect()
}

/// Which of `ONLY_BY_FEATURE` stand in `tree`, one package a line with its name first.
fn unwanted(tree: &str) -> Vec<&'static str> {
    let named = |unwanted: &&str| tree.lines().any(|line| line.split_whitespace().next() == Some(unwanted));
    ONLY_BY_FEATURE.into_iter().filter(|name| named(name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_package_is_unwanted_by_its_whole_name() {
        let tree =
            "orogen v0.1.0 (/somewhere/image)\nimage-webp v0.2.0\nwgpu-types v30.0.0\nnaga v30.0.0 (*)\n";
        assert_eq!(unwanted(tree), <[&str; 0]>::default());
        assert_eq!(crates(&format!("{tree}\n{tree}")).len(), 4);
        assert_eq!(unwanted(&format!("{tree}wgpu v30.0.0\nclap v4.5.0 (*)\n")), ["wgpu", "clap"]);
    }
}
