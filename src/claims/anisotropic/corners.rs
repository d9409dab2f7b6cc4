//! Trials of the points X and Y: where the curves meet, and how.

use super::prelude::*;
use super::simulated::{bisect, change, order, restless, reverses, simulated_y};

/// Seeded starts, the plain one first.
fn starts() -> impl Iterator<Item = DriveState> {
    let mut points = Points::here();
    (0..24).map(move |i| match i {
        0 => START,
        _ => DriveState {
            phi: points.uniform(0.0, 2.0 * PI),
            w: points.uniform(-2.0, 2.0),
        },
    })
}

fn at(start: DriveState) -> String {
    format!("start φ = {:.6}, 𝔴 = {:.6}", start.phi, start.w)
}

fn x(change_of: &'static str, holds: fn(&[Interval]) -> bool) -> Evidence {
    const EQUAL: &str = r"the $\lambda_0$ at which, for $q=1$, ";
    const X: [&str; 3] = [r"$\lambda_0$ of X", "", ""];
    let compared = Compared::composed(X, [EQUAL, change_of, " in the simulated motion"]);
    let [_, lambda0] = printed::eq57_x();
    Trial::by(Root, Printed, compared, ROOT).over(starts(), |start| {
        let found = change(1.0, 1e-9, start, holds)?;
        Ok(Pair {
            at: at(start),
            stated: lambda0,
            found,
            scale: found,
        })
    })
}

const SIMULATED_Y: &str = r"the point of $q\lambda_0=1$ at which the simulated forward motion ends at the drive's minimum";

pub(super) fn y_digits() -> Evidence {
    Trial::by(
        Root,
        Printed,
        ["the root of (54) on (55)", SIMULATED_Y],
        MOTION,
    )
    .over(SIMULATED_POINTS.each(), |point| {
        let (start, found) = *point?;
        Ok(Pair {
            at: at(start),
            stated: printed_y(),
            found,
            scale: found,
        })
    })
}

static SIMULATED_POINTS: Runs<Vec<(DriveState, f64)>> = Runs::new(|| {
    let point = |start| simulated_y(start).map(|q| (start, q));
    every(starts().map(point))
});

/// NaN if they have no common point.
fn printed_y() -> f64 {
    touching().unwrap_or(f64::NAN)
}

/// How closely they touch, as a number: C − B and C − E over (q − q_Y)², the mean of both sides.
fn y_curvature() -> Evidence {
    let trial = Trial::by(Root, Printed, Compared::one(
        r"$\lambda_0$ on C less $(q_Y-1)\delta^2/[2q_Y^3(q_Y+1)]$",
        r"the $\lambda_0$ at which direct reversals end in the simulation, in units of its distance from $q\lambda_0=1$",
    )
    .over(r"$q=q_Y\pm\delta$"), CONTACT);
    trial.over(steps(), |k| {
        let (y, own) = (printed_y(), own_y()?);
        let delta = 1e-2 * libm::exp10(-k / 24.0);
        let both = [own - delta, own + delta];
        let mean = |at: [f64; 2]| 0.5 * (at[0] + at[1]);
        let below = corrected::contact(y) * delta * delta;
        let [low, high] = both.map(|q| change(q, 1e-9, START, reverses));
        let found = mean([low?, high?]);
        Ok(Pair {
            at: format!("δ = {delta:.5e}"),
            stated: mean(both.map(printed::eq55_lambda0)) - below,
            found,
            scale: mean(both.map(|q| 1.0 / q)) - found,
        })
    })
}

fn steps() -> Vec<f64> {
    Points::here().grid((0..24).map(f64::from))
}

/// The ends in q of region II along qλ₀ = 1 − η, by simulation.
fn opening(eta: f64) -> Result<[f64; 2], Failure> {
    let y = own_y()?;
    let is_second = |q: f64| Ok(order(attractor(q, (1.0 - eta) / q)?.intervals()) == "+-0");
    Ok([bisect(y, 2.0, is_second)?, bisect(y, 9.0, is_second)?])
}

attempts![
    x_root = x("a rest appears", restless),
    y_decimals = {
        let [q, lambda0] = printed::eq58_y();
        let both = |start| [(start, true), (start, false)];
        Trial::by(Root, Printed, ["(58)", SIMULATED_Y], THREE_DECIMALS).over(
            starts().flat_map(both),
            |(start, is_q)| {
                let found = simulated_y(start)?;
                let (name, stated, found) = if is_q {
                    ("q", q, found)
                } else {
                    ("λ₀", lambda0, 1.0 / found)
                };
                Ok(Pair::plain(format!("{name}, {}", at(start)), stated, found))
            },
        )
    },
    y_limit = Trial::by(
        Limit,
        Printed,
        Compared::one(
            "$q$ of (58)",
            r"the middle of region II on $q\lambda_0=1-\eta$, whose ends come from simulation",
        )
        .over(r"$\eta$ from $10^{-5}$ to $10^{-10}$"),
        THREE_DECIMALS,
    )
    .over(steps(), |k| {
        let eta = 1e-5 * libm::exp10(-k / 5.0);
        let [low, high] = opening(eta)?;
        Ok(Pair::plain(
            format!("η = {eta:.5e}"),
            printed::eq58_y::<f64>()[0],
            0.5 * (low + high),
        ))
    }),
    x_both = x("direct reversals end", reverses),
    y_digits,
    y_by_slip = {
        let trial = Trial::by(
            Root,
            Remark,
            Compared::many(
                r"$q_Y=\sqrt{1+x^2}$ and $\lambda_0=1/q_Y$, with the root of $\tan x=x$ between $\pi$ and $3\pi/2$,",
                SIMULATED_Y,
            ),
            MOTION,
        );
        trial.over(with_each(SIMULATED_POINTS.each(), [0, 1]), |case| {
            let (&(start, q), i) = case?;
            let x = root(|x| libm::sin(x) - x * libm::cos(x), PI, 1.5 * PI)?;
            let found = [q, 1.0 / q][i];
            Ok(Pair {
                at: format!("{}, {}", ["q", "λ₀"][i], at(start)),
                stated: corrected::y_from_root(x)[i],
                found,
                scale: found,
            })
        })
    },
    // Curves that touch: region II between them on qλ₀ = 1 − η opens as the root of η; as η, if they crossed. C lies above
    // both B and E by c (q − q_Y)², to lowest order, so that it opens for |q − q_Y| < √(η/(q_Y c)).
    y_contact = Trial::by(
        Limit,
        Printed,
        Compared::one(
            r"$2\sqrt{\eta/(q_Yc)}$, with $c=(q_Y-1)/[2q_Y^3(q_Y+1)]$,",
            r"the width in $q$ of region II on $q\lambda_0=1-\eta$ in the simulation",
        )
        .over(r"$\eta$ from $10^{-3}$ to $10^{-10}$"),
        CONTACT,
    )
    .over(steps(), |k| {
        let eta = 1e-3 * libm::exp2(-k);
        let y = printed_y();
        let [low, high] = opening(eta)?;
        Ok(Pair {
            at: format!("η = {eta:.5e}"),
            stated: 2.0 * libm::sqrt(eta / (y * corrected::contact(y))),
            found: high - low,
            scale: high - low,
        })
    }),
    y_curvature
];
