//! Trials of the points X and Y: where the curves meet, and how.

use super::simulated::{
    START, attractor_from, bisect, change, restless, reverses, simulated, touching,
};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::points::Points;
use crate::claims::tolerances::{CONTACT, MOTION, ROOT, THREE_DECIMALS};
use crate::corrections::anisotropic as corrected;
use crate::evidence::{Evidence, Route, Subject};
use crate::motion::drive::{Friction, Interval, Sign, State};
use crate::paper::anisotropic as printed;
use std::f64::consts::PI;

/// Seeded starts, the plain one first.
fn starts(stream: u64) -> impl Iterator<Item = State> {
    let mut points = Points::stream(stream);
    (0..24).map(move |i| match i {
        0 => START,
        _ => State {
            phi: points.uniform(0.0, 2.0 * PI),
            w: points.uniform(-2.0, 2.0),
        },
    })
}

fn at(start: State) -> String {
    format!("start φ = {:.6}, 𝔴 = {:.6}", start.phi, start.w)
}

/// (57) with the change of the motion with equal frictions.
pub fn x_root() -> Evidence {
    let compared =
        "λ₀ of X with the λ₀ at which, with q = 1, a rest appears in the simulated motion";
    x(compared, 308, restless)
}

/// At X both A and B end.
pub fn x_both() -> Evidence {
    let compared =
        "λ₀ of X with the λ₀ at which, with q = 1, direct reversals end in the simulated motion";
    x(compared, 309, reverses)
}

fn x(compared: &'static str, stream: u64, holds: fn(&[Interval]) -> bool) -> Evidence {
    let [q, lambda0] = printed::eq57_x();
    let trial = Trial::by(Route::Root, Subject::Printed, compared, ROOT);
    trial.over(starts(stream), |start| {
        Ok(Pair {
            at: at(start),
            stated: lambda0,
            found: change(q, 1e-9, start, holds)?,
            scale: lambda0,
        })
    })
}

/// The q at which, along C, the forward motion ends just where the drive is lowest: Y by simulation alone.
fn simulated_y(start: State) -> Result<f64, Failure> {
    bisect(2.0, 12.0, |q| {
        let motion = attractor_from(start, Friction::new(1.0 / q, 1.0)?)?;
        let forward = motion.intervals().iter().find(|i| i.sign == Sign::Positive);
        Ok(forward.ok_or("no forward motion on C")?.end < 1.5 * PI)
    })
}

/// (58) with Y by simulation, from several starts.
pub fn y_decimals() -> Evidence {
    let compared = "(58) with the point of qλ₀ = 1 where the forward motion ends at the drive's minimum, by simulation";
    let trial = Trial::by(Route::Root, Subject::Printed, compared, THREE_DECIMALS);
    let [q, lambda0] = printed::eq58_y();
    let both = |start| [(start, true), (start, false)];
    trial.over(starts(310).flat_map(both), |(start, is_q)| {
        let found = simulated_y(start)?;
        let (name, stated, found) = if is_q {
            ("q", q, found)
        } else {
            ("λ₀", lambda0, 1.0 / found)
        };
        Ok(Pair {
            at: format!("{name}, {}", at(start)),
            stated,
            found,
            scale: 1.0,
        })
    })
}

/// (58) with the place to which region II narrows along qλ₀ = 1 − η.
pub fn y_limit() -> Evidence {
    let compared = "q of (58) with the middle of region II on qλ₀ = 1 − η, its ends by simulation, for η from 1e-5 to 1e-10";
    let trial = Trial::by(Route::Limit, Subject::Printed, compared, THREE_DECIMALS);
    trial.over(0..24, |k| {
        let eta = 1e-5 * libm::exp10(-f64::from(k) / 5.0);
        let [low, high] = opening(eta)?;
        Ok(Pair {
            at: format!("η = {eta:.5e}"),
            stated: printed::eq58_y::<f64>()[0],
            found: 0.5 * (low + high),
            scale: 1.0,
        })
    })
}

/// Y from (54) and (55), to all digits, with Y by simulation.
pub fn y_digits() -> Evidence {
    let compared = "the root of (54) on (55) with the point of qλ₀ = 1 where the forward motion ends at the drive's minimum, by simulation";
    let trial = Trial::by(Route::Root, Subject::Printed, compared, MOTION);
    trial.over(starts(311), |start| {
        let found = simulated_y(start)?;
        Ok(Pair {
            at: at(start),
            stated: touching()?,
            found,
            scale: found,
        })
    })
}

/// Curves that touch: region II between them on qλ₀ = 1 − η opens as the root of η; as η, if they crossed.
pub fn y_contact() -> Evidence {
    let compared = "1/2 with the exponent by which region II opens along q on qλ₀ = 1 − η, by simulation, for η from 1e-3 to 1e-10";
    let trial = Trial::by(Route::Limit, Subject::Printed, compared, CONTACT);
    trial.over(0..24, |k| {
        let eta = 1e-3 * libm::exp2(-f64::from(k));
        let width = |eta: f64| opening(eta).map(|[low, high]| high - low);
        let found = libm::log2(width(eta)? / width(0.5 * eta)?);
        Ok(Pair {
            at: format!("η = {eta:.5e}"),
            stated: 0.5,
            found,
            scale: 1.0,
        })
    })
}

/// How closely they touch, as a number: C − B and C − E over (q − q_Y)², the mean of both sides.
pub fn y_curvature() -> Evidence {
    let compared = "(q_Y − 1)/(2 q_Y³ (q_Y + 1)) with (λ₀ on C − λ₀ where direct reversals end)/(q − q_Y)², by simulation, at q = q_Y ± δ";
    let trial = Trial::by(Route::Root, Subject::Printed, compared, CONTACT);
    trial.over(0..24, |k| {
        let y = touching()?;
        let delta = 1e-2 * libm::exp10(-f64::from(k) / 24.0);
        let gap = |q: f64| -> Result<f64, Failure> {
            let end = change(q, 1e-9, START, reverses)?;
            Ok((printed::eq55_lambda0(q) - end) / (delta * delta))
        };
        let found = 0.5 * (gap(y - delta)? + gap(y + delta)?);
        Ok(Pair {
            at: format!("δ = {delta:.5e}"),
            stated: corrected::contact(y),
            found,
            scale: found,
        })
    })
}

/// The ends in q of region II along qλ₀ = 1 − η, by simulation.
fn opening(eta: f64) -> Result<[f64; 2], Failure> {
    let y = touching()?;
    let is_second = |q: f64| Ok(simulated(q, (1.0 - eta) / q)? == 2);
    Ok([bisect(y, 2.0, is_second)?, bisect(y, 9.0, is_second)?])
}
