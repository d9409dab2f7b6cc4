//! Trials of the mirror: φ → φ + π, 𝔴 → −𝔴 turns the friction (λ₀, q) into (qλ₀, 1/q).

use super::prelude::*;
use super::simulated::{drive, from_forward};

/// (q, λ₀) with q < 1, and so that the mirrored λ₀ lies between 0 and 1.4.
fn small_ratio(points: &mut Points) -> (f64, f64) {
    let q = points.log_uniform(1.0 / 12.0, 1.0);
    (q, points.uniform(0.0, 1.4) / q)
}

pub(super) fn integration() -> Evidence {
    let trial = Trial::motion(
        Printed,
        [
            r"$-\mathfrak w(\phi+\pi)$ of the motion with $1/q$ and $q\lambda_0$ from the mirrored start",
            r"$\mathfrak w(\phi)$ of the motion with $q<1$ and $\lambda_0$",
        ],
    );
    trial.drawn(0..400, |i, points| {
        let (q, lambda0) = small_ratio(points);
        let lambda0 = match i % 20 {
            7 => 5e-4,
            8 => 1.0 - 5e-4,
            9 => 1.0 + 5e-4,
            _ => lambda0,
        };
        let start = DriveState {
            phi: points.uniform(0.0, 6.0),
            w: points.uniform(-2.0, 2.0),
        };
        let after = points.uniform(0.0, 20.0);
        let mirrored = DriveState {
            phi: start.phi + PI,
            w: -start.w,
        };
        let end = |friction: Friction, start: DriveState| -> Result<f64, Failure> {
            Ok(drive()?.advance(friction, start, start.phi + after)?.end.w)
        };
        let found = end(Friction::new(lambda0, q * lambda0)?, start)?;
        let [other_q, other_lambda0] = printed::s24_mirrored(q, lambda0);
        let other = || {
            end(
                Friction::new(other_lambda0, other_q * other_lambda0)?,
                mirrored,
            )
        };
        Ok(Pair {
            at: format!(
                "q = {q:.6}, λ₀ = {lambda0:.6}, φ = {:.6} from {:.6}, {:.6}",
                start.phi + after,
                start.phi,
                start.w
            ),
            // No motion has a friction below zero.
            stated: -other().unwrap_or(f64::NAN),
            found,
            scale: 1.0 + (1.0 + lambda0) * after,
        })
    })
}

pub(super) fn census() -> Evidence {
    let trial = Trial::census(
        Printed,
        [
            r"the order of slips and rests in a period by the corrected list at $(1/q,q\lambda_0)$ (3 for a forward slip, 2 for a rest, 1 for a backward slip)",
            r"that of the simulated motion at $(q,\lambda_0)$, forward and backward exchanged",
        ],
    );
    let mut points = Points::here();
    let words = listed_digits();
    trial.over(0..2000, |_| {
        let (q, lambda0) = small_ratio(&mut points);
        let [other_q, other_lambda0] = printed::s24_mirrored(q, lambda0);
        let region = corrected_list(other_q)(other_lambda0);
        let motion = attractor_from(START, Friction::new(lambda0, q * lambda0)?)?;
        let exchanged = motion
            .intervals()
            .iter()
            .map(|i| -i.sign.factor())
            .collect();
        Ok(Pair::plain(
            format!("q = {q:.6}, λ₀ = {lambda0:.6}"),
            region.map_or(f64::NAN, |k| words[k - 1]),
            from_forward(exchanged),
        ))
    })
}

attempts![integration, census];
