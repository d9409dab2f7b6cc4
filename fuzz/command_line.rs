//! Any command line, one word per line of the input.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let line = std::iter::once("slipbook").chain(text.lines());
    if let Err(refusal) = slipbook::cli::command(&slipbook::edition::EDITION).try_get_matches_from(line) {
        assert!(!refusal.to_string().is_empty());
    }
});
