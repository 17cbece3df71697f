//! Any text is read and split, whichever of its conditions hold, and every piece lies inside of it.
#![no_main]

use libfuzzer_sys::fuzz_target;
use orogen::syntax::{parse_fragment, split};

fuzz_target!(|data: (u64, &str)| {
    let (truth, text) = data;
    let fragment = parse_fragment(text.into());
    let truth: Vec<bool> = (0..fragment.conditions).map(|n| truth >> (n % 64) & 1 == 1).collect();
    let module = split(&fragment, &truth);
    for piece in &module.pieces {
        assert!(text.get(piece.range()).is_some());
    }
});
