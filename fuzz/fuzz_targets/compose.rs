//! Any two fragments, one of which may include the other, compose or are refused at places inside of them.
#![no_main]

use libfuzzer_sys::fuzz_target;
use orogen::{Bake, Library, Preset};

fuzz_target!(|input: (&str, &str, bool)| {
    let (root, other, live) = input;
    let library = Library::empty().with_file("root.wgsl", root).with_file("other.wgsl", other);
    let bake = if live { Bake::live(["*"]) } else { Bake::constants() };
    if let Err(error) = orogen::compose(&library, &Preset::of_module("root.wgsl"), &bake) {
        for label in error.diagnostics().iter().flat_map(|diagnostic| &diagnostic.labels) {
            assert!(error.files().get(label.file).text.get(label.span.range()).is_some());
        }
        error.render(false);
        error.json_lines();
    }
});
