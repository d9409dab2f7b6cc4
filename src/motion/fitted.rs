//! Accelerations that are known by their values alone: from a function, or from a table such as an accelerometer's.

use super::acceleration::{Acceleration, Coefficients};
use crate::numerics::piecewise::{Piecewise, PiecewiseError};
use crate::numerics::taylor::TERMS;
use std::f64::consts::TAU;

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
    /// A function that even in a very short time is no polynomial.
    #[error(
        "the acceleration cannot be resolved near t = {t}: list every jump and kink among the breaks"
    )]
    Unresolved {
        /// When.
        t: f64,
    },
    /// A line of a file that is no row of numbers.
    #[error("line {line} is no row of a time and one or two numbers: `{text}`")]
    Line {
        /// Its number, from 1.
        line: usize,
        /// What stands there.
        text: String,
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

/// A(t) as a chain of polynomials, on a range of times; outside it has no value, and a motion that gets there is an error.
///
/// ```
/// use slipbook::motion::{Fitted, State, run};
///
/// let shaken = Fitted::from_fn(|t| [(3.0 * t).sin() * (-0.1 * t).exp(), 0.0], [0.0, 20.0], &[])?;
/// assert!(shaken.error() < 1e-13);
/// let start = State { t: 0.0, v: [0.0; 2], x: [0.0; 2] };
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

/// A polynomial in the time since `from`, which holds until the next part begins.
#[derive(Debug, Clone, PartialEq)]
struct Part {
    from: f64,
    powers: Vec<f64>,
}

impl Part {
    /// The coefficients about a later time.
    fn about(&self, t: f64) -> Coefficients {
        let s = t - self.from;
        let mut c = [0.0; TERMS];
        // Horner's scheme for the polynomial in (s + τ).
        for a in self.powers.iter().rev() {
            for k in (1..self.powers.len().min(TERMS)).rev() {
                c[k] = c[k] * s + c[k - 1];
            }
            c[0] = c[0] * s + a;
        }
        c
    }
}

/// Times between the ends at which a fit is held against its function.
const CHECKS: usize = 1000;
/// The fewest rows of a table: every second one has to make a spline too.
const LEAST_ROWS: usize = 7;
/// The largest value, whose products are still numbers.
const LARGEST: f64 = 1e50;

impl Fitted {
    /// From a function of the time to (A_x, A_y) in length/time², for times in `[from, to]`. `breaks` lists the times at
    /// which it jumps or has a kink. [`error`](Self::error) is measured: the largest difference from the function at a thousand
    /// other times.
    ///
    /// Asks the function some hundred times for each oscillation, at most some 10⁵ times.
    ///
    /// # Errors
    /// [`FitError`]: a range that is empty, a value that is not finite, a function that cannot be resolved.
    pub fn from_fn(
        function: impl Fn(f64) -> [f64; 2],
        [from, to]: [f64; 2],
        breaks: &[f64],
    ) -> Result<Self, FitError> {
        rise(from, to)?;
        let unit = (to - from) / TAU;
        let phases: Vec<_> = breaks
            .iter()
            .filter(|t| **t > from && **t < to)
            .map(|t| (t - from) / unit)
            .collect();
        let fit = |i: usize| -> Result<Vec<Part>, FitError> {
            let chain = Piecewise::fit(|phase| function(from + unit * phase)[i], &phases);
            let chain = chain.map_err(|error| match error {
                PiecewiseError::NotFinite { at, value } => FitError::Value {
                    t: from + unit * at,
                    value,
                },
                PiecewiseError::Unresolved { at } | PiecewiseError::Break { value: at } => {
                    FitError::Unresolved {
                        t: from + unit * at,
                    }
                }
            })?;
            let part = |piece: &crate::numerics::piecewise::Piece| {
                let mut power = 1.0;
                let powers = piece.coefficients().iter().map(|c| {
                    let c = c * power;
                    power /= unit;
                    c
                });
                Part {
                    from: from + unit * piece.start(),
                    powers: powers.collect(),
                }
            };
            Ok(chain.pieces().iter().map(part).collect())
        };
        let mut fitted = Self {
            components: [fit(0)?, fit(1)?],
            until: to,
            error: 0.0,
        };
        for k in 0..CHECKS {
            // Steps of the golden mean fall nowhere twice, and not on the nodes of the fit.
            let t = from + (to - from) * (0.5 + k as f64 * 0.618_033_988_749_894_9).fract();
            let (asked, found) = (function(t), fitted.coefficients(t));
            for i in 0..2 {
                fitted.error = fitted.error.max((asked[i] - found[i][0]).abs());
            }
        }
        Ok(fitted)
    }

    /// From a table of times and (A_x, A_y) in length/time², by cubic splines through all of it, natural at the ends.
    /// [`error`](Self::error) is an estimate from the table itself: the largest distance of a row that is left out from the
    /// spline through every second one. A spline through all is better, by sixteen where the table resolves the motion;
    /// noise of the instrument is in it as it is in the table.
    ///
    /// The work is proportional to the rows; so is that of a motion, which takes a step at least from row to row.
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

    /// From the text of a CSV file as an accelerometer writes it: t, A_x and, if there is a third column, A_y in each line;
    /// behind commas, semicolons, tabs or spaces. A first line of words is a head; empty lines and those that begin with `#`
    /// are passed over. All else is as for [`from_table`](Self::from_table).
    ///
    /// ```
    /// use slipbook::motion::Fitted;
    ///
    /// let file: String = (0..100).map(|k| format!("{},{}\n", 0.1 * f64::from(k), k % 7)).collect();
    /// let shaken = Fitted::from_csv(&format!("t,ax\n{file}"))?;
    /// # Ok::<(), slipbook::motion::FitError>(())
    /// ```
    ///
    /// # Errors
    /// [`FitError::Line`] for a line that is no row; and as for [`from_table`](Self::from_table).
    pub fn from_csv(text: &str) -> Result<Self, FitError> {
        let mut rows = Vec::new();
        let lines = text.trim_start_matches('\u{feff}').lines().enumerate();
        let lines = lines.filter(|(_, line)| !(line.trim().is_empty() || line.starts_with('#')));
        for (n, (line, text)) in lines.enumerate() {
            let cells = text.split([',', ';', '\t', ' ']).map(str::trim);
            let cells = cells.filter(|cell| !cell.is_empty());
            let numbers: Vec<Option<f64>> = cells.map(|cell| cell.parse().ok()).collect();
            match numbers[..] {
                [Some(t), Some(x)] => rows.push((t, [x, 0.0])),
                [Some(t), Some(x), Some(y)] => rows.push((t, [x, y])),
                _ if n == 0 && numbers.iter().all(Option::is_none) => {}
                _ => {
                    let (line, text) = (line + 1, text.to_owned());
                    return Err(FitError::Line { line, text });
                }
            }
        }
        Self::from_table(&rows)
    }

    /// The largest error of a component, in length/time²: measured for a function, estimated for a table.
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

/// The natural cubic spline through a component of the rows.
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
        // The end of all times is a break too: a step that passed it would trust the last polynomial beyond.
        let end = (t < self.until).then_some(self.until);
        [x, y, end].into_iter().flatten().reduce(f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{Plane, Signal, State, run};

    fn start() -> State {
        State {
            t: 0.0,
            v: [1.0, 0.5],
            x: [0.0; 2],
        }
    }

    /// A sine by its values moves a particle as the sine by its series does.
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
            let values = Fitted::from_fn(function, [from, from + 10.0], &[]).unwrap();
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

    /// Of either component, and of functions that need parts where the other one needs none.
    #[test]
    fn every_part_begins_at_a_break() {
        let [from, to] = [-4.0, 6.0];
        let quick = |t: f64| libm::sin(20.0 * t);
        let jump = |t: f64| if t < 1.0 { 0.5 } else { -0.5 };
        let of = |function: &dyn Fn(f64) -> [f64; 2], breaks: &[f64]| {
            Fitted::from_fn(function, [from, to], breaks).unwrap()
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

    /// Where the time is not the phase of the fit.
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
                let refused = Fitted::from_fn(none, [from, to], &[]).unwrap_err();
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
        let listed = Fitted::from_fn(jump, [0.0, 3.0], &[1.0]).unwrap();
        assert_eq!(listed.error(), 0.0);
        let refused = Fitted::from_fn(jump, [0.0, 3.0], &[]).unwrap_err();
        assert!(matches!(refused, FitError::Unresolved { t } if (t - 1.0).abs() < 1e-6));
        assert!(Fitted::from_fn(jump, [1.0, 1.0], &[]).is_err());
        assert!(Fitted::from_fn(|_| [f64::NAN, 0.0], [0.0, 1.0], &[]).is_err());
        // Beyond its times there is no motion.
        assert!(run(&listed, 0.1, start(), 4.0).is_err());
    }

    /// Where the rows lie unevenly too, slope and curvature of the spline are continuous.
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

    /// The stated error is no smaller than the true one, and falls as a spline's does.
    #[test]
    fn a_table_states_its_error() {
        let function = |t: f64| [libm::sin(2.0 * t), libm::cos(t)];
        let of = |rows: u32| {
            let times = (0..=rows).map(|k| 6.0 * f64::from(k) / f64::from(rows));
            // Natural at the ends as the first component is at t = 0; the second is not.
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

    #[test]
    fn a_file_is_read_as_its_rows() {
        let rows: Vec<_> = (0..20)
            .map(|k| 0.1 * f64::from(k))
            .map(|t| (t, [libm::sin(t), 0.0]))
            .collect();
        let table = Fitted::from_table(&rows).unwrap();
        for (head, between) in [
            ("", ","),
            ("t,ax\n", ","),
            ("\u{feff}time;a\n", "; "),
            ("# g\n\n", "\t"),
        ] {
            let lines = rows
                .iter()
                .map(|(t, [x, _])| format!("{t}{between}{x}\r\n"));
            let text = head.to_owned() + &lines.collect::<String>();
            assert_eq!(Fitted::from_csv(&text).as_ref(), Ok(&table), "{head}");
        }
        for (text, line) in [
            ("t,a\n1,2\n3,x\n", 3),
            ("1\n", 1),
            ("1,2,3,4\n", 1),
            ("t,a\nt,a\n", 2),
        ] {
            let refused = Fitted::from_csv(text).unwrap_err();
            assert!(
                matches!(refused, FitError::Line { line: of, .. } if of == line),
                "{refused}"
            );
        }
        assert!(matches!(
            Fitted::from_csv(""),
            Err(FitError::Rows { rows: 0, .. })
        ));
    }

    /// A jolt in the last row alone, of an even and of an odd number. The spline through every second row and the last is
    /// known from its tridiagonal system; of the rows left out it misses the last but one most.
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
    fn the_columns_of_a_file_are_t_and_x_and_y() {
        let file: String = (0..9).map(|k| format!("{k},{},{}\n", 3 * k, -k)).collect();
        let [x, y] = Fitted::from_csv(&file).unwrap().coefficients(2.5);
        assert!((x[0] - 7.5).abs() < 1e-14 && (y[0] + 2.5).abs() < 1e-14);
    }
}
