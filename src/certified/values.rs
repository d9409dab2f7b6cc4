//! The numbers that are stated somewhere, each with as many certain digits as one asks for.

use super::ball::{Ball, bits_for};
use super::drive::{self, Edge};
use super::error::CertifiedError;
use super::interval::Interval;

/// A number, and how to enclose it.
#[derive(Debug, Clone, Copy)]
pub struct Value {
    /// A name that is its own.
    pub name: &'static str,
    /// Its symbol, in LaTeX.
    pub symbol: &'static str,
    /// What it is, in a few words. All of them are dimensionless.
    pub meaning: &'static str,
    /// Encloses it with this many bits after the point.
    ball: fn(usize) -> Result<Ball, CertifiedError>,
}

impl Value {
    /// An enclosure to about `digits` decimals.
    ///
    /// # Errors
    /// None that is known for the [`values`]: each is proved to exist.
    pub fn ball(&self, digits: usize) -> Result<Ball, CertifiedError> {
        (self.ball)(bits_for(digits))
    }

    /// The number's decimals, correctly rounded to `digits` after the point.
    ///
    /// # Errors
    /// As [`ball`](Self::ball), and [`CertifiedError::NotProved`] if the number is so close to the middle between
    /// two decimals that this enclosure cannot tell which is nearer.
    pub fn decimal(&self, digits: usize) -> Result<String, CertifiedError> {
        let ball = self.ball(digits)?;
        let close = || CertifiedError::unproved("the rounding is not certain", &[ball.interval()]);
        ball.decimal(digits).ok_or_else(close)
    }

    /// Neighbouring f64 around it.
    ///
    /// # Errors
    /// As [`ball`](Self::ball).
    pub fn interval(&self) -> Result<Interval, CertifiedError> {
        Ok(self.ball(25)?.interval())
    }
}

/// All of them.
pub fn values() -> &'static [Value] {
    VALUES
}

/// The value of this name.
pub fn find(name: &str) -> Option<&'static Value> {
    VALUES.iter().find(|value| value.name == name)
}

macro_rules! value {
    ($name:literal, $symbol:literal, $meaning:literal, $ball:expr) => {
        Value {
            name: $name,
            symbol: $symbol,
            meaning: $meaning,
            ball: $ball,
        }
    };
}

const VALUES: &[Value] = &[
    value!(
        "lambda-c",
        r"\lambda_\mathrm{c}",
        "the friction above which the large-time motion under a sine rests; the λ₀ of X",
        drive::lambda_c
    ),
    value!(
        "phi-c",
        r"\sin^{-1}\lambda_\mathrm{c}",
        "the phase at which the slip begins at the critical friction",
        |bits| Ok(drive::critical_phase(bits)?.value)
    ),
    value!(
        "slip-end-fig-4",
        r"\tilde\phi_2(1/\sqrt2)",
        "where the forward slip ends at λ₀ = 1/√2, the friction of figure 4",
        |bits| {
            let lambda = root_of_ratio(1, 2, bits)?;
            let pi = Ball::pi(bits + 8);
            slip_end(&lambda, pi.over(&Ball::int(4, bits)), 3.197, bits)
        }
    ),
    value!(
        "slip-end-0.6",
        r"\tilde\phi_2(3/5)",
        "where the forward slip ends at λ₀ = 3/5",
        |bits| slip_end_at(3, 5, 3.523, bits)
    ),
    value!(
        "slip-end-0.9",
        r"\tilde\phi_2(9/10)",
        "where the forward slip ends at λ₀ = 9/10",
        |bits| slip_end_at(9, 10, 2.482, bits)
    ),
    value!(
        "x-Y",
        r"x_Y",
        "the length of the forward motion at Y, the root of tan x = x between π and 3π/2",
        |bits| Ok(drive::touching_length(bits)?.value)
    ),
    value!("q-Y", r"q_Y", "the q of Y", |bits| {
        let [q, _] = drive::y(bits)?;
        Ok(q)
    }),
    value!("lambda-Y", r"\lambda_Y", "the λ₀ of Y", |bits| {
        let [_, lambda] = drive::y(bits)?;
        Ok(lambda)
    }),
    value!(
        "contact-Y",
        r"\frac{q_Y-1}{2q_Y^3(q_Y+1)}",
        "how closely B and E touch C at Y: their distance over (q − q_Y)²",
        drive::contact
    ),
    value!(
        "A-2",
        r"\lambda_\mathrm{A}(2)",
        "curve A at q = 2",
        |bits| { drive::rest_appears(&Ball::int(2, bits + 16), bits) }
    ),
    value!(
        "A-6",
        r"\lambda_\mathrm{A}(6)",
        "curve A at q = 6",
        |bits| { drive::rest_appears(&Ball::int(6, bits + 16), bits) }
    ),
    value!(
        "A-12",
        r"\lambda_\mathrm{A}(12)",
        "curve A at q = 12",
        |bits| { drive::rest_appears(&Ball::int(12, bits + 16), bits) }
    ),
    value!(
        "B-2",
        r"\lambda_\mathrm{B}(2)",
        "curve B at q = 2",
        |bits| { drive::reversals_end(Edge::Beginning, &Ball::int(2, bits + 32), 0.951, bits) }
    ),
    value!(
        "B-3",
        r"\lambda_\mathrm{B}(3)",
        "curve B at q = 3",
        |bits| { drive::reversals_end(Edge::Beginning, &Ball::int(3, bits + 32), 1.236, bits) }
    ),
    value!(
        "E-6",
        r"\lambda_\mathrm{E}(6)",
        "curve E at q = 6",
        |bits| { drive::reversals_end(Edge::End, &Ball::int(6, bits + 32), 1.358, bits) }
    ),
    value!(
        "E-12",
        r"\lambda_\mathrm{E}(12)",
        "curve E at q = 12",
        |bits| { drive::reversals_end(Edge::End, &Ball::int(12, bits + 32), 0.846, bits) }
    ),
    value!(
        "escape-rho",
        r"\frac{1}{3\sqrt2}",
        "ρ/τ² and p/τ² of an escape at large times",
        |bits| root_of_ratio(1, 18, bits)
    ),
    value!(
        "escape-s",
        r"\frac{1}{9\sqrt2}",
        "s/τ³ of an escape at large times",
        |bits| root_of_ratio(1, 162, bits)
    ),
    value!(
        "escape-A",
        r"\frac{2^{1/4}}{3}",
        "A/τ^(3/2) of an escape at large times",
        |bits| {
            let square = root_of_ratio(2, 81, bits + 8)?;
            let root = square.sqrt().map(|root| root.with_bits(bits));
            root.ok_or_else(|| no_value(&square))
        }
    ),
    value!(
        "escape-turns",
        r"\sqrt2",
        "the angle of an escaping particle in the laboratory over ln τ",
        |bits| root_of_ratio(2, 1, bits)
    ),
    value!(
        "escape-delay",
        r"\frac{3\sqrt2}{4}",
        "how much an escape lags behind, over ln τ",
        |bits| root_of_ratio(9, 8, bits)
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
