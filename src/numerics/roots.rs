//! Roots of one equation in one unknown, from a bracket.
//!
//! The method is ITP (Oliveira and Takahashi, "An enhancement of the bisection method average performance
//! preserving minmax optimality", ACM Trans. Math. Softw. 47(1), 2020): an interpolated point, truncated
//! towards the middle and projected so that the bracket never lags behind bisection by more than one step.

use super::error::{NumericsError, finite};

/// A root of `f` between `low` and `high`, to two units in the last place of the root, or of the smallest
/// normal number. Where `f` jumps across zero, the place of the jump.
///
/// # Errors
/// [`NumericsError::Argument`] for an end that is not finite, [`NumericsError::NoSignChange`] when `f` has the
/// same sign at both ends, [`NumericsError::NotFinite`] when `f` is NaN somewhere on the way.
pub fn root(mut f: impl FnMut(f64) -> f64, low: f64, high: f64) -> Result<f64, NumericsError> {
    let (mut a, mut b) = (
        finite("low", low)?.min(high),
        finite("high", high)?.max(low),
    );
    let mut at = |x: f64| {
        let y = f(x);
        if y.is_nan() {
            Err(NumericsError::NotFinite {
                what: "the function",
                at: x,
            })
        } else {
            Ok(y)
        }
    };
    let (mut ya, mut yb) = (at(a)?, at(b)?);
    if ya == 0.0 {
        return Ok(a);
    }
    if yb == 0.0 {
        return Ok(b);
    }
    if (ya > 0.0) == (yb > 0.0) {
        return Err(NumericsError::NoSignChange {
            low: a,
            high: b,
            at_low: ya,
            at_high: yb,
        });
    }
    let rising = if ya < 0.0 { 1.0 } else { -1.0 };
    let width = b - a;
    for step in 0..LIMIT {
        let middle = a + 0.5 * (b - a);
        let tolerance = (f64::EPSILON * middle.abs()).max(f64::MIN_POSITIVE);
        if b - a <= 2.0 * tolerance || middle <= a || middle >= b {
            return Ok(if ya.abs() < yb.abs() { a } else { b });
        }
        let x = next(a, b, ya, yb, width, tolerance, step).clamp(a, b);
        // An end again would not shrink the bracket.
        let x = if x <= a || x >= b { middle } else { x };
        let y = at(x)?;
        if y == 0.0 {
            return Ok(x);
        }
        if y * rising > 0.0 {
            (b, yb) = (x, y);
        } else {
            (a, ya) = (x, y);
        }
    }
    Err(NumericsError::Limit {
        what: "evaluations of a root-finder",
        limit: LIMIT,
        at: a,
    })
}

/// Enough for plain bisection of the whole range of f64 (2¹¹ binary orders, 53 bits), twice.
const LIMIT: usize = 2 * (2048 + 64);

/// The point to try next: interpolate, truncate, project.
fn next(a: f64, b: f64, ya: f64, yb: f64, width: f64, tolerance: f64, step: usize) -> f64 {
    let middle = a + 0.5 * (b - a);
    if !(ya.is_finite() && yb.is_finite()) || step >= 60 {
        return middle;
    }
    let chord = a + (b - a) * (ya / (ya - yb));
    let towards = if middle >= chord { 1.0 } else { -1.0 };
    let kappa = 0.2 / width;
    let truncation = (kappa * (b - a) * (b - a)).max(tolerance);
    let truncated = if truncation <= (middle - chord).abs() {
        chord + towards * truncation
    } else {
        middle
    };
    // n_max of the paper is what bisection needs; one more step is granted.
    let bisections = libm::ceil(libm::log2(width / (2.0 * tolerance))).max(0.0);
    let slack = tolerance * libm::exp2(bisections + 1.0 - step as f64) - 0.5 * (b - a);
    if (truncated - middle).abs() <= slack {
        truncated
    } else {
        middle - towards * slack.max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Function, bracket, root.
    type Case = (fn(f64) -> f64, f64, f64, f64);

    #[test]
    fn roots_of_many_shapes() {
        let cases: [Case; 6] = [
            (|x| x * x - 2.0, 0.0, 2.0, std::f64::consts::SQRT_2),
            (libm::cos, 0.0, 3.0, std::f64::consts::FRAC_PI_2),
            (|x| libm::exp(x) - 1e-10, -100.0, 100.0, -23.025850929940457),
            (|x| (x - 0.3) * (x - 0.3) * (x - 0.3), -1.0, 5.0, 0.3),
            (|x| 1.0 / (x - 1.0), 0.0, 3.0, 1.0),
            (|x| x - 1e-200, -1.0, 1.0, 1e-200),
        ];
        for (f, low, high, expected) in cases {
            let found = root(f, low, high).unwrap();
            let turned = root(f, high, low).unwrap();
            assert!(
                (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
                "{found} {expected}"
            );
            assert_eq!(found, turned);
        }
    }

    #[test]
    fn few_evaluations_on_smooth_functions() {
        let mut count = 0;
        let found = root(
            |x| {
                count += 1;
                libm::exp(x) - 2.0
            },
            0.0,
            1.0,
        )
        .unwrap();
        assert!((found - std::f64::consts::LN_2).abs() < 3e-16);
        assert!(count < 20, "{count}");
    }

    #[test]
    fn errors_are_typed() {
        assert!(matches!(
            root(|x| x * x + 1.0, 0.0, 1.0),
            Err(NumericsError::NoSignChange { .. })
        ));
        assert!(matches!(
            root(|x| x, f64::NAN, 1.0),
            Err(NumericsError::Argument { name: "low", .. })
        ));
        assert!(matches!(
            root(|x| x, -1.0, f64::INFINITY),
            Err(NumericsError::Argument { name: "high", .. })
        ));
        assert!(matches!(
            root(|x| libm::sqrt(x) - 1.0, -4.0, 4.0),
            Err(NumericsError::NotFinite { .. })
        ));
    }
}
