//! Why there is no motion to show.

use crate::numerics::{NumericsError, error::plain};

/// Why a motion cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A parameter lies outside its range.
    #[error("{name} = {} must be {range}", plain(*value))]
    Argument {
        /// Name of the parameter.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        range: &'static str,
    },
    /// The motion takes more steps than are allowed.
    #[error("the motion needs more than {limit} steps; it came to t = {t}")]
    Steps {
        /// How many are allowed.
        limit: usize,
        /// Time reached.
        t: f64,
    },
    /// The motion leaves the times at which its acceleration is known.
    #[error(
        "the acceleration is known from t = {} to {}, not at {}",
        plain(*from),
        plain(*to),
        plain(*t)
    )]
    Outside {
        /// Start or end of the motion.
        t: f64,
        /// The first time at which the acceleration is known,
        from: f64,
        /// and the last.
        to: f64,
    },
    /// A numerical method failed on the way.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

pub(super) fn check(
    name: &'static str,
    value: f64,
    fit: bool,
    range: &'static str,
) -> Result<(), MotionError> {
    if fit {
        Ok(())
    } else {
        Err(MotionError::Argument { name, value, range })
    }
}

pub(super) fn finite(t: f64, state: &[f64]) -> Result<(), MotionError> {
    if t.is_finite() && state.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(NumericsError::NotFinite {
            what: "the motion",
            at: t,
        }
        .into())
    }
}
