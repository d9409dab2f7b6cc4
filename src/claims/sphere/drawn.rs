//! What the figures of section 3 show: motions and points of the trials.

use super::angle;
use super::driven;
use crate::claims::compare::Failure;

/// The slip velocity and the velocity of the centre of a solid sphere on a swinging plane, over two late periods.
#[derive(Debug, Clone, PartialEq)]
pub struct Swinging {
    /// λ₀ of (84).
    pub lambda: f64,
    /// (φ, ϖ w_x/A₀, ϖ v_x/A₀), φ from 0 to 4π; all dimensionless.
    pub points: Vec<[f64; 3]>,
    /// The phases between which it rolls.
    pub rolls: Vec<[f64; 2]>,
}

/// One motion for each λ₀.
///
/// # Errors
/// Why there is none.
pub fn swinging(lambdas: &[f64]) -> Result<Vec<Swinging>, Failure> {
    lambdas
        .iter()
        .map(|lambda| driven::swinging(*lambda))
        .collect()
}

/// (γ, τ of the motion over τ of the printed (82)) for the sliding spheres on which (82) is tried.
///
/// # Errors
/// Why there is none.
pub fn times_over_printed() -> Result<Vec<[f64; 2]>, Failure> {
    angle::times_over_printed()
}
