//! The tokens of any text are the text again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use orogen::syntax::lex;

fuzz_target!(|data: &[u8]| {
    let text = String::from_utf8_lossy(data);
    let tokens = lex(&text);
    let again: String = tokens.iter().map(|(_, span)| &text[span.range()]).collect();
    assert_eq!(again, text);
});
