//! Any condition is read and decided, or refused at a place inside of its line.
#![no_main]

use libfuzzer_sys::fuzz_target;
use orogen::syntax::parse_directive;
use orogen::{Bake, Library, Preset};

const OPTIONS: &str = "#option a.on = true\n#option a.n = 3\n#option a.mode = x { x, y }\n#option q = 2\n";

fuzz_target!(|condition: &str| {
    let line = condition.lines().next().unwrap_or("");
    let _ = parse_directive(&format!("#if {line}"), 0, "");
    let text = format!("{OPTIONS}#if {line}\nconst A = 1;\n#endif\nconst B = 2;\n");
    if let Err(error) =
        orogen::compose(&Library::empty(), &Preset::of_text("fuzz", &text), &Bake::constants())
    {
        for label in error.diagnostics().iter().flat_map(|diagnostic| &diagnostic.labels) {
            assert!(error.files().get(label.file).text.get(label.span.range()).is_some());
        }
    }
});
