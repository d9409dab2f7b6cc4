//! The changes of the simulated motion at many values of q, and the laws far out.

use super::prelude::*;
use super::simulated::Changes;
use crate::numerics::fit::fit;

#[derive(Debug, Clone, Copy)]
pub(crate) struct Row {
    pub q: f64,
    /// Whether it lies before that of Y.
    pub before_y: bool,
    pub changes: Changes,
}

impl Row {
    /// Its changes are sought from `low` up.
    pub(crate) fn at(q: f64, low: f64) -> Result<Self, Failure> {
        Ok(Row {
            q,
            before_y: q < own_y()?,
            changes: Changes::at(q, low, START)?,
        })
    }
}

/// Generic ones first, then the edges, close to the end of B on both sides, and the whole range, the part with B
/// more densely.
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
    list.extend((0..22).map(|k| 1.0 + 11.0 * (f64::from(k) + 0.5) / 22.0));
    list.extend((0..12).map(|k| 1.0 + 3.6 * (f64::from(k) + 0.4) / 12.0));
    list.extend([14.0, 20.0, 35.0]);
    Points::here().grid(list)
}

pub(crate) fn rows() -> impl Iterator<Item = Result<&'static Row, Failure>> {
    static ROWS: Runs<Vec<Row>> = Runs::new(|| all_rows(&ratios(), 1e-9));
    ROWS.each()
}

/// q from 200 to 20,000.
pub(crate) static FAR_ROWS: Runs<Vec<Row>> = Runs::new(|| {
    let q = (0..=20).map(|k| 200.0 * libm::exp10(f64::from(k) / 10.0));
    all_rows(&Points::here().grid(q), 1e-12)
});

fn all_rows(ratios: &[f64], low: f64) -> Result<Vec<Row>, Failure> {
    let row = |&q: &f64| Row::at(q, low).map_err(|error| format!("q = {q}: {error}").into());
    ratios.iter().map(row).collect()
}

/// A power law λ₀ = prefactor · (q + 1)^exponent, with standard errors.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PowerLaw {
    pub exponent: (f64, f64),
    pub prefactor: (f64, f64),
}

/// The terms of the logarithm in x = q + 1.
const TERMS: [&dyn Fn(f64) -> f64; 5] = [
    &|_| 1.0,
    &|x| libm::log(x),
    &|x| 1.0 / (x * x),
    &|x| 1.0 / (x * x * x),
    &|x| 1.0 / (x * x * x * x),
];

/// The laws by which, far out, the onset of rest and the end of direct reversals fall with q, measured on the
/// simulation. The next terms of the logarithm, of order q⁻² to q⁻⁴, are fitted along; to the fit's standard error
/// is added what leaving out the last of them changes.
pub(crate) fn far_laws() -> Result<[PowerLaw; 2], Failure> {
    let rows = every(FAR_ROWS.each())?;
    let law = |height: fn(&Changes) -> f64| -> Result<PowerLaw, Failure> {
        let data: Vec<_> = rows
            .iter()
            .map(|row| (row.q + 1.0, libm::log(height(&row.changes))))
            .collect();
        let (best, shorter) = (fit(&data, &TERMS)?, fit(&data, &TERMS[..4])?);
        let measured = |i: usize| {
            let changed = (best.coefficients[i] - shorter.coefficients[i]).abs();
            (best.coefficients[i], best.errors[i] + changed)
        };
        let (logarithm, error) = measured(0);
        let prefactor = libm::exp(logarithm);
        Ok(PowerLaw {
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
    fn the_terms_are_a_logarithm_and_powers() {
        let expected = [1.0, libm::log(3.0), 1.0 / 9.0, 1.0 / 27.0, 1.0 / 81.0];
        assert_eq!(TERMS.map(|term| term(3.0)), expected);
    }

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
}
