//! Trials of (31), (32), (34), (35): one slip after a rest, and where it ends.

use super::prelude::*;
use super::reference_motions::{all, at, dense, small};

/// At how many of 1000 places between these two it is not positive.
fn not_positive(from: f64, to: f64, left: impl Fn(f64) -> f64) -> usize {
    let place = |k: i32| from + (to - from) * f64::from(k) / 1001.0;
    (1..=1000).filter(|k| left(place(*k)) <= 0.0).count()
}

fn bracket_limit() -> Evidence {
    let trial = Trial::by(
        Limit,
        Printed,
        [
            r"the gap between $\tilde\phi_2$ of the simulated slip and (30) or (28), over $\sqrt{4\pi\lambda_0}$ for $\lambda_0\to0$ and over $\sqrt{2(1-\lambda_0)}$ for $\lambda_0\to1$,",
            "1",
        ],
        EDGE,
    );
    let exponents = (0..15).map(|i| -9.0 - 0.1 * f64::from(i));
    let exponents = Points::here().grid(exponents).into_iter();
    let cases = exponents.flat_map(|exponent| [true, false].map(|near_0| (exponent, near_0)));
    trial.over(cases, |(exponent, near_0)| {
        let small = libm::pow(10.0, exponent);
        let (lambda, leading, gap) = if near_0 {
            let gap = printed::eq30_phi4(small) - Slip::of(small)?.end;
            (small, libm::sqrt(4.0 * PI * small), gap)
        } else {
            let lambda = 1.0 - small;
            // As rounded, the distance from 1 is another one.
            let leading = libm::sqrt(2.0 * (1.0 - lambda));
            let gap = Slip::of(lambda)?.end - printed::eq28_phi2(lambda);
            (lambda, leading, gap)
        };
        Ok(Pair::plain(
            format!("λ₀ = {lambda:.12}"),
            gap / leading,
            1.0,
        ))
    })
}

/// What is left of 𝔴 when the drive could start the next slip.
fn left_with_motion(law: &'static str, left: fn(Double) -> Double) -> Evidence {
    const LEFT: &str = r"$\mathfrak w$ at the simulated $\phi_3$ of a slip from rest";
    let compared = Compared::composed(["the left side of ", law, ""], [LEFT, "", ""]);
    Trial::motion(Printed, compared.over(r"$\lambda_0<\lambda_\mathrm c$")).over(
        small(),
        |lambda| {
            let friction = Friction::new(lambda, lambda)?;
            let state = |phi| DriveState { phi, ..ORIGIN };
            let release = drive()?.advance(friction, state(PI), PI + 2.0)?;
            let phi3 = release.intervals.first().ok_or("no interval")?.end;
            let found = drive()?.advance(friction, ORIGIN, phi3)?.end.w;
            let stated = left(Double::from(lambda));
            Ok(Pair::wide(at(lambda), stated, found).within(1.0))
        },
    )
}

pub(super) fn eq34<S: Scalar>(lambda: S) -> S {
    printed::eq34_left(
        lambda,
        printed::eq27_phi1(lambda),
        printed::eq29_phi3(lambda),
    )
}

fn ends_early(law: &'static str, inequality: fn(f64) -> bool) -> Evidence {
    const EARLY: &str = "whether the simulated slip lasts less than half a period";
    let holds = ["whether ", law, " holds (1 if so)"];
    let compared = Compared::composed(holds, [EARLY, "", ""]);
    Trial::census(Printed, compared).over(dense(), |lambda| {
        let slip = Slip::of(lambda)?;
        // The backward slip could begin half a period after the forward one did.
        Ok(Pair::plain(
            at(lambda),
            is(inequality(lambda)),
            is(slip.end < slip.start + PI),
        ))
    })
}

attempts![
    eq31_motion = Trial::motion(
        Printed,
        [
            "(31)",
            r"$\mathfrak w$ of the motion that rests until $\phi_1$, at 40 phases of the slip",
        ],
    )
    .pairs(all(), |lambda| {
        let slip = Slip::of(lambda)?;
        let friction = Friction::new(lambda, lambda)?;
        let mut pairs = Vec::new();
        for k in 1..=40 {
            let phi = slip.start + (slip.end - slip.start) * f64::from(k) / 41.0;
            let found = drive()?.advance(friction, ORIGIN, phi)?.end.w;
            let [l, phi_n] = [lambda, phi].map(Double::from);
            let stated = printed::eq31_w(l, printed::eq27_phi1(l), phi_n);
            let at = format!("λ₀ = {lambda:.6}, φ = {phi:.6}");
            pairs.push(Pair::wide(at, stated, found).within(2.0 + lambda * phi));
        }
        Ok(pairs)
    }),
    eq32_root = Trial::by(
        Root,
        Printed,
        [
            r"the root of (32) between $\phi_2$ and $\phi_4$",
            "the end of the simulated slip",
        ],
        ROOT,
    )
    .over(all(), |lambda| {
        let found = Slip::of(lambda)?.end;
        Ok(Pair {
            at: at(lambda),
            stated: phi_t2(lambda),
            found,
            scale: found + end_spread(lambda, found),
        })
    }),
    eq32_motion = {
        let trial = Trial::motion(
            Printed,
            ["(32) at the end of a slip of a particle from rest", "0"],
        );
        // Every eighth of the random frictions, and all that lie at the ends and at λ_c.
        let frictions = all().into_iter().enumerate();
        let some = frictions
            .filter(|(i, _)| i % 8 == 0 || *i >= 200)
            .map(|(_, lambda)| lambda);
        trial.over(some, |lambda| {
            let motion = Particle::plain(lambda).run(0.0, [0.0; 2], 2.0 * PI)?;
            let end = motion.first_stop().ok_or("no stop")?;
            let [l, phi] = [lambda, end].map(Double::from);
            let stated = printed::eq32_left(l, printed::eq27_phi1(l), phi);
            Ok(Pair::wide(at(lambda), stated, 0.0).within(2.0 + lambda * end))
        })
    },
    eq32_census = {
        let trial = Trial::census(
            Printed,
            [
                "the number of phases, of 1000 between the ends of the simulated slip, at which (32) is not positive",
                "0",
            ],
        );
        let frictions = all().into_iter().filter(|l| (1e-3..=0.999).contains(l));
        trial.over(frictions, |lambda| {
            let slip = Slip::of(lambda)?;
            let phi1 = printed::eq27_phi1(lambda);
            let left = |phi: f64| printed::eq32_left(lambda, phi1, phi);
            Ok(Pair::plain(
                at(lambda),
                not_positive(slip.start, slip.end, left) as f64,
                0.0,
            ))
        })
    },
    eq34_motion = left_with_motion("(34)", eq34),
    eq34_census = ends_early("(34)", |lambda| eq34(lambda) < 0.0),
    eq35_motion = left_with_motion("(35)", printed::eq35_left),
    eq35_census = ends_early("(35)", |lambda| printed::eq35_left(lambda) < 0.0),
    eq36_census = ends_early("(36)", |lambda| {
        let [left, right] = printed::eq36_sides(lambda);
        left > right
    }),
    bracket_census = Trial::census(
        Printed,
        [
            "whether (28) and (30) hold the end of the simulated slip between them (1 if so)",
            "1",
        ],
    )
    .over(dense(), |lambda| {
        let (low, high) = (printed::eq28_phi2(lambda), printed::eq30_phi4(lambda));
        let end = Slip::of(lambda)?.end;
        Ok(Pair::plain(at(lambda), is(low < end && end < high), 1.0))
    }),
    bracket_limit
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_at_which_it_is_not_positive() {
        // At 3, 4, …, 1002.
        assert_eq!(not_positive(2.0, 1003.0, |x| 502.5 - x), 500);
        assert_eq!(not_positive(2.0, 1003.0, |x| x - 2.5), 0);
        assert_eq!(not_positive(2.0, 1003.0, |x| x - 3.5), 1);
        assert_eq!(not_positive(2.0, 1003.0, |x| 1002.5 - x), 0);
    }
}
