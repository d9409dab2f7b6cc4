//! Trials of the mirror: φ → φ + π, 𝔴 → −𝔴 turns the friction (λ₀, q) into (qλ₀, 1/q).

use super::simulated::{Curves, START, attractor_from, drive, order};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::points::Points;
use crate::claims::tolerances::{MOTION, NONE};
use crate::corrections::anisotropic as corrected;
use crate::evidence::{Evidence, Route, Subject};
use crate::motion::drive::{Friction, State};
use crate::paper::anisotropic as printed;
use std::f64::consts::PI;

/// (q, λ₀) with q < 1, and so that the mirrored λ₀ lies between 0 and 1.4.
fn small_ratio(points: &mut Points) -> (f64, f64) {
    let q = points.log_uniform(1.0 / 12.0, 1.0);
    (q, points.uniform(0.0, 1.4) / q)
}

/// A motion with q < 1 from any start, and its mirror image with 1/q, some time later.
pub fn integration() -> Evidence {
    let compared = "−𝔴(φ + π) of the motion with 1/q and qλ₀ from the mirrored start with 𝔴(φ) of the motion with q < 1 and λ₀";
    let trial = Trial::by(Route::Integration, Subject::Printed, compared, MOTION);
    let mut points = Points::stream(312);
    trial.over(0..400, |_| {
        let (q, lambda0) = small_ratio(&mut points);
        let start = State {
            phi: points.uniform(0.0, 6.0),
            w: points.uniform(-2.0, 2.0),
        };
        let after = points.uniform(0.0, 20.0);
        let mirrored = State {
            phi: start.phi + PI,
            w: -start.w,
        };
        let end = |friction: Friction, start: State| -> Result<f64, Failure> {
            Ok(drive()?.advance(friction, start, start.phi + after)?.end.w)
        };
        let found = end(Friction::new(lambda0, q * lambda0)?, start)?;
        let (other_q, other_lambda0) = (1.0 / q, q * lambda0);
        let friction = Friction::new(other_lambda0, other_q * other_lambda0)?;
        Ok(Pair {
            at: format!(
                "q = {q:.6}, λ₀ = {lambda0:.6}, φ = {:.6} from {:.6}, {:.6}",
                start.phi + after,
                start.phi,
                start.w
            ),
            stated: -end(friction, mirrored)?,
            found,
            scale: 1.0 + (1.0 + lambda0) * after,
        })
    })
}

/// The order of the intervals with q < 1, forward and backward exchanged, in the region list at (1/q, qλ₀).
pub fn census() -> Evidence {
    let compared = "the corrected list's region, 1 to 5, at (1/q, qλ₀) with the order of the simulated intervals at (q, λ₀), forward and backward exchanged";
    let trial = Trial::by(Route::Census, Subject::Printed, compared, NONE);
    let mut points = Points::stream(313);
    trial.over(0..2000, |_| {
        let (q, lambda0) = small_ratio(&mut points);
        let curves = Curves::at(1.0 / q)?;
        let region = corrected::region(q * lambda0, &curves.corrected);
        let motion = attractor_from(START, Friction::new(lambda0, q * lambda0)?)?;
        let found = exchanged(&order(motion.intervals()));
        let found = printed::ORDERS.iter().position(|listed| {
            // Where in the period the list begins is left open.
            listed.len() == found.len() && found.repeat(2).contains(listed)
        });
        Ok(Pair {
            at: format!("q = {q:.6}, λ₀ = {lambda0:.6}"),
            stated: region.map_or(0.0, |k| k as f64),
            found: found.map_or(0.0, |i| (i + 1) as f64),
            scale: 1.0,
        })
    })
}

/// An order of intervals seen in the mirror.
fn exchanged(order: &str) -> String {
    let other = |letter| match letter {
        '+' => '-',
        '-' => '+',
        rest => rest,
    };
    order.chars().map(other).collect()
}
