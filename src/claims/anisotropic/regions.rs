//! Trials of the list of regions and of the diagram.

use super::census::{self, Point};
use super::rows::{Row, rows};
use crate::claims::compare::{Pair, Trial};
use crate::claims::tolerances::{NONE, ROOT};
use crate::evidence::{Evidence, Route, Subject};

type List = fn(&Point) -> Option<usize>;

/// Every point of the census of which `wanted` holds: what a list says with what was simulated.
fn census(
    subject: Subject,
    compared: &'static str,
    list: List,
    wanted: impl Fn(&Point) -> bool,
) -> Evidence {
    let trial = Trial::by(Route::Census, subject, compared, NONE);
    let points = match census::points() {
        Ok(points) => points,
        Err(error) => return trial.over([error], Err),
    };
    // The first points kept for readers come from the middle of the plane, not from its corner.
    let (first, rest): (Vec<_>, Vec<_>) = points
        .filter(|point| wanted(point))
        .enumerate()
        .partition(|(i, _)| i % GENERIC == GENERIC / 2);
    let points = first.into_iter().chain(rest).map(|(_, point)| point);
    trial.over(points.enumerate(), |(i, point)| {
        let listed = list(&point).unwrap_or(0);
        // A hundred thousand names would take longer than the motions: only those that are read are written.
        let read = i < GENERIC || listed != point.found;
        Ok(Pair {
            at: if read { point.at() } else { String::new() },
            stated: listed as f64,
            found: point.found as f64,
            scale: 1.0,
        })
    })
}

/// One point in so many is put first.
const GENERIC: usize = 997;

const BY_REGION: &str = "the region, 1 to 5, with the order of the simulated intervals, wherever the printed list has this region";
const BY_CORRECTED_REGION: &str = "the region, 1 to 5, with the order of the simulated intervals, wherever the corrected list has this region";

fn printed_census(region: usize) -> Evidence {
    census(Subject::Printed, BY_REGION, Point::printed, |point| {
        point.printed() == Some(region)
    })
}

/// The ends of a region along λ₀ with the ends of its kind of motion.
fn ends(
    region: usize,
    subject: Subject,
    compared: &'static str,
    list: fn(&Row) -> [f64; 4],
    wanted: fn(&Row) -> bool,
) -> Evidence {
    let trial = Trial::by(Route::Root, subject, compared, ROOT);
    let rows = match rows() {
        Ok(rows) => rows,
        Err(error) => return trial.over([error], Err),
    };
    let both = rows
        .iter()
        .filter(|row| wanted(row))
        .flat_map(|row| [(row, true), (row, false)]);
    // Region I begins and region V ends where the plane does.
    let cases = both.filter(|(_, lower)| if *lower { region > 1 } else { region < 5 });
    trial.over(cases, |(row, lower)| {
        let bounds = list(row);
        let changes = row.changes;
        let motion = [
            changes.rest,
            changes.reversal,
            changes.backward,
            changes.motion,
        ];
        let (name, stated, found) = if lower {
            let (end, begins) = (bounds[region - 2], motion[region - 2]);
            // What IV's words say of its own points holds too if its motion goes on below.
            let found = if region == 4 { begins.max(end) } else { begins };
            ("lower end", end, found)
        } else {
            ("upper end", bounds[region - 1], motion[region - 1])
        };
        Ok(Pair {
            at: format!("q = {:.6}, {name}", row.curves.q),
            stated,
            found,
            scale: stated,
        })
    })
}

const BY_ENDS: &str = "the region's ends in λ₀ by the printed curves with those of its kind of motion, by bisection on the simulation";
const BY_ENDS_OR_BEYOND: &str = "the region's ends in λ₀ by the printed curves with those of its kind of motion, by bisection on the simulation; the lower end with itself where the motion goes on below";
const BY_CORRECTED_ENDS: &str = "the region's ends in λ₀ by the corrected list with those of its kind of motion, by bisection on the simulation";

/// The upper ends of the regions I to IV by the printed list. Without B, II reaches up to C and III is empty.
fn printed_bounds(row: &Row) -> [f64; 4] {
    let curves = row.curves.printed;
    [curves.a, curves.b.unwrap_or(curves.c), curves.c, curves.d]
}

/// The same by the corrected list.
fn corrected_bounds(row: &Row) -> [f64; 4] {
    let curves = row.curves.corrected;
    let c = curves.c.unwrap_or(curves.b_or_e);
    [curves.a, curves.b_or_e, c, curves.d]
}

fn everywhere(_: &Row) -> bool {
    true
}

/// Not at q = 1, where A and B are one, nor so near that their distance is lost in rounding.
fn has_second(row: &Row) -> bool {
    row.curves.q > 1.0001
}

/// Where III is: up to Y, but not so near that C and B are one to rounding; nor the row where C and D are one.
fn has_third(row: &Row) -> bool {
    row.curves
        .printed
        .b
        .is_some_and(|b| row.curves.printed.c - b > 1e-9)
}

/// Where IV is: not at q = 1.
fn has_fourth(row: &Row) -> bool {
    row.curves.q > 1.0
}

/// Region I at the points of the census.
pub fn first_census() -> Evidence {
    printed_census(1)
}

/// Region I by its ends.
pub fn first_ends() -> Evidence {
    ends(1, Subject::Printed, BY_ENDS, printed_bounds, everywhere)
}

/// Region II at the points of the census.
pub fn second_census() -> Evidence {
    printed_census(2)
}

/// Region II by its ends.
pub fn second_ends() -> Evidence {
    ends(2, Subject::Printed, BY_ENDS, printed_bounds, has_second)
}

/// Region II of the corrected list at the points of the census.
pub fn second_corrected_census() -> Evidence {
    census(
        Subject::Corrected,
        BY_CORRECTED_REGION,
        Point::corrected,
        |point| point.corrected() == Some(2),
    )
}

/// Region II of the corrected list by its ends.
pub fn second_corrected_ends() -> Evidence {
    ends(
        2,
        Subject::Corrected,
        BY_CORRECTED_ENDS,
        corrected_bounds,
        has_second,
    )
}

/// What is new in region IV: between E and C.
pub fn between_e_and_c() -> Evidence {
    let compared = "region 4 with the order of the simulated intervals, between E and C";
    census(Subject::Corrected, compared, Point::corrected, |point| {
        let curves = point.curves;
        curves.printed.b.is_none()
            && (curves.corrected.b_or_e..curves.printed.c).contains(&point.lambda0)
    })
}

/// Region III at the points of the census.
pub fn third_census() -> Evidence {
    printed_census(3)
}

/// Region III by its ends.
pub fn third_ends() -> Evidence {
    ends(3, Subject::Printed, BY_ENDS, printed_bounds, has_third)
}

/// Region IV at the points of the census.
pub fn fourth_census() -> Evidence {
    printed_census(4)
}

/// Region IV by its ends.
pub fn fourth_ends() -> Evidence {
    ends(
        4,
        Subject::Printed,
        BY_ENDS_OR_BEYOND,
        printed_bounds,
        has_fourth,
    )
}

/// Region V at the points of the census.
pub fn fifth_census() -> Evidence {
    printed_census(5)
}

/// Region V by its lower end.
pub fn fifth_ends() -> Evidence {
    ends(5, Subject::Printed, BY_ENDS, printed_bounds, everywhere)
}

/// The axes of the diagram end here.
pub const LARGEST_Q: f64 = 7.0;

/// The printed diagram at the points of the census.
pub fn diagram() -> Evidence {
    let compared = "the region, 1 to 5, in the printed diagram with the order of the simulated intervals, all over the diagram's axes";
    census(Subject::Printed, compared, Point::printed, |point| {
        point.curves.q <= LARGEST_Q
    })
}

/// The corrected diagram at all points of the census.
pub fn corrected_diagram() -> Evidence {
    let compared = "the region, 1 to 5, in the corrected diagram with the order of the simulated intervals, for q from 1 to 12";
    census(Subject::Corrected, compared, Point::corrected, |_| true)
}

/// The corrected diagram's curves with the changes of the motion, none left out.
pub fn corrected_curves() -> Evidence {
    let compared = "λ₀ on A, on B or E, on C (on E beyond Y) and on D with the λ₀ at which a rest appears, direct reversals end, backward motion ends and all motion ends";
    let trial = Trial::by(Route::Root, Subject::Corrected, compared, ROOT);
    let rows = match rows() {
        Ok(rows) => rows,
        Err(error) => return trial.over([error], Err),
    };
    let changes = |row: &'static Row| {
        let found = row.changes;
        let found = [found.rest, found.reversal, found.backward, found.motion];
        let names = ["rest", "reversal", "backward", "motion"];
        let stated = corrected_bounds(row);
        (0..4).map(move |i| (row.curves.q, names[i], stated[i], found[i]))
    };
    trial.over(rows.iter().flat_map(changes), |(q, name, stated, found)| {
        Ok(Pair {
            at: format!("q = {q:.6}, {name}"),
            stated,
            found,
            scale: found,
        })
    })
}
