//! An exam in dry friction for engines and solvers: set-ups, each with one question, and answers that can be relied on.
//!
//! Every answer is found twice, without the paper: by following the motion ([`crate`]), and by an enclosure
//! ([`crate::validated`]) or a second integrator with other equations. If they do not agree, it is an [`ExamError`].
//!
//! ```
//! use slipbook_motion::exam::{Answer, TASKS};
//!
//! let task = TASKS.iter().find(|task| task.id == "stop-place").ok_or("no such task")?;
//! let sat = task.sit()?;
//! assert_eq!(sat.answer, Answer::Number(0.425));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod plane;
pub mod posed;
mod ratchet;
mod sphere;
mod tray;
mod turntable;

use crate::MotionError;
use crate::drive::DriveError;
use crate::numerics::NumericsError;
use crate::scene::SceneError;
use serde::Serialize;
use trialbook::certified::{enclosure::Enclosure, error::CertifiedError, interval::Interval};

/// A set-up, a question, and two ways to its answer. Dimensionless, in the units that the set-up names.
#[derive(Debug)]
pub struct Task {
    /// Name, unique.
    pub id: &'static str,
    /// What is to be set up.
    pub setup: &'static str,
    /// The same as data.
    pub posed: posed::Posed,
    /// The question.
    pub question: &'static str,
    /// Of the number that answers it, in the quantities of the set-up (ω is the angular frequency of a pull that repeats); empty
    /// for an order.
    pub unit: &'static str,
    motion: fn() -> Result<Answer, ExamError>,
    other: Other,
}

/// The second way to an answer.
#[derive(Debug)]
enum Other {
    /// As many certain digits as one asks for.
    Digits(Enclosure),
    /// An interval that holds it.
    Within(fn() -> Result<Interval, CertifiedError>),
    /// Another integrator, with equations of motion of its own.
    Integrated(fn() -> Result<Answer, ExamError>),
}

/// One number, or one order of events.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Answer {
    /// A number, dimensionless.
    Number(f64),
    /// What follows on what.
    Order(String),
}

/// What an answer rests on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Basis {
    /// It is enclosed; its error is a bound.
    Certified,
    /// Two integrators agree; its error is their difference, and at least 10⁻¹³ of its size.
    Integrated,
}

impl Basis {
    /// Its name in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Certified => "certified",
            Self::Integrated => "integrated",
        }
    }
}

/// A task with its answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sat {
    /// The answer.
    pub answer: Answer,
    /// How far the true number may be from it; nothing for an order.
    pub error: Option<f64>,
    /// What it rests on.
    pub basis: Basis,
    /// What following the motion gives.
    pub motion: Answer,
}

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExamError {
    /// A motion that cannot be followed.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A driven motion that cannot be followed.
    #[error(transparent)]
    Drive(#[from] DriveError),
    /// A scene that cannot be run.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// An enclosure that is not proved.
    #[error(transparent)]
    Certified(#[from] CertifiedError),
    /// A root not found.
    #[error(transparent)]
    Numerics(#[from] NumericsError),
    /// An event that the question is about does not happen.
    #[error("{0} does not happen")]
    Missing(&'static str),
    /// The two ways come to different answers.
    #[error("{id}: the motion gives {motion}, the other way {other}")]
    Disagree {
        /// The task.
        id: &'static str,
        /// The one answer.
        motion: String,
        /// The other.
        other: String,
    },
}

/// All tasks, in the order of the exam.
pub static TASKS: [Task; 23] = [
    plane::STOP_TIME,
    plane::STOP_PLACE,
    plane::TURNING,
    plane::CREEP,
    plane::BREAKAWAY,
    tray::REST_FRACTION,
    tray::REST_FRACTION_LOW,
    tray::NEVER_RESTS,
    tray::THRESHOLD,
    tray::MIRROR,
    tray::HEAT,
    tray::SIDEWAYS,
    ratchet::ORDERS,
    ratchet::DRIFT,
    ratchet::NO_WAY_BACK,
    ratchet::TOUCHING,
    sphere::SLIP_TIME,
    sphere::PLACE,
    sphere::DRIVEN_SLIP,
    turntable::CRITICAL_RADIUS,
    turntable::CRITICAL_SPEED,
    turntable::PLACE_OF_REST,
    turntable::ESCAPE,
];

/// The unit of a share, a ratio or a logarithm.
const DIMENSIONLESS: &str = "dimensionless";

/// Relative to the larger of 1 and the answer, beside the width of an enclosure: a hundred times what the integrators promise.
const CLOSE: f64 = 1e-10;
/// Claimed without an enclosure, relative to the answer.
const LEAST: f64 = 1e-13;

impl Task {
    /// What following the motion gives, without the other way.
    ///
    /// # Errors
    /// [`ExamError`] where the motion cannot be followed, or has no such event.
    pub fn by_motion(&self) -> Result<Answer, ExamError> {
        (self.motion)()
    }

    /// The answer.
    ///
    /// # Errors
    /// [`ExamError`] where a way ends without an answer, or the two do not agree.
    pub fn sit(&self) -> Result<Sat, ExamError> {
        let motion = self.by_motion()?;
        let (answer, error, basis) = match &self.other {
            Other::Digits(enclosure) => enclosed(enclosure.interval()?),
            Other::Within(interval) => enclosed(interval()?),
            Other::Integrated(other) => match (&motion, other()?) {
                (Answer::Number(x), Answer::Number(y)) => {
                    let error = (x - y).abs().max(LEAST * x.abs());
                    (Answer::Number(y), Some(error), Basis::Integrated)
                }
                (_, answer) => (answer, None, Basis::Integrated),
            },
        };
        let bound = match basis {
            Basis::Certified => error.unwrap_or(0.0),
            Basis::Integrated => 0.0,
        };
        let agree = match (&motion, &answer) {
            (Answer::Number(x), Answer::Number(y)) => {
                (x - y).abs() <= CLOSE * y.abs().max(1.0) + bound
            }
            (x, y) => x == y,
        };
        if !agree {
            return Err(ExamError::Disagree {
                id: self.id,
                motion: motion.to_string(),
                other: answer.to_string(),
            });
        }
        Ok(Sat {
            answer,
            error,
            basis,
            motion,
        })
    }
}

fn enclosed(interval: Interval) -> (Answer, Option<f64>, Basis) {
    let middle = interval.mid();
    let error = (interval.hi() - middle).max(middle - interval.lo());
    (Answer::Number(middle), Some(error), Basis::Certified)
}

impl std::fmt::Display for Answer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(x) => write!(f, "{x}"),
            Self::Order(order) => f.write_str(order),
        }
    }
}

impl Sat {
    /// With the decimals that its error leaves, at most fifteen digits; without its unit.
    pub fn text(&self) -> String {
        let (Answer::Number(x), Some(error)) = (&self.answer, self.error) else {
            return self.answer.to_string();
        };
        let known = |size: f64| libm::floor(-libm::log10(size.max(1e-300)));
        let decimals = known(error)
            .min(15.0 + known(x.abs().max(1e-3)))
            .clamp(0.0, 15.0);
        let text = format!("{x:.0$}", decimals as usize);
        match text.contains('.') {
            true if format!("{x}").len() < text.len() => format!("{x}"),
            _ => text,
        }
    }

    /// An interval that holds the number; nothing for an order.
    pub fn interval(&self) -> Option<[f64; 2]> {
        match (&self.answer, self.error) {
            (Answer::Number(x), Some(error)) => Some(around(*x, error)),
            _ => None,
        }
    }

    /// Of the followed motion from the answer; nothing for an order.
    pub fn deviation(&self) -> Option<f64> {
        match (&self.motion, &self.answer) {
            (Answer::Number(x), Answer::Number(y)) => Some((x - y).abs()),
            _ => None,
        }
    }
}

/// Rounded outwards; no more than that one, if the error is nothing.
fn around(x: f64, error: f64) -> [f64; 2] {
    match error > 0.0 {
        true => [(x - error).next_down(), (x + error).next_up()],
        false => [x, x],
    }
}

/// A number known exactly as a fraction.
macro_rules! fraction {
    ($n:literal / $m:literal) => {
        Other::Digits(Enclosure(|bits| $crate::exam::ratio($n, $m, bits)))
    };
}
use fraction;

fn ratio(n: i64, m: i64, bits: usize) -> Result<trialbook::certified::ball::Ball, CertifiedError> {
    valued(trialbook::certified::ball::Ball::ratio(n, m, bits))
}

fn valued<T>(value: Option<T>) -> Result<T, CertifiedError> {
    value.ok_or_else(|| CertifiedError::unproved("an operation has no value", &[]))
}

#[cfg(test)]
mod tests;
