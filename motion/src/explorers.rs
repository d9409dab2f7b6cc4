//! What the book's explorers ask: a few numbers in, the values and curves to show out.
//!
//! Pictures are drawn in the reader's browser, but computed by this module, compiled to WebAssembly (see `book/explorers`). A
//! question is a number of [`QUESTIONS`] with up to four arguments, its answer a list of values and one of curves.

pub mod anisotropic;
pub mod constant;
pub mod periodic;
pub mod plane;
pub mod scene;
pub mod sphere;
pub mod tray;
pub mod turntable;

use crate::MotionError;
use crate::drive::DriveError;

/// An answer, ready to be shown. All numbers are dimensionless, in the units that the question names.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answer {
    /// The values, in the order that the question names.
    pub values: Vec<f64>,
    /// Point by point, in the order that the question names.
    pub curves: Vec<Vec<[f64; 2]>>,
}

impl Answer {
    /// As one list: the number of values, the values, the number of curves, and for each curve the number of its points and their
    /// coordinates.
    pub fn flat(&self) -> Vec<f64> {
        let mut list = vec![self.values.len() as f64];
        list.extend(&self.values);
        list.push(self.curves.len() as f64);
        for curve in &self.curves {
            list.push(curve.len() as f64);
            list.extend(curve.iter().flatten());
        }
        list
    }
}

/// Why a question has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExplorerError {
    /// There is no motion to show.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// There is no one-dimensional motion to show.
    #[error(transparent)]
    Drive(#[from] DriveError),
    /// There is no question of this number.
    #[error("question {number} must be below {}", QUESTIONS.len())]
    Question {
        /// The number asked for.
        number: usize,
    },
}

/// A question with its arguments; those that it has no use for are ignored.
pub type Question = fn([f64; 4]) -> Result<Answer, ExplorerError>;

/// By the number under which the browser puts them.
pub const QUESTIONS: [Question; 14] = [
    |[lambda, theta, ..]| constant::motion(lambda, theta),
    |[lambda, ..]| constant::portrait(lambda),
    |[q, lambda, w, _]| anisotropic::motion(q, lambda, w),
    |[to, ..]| anisotropic::map(to),
    |[rho, u, v, _]| turntable::motion(rho, [u, v]),
    |[rho, coarse, ..]| turntable::boundary(rho, coarse != 0.0),
    |[lambda, kappa, u, v]| sphere::motion(lambda, kappa, [u, v]),
    |[lambda, theta, ..]| constant::film(lambda, theta),
    |[q, lambda, w, _]| anisotropic::film(q, lambda, w),
    |[lambda, kappa, u, v]| sphere::film(lambda, kappa, [u, v]),
    |[rho, ..]| turntable::growth(rho),
    |[third, lambda, w, eta]| periodic::motion(third, lambda, w, eta),
    |[third, lambda, w, eta]| periodic::film(third, lambda, w, eta),
    |[lambda, w, across, _]| plane::film(lambda, w, across),
];

/// The answer to a question by its number.
///
/// # Errors
/// No such question, and those of the question.
pub fn answer(number: usize, arguments: [f64; 4]) -> Result<Answer, ExplorerError> {
    let question = QUESTIONS.get(number);
    question.ok_or(ExplorerError::Question { number })?(arguments)
}

const PICTURES: u32 = 480;

fn flag(truth: bool) -> f64 {
    f64::from(u8::from(truth))
}

fn spread(from: f64, to: f64, n: u32) -> impl Iterator<Item = f64> + Clone {
    (0..=n).map(move |i| from + (to - from) * (f64::from(i) / f64::from(n)))
}
