//! WGSL that lies around, and small edits of it.
//!
//! The files of the dependency tree are read where cargo keeps them; none of them is copied here. With `CORPUS=FOLDER` in the
//! environment, those of that folder are read as well.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use orogen::syntax::lex;

/// The `.wgsl` files in `root` and the folders in it.
fn wgsl_in(root: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(root).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            wgsl_in(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "wgsl") {
            found.push(path);
        }
    }
}

/// The `.wgsl` files in `root` and the folders in it: their paths and their texts, sorted.
pub(crate) fn texts(root: &Path) -> Vec<(String, String)> {
    let mut paths = Vec::new();
    wgsl_in(root, &mut paths);
    paths.sort();
    // What is no UTF-8 is no WGSL.
    let read = |path: PathBuf| Some((path.display().to_string(), fs::read_to_string(&path).ok()?));
    paths.into_iter().filter_map(read).collect()
}

/// The folders of all packages that are not our own.
fn packages() -> Vec<PathBuf> {
    let metadata =
        Command::new(env!("CARGO")).args(["metadata", "--format-version", "1", "--locked"]).output();
    let metadata: serde_json::Value = serde_json::from_slice(&metadata.unwrap().stdout).unwrap();
    let packages =
        metadata["packages"].as_array().unwrap().iter().filter(|package| !package["source"].is_null());
    let manifest = |package: &serde_json::Value| PathBuf::from(package["manifest_path"].as_str().unwrap());
    packages.map(|package| manifest(package).parent().unwrap().to_owned()).collect()
}

/// The files of the dependency tree.
pub(crate) fn tree() -> Vec<(String, String)> {
    let mut all: Vec<_> = packages().iter().flat_map(|folder| texts(folder)).collect();
    all.extend(std::env::var_os("CORPUS").into_iter().flat_map(|folder| texts(Path::new(&folder))));
    let named = |package: &str| all.iter().any(|(name, _)| name.contains(package));
    assert!(named("naga-30") && named("wgpu-core-30"), "cargo's folder of packages was not found");
    all
}

/// The strings in the tests of naga's WGSL front end: some are WGSL.
pub(crate) fn strings_in_naga() -> Vec<String> {
    let packages = packages();
    let naga = packages.iter().find(|folder| folder.join("src/front/wgsl/tests.rs").exists());
    let rust = fs::read_to_string(naga.unwrap().join("src/front/wgsl/tests.rs")).unwrap();
    let mut strings = Vec::new();
    let mut rest = rust.as_str();
    while let Some(at) = rest.find('"') {
        let (before, after) = rest.split_at(at);
        let hashes = before.len() - before.trim_end_matches('#').len();
        let is_raw = before.trim_end_matches('#').ends_with('r');
        let after = &after[1..];
        let end = if is_raw {
            after.find(&format!("\"{}", "#".repeat(hashes)))
        } else {
            let mut escaped = false;
            after.find(|c| {
                let ends = c == '"' && !escaped;
                escaped = c == '\\' && !escaped;
                ends
            })
        };
        let Some(end) = end else { break };
        let text = &after[..end];
        strings.push(if is_raw { text.to_owned() } else { text.replace("\\n", "\n").replace("\\\n", "") });
        rest = &after[end + 1..];
    }
    strings
}

/// Whole modules of our own tests.
pub(crate) fn of_our_tests() -> Vec<(String, String)> {
    let mut all = texts(Path::new("tests/export/passthrough"));
    all.extend(
        texts(Path::new("tests/compose")).into_iter().filter(|(name, _)| name.ends_with("expected.wgsl")),
    );
    all
}

/// A generator of numbers (SplitMix64): the same edits on every run.
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    /// A number below `end`.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % end as u64) as usize
    }
}

/// `text` with one token removed, doubled, exchanged with another, or replaced by another.
pub(crate) fn edited(text: &str, numbers: &mut Numbers) -> String {
    let tokens = lex(text);
    let mut words: Vec<&str> = tokens.iter().map(|(_, span)| &text[span.range()]).collect();
    let solid: Vec<usize> = (0..tokens.len()).filter(|at| !tokens.kind(*at).is_trivia()).collect();
    if solid.is_empty() {
        return text.to_owned();
    }
    let (a, b) = (solid[numbers.below(solid.len())], solid[numbers.below(solid.len())]);
    match numbers.below(4) {
        0 => drop(words.remove(a)),
        1 => words.insert(a, words[a]),
        2 => words.swap(a, b),
        _ => words[a] = words[b],
    }
    words.concat()
}
