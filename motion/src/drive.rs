//! A one-dimensional periodic drive with dry friction (sections 2.2 to 2.4), from its equation of motion.
//!
//! With the phase φ and the velocity w (both dimensionless, period 2π),
//!
//! - w' = h(φ) − λ₊ while w > 0,
//! - w' = h(φ) + λ₋ while w < 0,
//! - w stays 0 while −λ₋ ≤ h(φ) ≤ λ₊.
//!
//! h pulls the body along +w in the plane's frame: where the plane [accelerates](super) by A, h is −A in units of its size.
//!
//! h is any function of period 2π, represented once by [`Piecewise`], off which all is read. One [`Drive`] serves any number of
//! friction pairs.
//!
//! # Decisions
//! - **Thresholds.** Rest ends only where h leaves [−λ₋, λ₊] by more than [`Drive::resolution`], about
//!   1e-15 of the largest |h|: at λ₊ = max h itself the particle stays at rest.
//! - **Touching.** A minimum of |w| within the resolution of 0 is no rest and no change of sign; [`Attractor::grazes`] tells.
//! - **Intervals of length zero** (at most [`ZERO_LENGTH`]) are not listed; `grazes` tells.
//! - **Neutral motions.** If the mean of h is exactly λ₊ (or −λ₋), all motions of one sign are periodic; the
//!   one that the start leads to is returned, with contraction rate 1. So it is without friction.

mod arcs;
mod attractor;
mod intervals;
mod margins;
mod planar;
mod sign;

pub use attractor::{Agreement, Attractor, Outcome, Periods};
pub use intervals::{Interval, ZERO_LENGTH};
pub use margins::Margins;
pub use planar::PlanarState;
pub use sign::Sign;

use crate::numerics::{
    NumericsError,
    error::plain,
    piecewise::{Piecewise, PiecewiseError},
};
use arcs::{Mark, Walker};
use std::f64::consts::TAU;

/// Why a motion could not be followed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DriveError {
    /// The drive is no bounded, piecewise smooth function.
    #[error("the drive h: {0}")]
    Shape(#[from] PiecewiseError),
    /// A parameter is outside its range.
    #[error("{name} must be {allowed}, but it is {}", plain(*value))]
    Parameter {
        /// The parameter's name.
        name: &'static str,
        /// Its allowed range.
        allowed: &'static str,
        /// What was given.
        value: f64,
    },
    /// The integration of the planar motion failed.
    #[error("the planar motion: {0}")]
    Numerics(#[from] NumericsError),
    /// The motion is not yet periodic within the allowed number of periods.
    #[error("not periodic after {periods} periods: the last one changed w by {change:e}")]
    NotSettled {
        /// Periods followed.
        periods: u32,
        /// By how much w changed over the last of them.
        change: f64,
    },
}

/// Friction over drive amplitude, for positive and negative velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    plus: f64,
    minus: f64,
}

impl Friction {
    /// λ₊ and λ₋, dimensionless.
    ///
    /// # Errors
    /// A value that is negative, infinite or no number.
    pub fn new(plus: f64, minus: f64) -> Result<Self, DriveError> {
        for (name, value) in [("lambda_plus", plus), ("lambda_minus", minus)] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(DriveError::Parameter {
                    name,
                    allowed: "in [0, ∞)",
                    value,
                });
            }
        }
        Ok(Friction { plus, minus })
    }

    /// λ₊: the deceleration while w > 0.
    pub fn plus(&self) -> f64 {
        self.plus
    }

    /// λ₋: the deceleration while w < 0.
    pub fn minus(&self) -> f64 {
        self.minus
    }
}

/// A phase and a velocity, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveState {
    /// The phase φ, radians; any finite value.
    pub phi: f64,
    /// The velocity w.
    pub w: f64,
}

impl DriveState {
    fn check(self) -> Result<Self, DriveError> {
        for (name, value, bound) in [("phi", self.phi, LARGEST_PHASE), ("w", self.w, LARGEST_W)] {
            if value.is_nan() || value.abs() > bound {
                let allowed = "finite, with |phi| ≤ 1e6 and |w| ≤ 1e9";
                return Err(DriveError::Parameter {
                    name,
                    allowed,
                    value,
                });
            }
        }
        Ok(self)
    }
}

/// Phases beyond this have lost too many digits modulo 2π.
const LARGEST_PHASE: f64 = 1e6;
/// Velocities beyond this cannot be told from their next period's.
const LARGEST_W: f64 = 1e9;
/// What counts as equal to a level of h, in units of the largest |h|.
const RESOLUTION: f64 = 2e-15;

/// A drive h of period 2π, ready for any friction.
#[derive(Debug, Clone)]
pub struct Drive {
    shape: Piecewise,
}

/// A stretch of motion, as [`Drive::advance`] returns it.
#[derive(Debug, Clone, PartialEq)]
pub struct DrivePath {
    /// The state at the end.
    pub end: DriveState,
    /// What happened, in order; phases are not reduced modulo 2π.
    pub intervals: Vec<Interval>,
    /// By what factor a small change of the initial w has shrunk: 0 after a rest.
    pub contraction: f64,
}

impl Drive {
    /// The drive h(φ), asked only for φ in [0, 2π); `breaks` lists its jumps and kinks. What lasts less than a thousandth of a
    /// period needs breaks around it.
    ///
    /// Cost: that of [`Piecewise::fit`].
    ///
    /// # Errors
    /// A value of h that is not finite, a jump that is not listed: see [`PiecewiseError`].
    pub fn new(h: impl Fn(f64) -> f64, breaks: &[f64]) -> Result<Self, DriveError> {
        let shape = Piecewise::fit(h, breaks)?;
        Ok(Drive { shape })
    }

    /// h at any finite phase; at a jump, the limit from the right.
    pub fn h(&self, phi: f64) -> f64 {
        self.shape.value(phi)
    }

    /// The mean of h over a period.
    pub fn mean(&self) -> f64 {
        self.shape.integral() / TAU
    }

    /// The difference in h below which two levels count as equal.
    pub fn resolution(&self) -> f64 {
        RESOLUTION * self.shape.size()
    }

    /// The representation of h.
    pub fn shape(&self) -> &Piecewise {
        &self.shape
    }

    /// Follows the motion from `start` to the phase `until`.
    ///
    /// Cost: every piece of the drive once in each period, of which there are at most 16,000.
    ///
    /// # Errors
    /// A start that is not finite or too large; an end before the start or more than 1e5 radians after it.
    pub fn advance(
        &self,
        friction: Friction,
        start: DriveState,
        until: f64,
    ) -> Result<DrivePath, DriveError> {
        let start = start.check()?;
        if !(until >= start.phi && until - start.phi <= 1e5) {
            return Err(DriveError::Parameter {
                name: "until",
                allowed: "in [phi, phi + 1e5]",
                value: until,
            });
        }
        let base = start.phi.rem_euclid(TAU);
        let target = until.rem_euclid(TAU);
        let mut wraps = ((until - start.phi - (target - base)) / TAU).round() as u32;
        let mut marks = Vec::new();
        let mut walker = Walker::new(self, friction, base, start.w);
        let goal = self.shape.locate(target);
        if wraps == 0 && goal < walker.position() {
            // Rounding near a multiple of 2π: an end that is not after the start.
            return Ok(DrivePath {
                end: DriveState {
                    phi: until,
                    ..start
                },
                intervals: Vec::new(),
                contraction: 1.0,
            });
        }
        while wraps > 0 {
            walker.finish_turn(&mut marks);
            wraps -= 1;
        }
        walker.run_to(goal, &mut marks);
        let shift = start.phi - base;
        for mark in &mut marks {
            mark.phi += shift;
        }
        Ok(DrivePath {
            end: DriveState {
                phi: until,
                w: walker.w(),
            },
            intervals: intervals::between(&marks, until),
            contraction: walker.contraction(),
        })
    }

    /// w at the start's phase after 0, 1, 2, … periods, by plain following: each costs a visit to every piece of the drive.
    ///
    /// # Errors
    /// A start that is not finite or too large.
    pub fn strobe(
        &self,
        friction: Friction,
        start: DriveState,
        periods: u32,
    ) -> Result<Vec<f64>, DriveError> {
        let start = start.check()?;
        let base = start.phi.rem_euclid(TAU);
        let mut walker = Walker::new(self, friction, base, start.w);
        let section = walker.position();
        let mut marks: Vec<Mark> = Vec::new();
        let mut values = vec![start.w];
        for _ in 0..periods {
            walker.period(section, &mut marks);
            values.push(walker.w());
        }
        Ok(values)
    }
}

#[cfg(test)]
mod tests;
