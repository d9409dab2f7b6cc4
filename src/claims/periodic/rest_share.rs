//! Trials of how long a particle is at rest in a period when friction is slightly below the largest drive.

use super::drives::{motion, rest_share, steps_between};
use super::prelude::*;

/// At λ₀ = 1 − δ.
fn share(drive: &Drive, delta: f64) -> Result<f64, Failure> {
    let motion = motion(drive, 1.0 - delta)?.ok_or("it drifts")?;
    Ok(rest_share(&motion))
}

/// λ₀ → 1: the motion that is left lasts as √δ, and then as powers of it.
pub(super) fn limit() -> Evidence {
    Trial::by(
        Limit,
        Printed,
        Compared::one(
            "the whole period, 1,",
            r"the limit of the share of a period that is rest, as $\lambda_0\to1$",
        )
        .over("three harmonics at random"),
        SHARE,
    )
    .drawn(0..30, |i, points| {
        let drive = Harmonics::random(points)?.drive()?;
        let delta = 1e-8;
        let [far, near] = [share(&drive, 4.0 * delta)?, share(&drive, delta)?];
        Ok(Pair::plain(
            format!("drive {i}"),
            printed::s23_late_share(),
            2.0 * near - far,
        ))
    })
}

pub(super) fn census() -> Evidence {
    let trial = Trial::census(Printed, Compared::one(
        r"whether the share of rest is more than half of the period, as stated for $\lambda_0\to1$ (1 if so),",
        r"whether it is at $\lambda_0$ between $1-10^{-3}$ and 1",
    )
    .over("three harmonics at random"));
    let mut points = Points::here();
    trial.over(0..60, |i| {
        let drive = Harmonics::random(&mut points)?.drive()?;
        let delta = points.log_uniform(1e-9, 1e-3);
        let most = |share: f64| is(share > 0.5);
        Ok(Pair::plain(
            format!("drive {i}, λ₀ = 1 − {delta:.3e}"),
            most(printed::s23_late_share()),
            most(share(&drive, delta)?),
        ))
    })
}

pub(super) fn two_valued() -> Evidence {
    Trial::census(
        Remark,
        Compared::constant(
            "the expected 0",
            r"the share of rest for steps between 1 and $-1$ with $\lambda_0$ just below 1",
        ),
    )
    .drawn(0..24, |_, points| {
        let (x, y) = (points.uniform(0.2, 2.9), points.uniform(0.2, 2.9));
        let drive = steps_between(x, y)?;
        let delta = points.log_uniform(1e-6, 1e-1);
        Ok(Pair::plain(
            format!("steps at {x:.6} and {y:.6}, λ₀ = 1 − {delta:.3e}"),
            0.0,
            share(&drive, delta)?.abs(),
        ))
    })
}

attempts![limit, census, two_valued];
