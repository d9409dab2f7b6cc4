//! Certified digits, and all certificates of the ledger: `cargo bench --bench certified`.

use slipbook::claims::PAPER;
use slipbook::validated::numbers::{LAMBDA_C, Q_Y, X_Y};
use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for (name, value) in [("x-Y", X_Y), ("q-Y", Q_Y), ("lambda-c", LAMBDA_C)] {
        for digits in [50, 1000] {
            // The digits are certain, or this is an error.
            value.decimal(digits)?;
            let milliseconds = each(1000, || drop(black_box(value.ball(digits))));
            println!("{name} to {digits} digits: {milliseconds:.4} ms");
        }
    }
    let mut sum = 0.0;
    let mut certificates = BTreeMap::new();
    for trial in PAPER.claims().flat_map(|(_, claim)| claim.trials) {
        if ["certified", "bounds"]
            .iter()
            .any(|file| trial.file().contains(file))
        {
            certificates.insert(format!("{} {}", trial.file(), trial.name()), trial);
        }
    }
    for (name, trial) in certificates {
        let milliseconds = each(50, || drop(black_box(trial.evidence())));
        let parts = trial.evidence().points;
        println!("{name}: {milliseconds:.3} ms, {parts} parts");
        sum += milliseconds;
    }
    println!("all certificates: {sum:.1} ms");
    Ok(())
}

/// Milliseconds that one call takes: the fastest of many, so that other work on the machine does not count.
fn each(calls: u32, work: impl Fn()) -> f64 {
    let call = || {
        let begin = Instant::now();
        work();
        1e3 * begin.elapsed().as_secs_f64()
    };
    (0..calls).map(|_| call()).fold(f64::INFINITY, f64::min)
}
