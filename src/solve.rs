//! Calculators at the reader's own parameters, one per topic.
//!
//! Each answers twice: by the paper's formula, corrected where the printed one fails, in numbers of twice the width,
//! and by the motion, which knows no formula; without a formula, by two integrations of the motion. How far the two
//! differ says how many digits are to be believed.
//!
//! Cost: a few motions, which have their [limits](crate::motion): milliseconds as a rule, some tenths of a second on
//! the turntable's boundary.
//!
#![doc = include_str!("solve/axes/library.md")]
//!
//! What is given is taken as exact: an `f64` as the number that it is, a typed decimal fraction as it stands
//! ([`Double`]).
//!
//! ```
//! use slipbook::solve::constant::{At, ConstantProblem};
//!
//! let launch = ConstantProblem { lambda: 0.5, v0: 1.0, theta0: 1.0, accel: 1.0, at: At::Time(2.0) };
//! let answer = launch.solve()?;
//! assert!((answer.best.v - 1.721_996_770_1).abs() < 1e-9);
//! assert!(answer.digits >= Some(10));
//! # Ok::<(), slipbook::solve::SolveError>(())
//! ```

pub mod anisotropic;
/// Which way the axes of the problems point, as Markdown: words and a sketch.
pub mod axes {
    /// Where the plane has one acceleration.
    pub const LINE: &str = include_str!("solve/axes/line.md");
    /// Where it is driven to and fro.
    pub const DRIVE: &str = include_str!("solve/axes/drive.md");
    /// On the turntable.
    pub const TABLE: &str = include_str!("solve/axes/table.md");
}
pub mod constant;
pub mod periodic;
mod report;
pub mod rest;
pub mod sinusoidal;
pub mod sphere;
#[cfg(test)]
mod tests;
pub mod turntable;

mod units;

pub use report::{Report, VERSION};
pub use units::{DIMENSIONLESS, RADIANS, head};

use crate::motion::{MotionError, drive::DriveError};
use crate::numerics::NumericsError;
pub use crate::numerics::double::Double;
pub(crate) use crate::numerics::error::plain;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
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
        "so close to the boundary between rest and escape that rounding decides (p = {} μg/Ω at the time {}/Ω)",
        plain(*p),
        plain(*tau)
    )]
    Undecided {
        /// Time reached, dimensionless.
        tau: f64,
        /// Speed there, dimensionless.
        p: f64,
    },
    /// Its stop is asked for, and it has none.
    #[error("it slides for ever: say at which time or angle")]
    NoStop,
    /// The two ways to the answer have no digit in common, and nothing explains it.
    #[error(
        "no digit of the answer is known: formula and motion, or two integrations of the motion, do not agree"
    )]
    Unknown,
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

/// A number that is given: an `f64`, or one that is known more closely, such as a decimal fraction.
pub trait Quantity: Copy + Into<Double> + Into<f64> {}

impl<T: Copy + Into<Double> + Into<f64>> Quantity for T {}

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

/// The motion of parameters that are in range; one that cannot be followed that far, in floating-point numbers or in the
/// steps allowed, is none.
fn followed<T>(motion: Result<Option<T>, SolveError>) -> Option<T> {
    motion.ok().flatten()
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
    /// The unit of a number; empty for a word.
    pub unit: &'static str,
    /// Its digits count against the larger of this and its own size: 0 where all its own digits count.
    pub scale: f64,
    /// What is not known of it, in numbers of twice the width: the rounding of what it is a small difference of.
    lost: f64,
    /// Below this two ways are not compared, as one of them has no numbers for it.
    unseen: f64,
}

/// Of what is a difference of numbers of size 1 and less than this, [`ROUNDED`] leaves fewer than fifteen digits.
const SMALL: f64 = 2e-14;

/// Below this nothing is left of the second half of a number of twice the width.
const LOST: f64 = 1e-310;

/// Below this an angle loses digits to the end of floating-point numbers,
const LEAST_ANGLE: f64 = 1e-290;
/// and below this the motion does not see it, as its terms are powers of it.
const UNSEEN_ANGLE: f64 = 1e-60;

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

    fn within(scale: f64, name: &'static str, value: impl Into<Value>) -> Self {
        let value = value.into();
        Field {
            name,
            value,
            unit: match value {
                Value::Word(_) => "",
                _ => DIMENSIONLESS,
            },
            scale,
            lost: LOST,
            unseen: 0.0,
        }
    }

    fn of(self, unit: &'static str) -> Self {
        Field { unit, ..self }
    }

    fn unseen_below(self, unseen: f64) -> Self {
        Field { unseen, ..self }
    }

    /// A difference of numbers of this size.
    fn out_of(self, size: f64) -> Self {
        Field {
            lost: self.lost + ROUNDED * size,
            ..self
        }
    }

    /// Whether it is another one but for `rounding`; words do not count.
    fn is_within(&self, other: &Field, rounding: f64) -> bool {
        match (self.value, other.value) {
            (Value::Number(a), Value::Number(b)) => (a - b).abs() <= rounding,
            (Value::Word(_), Value::Word(_)) => rounding > 0.0,
            (a, b) => a == b,
        }
    }

    fn rounded(self, digits: u32) -> Self {
        let Value::Number(x) = self.value else {
            return self;
        };
        let beyond = if x.abs() < self.scale {
            power_of_ten(self.scale) - power_of_ten(x)
        } else {
            0
        };
        if digits == 0 {
            // Of which no digit is known: no number, and least of all 0.
            return Field {
                value: Value::Missing,
                ..self
            };
        }
        let value = match i64::from(digits) - beyond {
            more @ 1.. if x != 0.0 => {
                let text = format!("{x:.*e}", more as usize - 1);
                text.parse().unwrap_or(x)
            }
            _ => 0.0,
        };
        Field {
            value: Value::from(value),
            ..self
        }
    }

    /// An error as a part of what the digits count against.
    fn part(&self, error: f64) -> f64 {
        match self.value {
            Value::Number(x) if error != 0.0 && x != 0.0 => error.abs() / x.abs().max(self.scale),
            _ => 0.0,
        }
    }

    /// Relative to its size; 1 where only one is a number. Words do not count.
    fn difference(&self, other: &Field) -> f64 {
        match (self.value, other.value) {
            (Value::Number(a), Value::Number(b)) if a == b => 0.0,
            (Value::Number(a), Value::Number(b)) => {
                let least = self.scale.max(other.scale).max(self.unseen);
                (a - b).abs() / a.abs().max(b.abs()).max(least)
            }
            (Value::Word(_), Value::Word(_)) => 0.0,
            (a, b) if a == b => 0.0,
            _ => 1.0,
        }
    }

    fn is_seen_beside(&self, other: &Field) -> bool {
        match (self.value, other.value) {
            (Value::Word(a), Value::Word(b)) => a != b,
            _ => self.difference(other) > ALIKE,
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
    /// Significant digits of every number that are to be believed: all fifteen where the two ways differ by no more
    /// than the rounding of the worse one explains, else those in which they agree. Those of a component count
    /// beside the length of its vector. Nothing where the answer has no number.
    pub digits: Option<u32>,
    /// What the answer rests on, in words.
    pub note: String,
}

/// Two motions found in different ways agree to this where nothing makes much of rounding,
const ALIKE: f64 = 1e-9;
/// and to so many times what a nudge of the start by 10⁻²⁸ moves: 500 roundings of an `f64`.
const NARROWER: f64 = 1e15;
/// A formula and a motion agree to this where nothing does,
const CLOSE: f64 = 1e-12;
/// and elsewhere to so many times the difference of two motions that are one but for their units.
const NOISE: f64 = 100.0;
/// Units that no power of two leads to, so that every rounding is another one.
const UNITS: f64 = 1.1;
/// or to what a parameter that is off by a few hundred roundings makes of the formula.
const NUDGES: [f64; 2] = [1.0 - 1e-13, 1.0 + 1e-13];
/// The rounding of phases and of the velocities of a drive of size 1.
const PHASES: f64 = 1e-13;

/// What a hundred roundings take from a number of twice the width.
const ROUNDED: f64 = 1e-29;

const NEXT_TO_IT: &str =
    "the motion is that of the floating-point numbers next to what is given, and here that shows";

/// A relative error below this cannot be told from rounding.
const ROUNDING: f64 = 1e-15;

/// What a formula says in numbers of twice the width: for what is given, rounded to `f64` and nudged.
struct Said<T> {
    given: T,
    rounded: T,
    /// Where that is in range.
    beside: Vec<T>,
}

impl<T> Said<T> {
    /// By the formula, a function of what is given (`None`) or of a parameter in `f64` times a number.
    fn by<E>(formula: impl Fn(Option<f64>) -> Result<T, E>) -> Result<Self, E> {
        let nudged = |by| formula(Some(by)).ok();
        Ok(Self {
            given: formula(None)?,
            rounded: formula(Some(1.0))?,
            beside: NUDGES.into_iter().filter_map(nudged).collect(),
        })
    }
}

impl<T: Fields + Clone> Answer<T> {
    /// From a formula and the motion in `f64`, twice over in different units. All digits that the formula
    /// [keeps](Field::lost) are known where the motion differs from it by no more than from itself, or than the
    /// formula does for parameters next to the given ones, or nowhere by more than `rounding`; else those in which
    /// the two agree.
    fn by_both(
        said: Said<T>,
        motions: [T; 2],
        rounding: f64,
        note: impl Into<String>,
    ) -> Result<Self, SolveError> {
        let [motion, again] = motions;
        let (formula, near) = (said.given, Self::compared(said.rounded, &motion, note)?);
        let answer = Self {
            disagreement: near.disagreement,
            digits: near.digits,
            ..Self::compared(formula.clone(), &formula, near.note)?
        };
        let [ours, rounded, theirs, same] =
            [&formula, &near.best, &motion, &again].map(Fields::fields);
        let beside: Vec<_> = said.beside.iter().map(Fields::fields).collect();
        let of_no_size = rounded
            .iter()
            .zip(&theirs)
            .all(|(a, b)| a.is_within(b, rounding));
        let explained = |(i, found): (usize, &Field)| {
            let nudged = beside.iter().map(|there| rounded[i].difference(&there[i]));
            let noise = nudged.fold(NOISE * found.difference(&same[i]), f64::max);
            found.difference(&rounded[i]) <= CLOSE + noise
        };
        let explained = of_no_size || theirs.iter().enumerate().all(explained);
        let mut next = beside.iter().chain([&rounded]);
        let shows = next.any(|there| {
            let mut all = ours.iter().zip(there).zip(&theirs);
            all.any(|((a, b), motion)| a.is_seen_beside(b) && a.is_seen_beside(motion))
        });
        Ok(Answer {
            by_formula: Some(formula),
            by_motion: Some(motion),
            digits: match answer.digits {
                Some(_) if explained => Some(kept(&ours)),
                agreed => agreed,
            },
            note: if shows {
                format!("{}; {NEXT_TO_IT}", answer.note)
            } else {
                answer.note
            },
            ..answer
        })
    }

    /// As [`by_both`](Self::by_both), if the motion gets there.
    fn by_either(
        said: Said<T>,
        motions: Option<[T; 2]>,
        rounding: f64,
        note: impl Into<String>,
    ) -> Result<Self, SolveError> {
        if let Some(motions) = motions {
            return Self::by_both(said, motions, rounding, note);
        }
        let formula = said.given;
        let alone = "the motion does not get there in floating-point numbers, so that the digits are those of the formula alone";
        let answer = Self::compared(
            formula.clone(),
            &formula,
            format!("{}; {alone}", note.into()),
        )?;
        Ok(Answer {
            digits: answer.digits.map(|_| kept(&formula.fields())),
            by_formula: Some(formula),
            disagreement: None,
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

    /// From a motion in numbers of twice the width and one in `f64`. By `nudged` and `rounded` each field of the
    /// first changes for a nudge of the start by 10⁻²⁸ and for its rounding to `f64`: all digits that the nudge
    /// leaves are known, unless the second way differs by more than the narrower numbers explain.
    fn by_wide_motion(
        best: T,
        second: &T,
        [nudged, rounded]: [Vec<f64>; 2],
        note: impl Into<String>,
    ) -> Result<Self, SolveError> {
        let answer = Self::by_motions(best, second, note)?;
        let fields = answer.best.fields();
        let numbers = fields
            .iter()
            .filter(|field| matches!(field.value, Value::Number(_)));
        let largest = |moved: Vec<f64>| {
            let parts = numbers
                .clone()
                .zip(moved)
                .map(|(field, moved)| field.part(moved));
            parts.fold(0.0, f64::max)
        };
        let (nudged, rounded) = (largest(nudged), largest(rounded));
        let unlike = answer.disagreement.unwrap_or(0.0);
        let explained = unlike <= ALIKE + NARROWER * nudged + 2.0 * rounded;
        Ok(Answer {
            digits: Some(digits(if explained { nudged } else { unlike })),
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

fn digits(error: f64) -> u32 {
    libm::floor(-libm::log10(error.clamp(ROUNDING, 1.0))) as u32
}

/// A number to the digits that this error leaves, and how many they are.
pub fn known(value: f64, error: f64) -> (f64, u32) {
    let field = Field::new("", value);
    // One unit of the last digit is allowed, and half of it goes to its rounding.
    let unit = libm::log10(2.0 * error).max(-400.0) - power_of_ten(value) as f64;
    let digits = (1.0 - unit).floor().clamp(0.0, 15.0) as u32;
    match field.rounded(digits).value {
        Value::Number(value) => (value, digits),
        _ => (value, digits),
    }
}

/// That of the first significant digit.
fn power_of_ten(x: f64) -> i64 {
    let text = format!("{x:e}");
    let power = text.split_once('e').map(|(_, power)| power.parse());
    power.and_then(Result::ok).unwrap_or(0)
}

fn kept(fields: &[Field]) -> u32 {
    let parts = fields.iter().map(|field| field.part(field.lost));
    digits(parts.fold(0.0, f64::max))
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
    /// Units of the two axes.
    pub units: [&'static str; 2],
    /// True if both axes have the same unit.
    pub equal: bool,
    /// The points, in order.
    pub points: Vec<[f64; 2]>,
}

/// In equal steps, both ends included.
fn steps(end: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| end * (f64::from(i) / f64::from(count)))
}
