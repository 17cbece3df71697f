//! The README's snippets that are no Rust: each command runs, each preset and fragment is valid, and what is shown of an
//! error is what is said. (Those in Rust are tests in the documentation: see `src/lib.rs`.)

#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const README: &str = include_str!("../README.md");
const BEVY: &str = include_str!("../docs/bevy.md");

/// The README's snippets in `language`.
fn snippets(language: &str) -> Vec<String> {
    snippets_of(README, language)
}

/// The snippets of `page` in `language`.
fn snippets_of(page: &str, language: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        let Some(fence) = line.strip_prefix("```") else { continue };
        let text: Vec<_> = lines.by_ref().take_while(|line| *line != "```").collect();
        if fence == language {
            found.push(text.join("\n") + "\n");
        }
    }
    found
}

/// `line` as a shell would split it, comments left out.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut quoted) = (Vec::new(), String::new(), false);
    for c in line.chars() {
        match c {
            '\'' => quoted = !quoted,
            '#' if !quoted && word.is_empty() => break,
            ' ' if !quoted => words.extend(Some(std::mem::take(&mut word)).filter(|word| !word.is_empty())),
            c => word.push(c),
        }
    }
    words.extend(Some(word).filter(|word| !word.is_empty()));
    words
}

fn orogen(folder: &Path, arguments: &[String]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_orogen")).args(arguments).current_dir(folder).output().unwrap()
}

/// A folder with the files that the README speaks of.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    put("points.csv", "x,y\n0,0\n250,-900\n");
    put("dawn.json", &snippets("json")[0]);
    put("world.json", r#"{ "orogen": 1, "extends": "alpine" }"#);
    folder
}

#[test]
fn every_command_does_what_it_says() {
    let folder = folder();
    let mut ran = 0;
    let commands = [snippets("sh"), snippets_of(BEVY, "sh")].concat();
    for line in commands.iter().flat_map(|snippet| snippet.lines()) {
        let mut words = words(line);
        match words.first().map(String::as_str) {
            Some("orogen") => {}
            // What these do is what CI runs.
            Some("cargo") if ["demo", "test", "-p", "--example"].contains(&words[2].as_str()) => continue,
            other => panic!("{line}: what is {other:?}?"),
        }
        words.remove(0);
        // What would go on for ever is done once, and what takes minutes in small.
        words.retain(|word| word != "--watch");
        if words[0] == "render" {
            let size = if line.contains("cube") { "16x16" } else { "32x18" };
            words.extend(["--size", size, "--set", "quality=low"].map(String::from));
        }
        if let Some(pixels) = words.iter().position(|word| word == "--pixels") {
            words[pixels + 1] = "17".into();
        }
        let output = orogen(folder.path(), &words);
        assert!(output.status.success(), "{line}\n{}", String::from_utf8_lossy(&output.stderr));
        if let Some(to) = words.iter().position(|word| word == "-o") {
            let path = folder.path().join(&words[to + 1]);
            let faces = folder.path().join(words[to + 1].replace(".png", "_px.png"));
            assert!(
                path.exists() || line.contains("--faces") && faces.exists(),
                "{line} has written nothing"
            );
        }
        ran += 1;
    }
    assert!(ran >= 15, "{ran} commands");
}

#[test]
fn the_preset_is_valid_and_the_error_is_told_as_shown() {
    let folder = folder();
    let check = |file: &str| orogen(folder.path(), &["check".into(), file.into()]);
    let valid = check("dawn.json");
    assert!(valid.status.success(), "{}", String::from_utf8_lossy(&valid.stderr));

    let shown = snippets("text").into_iter().find(|text| text.contains("OR0507")).unwrap();
    // The line that is shown, at the number that is shown.
    let line = shown.lines().find_map(|line| line.split_once(" │     \"sun\"")).unwrap();
    let number: usize = line.0.trim().parse().unwrap();
    let preset = snippets("json")[0]
        .replace("\"elevation\"", "\"elevaton\"")
        .replace(", \"color\": \"#ffb070\" },", " }\n   ,");
    assert!(preset.lines().nth(number - 1).unwrap().contains("elevaton"), "{preset}");
    fs::write(folder.path().join("dawn.json"), preset).unwrap();
    let wrong = check("dawn.json");
    let said = String::from_utf8_lossy(&wrong.stderr);
    assert!(said.starts_with(shown.trim_end()), "{said}"); // a line that counts what was checked comes behind
}

#[test]
fn every_fragment_is_valid_or_stands_in_an_example_as_it_is_shown() {
    let mut examples = String::new();
    for folder in ["examples/host", "examples/embed/wgsl"] {
        for entry in fs::read_dir(folder).unwrap() {
            examples += &fs::read_to_string(entry.unwrap().path()).unwrap_or_default();
        }
    }
    for snippet in snippets("wgsl") {
        let code = |line: &str| line.split("//").next().unwrap().trim().to_owned();
        let missing: Vec<_> = snippet.lines().map(code).filter(|line| !examples.contains(line)).collect();
        if missing.is_empty() {
            continue;
        }
        let folder = folder();
        fs::write(folder.path().join("snippet.wgsl"), &snippet).unwrap();
        let check = orogen(folder.path(), &["check".into(), "snippet.wgsl".into()]);
        let said = String::from_utf8_lossy(&check.stderr);
        assert!(check.status.success(), "{snippet}\nnot in an example: {missing:#?}\n{said}");
    }
}
