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

/// Milliseconds that one call takes: the fastest of many, so that other work on the machine does not count.
fn each(work: impl Fn()) -> f64 {
    let call = || {
        let begin = Instant::now();
        work();
        1e3 * begin.elapsed().as_secs_f64()
    };
    (0..1000).map(|_| call()).fold(f64::INFINITY, f64::min)
}
