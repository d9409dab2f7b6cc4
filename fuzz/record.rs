//! Any record of verdicts.
#![no_main]

use libfuzzer_sys::fuzz_target;
use slipbook::ledger::Record;

fuzz_target!(|text: &str| {
    if let Err(error) = Record::parse(text) {
        assert!(error.to_string().contains("line"));
    }
});
