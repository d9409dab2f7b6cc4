//! The rows of a recording, free of what is known of the sensor's zeros.

use super::{
    LARGEST, LEAST_ROWS, MeasureError, Settings,
    pieces::{Line, Piece, cut},
};
use crate::fitted::Recording;

/// The latest time: after the year 2100, counted in seconds from 1970.
const LATEST: f64 = 1e10;
/// How long a stretch has to be quiet to be a rest, in s, and how many rows it has.
const QUIET: f64 = 0.25;
const QUIET_ROWS: usize = 16;

/// A recording, ready to be looked at.
pub struct Sensor {
    pub t: Vec<f64>,
    /// Along the floor.
    pub f: Vec<[f64; 2]>,
    /// N/m.
    pub n: Vec<f64>,
    /// |f|/N.
    pub ratio: Vec<f64>,
    /// Variance of the noise along an axis.
    pub noise: f64,
    /// Variance of what digits leave out of all rows alike, where noise does not blur them.
    pub digits: f64,
    /// How many axes there are.
    pub axes: f64,
    pub zeroed: bool,
    pub measured: bool,
    /// What has been taken off f since its zeros were known to this variance.
    pub shifted: [f64; 2],
    pub doubt: f64,
    /// The variance of the zero of N/m.
    pub doubt_across: f64,
}

impl Sensor {
    pub fn new(recording: &Recording, settings: &Settings) -> Result<Self, MeasureError> {
        let rows = recording.rows.len();
        if rows < LEAST_ROWS {
            let least = LEAST_ROWS;
            return Err(MeasureError::Rows { least, rows });
        }
        for (name, value) in [("g", settings.g), ("offset", settings.offset)] {
            if !(1e-3..=1e3).contains(&value) {
                let range = "between 0.001 and 1000";
                return Err(MeasureError::Setting { name, value, range });
            }
        }
        let t: Vec<_> = recording.rows.iter().map(|row| row.0).collect();
        let mut f: Vec<_> = recording.rows.iter().map(|row| row.1).collect();
        let normal = recording.normal.as_deref();
        let fit = |x: f64| x.abs() <= LARGEST;
        for k in 0..rows {
            let rises = t[k].abs() <= LATEST && (k == 0 || t[k - 1] < t[k]);
            let z = normal.is_none_or(|z| z.get(k).is_some_and(|z| fit(*z)));
            if !(rises && f[k].iter().all(|x| fit(*x)) && z) {
                return Err(MeasureError::Row { row: k + 1 });
            }
        }
        let axes = (0..2).filter(|i| f.iter().any(|f| f[*i] != 0.0)).count();
        let axes = axes.max(1) as f64;
        let windows = windows(&t, &f);
        let (noise, digit) = (noise(&windows, axes), digit(&f));
        let digits = if noise < 4.0 * digit { digit } else { 0.0 };
        let noise = noise.max(digit).max(1e-12);
        let g = settings.g;
        let rest = match settings.rest {
            Some([from, to]) => {
                let inside = |k: &usize| (from..=to).contains(&t[*k]);
                let rest: Vec<_> = (0..rows).filter(inside).collect();
                if rest.len() < QUIET_ROWS {
                    return Err(MeasureError::Rest { from, to });
                }
                rest
            }
            None => rests(&windows, noise, 0.05 * g),
        };
        let zeroed = !rest.is_empty();
        let mean = |of: &dyn Fn(usize) -> f64| {
            rest.iter().map(|k| of(*k)).sum::<f64>() / rest.len().max(1) as f64
        };
        // Most phones give gravity with the rest; some take it away.
        let mut sizes: Vec<_> = normal.unwrap_or(&[]).iter().map(|z| z.abs()).collect();
        let middle = sizes.len() / 2;
        let measured =
            !sizes.is_empty() && *sizes.select_nth_unstable_by(middle, f64::total_cmp).1 > 0.5 * g;
        let n = match normal.filter(|_| measured) {
            Some(z) => {
                let off = if zeroed {
                    mean(&|k| z[k].abs()) - g
                } else {
                    0.0
                };
                z.iter().map(|z| (z.abs() - off).max(0.1 * g)).collect()
            }
            None => vec![g; rows],
        };
        let zero = [mean(&|k| f[k][0]), mean(&|k| f[k][1])];
        f.iter_mut()
            .for_each(|f| *f = [f[0] - zero[0], f[1] - zero[1]]);
        // Where it was quiet for some windows, noise may still be correlated over a part of one.
        let doubt = if zeroed {
            4.0 * noise / rest.len() as f64 + digits
        } else {
            settings.offset * settings.offset
        };
        let mut sensor = Self {
            t,
            f,
            n,
            ratio: Vec::new(),
            noise,
            digits,
            axes,
            zeroed,
            measured,
            shifted: [0.0; 2],
            doubt,
            doubt_across: if measured { doubt } else { 0.0 },
        };
        sensor.shift([0.0; 2]);
        Ok(sensor)
    }

    /// Takes an offset off.
    pub fn shift(&mut self, offset: [f64; 2]) {
        for f in &mut self.f {
            *f = [f[0] - offset[0], f[1] - offset[1]];
        }
        self.shifted = [0, 1].map(|i| self.shifted[i] + offset[i]);
        let size = |(f, n): (&[f64; 2], &f64)| libm::hypot(f[0], f[1]) / n;
        self.ratio = self.f.iter().zip(&self.n).map(size).collect();
    }

    /// Straight pieces of the ratio.
    pub fn pieces(&self) -> Vec<Piece> {
        let mut n = self.n.clone();
        let middle = n.len() / 2;
        let n = *n.select_nth_unstable_by(middle, f64::total_cmp).1;
        let floor = self.noise / (n * n);
        let penalty = 4.0 * libm::log(self.t.len() as f64);
        cut(&self.t, &self.ratio, floor, penalty)
    }

    /// The line through the ratio of these rows.
    pub fn line(&self, from: usize, to: usize) -> Line {
        Line::through((from..to).map(|k| (self.t[k], self.ratio[k])))
    }

    /// The mean of f over these rows.
    pub fn mean(&self, from: usize, to: usize) -> [f64; 2] {
        let sum = self.f[from..to]
            .iter()
            .fold([0.0; 2], |sum, f| [sum[0] + f[0], sum[1] + f[1]]);
        sum.map(|sum| sum / (to - from) as f64)
    }
}

struct Window {
    from: usize,
    to: usize,
    lines: [Line; 2],
}

fn windows(t: &[f64], f: &[[f64; 2]]) -> Vec<Window> {
    let mean = (t[t.len() - 1] - t[0]) / (t.len() - 1) as f64;
    let rows = ((QUIET / mean) as usize).clamp(QUIET_ROWS, t.len());
    let window = |from: usize| {
        let to = from + rows;
        let line = |i: usize| Line::through((from..to).map(|k| (t[k], f[k][i])));
        let lines = [line(0), line(1)];
        Window { from, to, lines }
    };
    (0..t.len() / rows).map(|k| window(k * rows)).collect()
}

/// The variance of the noise, from the quietest tenth of the windows.
fn noise(windows: &[Window], axes: f64) -> f64 {
    let variance =
        |w: &Window| (w.lines[0].left() + w.lines[1].left()) / (axes * (w.lines[0].rows - 2.0));
    let mut all: Vec<_> = windows.iter().map(variance).collect();
    let tenth = all.len() / 10;
    let least = *all.select_nth_unstable_by(tenth, f64::total_cmp).1;
    // The tenth of χ², by Wilson and Hilferty.
    let free = axes * (windows[0].lines[0].rows - 2.0);
    let spread = 2.0 / (9.0 * free);
    let tenth = (1.0 - spread - 1.2816 * libm::sqrt(spread)).powi(3);
    least / tenth
}

/// The variance of a last digit.
fn digit(f: &[[f64; 2]]) -> f64 {
    let steps = f
        .windows(2)
        .flat_map(|pair| [0, 1].map(|i| (pair[1][i] - pair[0][i]).abs()));
    let least = steps
        .filter(|step| *step > 0.0)
        .fold(f64::INFINITY, f64::min);
    if least.is_finite() {
        least * least / 12.0
    } else {
        0.0
    }
}

/// The rows of quiet stretches with the same small mean: of the longest, and of all that agree with it.
fn rests(windows: &[Window], noise: f64, most: f64) -> Vec<usize> {
    // A stretch ends where its straight line is no longer level.
    let still = |lines: &[Line; 2]| {
        lines.iter().all(|line| {
            let quiet = line.variance() < 4.0 * noise;
            let level = line.slope().abs() * libm::sqrt(line.tt)
                < 3.0 * libm::sqrt(noise.max(line.variance()));
            quiet && level && line.y.abs() < most
        })
    };
    let mut found: Vec<(usize, usize, [Line; 2])> = Vec::new();
    let mut open = false;
    for window in windows.iter() {
        if !still(&window.lines) {
            open = false;
            continue;
        }
        if let Some((_, to, lines)) = found.last_mut().filter(|_| open) {
            let both = [0, 1].map(|i| lines[i].with(&window.lines[i]));
            if still(&both) {
                (*to, *lines) = (window.to, both);
                continue;
            }
        }
        found.push((window.from, window.to, window.lines));
        open = true;
    }
    let Some(longest) = found
        .iter()
        .max_by_key(|rest| rest.1 - rest.0)
        .map(|rest| rest.2)
    else {
        return Vec::new();
    };
    let agrees = |lines: &[Line; 2]| {
        (0..2).all(|i| {
            let spread = noise * (1.0 / lines[i].rows + 1.0 / longest[i].rows);
            (lines[i].y - longest[i].y).abs() < 4.0 * libm::sqrt(spread)
        })
    };
    let agreeing = found.iter().filter(|rest| agrees(&rest.2));
    agreeing.flat_map(|rest| rest.0..rest.1).collect()
}
