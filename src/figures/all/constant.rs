//! Figures of section 2.1.

use super::AllFiguresError;
use crate::claims::constant::drawn::{self, Curve};
use crate::figures::constant::{
    Ending, History, Hodograph, Hodographs, StoppingTimes, fig1, speed_and_angle, stopping_time,
};
use crate::motion::MotionError;
use std::f64::consts::PI;
use trialbook::figures::Figure;

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    Ok(vec![portraits()?, histories()?, stopping_times()?])
}

/// fig-1.
fn portraits() -> Result<Figure, AllFiguresError> {
    let panel = |lambdas: &[f64]| -> Result<Vec<_>, MotionError> {
        Ok(drawn::panel(lambdas)?.iter().map(hodograph).collect())
    };
    Ok(fig1(&Hodographs {
        weak: panel(&drawn::WEAK)?,
        strong: panel(&drawn::STRONG)?,
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
        let curve = drawn::curve(lambda, 2.0 * PI / 3.0)?;
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
            Ok([theta0, drawn::curve(lambda, theta0)?.motion.end().t])
        };
        Ok(StoppingTimes {
            lambda,
            points: (0..=60).map(time).collect::<Result<_, MotionError>>()?,
        })
    };
    let all: Result<Vec<_>, _> = [1.2, 1.5, 2.0, 5.0].into_iter().map(times).collect();
    Ok(stopping_time(&all?)?)
}
