//! Accelerations that are known by their values alone: from a function, or from a table such as an accelerometer's.

mod cells;
mod csv;
mod peer;
mod when;

pub use cells::Columns;
pub(crate) use cells::G;
pub use csv::Recording;

use super::acceleration::Acceleration;
use crate::numerics::{
    piecewise::interpolate,
    taylor::{Coefficients, TERMS},
};
use std::cell::Cell;

/// Why values make no acceleration.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
    /// The range of times is empty or not finite.
    #[error("the times must be finite and rise, but one goes from {from} to {to}")]
    Times {
        /// A time,
        from: f64,
        /// and what is to come after it.
        to: f64,
    },
    /// A value is not finite.
    #[error("every value must be finite, at most 1e50 in size, but one is {value} at t = {t}")]
    Value {
        /// When.
        t: f64,
        /// The value.
        value: f64,
    },
    /// A width of which there are too many in the range, or that the times can hardly tell apart.
    #[error("width = {width} must be at least {least} for these times")]
    Width {
        /// What was given.
        width: f64,
        /// The least.
        least: f64,
    },
    /// A function that even in a very short time is no polynomial.
    #[error(
        "the acceleration cannot be resolved near t = {t}: list every jump and kink among the breaks; noise has no polynomials"
    )]
    Unresolved {
        /// When.
        t: f64,
    },
    /// Too many oscillations.
    #[error(
        "the acceleration needs more than {most} polynomials, which came to t = {t}: take a shorter time"
    )]
    Parts {
        /// How many are allowed.
        most: usize,
        /// When they were used up.
        t: f64,
    },
    /// A line of a file that cannot be read, or could be read in two ways.
    #[error("line {line}: {why}: `{text}`")]
    Line {
        /// Its number, from 1.
        line: usize,
        /// What stands there.
        text: String,
        /// What is wrong with it.
        why: &'static str,
    },
    /// Too few rows.
    #[error("a table needs at least {least} rows, this one has {rows}")]
    Rows {
        /// How many are needed.
        least: usize,
        /// How many there are.
        rows: usize,
    },
}

/// A(t) as a chain of polynomials, on a range of [times](Self::times); a motion that leaves it is a
/// [`MotionError::Outside`](super::MotionError::Outside).
///
/// ```
/// use slipbook_motion::{Fitted, State, run};
///
/// let shaken = Fitted::from_fn(|t| [(3.0 * t).sin() * (-0.1 * t).exp(), 0.0], [0.0, 20.0], 0.1, &[])?;
/// assert!(shaken.error() < 1e-13);
/// let start = State::moving([0.0; 2]);
/// let motion = run(&shaken, 0.5, start, 20.0)?;
/// assert!(motion.first_stop().is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    components: [Vec<Part>; 2],
    until: f64,
    error: f64,
}

/// In the time since `from`, until the next part begins.
#[derive(Debug, Clone, PartialEq)]
struct Part {
    from: f64,
    powers: Vec<f64>,
}

impl Part {
    fn value(&self, t: f64) -> f64 {
        let s = t - self.from;
        self.powers.iter().rev().fold(0.0, |sum, a| sum * s + a)
    }

    fn about(&self, t: f64) -> Coefficients {
        let s = t - self.from;
        let mut c = [0.0; TERMS];
        for a in self.powers.iter().rev() {
            for k in (1..self.powers.len().min(TERMS)).rev() {
                c[k] = c[k] * s + c[k - 1];
            }
            c[0] = c[0] * s + a;
        }
        c
    }
}

/// As a part of the range: the function is asked some ten times in each.
const NARROWEST: f64 = 1e-7;
/// As a part of the largest time: tens of thousands of numbers.
const SHORTEST: f64 = 65_536.0 * f64::EPSILON;
const MOST_PARTS: usize = 1 << 16;
/// Times at which a range without breaks is surveyed, and a part is held against its function.
const SURVEY: f64 = 64.0;
const CHECKS: f64 = 4.0;
/// Where the rounding of t·dA/dt is as large as that of A is allowed to be.
const ROUNDING: f64 = 0.25;
/// As a part of the largest value, however steep the function.
const LOOSEST: f64 = 1e-4;
/// Every second one has to make a spline too.
const LEAST_ROWS: usize = 7;
/// Its products are still numbers.
const LARGEST: f64 = 1e50;

impl Fitted {
    /// From a function of the time to the plane's acceleration (A_x, A_y) in length/time² ([pulled](super) is the other way), for times in `[from, to]`. `breaks` lists the times at
    /// which it jumps or has a kink.
    ///
    /// `width` is how long the shortest pulse lasts, from its beginning to its end: the function is asked, and the fit held
    /// against it, at least once in each half of it, from break to break. A shorter pulse may lie between, unless breaks enclose
    /// it.
    ///
    /// [`error`](Self::error) is measured at all these times. No part misses a component by more than 4·10⁻¹⁵ (max |A| + t max
    /// |dA/dt|): its rounding, and that of t and of the phases in which t is multiplied.
    ///
    /// Asks the function some ten times in each `width` and some hundred times for each oscillation.
    ///
    /// # Errors
    /// [`FitError`]: a range that is empty, a `width` below 10⁻⁷ of it or 1.5·10⁻¹¹ of the times, a value that is not finite; a
    /// function that cannot be fitted within the error above and 10⁻⁴ max |A|, or by no more than 65,536 polynomials.
    pub fn from_fn(
        function: impl Fn(f64) -> [f64; 2],
        [from, to]: [f64; 2],
        width: f64,
        breaks: &[f64],
    ) -> Result<Self, FitError> {
        rise(from, to)?;
        let shortest = SHORTEST * from.abs().max(to.abs());
        let least = shortest.max(NARROWEST * (to - from));
        if width.is_nan() || width < least || width <= 0.0 {
            return Err(FitError::Width { width, least });
        }
        let inside = |t: &&f64| **t - from > shortest && to - **t > shortest;
        let mut edges: Vec<_> = breaks.iter().filter(inside).copied().collect();
        edges.sort_by(f64::total_cmp);
        edges.dedup_by(|later, earlier| *later - *earlier <= shortest);
        edges.insert(0, from);
        edges.push(to);
        let value = |t| {
            let values = function(t);
            match values.iter().find(|x| x.is_nan() || x.abs() > LARGEST) {
                Some(&value) => Err(FitError::Value { t, value }),
                None => Ok(values),
            }
        };
        let (mut sizes, mut slopes) = ([0.0_f64; 2], [0.0_f64; 2]);
        for edge in edges.windows(2) {
            let mut before: Option<(f64, [f64; 2])> = None;
            for t in times([edge[0], edge[1]], width, SURVEY, shortest) {
                let values = value(t)?;
                for i in 0..2 {
                    sizes[i] = sizes[i].max(values[i].abs());
                    if let Some((earlier, before)) = before {
                        let slope = (values[i] - before[i]).abs() / (t - earlier);
                        slopes[i] = slopes[i].max(slope);
                    }
                }
                before = Some((t, values));
            }
        }
        let mut error = 0.0_f64;
        let mut fit = |i: usize| {
            let component = |t| Ok(value(t)?[i]);
            let (parts, missed) = chain(component, &edges, width, [sizes[i], slopes[i]])?;
            error = error.max(missed);
            Ok(parts)
        };
        Ok(Self {
            components: [fit(0)?, fit(1)?],
            until: to,
            error,
        })
    }

    /// From a table of times and the plane's acceleration (A_x, A_y) in length/time², by cubic splines through all of it, natural
    /// at the ends. [`error`](Self::error) is an estimate from the table itself: the largest distance of a row that is left out
    /// from the spline through every second one. A spline through all is better, by sixteen where the table resolves the motion.
    /// Noise across the drive is a drive too: a particle then hardly ever comes to v = 0.
    ///
    /// The work is proportional to the rows; a motion takes a step at least from row to row.
    ///
    /// # Errors
    /// [`FitError`]: fewer than seven rows, times that do not rise, values that are not finite.
    pub fn from_table(rows: &[(f64, [f64; 2])]) -> Result<Self, FitError> {
        if rows.len() < LEAST_ROWS {
            let rows = rows.len();
            return Err(FitError::Rows {
                least: LEAST_ROWS,
                rows,
            });
        }
        for pair in rows.windows(2) {
            rise(pair[0].0, pair[1].0)?;
        }
        for (t, values) in rows {
            if let Some(&value) = values.iter().find(|x| x.is_nan() || x.abs() > LARGEST) {
                return Err(FitError::Value { t: *t, value });
            }
        }
        let mut half: Vec<_> = rows.iter().copied().step_by(2).collect();
        if rows.len().is_multiple_of(2) {
            half.extend(rows.last());
        }
        let (mut fitted, half) = (Self::spline(rows), Self::spline(&half));
        for (t, values) in rows.iter().skip(1).step_by(2) {
            let found = half.coefficients(*t);
            for i in 0..2 {
                fitted.error = fitted.error.max((values[i] - found[i][0]).abs());
            }
        }
        Ok(fitted)
    }

    /// From the text of a CSV file, such as an accelerometer's: a line for each time, with its cells behind semicolons, tabs,
    /// bars, commas or spaces, of which the first that is in the first line counts; titles may stand before it. Each cell is read right, or its line refused.
    ///
    /// - A head, with its units or with a line of units below, names the columns. The time is called t or time, or has a unit of
    ///   time: s, ms, us, ns, min or h. Without a unit it is in s, if it goes on by a second at most; of several times one that is said to be in
    ///   s counts.
    /// - A column is the acceleration if its name says so (a word that begins with acc or has accel in it, a, or g-force; with the
    ///   axis, as in ax, acc_x, “Linear Acceleration x”) or its unit does: m/s², also of mm, cm, km, ft, in; g or mg behind a mere
    ///   axis. Along x, along y, one each, or along no axis: that is A_x. It is turned into m/s², which it is without a unit, up
    ///   to 200: larger numbers are counts, and 1 along z is likely to be in g, so their unit has to be given.
    /// - All other columns are passed over: velocities, angular ones, fields, x and y without a unit. So are, whatever their unit,
    ///   a size, an error, the pull of gravity. Where none is left, or two are the same, the file is refused: see
    ///   [`from_csv_with`](Self::from_csv_with).
    /// - Without a head a line is t, A_x and, if there is a third number, A_y, in units of your choice. A remark `# t ax ay` is a head.
    /// - The decimal sign is one for all numbers: a point or, where commas do not separate, a comma. There are none for thousands.
    /// - Lines have the same number of cells, those that are read are finite numbers, and the times rise. Those of the clock, as
    ///   10:30:05.25 or 10:30:05:250, also behind a date as 2026-01-31 or 31-Jan-2026, become seconds since the first.
    /// - A line in which no acceleration has a value, but another column has, is that of another sensor, and passed over; so are
    ///   lines without values at the end. A step of more than eight usual ones is a gap, and refused.
    /// - Quotes around cells, a byte order mark and a first line `sep=;` are understood; empty lines and those that begin with
    ///   `#` are passed over.
    ///
    /// So all formats of phyphox are read, and of PEER's records (`.AT2`) both, which are along x. A sensor that lies on the plane measures the A of [`Acceleration`], with its sign. All
    /// else is as for [`from_table`](Self::from_table).
    ///
    /// ```
    /// use slipbook_motion::Fitted;
    ///
    /// let file: String = (0..100).map(|k| format!("{};{}\n", 0.1 * f64::from(k), k % 7)).collect();
    /// let shaken = Fitted::from_csv(&format!("Time (s);Acceleration x (m/s^2)\n{file}"))?;
    /// assert!(Fitted::from_csv(&format!("t;v_x\n{file}")).is_err());
    /// # Ok::<(), slipbook_motion::FitError>(())
    /// ```
    ///
    /// # Errors
    /// [`FitError::Line`] for the first line that cannot be read, or could be read in two ways; and as for
    /// [`from_table`](Self::from_table).
    pub fn from_csv(text: &str) -> Result<Self, FitError> {
        Self::from_csv_with(text, &Columns::default())
    }

    /// As [`from_csv`](Self::from_csv), with columns and units of your choice where `columns` has them: what a column is called
    /// is then no longer asked, though a unit in its head has to be one of acceleration, or of time, unless it is given too. Gaps are bridged if asked for.
    ///
    /// ```
    /// use slipbook_motion::{Columns, Fitted};
    ///
    /// let file: String = (0..100).map(|k| format!("{k},{},9.8,{},0\n", 0.01 * f64::from(k), k % 7)).collect();
    /// let file = format!("time,seconds_elapsed,z,y,x\n{file}");
    /// assert!(Fitted::from_csv(&file).is_err());
    /// let columns = Columns { x: Some("x"), y: Some("y"), ..Columns::default() };
    /// assert_eq!(Fitted::from_csv_with(&file, &columns)?.times(), [0.0, 0.99]);
    /// # Ok::<(), slipbook_motion::FitError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`from_csv`](Self::from_csv); [`FitError::Line`] with the head's line for a column or a unit that there is not.
    pub fn from_csv_with(text: &str, columns: &Columns) -> Result<Self, FitError> {
        Self::from_table(&csv::rows(text, columns)?)
    }

    /// The first and the last time at which it is known.
    pub fn times(&self) -> [f64; 2] {
        [self.components[0][0].from, self.until]
    }

    pub(crate) fn is_along_x(&self) -> bool {
        let mut powers = self.components[1].iter().flat_map(|part| &part.powers);
        powers.all(|a| *a == 0.0)
    }

    /// Of a component, in length/time²: measured for a function, estimated for a table.
    pub fn error(&self) -> f64 {
        self.error
    }

    fn spline(rows: &[(f64, [f64; 2])]) -> Self {
        Self {
            components: [0, 1].map(|i| spline(rows, i)),
            until: rows.last().map_or(f64::NAN, |row| row.0),
            error: 0.0,
        }
    }
}

fn rise(from: f64, to: f64) -> Result<(), FitError> {
    let fit = from < to && (to - from).is_finite();
    fit.then_some(()).ok_or(FitError::Times { from, to })
}

/// No farther apart than half the width, at least so many; the outer ones are some numbers off the ends, where a jump may be.
fn times([a, b]: [f64; 2], width: f64, least: f64, shortest: f64) -> impl Iterator<Item = f64> {
    let n = (2.0 * (b - a) / width).ceil().max(least);
    let off = shortest.min(b - a) / 1024.0;
    (0..=n as usize).map(move |k| (a + (b - a) * (k as f64 / n)).clamp(a + off, b - off))
}

/// Between the edges, for a component of about this size and slope; and by how much they miss it.
fn chain(
    function: impl Fn(f64) -> Result<f64, FitError>,
    edges: &[f64],
    width: f64,
    [size, slope]: [f64; 2],
) -> Result<(Vec<Part>, f64), FitError> {
    let size = Cell::new(size);
    let shortest = SHORTEST * edges[0].abs().max(edges[edges.len() - 1].abs());
    let asked = |t| {
        let value: f64 = function(t)?;
        size.set(size.get().max(value.abs()));
        Ok(value)
    };
    let mut pending: Vec<_> = edges
        .windows(2)
        .rev()
        .map(|edge| [edge[0], edge[1]])
        .collect();
    let (mut parts, mut error) = (Vec::new(), 0.0_f64);
    while let Some([a, b]) = pending.pop() {
        let largest = a.abs().max(b.abs());
        // Where waves annul each other, the slope is less than that of which the rounding is left.
        let rounded = size.get() + ROUNDING * largest * slope;
        let fit = interpolate(&asked, [a, b], rounded, f64::EPSILON * largest)?;
        let part = Part {
            from: a,
            powers: fit.coefficients,
        };
        let mut met = fit.resolved && fit.tolerance <= LOOSEST * size.get();
        let mut missed = 0.0_f64;
        for t in times([a, b], width, CHECKS, shortest) {
            if !met {
                break;
            }
            missed = missed.max((asked(t)? - part.value(t)).abs());
            met = missed <= fit.tolerance;
        }
        if met {
            parts.push(part);
            error = error.max(missed);
        } else if b - a < shortest {
            return Err(FitError::Unresolved { t: a });
        } else if parts.len() + pending.len() > MOST_PARTS {
            let most = MOST_PARTS;
            return Err(FitError::Parts { most, t: a });
        } else {
            let middle = a + 0.5 * (b - a);
            pending.extend([[middle, b], [a, middle]]);
        }
    }
    Ok((parts, error))
}

/// Natural and cubic, through a component of the rows.
fn spline(rows: &[(f64, [f64; 2])], i: usize) -> Vec<Part> {
    let n = rows.len();
    let step = |k: usize| rows[k + 1].0 - rows[k].0;
    let slope = |k: usize| (rows[k + 1].1[i] - rows[k].1[i]) / step(k);
    // Half the second derivatives m at the rows, from a tridiagonal system that elimination solves.
    let (mut above, mut right) = (vec![0.0; n], vec![0.0; n]);
    for k in 1..n - 1 {
        let (h, next) = (step(k - 1), step(k));
        let pivot = 2.0 * (h + next) - h * above[k - 1];
        above[k] = next / pivot;
        right[k] = (3.0 * (slope(k) - slope(k - 1)) - h * right[k - 1]) / pivot;
    }
    let mut m = vec![0.0; n];
    for k in (1..n - 1).rev() {
        m[k] = right[k] - above[k] * m[k + 1];
    }
    (0..n - 1)
        .map(|k| {
            let h = step(k);
            let first = slope(k) - h * (2.0 * m[k] + m[k + 1]) / 3.0;
            let third = (m[k + 1] - m[k]) / (3.0 * h);
            Part {
                from: rows[k].0,
                powers: vec![rows[k].1[i], first, m[k], third],
            }
        })
        .collect()
}

impl Acceleration for Fitted {
    fn coefficients(&self, t: f64) -> [Coefficients; 2] {
        [0, 1].map(|i| {
            let parts = &self.components[i];
            match parts.partition_point(|part| part.from <= t).checked_sub(1) {
                Some(k) if t < self.until => parts[k].about(t),
                _ => [f64::NAN; TERMS],
            }
        })
    }

    fn next_break(&self, t: f64) -> Option<f64> {
        let next = |parts: &Vec<Part>| {
            let k = parts.partition_point(|part| part.from <= t);
            parts.get(k).map(|part| part.from)
        };
        let [x, y] = [0, 1].map(|i| next(&self.components[i]));
        // The end of all times is a break too, or a step would trust the last polynomial beyond it.
        let end = (t < self.until).then_some(self.until);
        [x, y, end].into_iter().flatten().reduce(f64::min)
    }

    fn times(&self) -> [f64; 2] {
        self.times()
    }

    fn pieces(&self) -> usize {
        self.components.iter().map(Vec::len).sum()
    }

    fn error(&self) -> f64 {
        self.error
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::{MotionError, Plane, Signal, State, run, run_to_stop};

    /// With noise: a slip may begin and end every few rows.
    pub(crate) fn noisy(from: f64, rows: u32, seed: u64) -> Fitted {
        let mut state = seed;
        let mut random = || {
            state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(1);
            (state >> 40) as f64 / f64::from(1 << 24)
        };
        let mut noise = || 0.1 * (random() + random() + random() + random() - 2.0);
        let rows = (0..rows).map(|k| {
            let t = 0.002 * f64::from(k);
            (from + t, [3.0 * libm::sin(4.4 * t) + noise(), noise()])
        });
        Fitted::from_table(&rows.collect::<Vec<_>>()).unwrap()
    }

    fn start() -> State {
        State::moving([1.0, 0.5])
    }

    #[test]
    fn a_function_moves_a_particle_as_its_series_does() {
        for ([x, y], from) in [
            ([2.0, 0.0], 0.0),
            ([0.0, 2.0], 0.0),
            ([1.0, -2.0], -3.0),
            ([0.0, -2.0], 7.5),
        ] {
            let sine = Signal::Sine {
                frequency: 3.0,
                phase: 0.25,
            };
            let series = Plane::along([x, y], sine);
            let function = |t: f64| [x, y].map(|a| a * libm::sin(3.0 * t + 0.25));
            let values = Fitted::from_fn(function, [from, from + 10.0], 0.1, &[]).unwrap();
            assert!(values.error() < 1e-14 * 2.0 * 20.0, "{}", values.error());
            let start = State { t: from, ..start() };
            let [exact, found] = [&series as &dyn Acceleration, &values]
                .map(|plane| run(plane, 0.5, start, from + 10.0).unwrap());
            for later in [1.0, 3.5, 7.0, 10.0] {
                let [a, b] = [&exact, &found].map(|motion| motion.at(from + later).unwrap());
                for i in 0..2 {
                    assert!((a.v[i] - b.v[i]).abs() < 1e-11, "{later}: {a:?} {b:?}");
                }
            }
        }
    }

    #[test]
    fn every_part_begins_at_a_break() {
        let [from, to] = [-4.0, 6.0];
        let quick = |t: f64| libm::sin(20.0 * t);
        let jump = |t: f64| if t < 1.0 { 0.5 } else { -0.5 };
        let of = |function: &dyn Fn(f64) -> [f64; 2], breaks: &[f64]| {
            Fitted::from_fn(function, [from, to], 0.1, breaks).unwrap()
        };
        for fitted in [
            of(&|t| [quick(t), 1.0], &[]),
            of(&|t| [1.0, quick(t)], &[]),
            of(&|t| [jump(t), quick(t)], &[1.0]),
            of(&|t| [quick(t), jump(t)], &[1.0]),
        ] {
            let begins = fitted.components.iter().flatten().map(|part| part.from);
            let mut expected: Vec<_> = begins.filter(|t| *t > from).chain([to]).collect();
            expected.sort_by(f64::total_cmp);
            expected.dedup();
            assert!(expected.len() > 10);
            let breaks = std::iter::successors(Some(from), |t| fitted.next_break(*t));
            assert_eq!(breaks.skip(1).collect::<Vec<_>>(), expected);
        }
    }

    #[test]
    fn an_error_names_the_time() {
        for (from, to, at) in [(20.0, 28.0, 23.0), (-7.0, -1.0, -2.0), (0.0, 100.0, 60.0)] {
            for i in 0..2 {
                let along = |x: f64| {
                    let mut a = [1.0; 2];
                    a[i] = x;
                    a
                };
                let none = |t: f64| along(if t < at { 1.0 } else { f64::NAN });
                let refused = Fitted::from_fn(none, [from, to], 0.1, &[]).unwrap_err();
                assert!(
                    matches!(refused, FitError::Value { t, value } if value.is_nan() && (at..=to).contains(&t)),
                    "{refused}"
                );
            }
        }
    }

    #[test]
    fn a_jump_is_listed_or_refused() {
        let jump = |t: f64| [if t < 1.0 { 1.0 } else { -1.0 }, 0.0];
        let listed = Fitted::from_fn(jump, [0.0, 3.0], 0.1, &[1.0]).unwrap();
        assert_eq!(listed.error(), 0.0);
        let refused = Fitted::from_fn(jump, [0.0, 3.0], 0.1, &[]).unwrap_err();
        assert!(matches!(refused, FitError::Unresolved { t } if (t - 1.0).abs() < 1e-6));
        assert!(Fitted::from_fn(jump, [1.0, 1.0], 0.1, &[]).is_err());
        assert!(Fitted::from_fn(|_| [f64::NAN, 0.0], [0.0, 1.0], 0.1, &[]).is_err());
        for (from, until, told) in [(0.0, 4.0, 4.0), (-1.0, 2.0, -1.0), (5.0, 5.0, 5.0)] {
            let start = State { t: from, ..start() };
            let outside = MotionError::Outside {
                t: told,
                from: 0.0,
                to: 3.0,
            };
            assert_eq!(run(&listed, 0.1, start, until), Err(outside));
        }
        let slow = State::moving([-0.1, 0.0]);
        assert!(run_to_stop(&listed, 1.0, slow, 9.0).is_ok());
        assert!(run_to_stop(&listed, 0.1, start(), 9.0).is_err());
    }

    #[test]
    fn a_spline_is_smooth() {
        let times = [0.0, 0.1, 0.5, 0.6, 1.7, 2.0, 3.1, 3.2, 4.0];
        let rows = times.map(|t| (t, [libm::sin(2.0 * t), libm::cos(t)]));
        let fitted = Fitted::from_table(&rows).unwrap();
        for t in &times[1..8] {
            let [before, after] = [t - 1e-9, *t].map(|t| fitted.coefficients(t));
            for i in 0..2 {
                for k in 0..3 {
                    assert!((before[i][k] - after[i][k]).abs() < 1e-7, "{t}: {i}, {k}");
                }
            }
        }
    }

    #[test]
    fn a_table_states_its_error() {
        let function = |t: f64| [libm::sin(2.0 * t), libm::cos(t)];
        let of = |rows: u32| {
            let times = (0..=rows).map(|k| 6.0 * f64::from(k) / f64::from(rows));
            let rows: Vec<_> = times.map(|t| (t, function(t))).collect();
            Fitted::from_table(&rows).unwrap()
        };
        let mut last = f64::INFINITY;
        for rows in [20, 40, 80, 160] {
            let fitted = of(rows);
            let off = |k: u32| {
                let t = 6.0 * f64::from(k) / 997.0;
                let (found, right) = (fitted.coefficients(t), function(t));
                (0..2)
                    .map(|i| (found[i][0] - right[i]).abs())
                    .fold(0.0, f64::max)
            };
            let worst = (0..997).map(off).fold(0.0, f64::max);
            assert!(
                worst <= fitted.error(),
                "{rows}: {worst} {}",
                fitted.error()
            );
            assert!(fitted.error() < 0.5 * last, "{rows}");
            last = fitted.error();
        }
        let straight: Vec<_> = (0..9)
            .map(|k| (f64::from(k * k), [f64::from(3 * k * k), 1.0]))
            .collect();
        assert!(Fitted::from_table(&straight).unwrap().error() < 1e-13);
        assert!(Fitted::from_table(&straight[..6]).is_err());
        let back: Vec<_> = straight.iter().rev().copied().collect();
        assert!(Fitted::from_table(&back).is_err());
    }

    /// The spline through every second row and the last is known from its tridiagonal system; of the rows left out it misses the
    /// last but one most.
    #[test]
    fn the_last_row_is_among_those_that_tell_the_error() {
        for (rows, error) in [(8, 33.0 / 164.0), (9, 179.0 / 448.0)] {
            for i in 0..2 {
                let jolt = |k: i32| {
                    let mut values = [0.0; 2];
                    values[i] = f64::from(u8::from(k == rows - 1));
                    (f64::from(k), values)
                };
                let table: Vec<_> = (0..rows).map(jolt).collect();
                let stated = Fitted::from_table(&table).unwrap().error();
                assert!((stated - error).abs() < 1e-15, "{rows} {i}: {stated}");
            }
        }
    }

    #[test]
    fn a_file_is_the_table_of_its_rows() {
        let rows: Vec<_> = (0..9)
            .map(|k| (f64::from(k), [f64::from(3 * k), -f64::from(k)]))
            .collect();
        let file: String = rows
            .iter()
            .map(|(t, [x, y])| format!("{t};{x};{y}\n"))
            .collect();
        assert_eq!(Fitted::from_csv(&file), Fitted::from_table(&rows));
        assert!(matches!(
            Fitted::from_csv(""),
            Err(FitError::Rows { rows: 0, .. })
        ));
    }

    /// With a single pulse; where the block comes to, from the antiderivatives by hand with 25 digits.
    #[test]
    fn a_short_pulse_in_a_long_record_moves_a_block() {
        let moved =
            |pull: &dyn Fn(f64) -> f64, until: f64, width: f64, breaks: &[f64], friction: f64| {
                let fitted =
                    Fitted::from_fn(|t| [-pull(t), 0.0], [0.0, until], width, breaks).unwrap();
                let rest = State::moving([0.0; 2]);
                let motion = run(&fitted, friction, rest, until).unwrap();
                (
                    motion.starts().first().copied().unwrap_or(f64::NAN),
                    motion.end().x[0],
                )
            };
        let bell = |height: f64, at: f64, w: f64| {
            move |t: f64| height * libm::exp(-((t - at) / w).powi(2))
        };
        for (w, way) in [
            (0.1, 15.289_779_591_456_9),
            (0.03, 15.569_543_542_260_8),
            (0.01, 15.658_210_674_777_5),
            (0.001, 15.702_305_900_159_1),
        ] {
            for at in [29.0, 30.0, 30.000_123] {
                let (_, found) = moved(&bell(1.0 / w, at, w), 60.0, w, &[], 0.1);
                assert!((found - way).abs() < 1e-9, "{w} {at}: {found}");
            }
        }
        let (_, found) = moved(&bell(50.0, 4.0, 0.01), 10.0, 0.01, &[], 3.0);
        assert!((found - 0.113_711_199_76).abs() < 1e-10, "{found}");
        let sine = |t: f64| {
            if (4.0..4.02).contains(&t) {
                -50.0 * libm::sin(std::f64::consts::PI * (t - 4.0) / 0.02)
            } else {
                0.0
            }
        };
        for width in [0.02, 2.0] {
            let (start, found) = moved(&sine, 10.0, width, &[4.0, 4.02], 3.0);
            assert!((start - 4.000_382_201_418_6).abs() < 1e-10, "{start}");
            assert!((found + 0.061_302_861_715_8).abs() < 1e-10, "{found}");
        }
        let block = |t: f64| if (5.0..5.2).contains(&t) { 4.0 } else { 0.0 };
        let (start, found) = moved(&block, 60.0, 0.2, &[5.0, 5.2], 1.0);
        assert!(
            start == 5.0 && (found - 0.24).abs() < 1e-12,
            "{start} {found}"
        );
    }

    /// Smooth ones of exactly the width: alone, by twos, on waves, next to a break, and small beside what else there is.
    #[test]
    fn a_pulse_of_the_width_is_seen_wherever_it_lies() {
        let width = 0.05;
        let pulse = |u: f64| {
            if u.abs() < 1.0 {
                libm::exp(1.0 - 1.0 / (1.0 - u * u))
            } else {
                0.0
            }
        };
        let golden = |k: i32| (0.5 + f64::from(k) * 0.618_033_988_749_894_9).fract();
        let places = (0..40).map(|k| 0.025 + 9.95 * golden(k));
        for at in places.chain([0.025, 2.5, 4.975, 5.025, 9.975]) {
            for (wave, height) in [
                (0.0, 40.0),
                (0.0, 1e-6),
                (1.0, 1.0),
                (1.0, 1e-9),
                (-30.0, 1e-9),
            ] {
                for twin in [0.0, 0.06] {
                    let pulses = |t: f64| {
                        let u = (t - at) / (0.5 * width);
                        height * (pulse(u) - pulse(u - twin / (0.5 * width)))
                    };
                    let function = |t: f64| {
                        [
                            pulses(t),
                            wave * libm::sin(7.0 * t) + f64::from(u8::from(t < 5.0)) - pulses(t),
                        ]
                    };
                    let fitted = Fitted::from_fn(function, [0.0, 10.0], width, &[5.0]).unwrap();
                    for k in 1..50 {
                        let t = at + 0.5 * width * (0.04 * f64::from(k) - 1.0);
                        let (asked, found) = (function(t), fitted.coefficients(t));
                        let slope = 100.0 * height + 7.0 * wave.abs();
                        for (i, size) in [height, height + wave.abs() + 1.0].into_iter().enumerate()
                        {
                            let promised = 4e-15 * (size + 10.0 * slope);
                            let missed = (asked[i] - found[i][0]).abs();
                            assert!(
                                missed <= promised,
                                "{at} {wave} {height} {twin}: {missed} at {t}"
                            );
                            assert!(
                                fitted.error()
                                    <= 4e-15 * (size.max(1.0) + wave.abs() + height + 10.0 * slope)
                            );
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn a_box_that_is_not_listed_is_never_forgotten() {
        for k in 0..200 {
            let at = 59.0 * (0.5 + f64::from(k) * 0.618_033_988_749_894_9).fract();
            for last in [0.2, 0.3, 1.0] {
                let function = |t: f64| {
                    [
                        0.0,
                        if (at..at + last).contains(&t) {
                            1e-3
                        } else {
                            0.0
                        },
                    ]
                };
                let refused = Fitted::from_fn(function, [0.0, 60.0], 0.2, &[]).unwrap_err();
                let ends = [at, at + last];
                assert!(
                    matches!(refused, FitError::Unresolved { t } if ends.iter().any(|end| (t - end).abs() < 1e-6)),
                    "{refused}"
                );
            }
        }
    }

    #[test]
    fn long_waves_are_met_to_the_rounding_of_their_phase() {
        let turn = std::f64::consts::TAU;
        for (waves, until) in [
            (&[2.0][..], 3600.0),
            (&[100.0], 60.0),
            (&[10.0], 600.0),
            (&[2.0 * 1.5 / turn], 1e4),
            (&[50.0, 51.0], 60.0),
        ] {
            let sum = |t: f64| waves.iter().map(|f| libm::sin(turn * f * t)).sum::<f64>();
            let steepest = turn * waves.iter().sum::<f64>();
            let fitted =
                Fitted::from_fn(|t| [2.0 * sum(t), 0.0], [0.0, until], 0.2 / waves[0], &[])
                    .unwrap();
            assert!(
                fitted.error() <= 8e-15 * (2.0 + until * steepest),
                "{waves:?} {}",
                fitted.error()
            );
        }
        let quick = |t: f64| [0.0, libm::sin(1e4 * t)];
        let refused = Fitted::from_fn(quick, [0.0, 60.0], 1e-4, &[]).unwrap_err();
        assert!(matches!(refused, FitError::Parts { .. }), "{refused}");
        for width in [f64::NAN, 0.0, -1.0, 1e-9] {
            let refused = Fitted::from_fn(quick, [0.0, 1.0], width, &[]).unwrap_err();
            assert!(
                matches!(refused, FitError::Width { least: 1e-7, .. }),
                "{refused}"
            );
        }
        for [from, to] in [[1e9, 1e9 + 1e-6], [1e308, 1.7e308], [0.0, 1e-300]] {
            let jump = |t: f64| [f64::from(u8::from(t >= from + 0.6 * (to - from))), 0.0];
            let refused = Fitted::from_fn(jump, [from, to], f64::INFINITY, &[]);
            assert!(
                matches!(refused, Err(FitError::Unresolved { .. })),
                "{refused:?}"
            );
        }
        assert!(matches!(
            Fitted::from_fn(quick, [1e9, 1e9 + 1.0], 1e-3, &[]),
            Err(FitError::Width { .. })
        ));
    }

    #[test]
    fn a_motion_carries_the_error_of_its_drive() {
        let shaking = |t: f64| [2.0 * libm::sin(3.0 * t), libm::cos(2.0 * t)];
        let rows: Vec<_> = (0..=40)
            .map(|k| 0.25 * f64::from(k))
            .map(|t| (t, shaking(t)))
            .collect();
        let [exact, table] = [
            Fitted::from_fn(shaking, [0.0, 10.0], 0.1, &[]),
            Fitted::from_table(&rows),
        ]
        .map(|fitted| fitted.unwrap());
        let [right, found] = [&exact, &table].map(|plane| run(plane, 0.5, start(), 10.0).unwrap());
        assert_eq!(found.drive_error(), table.error());
        let mut largest = 0.0_f64;
        for k in 1..=100 {
            let t = 0.1 * f64::from(k);
            let [a, b] = [&right, &found].map(|motion| motion.at(t).unwrap());
            let off = libm::hypot(a.v[0] - b.v[0], a.v[1] - b.v[1]);
            largest = largest.max(off / (2.0_f64.sqrt() * found.drive_error() * t));
        }
        assert!((1e-4..=1.0).contains(&largest), "{largest}");
    }
}
