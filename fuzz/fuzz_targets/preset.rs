//! Any text is a preset or is refused at a place inside of it.
#![no_main]

use libfuzzer_sys::fuzz_target;
use orogen::Preset;

fuzz_target!(|text: &str| {
    if let Err(error) = Preset::parse("fuzz", text) {
        for label in error.diagnostics().iter().flat_map(|diagnostic| &diagnostic.labels) {
            assert!(error.files().get(label.file).text.get(label.span.range()).is_some());
        }
        error.render(false);
        error.json_lines();
    }
});
