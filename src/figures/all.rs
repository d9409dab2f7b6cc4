//! All figures of the book, from the same data that the trials used.

mod sinusoidal;

use super::constant::{
    Ending, History, Hodograph, Hodographs, StoppingTimes, fig1, speed_and_angle, stopping_time,
};
use super::periodic as periodic_figures;
use super::{Figure, FigureError};
use crate::claims::constant::portrait::{self, Curve};
use crate::claims::periodic::{drawn, drives::Phase};
use crate::motion::MotionError;
use crate::motion::drive::DriveError;
use std::f64::consts::PI;

/// Why a figure has no data or cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AllFiguresError {
    /// A motion that cannot be followed.
    #[error("a figure's motion: {0}")]
    Motion(#[from] MotionError),
    /// A motion that cannot be followed, said in words.
    #[error("a figure's data: {0}")]
    Data(String),
    /// A driven motion that cannot be followed.
    #[error("a figure's driven motion: {0}")]
    Drive(#[from] DriveError),
    /// Data that cannot be drawn.
    #[error("a figure: {0}")]
    Figure(#[from] FigureError),
}

/// Every figure, in the order of the book.
///
/// # Errors
/// [`AllFiguresError`] if a motion cannot be followed or its data not be drawn.
pub fn all() -> Result<Vec<Figure>, AllFiguresError> {
    let mut all = vec![portraits()?, histories()?, stopping_times()?];
    all.extend(sinusoidal::figures()?);
    all.extend([
        drive_census()?,
        pulse_waves()?,
        rest_shares()?,
        come_and_go()?,
    ]);
    Ok(all)
}

/// fig-1.
fn portraits() -> Result<Figure, AllFiguresError> {
    let panel = |lambdas: &[f64]| -> Result<Vec<_>, MotionError> {
        Ok(portrait::panel(lambdas)?.iter().map(hodograph).collect())
    };
    Ok(fig1(&Hodographs {
        weak: panel(&portrait::WEAK)?,
        strong: panel(&portrait::STRONG)?,
    })?)
}

fn hodograph(curve: &Curve) -> Hodograph {
    let end = curve.motion.end();
    Hodograph {
        lambda: curve.lambda,
        theta0: curve.theta0,
        points: sampled(curve).map(|s| [s.t, s.v[0], s.v[1]]).collect(),
        ending: if end.speed() == 0.0 {
            Ending::Rest
        } else if curve.lambda == 1.0 {
            Ending::Terminal(end.v)
        } else {
            Ending::Onward
        },
    }
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

/// Rests per period of the named drives.
fn drive_census() -> Result<Figure, AllFiguresError> {
    let rows: Vec<_> = drawn::census(400)?
        .into_iter()
        .map(|row| periodic_figures::CensusRow {
            name: row.name.into(),
            mean_size: row.mean_size,
            fates: row.phases.into_iter().map(fate).collect(),
        })
        .collect();
    Ok(periodic_figures::census(&rows)?)
}

fn fate(phase: Phase) -> periodic_figures::Fate {
    match phase {
        Phase::Drifts => periodic_figures::Fate::Drifts,
        Phase::Rests(rests) => periodic_figures::Fate::Rests(rests),
        // At rest for ever is one rest.
        Phase::Still => periodic_figures::Fate::Rests(1),
    }
}

fn waves(list: Vec<drawn::Wave>) -> Vec<periodic_figures::Wave> {
    let wave = |wave: drawn::Wave| periodic_figures::Wave {
        lambda: wave.lambda,
        rests: wave.rests,
        points: wave.points,
    };
    list.into_iter().map(wave).collect()
}

/// The pulses' motion below and above λ_c.
fn pulse_waves() -> Result<Figure, AllFiguresError> {
    let list = waves(drawn::pulse_waves()?);
    Ok(periodic_figures::pulse_waves(drawn::ETA, &list)?)
}

/// How long the pulses let rest.
fn rest_shares() -> Result<Figure, AllFiguresError> {
    let side = 100;
    Ok(periodic_figures::rest_shares(side, &drawn::shares(side)?)?)
}

/// Rests that come and go with growing friction.
fn come_and_go() -> Result<Figure, AllFiguresError> {
    Ok(periodic_figures::come_and_go(
        &waves(drawn::come_and_go()?),
    )?)
}
