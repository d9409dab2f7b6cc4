//! The census of the plane: the kind of motion at many points, by simulation alone, beside both lists.

use super::simulated::{Curves, simulated};
use crate::claims::compare::Failure;
use crate::claims::points::Points;
use crate::claims::runs::Runs;
use crate::corrections::anisotropic as corrected;
use crate::paper::anisotropic as printed;

/// Cells of the census along q, thirty for each unit.
pub const COLUMNS: usize = 330;
/// Cells of the census along λ₀.
pub const ROWS: usize = 180;
/// The ends of the census along q.
pub const Q: (f64, f64) = (1.0, 12.0);
/// The ends of the census along λ₀.
pub const LAMBDA0: (f64, f64) = (0.0, 1.4);

/// One value of q, at random in its column but for the first and the last, with one λ₀ at random in each cell.
#[derive(Debug, Clone)]
pub struct Column {
    /// The curves there.
    pub curves: Curves,
    /// λ₀ from the lowest cell up, and the simulated region.
    pub cells: Vec<(f64, usize)>,
}

/// One simulated point.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    /// The curves at its q.
    pub curves: Curves,
    /// Its λ₀.
    pub lambda0: f64,
    /// The region that the motion fits, 0 if none.
    pub found: usize,
}

impl Point {
    /// The region of the printed list.
    pub fn printed(&self) -> Option<usize> {
        printed::region(self.lambda0, &self.curves.printed)
    }

    /// The region of the corrected list.
    pub fn corrected(&self) -> Option<usize> {
        corrected::region(self.lambda0, &self.curves.corrected)
    }

    /// The point in the claim's own symbols.
    pub fn at(&self) -> String {
        format!("q = {:.6}, λ₀ = {:.6}", self.curves.q, self.lambda0)
    }
}

/// How the census came out.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Count {
    /// Points simulated.
    pub points: usize,
    /// Points so near a curve that nothing is said.
    pub blurred: usize,
    /// Points at which the printed list is wrong.
    pub printed_wrong: usize,
    /// Points at which the corrected list is wrong.
    pub corrected_wrong: usize,
}

/// The columns, in order of q.
///
/// # Errors
/// Why there are none.
pub fn columns() -> Result<&'static [Column], Failure> {
    static COLUMNS: Runs<Vec<Column>> = Runs::new(run);
    Ok(COLUMNS.get()?)
}

fn run() -> Result<Vec<Column>, Failure> {
    let mut points = Points::stream(300);
    let step = |(from, to): (f64, f64), cells: usize| (to - from) / cells as f64;
    let drawn: Vec<(f64, Vec<f64>)> = (0..COLUMNS)
        .map(|i| {
            let share = match i {
                0 => 0.0,
                _ if i + 1 == COLUMNS => 1.0,
                _ => points.uniform(0.0, 1.0),
            };
            let q = Q.0 + (i as f64 + share) * step(Q, COLUMNS);
            // λ₀ = 0 itself is no point of the plane.
            let lambda0 = |j| (j as f64 + points.uniform(1e-9, 1.0)) * step(LAMBDA0, ROWS);
            (q, (0..ROWS).map(lambda0).collect())
        })
        .collect();
    let column = |(q, lambdas): &(f64, Vec<f64>)| {
        let made = || -> Result<Column, Failure> {
            let cell = |&lambda0: &f64| Ok((lambda0, simulated(*q, lambda0)?));
            Ok(Column {
                curves: Curves::at(*q)?,
                cells: lambdas.iter().map(cell).collect::<Result<_, Failure>>()?,
            })
        };
        made().map_err(|error| format!("q = {q}: {error}").into())
    };
    // By threads of its own: within a shared lazy value, a task that a thread pool takes over meanwhile could wait
    // for that very value.
    let half = |columns: &[_]| {
        columns
            .iter()
            .map(column)
            .collect::<Result<Vec<_>, Failure>>()
    };
    let (low, high) = drawn.split_at(COLUMNS / 2);
    std::thread::scope(|scope| {
        let high = scope.spawn(|| half(high));
        let mut all = half(low)?;
        all.extend(high.join().map_err(|_| "the census has failed")??);
        Ok(all)
    })
}

/// All points away from the curves.
///
/// # Errors
/// As [`columns`].
pub fn points() -> Result<impl Iterator<Item = Point>, Failure> {
    let of = |column: &'static Column| {
        let curves = column.curves;
        let point = move |&(lambda0, found): &(f64, usize)| Point {
            curves,
            lambda0,
            found,
        };
        column.cells.iter().map(point)
    };
    let clear = |point: &Point| !point.curves.blur(point.lambda0);
    Ok(columns()?.iter().flat_map(of).filter(clear))
}

/// Counts the mismatches of both lists, up to this q.
///
/// # Errors
/// As [`columns`].
pub fn count(largest_q: f64) -> Result<Count, Failure> {
    let within = || columns().map(|all| all.iter().filter(move |c| c.curves.q <= largest_q));
    let all: usize = within()?.map(|column| column.cells.len()).sum();
    let clear = points()?.filter(|point| point.curves.q <= largest_q);
    Ok(tally(all, clear))
}

/// Counts the mismatches at points that are clear, out of `all`.
fn tally(all: usize, points: impl Iterator<Item = Point>) -> Count {
    let mut count = Count {
        points: all,
        ..Count::default()
    };
    let mut clear = 0;
    for point in points {
        clear += 1;
        count.printed_wrong += usize::from(point.printed() != Some(point.found));
        count.corrected_wrong += usize::from(point.corrected() != Some(point.found));
    }
    count.blurred = all - clear;
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::drive::{Friction, State};

    /// Every wrong point of the printed list lies between E and C beyond Y, and the motion there is that of IV.
    #[test]
    fn the_printed_list_fails_in_one_place_only() {
        let total = count(f64::INFINITY).unwrap();
        println!("{total:?}, on the figure's axes {:?}", count(7.0).unwrap());
        assert!(total.points >= 50_000 && total.blurred < 3, "{total:?}");
        assert!(total.printed_wrong > 250, "{total:?}");
        assert_eq!(total.corrected_wrong, 0);
        for point in points().unwrap() {
            let Curves {
                printed, corrected, ..
            } = point.curves;
            let lacking =
                printed.b.is_none() && (corrected.b_or_e..printed.c).contains(&point.lambda0);
            assert_eq!(point.printed() != Some(point.found), lacking, "{point:?}");
            assert!(!lacking || (point.found, point.printed()) == (4, Some(2)));
        }
    }

    #[test]
    fn points_that_neither_list_fits_are_counted() {
        let (q, lambda0) = (2.0, 0.38);
        let curves = Curves::at(q).unwrap();
        let region = simulated(q, lambda0).unwrap();
        let found = |found: usize| Point {
            curves,
            lambda0,
            found,
        };
        let points = [region, region + 1, region, 0, region].map(found);
        let expected = Count {
            points: 8,
            blurred: 3,
            printed_wrong: 2,
            corrected_wrong: 2,
        };
        assert_eq!(tally(8, points.into_iter()), expected);
    }

    /// The kind of motion does not depend on the start.
    #[test]
    fn other_starts_lead_to_the_same_kind() {
        use super::super::simulated::{attractor_from, fits};
        let mut random = Points::stream(301);
        for point in points().unwrap().step_by(997) {
            let start = State {
                phi: random.uniform(0.0, 6.0),
                w: random.uniform(-3.0, 3.0),
            };
            let friction = Friction::new(point.lambda0, point.curves.q * point.lambda0).unwrap();
            let attractor = attractor_from(start, friction).unwrap();
            assert_eq!(fits(attractor.intervals()), point.found, "{point:?}");
        }
    }
}
