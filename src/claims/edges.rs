//! The edges of what the formulas are stated for.

use crate::seeded::Corner;

/// How near is near.
const NEAR: f64 = 1e-3;

const fn corner(letter: &'static str, low: f64, high: f64) -> Corner {
    Corner { letter, low, high }
}

const fn above(letter: &'static str, low: f64) -> Corner {
    corner(letter, low, f64::INFINITY)
}

const fn negative(letter: &'static str) -> Corner {
    corner(letter, f64::NEG_INFINITY, 0.0)
}

/// The corners of each symbol, by its letter.
pub(crate) const CORNERS: &[Corner] = &[
    corner("λ", 0.0, NEAR),
    corner("λ", 1.0 - NEAR, 1.0),
    corner("λ", 1.0, 1.0 + NEAR),
    above("λ", 8.0),
    corner("λ₀", 0.0, NEAR),
    corner("λ₀", 1.0 - NEAR, 1.0),
    corner("λ₀", 1.0, 1.0 + NEAR),
    negative("θ"),
    above("θ", 1.6),
    negative("θ₀"),
    above("θ₀", 1.6),
    negative("ψ"),
    above("ψ", 1.6),
    above("t", 10.0),
    above("τ", 10.0),
    above("μ", 1.0),
    above("μ₊", 1.0),
    above("μ₋", 1.0),
    above("q", 8.0),
    above("α", 3.0),
    corner("α", 0.0, 1e-2),
    above("β", 3.0),
    corner("β", 0.0, 1e-2),
];
