//! The numbers that are stated somewhere, each with as many certain digits as one asks for.

use super::ball::Ball;
use super::drive::{self, Edge};
use super::error::CertifiedError;
pub use super::value::Value;

/// All of them.
pub fn values() -> &'static [Value] {
    VALUES
}

/// The value of this name.
pub fn find(name: &str) -> Option<&'static Value> {
    VALUES.iter().find(|value| value.name == name)
}

/// The critical friction.
pub const LAMBDA_C: Value = Value::new(
    "lambda-c",
    r"\lambda_\mathrm{c}",
    "the friction above which the large-time motion under a sine rests; the λ₀ of X",
    drive::lambda_c,
);

/// The q of Y.
pub const Q_Y: Value = Value::new("q-Y", r"q_Y", "the q of Y", |bits| {
    let [q, _] = drive::y(bits)?;
    Ok(q)
});

const VALUES: &[Value] = &[
    LAMBDA_C,
    Value::new(
        "phi-c",
        r"\sin^{-1}\lambda_\mathrm{c}",
        "the phase at which the slip begins at the critical friction",
        |bits| Ok(drive::critical_phase(bits)?.value),
    ),
    Value::new(
        "slip-end-fig-4",
        r"\tilde\phi_2(1/\sqrt2)",
        "where the forward slip ends at λ₀ = 1/√2, the friction of figure 4",
        |bits| {
            let lambda = root_of_ratio(1, 2, bits)?;
            let pi = Ball::pi(bits + 8);
            slip_end(&lambda, pi.over(&Ball::int(4, bits)), 3.197, bits)
        },
    ),
    Value::new(
        "slip-end-0.6",
        r"\tilde\phi_2(3/5)",
        "where the forward slip ends at λ₀ = 3/5",
        |bits| slip_end_at(3, 5, 3.523, bits),
    ),
    Value::new(
        "slip-end-0.9",
        r"\tilde\phi_2(9/10)",
        "where the forward slip ends at λ₀ = 9/10",
        |bits| slip_end_at(9, 10, 2.482, bits),
    ),
    Value::new(
        "x-Y",
        r"x_Y",
        "the length of the forward motion at Y, the root of tan x = x between π and 3π/2",
        |bits| Ok(drive::touching_length(bits)?.value),
    ),
    Q_Y,
    Value::new("lambda-Y", r"\lambda_Y", "the λ₀ of Y", |bits| {
        let [_, lambda] = drive::y(bits)?;
        Ok(lambda)
    }),
    Value::new(
        "contact-Y",
        r"\frac{q_Y-1}{2q_Y^3(q_Y+1)}",
        "how closely B and E touch C at Y: their distance over (q − q_Y)²",
        drive::contact,
    ),
    Value::new(
        "A-2",
        r"\lambda_\mathrm{A}(2)",
        "curve A at q = 2",
        |bits| drive::rest_appears(&Ball::int(2, bits + 16), bits),
    ),
    Value::new(
        "A-6",
        r"\lambda_\mathrm{A}(6)",
        "curve A at q = 6",
        |bits| drive::rest_appears(&Ball::int(6, bits + 16), bits),
    ),
    Value::new(
        "A-12",
        r"\lambda_\mathrm{A}(12)",
        "curve A at q = 12",
        |bits| drive::rest_appears(&Ball::int(12, bits + 16), bits),
    ),
    Value::new(
        "B-2",
        r"\lambda_\mathrm{B}(2)",
        "curve B at q = 2",
        |bits| drive::reversals_end(Edge::Beginning, &Ball::int(2, bits + 32), 0.951, bits),
    ),
    Value::new(
        "B-3",
        r"\lambda_\mathrm{B}(3)",
        "curve B at q = 3",
        |bits| drive::reversals_end(Edge::Beginning, &Ball::int(3, bits + 32), 1.236, bits),
    ),
    Value::new(
        "E-6",
        r"\lambda_\mathrm{E}(6)",
        "curve E at q = 6",
        |bits| drive::reversals_end(Edge::End, &Ball::int(6, bits + 32), 1.358, bits),
    ),
    Value::new(
        "E-12",
        r"\lambda_\mathrm{E}(12)",
        "curve E at q = 12",
        |bits| drive::reversals_end(Edge::End, &Ball::int(12, bits + 32), 0.846, bits),
    ),
    Value::new(
        "escape-rho",
        r"\frac{1}{3\sqrt2}",
        "ρ/τ² and p/τ² of an escape at large times",
        |bits| root_of_ratio(1, 18, bits),
    ),
    Value::new(
        "escape-s",
        r"\frac{1}{9\sqrt2}",
        "s/τ³ of an escape at large times",
        |bits| root_of_ratio(1, 162, bits),
    ),
    Value::new(
        "escape-A",
        r"\frac{2^{1/4}}{3}",
        "A/τ^(3/2) of an escape at large times",
        |bits| {
            let square = root_of_ratio(2, 81, bits + 8)?;
            let root = square.sqrt().map(|root| root.with_bits(bits));
            root.ok_or_else(|| no_value(&square))
        },
    ),
    Value::new(
        "escape-turns",
        r"\sqrt2",
        "the angle of an escaping particle in the laboratory over ln τ",
        |bits| root_of_ratio(2, 1, bits),
    ),
    Value::new(
        "escape-delay",
        r"\frac{3\sqrt2}{4}",
        "how much an escape lags behind, over ln τ",
        |bits| root_of_ratio(9, 8, bits),
    ),
];

fn no_value(of: &Ball) -> CertifiedError {
    CertifiedError::unproved("an operation has no value", &[of.interval()])
}

/// √(n/m).
fn root_of_ratio(n: i64, m: i64, bits: usize) -> Result<Ball, CertifiedError> {
    let root = Ball::ratio(n, m, bits + 8).and_then(|ratio| ratio.sqrt());
    root.ok_or_else(|| no_value(&Ball::int(m, 1)))
}

/// φ̃₂ at λ₀ = n/m.
fn slip_end_at(n: i64, m: i64, near: f64, bits: usize) -> Result<Ball, CertifiedError> {
    let lambda = Ball::ratio(n, m, bits + 16).ok_or_else(|| no_value(&Ball::int(m, 1)))?;
    let phi1 = lambda.asin();
    slip_end(&lambda, phi1, near, bits)
}

fn slip_end(
    lambda: &Ball,
    phi1: Option<Ball>,
    near: f64,
    bits: usize,
) -> Result<Ball, CertifiedError> {
    let phi1 = phi1.ok_or_else(|| no_value(lambda))?;
    Ok(drive::slip_end(lambda, &phi1, near, bits)?.value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_value_has_its_digits() {
        for value in values() {
            let fifty = value.decimal(50).unwrap();
            let hundred = value.decimal(100).unwrap();
            println!("{} {fifty}", value.name);
            assert_eq!(fifty[..46], hundred[..46], "{}", value.name);
            assert!(value.interval().unwrap().width() < 3e-15, "{}", value.name);
        }
        let names: BTreeSet<_> = values().iter().map(|value| value.name).collect();
        assert_eq!(names.len(), values().len());
    }

    #[test]
    fn a_thousand_digits_on_request() {
        for name in ["x-Y", "lambda-c", "slip-end-0.6", "E-12"] {
            let value = find(name).unwrap();
            let (decimal, longer) = (value.decimal(1000).unwrap(), value.decimal(1100).unwrap());
            assert_eq!(decimal[..990], longer[..990], "{name}");
        }
    }
}
