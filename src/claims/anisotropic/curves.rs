//! Trials of the curves: (53) to (56), and E, which continues B. Where they are tried, the simulation says.

use super::prelude::*;
use super::rows::FAR_ROWS;
use super::simulated::{Regions, curve_a, curve_b, curves_as_corrected, orders};

/// A curve: what gives its λ₀ at a q, and this; NaN where there is none.
type Law = (&'static str, fn(f64) -> f64);

const EQ53: Law = ("the root of (53)", |q| curve_a(q).unwrap_or(f64::NAN));
const EQ54: Law = ("the root of (54)", on_b);
const EQ55: Law = ("(55)", printed::eq55_lambda0);
const EQ56: Law = ("(56)", |_| printed::eq56_lambda0());
const E: Law = ("the root of E", on_b_or_e);

/// NaN where (54) has no root.
fn on_b(q: f64) -> f64 {
    curve_b(q).unwrap_or_default().unwrap_or(f64::NAN)
}

/// λ₀ on B up to Y and on E beyond; NaN where neither has a root.
fn on_b_or_e(q: f64) -> f64 {
    curves_as_corrected(q).map_or(f64::NAN, |curves| curves.b_or_e)
}

/// Where the order of the simulated motion changes: what happens there, and at which λ₀ of a row.
type Change = (&'static str, fn(&Row) -> f64);

const REST: Change = ("at which a rest appears in the simulated motion", |row| {
    row.changes.rest
});
const REVERSAL: Change = (
    "at which forward motion ceases to turn straight into backward motion",
    |row| row.changes.reversal,
);
const BACKWARD: Change = (
    "beyond which the simulated motion has no backward part",
    |row| row.changes.backward,
);
const MOTION: Change = (
    "beyond which the simulated particle is at rest for ever",
    |row| row.changes.motion,
);

const fn lambda0_of(law: &'static str, change: &'static str) -> Compared {
    Compared::composed([law, "", ""], [r"the $\lambda_0$ ", change, ""])
}

fn change(
    subject: Subject,
    (law, stated): Law,
    (name, found): Change,
    wanted: fn(&Row) -> bool,
) -> Evidence {
    let trial = Trial::by(Root, subject, lambda0_of(law, name), ROOT);
    over(&trial, only(rows(), |row| wanted(row)), [stated], found)
}

fn over<const N: usize>(
    trial: &Trial,
    rows: impl Iterator<Item = Result<&'static Row, Failure>>,
    stated: [fn(f64) -> f64; N],
    found: fn(&Row) -> f64,
) -> Evidence {
    trial.over(with_each(rows, stated), |case| {
        let (row, stated) = case?;
        Ok(Pair {
            at: format!("q = {:.6}", row.q),
            stated: stated(row.q),
            found: found(row),
            scale: found(row),
        })
    })
}

const DISTANCES: [f64; 3] = [1e-3, 1e-6, 1e-9];

const PRINTED: (&str, fn(f64) -> Regions) = ("the printed list", printed_list);
const CORRECTED: (&str, fn(f64) -> Regions) = ("the corrected list", corrected_list);

fn sides(
    subject: Subject,
    (name, list): (&'static str, fn(f64) -> Regions),
    wanted: fn(&Row) -> bool,
    (of, height): Change,
) -> Evidence {
    let around = [
        r"$10^{-3}$, $10^{-6}$ and $10^{-9}$ on both sides of the $\lambda_0$ ",
        of,
        "",
    ];
    let trial = Trial::census(subject, orders(name).over_composed(around));
    let words = listed_digits();
    let of = |row: &'static Row| {
        let (q, height, list) = (row.q, height(row), list(row.q));
        let both = move |distance: f64| [height - distance, height + distance];
        let heights = DISTANCES.into_iter().flat_map(both);
        heights.map(move |lambda0| (q, lambda0, list(lambda0)))
    };
    let rows = only(rows(), |row| wanted(row));
    trial.over(rows.flat_map(|row| parts(row.map(of))), |point| {
        let (q, lambda0, region) = point?;
        Ok(Pair::plain(
            format!("q = {q:.6}, λ₀ = {lambda0:.9}"),
            region.map_or(f64::NAN, |k| words[k - 1]),
            simulated(q, lambda0)?,
        ))
    })
}

fn everywhere(_: &Row) -> bool {
    true
}

fn before_y(row: &Row) -> bool {
    row.before_y
}

fn beyond_y(row: &Row) -> bool {
    !row.before_y
}

fn far_out(subject: Subject, (law, stated): Law, (name, found): Change) -> Evidence {
    let trial = Trial::by(
        Limit,
        subject,
        lambda0_of(law, name).over("$q$ from 200 to 20,000"),
        FAR_A,
    );
    over(&trial, FAR_ROWS.each(), [stated], found)
}

/// Where friction backwards is as strong as the drive.
const AS_STRONG: Change = (r"at which $q\lambda_0=1$", |row| 1.0 / row.q);

/// At q = 1, C and D are one.
fn off_one(row: &Row) -> bool {
    row.q > 1.01
}

attempts![
    eq53_root = change(Printed, EQ53, REST, everywhere),
    eq53_census = sides(Printed, PRINTED, everywhere, REST),
    eq53_limit = far_out(Printed, EQ53, REST),
    a_far_limit = far_out(
        Remark,
        (
            r"$\pi/(q+1)^2\,[1-\pi^2/(3(q+2)^2)]$, to which curve A tends,",
            corrected::a_far
        ),
        REST
    ),
    eq54_root = change(Printed, EQ54, REVERSAL, before_y),
    eq54_census = sides(Printed, PRINTED, before_y, REVERSAL),
    eq54_ends = {
        let trial = Trial::census(
            Remark,
            [
                "whether (54) has a root (1 if so)",
                "whether, on C, the forward motion of the simulation ends before the drive is lowest (1 if so)",
            ],
        );
        let at = |row: &Row| format!("q = {:.6}", row.q);
        trial.each(rows(), at, |row| {
            Ok([is(!on_b(row.q).is_nan()), is(row.before_y), 1.0])
        })
    },
    eq55_root | eq55_corrected_root = change(EQ55, BACKWARD)((everywhere) | (before_y)),
    eq55_census | eq55_corrected_census =
        sides(PRINTED)((off_one, AS_STRONG) | (before_y, BACKWARD)),
    eq56_root = change(Printed, EQ56, MOTION, everywhere),
    eq56_census = sides(Printed, PRINTED, everywhere, MOTION),
    e_root = change(Corrected, E, REVERSAL, beyond_y),
    e_census = sides(Corrected, CORRECTED, everywhere, REVERSAL),
    e_limit = {
        let trial = Trial::by(
            Limit,
            Corrected,
            Compared::many(
                r"the root of E, and $4\pi/(q+1)^2\,[1-4\pi^2/(q+7/3)^2]$, to which it tends,",
                r"the $\lambda_0$ at which direct reversals end",
            )
            .over("$q$ from 200 to 20,000"),
            FAR_E,
        );
        let both = [on_b_or_e, corrected::e_far];
        over(&trial, FAR_ROWS.each(), both, REVERSAL.1)
    }
];
