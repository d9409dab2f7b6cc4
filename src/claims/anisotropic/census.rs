//! The census of the plane: the kind of motion at many points, by simulation alone; and how both lists fare with it.

use super::prelude::*;
use trialbook::trials::points::round;

/// Cells of the census along q, thirty for each unit.
pub const COLUMNS: usize = 330;
/// Cells of the census along λ₀.
pub const ROWS: usize = 180;
/// The ends of the census along q.
pub const Q: (f64, f64) = (1.0, 12.0);
/// To this q the census of every other round of a deep run goes on.
const FAR: f64 = 30.0;
/// The ends of the census along λ₀.
pub const LAMBDA0: (f64, f64) = (0.0, 1.4);

/// One value of q, at random in its column but for the first and the last, with one λ₀ at random in each cell.
#[derive(Debug, Clone)]
pub struct Column {
    /// The ratio q.
    pub q: f64,
    /// λ₀ from the lowest cell up, and the [digits](super::simulated::digits) of the motion.
    pub cells: Vec<(f64, f64)>,
}

/// How the census came out.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Count {
    /// Points simulated.
    pub points: usize,
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
    let mut points = Points::here();
    let step = |(from, to): (f64, f64), cells: usize| (to - from) / cells as f64;
    let along_q = match round() % 2 {
        0 => Q,
        _ => (Q.1, FAR),
    };
    let drawn: Vec<(f64, Vec<f64>)> = (0..COLUMNS)
        .map(|i| {
            let share = match i {
                0 => 0.0,
                _ if i + 1 == COLUMNS => 1.0,
                _ => points.uniform(0.0, 1.0),
            };
            let q = along_q.0 + (i as f64 + share) * step(along_q, COLUMNS);
            // λ₀ = 0 itself is no point of the plane.
            let lambda0 = |j| (j as f64 + points.uniform(1e-9, 1.0)) * step(LAMBDA0, ROWS);
            (q, (0..ROWS).map(lambda0).collect())
        })
        .collect();
    let column = |(q, lambdas): &(f64, Vec<f64>)| {
        let made = || -> Result<Column, Failure> {
            let cell = |&lambda0: &f64| Ok((lambda0, simulated(*q, lambda0)?));
            Ok(Column {
                q: *q,
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

/// Counts the points at which each list is wrong, up to this q.
///
/// # Errors
/// As [`columns`].
pub fn count(largest_q: f64) -> Result<Count, Failure> {
    let within = columns()?.iter().filter(|column| column.q <= largest_q);
    Ok(within.fold(Count::default(), |sum, column| sum.with(column)))
}

impl Count {
    fn with(self, column: &Column) -> Self {
        let words = listed_digits();
        let wrong = |list: &dyn Fn(f64) -> Option<usize>| {
            let right = |(lambda0, found): &(f64, f64)| {
                list(*lambda0).is_some_and(|region| words[region - 1] == *found)
            };
            column.cells.iter().filter(|cell| !right(cell)).count()
        };
        Count {
            points: self.points + column.cells.len(),
            printed_wrong: self.printed_wrong + wrong(&printed_list(column.q)),
            corrected_wrong: self.corrected_wrong + wrong(&corrected_list(column.q)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::simulated::{Curves, fits};
    use super::*;
    use crate::motion::drive::{DriveState, Friction};

    /// Every wrong point of the printed list lies between E and C beyond Y, and the motion there is that of IV.
    #[test]
    fn the_printed_list_fails_in_one_place_only() {
        let total = count(f64::INFINITY).unwrap();
        println!("{total:?}, on the figure's axes {:?}", count(7.0).unwrap());
        assert!(total.points >= 50_000, "{total:?}");
        assert!(total.printed_wrong > 250, "{total:?}");
        assert_eq!(total.corrected_wrong, 0);
        for column in columns().unwrap() {
            let Curves {
                printed, corrected, ..
            } = Curves::at(column.q).unwrap();
            let listed = printed_list(column.q);
            for (lambda0, found) in &column.cells {
                let (listed, found) = (listed(*lambda0), fits(*found));
                let lacking =
                    printed.b.is_none() && (corrected.b_or_e..printed.c).contains(lambda0);
                assert_eq!(listed != Some(found), lacking, "{}, {lambda0}", column.q);
                assert!(!lacking || (found, listed) == (4, Some(2)));
            }
        }
    }

    #[test]
    fn points_that_neither_list_fits_are_counted() {
        let (q, lambda0) = (2.0, 0.38);
        let right = simulated(q, lambda0).unwrap();
        let found = [right, right + 1.0, right, 0.0, right];
        let cells = found.map(|found| (lambda0, found)).to_vec();
        let before = Count {
            points: 3,
            printed_wrong: 4,
            corrected_wrong: 5,
        };
        let expected = Count {
            points: 8,
            printed_wrong: 6,
            corrected_wrong: 7,
        };
        assert_eq!(before.with(&Column { q, cells }), expected);
    }

    #[test]
    fn other_starts_lead_to_the_same_kind() {
        use super::super::simulated::{attractor_from, own_digits};
        let mut random = Points::here();
        let points = columns().unwrap().iter();
        let points = points.flat_map(|column| column.cells.iter().map(|cell| (column.q, *cell)));
        for (q, (lambda0, found)) in points.step_by(997) {
            let start = DriveState {
                phi: random.uniform(0.0, 6.0),
                w: random.uniform(-3.0, 3.0),
            };
            let friction = Friction::new(lambda0, q * lambda0).unwrap();
            let attractor = attractor_from(start, friction).unwrap();
            let again = own_digits(attractor.intervals());
            assert_eq!(again, found, "q = {q}, λ₀ = {lambda0}");
        }
    }
}
