//! Trials of the curves: (53) to (56), and E, which continues B.

use super::rows::{Row, far_rows, rows};
use super::simulated::{Curves, simulated};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::tolerances::{FAR_A, FAR_E, NONE, ROOT};
use crate::corrections::anisotropic as corrected;
use crate::evidence::{Evidence, Route, Subject};
use crate::paper::anisotropic as printed;

/// A formula's λ₀ with the λ₀ at which the simulation changes, at those q that are wanted.
fn change(
    subject: Subject,
    compared: &'static str,
    wanted: impl Fn(&Row) -> bool,
    stated: impl Fn(&Row) -> f64,
    found: impl Fn(&Row) -> f64,
) -> Evidence {
    let trial = Trial::by(Route::Root, subject, compared, ROOT);
    over(&trial, rows(), wanted, |row| Pair {
        at: format!("q = {:.6}", row.curves.q),
        stated: stated(row),
        found: found(row),
        scale: found(row),
    })
}

fn over(
    trial: &Trial,
    rows: Result<&'static [Row], Failure>,
    wanted: impl Fn(&Row) -> bool,
    pair: impl Fn(&Row) -> Pair,
) -> Evidence {
    match rows {
        Ok(rows) => trial.over(rows.iter().filter(|row| wanted(row)), |row| Ok(pair(row))),
        Err(error) => trial.over([error], Err),
    }
}

/// How far from a curve the motion is looked at.
const DISTANCES: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// The region of a list with the simulated one, on both sides of a curve.
fn sides(
    subject: Subject,
    compared: &'static str,
    wanted: impl Fn(&Row) -> bool,
    curve: impl Fn(&Curves) -> f64,
    region: impl Fn(f64, &Curves) -> Option<usize>,
) -> Evidence {
    let trial = Trial::by(Route::Census, subject, compared, NONE);
    let rows = match rows() {
        Ok(rows) => rows,
        Err(error) => return trial.over([error], Err),
    };
    let of = |row: &Row| {
        let (curves, height) = (row.curves, curve(&row.curves));
        let both = move |distance: f64| [height - distance, height + distance];
        DISTANCES
            .into_iter()
            .flat_map(both)
            .filter(move |&lambda0| !curves.blur(lambda0))
            .map(move |lambda0| (curves, lambda0))
    };
    let points = rows.iter().filter(|row| wanted(row)).flat_map(of);
    trial.over(points, |(curves, lambda0)| {
        Ok(Pair {
            at: format!("q = {:.6}, λ₀ = {lambda0:.9}", curves.q),
            stated: region(lambda0, &curves).map_or(0.0, |k| k as f64),
            found: simulated(curves.q, lambda0)? as f64,
            scale: 1.0,
        })
    })
}

fn by_printed_list(lambda0: f64, curves: &Curves) -> Option<usize> {
    printed::region(lambda0, &curves.printed)
}

fn by_corrected_list(lambda0: f64, curves: &Curves) -> Option<usize> {
    corrected::region(lambda0, &curves.corrected)
}

fn before_y(row: &Row) -> bool {
    row.curves.printed.b.is_some()
}

fn beyond_y(row: &Row) -> bool {
    !before_y(row)
}

const SIDES: &str = "the printed list's region, 1 to 5, at 1e-3, 1e-6 and 1e-9 on both sides of the curve with the simulated one";

/// (53) with the onset of rest.
pub fn eq53_root() -> Evidence {
    let compared = "the root of (53) with the λ₀ at which a rest appears in the simulated motion";
    change(
        Subject::Printed,
        compared,
        |_| true,
        |row| row.curves.printed.a,
        |row| row.changes.rest,
    )
}

/// (53) on both sides.
pub fn eq53_census() -> Evidence {
    sides(
        Subject::Printed,
        SIDES,
        |_| true,
        |curves| curves.printed.a,
        by_printed_list,
    )
}

/// (53) for large q: its own asymptotic form.
pub fn eq53_limit() -> Evidence {
    let compared = "π/(q + 1)² (1 − π²/(3 (q + 2)²)), to which (53) tends, with the λ₀ at which a rest appears, q from 200 to 20,000";
    let trial = Trial::by(Route::Limit, Subject::Printed, compared, FAR_A);
    over(
        &trial,
        far_rows(),
        |_| true,
        |row| far(row, corrected::a_far, row.changes.rest),
    )
}

fn far(row: &Row, law: fn(f64) -> f64, found: f64) -> Pair {
    Pair {
        at: format!("q = {:.6}", row.curves.q),
        stated: law(row.curves.q),
        found,
        scale: found,
    }
}

/// (54) up to Y with the end of direct reversals.
pub fn eq54_root() -> Evidence {
    eq54(Subject::Within, before_y)
}

/// (54) beyond Y, where direct reversals end too.
pub fn eq54_outside() -> Evidence {
    eq54(Subject::Outside, beyond_y)
}

fn eq54(subject: Subject, wanted: fn(&Row) -> bool) -> Evidence {
    let compared = "the root of (54) with the λ₀ at which forward motion ceases to turn straight into backward motion";
    change(
        subject,
        compared,
        wanted,
        |row| row.curves.printed.b.unwrap_or(f64::NAN),
        |row| row.changes.reversal,
    )
}

/// (54) on both sides, up to Y.
pub fn eq54_census() -> Evidence {
    sides(
        Subject::Within,
        SIDES,
        before_y,
        |curves| curves.corrected.b_or_e,
        by_printed_list,
    )
}

/// E with the end of direct reversals, beyond Y.
pub fn e_root() -> Evidence {
    let compared = "the root of E with the λ₀ at which forward motion ceases to turn straight into backward motion";
    change(
        Subject::Corrected,
        compared,
        beyond_y,
        |row| row.curves.corrected.b_or_e,
        |row| row.changes.reversal,
    )
}

/// B and E on both sides, with the corrected list, over the whole range of q.
pub fn e_census() -> Evidence {
    let compared = "the corrected list's region, 1 to 5, at 1e-3, 1e-6 and 1e-9 on both sides of B and E with the simulated one";
    sides(
        Subject::Corrected,
        compared,
        |_| true,
        |curves| curves.corrected.b_or_e,
        by_corrected_list,
    )
}

/// E for large q.
pub fn e_limit() -> Evidence {
    let compared = "4π/(q + 1)² (1 − 4π²/(q + 7/3)²), to which E tends, with the λ₀ at which direct reversals end, q from 200 to 20,000";
    let trial = Trial::by(Route::Limit, Subject::Corrected, compared, FAR_E);
    over(
        &trial,
        far_rows(),
        |_| true,
        |row| far(row, corrected::e_far, row.changes.reversal),
    )
}

/// (55) up to Y with the end of backward motion.
pub fn eq55_root() -> Evidence {
    eq55(Subject::Within, before_y)
}

/// (55) beyond Y, where backward motion ends too.
pub fn eq55_outside() -> Evidence {
    eq55(Subject::Outside, beyond_y)
}

fn eq55(subject: Subject, wanted: fn(&Row) -> bool) -> Evidence {
    change(
        subject,
        "(55) with the λ₀ beyond which the simulated motion has no backward part",
        wanted,
        |row| row.curves.printed.c,
        |row| row.changes.backward,
    )
}

/// (55) on both sides, up to Y.
pub fn eq55_census() -> Evidence {
    sides(
        Subject::Within,
        SIDES,
        before_y,
        |curves| curves.printed.c,
        by_printed_list,
    )
}

/// (55) on both sides, beyond Y.
pub fn eq55_census_outside() -> Evidence {
    sides(
        Subject::Outside,
        SIDES,
        beyond_y,
        |curves| curves.printed.c,
        by_printed_list,
    )
}

/// (56) with the end of all motion.
pub fn eq56_root() -> Evidence {
    change(
        Subject::Printed,
        "(56) with the λ₀ beyond which the simulated particle is at rest for ever",
        |_| true,
        |row| row.curves.printed.d,
        |row| row.changes.motion,
    )
}

/// (56) on both sides.
pub fn eq56_census() -> Evidence {
    sides(
        Subject::Printed,
        SIDES,
        |_| true,
        |curves| curves.printed.d,
        by_printed_list,
    )
}
