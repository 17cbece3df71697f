//! `cargo xtask accuracy`: runs the tests that measure the library, and writes what they measured into
//! `docs/accuracy.md`.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::install::{self, Install};
use crate::run::{Failure, Outcome, cargo, read, root, run, target, write};

/// The rows of one test.
#[derive(Debug, PartialEq)]
struct Rows {
    /// The heading that they come under.
    section: String,
    /// What each measured, and its bound: `| what | measured | bound |`.
    rows: Vec<String>,
}

/// Runs the tests and writes the page. Where a bound is broken, the page stays as it was.
pub(crate) fn accuracy(install: Install) -> Outcome {
    install::driver(install)?;
    let folder = target()?.join("tmp/accuracy");
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|cause| Failure::File { path: folder.clone(), cause })?;
    }
    let mut tests = cargo("test --no-fail-fast --test accuracy --test census");
    run(tests.envs(install::driver_for_tests()))?;
    let adapter = read(&folder.join("adapter"))?;
    let mut measured = BTreeMap::new();
    for path in files(&folder)? {
        let test = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if path.extension().is_some_and(|extension| extension == "txt") {
            measured.insert(test, rows(&read(&path)?));
        }
    }
    if measured.is_empty() {
        return Err(Failure::Check(format!("the tests left no rows in {}", folder.display())));
    }
    let page = root().join("docs/accuracy.md");
    write(&page, &written(adapter.trim(), &measured))?;
    println!("\ndocs/accuracy.md: {} tests", measured.len());
    Ok(())
}

fn files(folder: &Path) -> Outcome<Vec<std::path::PathBuf>> {
    let wrong = |cause| Failure::File { path: folder.to_owned(), cause };
    let entries = fs::read_dir(folder).map_err(wrong)?;
    entries.map(|entry| entry.map(|entry| entry.path()).map_err(wrong)).collect()
}

/// A test's file: the section, then a row a line.
fn rows(text: &str) -> Rows {
    let mut lines = text.lines();
    let section = lines.next().unwrap_or_default().to_owned();
    Rows { section, rows: lines.filter(|line| !line.is_empty()).map(str::to_owned).collect() }
}

/// The page: a heading a section, a table a test, both in the order of their names.
fn written(adapter: &str, measured: &BTreeMap<String, Rows>) -> String {
    let mut page = format!(
        "# Accuracy

What the library's functions promise, and what was measured. `cargo xtask accuracy` runs the tests and writes this page; on
this one they ran on {adapter}. A GPU of another make rounds otherwise, in the last bits.

Each row is a promise that a test keeps: what was measured, how much it was, and the bound that fails the test when it is
broken; without a bound the number is only told. Truth is f64, written in Rust from the definitions (`truth/`), or a property
that needs none. The sentence over a table is the name of its test.
"
    );
    let mut sections: BTreeMap<&str, Vec<(&str, &Rows)>> = BTreeMap::new();
    for (test, rows) in measured {
        sections.entry(&rows.section).or_default().push((test, rows));
    }
    for (section, tests) in sections {
        page += &format!("\n## {section}\n");
        for (test, rows) in tests {
            page += &format!("\n{}\n\n| what | measured | bound |\n| --- | ---: | --- |\n", sentence(test));
            page += &rows.rows.iter().map(|row| format!("{row}\n")).collect::<String>();
        }
    }
    page
}

/// `perlin_noise_keeps_its_range` → «Perlin noise keeps its range:»
fn sentence(test: &str) -> String {
    let words = test.replace('_', " ");
    let mut letters = words.chars();
    letters
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + letters.as_str() + ":")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_has_sections_and_tests_in_the_order_of_their_names() {
        let of = |name: &str, text: &str| (name.to_owned(), rows(text));
        let measured = BTreeMap::from([
            of("worley_is_exact", "Noise\n| `worley_noise2` | 0 | ≤ 0 |\n"),
            of("a_hash_is_even", "Hashes\n| `pcg` | 1 | 1 ± 0.01 |\n| `pcg2d` | 1 | |\n"),
            of("perlin_is_smooth", "Noise\n| `perlin_noise2` | 1 | ≤ 2 |\n"),
        ]);
        let page = written("llvmpipe", &measured);
        let at = |text: &str| page.find(text).expect("it is in the page");
        let order = [
            "llvmpipe",
            "## Hashes",
            "A hash is even:",
            "| `pcg2d`",
            "## Noise",
            "Perlin is smooth:",
            "Worley is",
        ];
        assert!(order.map(at).is_sorted(), "{page}");
        assert_eq!(page.matches("## Noise").count(), 1);
        assert_eq!(page.matches("| --- | ---: |").count(), 3);
    }
}
