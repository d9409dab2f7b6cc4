//! A number that knows how well its formula determines it.
//!
//! A printed formula evaluated on [`Conditioned`] numbers returns its value and the spread that a relative
//! change of one unit in every input and in every operation would cause, to first order. Where terms
//! cancel, as in (13) near λ = 1, the spread exceeds the value, and a comparison in units of the spread
//! asks for as many digits as the formula can give: no more, and no fewer.

use crate::scalar::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value and its spread for relative changes of size one (first order), both in the value's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditioned {
    /// The value.
    pub value: f64,
    /// How far the value moves, per unit of relative change in inputs and operations.
    pub spread: f64,
}

impl Conditioned {
    /// A number known to within rounding, such as one that a motion returns.
    pub fn measured(value: f64) -> Self {
        Conditioned {
            value,
            spread: value.abs(),
        }
    }

    /// The result of an operation: the inputs' spread carried over, and the operation's own rounding.
    fn of(value: f64, carried: f64) -> Self {
        Conditioned {
            value,
            spread: carried + value.abs(),
        }
    }

    fn map(self, f: fn(f64) -> f64, slope: f64) -> Self {
        Self::of(f(self.value), slope.abs() * self.spread)
    }
}

impl Add for Conditioned {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::of(self.value + other.value, self.spread + other.spread)
    }
}

impl Sub for Conditioned {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::of(self.value - other.value, self.spread + other.spread)
    }
}

impl Mul for Conditioned {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let carried = self.value.abs() * other.spread + other.value.abs() * self.spread;
        Self::of(self.value * other.value, carried)
    }
}

impl Div for Conditioned {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let carried = (self.spread + value.abs() * other.spread) / other.value.abs();
        Self::of(value, carried)
    }
}

impl Neg for Conditioned {
    type Output = Self;
    fn neg(self) -> Self {
        Conditioned {
            value: -self.value,
            ..self
        }
    }
}

impl Scalar for Conditioned {
    fn int(n: i64) -> Self {
        Conditioned {
            value: n as f64,
            spread: 0.0,
        }
    }
    fn pi() -> Self {
        Self::measured(f64::pi())
    }
    fn sin(self) -> Self {
        self.map(Scalar::sin, Scalar::cos(self.value))
    }
    fn cos(self) -> Self {
        self.map(Scalar::cos, Scalar::sin(self.value))
    }
    fn asin(self) -> Self {
        self.map(
            Scalar::asin,
            1.0 / Scalar::sqrt(1.0 - self.value * self.value),
        )
    }
    fn acos(self) -> Self {
        self.map(
            Scalar::acos,
            1.0 / Scalar::sqrt(1.0 - self.value * self.value),
        )
    }
    fn sinh(self) -> Self {
        self.map(Scalar::sinh, Scalar::cosh(self.value))
    }
    fn cosh(self) -> Self {
        self.map(Scalar::cosh, Scalar::sinh(self.value))
    }
    fn exp(self) -> Self {
        self.map(Scalar::exp, Scalar::exp(self.value))
    }
    fn ln(self) -> Self {
        self.map(Scalar::ln, 1.0 / self.value)
    }
    fn sqrt(self) -> Self {
        self.map(Scalar::sqrt, 0.5 / Scalar::sqrt(self.value))
    }
    fn tan(self) -> Self {
        let cos = Scalar::cos(self.value);
        self.map(Scalar::tan, 1.0 / (cos * cos))
    }
    fn tanh(self) -> Self {
        let cosh = Scalar::cosh(self.value);
        self.map(Scalar::tanh, 1.0 / (cosh * cosh))
    }
    fn pow(self, exponent: Self) -> Self {
        let value = Scalar::pow(self.value, exponent.value);
        let by_base = exponent.value * value / self.value * self.spread;
        let by_exponent = match self.value {
            0.0 => 0.0,
            base => value * Scalar::ln(base) * exponent.spread,
        };
        Self::of(value, by_base.abs() + by_exponent.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cancelling_difference_keeps_the_size_of_its_terms() {
        let x = Conditioned::measured(1.0 + 1e-9);
        let difference = x * x - Conditioned::int(1);
        assert!(difference.value < 3e-9 && difference.spread > 2.0);
    }

    #[test]
    fn spreads_are_those_of_difference_quotients() {
        type Function = fn(Conditioned) -> Conditioned;
        let functions: [Function; 9] = [
            |x| x.sin(),
            |x| x.cos(),
            |x| x.tan(),
            |x| x.asin(),
            |x| x.ln(),
            |x| x.sqrt(),
            |x| x.tanh(),
            |x| x.pow(Conditioned::int(3)),
            |x| Conditioned::int(2) / x,
        ];
        for (i, f) in functions.iter().enumerate() {
            let x = 0.7;
            let at = f(Conditioned::measured(x));
            let h = 1e-6;
            let quotient = (f(Conditioned::int(0) + Conditioned::measured(x * (1.0 + h))).value
                - at.value)
                / h;
            let expected = quotient.abs() + at.value.abs();
            assert!(
                (at.spread - expected).abs() < 1e-4 * expected,
                "function {i}: {} against {expected}",
                at.spread
            );
        }
    }
}
