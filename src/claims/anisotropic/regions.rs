//! Trials of the list of regions and of the diagram.

use super::census;
use super::prelude::*;
use super::simulated::{Regions, curves_as_corrected, curves_as_printed, orders, own_digits};

/// What a claim says of λ₀ at one q, in digits: NaN if it has no value; none if it says nothing.
type Says = Box<dyn Fn(f64) -> Option<f64>>;

/// Every point of the census of which `wanted` holds, by its q, λ₀ and motion, and those next to one. Where nothing
/// is said, that agrees.
fn census(
    trial: &Trial,
    wanted: impl Fn(f64, f64, f64) -> bool,
    says: impl Fn(f64) -> Says,
) -> Evidence {
    let of = |column: &'static census::Column| {
        let (q, cells, says) = (column.q, &column.cells, says(column.q));
        let wanted: Vec<_> = cells
            .iter()
            .map(|(l, found)| wanted(q, *l, *found))
            .collect();
        let near = move |i: usize| {
            let end = wanted.len().min(i + BESIDE + 1);
            wanted[i.saturating_sub(BESIDE)..end].contains(&true)
        };
        let near = cells.iter().enumerate().filter(move |(i, _)| near(*i));
        near.map(move |(_, (lambda0, found))| (q, *lambda0, *found, says(*lambda0)))
    };
    // The first points kept for readers come from the middle of the plane, not from its corner.
    let (first, rest): (Vec<_>, Vec<_>) = parts(census::columns())
        .flat_map(|column| parts(column.map(of)))
        .enumerate()
        .partition(|(i, _)| i % GENERIC == GENERIC / 2);
    let points = first.into_iter().chain(rest).map(|(_, point)| point);
    trial.over(points.enumerate(), |(i, point)| {
        let (q, lambda0, found, said) = point?;
        let stated = said.unwrap_or(found);
        // A hundred thousand names would take longer than the motions: only those that are read are written.
        let read = i < GENERIC || stated != found;
        let at = match read {
            true => format!("q = {q:.6}, λ₀ = {lambda0:.6}"),
            false => (q.to_bits().rotate_left(32) ^ lambda0.to_bits()).to_string(),
        };
        Ok(Pair::plain(at, stated, found))
    })
}

/// So many points on each side of a wanted one are looked at too, to see where a region ends.
const BESIDE: usize = 2;

/// One point in so many is put first.
const GENERIC: usize = 997;

fn words_of(region: usize, list: Regions) -> Says {
    let words = listed_digits()[region - 1];
    Box::new(move |lambda0| match list(lambda0) {
        Some(other) if other != region => None,
        here => Some(here.map_or(f64::NAN, |_| words)),
    })
}

fn all_words(list: Regions) -> Says {
    let words = listed_digits();
    Box::new(move |lambda0| Some(list(lambda0).map_or(f64::NAN, |region| words[region - 1])))
}

fn one_census(
    subject: Subject,
    region: usize,
    own: f64,
    list: (&'static str, fn(f64) -> Regions),
) -> Evidence {
    let (points, list) = list;
    let trial = Trial::census(subject, orders("the claim").over(points));
    census(
        &trial,
        |_, _, found| found == own,
        |q| words_of(region, list(q)),
    )
}

const AS_PRINTED: (&str, fn(f64) -> Regions) =
    ("in the region as printed and next to it", printed_list);
const AS_CORRECTED: (&str, fn(f64) -> Regions) =
    ("in the region as corrected and next to it", corrected_list);

fn beside(row: &Row, name: &str, stated: f64, which: usize) -> Pair {
    let found = row.changes.upwards()[which];
    Pair {
        at: format!("q = {:.6}, {name}", row.q),
        stated,
        found,
        scale: found,
    }
}

fn ends(
    subject: Subject,
    region: usize,
    wanted: fn(&Row) -> bool,
    (name, list): (&'static str, fn(&Row) -> [f64; 4]),
) -> Evidence {
    let trial = Trial::by(
        Root,
        subject,
        Compared::composed(
            [r"each end of the region in $\lambda_0$ by the ", name, ""],
            ["that of its kind of motion in the simulation", "", ""],
        ),
        ROOT,
    );
    let both = with_each(only(rows(), |row| wanted(row)), [true, false]);
    // Region I begins and region V ends where the plane does.
    let cases = only(
        both,
        |(_, lower)| if *lower { region > 1 } else { region < 5 },
    );
    trial.over(cases, |case| {
        let (row, lower) = case?;
        let (name, which) = match lower {
            true => ("lower end", region - 2),
            false => ("upper end", region - 1),
        };
        Ok(beside(row, name, list(row)[which], which))
    })
}

/// Of the regions I to IV. Without B, II reaches up to C and III is empty.
fn printed_bounds(row: &Row) -> [f64; 4] {
    let bounds = curves_as_printed(row.q).map(|curves| {
        let c = curves.c;
        [curves.a, curves.b.unwrap_or(c), c, curves.d]
    });
    bounds.unwrap_or([f64::NAN; 4])
}

fn corrected_bounds(row: &Row) -> [f64; 4] {
    let bounds = curves_as_corrected(row.q).map(|curves| {
        let c = curves.c.unwrap_or(curves.b_or_e);
        [curves.a, curves.b_or_e, c, curves.d]
    });
    bounds.unwrap_or([f64::NAN; 4])
}

const PRINTED: (&str, fn(&Row) -> [f64; 4]) = ("printed curves", printed_bounds);
const CORRECTED: (&str, fn(&Row) -> [f64; 4]) = ("corrected list", corrected_bounds);

fn everywhere(_: &Row) -> bool {
    true
}

/// Not at q = 1, where A and B are one, nor so near that their distance is lost in rounding.
fn has_second(row: &Row) -> bool {
    row.q > 1.0001
}

/// Where III is: up to Y, but not so near that its motion ends where it begins, to rounding.
fn has_third(row: &Row) -> bool {
    row.before_y && row.changes.backward - row.changes.reversal > 1e-9
}

/// Where IV is, not at q = 1, and C is its lower end.
fn begins_at_c(row: &Row) -> bool {
    row.q > 1.0 && row.before_y
}

fn begins_below_c(row: &Row) -> bool {
    !row.before_y
}

/// Between E and C.
fn beyond_e(subject: Subject) -> Evidence {
    let compared =
        orders("the words of IV").over("between E and C; elsewhere beyond Y this says nothing");
    let trial = Trial::census(subject, compared);
    let y = match own_y() {
        Ok(y) => y,
        Err(error) => return trial.over([error], Err),
    };
    let says = |q| -> Says {
        let c = printed::eq55_lambda0(q);
        let e = curves_as_corrected(q).map_or(f64::NAN, |curves| curves.b_or_e);
        let words = listed_digits()[3];
        Box::new(move |lambda0| {
            if (e..c).contains(&lambda0) {
                Some(words)
            } else {
                (e + c).is_nan().then_some(f64::NAN)
            }
        })
    };
    let wanted = |q: f64, lambda0: f64, found: f64| q > y && q * lambda0 < 1.0 && found == 32.0;
    census(&trial, wanted, says)
}

/// The axes of the diagram end here.
pub(super) const LARGEST_Q: f64 = 7.0;

pub(super) fn diagram() -> Evidence {
    let trial = Trial::census(
        Printed,
        orders("the printed diagram").over("all over the diagram's axes"),
    );
    let says = |q| all_words(printed_list(q));
    census(&trial, |q, _, _| q <= LARGEST_Q, says)
}

pub(super) fn far() -> Evidence {
    let points = Points::here().within(1000, [[12.0, 30.0], [1e-6, 1.0]]);
    Trial::census(Corrected, orders("the corrected diagram")).at(
        ["q", "qλ₀/2"],
        points,
        1.0,
        |[q, share]| {
            let lambda0 = 2.0 * share / q;
            let stated = all_words(corrected_list(q))(lambda0);
            Ok([stated.unwrap_or(f64::NAN), simulated(q, lambda0)?])
        },
    )
}

attempts![
    first_census = one_census(Printed, 1, 31.0, AS_PRINTED),
    first_ends = ends(Printed, 1, everywhere, PRINTED),
    first_outside = {
        let trial = Trial::census(
            Outside,
            [
                "the order of slips and rests in a period by the claim (3 for a forward slip, 2 for a rest, 1 for a backward slip)",
                "that of the motion without friction that begins with $1<\\mathfrak w<3$ at $\\phi=0$",
            ],
        );
        let starts = Points::here().within(24, [[1.0, 3.0]]);
        trial.at(["𝔴"], starts, 1.0, |[w]| {
            let motion = attractor_from(DriveState { phi: 0.0, w }, Friction::new(0.0, 0.0)?)?;
            Ok([listed_digits()[0], own_digits(motion.intervals())])
        })
    },
    second_census | second_corrected_census = one_census(2, 312.0)((AS_PRINTED) | (AS_CORRECTED)),
    second_ends | second_corrected_ends = ends(2, has_second)((PRINTED) | (CORRECTED)),
    between_e_and_c = beyond_e(Corrected),
    third_census = one_census(Printed, 3, 3212.0, AS_PRINTED),
    third_ends = ends(Printed, 3, has_third, PRINTED),
    fourth_census = one_census(Printed, 4, 32.0, AS_PRINTED),
    fourth_ends = ends(Printed, 4, begins_at_c, PRINTED),
    down_to_e = beyond_e(Remark),
    fourth_ends_beyond = ends(Remark, 4, begins_below_c, CORRECTED),
    fifth_census = one_census(Printed, 5, 2.0, AS_PRINTED),
    fifth_ends = ends(Printed, 5, everywhere, PRINTED),
    diagram,
    corrected_diagram = {
        let trial = Trial::census(
            Corrected,
            orders("the corrected diagram").over("$q$ from 1 to 12"),
        );
        let says = |q| all_words(corrected_list(q));
        census(&trial, |_, _, _| true, says)
    },
    far,
    corrected_curves = {
        let trial = Trial::by(
            Root,
            Corrected,
            Compared::many(
                r"$\lambda_0$ on A, on B or E, on C (on E beyond Y) and on D",
                r"the $\lambda_0$ at which a rest appears, direct reversals end, backward motion ends and all motion ends",
            ),
            ROOT,
        );
        let names = ["rest", "reversal", "backward", "motion"];
        trial.pairs(rows(), |row| {
            let row = row?;
            let stated = corrected_bounds(row);
            Ok((0..4)
                .map(|i| beside(row, names[i], stated[i], i))
                .collect())
        })
    },
    diagram_step = {
        let trial = Trial::census(
            Step,
            [
                r"the region by the printed list, less the number of curves below $\lambda_0$, C counted twice where B has ended,",
                "the expected 1",
            ],
        );
        let points = Points::here().within(400, [[1.0, LARGEST_Q], [0.0, 1.4]]);
        trial.at(["q", "λ₀"], points, 1.0, |[q, lambda0]| {
            let beyond_the_crossed = |curves: printed::Curves| {
                let crossed = [curves.a, curves.b.unwrap_or(curves.c), curves.c, curves.d];
                let below = crossed.iter().filter(|curve| **curve < lambda0).count();
                Some(printed::region(lambda0, &curves)? as f64 - below as f64)
            };
            let curves = where_defined(curves_as_printed(q));
            Ok([curves.and_then(beyond_the_crossed).unwrap_or(f64::NAN), 1.0])
        })
    }
];
