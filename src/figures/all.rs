//! All figures of the book, from the same data that the trials used; one file per topic.

mod anisotropic;
mod constant;
mod digits;
mod escape;
mod exam;
mod periodic;
mod rest;
mod sinusoidal;
mod sphere;
mod turntable;

use crate::motion::MotionError;
use crate::motion::drive::DriveError;
use rayon::prelude::*;
use trialbook::claims::compare::Failure;
use trialbook::figures::{Figure, FigureError};

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
        sphere::figures,
        turntable::figures,
        escape::figures,
        rest::figures,
        digits::figures,
        exam::figures,
    ];
    let made: Result<Vec<_>, _> = topics.into_par_iter().map(|figures| figures()).collect();
    Ok(made?.into_iter().flatten().collect())
}
