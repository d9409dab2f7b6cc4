//! What the figures of section 3 show: motions and points of the trials.

use super::angle;
use super::driven::{self, Swinging};
use trialbook::claims::compare::Failure;

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
