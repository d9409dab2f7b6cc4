//! The edges of what the formulas are stated for, and the claims that are stated for a part of a symbol's values only.

use crate::seeded::{Corner, Domain};
use std::f64::consts::PI;

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
pub const CORNERS: &[Corner] = &[
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

const fn domain(claim: &'static str, letter: &'static str, low: f64, high: f64) -> Domain {
    Domain {
        claim,
        letter,
        low,
        high,
    }
}

/// Where a claim is stated, or holds, for a part of the values: its conditions say so.
pub const DOMAINS: &[Domain] = &[
    domain("eq-10", "θ", 0.0, PI),
    domain("eq-12", "θ", 0.0, PI),
    domain("eq-12", "θ₀", 0.0, PI),
    // Where friction stops the particle.
    domain("eq-20", "λ", 1.0, f64::INFINITY),
    domain("s21-large-friction-stops", "λ", 1.0, f64::INFINITY),
    // By (25).
    domain("eq-27", "λ₀", 0.0, 1.0),
    domain("eq-28", "λ₀", 0.0, 1.0),
    domain("eq-29", "λ₀", 0.0, 1.0),
    domain("eq-30", "λ₀", 0.0, 1.0),
    domain("eq-31", "λ₀", 0.0, 1.0),
    // From λ_c of (37) on.
    domain("eq-33", "λ₀", 0.53, 1.0),
    // (40): below λ_c.
    domain("eq-38", "λ₀", 0.0, 0.54),
    domain("eq-39", "λ₀", 0.0, 0.54),
    domain("s22-vy-two-stages", "λ₀", 0.0, 0.54),
    domain("s22-friction-across", "λ₀", 0.0, 0.54),
    // λ_c = η < λ₀ < 1, and for the correction 0 < λ₀ < η.
    domain("eq-44", "λ₀", 0.0, 1.0),
    domain("eq-46", "λ₀", 0.0, 1.0),
    // Above λ₀ = 1 nothing moves, by (56).
    domain("eq-49", "λ₀", 0.0, 1.0),
    domain("eq-50", "λ₀", 0.0, 1.0),
    domain("eq-51", "λ₀", 0.0, 1.0),
    domain("eq-52", "λ₀", 0.0, 1.0),
    // Below A, which begins at λ_c.
    domain("s24-region-1", "λ₀", 0.0, 0.54),
    // Up to the point Y.
    domain("eq-55", "q", 1.0, 4.604),
    // What the mirror takes back to q ≥ 1.
    domain("s24-q-at-least-one", "q", 0.0, 1.0),
    // An escape at large α.
    domain("eq-128", "α", 1.0, f64::INFINITY),
    domain("eq-129", "α", 1.0, f64::INFINITY),
    // Just before the particle comes to rest, α → 0; τ is counted from the rest, and negative.
    domain("eq-141", "τ", f64::NEG_INFINITY, 0.0),
    domain("eq-142", "α", 0.0, 0.1),
    domain("eq-142", "ψ", -1.0, 1.0),
    domain("eq-143", "α", 0.0, 0.1),
    domain("eq-144", "α", 0.0, 0.1),
    domain("eq-145", "α", 0.0, 0.1),
    domain("eq-146", "α", 0.0, 0.1),
    domain("eq-147", "α", 0.0, 0.1),
    domain("s4-near-rest", "α", 0.0, 0.1),
    domain("s4-psi-free", "α", 0.0, 0.1),
    domain("s4-envelope-is-boundary", "α", 0.0, 0.5),
];
