//! A function of period 2π, known only point by point, as a chain of short polynomials.
//!
//! [`Piecewise::fit`] halves the period, cut at jumps and kinks, until Chebyshev interpolants of low degree meet the function to
//! rounding, and cuts where the slope changes sign: every piece is monotone, and its antiderivative exact. Polynomials are in
//! powers of the distance from the left end of their piece, so that integrals over short distances keep their relative accuracy.

mod chebyshev;
mod piece;

pub use chebyshev::{Fit, interpolate};
pub use piece::{Piece, Secant};

use polycool::PolyDyn;
use std::f64::consts::TAU;
use trialbook::numerics::series;

/// Why a function could not be represented.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PiecewiseError {
    /// The function has no finite value, or one whose integrals and coefficients might have none.
    #[error("the function must be finite, at most 1e100 in size, but it is {value} at {at}")]
    NotFinite {
        /// Where, in [0, 2π).
        at: f64,
        /// What the function returned there.
        value: f64,
    },
    /// Even a very short part is no polynomial: most often a jump or a kink that was not listed.
    #[error("the function cannot be resolved near {at}: list every jump and kink among the breaks")]
    Unresolved {
        /// Where, in [0, 2π).
        at: f64,
    },
    /// A break is no number.
    #[error("every break must be finite, but one is {value}")]
    Break {
        /// The break.
        value: f64,
    },
}

/// Still halved, as a share of the period.
const SHORTEST: f64 = 1e-12;
/// What needs more oscillates too fast, or is noise.
const MOST_PARTS: usize = 1 << 14;
/// High divided differences of it, on the shortest part, are still numbers.
const LARGEST: f64 = 1e100;
/// Breaks closer than this (radians) count as one.
const SAME_BREAK: f64 = 1e-13;
/// Half the spacing of numbers near 2π.
const ARGUMENT: f64 = 4.5e-16;
/// Points per part for the first estimate of the size.
const SURVEY: usize = 64;

/// Twice in the narrowest feature that is never missed, a thousandth of the period.
const PROBES: usize = 2048;
/// As a share of the largest value: far more than rounding, far less than a feature.
const MISSED: f64 = 1e-12;

/// A function of period 2π as a chain of monotone polynomials.
#[derive(Debug, Clone)]
pub struct Piecewise {
    pieces: Vec<Piece>,
    /// The piece in which each of equally wide cells of the period begins.
    cells: Vec<usize>,
    size: f64,
    integral: f64,
}

impl Piecewise {
    /// Represents `function`, asked only for arguments in [0, 2π), to about 1e-15 of its largest value. No feature that lasts
    /// a thousandth of the period is missed; a shorter one needs breaks around it.
    ///
    /// `breaks` lists its jumps and kinks, in any order, modulo 2π; a jump or kink at 0 need not be listed.
    ///
    /// Cost: an interpolation for each part, at most some 32,000.
    ///
    /// # Errors
    /// A value or a break that is not finite, a value beyond 1e100; a function that even on 1e-12 of the period is no
    /// polynomial (an unlisted jump or kink, a pole, a root-like edge, noise).
    pub fn fit(function: impl Fn(f64) -> f64, breaks: &[f64]) -> Result<Self, PiecewiseError> {
        let edges = edges(breaks)?;
        let finite = |at: f64| {
            let value = function(at);
            if value.abs() <= LARGEST {
                Ok(value)
            } else {
                Err(PiecewiseError::NotFinite { at, value })
            }
        };
        let mut size = 0.0_f64;
        for pair in edges.windows(2) {
            for k in 0..SURVEY {
                let at = pair[0] + (pair[1] - pair[0]) * (k as f64 / SURVEY as f64);
                size = size.max(finite(at)?.abs());
            }
        }
        let probe = |k: usize| {
            let at = TAU * ((k as f64 + 0.5) / PROBES as f64);
            finite(at).map(|value| (at, value))
        };
        let probes = (0..PROBES).map(probe).collect::<Result<Vec<_>, _>>()?;
        // Half of it, so that only a peak that was not met before counts.
        size = probes
            .iter()
            .fold(size, |size, (_, value)| size.max(value.abs() / 2.0));
        let mut fits = Vec::new();
        for pair in edges.windows(2) {
            refine(&finite, &probes, [pair[0], pair[1]], size, &mut fits)?;
        }
        let mut pieces = Vec::new();
        let mut before = 0.0;
        for fit in fits {
            let piece = Piece::new(&fit, before);
            before += piece.integral();
            size = size.max(piece.left().abs()).max(piece.right().abs());
            pieces.push(piece);
        }
        let count = (2 * pieces.len()).next_power_of_two();
        let cells = (0..count)
            .map(|cell| {
                let at = TAU * (cell as f64 / count as f64);
                pieces.partition_point(|piece| piece.start() <= at) - 1
            })
            .collect();
        Ok(Piecewise {
            pieces,
            cells,
            size,
            integral: before,
        })
    }

    /// The pieces, from 0 to 2π.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The largest absolute value.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The integral over one period.
    pub fn integral(&self) -> f64 {
        self.integral
    }

    /// The piece that holds `at` in [0, 2π), and the distance from its left end.
    pub(crate) fn locate(&self, at: f64) -> (usize, f64) {
        let cell = (at / TAU * self.cells.len() as f64) as usize;
        let mut index = self.cells[cell.min(self.cells.len() - 1)];
        while index + 1 < self.pieces.len() && self.pieces[index + 1].start() <= at {
            index += 1;
        }
        let piece = &self.pieces[index];
        (index, (at - piece.start()).clamp(0.0, piece.length()))
    }

    /// At any finite argument; at a jump, the limit from the right.
    pub fn value(&self, at: f64) -> f64 {
        let (index, s) = self.locate(at.rem_euclid(TAU));
        self.pieces[index].value(s)
    }

    /// The integral from 0 to any finite argument.
    pub fn antiderivative(&self, at: f64) -> f64 {
        let reduced = at.rem_euclid(TAU);
        let periods = ((at - reduced) / TAU).round();
        let (index, s) = self.locate(reduced);
        let piece = &self.pieces[index];
        periods * self.integral + (piece.before() + s * piece.secant(0.0).mean(s))
    }
}

/// Of the parts on which the function is smooth, from 0 to 2π.
fn edges(breaks: &[f64]) -> Result<Vec<f64>, PiecewiseError> {
    if let Some(&value) = breaks.iter().find(|b| !b.is_finite()) {
        return Err(PiecewiseError::Break { value });
    }
    let mut sorted: Vec<f64> = breaks.iter().map(|b| b.rem_euclid(TAU)).collect();
    sorted.sort_by(f64::total_cmp);
    let mut edges = vec![0.0];
    for b in sorted {
        if b - edges[edges.len() - 1] > SAME_BREAK && TAU - b > SAME_BREAK {
            edges.push(b);
        }
    }
    edges.push(TAU);
    Ok(edges)
}

/// Until the interpolants fit, then cuts at the extrema; appends the fits in order.
fn refine(
    function: &impl Fn(f64) -> Result<f64, PiecewiseError>,
    probes: &[(f64, f64)],
    [a, b]: [f64; 2],
    size: f64,
    fits: &mut Vec<Fit>,
) -> Result<(), PiecewiseError> {
    let mut pending = vec![(a, b)];
    while let Some((a, b)) = pending.pop() {
        let fit = interpolate(function, [a, b], size, ARGUMENT)?;
        let first = probes.partition_point(|(at, _)| *at <= a);
        let inside = probes[first..].iter().take_while(|(at, _)| *at < b);
        let met = |(at, value): &(f64, f64)| {
            (series::value(&fit.coefficients, &(at - a)) - value).abs() <= MISSED * size
        };
        if !(fit.resolved && inside.into_iter().all(met)) {
            if b - a < SHORTEST * TAU || fits.len() + pending.len() > MOST_PARTS {
                return Err(PiecewiseError::Unresolved { at: a });
            }
            let middle = 0.5 * (a + b);
            pending.push((middle, b));
            pending.push((a, middle));
            continue;
        }
        let cuts = extrema(&fit);
        if cuts.is_empty() {
            fits.push(fit);
            continue;
        }
        let mut left = a;
        for right in cuts.into_iter().chain([b]) {
            fits.push(interpolate(function, [left, right], size, ARGUMENT)?);
            left = right;
        }
    }
    Ok(())
}

fn extrema(fit: &Fit) -> Vec<f64> {
    let length = fit.end - fit.start;
    let unit = fit.coefficients.iter().scan(1.0, |power, c| {
        let scaled = c * *power;
        *power *= length;
        Some(scaled)
    });
    let slope = PolyDyn::new(unit).deriv();
    let mut cuts: Vec<f64> = slope
        .roots_between(0.0, 1.0, 1e-15)
        .into_iter()
        .map(|t| fit.start + length * t)
        .filter(|x| x - fit.start > SAME_BREAK && fit.end - x > SAME_BREAK)
        .collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|x, y| *x - *y < SAME_BREAK);
    cuts
}

#[cfg(test)]
mod tests;
