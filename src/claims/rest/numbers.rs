//! The two numbers of each case by hand, and the numbers by which claims can be found. The words are in the claims' entries.

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

pub(super) static VALUES: [Number; 8] = [
    Number::new("critical-radius", || Ok(turntable::critical_radius()?)),
    Number::new("critical-speed", || Ok(turntable::critical_speed()?)),
    Number::new("envelope", || Ok(printed::eq147_a(0.1))),
    Number::new("boundary-least", || Ok(corrected::boundary_least(0.1))),
    Number::new("boundary", boundary_example),
    Number::new("boundary-series", || Ok(corrected::boundary_a(0.1, 0.2))),
    Number::new("boundary-slope", || Ok(corrected::boundary_slope(PI / 2.0))),
    Number::new("boundary-curvature", || {
        Ok(corrected::boundary_curvature(0.0))
    }),
];

/// A on the boundary at α = 0.1, ψ = 0.2; computed once.
fn boundary_example() -> Result<f64, Failure> {
    static A: Runs<f64> = Runs::new(|| Ok(turntable::boundary(0.1, 0.2)?));
    A.get().copied()
}
