//! Trials of what is said of very large friction: λ₀ > max |h| = 1.
//!
//! While w > 0, w' = h − λ₀ ≤ 1 − λ₀, and likewise for w < 0: |w| is used up within |w₀|/(λ₀ − 1).

use super::drives::{named, phase};
use super::prelude::*;
use crate::motion::drive::Interval;
use crate::paper::general;
use trialbook::trials::points::round;

fn at(name: &str, lambda: f64, start: DriveState) -> String {
    let DriveState { phi, w } = start;
    format!("{name}: λ₀ = {lambda:.6}, φ₀ = {phi:.6}, 𝔴₀ = {w:.6}")
}

fn within_time() -> Evidence {
    let trial = Trial::by(
        Integration,
        Printed,
        Compared::constant(
            r"1 for $\lambda_0>1$ and 0 below",
            r"whether the motion, from any start, is at rest (1 if so) from a millionth past the phase $\lvert\mathfrak w_0\rvert/(\lambda_0-1)$ on, or for $\lambda_0<1$ from a period on,",
        ),
        NONE,
    );
    let mut points = Points::here();
    let drives = named();
    trial.over(0..1000, |i| {
        let drives = drives.as_ref().map_err(Clone::clone)?;
        let one = &drives[i % drives.len()];
        // In later rounds of a deep run each point has a drive of its own.
        let (name, drive) = match round() {
            0 => (one.name, &one.drive),
            _ => ("three harmonics", &Harmonics::random(&mut points)?.drive()?),
        };
        let excess = points.log_uniform(1e-3, 1e2);
        let lambda = if i % 5 == 4 {
            1.0 / (1.0 + excess)
        } else {
            1.0 + excess
        };
        let w = points.sign() * points.log_uniform(1e-6, 90.0);
        let phi = points.uniform(0.0, TAU);
        let start = DriveState { phi, w };
        let both = Friction::new(lambda, lambda)?;
        let longest = match lambda {
            small if small < 1.0 => TAU,
            large => w.abs() / (large - 1.0) * (1.0 + 1e-6),
        };
        let until = phi + longest;
        let end = drive.advance(both, start, until)?.end;
        let later = drive.advance(both, end, until + 2.0 * TAU)?;
        Ok(Pair::plain(
            at(name, lambda, start),
            stated_rest(lambda),
            is(left(end.w, &later.intervals) == 0.0),
        ))
    })
}

/// 1 where the claim lets nothing move in the end; at λ₀ = 1 itself nothing does either.
fn stated_rest(lambda: f64) -> f64 {
    let [left, right] = printed::s23_rest_sides(lambda);
    is(left <= right)
}

/// |𝔴|, and how long it moves later.
fn left(w: f64, later: &[Interval]) -> f64 {
    let moving = later.iter().filter(|i| i.sign != Sign::Rest);
    w.abs() + moving.map(|i| i.length()).sum::<f64>()
}

pub(super) fn stopping_time() -> Evidence {
    let trial = Trial::by(
        Root,
        Printed,
        [
            r"the root of $\lvert\mathfrak w_0\rvert+\int(1)\,\mathrm d\phi$, taken along the velocity,",
            "the phase at which the motion comes to rest",
        ],
        ROOT,
    );
    trial.drawn(0..60, |_, points| {
        let shape = Harmonics::random(points)?;
        let lambda = 1.0 + points.log_uniform(0.05, 10.0);
        let (phi, w) = (
            points.uniform(0.0, TAU),
            points.sign() * points.log_uniform(1e-2, 3.0),
        );
        let start = DriveState { phi, w };
        let longest = w.abs() / (lambda - 1.0);
        let path =
            shape
                .drive()?
                .advance(Friction::new(lambda, lambda)?, start, phi + longest + 1.0)?;
        let stop = path.intervals.iter().find(|i| i.sign == Sign::Rest);
        // Along the velocity, by (1), in units in which the drive is h.
        let force = |x: f64| {
            let rate = general::eq1_velocity_rate([-shape.h(x), 0.0], lambda, 1.0, [w, 0.0]);
            w.signum() * rate[0]
        };
        let size = |x: f64| match integral_within(force, phi, x, 1e-14) {
            Ok(gain) => w.abs() + gain.value,
            Err(_) => f64::NAN,
        };
        Ok(Pair::plain(
            at("three harmonics", lambda, start),
            root(size, phi, phi + longest).unwrap_or(f64::NAN),
            stop.map_or(f64::NAN, |i| i.start),
        ))
    })
}

attempts![
    within_time,
    stopping_time,
    sharp = {
        let drives = named();
        let excess = [1e-3, -1e-3, 0.0, 1e-9, -1e-6, 1e-6, -0.1, 0.1, 9.0, -1e-5];
        let excess = Points::here().grid(excess);
        Trial::census(
            Printed,
            Compared::constant(
                r"1 for $\lambda_0\ge1$ and 0 below",
                "whether the motion is at rest for ever (1 if so)",
            ),
        )
        .over(
            (0..10).flat_map(|k| excess.iter().map(move |e| (k, *e))),
            |(k, excess)| {
                let drives = drives.as_ref().map_err(Clone::clone)?;
                let one = &drives[k % drives.len()];
                let still = phase(&one.drive, 1.0 + excess)? == Phase::Still;
                Ok(Pair::plain(
                    format!("{}: λ₀ − 1 = {excess:e}", one.name),
                    stated_rest(1.0 + excess),
                    is(still),
                ))
            },
        )
    }
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speed_and_later_motion_are_left() {
        let interval = |sign, start, end| Interval { sign, start, end };
        let later = [
            interval(Sign::Positive, 0.0, 3.0),
            interval(Sign::Rest, 3.0, 10.0),
            interval(Sign::Negative, 10.0, 11.5),
        ];
        assert_eq!(left(-2.0, &later), 6.5);
        assert_eq!(left(0.0, &later[1..2]), 0.0);
    }
}
