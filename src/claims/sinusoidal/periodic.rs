//! Trials of (33), (38), (39): the two periodic motions, over whole periods.

use super::prelude::*;
use super::reference_motions::{eq33, eq38, large, small, starts};
use crate::numerics::eigenvalues::{eigenvalues, jacobian};

const PHASES: u32 = 256;

fn at(lambda: f64, phi: f64) -> String {
    format!("λ₀ = {lambda:.6}, φ = {phi:.6}")
}

fn phases(from: f64) -> impl Iterator<Item = f64> {
    let place = |k: u32| f64::from(101 * k % PHASES) + 0.5;
    (1..=PHASES).map(move |k| from + TAU * place(k) / f64::from(PHASES))
}

fn over_a_period(
    lambda: f64,
    attractor: &Attractor,
    from: f64,
    form: impl Fn(f64) -> Double,
) -> Vec<Pair> {
    let pair = |phi: f64| {
        // Where the contraction is weak, the end of a period says little about its periodic state.
        let scale = 1.0 / (1.0 - attractor.contraction()).max(f64::MIN_POSITIVE);
        Pair::wide(at(lambda, phi), form(phi), attractor.w(phi)).within(scale)
    };
    phases(from).map(pair).collect()
}

fn one_motion(frictions: Vec<f64>, subject: Subject) -> Evidence {
    Trial::census(
        subject,
        Compared::constant(
            "the expected 1",
            "whether seven starts, near and far, end in the same motion (1 if so)",
        ),
    )
    .over(frictions, |lambda| {
        let friction = Friction::new(lambda, lambda)?;
        let agreement = drive()?.attractors_agree(friction, &starts(), 200)?;
        Ok(Pair::plain(
            format!("λ₀ = {lambda:.6}"),
            1.0,
            is(agreement.agree),
        ))
    })
}

/// Periods after which the motion has to be near the periodic one: twice what the least friction tried takes.
const PERIODS: u32 = 320;

fn eq38_approach() -> Evidence {
    let trial = Trial::by(
        Limit,
        Within,
        [
            r"$[(d-\lambda_0)/(d+\lambda_0)]^2$, with $d=\sin\tilde\phi_1$,",
            "the factor by which a simulated motion's distance to the periodic one shrinks in a period",
        ],
        APPROACH,
    );
    let frictions = small().into_iter().filter(|l| (0.02..0.5).contains(l));
    trial.over(frictions, |lambda| {
        let attractor = settled(lambda, ORIGIN)?;
        let phi = interval(&attractor, Sign::Positive)?.start + 1.0;
        let limit = attractor.w(phi);
        let mut w = limit + 0.3;
        let friction = Friction::new(lambda, lambda)?;
        for _ in 0..PERIODS {
            let values = drive()?.strobe(friction, DriveState { phi, w }, 1)?;
            let ratio = (values[1] - limit) / (w - limit);
            w = values[1];
            // The distance is small, but far above rounding.
            if w - limit <= 1e-6 {
                return Ok(Pair::plain(
                    at(lambda, phi),
                    corrected::contraction(lambda),
                    ratio,
                ));
            }
        }
        Err("the motion does not come near to the periodic one".into())
    })
}

fn interval(attractor: &Attractor, sign: Sign) -> Result<Interval, Failure> {
    let found = attractor.intervals().iter().find(|i| i.sign == sign);
    Ok(*found.ok_or("no such interval")?)
}

fn rest_interval_reached() -> Evidence {
    let trial = Trial::motion(
        Printed,
        [
            "(33)",
            r"$\mathfrak w$ at 40 phases of the period that follows the first rest on the way from any start",
        ],
    );
    let mut points = Points::here();
    trial.pairs(large(), |lambda| {
        let start = DriveState {
            phi: points.uniform(0.0, TAU),
            w: points.uniform(-6.0, 6.0),
        };
        let friction = Friction::new(lambda, lambda)?;
        let path = drive()?.advance(friction, start, start.phi + 40.0)?;
        let first = path.intervals.iter().find(|i| i.sign == Sign::Rest);
        let from = first.ok_or("no rest")?.end;
        let (end, phi1) = (phi_t2(lambda), printed::eq27_phi1(lambda));
        let mut pairs = Vec::new();
        for k in 1..=40 {
            let phi = from + TAU * f64::from(k) / 40.5;
            let w = drive()?.advance(friction, start, phi)?.end.w;
            let stated = eq33(lambda, end, phi1 + (phi - phi1).rem_euclid(TAU));
            pairs.push(Pair::wide(at(lambda, phi), stated, w).within(1.0));
        }
        Ok(pairs)
    })
}

attempts![
    eq33_motion = Trial::motion(
        Printed,
        [
            r"(33), with $\tilde\phi_2$ by (32),",
            "the simulated large-time motion at 256 phases of the period",
        ],
    )
    .pairs(
        large().into_iter().zip(starts().into_iter().cycle()),
        |(lambda, start)| {
            let attractor = settled(lambda, start)?;
            let end = phi_t2(lambda);
            let from = Slip::of(lambda)?.start;
            let form = |phi| eq33(lambda, end, phi);
            Ok(over_a_period(lambda, &attractor, from, form))
        },
    ),
    eq33_unique = one_motion(large(), Printed),
    eq38_motion = Trial::motion(
        Within,
        [
            "(38) with (39)",
            "the simulated large-time motion at 256 phases of the period",
        ],
    )
    .pairs(
        small().into_iter().zip(starts().into_iter().cycle()),
        |(lambda, start)| {
            let attractor = settled(lambda, start)?;
            let from = interval(&attractor, Sign::Positive)?.start;
            Ok(over_a_period(lambda, &attractor, from, |phi| {
                eq38(lambda, phi)
            }))
        },
    ),
    eq38_unique = one_motion(small(), Within),
    eq38_approach,
    // The other multiplier, of the velocity across, is next to zero.
    eq38_multiplier = {
        let trial = Trial::by(
            Integration,
            Within,
            [
                r"$[(d-\lambda_0)/(d+\lambda_0)]^2$, with $d=\sin\tilde\phi_1$,",
                "the larger Floquet multiplier of the motion in the plane about the periodic one, an eigenvalue of its derivative over a period",
            ],
            MULTIPLIER,
        );
        let frictions = small().into_iter().filter(|l| (0.1..0.4).contains(l));
        trial.over(frictions, |lambda| {
            let attractor = settled(lambda, ORIGIN)?;
            let phi = interval(&attractor, Sign::Positive)?.start + 1.0;
            let after =
                |v| Ok::<_, Failure>(Particle::plain(lambda).run(phi, v, phi + TAU)?.end().v);
            let matrix = jacobian(after, [attractor.w(phi), 0.0], [1e-5; 2])?;
            let [_, [found, _]] = eigenvalues(matrix)?;
            Ok(Pair::plain(
                at(lambda, phi),
                corrected::contraction(lambda),
                found,
            ))
        })
    },
    eq38_outside = {
        let mut points = Points::here();
        Trial::motion(
            Outside,
            [
                "(38) with (39)",
                "the motion without friction, from any start, at 256 phases of the period",
            ],
        )
        .pairs(0..24, |_| {
            let start = DriveState {
                phi: 0.0,
                w: points.uniform(0.5, 3.0),
            };
            let attractor = settled(0.0, start)?;
            let from = FRAC_PI_2;
            let pair = |phi: f64| {
                let at = format!("λ₀ = 0, 𝔴 = {:.6} at φ = 0, φ = {phi:.6}", start.w);
                Pair::wide(at, eq38(0.0, phi), attractor.w(phi)).within(start.w)
            };
            Ok(phases(from).map(pair).collect())
        })
    },
    eq39_motion = Trial::motion(
        Printed,
        [
            "(39)",
            "the phase at which the simulated large-time motion turns positive",
        ],
    )
    .over(small(), |lambda| {
        let attractor = settled(lambda, ORIGIN)?;
        let found = interval(&attractor, Sign::Positive)?.start;
        let stated = printed::eq39_phi_t1(Double::from(lambda));
        let scale = found.max(1.0 / (1.0 - attractor.contraction()));
        Ok(Pair::wide(format!("λ₀ = {lambda:.6}"), stated, found).within(scale))
    }),
    eq39_outside = {
        let trial = Trial::motion(
            Outside,
            [
                "(39)",
                r"the phase at which the motion without friction turns positive, from any start with $-2<\mathfrak w<0$ at $\phi=0$",
            ],
        );
        let starts = Points::here().within(24, [[-1.9, -0.1]]);
        trial.at(["𝔴"], starts, 1.0, |[w]| {
            let motion = settled(0.0, DriveState { phi: 0.0, w })?;
            let found = interval(&motion, Sign::Positive)?.start;
            Ok([printed::eq39_phi_t1(0.0), found])
        })
    },
    rest_interval_root = {
        let trial = Trial::by(
            Root,
            Printed,
            Compared::many(
                r"the ends of $[\tilde\phi_2,\phi_3]$ and $[\tilde\phi_2+\pi,\phi_1+2\pi]$, with the root $\tilde\phi_2$ of (32),",
                "the ends of the simulated rests",
            ),
            ROOT,
        );
        trial.pairs(large(), |lambda| {
            let end = phi_t2(lambda);
            let (phi1, phi3) = (printed::eq27_phi1(lambda), printed::eq29_phi3(lambda));
            let [_, stated @ ..] = printed::eq33_ends(phi1, end, phi3);
            let list = settled(lambda, ORIGIN)?;
            let rests = list.intervals().iter().filter(|i| i.sign == Sign::Rest);
            let found: Vec<_> = rests.flat_map(|i| [i.start, i.end]).collect();
            let slip = Slip::of(lambda)?;
            let spread = end_spread(lambda, slip.end).max(1.0 / libm::cos(slip.start));
            let pair = |(i, stated): (usize, f64)| Pair {
                at: format!("λ₀ = {lambda:.6}"),
                stated,
                found: found.get(i).copied().unwrap_or(f64::NAN),
                scale: spread,
            };
            Ok(stated.into_iter().enumerate().map(pair).collect())
        })
    },
    rest_interval_reached
];
