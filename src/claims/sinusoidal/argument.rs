//! Trials of the steps of section 2.2 between its formulas.

use super::prelude::*;
use super::reference_motions::{at, dense};

/// Longer than half the period, with a velocity below zero a period after φ₁.
fn outlasts(lambda: f64) -> Result<bool, Failure> {
    let slip = Slip::of(lambda)?;
    let friction = Friction::new(lambda, lambda)?;
    let later = drive()?.advance(friction, ORIGIN, slip.start + TAU)?.end.w;
    Ok(slip.end - slip.start > PI && later < 0.0)
}

/// λ₀ < λ_c and a phase at which the large-time motion is away from its zeros, with its 𝔴 there.
fn away_from_zeros(points: &mut Points) -> Result<[f64; 3], Failure> {
    let lambda = points.uniform(0.1, lambda_c());
    let motion = settled(lambda, ORIGIN)?;
    let slip = motion.intervals().first().ok_or("no interval")?;
    let phi = slip.start + slip.length() * points.uniform(0.25, 0.75);
    Ok([lambda, phi, motion.w(phi)])
}

attempts![
    stays_census = {
        let mut points = Points::here();
        let large = (0..60).map(|_| points.uniform(1.0, 3.0));
        let frictions: Vec<_> = dense().into_iter().step_by(5).chain(large).collect();
        Trial::census(
            Printed,
            [
                r"whether $\lambda_0<1$ (1 if so)",
                "whether the large-time motion along the drive moves",
            ],
        )
        .over(frictions, |lambda| {
            let motion = settled(lambda, ORIGIN)?;
            let [left, right] = printed::eq25_sides(lambda);
            let moves = motion.intervals().iter().any(|i| i.sign != Sign::Rest);
            Ok(Pair::plain(at(lambda), is(left < right), is(moves)))
        })
    },
    stays_motion = Trial::by(
        Integration,
        Printed,
        [
            r"whether $\lambda_0<1$ (1 if so)",
            "whether $v_x$ of a particle on the plane has another value than 0 in its sixth period",
        ],
        NONE,
    )
    .drawn(0..24, |_, points| {
        let lambda = points.uniform(0.25, 1.4);
        let v = [points.uniform(-1.0, 1.0), points.uniform(-1.0, 1.0)];
        let motion = Particle::plain(lambda).run(0.0, v, 6.0 * TAU)?;
        let [left, right] = printed::eq25_sides(lambda);
        let mut moves = false;
        for k in 0..=64 {
            moves |= motion.at(TAU * (5.0 + f64::from(k) / 64.0))?.v[0] != 0.0;
        }
        Ok(Pair::plain(
            format!("{}, v = ({:.6}, {:.6})", at(lambda), v[0], v[1]),
            is(left < right),
            is(moves),
        ))
    }),
    across_rate = {
        let trial = Trial::by(
            Integration,
            Printed,
            [
                r"the relative rate $-\lambda_0/\lvert\mathfrak w\rvert$ of $\mathfrak w_y$ by a friction proportional to $\mathfrak w_y$",
                r"$\mathrm d\ln\mathfrak w_y/\mathrm d\phi$ of the motion, by differences, at $\mathfrak w_y=\mathrm e^{-20}$",
            ],
            ACROSS,
        );
        trial.drawn(0..30, |_, points| {
            let [lambda, phi, w_x] = away_from_zeros(points)?;
            let h = 1e-4;
            let ln_w_y = -20.0;
            let start = PlanarState { phi, w_x, ln_w_y };
            let states = drive()?.planar(lambda, start, &[phi + h, phi + 2.0 * h])?;
            let [one, two] = [0, 1].map(|k: usize| states[k].ln_w_y - ln_w_y);
            let found = (4.0 * one - two) / (2.0 * h);
            Ok(Pair {
                at: format!("{}, φ = {phi:.6}", at(lambda)),
                stated: printed::s22_across_friction(lambda, w_x, 1.0),
                found,
                scale: found.abs(),
            })
        })
    },
    across_proportional = {
        let trial = Trial::by(
            Limit,
            Printed,
            [
                r"the ratio of the friction across the drive at two velocities that are as 100 to 1",
                r"that of what $v_y=10^{-4}$ and $v_y=10^{-6}$ lose in a hundredth of a period away from the zeros of $v_x$",
            ],
            ACROSS,
        );
        trial.drawn(0..30, |_, points| {
            let [lambda, phi, w_x] = away_from_zeros(points)?;
            let lost = |v_y: f64| -> Result<f64, Failure> {
                let motion = Particle::plain(lambda).run(phi, [w_x, v_y], phi + 0.01 * TAU)?;
                Ok(v_y - motion.end().v[1])
            };
            let friction = |w_y| printed::s22_across_friction(lambda, w_x, w_y);
            let found = lost(1e-4)? / lost(1e-6)?;
            Ok(Pair {
                at: format!("{}, φ = {phi:.6}", at(lambda)),
                stated: friction(1e-4) / friction(1e-6),
                found,
                scale: found,
            })
        })
    },
    outlasts_census = {
        let trial = Trial::census(
            Within,
            [
                r"whether $\lambda_0<\lambda_\mathrm c$ (1 if so)",
                r"whether the slip from $\phi_1$ on lasts longer than $\pi$ and $\mathfrak w<0$ a period after $\phi_1$",
            ],
        );
        trial.over(dense().into_iter().step_by(3), |lambda| {
            Ok(Pair::plain(
                at(lambda),
                is(lambda < printed::eq37_lambda_c()),
                is(outlasts(lambda)?),
            ))
        })
    },
    outlasts_outside = {
        let trial = Trial::census(
            Outside,
            Compared::constant(
                "1, as the claim has it",
                r"whether, without friction, $\mathfrak w<0$ (1 if so) one to twenty periods after a start from rest at the phase 0",
            ),
        );
        trial.over(1..=20, |periods| {
            let friction = Friction::new(0.0, 0.0)?;
            let later = f64::from(periods) * TAU;
            let later = drive()?.advance(friction, ORIGIN, later)?.end.w;
            Ok(Pair::plain(
                format!("λ₀ = 0, periods: {periods}"),
                1.0,
                is(later < -1e-12),
            ))
        })
    },
    neither_end = no_inside(
        "a friction",
        r"$\lambda_0=0$ and $\lambda_0=\lambda_\mathrm c$",
        [("λ₀", [0.0, lambda_c()])],
        &[[0.0], [lambda_c()]],
        |[lambda]| lambda > 0.0 && lambda != lambda_c(),
    )
];

#[cfg(test)]
mod tests {
    use super::super::reference_motions::small;
    use super::*;

    #[test]
    fn a_slip_outlasts_half_the_period_below_the_border() {
        let c = lambda_c();
        assert_eq!(
            [c - 1e-3, c + 1e-3].map(|l| outlasts(l).unwrap()),
            [true, false]
        );
        assert!(small().into_iter().all(|l| outlasts(l).unwrap()));
    }
}
