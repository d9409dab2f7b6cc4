//! Linear least squares, by `faer`, the columns of the design matrix scaled to unit length: Householder's QR
//! for the coefficients, singular values for the [condition](Fit::condition).

use super::error::NumericsError;
use faer::Mat;
use faer::linalg::solvers::SolveLstsq;

/// A fitted sum of functions.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// Coefficient of each function.
    pub coefficients: Vec<f64>,
    /// Standard error of each coefficient, from the scatter of the residuals; zero with as many coefficients
    /// as data.
    pub errors: Vec<f64>,
    /// Root mean square of the residuals.
    pub residual: f64,
    /// Largest absolute residual.
    pub worst: f64,
    /// The condition number of the scaled design matrix: the most by which it enlarges a relative error of
    /// the data. At least 1.
    pub condition: f64,
}

/// Fits `y` ≈ Σ cᵢ · basisᵢ(x) to the data (x, y).
///
/// # Errors
/// [`NumericsError::NotFinite`] for a datum or a value of a basis function that is not finite,
/// [`NumericsError::Rank`] for fewer data than functions or functions that the data cannot tell apart,
/// [`NumericsError::Library`] where squares of the data are beyond floating point.
pub fn fit(data: &[(f64, f64)], basis: &[&dyn Fn(f64) -> f64]) -> Result<Fit, NumericsError> {
    let (rows, columns) = (data.len(), basis.len());
    let undetermined = |rank| NumericsError::Rank {
        data: rows,
        unknowns: columns,
        rank,
    };
    let beyond = || NumericsError::Library {
        method: "least squares",
        message: "the data are too large or too small".to_owned(),
    };
    if columns == 0 || rows < columns {
        return Err(undetermined(rows.min(columns)));
    }
    let mut design = Mat::from_fn(rows, columns, |i, j| basis[j](data[i].0));
    for (i, (x, y)) in data.iter().enumerate() {
        if !(y.is_finite() && (0..columns).all(|j| design[(i, j)].is_finite())) {
            return Err(NumericsError::NotFinite {
                what: "a datum or basis function",
                at: *x,
            });
        }
    }
    let scales: Vec<f64> = design.col_iter().map(|column| column.norm_l2()).collect();
    for (column, scale) in design.col_iter_mut().zip(&scales) {
        if !(*scale > 0.0 && scale.is_finite()) {
            return Err(undetermined(columns - 1));
        }
        column.iter_mut().for_each(|x| *x /= scale);
    }
    let singular = design.singular_values().map_err(|_| beyond())?;
    let rank = singular.iter().filter(|&&s| s > DEPENDENT).count();
    if rank < columns {
        return Err(undetermined(rank));
    }
    let values = Mat::from_fn(rows, 1, |i, _| data[i].1);
    let qr = design.qr();
    let solution = qr.solve_lstsq(&values);
    let residuals = &values - &design * &solution;
    let squares = residuals.squared_norm_l2();
    let variance = if rows > columns {
        squares / (rows - columns) as f64
    } else {
        0.0
    };
    // The covariance is variance · R⁻¹R⁻ᵀ.
    let mut inverse = Mat::<f64>::identity(columns, columns);
    qr.thin_R().solve_upper_triangular_in_place(&mut inverse);
    let error = |j: usize| libm::sqrt(variance) * inverse.row(j).norm_l2() / scales[j];
    let fit = Fit {
        coefficients: (0..columns).map(|j| solution[(j, 0)] / scales[j]).collect(),
        errors: (0..columns).map(error).collect(),
        residual: libm::sqrt(squares / rows as f64),
        worst: residuals.norm_max(),
        condition: singular[0] / singular[columns - 1],
    };
    let mut numbers = fit.coefficients.iter().chain(&fit.errors);
    if numbers.all(|x| x.is_finite()) && fit.residual.is_finite() {
        Ok(fit)
    } else {
        Err(beyond())
    }
}

/// Of a design matrix with unit columns: below this they depend on each other.
const DEPENDENT: f64 = 1e-13;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_data_give_exact_coefficients() {
        let data: Vec<_> = (1..40)
            .map(|i| 0.1 * i as f64)
            .map(|x| (x, 3.0 - 2e-6 * x * x + 0.5 / x))
            .collect();
        let fit = fit(&data, &[&|_| 1.0, &|x| x * x, &|x| 1.0 / x]).unwrap();
        for (found, expected) in fit.coefficients.iter().zip([3.0, -2e-6, 0.5]) {
            assert!((found - expected).abs() < 1e-14, "{fit:?}");
        }
        assert!(fit.worst < 1e-14 && fit.residual <= fit.worst);
    }

    #[test]
    fn standard_errors_of_a_straight_line() {
        // y = x with residuals +1, −1, −1, +1 at x = 0, 1, 2, 3: the textbook's formulas give slope 1,
        // s² = 4/2, errors s/√Σ(x−x̄)² = √(2/5) and s √(1/4 + x̄²/5) = √(2·0.7).
        let data = [(0.0, 1.0), (1.0, 0.0), (2.0, 1.0), (3.0, 4.0)];
        let fit = fit(&data, &[&|_| 1.0, &|x| x]).unwrap();
        assert!(fit.coefficients[0].abs() < 1e-14 && (fit.coefficients[1] - 1.0).abs() < 1e-14);
        assert!((fit.errors[0] - libm::sqrt(1.4)).abs() < 1e-14, "{fit:?}");
        assert!((fit.errors[1] - libm::sqrt(0.4)).abs() < 1e-14);
        assert!((fit.residual - 1.0).abs() < 1e-14 && (fit.worst - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_condition_is_that_of_the_angle_between_the_columns() {
        // Unit columns at an angle γ have the singular values √(1 ± cos γ), so that the condition number is cot(γ/2).
        for cosine in [0.0, 0.6, 1.0 - 1e-6] {
            let sine = libm::sqrt((1.0 - cosine) * (1.0 + cosine));
            let other = move |x: f64| if x == 0.0 { 7.0 * cosine } else { 7.0 * sine };
            let fit = fit(&[(0.0, 1.0), (1.0, 2.0)], &[&|x| 1.0 - x, &other]).unwrap();
            let expected = (1.0 + cosine) / sine;
            assert!((fit.condition / expected - 1.0).abs() < 1e-9, "{fit:?}");
        }
    }

    #[test]
    fn what_is_not_determined_is_an_error() {
        let data = [(0.0, 1.0), (1.0, 2.0), (2.0, 0.0)];
        let twice: [&dyn Fn(f64) -> f64; 2] = [&|x| x, &|x| 2.0 * x];
        assert!(matches!(
            fit(&data, &twice),
            Err(NumericsError::Rank { rank: 1, .. })
        ));
        assert!(matches!(
            fit(&data[..1], &twice),
            Err(NumericsError::Rank { .. })
        ));
        assert!(matches!(
            fit(&data, &[&|x| 1.0 / x]),
            Err(NumericsError::NotFinite { .. })
        ));
    }
}
