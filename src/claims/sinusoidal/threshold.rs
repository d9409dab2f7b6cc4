//! Trials of (34), (36), (37), (40), (41): the critical friction.

use super::prelude::*;
use super::reference_motions::{dense, excess_length, forward, small};
use super::slip::eq34;

/// A start, and the friction from which on the motion that it leads to has rests.
#[derive(Debug, Clone, Copy)]
struct Onset {
    start: DriveState,
    lambda: f64,
}

/// By bisection on the simulation alone, down to neighbouring numbers.
static ONSETS: Runs<Vec<Onset>> = Runs::new(|| {
    let mut points = Points::here();
    let mut start = || DriveState {
        phi: points.uniform(0.0, TAU),
        w: points.uniform(-3.0, 3.0),
    };
    let starts: Vec<_> = (0..24).map(|_| start()).collect();
    let found = |start: DriveState| onset(start).map(|lambda| Onset { start, lambda });
    every(starts.into_iter().map(found))
});

fn onset(start: DriveState) -> Result<f64, Failure> {
    let (mut low, mut high) = (0.2, 0.9);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Ok(middle);
        }
        let attractor = settled(middle, start)?;
        let rests = attractor.intervals().iter().any(|i| i.sign == Sign::Rest);
        *(if rests { &mut high } else { &mut low }) = middle;
    }
}

fn at(onset: &Onset) -> String {
    format!("from φ = {:.6}, 𝔴 = {:.6}", onset.start.phi, onset.start.w)
}

attempts![
    eq34_root = Trial::by(
        Root,
        Printed,
        [
            "the root of the left side of (34)",
            "the friction at which simulated rests appear",
        ],
        ONSET,
    )
    .each(ONSETS.each(), at, |onset| {
        Ok([
            root(eq34::<f64>, 0.01, 0.99).unwrap_or(f64::NAN),
            onset.lambda,
            1.0,
        ])
    }),
    eq37_root = {
        let trial = Trial::by(
            Root,
            Printed,
            [
                "(37)",
                "the root of how much longer than half a period a simulated slip lasts, from several brackets",
            ],
            ROOT,
        );
        trial.drawn(0..24, |_, points| {
            let (low, high) = (points.uniform(0.01, 0.5), points.uniform(0.6, 0.99));
            Ok(Pair::plain(
                format!("λ₀ between {low:.6} and {high:.6}"),
                printed::eq37_lambda_c(),
                root(excess_length, low, high)?,
            ))
        })
    },
    eq37_motion = Trial::by(
        Integration,
        Printed,
        [
            "(37)",
            "the friction at which simulated rests appear, by bisection",
        ],
        ONSET,
    )
    .each(ONSETS.each(), at, |onset| {
        Ok([printed::eq37_lambda_c(), onset.lambda, onset.lambda])
    }),
    eq40_census = Trial::census(
        Printed,
        [
            "whether (40) holds (1 if so)",
            "whether the simulated large-time motion has no rest",
        ],
    )
    .over(dense(), |lambda| {
        let attractor = settled(lambda, ORIGIN)?;
        let [left, right] = printed::eq40_sides(lambda);
        Ok(Pair::plain(
            format!("λ₀ = {lambda:.6}"),
            is(left < right),
            is(attractor.intervals().iter().all(|i| i.sign != Sign::Rest)),
        ))
    }),
    eq41_motion = Trial::motion(
        Printed,
        [
            "the difference of the sides of (41)",
            "the same of the simulation, where it has to be positive",
        ],
    )
    .over(small(), |lambda| {
        let attractor = settled(lambda, ORIGIN)?;
        let turn = forward(attractor.intervals());
        let found = turn.ok_or("no slip")?.start - Slip::of(lambda)?.start;
        let l = Double::from(lambda);
        let [left, right] = printed::eq41_sides(printed::eq39_phi_t1(l), printed::eq27_phi1(l));
        let at = format!("λ₀ = {lambda:.6}");
        let scale = found.max(1.0 / (1.0 - attractor.contraction()));
        let found = if found > 0.0 { found } else { f64::NAN };
        Ok(Pair::wide(at, left - right, found).within(scale))
    }),
    eq41_census = {
        let below = dense().into_iter().filter(|lambda| *lambda < lambda_c());
        Trial::census(
            Printed,
            Compared::one(
                "whether (41) holds (1 if so)",
                "whether the simulated motion turns later than a rest would end",
            )
            .over(r"$\lambda_0<\lambda_\mathrm c$"),
        )
        .over(below, |lambda| {
            let attractor = settled(lambda, ORIGIN)?;
            let turn = forward(attractor.intervals());
            let [left, right] =
                printed::eq41_sides(printed::eq39_phi_t1(lambda), printed::eq27_phi1(lambda));
            Ok(Pair::plain(
                format!("λ₀ = {lambda:.6}"),
                is(left > right),
                is(turn.ok_or("no slip")?.start > Slip::of(lambda)?.start),
            ))
        })
    }
];
