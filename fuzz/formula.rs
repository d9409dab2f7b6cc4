//! Any formula, or words with formulas, put into plain text.
#![no_main]

use libfuzzer_sys::fuzz_target;
use trialbook::notation::{plain_formula, plain_words};

fuzz_target!(|text: &str| {
    plain_formula(text);
    plain_words(text);
});
