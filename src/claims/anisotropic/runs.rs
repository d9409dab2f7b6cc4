//! The simulated motions of section 2.4 and the curves that they are held against.

use crate::claims::compare::Failure;
use crate::corrections::anisotropic as corrected;
use crate::motion::drive::{
    Attractor, Drive, DriveError, Friction, Interval, Outcome, Sign, State,
};
use crate::numerics::fit::fit;
use crate::numerics::roots::root;
use crate::paper::anisotropic as printed;
use std::sync::LazyLock;

/// The start of every motion unless another is said.
pub const START: State = State { phi: 0.0, w: 0.0 };
/// Far more periods than any attractor here takes.
const MAX_PERIODS: u32 = 200;

/// The drive sin φ.
pub fn drive() -> Result<&'static Drive, DriveError> {
    static DRIVE: LazyLock<Result<Drive, DriveError>> =
        LazyLock::new(|| Drive::new(libm::sin, &[]));
    DRIVE.as_ref().map_err(Clone::clone)
}

/// The periodic motion that a start leads to.
///
/// # Errors
/// Friction outside its range, a motion that does not become periodic.
pub fn attractor_from(start: State, friction: Friction) -> Result<Attractor<'static>, Failure> {
    match drive()?.attractor(friction, start, MAX_PERIODS)? {
        Outcome::Settles(attractor) => Ok(attractor),
        Outcome::Drifts { per_period } => Err(format!(
            "the motion with λ₊ = {}, λ₋ = {} drifts by {per_period} a period",
            friction.plus(),
            friction.minus()
        )
        .into()),
    }
}

/// The periodic motion with λ₊ = λ₀ and λ₋ = qλ₀.
///
/// # Errors
/// As [`attractor_from`].
pub fn attractor(q: f64, lambda0: f64) -> Result<Attractor<'static>, Failure> {
    attractor_from(START, Friction::new(lambda0, q * lambda0)?)
}

/// The order of a period's intervals, as `+`, `-` and `0`.
pub fn order(intervals: &[Interval]) -> String {
    let letter = |interval: &Interval| match interval.sign {
        Sign::Positive => '+',
        Sign::Negative => '-',
        Sign::Rest => '0',
    };
    intervals.iter().map(letter).collect()
}

/// The region, 1 to 5, whose printed description fits the motion; 0 if none does.
pub fn fits(intervals: &[Interval]) -> usize {
    let found = order(intervals);
    let place = printed::ORDERS.iter().position(|order| *order == found);
    place.map_or(0, |i| i + 1)
}

/// The simulated region of a point.
///
/// # Errors
/// As [`attractor_from`].
pub fn simulated(q: f64, lambda0: f64) -> Result<usize, Failure> {
    Ok(fits(attractor(q, lambda0)?.intervals()))
}

/// Below any curve of the plane.
const LOWEST: f64 = 1e-12;

/// λ₀ on the printed curve A.
///
/// # Errors
/// No solution of (53), which does not happen for 0 < q < 1e5.
pub fn curve_a(q: f64) -> Result<f64, Failure> {
    let k = printed::eq53_k(q);
    let sides = |lambda0| difference(printed::eq53_sides(k, lambda0));
    Ok(root(sides, LOWEST, 1.0)?)
}

/// λ₀ on the printed curve B, if (54) has a solution there. It has at most one: left less right side falls
/// with λ₀ wherever both have values.
///
/// # Errors
/// A value that is not a number, which does not happen for q ≥ 1.
pub fn curve_b(q: f64) -> Result<Option<f64>, Failure> {
    let sides = |lambda0| difference(printed::eq54_sides(lambda0, q * lambda0));
    let top = largest(q);
    if sides(top) > 0.0 {
        return Ok(None);
    }
    Ok(Some(root(sides, LOWEST, top)?))
}

/// λ₀ on the curve E of the corrections, if there is one. Left less right side is 0 at λ₀ = 0, falls, and
/// rises again, so that there is one more root or none.
///
/// # Errors
/// A value that is not a number, which does not happen for q ≥ 1.
pub fn curve_e(q: f64) -> Result<Option<f64>, Failure> {
    let sides = |lambda0| difference(corrected::e_sides(lambda0, q * lambda0));
    let top = largest(q);
    if sides(top) < 0.0 {
        return Ok(None);
    }
    Ok(Some(root(sides, LOWEST, top)?))
}

fn difference([left, right]: [f64; 2]) -> f64 {
    left - right
}

/// The largest λ₀ with qλ₀ ≤ 1 in floating point.
fn largest(q: f64) -> f64 {
    let top = 1.0 / q;
    if q * top > 1.0 { top.next_down() } else { top }
}

/// All curves at one q, printed and corrected.
#[derive(Debug, Clone, Copy)]
pub struct Curves {
    /// The ratio q.
    pub q: f64,
    /// As printed.
    pub printed: printed::Curves,
    /// As corrected.
    pub corrected: corrected::Curves,
}

impl Curves {
    /// The curves at this q ≥ 1.
    ///
    /// # Errors
    /// A formula without a root.
    pub fn at(q: f64) -> Result<Self, Failure> {
        let (a, b, e) = (curve_a(q)?, curve_b(q)?, curve_e(q)?);
        let (c, d) = (printed::eq55_lambda0(q), printed::eq56_lambda0());
        let neither = || format!("neither B nor E has a point at q = {q}");
        Ok(Curves {
            q,
            printed: printed::Curves { a, b, c, d },
            corrected: corrected::Curves {
                a,
                b_or_e: b.or(e).ok_or_else(neither)?,
                c: b.map(|_| c),
                d,
            },
        })
    }

    /// Whether a curve, printed or new, is so near that rounding decides.
    pub fn blur(&self, lambda0: f64) -> bool {
        let printed::Curves { a, c, d, .. } = self.printed;
        let near = |curve: f64| (lambda0 - curve).abs() < BLUR;
        [a, self.corrected.b_or_e, c, d].into_iter().any(near)
    }
}

/// Within this distance of a curve nothing is said.
pub const BLUR: f64 = 1e-12;

/// Where the kind of motion changes at one q, by simulation alone.
#[derive(Debug, Clone, Copy)]
pub struct Changes {
    /// The least λ₀ with an interval of rest.
    pub rest: f64,
    /// The largest λ₀ at which forward motion turns into backward motion without a rest.
    pub reversal: f64,
    /// The largest λ₀ with backward motion.
    pub backward: f64,
    /// The largest λ₀ with any motion.
    pub motion: f64,
}

impl Changes {
    /// Finds them between `low` and 1.4 by bisection on the list of intervals, to neighbouring numbers.
    ///
    /// # Errors
    /// As [`attractor_from`].
    pub fn at(q: f64, low: f64, start: State) -> Result<Self, Failure> {
        let change = |holds: fn(&[Interval]) -> bool| {
            bisect(low, 1.4, |lambda0| {
                let friction = Friction::new(lambda0, q * lambda0)?;
                Ok(holds(attractor_from(start, friction)?.intervals()))
            })
        };
        Ok(Changes {
            rest: change(|list| !list.iter().any(|i| i.sign == Sign::Rest))?,
            reversal: change(reverses)?,
            backward: change(|list| list.iter().any(|i| i.sign == Sign::Negative))?,
            motion: change(|list| list.iter().any(|i| i.sign != Sign::Rest))?,
        })
    }
}

fn reverses(list: &[Interval]) -> bool {
    let next = list.iter().cycle().skip(1);
    list.iter()
        .zip(next)
        .any(|(now, next)| now.sign == Sign::Positive && next.sign == Sign::Negative)
}

/// Where `holds` changes between `low` and `high`, to neighbouring numbers: the side on which it is as at `low`.
///
/// # Errors
/// Those of `holds`; the same answer at both ends.
pub fn bisect(
    low: f64,
    high: f64,
    mut holds: impl FnMut(f64) -> Result<bool, Failure>,
) -> Result<f64, Failure> {
    let (mut a, mut b) = (low, high);
    let first = holds(a)?;
    if holds(b)? == first {
        return Err(format!("no change between {low} and {high}").into());
    }
    loop {
        let middle = 0.5 * (a + b);
        if middle <= a.min(b) || middle >= a.max(b) {
            return Ok(a);
        }
        if holds(middle)? == first {
            a = middle;
        } else {
            b = middle;
        }
    }
}

/// One q with everything that is known there.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// The curves by formula.
    pub curves: Curves,
    /// The changes by simulation.
    pub changes: Changes,
}

/// The values of q at which the curves are tried: generic ones first, then the edges, close to the end of B
/// on both sides, and the whole range, the part with B more densely.
fn ratios() -> Vec<f64> {
    let mut list = vec![
        2.0,
        3.0,
        1.5,
        6.0,
        1.0,
        12.0,
        1.000_000_42,
        1.0003,
        1.02,
        4.4,
        4.55,
        4.59,
        4.603,
        4.6033,
        4.603_33,
        4.603_35,
        4.6034,
        4.604,
        4.61,
        4.65,
        4.8,
    ];
    list.extend((0..48).map(|k| 1.0 + 11.0 * (f64::from(k) + 0.5) / 48.0));
    list.extend((0..24).map(|k| 1.0 + 3.6 * (f64::from(k) + 0.4) / 24.0));
    list
}

/// Rows for all values of q at which the curves are tried.
///
/// # Errors
/// Why there is none.
pub fn rows() -> Result<&'static [Row], Failure> {
    static ROWS: LazyLock<Result<Vec<Row>, String>> = LazyLock::new(|| all_rows(&ratios(), 1e-9));
    ROWS.as_deref()
        .map_err(|error| Failure::from(error.clone()))
}

/// Rows far out, q from 200 to 20,000.
///
/// # Errors
/// Why there is none.
pub fn far_rows() -> Result<&'static [Row], Failure> {
    static ROWS: LazyLock<Result<Vec<Row>, String>> = LazyLock::new(|| {
        let q: Vec<f64> = (0..=24)
            .map(|k| 200.0 * libm::exp10(f64::from(k) / 12.0))
            .collect();
        all_rows(&q, 1e-12)
    });
    ROWS.as_deref()
        .map_err(|error| Failure::from(error.clone()))
}

fn all_rows(ratios: &[f64], low: f64) -> Result<Vec<Row>, String> {
    use rayon::prelude::*;
    let row = |&q: &f64| {
        let made = || -> Result<Row, Failure> {
            Ok(Row {
                curves: Curves::at(q)?,
                changes: Changes::at(q, low, START)?,
            })
        };
        made().map_err(|error| format!("q = {q}: {error}"))
    };
    ratios.par_iter().map(row).collect()
}

/// The point Y from the printed formulas: the q at which λ₀ = 1/q solves (54).
///
/// # Errors
/// No such q.
pub fn touching() -> Result<f64, Failure> {
    let sides = |q: f64| difference(printed::eq54_sides(printed::eq55_lambda0(q), 1.0));
    Ok(root(sides, 2.0, 12.0)?)
}

/// A power law λ₀ = prefactor · (q + 1)^exponent, with standard errors.
#[derive(Debug, Clone, Copy)]
pub struct Law {
    /// The exponent and its error.
    pub exponent: (f64, f64),
    /// The prefactor and its error.
    pub prefactor: (f64, f64),
}

/// The laws by which, far out, the onset of rest and the end of direct reversals fall with q, measured on the
/// simulation. The next terms of the logarithm, of order q⁻² to q⁻⁴, are fitted along; to the fit's standard error
/// is added what leaving out the last of them changes.
///
/// # Errors
/// As [`far_rows`].
pub fn far_laws() -> Result<[Law; 2], Failure> {
    let rows = far_rows()?;
    let basis: [&dyn Fn(f64) -> f64; 5] = [
        &|_| 1.0,
        &|x| libm::log(x),
        &|x| 1.0 / (x * x),
        &|x| 1.0 / (x * x * x),
        &|x| 1.0 / (x * x * x * x),
    ];
    let law = |height: fn(&Changes) -> f64| -> Result<Law, Failure> {
        let data: Vec<_> = rows
            .iter()
            .map(|row| (row.curves.q + 1.0, libm::log(height(&row.changes))))
            .collect();
        let (best, shorter) = (fit(&data, &basis)?, fit(&data, &basis[..4])?);
        let measured = |i: usize| {
            let changed = (best.coefficients[i] - shorter.coefficients[i]).abs();
            (best.coefficients[i], best.errors[i] + changed)
        };
        let (logarithm, error) = measured(0);
        let prefactor = libm::exp(logarithm);
        Ok(Law {
            exponent: measured(1),
            prefactor: (prefactor, prefactor * error),
        })
    };
    Ok([law(|c| c.rest)?, law(|c| c.reversal)?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn far_out_both_curves_fall_as_the_square() {
        let laws = far_laws().unwrap();
        for (law, prefactor) in laws.iter().zip([PI, 4.0 * PI]) {
            println!("{law:?}");
            let off = |(value, error): (f64, f64), expected: f64| {
                assert!(error < 1e-6, "{law:?}");
                assert!((value - expected).abs() < 3.0 * error, "{law:?}");
            };
            off(law.exponent, -2.0);
            off(law.prefactor, prefactor);
        }
    }

    #[test]
    fn the_curve_is_one_valued() {
        // Left less right side of (54) falls, that of E falls and rises: no second root anywhere.
        for i in 1..400 {
            let q = 1.0 + 0.05 * f64::from(i);
            let changes = |sides: fn(f64, f64) -> [f64; 2]| {
                let value = |k: u32| {
                    let lambda0 = f64::from(k) / 2000.0 / q;
                    difference(sides(lambda0, (q * lambda0).min(1.0)))
                };
                (1..2000).filter(|&k| value(k) * value(k + 1) < 0.0).count()
            };
            let b = usize::from(curve_b(q).unwrap().is_some());
            assert_eq!(changes(printed::eq54_sides), b, "q = {q}");
            assert_eq!(changes(corrected::e_sides), 1 - b, "q = {q}");
        }
    }
}
