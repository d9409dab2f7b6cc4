//! The two numbers of each case by hand. The words are in the claims' entries.

use super::boundary::SURFACES;
use super::prelude::*;
use super::surfaces::bend;
use crate::motion::turntable;
use std::f64::consts::SQRT_2;

/// In the paper's order: what the printed formula says, and what the motion does.
pub(super) static CASES: [Numbers; 4] = [
    Numbers::new(
        "eq-146",
        || Ok(printed::eq146_right(0.5, 0.5 * SQRT_2)),
        || {
            let surface = SURFACES.each().last().ok_or("no surface")??;
            Ok(surface.slope)
        },
    ),
    Numbers::new("eq-147", || Ok(printed::eq147_a(0.1)), boundary_example),
    Numbers::new(
        "s4-psi-free",
        || Ok(0.5 - printed::eq145_a(0.5, 1.0)),
        || bend(0.5, FRAC_PI_2),
    ),
    Numbers::new(
        "s4-envelope-is-boundary",
        || Ok(printed::eq147_a(0.1)),
        boundary_example,
    ),
];

/// A on the boundary at α = 0.1, ψ = 0.2; computed once.
pub(super) fn boundary_example() -> Result<f64, Failure> {
    static A: Runs<f64> = Runs::new(|| Ok(turntable::boundary(0.1, 0.2)?));
    A.get().copied()
}
