//! Trials of the curves: (53) to (56), and E, which continues B. Where they are tried, the simulation says.

use super::rows::{Row, far_rows, rows};
use super::simulated::{
    Regions, corrected_list, curve_a, curve_b, curves_as_corrected, listed_digits, printed_list,
    simulated,
};
use crate::claims::tolerances::{FAR_A, FAR_E, NONE, ROOT};
use crate::corrections::anisotropic as corrected;
use crate::evidence::{Evidence, Route, Subject};
use crate::paper::anisotropic as printed;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::{Compared, Failure, Pair, Trial};

/// λ₀ on (53); NaN where it has no root.
fn on_a(q: f64) -> f64 {
    curve_a(q).unwrap_or(f64::NAN)
}

/// λ₀ on (54); NaN where it has no root.
fn on_b(q: f64) -> f64 {
    curve_b(q).unwrap_or_default().unwrap_or(f64::NAN)
}

/// λ₀ on B up to Y and on E beyond; NaN where neither has a root.
fn on_b_or_e(q: f64) -> f64 {
    curves_as_corrected(q).map_or(f64::NAN, |curves| curves.b_or_e)
}

/// A formula's λ₀ with the λ₀ at which the simulation changes, at those q that are wanted.
fn change(
    subject: Subject,
    compared: Compared,
    wanted: fn(&Row) -> bool,
    stated: fn(f64) -> f64,
    found: fn(&Row) -> f64,
) -> Evidence {
    let trial = Trial::by(Route::Root, subject, compared, ROOT);
    over(&trial, rows(), wanted, &[stated], found)
}

fn over(
    trial: &Trial,
    rows: Result<&'static [Row], Failure>,
    wanted: fn(&Row) -> bool,
    stated: &[fn(f64) -> f64],
    found: fn(&Row) -> f64,
) -> Evidence {
    let rows = match rows {
        Ok(rows) => rows.iter().filter(|row| wanted(row)),
        Err(error) => return trial.over([error], Err),
    };
    let cases = rows.flat_map(|row| stated.iter().map(move |stated| (row, stated)));
    trial.over(cases, |(row, stated)| {
        Ok(Pair {
            at: format!("q = {:.6}", row.q),
            stated: stated(row.q),
            found: found(row),
            scale: found(row),
        })
    })
}

/// How far from a change the motion is looked at.
const DISTANCES: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// The words of a list with the simulated motion, on both sides of a λ₀.
fn sides(
    subject: Subject,
    compared: Compared,
    wanted: fn(&Row) -> bool,
    height: fn(&Row) -> f64,
    list: fn(f64) -> Regions,
) -> Evidence {
    let trial = Trial::by(Route::Census, subject, compared, NONE);
    let rows = match rows() {
        Ok(rows) => rows,
        Err(error) => return trial.over([error], Err),
    };
    let words = listed_digits();
    let of = |row: &Row| {
        let (q, height, list) = (row.q, height(row), list(row.q));
        let both = move |distance: f64| [height - distance, height + distance];
        let heights = DISTANCES.into_iter().flat_map(both);
        heights.map(move |lambda0| (q, lambda0, list(lambda0)))
    };
    let points = rows.iter().filter(|row| wanted(row)).flat_map(of);
    trial.over(points, |(q, lambda0, region)| {
        Ok(Pair {
            at: format!("q = {q:.6}, λ₀ = {lambda0:.9}"),
            stated: region.map_or(f64::NAN, |k| words[k - 1]),
            found: simulated(q, lambda0)?,
            scale: 1.0,
        })
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

fn rest(row: &Row) -> f64 {
    row.changes.rest
}

fn reversal(row: &Row) -> f64 {
    row.changes.reversal
}

fn backward(row: &Row) -> f64 {
    row.changes.backward
}

fn motion(row: &Row) -> f64 {
    row.changes.motion
}

const SIDES: Compared = Compared::one(
    "the order of slips and rests in a period by the printed list (3 for a forward slip, 2 for a rest, 1 for a backward slip)",
    "that of the simulated motion",
)
.over("$10^{-3}$, $10^{-6}$ and $10^{-9}$ on both sides of where the order changes");

/// (53) with the onset of rest.
fn eq53_root() -> Evidence {
    let compared = Compared::one(
        "the root of (53)",
        r"the $\lambda_0$ at which a rest appears in the simulated motion",
    );
    change(Subject::Printed, compared, everywhere, on_a, rest)
}

/// (53) on both sides.
fn eq53_census() -> Evidence {
    sides(Subject::Printed, SIDES, everywhere, rest, printed_list)
}

/// (53) for large q.
fn eq53_limit() -> Evidence {
    let compared = Compared::one(
        "the root of (53)",
        r"the $\lambda_0$ at which a rest appears in the simulated motion",
    );
    far_out(Subject::Printed, compared, on_a)
}

/// Its asymptotic form, which is ours.
fn a_far_limit() -> Evidence {
    let compared = Compared::one(
        r"$\pi/(q+1)^2\,[1-\pi^2/(3(q+2)^2)]$, to which curve A tends,",
        r"the $\lambda_0$ at which a rest appears in the simulated motion",
    );
    far_out(Subject::Remark, compared, corrected::a_far)
}

fn far_out(subject: Subject, compared: Compared, stated: fn(f64) -> f64) -> Evidence {
    let compared = compared.over("$q$ from 200 to 20,000");
    let trial = Trial::by(Route::Limit, subject, compared, FAR_A);
    over(&trial, far_rows(), everywhere, &[stated], rest)
}

/// (54) up to Y with the end of direct reversals.
fn eq54_root() -> Evidence {
    let compared = Compared::one(
        "the root of (54)",
        r"the $\lambda_0$ at which forward motion ceases to turn straight into backward motion",
    );
    change(Subject::Printed, compared, before_y, on_b, reversal)
}

/// (54) on both sides, up to Y.
fn eq54_census() -> Evidence {
    sides(Subject::Printed, SIDES, before_y, reversal, printed_list)
}

/// Where (54) ends.
fn eq54_ends() -> Evidence {
    let compared = Compared::one(
        "whether (54) has a root (1 if so)",
        "whether, on C, the forward motion of the simulation ends before the drive is lowest (1 if so)",
    );
    let trial = Trial::by(Route::Census, Subject::Remark, compared, NONE);
    let rows = match rows() {
        Ok(rows) => rows,
        Err(error) => return trial.over([error], Err),
    };
    let yes = |yes: bool| f64::from(u8::from(yes));
    trial.over(rows, |row| {
        Ok(Pair {
            at: format!("q = {:.6}", row.q),
            stated: yes(!on_b(row.q).is_nan()),
            found: yes(row.before_y),
            scale: 1.0,
        })
    })
}

/// E with the end of direct reversals, beyond Y.
fn e_root() -> Evidence {
    let compared = Compared::one(
        "the root of E",
        r"the $\lambda_0$ at which forward motion ceases to turn straight into backward motion",
    );
    change(Subject::Corrected, compared, beyond_y, on_b_or_e, reversal)
}

/// B and E on both sides, with the corrected list, over the whole range of q.
fn e_census() -> Evidence {
    let compared = Compared::one(
        "the order of slips and rests in a period by the corrected list (3 for a forward slip, 2 for a rest, 1 for a backward slip)",
        "that of the simulated motion",
    )
    .over("$10^{-3}$, $10^{-6}$ and $10^{-9}$ on both sides of where direct reversals end");
    let subject = Subject::Corrected;
    sides(subject, compared, everywhere, reversal, corrected_list)
}

/// E for large q, and its asymptotic form.
fn e_limit() -> Evidence {
    let compared = Compared::many(
        r"the root of E, and $4\pi/(q+1)^2\,[1-4\pi^2/(q+7/3)^2]$, to which it tends,",
        r"the $\lambda_0$ at which direct reversals end",
    )
    .over("$q$ from 200 to 20,000");
    let trial = Trial::by(Route::Limit, Subject::Corrected, compared, FAR_E);
    let both = [on_b_or_e, corrected::e_far];
    over(&trial, far_rows(), everywhere, &both, reversal)
}

/// (55) with the end of backward motion.
fn eq55_root() -> Evidence {
    eq55(Subject::Printed, everywhere)
}

/// The same up to Y.
fn eq55_corrected_root() -> Evidence {
    eq55(Subject::Corrected, before_y)
}

fn eq55(subject: Subject, wanted: fn(&Row) -> bool) -> Evidence {
    let compared = Compared::one(
        "(55)",
        r"the $\lambda_0$ beyond which the simulated motion has no backward part",
    );
    change(subject, compared, wanted, printed::eq55_lambda0, backward)
}

/// The printed list on both sides of where friction backwards is as strong as the drive.
fn eq55_census() -> Evidence {
    let compared = Compared::one(
        "the order of slips and rests in a period by the printed list (3 for a forward slip, 2 for a rest, 1 for a backward slip)",
        "that of the simulated motion",
    )
    .over(r"$10^{-3}$, $10^{-6}$ and $10^{-9}$ on both sides of $q\lambda_0=1$");
    let as_strong = |row: &Row| 1.0 / row.q;
    sides(Subject::Printed, compared, off_one, as_strong, printed_list)
}

/// The same up to Y, by where backward motion ends.
fn eq55_corrected_census() -> Evidence {
    sides(Subject::Corrected, SIDES, before_y, backward, printed_list)
}

/// At q = 1, C and D are one.
fn off_one(row: &Row) -> bool {
    row.q > 1.01
}

/// (56) with the end of all motion.
fn eq56_root() -> Evidence {
    let compared = Compared::one(
        "(56)",
        r"the $\lambda_0$ beyond which the simulated particle is at rest for ever",
    );
    let on_d = |_: f64| printed::eq56_lambda0();
    change(Subject::Printed, compared, everywhere, on_d, motion)
}

/// (56) on both sides.
fn eq56_census() -> Evidence {
    sides(Subject::Printed, SIDES, everywhere, motion, printed_list)
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq53_root,
    eq53_census,
    eq53_limit,
    a_far_limit,
    eq54_root,
    eq54_census,
    eq54_ends,
    eq55_root,
    eq55_census,
    eq55_corrected_root,
    eq55_corrected_census,
    eq56_root,
    eq56_census,
    e_root,
    e_census,
    e_limit
];
