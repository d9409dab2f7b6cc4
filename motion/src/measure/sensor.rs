//! The rows of a recording, free of what is known of the sensor's zeros.

use super::{
    LARGEST, LEAST_ROWS, MeasureError, Settings,
    pieces::{Line, Piece, cut},
};
use crate::fitted::Recording;
use crate::numerics::median;

/// After the year 2100, counted in seconds from 1970.
const LATEST: f64 = 1e10;
/// In s and in rows.
const QUIET: f64 = 0.25;
const QUIET_ROWS: usize = 16;
const QUIETER: f64 = 3.0;
pub(crate) const SAME: f64 = 0.06;

pub(crate) struct Sensor {
    pub t: Vec<f64>,
    /// Along the floor.
    pub f: Vec<[f64; 2]>,
    /// N/m.
    pub n: Vec<f64>,
    /// |f|/N.
    pub ratio: Vec<f64>,
    /// Variance of the noise along an axis.
    pub noise: f64,
    /// The factor of a mean's variance, as neighbours are alike.
    pub alike: f64,
    /// Variance of what digits leave out of all rows alike.
    pub digits: f64,
    pub axes: f64,
    pub zeroed: bool,
    pub measured: bool,
    pub g: f64,
    /// Taken off f since its zeros were known to this variance.
    pub shifted: [f64; 2],
    pub doubt: f64,
    /// Variance of the zero of N/m.
    pub doubt_across: f64,
}

impl Sensor {
    /// `level` says whether quiet stretches count as a rest on level floor.
    pub(crate) fn new(
        recording: &Recording,
        settings: &Settings,
        level: bool,
    ) -> Result<Self, MeasureError> {
        let (rows, least) = (recording.rows.len(), LEAST_ROWS);
        if rows < least {
            return Err(MeasureError::Rows { least, rows });
        }
        for (name, value) in [("g", settings.g), ("offset", settings.offset)] {
            if !(1e-3..=1e3).contains(&value) {
                let range = "between 0.001 and 1000";
                return Err(MeasureError::Setting { name, value, range });
            }
        }
        let (t, f): (Vec<_>, Vec<_>) = recording.rows.iter().copied().unzip();
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
        let digit = digit(&f);
        let rough = jitter(&f, axes).max(digit).max(1e-12);
        let (noise, alike) = quiet(&windows, axes, rough, 0.05 * settings.g);
        let noise = noise.max(digit).max(1e-12);
        let digits = if noise < 4.0 * digit { digit } else { 0.0 };
        let g = settings.g;
        let rest: Vec<usize> = match settings.rest {
            Some([from, to]) => {
                let inside = |k: &usize| (from..=to).contains(&t[*k]);
                let rest: Vec<_> = (0..rows).filter(inside).collect();
                let moves = |i: usize| {
                    let line = Line::through(rest.iter().map(|k| (0.0, f[*k][i])));
                    line.yy > line.rows * (16.0 * noise + (0.01 * g).powi(2))
                        || line.y.abs() > 0.1 * g
                };
                if rest.len() < QUIET_ROWS || (0..2).any(moves) {
                    return Err(MeasureError::Rest { from, to });
                }
                rest
            }
            None if level => rests(&windows, noise, alike, 0.05 * g),
            None => Vec::new(),
        };
        let zeroed = !rest.is_empty();
        let mean = |of: &dyn Fn(usize) -> f64| {
            rest.iter().map(|k| of(*k)).sum::<f64>() / rest.len().max(1) as f64
        };
        // Most phones give gravity with the rest; some take it away.
        let across: Vec<_> = normal.unwrap_or(&[]).iter().map(|z| z.abs()).collect();
        let across_most = median(across.iter().copied());
        if across_most > 1.5 * g {
            return Err(MeasureError::Gravity {
                across: across_most,
                g,
            });
        }
        let measured = across_most > 0.5 * g;
        let n = if measured {
            let off = if zeroed {
                mean(&|k| across[k]) - g
            } else {
                0.0
            };
            across.iter().map(|z| (z - off).max(0.1 * g)).collect()
        } else {
            vec![g; rows]
        };
        // Where it was quiet for some windows, noise may be correlated over a part of one.
        let doubt = if zeroed {
            4.0 * alike * noise / rest.len() as f64 + digits
        } else {
            settings.offset * settings.offset
        };
        let zero = [0, 1].map(|i| mean(&|k| f[k][i]));
        let mut sensor = Self {
            t,
            f,
            n,
            ratio: Vec::new(),
            noise,
            alike,
            digits,
            axes,
            zeroed,
            measured,
            g,
            shifted: zero.map(|x| -x),
            doubt,
            doubt_across: if measured { doubt } else { 0.0 },
        };
        sensor.shift(zero);
        Ok(sensor)
    }

    pub(crate) fn shift(&mut self, offset: [f64; 2]) {
        for f in &mut self.f {
            *f = [f[0] - offset[0], f[1] - offset[1]];
        }
        self.shifted = [0, 1].map(|i| self.shifted[i] + offset[i]);
        let size = |(f, n): (&[f64; 2], &f64)| libm::hypot(f[0], f[1]) / n;
        self.ratio = self.f.iter().zip(&self.n).map(size).collect();
    }

    pub(crate) fn pieces(&self) -> Vec<Piece> {
        let n = median(self.n.iter().copied());
        let penalty = 4.0 * self.alike * libm::log(self.t.len() as f64);
        cut(&self.t, &self.ratio, self.noise / (n * n), penalty)
    }

    /// Variance of the ratio's noise.
    pub(crate) fn floor(&self, row: usize) -> f64 {
        self.noise / (self.n[row] * self.n[row])
    }

    /// To and fro they differ by what is unknown of the zeros.
    pub(crate) fn near(&self, a: f64, b: f64) -> bool {
        let zeros = 4.0 * libm::sqrt(self.doubt) / self.n[0];
        (a - b).abs() < SAME * 0.5 * (a + b) + zeros
    }

    fn size(&self, row: usize) -> f64 {
        libm::hypot(1.0, self.ratio[row]) * self.n[row]
    }

    /// Its middle, and the variance of that, which is 1.57 of a mean's.
    fn felt(&self, rows: impl Iterator<Item = usize> + Clone) -> (f64, f64) {
        let variance = 1.57 * self.alike * self.noise / rows.clone().count() as f64;
        (median(rows.map(|k| self.size(k))), variance)
    }

    /// With its variance: g, or nearly that in one of these plateaus, where z has an unknown zero.
    pub(crate) fn weight(&self, plateaus: &[Piece]) -> (f64, f64) {
        let off = |felt: &(f64, f64)| (felt.0 - self.g).powi(2);
        let long = plateaus
            .iter()
            .filter(|piece| piece.to - piece.from >= 2 * QUIET_ROWS);
        let felt = long.map(|piece| self.felt(piece.from..piece.to));
        let best = felt.min_by(|a, b| off(a).total_cmp(&off(b)));
        let best = best.filter(|felt| off(felt) < self.doubt_across && felt.1 < self.doubt_across);
        best.unwrap_or((self.g, self.doubt_across))
    }

    /// A rest on a tilted floor, where `weight` is felt: (g sin, g cos) is of one size. A slip has more on level floor, and less
    /// where it began with a drop from the ratio `top` on a slope.
    pub(crate) fn may_rest(&self, plateaus: &[Piece], top: f64, weight: (f64, f64)) -> bool {
        let all = plateaus
            .iter()
            .fold(Line::default(), |all, piece| all.with(&piece.line));
        let rows = plateaus.iter().flat_map(|piece| piece.from..piece.to);
        let (found, own) = self.felt(rows);
        let own = own + all.y * all.y * self.doubt + 2.0 * self.digits;
        let like = |(rest, doubt): (f64, f64)| {
            let more = found - rest;
            let less = rest * (libm::hypot(1.0, all.y) / libm::hypot(1.0, top) - 1.0);
            more * more < 9.0 * (own + doubt)
                && (less * less < 4.0 * (own + doubt) || more > 0.5 * less)
        };
        let low = (0..self.t.len()).filter(|k| 3.0 * self.ratio[*k] < all.y);
        let few = low.clone().count() < QUIET_ROWS;
        // What is low while the floor moves may be tilted all the same, but then no plateau has the other way.
        let ways = plateaus.iter().fold([0.0; 2], |sum, piece| {
            let mean = self.mean([piece.from, piece.to]);
            [0, 1].map(|i| sum[i] + piece.line.rows * mean[i])
        });
        let one_way = libm::hypot(ways[0], ways[1]) > 0.5 * all.y * all.rows * weight.0;
        self.measured && ((few || one_way) && like(weight) || !few && like(self.felt(low)))
    }

    pub(crate) fn line(&self, [from, to]: [usize; 2]) -> Line {
        Line::through((from..to).map(|k| (self.t[k], self.ratio[k])))
    }

    pub(crate) fn mean(&self, [from, to]: [usize; 2]) -> [f64; 2] {
        let sum = self.f[from..to]
            .iter()
            .fold([0.0; 2], |sum, f| [sum[0] + f[0], sum[1] + f[1]]);
        sum.map(|sum| sum / (to - from) as f64)
    }

    /// Its cosine, of f in some rows and in others.
    pub(crate) fn angle(&self, here: [usize; 2], there: [usize; 2]) -> f64 {
        let [a, b] = [here, there].map(|rows| self.mean(rows));
        (a[0] * b[0] + a[1] * b[1]) / (libm::hypot(a[0], a[1]) * libm::hypot(b[0], b[1]))
    }
}

#[derive(Clone, Copy)]
struct Window {
    rows: [usize; 2],
    lines: [Line; 2],
    /// The products of neighbours.
    next: f64,
}

impl Window {
    fn is_still(&self, noise: f64, alike: f64, most: f64) -> bool {
        self.lines.iter().all(|line| {
            let (variance, rise) = (line.variance(), line.slope() * line.ty);
            variance < 4.0 * noise
                && rise < 9.0 * alike * noise.max(variance)
                && line.y.abs() < most
        })
    }
}

fn windows(t: &[f64], f: &[[f64; 2]]) -> Vec<Window> {
    let mean = (t[t.len() - 1] - t[0]) / (t.len() - 1) as f64;
    let rows = ((QUIET / mean) as usize).clamp(QUIET_ROWS, t.len());
    let window = |k: usize| {
        let [from, to] = [k * rows, (k + 1) * rows];
        let line = |i: usize| Line::through((from..to).map(|k| (t[k], f[k][i])));
        let lines = [0, 1].map(line);
        let off = |k: usize| [0, 1].map(|i| f[k][i] - lines[i].at(t[k]));
        let product = |k: usize| {
            let [a, b] = [off(k), off(k + 1)];
            a[0] * b[0] + a[1] * b[1]
        };
        let next = (from..to - 1).map(product).sum();
        Window {
            rows: [from, to],
            lines,
            next,
        }
    };
    (0..t.len() / rows).map(window).collect()
}

/// Variance of the noise where no window is quiet, by third differences.
fn jitter(f: &[[f64; 2]], axes: f64) -> f64 {
    let third = |k: &[[f64; 2]], i: usize| k[3][i] - k[0][i] + 3.0 * (k[1][i] - k[2][i]);
    let sizes = f
        .windows(4)
        .map(|k| third(k, 0).powi(2) + third(k, 1).powi(2));
    // Of normal numbers of variance one, the median of the squares is 0.455, and that of the sums of two 1.386.
    median(sizes) / (20.0 * if axes > 1.0 { 1.386 } else { 0.455 })
}

/// Variance of the noise, and by what it multiplies that of a mean that neighbours are alike, as behind a filter.
fn quiet(windows: &[Window], axes: f64, rough: f64, most: f64) -> (f64, f64) {
    let (mut rows, mut next, mut left) = (0.0, 0.0, 0.0);
    // Third differences of what is alike are small.
    let still = windows
        .iter()
        .filter(|window| window.is_still(QUIETER * rough, 1.0, most));
    for window in still {
        rows += axes * (window.lines[0].rows - 2.0);
        next += window.next;
        left += window.lines.iter().map(Line::left).sum::<f64>();
    }
    if left <= 0.0 {
        return (rough, 1.0);
    }
    let part = next / left;
    // Its line makes a window's rows less alike.
    let part = (part + (2.0 + 4.0 * part) / windows[0].lines[0].rows).clamp(0.0, 0.9);
    (left / rows, (1.0 + part) / (1.0 - part))
}

/// Variance of the least step, if most are whole numbers of it, or of a decimal place behind which there is nothing.
fn digit(f: &[[f64; 2]]) -> f64 {
    let of_axis = |i: usize| {
        let steps = f.windows(2).map(|pair| (pair[1][i] - pair[0][i]).abs());
        let steps: Vec<_> = steps.filter(|step| *step > 0.0).collect();
        let least = steps.iter().copied().fold(f64::INFINITY, f64::min);
        let whole = |step: &&f64| {
            let times = **step / least;
            (times - libm::round(times)).abs() < 0.1
        };
        // Of numbers by chance one in five is so near to a whole one.
        let digital = 2 * steps.iter().filter(whole).count() > steps.len();
        if digital { least * least / 12.0 } else { 0.0 }
    };
    let ends = |scale: &f64| {
        let whole = |x: f64| (x - libm::round(x)).abs() < 1e-6;
        f.iter().flatten().all(|x| whole(x * scale))
    };
    let scale = (0..8).map(|place| libm::exp10(f64::from(place))).find(ends);
    let place = scale.map_or(0.0, |scale| 1.0 / (12.0 * scale * scale));
    of_axis(0).max(of_axis(1)).max(place)
}

/// Of quiet stretches with the same small mean as the longest.
fn rests(windows: &[Window], noise: f64, alike: f64, most: f64) -> Vec<usize> {
    let still = |window: &Window| window.is_still(noise, alike, most);
    let mut found: Vec<Window> = Vec::new();
    for window in windows.iter().filter(|window| still(window)) {
        // A stretch ends where its straight line is no longer level.
        let both = |last: &Window| Window {
            rows: [last.rows[0], window.rows[1]],
            lines: [0, 1].map(|i| last.lines[i].with(&window.lines[i])),
            next: 0.0,
        };
        match found.last_mut() {
            Some(last) if last.rows[1] == window.rows[0] && still(&both(last)) => {
                *last = both(last)
            }
            _ => found.push(*window),
        }
    }
    let longest = found.iter().max_by_key(|rest| rest.rows[1] - rest.rows[0]);
    let agrees = |rest: &&Window| {
        longest.is_some_and(|longest| {
            (0..2).all(|i| {
                let [a, b] = [rest.lines[i], longest.lines[i]];
                (a.y - b.y).powi(2) < 16.0 * alike * noise * (1.0 / a.rows + 1.0 / b.rows)
            })
        })
    };
    let agreeing = found.iter().filter(agrees);
    agreeing
        .flat_map(|rest| rest.rows[0]..rest.rows[1])
        .collect()
}
