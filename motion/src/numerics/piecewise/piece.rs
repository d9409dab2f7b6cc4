//! One monotone piece: its polynomial, its integrals, and where it takes a value.

use super::chebyshev::{Fit, POINTS};
use crate::numerics::{roots::falling_root, series};

/// A monotone polynomial on [0, length], in powers of the distance s from the left end.
#[derive(Debug, Clone)]
pub struct Piece {
    start: f64,
    length: f64,
    degree: usize,
    coefficients: [f64; POINTS],
    left: f64,
    right: f64,
    integral: f64,
    before: f64,
}

impl Piece {
    pub(super) fn new(fit: &Fit, before: f64) -> Self {
        let mut coefficients = [0.0; POINTS];
        coefficients[..fit.coefficients.len()].copy_from_slice(&fit.coefficients);
        let mut piece = Piece {
            start: fit.start,
            length: fit.end - fit.start,
            degree: fit.coefficients.len() - 1,
            coefficients,
            left: coefficients[0],
            right: 0.0,
            integral: 0.0,
            before,
        };
        piece.right = piece.value(piece.length);
        piece.integral = piece.length * piece.secant(0.0).mean(piece.length);
        piece
    }

    /// The argument at the left end, in [0, 2π).
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The length, positive.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The value at the left end (limit from the right).
    pub fn left(&self) -> f64 {
        self.left
    }

    /// The value at the right end (limit from the left).
    pub fn right(&self) -> f64 {
        self.right
    }

    /// The integral over the piece.
    pub fn integral(&self) -> f64 {
        self.integral
    }

    /// The integral from 0 to the left end.
    pub fn before(&self) -> f64 {
        self.before
    }

    /// Of the powers of the distance from the left end.
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    /// The value at the distance `s` from the left end.
    pub fn value(&self, s: f64) -> f64 {
        series::value(self.coefficients(), &s)
    }

    /// The value and the slope at `s`.
    pub fn value_slope(&self, s: f64) -> (f64, f64) {
        series::value_slope(self.coefficients(), s)
    }

    /// ∫ s f(s) ds from 0 to `s`, the first moment.
    pub fn moment(&self, s: f64) -> f64 {
        let terms = self.coefficients().iter().enumerate().rev();
        s * s * terms.fold(0.0, |sum, (k, c)| sum * s + c / (k + 2) as f64)
    }

    /// The mean of the function between `s0` and any other point, ready for use.
    pub fn secant(&self, s0: f64) -> Secant<'_> {
        // The antiderivative Σ cₖ s^(k+1)/(k+1), divided by s − s₀ after its value at s₀ is taken off.
        let mut quotient = [0.0; POINTS];
        let mut carry = 0.0;
        for k in (0..=self.degree).rev() {
            carry = carry * s0 + self.coefficients[k] * RECIPROCALS[k];
            quotient[k] = carry;
        }
        Secant {
            piece: self,
            quotient,
        }
    }

    /// Where the function takes the value `level`, between `s0` and `s1`, at the ends of which it must lie
    /// on different sides of `level`. An end at which that fails is the answer.
    pub fn crossing(&self, level: f64, s0: f64, s1: f64) -> f64 {
        let (at0, at1) = (self.value(s0) - level, self.value(s1) - level);
        let rising = at1 > at0;
        let side = if rising { 1.0 } else { -1.0 };
        if side * at0 >= 0.0 {
            return s0;
        }
        if side * at1 <= 0.0 {
            return s1;
        }
        let guess = s0 + (s1 - s0) * (at0 / (at0 - at1));
        falling_root(s0, s1, guess, |s| {
            let (value, slope) = self.value_slope(s);
            (side * (level - value), -side * slope)
        })
    }
}

const RECIPROCALS: [f64; POINTS] = {
    let mut table = [0.0; POINTS];
    let mut k = 0;
    while k < POINTS {
        table[k] = 1.0 / (k + 1) as f64;
        k += 1;
    }
    table
};

/// The mean between a fixed point s₀ and a variable one.
#[derive(Debug, Clone)]
pub struct Secant<'p> {
    piece: &'p Piece,
    quotient: [f64; POINTS],
}

impl Secant<'_> {
    /// The integral from s₀ is (s − s₀) times this, with no loss for s near s₀.
    pub fn mean(&self, s: f64) -> f64 {
        series::value(&self.quotient[..=self.piece.degree], &s)
    }

    /// The mean between s₀ and `s`, and the value at `s`.
    pub(crate) fn mean_value(&self, s: f64) -> (f64, f64) {
        let (mut mean, mut value) = (0.0, 0.0);
        for k in (0..=self.piece.degree).rev() {
            mean = mean * s + self.quotient[k];
            value = value * s + self.piece.coefficients[k];
        }
        (mean, value)
    }
}
