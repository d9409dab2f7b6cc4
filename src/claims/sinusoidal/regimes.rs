//! Trials of what section 2.2 says in words of the motion along the line.

use super::prelude::*;
use super::reference_motions::{at, dense, small, starts};

/// At large times, of all starts together.
fn all_rests(lambda: f64) -> Result<usize, Failure> {
    let mut rests = 0;
    for start in starts() {
        let attractor = settled(lambda, start)?;
        let list = attractor.intervals().iter();
        rests += list.filter(|i| i.sign == Sign::Rest).count();
    }
    Ok(rests)
}

/// A kind of large-time motion as a number: zeros in a period, ten times the rests, or −1 for rest throughout.
pub(crate) fn kind(zeros: usize, rests: usize, still: bool) -> f64 {
    if still {
        -1.0
    } else {
        (zeros + 10 * rests) as f64
    }
}

fn stated_kind(lambda: f64) -> f64 {
    let [left, right] = printed::eq25_sides(lambda);
    if lambda < printed::eq37_lambda_c() {
        kind(2, 0, false)
    } else if left < right {
        kind(0, 2, false)
    } else {
        kind(0, 0, true)
    }
}

pub(crate) fn listed_kind(list: &[Interval]) -> f64 {
    let rests = list.iter().filter(|i| i.sign == Sign::Rest).count();
    let pairs = list.iter().zip(list.iter().cycle().skip(1));
    let turns = pairs.filter(|(a, b)| a.sign.factor() * b.sign.factor() < 0.0);
    kind(turns.count(), rests, list.len() == 1 && rests == 1)
}

/// From 0 to 5, the two thresholds approached to 1e-9 from both sides.
fn frictions() -> Vec<f64> {
    let mut points = Points::here();
    let mut list = dense();
    list.extend((0..200).map(|_| points.uniform(1.0, 5.0)));
    list.extend((0..30).map(|i| 1.0 + libm::pow(10.0, -3.0 - 0.2 * f64::from(i))));
    list
}

pub(crate) fn trichotomy_census() -> Evidence {
    let trial = Trial::census(
        Within,
        [
            r"the number of zeros plus ten times that of rests in a period (2 below $\lambda_\mathrm c$, 20 above, $-1$ for rest throughout above 1)",
            "the same of the simulated list of intervals",
        ],
    );
    trial.over(
        frictions().into_iter().zip(starts().into_iter().cycle()),
        |(lambda, start)| {
            let attractor = settled(lambda, start)?;
            Ok(Pair::plain(
                at(lambda),
                stated_kind(lambda),
                listed_kind(attractor.intervals()),
            ))
        },
    )
}

/// By the other integrator.
pub(crate) fn trichotomy_motion() -> Evidence {
    let trial = Trial::by(
        Integration,
        Within,
        [
            r"the number of zeros plus ten times that of rests in a period (2 below $\lambda_\mathrm c$, 20 above, $-1$ for rest throughout above 1)",
            "that of a particle on the plane, over its third period",
        ],
        NONE,
    );
    trial.drawn(0..20, |_, points| {
        let lambda = points.uniform(0.1, 1.5);
        let start = points.uniform(0.0, TAU);
        let (from, to) = (start + 2.0 * TAU, start + 3.0 * TAU);
        let motion = Particle::plain(lambda).run(start, [0.0; 2], to)?;
        let within = |t: f64| t > from && t <= to;
        let stops = motion.stops().iter().filter(|t| within(**t)).count();
        let phases = motion.phases().iter();
        let rests = phases.filter(|p| p.kind == PhaseKind::Stick);
        let begun = rests.filter(|p| within(p.from)).count();
        let still = stops == 0 && motion.end().speed() == 0.0;
        Ok(Pair::plain(
            format!("λ₀ = {lambda:.6}, from φ = {start:.6}"),
            stated_kind(lambda),
            kind(stops.saturating_sub(begun), begun, still),
        ))
    })
}

pub(crate) fn trichotomy_outside() -> Evidence {
    let trial = Trial::census(
        Outside,
        Compared::constant(
            "the stated 2",
            r"the number of zeros in a period without friction, of starts with $\mathfrak w>0$ at $\phi=0$,",
        ),
    );
    trial.drawn(0..24, |_, points| {
        let w = points.uniform(0.1, 3.0);
        let attractor = settled(0.0, DriveState { phi: 0.0, w })?;
        Ok(Pair::plain(
            format!("λ₀ = 0, 𝔴 = {w:.6} at φ = 0"),
            stated_kind(0.0),
            listed_kind(attractor.intervals()),
        ))
    })
}

/// 1 where (25) does not hold, so that nothing moves at large times.
fn stated_still(lambda: f64) -> f64 {
    let [left, right] = printed::eq25_sides(lambda);
    is(left >= right)
}

/// All over the fourth period after a phase.
fn fourth_period(from: f64) -> impl Iterator<Item = f64> {
    (0..=32).map(move |k| from + TAU * (3.0 + f64::from(k) / 32.0))
}

/// At large times, from every start.
fn all_still(lambda: f64) -> Result<bool, Failure> {
    let mut still = true;
    for start in starts() {
        still &= listed_kind(settled(lambda, start)?.intervals()) == kind(0, 0, true);
    }
    Ok(still)
}

attempts![
    weak_drive_motion = {
        let trial = Trial::by(
            Integration,
            Printed,
            [
                "whether (25) fails (1 if so)",
                "whether a particle, launched in any direction, is at rest over the last period of four",
            ],
            NONE,
        );
        trial.drawn(0..30, |i, points| {
            let range = if i % 3 == 0 { [0.1, 0.95] } else { [1.05, 4.0] };
            let lambda = points.uniform(range[0], range[1]);
            let v = [points.uniform(-1.0, 1.0), points.uniform(-1.0, 1.0)];
            let from = points.uniform(0.0, TAU);
            let motion = Particle::plain(lambda).run(from, v, from + 4.0 * TAU)?;
            let mut largest = 0.0_f64;
            for phi in fourth_period(from) {
                largest = largest.max(motion.at(phi)?.speed());
            }
            Ok(Pair::plain(
                format!("λ₀ = {lambda:.6}, v_x = {:.6}, v_y = {:.6}", v[0], v[1]),
                stated_still(lambda),
                is(largest == 0.0),
            ))
        })
    },
    weak_drive_census = {
        let frictions = frictions().into_iter().enumerate();
        let some = frictions.filter(|(i, lambda)| *lambda > 1.0 || i % 20 == 0);
        Trial::census(
            Printed,
            [
                "whether (25) fails (1 if so)",
                "whether the simulated large-time motion is rest throughout, from seven starts",
            ],
        )
        .over(some, |(_, lambda)| {
            Ok(Pair::plain(
                at(lambda),
                stated_still(lambda),
                is(all_still(lambda)?),
            ))
        })
    },
    no_rest_motion = {
        let trial = Trial::by(
            Integration,
            Printed,
            [
                r"$-2\lambda_0(\tilde\phi_2-\phi_1-\pi)$, with the root $\tilde\phi_2$ of (32),",
                r"$\mathfrak w$ a period after a rest has ended at $\phi_1$, where it has to be negative",
            ],
            ROOT,
        );
        trial.over(small(), |lambda| {
            let (phi1, end) = (printed::eq27_phi1(lambda), phi_t2(lambda));
            let friction = Friction::new(lambda, lambda)?;
            let slip = Slip::of(lambda)?;
            let w = drive()?.advance(friction, ORIGIN, slip.start + TAU)?.end.w;
            Ok(Pair {
                at: at(lambda),
                stated: -2.0 * lambda * (end - phi1 - PI),
                found: if w < 0.0 { w } else { f64::NAN },
                scale: 10.0 + lambda * end_spread(lambda, slip.end),
            })
        })
    },
    no_rest_census = Trial::census(
        Printed,
        Compared::constant(
            r"1 for $\lambda_0<\lambda_\mathrm c$ and 0 above",
            "whether the simulated motions from seven starts have no rest at large times (1 if so)",
        ),
    )
    .over(dense().into_iter().step_by(4), |lambda| {
        Ok(Pair::plain(
            at(lambda),
            is(lambda < printed::eq37_lambda_c()),
            is(all_rests(lambda)? == 0),
        ))
    }),
    trichotomy_census,
    trichotomy_motion,
    trichotomy_outside
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Between λ_c and 1 each of the seven rests twice a period, above 1 all the time.
    #[test]
    fn the_rests_of_all_starts_are_counted() {
        assert_eq!([0.3, 0.8, 1.5].map(|l| all_rests(l).unwrap()), [0, 14, 7]);
        assert_eq!(
            [0.3, 0.8, 1.5].map(|l| all_still(l).unwrap()),
            [false, false, true]
        );
    }

    #[test]
    fn the_fourth_period_is_looked_at_from_end_to_end() {
        let phases: Vec<_> = fourth_period(1.0).collect();
        assert_eq!((phases[0], phases[32]), (1.0 + 3.0 * TAU, 1.0 + 4.0 * TAU));
        for pair in phases.windows(2) {
            assert!((pair[1] - pair[0] - TAU / 32.0).abs() < 1e-14);
        }
    }
}
