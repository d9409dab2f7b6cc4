//! Certified digits, and all certificates of the ledger: `cargo bench --bench certified`.

use slipbook::certified::numbers::{LAMBDA_C, Q_Y, X_Y};
use slipbook::claims::{anisotropic, rest, sinusoidal};
use slipbook::evidence::Evidence;
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
    for (name, trial) in CERTIFICATES {
        let milliseconds = each(50, || drop(black_box(trial())));
        println!("{name}: {milliseconds:.3} ms, {} parts", trial().points);
        sum += milliseconds;
    }
    println!("all certificates: {sum:.1} ms");
    Ok(())
}

type Trial = fn() -> Evidence;

/// The trials of the ledger, each once.
const CERTIFICATES: [(&str, Trial); 14] = [
    ("λ_c to 50 digits", sinusoidal::certified::lambda_c),
    ("bracket of φ̃₂", sinusoidal::certified::bracket),
    ("one change in (35)", sinusoidal::certified::threshold),
    ("one change in (41)", sinusoidal::certified::turns),
    ("root of (53)", anisotropic::certified::a_once),
    ("root of (54)", anisotropic::certified::b_once),
    ("root of E", anisotropic::certified::e_once),
    ("order of the curves", anisotropic::certified::order),
    ("X", anisotropic::certified::points::x_unique),
    ("Y, rounded", anisotropic::certified::points::y_rounding),
    ("Y to 50 digits", anisotropic::certified::points::y_digits),
    ("no way back", anisotropic::certified::points::no_way_back),
    ("fates, printed", rest::certified::printed),
    ("fates, corrected", rest::certified::corrected),
];

/// Milliseconds that one call takes: the fastest of many, so that other work on the machine does not count.
fn each(calls: u32, work: impl Fn()) -> f64 {
    let call = || {
        let begin = Instant::now();
        work();
        1e3 * begin.elapsed().as_secs_f64()
    };
    (0..calls).map(|_| call()).fold(f64::INFINITY, f64::min)
}
