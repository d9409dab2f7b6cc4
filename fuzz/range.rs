//! Any range of an ensemble.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|range: &str| {
    let line = ["slipbook", "ensemble", "--rho", range, "--p", "1", "--psi", range];
    let _ = slipbook::cli::command(&slipbook::edition::EDITION).try_get_matches_from(line);
});
