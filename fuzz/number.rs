//! Any number to be found: only what is one is graded.
#![no_main]

use libfuzzer_sys::fuzz_target;
use slipbook::claims::{PAPER, values::search};

fuzz_target!(|number: &str| {
    if let Ok(found) = search(PAPER.values(), number) {
        assert!(number.parse().is_ok_and(f64::is_finite));
        assert!(found.iter().all(|m| m.column.is_none_or(|column| column < number.len())));
    }
});
