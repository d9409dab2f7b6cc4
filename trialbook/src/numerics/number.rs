//! What a number must be able to do to be integrated with.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of the Taylor integrator. Not [`Copy`], so that numbers of any length qualify.
pub trait Number:
    Clone
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A quarter of the spacing of the numbers.
    const TOLERANCE_LOG2: f64 = -60.0;

    /// The number `x`, exactly.
    fn from_f64(x: f64) -> Self;
    /// Absolute value, roughly and not too small: only step sizes hang on it. Not finite for a number that
    /// is none.
    fn magnitude(&self) -> f64;
    /// Square root of a positive number.
    fn sqrt(&self) -> Self;
    /// Sine and cosine; the angle in radians.
    fn sin_cos(&self) -> (Self, Self);
    /// Exponential function.
    fn exp(&self) -> Self;
    /// Natural logarithm of a positive number.
    fn ln(&self) -> Self;
    /// A positive number to a real power.
    fn pow(&self, exponent: f64) -> Self;

    /// The number over the whole number `n`, from 1 on.
    #[inline(always)]
    fn over(&self, n: usize) -> Self {
        self.clone() / Self::from_f64(n as f64)
    }

    /// `sum + carry + delta` as a new sum and what rounding took from it. A type that has no use for the
    /// carry (an interval) leaves it zero.
    fn accumulate(sum: &Self, carry: &Self, delta: &Self) -> (Self, Self) {
        let new = sum.clone() + (carry.clone() + delta.clone());
        (new, Self::from_f64(0.0))
    }
}

/// A number of a fixed width, that can be compared and rounded to an `f64`.
pub trait Real: Number + Copy + PartialOrd {
    /// Relative spacing of the numbers.
    const ROUNDING: f64;

    /// The nearest `f64`.
    fn to_f64(self) -> f64;

    /// The larger of the two; not that which is no number.
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    /// The smaller of the two; not that which is no number.
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
}

impl Real for f64 {
    const ROUNDING: f64 = f64::EPSILON;

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
}

/// Elementary functions through libm: the same bits everywhere.
impl Number for f64 {
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn magnitude(&self) -> f64 {
        self.abs()
    }
    #[inline(always)]
    fn sqrt(&self) -> Self {
        libm::sqrt(*self)
    }
    #[inline(always)]
    fn sin_cos(&self) -> (Self, Self) {
        libm::sincos(*self)
    }
    #[inline(always)]
    fn exp(&self) -> Self {
        libm::exp(*self)
    }
    #[inline(always)]
    fn ln(&self) -> Self {
        libm::log(*self)
    }
    #[inline(always)]
    fn pow(&self, exponent: f64) -> Self {
        libm::pow(*self, exponent)
    }
    /// A division takes three times as long, and every next coefficient waits for it.
    #[inline(always)]
    fn over(&self, n: usize) -> Self {
        match INVERSES.get(n) {
            Some(inverse) => self * inverse,
            None => self / n as f64,
        }
    }
    #[inline(always)]
    fn accumulate(sum: &Self, carry: &Self, delta: &Self) -> (Self, Self) {
        // Knuth's two-sum: exact whatever the order of sizes.
        let delta = carry + delta;
        let new = sum + delta;
        let part = new - sum;
        (new, (sum - (new - part)) + (delta - part))
    }
}

/// More than a series of ours has terms.
const INVERSES: [f64; 64] = {
    let mut inverses = [0.0; 64];
    let mut n = 1;
    while n < inverses.len() {
        inverses[n] = 1.0 / n as f64;
        n += 1;
    }
    inverses
};
