//! The figures of the book, a file for each topic, made with the tools of [`trialbook::plotting`].

mod anisotropic;
mod census;
mod constant;
mod digits;
pub(crate) use digits::RECORD;
mod drift;
mod escape;
mod exam;
mod fates;
mod periodic;
mod rest;
mod sinusoidal;
pub mod solve;
mod sphere;
#[cfg(test)]
mod tests;
mod trend;
pub(crate) use trend::{falls, rises, same};
mod turntable;

use crate::motion::{MotionError, drive::DriveError};
use rayon::prelude::*;
use trialbook::plotting::{Figure, FigureError};
use trialbook::trials::compare::Failure;

/// Why a figure has no data or cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AllFiguresError {
    /// A motion that cannot be followed.
    #[error("a figure's motion: {0}")]
    Motion(#[from] MotionError),
    /// A driven motion that cannot be followed.
    #[error("a figure's driven motion: {0}")]
    Drive(#[from] DriveError),
    /// Data that a trial could not provide.
    #[error("a figure's data: {0}")]
    Data(String),
    /// Data that cannot be drawn.
    #[error("a figure: {0}")]
    Figure(#[from] FigureError),
}

impl From<Failure> for AllFiguresError {
    fn from(failure: Failure) -> Self {
        Self::Data(failure.to_string())
    }
}

type Drawn<T = Figure> = Result<T, AllFiguresError>;

/// Every figure, in the order of the book.
///
/// # Errors
/// [`AllFiguresError`] if a motion cannot be followed or its data not be drawn.
pub fn all() -> Result<Vec<Figure>, AllFiguresError> {
    let topics = [
        constant::figures,
        sinusoidal::figures,
        periodic::figures,
        anisotropic::figures,
        drift::figures,
        sphere::figures,
        turntable::figures,
        escape::figures,
        fates::figures,
        rest::figures,
        digits::figures,
        exam::figures,
    ];
    let made: Result<Vec<_>, _> = topics.into_par_iter().map(|figures| figures()).collect();
    Ok(made?.into_iter().flatten().collect())
}

/// Which figure of the paper one of ours is drawn after: by its caption and the marks on its axes alone.
fn after(id: &str) -> String {
    let number = id.trim_start_matches("fig-");
    format!(
        "After the paper's Figure {number}, by its caption and marks; its source has no pictures, and we have not seen that one."
    )
}
