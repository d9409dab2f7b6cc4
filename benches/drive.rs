//! Attractors of the sinusoidal drive per second, on one core and on all: `cargo bench --bench drive`.

use rayon::prelude::*;
use slipbook::motion::drive::{Drive, DriveState, Friction, Outcome};
use std::hint::black_box;
use std::time::Instant;

/// Grid points along each side of the parameter plane.
const SIDE: usize = 500;
const MAX_PERIODS: u32 = 100;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let drive = Drive::new(libm::sin, &[])?;
    let cases: Vec<Friction> = (0..SIDE * SIDE)
        .map(|k| {
            let q = 1.0 + 11.0 * ((k % SIDE) as f64 + 0.5) / SIDE as f64;
            let lambda = 1.4 * ((k / SIDE) as f64 + 0.5) / SIDE as f64;
            Friction::new(lambda, q * lambda)
        })
        .collect::<Result<_, _>>()?;
    let isotropic: Vec<Friction> = (0..100_000)
        .map(|k| Friction::new(1e-5 * k as f64, 1e-5 * k as f64))
        .collect::<Result<_, _>>()?;
    let start = DriveState { phi: 0.0, w: 0.0 };
    let intervals = |friction: &Friction| match drive.attractor(*friction, start, MAX_PERIODS) {
        Ok(Outcome::Settles(attractor)) => attractor.intervals().len(),
        Ok(Outcome::Drifts { .. }) | Err(_) => 0,
    };
    for (name, list) in [
        ("census, 1 < q < 12, 0 < λ < 1.4", &cases),
        ("q = 1, 0 ≤ λ < 1", &isotropic),
    ] {
        let begin = Instant::now();
        let sum: usize = list.iter().map(|f| black_box(intervals(f))).sum();
        report(name, "one core ", list.len(), begin);
        let begin = Instant::now();
        let again: usize = list.par_iter().map(|f| black_box(intervals(f))).sum();
        report(name, "all cores", list.len(), begin);
        if sum != again {
            return Err("the two runs differ".into());
        }
    }
    Ok(())
}

fn report(name: &str, cores: &str, count: usize, begin: Instant) {
    let seconds = begin.elapsed().as_secs_f64();
    let rate = count as f64 / seconds;
    println!(
        "{name}, {cores}: {rate:.0} attractors per second, {:.2} µs each",
        1e6 / rate
    );
}
