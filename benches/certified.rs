//! Certified digits, and certificates: `cargo bench --bench certified`.

use slipbook::certified::values;
use std::hint::black_box;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for name in ["x-Y", "q-Y", "lambda-c"] {
        let value = values::find(name).ok_or("no such value")?;
        for digits in [50, 1000] {
            // The digits are certain, or this is an error.
            value.decimal(digits)?;
            let milliseconds = each(|| drop(black_box(value.ball(digits))));
            println!("{name} to {digits} digits: {milliseconds:.4} ms");
        }
    }
    Ok(())
}

/// Milliseconds that one call takes: the best of several rounds.
fn each(work: impl Fn()) -> f64 {
    let round = || {
        let (begin, mut calls) = (Instant::now(), 0);
        while begin.elapsed().as_secs_f64() < 0.1 {
            work();
            calls += 1;
        }
        1e3 * begin.elapsed().as_secs_f64() / f64::from(calls)
    };
    (0..5).map(|_| round()).fold(f64::INFINITY, f64::min)
}
