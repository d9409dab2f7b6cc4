//! Trials of what section 2.2 says of the velocity across the drive: how it dies, and what it leaves behind.

use super::runs::{ORIGIN, Particle, drive, lambda_c, settled};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::points::Points;
use crate::claims::tolerances::{EXPONENTIAL, FIRST_STAGE, FORGOTTEN, NONE, VANISHES};
use crate::evidence::{Evidence, Route, Subject};
use crate::motion::drive::PlanarState;
use crate::scalar::Scalar;
use std::f64::consts::TAU;

/// A motion in the plane, once a period from φ = 0 on.
pub fn strobed(lambda: f64, w_x: f64, w_y: f64, periods: u32) -> Result<Vec<PlanarState>, Failure> {
    let start = PlanarState {
        phi: 0.0,
        w_x,
        ln_w_y: Scalar::ln(w_y),
    };
    let phases: Vec<_> = (0..=periods).map(|k| TAU * f64::from(k)).collect();
    Ok(drive()?.planar(lambda, start, &phases)?)
}

/// Random frictions on both sides of λ_c and of 1.
fn frictions(stream: u64, count: usize) -> Vec<[f64; 3]> {
    let mut points = Points::stream(stream);
    let mut draw = || {
        let lambda = points.uniform(0.15, 1.4);
        [lambda, points.uniform(-1.0, 1.0), points.uniform(0.1, 3.0)]
    };
    (0..count).map(|_| draw()).collect()
}

fn at([lambda, w_x, w_y]: [f64; 3]) -> String {
    format!("λ₀ = {lambda:.6}, 𝔴 = {w_x:.6}, 𝔴_y = {w_y:.6}")
}

/// v_y → 0: what is left after 20 periods.
pub fn vanishes_limit() -> Evidence {
    let compared = "0 with 𝔴_y after 20 periods, from ln 𝔴_y";
    let trial = Trial::by(Route::Limit, Subject::Printed, compared, VANISHES);
    trial.over(frictions(160, 30), |start| {
        let [lambda, w_x, w_y] = start;
        let states = strobed(lambda, w_x, w_y, 20)?;
        let last = states.last().ok_or("no state")?;
        Ok::<_, Failure>(Pair {
            at: at(start),
            stated: 0.0,
            found: Scalar::exp(last.ln_w_y),
            scale: w_y,
        })
    })
}

/// The same by the other integrator.
pub fn vanishes_motion() -> Evidence {
    let compared = "0 with v_y of a particle on the plane after 12 periods";
    let trial = Trial::by(Route::Integration, Subject::Printed, compared, VANISHES);
    trial.over(frictions(161, 40), |start| {
        let [lambda, w_x, w_y] = start;
        let end = Particle::plain(lambda)
            .run(0.0, [w_x, w_y], 12.0 * TAU)?
            .end();
        Ok::<_, Failure>(Pair {
            at: at(start),
            stated: 0.0,
            found: end.v[1],
            scale: w_y,
        })
    })
}

/// On the way v_y never grows.
pub fn vanishes_census() -> Evidence {
    let compared =
        "0 with the steps of a fortieth of a period on which ln 𝔴_y grows, over three periods";
    let trial = Trial::by(Route::Census, Subject::Printed, compared, NONE);
    trial.over(frictions(162, 30), |start| {
        let [lambda, w_x, w_y] = start;
        let phases: Vec<_> = (0..=120).map(|k| TAU * f64::from(k) / 40.0).collect();
        let from = PlanarState {
            phi: 0.0,
            w_x,
            ln_w_y: Scalar::ln(w_y),
        };
        let states = drive()?.planar(lambda, from, &phases)?;
        let grows = states.windows(2).filter(|s| s[1].ln_w_y > s[0].ln_w_y);
        Ok::<_, Failure>(Pair {
            at: at(start),
            stated: 0.0,
            found: grows.count() as f64,
            scale: 1.0,
        })
    })
}

/// First stage: the mean slope of 𝔴_y over a period, while 𝔴_y is ten thousand times 𝔴_x or more.
pub fn first_stage() -> Evidence {
    let compared = "−λ₀ with the mean slope of 𝔴_y over a period in which it stays above 10⁴ |𝔴|";
    let trial = Trial::by(Route::Limit, Subject::Printed, compared, FIRST_STAGE);
    let mut points = Points::stream(163);
    trial.over(0..30, |_| {
        let lambda = points.uniform(0.05, 1.5);
        let w_x = points.uniform(-1.0, 1.0);
        let w_y = points.log_uniform(3e4, 3e5);
        let states = strobed(lambda, w_x, w_y, 1)?;
        let last = Scalar::exp(states[1].ln_w_y);
        Ok::<_, Failure>(Pair {
            at: at([lambda, w_x, w_y]),
            stated: -lambda,
            found: (last - Scalar::exp(states[0].ln_w_y)) / TAU,
            scale: lambda,
        })
    })
}

/// Second stage, as printed: an exponential falls by the same factor in every period.
pub fn second_stage() -> Evidence {
    let compared = "1 with the fall of ln 𝔴_y in the third period after 𝔴_y has fallen below 1e-3, over that in the second";
    let trial = Trial::by(Route::Integration, Subject::Printed, compared, EXPONENTIAL);
    let mut points = Points::stream(164);
    trial.over(0..24, |_| {
        let lambda = points.uniform(0.15, lambda_c() - 0.03);
        let w_x = points.uniform(-1.0, 1.0);
        let states = strobed(lambda, w_x, 0.5, 12)?;
        let small = states.iter().position(|s| s.ln_w_y < -6.9);
        let small = small.ok_or("v_y stays large")?;
        let fall = |k: usize| match states.get(small + k..small + k + 2) {
            Some([before, after]) => before.ln_w_y - after.ln_w_y,
            _ => f64::NAN,
        };
        Ok::<_, Failure>(Pair {
            at: at([lambda, w_x, 0.5]),
            stated: 1.0,
            found: fall(2) / fall(1),
            scale: 1.0,
        })
    })
}

/// The large-time v_x, from several v_y, is that of a motion on the line.
pub fn ignores_motion() -> Evidence {
    let compared =
        "𝔴 of the large-time motion on the line with 𝔴 of a motion in the plane after 15 periods";
    let trial = Trial::by(Route::Integration, Subject::Printed, compared, FORGOTTEN);
    let mut points = Points::stream(165);
    trial.over(0..24, |_| {
        let lambda = points.uniform(0.3, 1.4);
        let (w_x, w_y) = (points.uniform(-1.0, 1.0), points.log_uniform(0.1, 10.0));
        let phi = 15.0 * TAU + points.uniform(0.0, TAU);
        let start = PlanarState {
            phi: 0.0,
            w_x,
            ln_w_y: Scalar::ln(w_y),
        };
        let states = drive()?.planar(lambda, start, &[phi])?;
        Ok::<_, Failure>(Pair {
            at: format!("{}, φ = {phi:.6}", at([lambda, w_x, w_y])),
            stated: settled(lambda, ORIGIN)?.w(phi),
            found: states[0].w_x,
            scale: 1.0,
        })
    })
}

/// On the way v_x does depend on v_y.
pub fn ignores_census() -> Evidence {
    let compared = "1 with 1 where the first period's 𝔴 differs by more than 0.01 between 𝔴_y = 0.1, 1 and 5 at the start";
    let trial = Trial::by(Route::Census, Subject::Printed, compared, NONE);
    let mut points = Points::stream(166);
    trial.over(0..30, |_| {
        let (lambda, w_x) = (points.uniform(0.15, 1.4), points.uniform(-1.0, 1.0));
        let phases: Vec<_> = (1..=16).map(|k| TAU * f64::from(k) / 16.0).collect();
        let mut curves = Vec::new();
        for w_y in [0.1, 1.0, 5.0] {
            let start = PlanarState {
                phi: 0.0,
                w_x,
                ln_w_y: Scalar::ln(w_y),
            };
            let states = drive()?.planar(lambda, start, &phases)?;
            curves.push(states.iter().map(|s| s.w_x).collect::<Vec<_>>());
        }
        let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).any(|(a, b)| (a - b).abs() > 0.01);
        let differ = apart(&curves[0], &curves[1]) && apart(&curves[1], &curves[2]);
        Ok::<_, Failure>(Pair {
            at: format!("λ₀ = {lambda:.6}, 𝔴 = {w_x:.6} at φ = 0"),
            stated: 1.0,
            found: f64::from(u8::from(differ)),
            scale: 1.0,
        })
    })
}
