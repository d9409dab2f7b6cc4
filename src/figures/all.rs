//! All figures of the book, from the same data that the trials used; one file per topic.

mod anisotropic;
mod constant;
mod periodic;

use super::{Figure, FigureError};
use crate::claims::anisotropic::{
    census, drawn as anisotropic_drawn, panels, rows as anisotropic_rows, runs as anisotropic_runs,
};
use crate::claims::compare::Failure;
use crate::motion::MotionError;
use crate::motion::drive::DriveError;

/// Why a figure has no data or cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
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
    let topics = [constant::figures, periodic::figures, anisotropic::figures];
    let mut all = Vec::new();
    for figures in topics {
        all.extend(figures()?);
    }
    Ok(all)
}

/// Points of a motion dense enough to draw: equal steps in time, and the integrator's own nodes where it
/// turns fast.
fn sampled(curve: &Curve) -> impl Iterator<Item = crate::motion::State> {
    let motion = &curve.motion;
    let end = motion.end().t;
    let mut states: Vec<_> = (0..=120)
        .filter_map(|i| motion.at(end * f64::from(i) / 120.0).ok())
        .collect();
    states.extend(motion.nodes());
    states.sort_by(|a, b| a.t.total_cmp(&b.t));
    states.dedup_by(|a, b| a.t == b.t);
    states.into_iter()
}

/// Speed and angle against time, from θ₀ = 2π/3.
fn histories() -> Result<Figure, AllFiguresError> {
    let history = |lambda: f64| -> Result<_, MotionError> {
        let curve = portrait::curve(lambda, 2.0 * PI / 3.0)?;
        Ok(History {
            lambda,
            points: sampled(&curve)
                .filter(|s| s.t <= 4.0)
                .map(|s| [s.t, s.speed(), s.direction()])
                .collect(),
            rests: curve.motion.end().speed() == 0.0,
        })
    };
    let histories: Result<Vec<_>, _> = [0.0, 0.5, 1.0, 2.0].into_iter().map(history).collect();
    Ok(speed_and_angle(&histories?)?)
}

/// Time of stopping against the launch angle.
fn stopping_times() -> Result<Figure, AllFiguresError> {
    let times = |lambda: f64| -> Result<_, MotionError> {
        let time = |i: u32| {
            let theta0 = PI * f64::from(i) / 60.0;
            Ok([theta0, portrait::curve(lambda, theta0)?.motion.end().t])
        };
        Ok(StoppingTimes {
            lambda,
            points: (0..=60).map(time).collect::<Result<_, MotionError>>()?,
        })
    };
    let all: Result<Vec<_>, _> = [1.2, 1.5, 2.0, 5.0].into_iter().map(times).collect();
    Ok(stopping_time(&all?)?)
}

fn heights(curves: &anisotropic_runs::Curves) -> anisotropic_figures::Heights {
    anisotropic_figures::Heights {
        q: curves.q,
        a: curves.printed.a,
        b: curves.printed.b,
        c: curves.printed.c,
        d: curves.printed.d,
        e: anisotropic_drawn::on_e(&curves.corrected),
    }
}

fn region_map(
    columns: std::ops::Range<usize>,
    rows: usize,
    largest_q: f64,
) -> Result<anisotropic_figures::Map, AllFiguresError> {
    let map = anisotropic_drawn::map(columns, rows)?;
    let count = census::count(largest_q)?;
    // A region is at most 5.
    let cell = |&(found, printed): &anisotropic_drawn::Cell| anisotropic_figures::Cell {
        found: found as u8,
        printed: printed.unwrap_or(0) as u8,
    };
    Ok(anisotropic_figures::Map {
        curves: map.curves.iter().map(heights).collect(),
        shape: map.shape,
        q: map.q,
        lambda0: map.lambda0,
        cells: map.cells.iter().map(cell).collect(),
        corners: anisotropic_drawn::corners()?,
        count: [count.points, count.printed_wrong, count.corrected_wrong],
    })
}

/// fig-5.
fn region_diagram() -> Result<Figure, AllFiguresError> {
    Ok(anisotropic_figures::fig5(&region_map(0..360, 400, 7.0)?)?)
}

/// The census beyond Y.
fn region_census() -> Result<Figure, AllFiguresError> {
    let map = region_map(180..660, 80, f64::INFINITY)?;
    Ok(anisotropic_figures::census(&map)?)
}

/// fig-6.
fn region_waves() -> Result<Figure, AllFiguresError> {
    let wave = |(points, (q, lambda0))| anisotropic_figures::Wave { q, lambda0, points };
    let waves = anisotropic_drawn::waves()?;
    let waves: Vec<_> = waves.into_iter().zip(panels::PANELS).map(wave).collect();
    Ok(anisotropic_figures::fig6(&waves)?)
}

/// The boundaries for large q.
fn region_boundaries() -> Result<Figure, AllFiguresError> {
    let seen = |row: &anisotropic_rows::Row| anisotropic_figures::Seen {
        curves: heights(&row.curves),
        rest: row.changes.rest,
        reversal: row.changes.reversal,
        backward: row.changes.backward,
        motion: row.changes.motion,
    };
    let seen: Vec<_> = anisotropic_drawn::boundaries()?.iter().map(seen).collect();
    let law = |law: anisotropic_rows::Law| anisotropic_figures::Law {
        exponent: law.exponent,
        prefactor: law.prefactor,
    };
    let laws = anisotropic_rows::far_laws()?.map(law);
    Ok(anisotropic_figures::far(&seen, laws)?)
}
