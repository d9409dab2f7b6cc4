//! Calculators at the reader's own parameters, one per topic.
//!
//! Each answers twice: by the paper's formula, corrected where the printed one fails, and by the motion, which
//! knows no formula. Both meet here, so that an answer says how far they differ and how many of its digits are
//! to be believed. Where there is no formula, two integrations of the motion take the two places.
//!
//! ```
//! use slipbook::claims::solve::constant::{At, Problem};
//!
//! let launch = Problem { lambda: 0.5, v0: 1.0, theta0: 1.0, accel: 1.0, at: At::Time(2.0) };
//! let answer = launch.solve()?;
//! assert!((answer.best.v - 1.721_996_770_1).abs() < 1e-9);
//! assert!(answer.digits >= Some(10));
//! # Ok::<(), slipbook::claims::solve::SolveError>(())
//! ```

pub mod anisotropic;
pub mod constant;
pub mod periodic;
mod report;
pub mod rest;
pub mod sinusoidal;
pub mod sphere;
#[cfg(test)]
mod tests;
pub mod turntable;

pub use report::{Report, VERSION};

use crate::motion::MotionError;
use crate::motion::drive::DriveError;
use crate::numerics::NumericsError;
pub(crate) use crate::numerics::error::plain;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// A parameter lies outside its range.
    #[error("{name} = {} must be {allowed}", plain(*value))]
    Parameter {
        /// Name of the parameter.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: String,
    },
    /// A number of the answer is too large for floating point.
    #[error("{name} is beyond the range of floating-point numbers")]
    NotFinite {
        /// Name of the answer's field.
        name: &'static str,
    },
    /// So close to the boundary between rest and escape that rounding decides.
    #[error(
        "so close to the boundary between rest and escape that rounding decides (p = {p} at time {tau})"
    )]
    Undecided {
        /// Time reached, dimensionless.
        tau: f64,
        /// Speed there, dimensionless.
        p: f64,
    },
    /// The motion cannot be followed.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// The driven motion cannot be followed.
    #[error(transparent)]
    Drive(#[from] DriveError),
    /// An equation cannot be solved.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
}

/// Requires that a parameter is fit.
fn check(name: &'static str, value: f64, fit: bool, allowed: &str) -> Result<(), SolveError> {
    if fit {
        Ok(())
    } else {
        Err(SolveError::Parameter {
            name,
            value,
            allowed: allowed.to_owned(),
        })
    }
}

/// Requires a positive size whose powers are still numbers.
fn size(name: &'static str, value: f64) -> Result<(), SolveError> {
    let fit = (1e-20..=1e20).contains(&value);
    check(name, value, fit, "between 1e-20 and 1e20")
}

/// One quantity of an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Field {
    /// Its name.
    pub name: &'static str,
    /// Its value.
    pub value: Value,
    /// Its digits count against the larger of this and its own size: 0 where all its own digits count.
    pub scale: f64,
}

/// What a quantity may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A word.
    Word(&'static str),
    /// Nothing: there is no such thing in this motion.
    Missing,
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        // Zero has no sign here.
        Value::Number(value + 0.0)
    }
}

impl From<Option<f64>> for Value {
    fn from(value: Option<f64>) -> Self {
        value.map_or(Value::Missing, Value::from)
    }
}

impl From<&'static str> for Value {
    fn from(word: &'static str) -> Self {
        Value::Word(word)
    }
}

impl Field {
    /// A quantity of which all own digits count.
    fn new(name: &'static str, value: impl Into<Value>) -> Self {
        Self::within(0.0, name, value)
    }

    /// A quantity that is a part of something of size `scale`.
    fn within(scale: f64, name: &'static str, value: impl Into<Value>) -> Self {
        Field {
            name,
            value: value.into(),
            scale,
        }
    }

    /// The difference from the same quantity found otherwise, relative to its size; 1 where only one is a number.
    fn difference(&self, other: &Field) -> f64 {
        match (self.value, other.value) {
            (Value::Number(a), Value::Number(b)) if a == b => 0.0,
            (Value::Number(a), Value::Number(b)) => {
                (a - b).abs() / a.abs().max(b.abs()).max(self.scale).max(other.scale)
            }
            (a, b) if a == b => 0.0,
            _ => 1.0,
        }
    }
}

/// The quantities of an answer, by name and in order.
pub trait Fields {
    /// Name, value and scale of each.
    fn fields(&self) -> Vec<Field>;
}

/// An answer, with the two ways by which it was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer<T> {
    /// The more trustworthy of the two.
    pub best: T,
    /// By the paper's formula, corrected where it fails; nothing where there is none.
    pub by_formula: Option<T>,
    /// By the motion.
    pub by_motion: Option<T>,
    /// The largest relative difference between the two ways.
    pub disagreement: Option<f64>,
    /// How many significant digits of every number are to be believed: those in which the two ways agree. Those of a
    /// component count beside the length of its vector. Nothing where the answer has no number or only one way.
    pub digits: Option<u32>,
    /// What the answer rests on, in words.
    pub note: String,
}

/// A relative error below this cannot be told from rounding.
const ROUNDING: f64 = 1e-15;

impl<T: Fields + Clone> Answer<T> {
    /// From a formula and a motion; the formula is the better one.
    fn by_both(formula: T, motion: T, note: impl Into<String>) -> Result<Self, SolveError> {
        let answer = Self::compared(formula.clone(), &motion, note)?;
        Ok(Answer {
            by_formula: Some(formula),
            by_motion: Some(motion),
            ..answer
        })
    }

    /// From a formula and, where it gets there, a motion.
    fn by_either(
        formula: T,
        motion: Option<T>,
        note: impl Into<String>,
    ) -> Result<Self, SolveError> {
        if let Some(motion) = motion {
            return Self::by_both(formula, motion, note);
        }
        let alone = "the motion is too near its end there for floating-point numbers, so no digits are vouched for";
        let answer = Self::compared(
            formula.clone(),
            &formula,
            format!("{}; {alone}", note.into()),
        )?;
        Ok(Answer {
            by_formula: Some(formula),
            disagreement: None,
            digits: None,
            ..answer
        })
    }

    /// From two integrations of the motion; the first is the better one.
    fn by_motions(motion: T, second: &T, note: impl Into<String>) -> Result<Self, SolveError> {
        let answer = Self::compared(motion.clone(), second, note)?;
        Ok(Answer {
            by_motion: Some(motion),
            ..answer
        })
    }

    fn compared(best: T, other: &T, note: impl Into<String>) -> Result<Self, SolveError> {
        let (ours, theirs) = (best.fields(), other.fields());
        for field in ours.iter().chain(&theirs) {
            if matches!(field.value, Value::Number(x) if !x.is_finite()) {
                return Err(SolveError::NotFinite { name: field.name });
            }
        }
        let pairs = ours.iter().zip(&theirs);
        let worst = pairs.map(|(a, b)| a.difference(b)).fold(0.0, f64::max);
        let numbers = ours.iter().any(|f| matches!(f.value, Value::Number(_)));
        Ok(Answer {
            best,
            by_formula: None,
            by_motion: None,
            disagreement: Some(worst),
            digits: numbers.then(|| digits(worst)),
            note: note.into(),
        })
    }
}

/// Significant digits that a relative error leaves.
fn digits(error: f64) -> u32 {
    libm::floor(-libm::log10(error.clamp(ROUNDING, 1.0))) as u32
}

/// A curve that shows an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// What it shows, in a few words.
    pub title: &'static str,
    /// Name of the horizontal axis.
    pub x: &'static str,
    /// Name of the vertical axis.
    pub y: &'static str,
    /// True if both axes have the same unit.
    pub equal: bool,
    /// The points, in order.
    pub points: Vec<[f64; 2]>,
}

/// From 0 to `end` in equal steps, both ends included.
fn steps(end: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| end * (f64::from(i) / f64::from(count)))
}
