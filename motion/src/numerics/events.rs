//! When a function that is known by its series over a step is zero.
//!
//! The extrema of the series, found by the crate `polycool`, cut the step into pieces on each of which the [bracketing
//! root-finder](super::roots) finishes. An extremum that is zero within rounding is a root too.

use polycool::PolyDyn;
use trialbook::numerics::{error::NumericsError, roots::root, series::value};

/// How a function is zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// Touching zero without going through, as far as rounding lets one see.
    Touching,
}

/// A root of a series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// Distance from the beginning of the step.
    pub at: f64,
    /// Whether the function goes through zero.
    pub way: Way,
}

/// The roots of a series in (0, `h`], in order; of several that rounding does not part the first. One at 0 (first coefficients
/// exactly zero) does not count; a series that is zero has none.
///
/// # Errors
/// [`NumericsError::NotFinite`] when a coefficient times its power of `h` is not finite.
pub fn roots(series: &[f64], h: f64) -> Result<Vec<Root>, NumericsError> {
    // In units of the step all coefficients are sizes of terms.
    let mut power = 1.0;
    let mut scaled = Vec::new();
    let start = series
        .iter()
        .position(|c| *c != 0.0)
        .unwrap_or(series.len());
    for c in &series[start..] {
        let term = if *c == 0.0 { 0.0 } else { c * power };
        if !term.is_finite() {
            return Err(NumericsError::NotFinite {
                what: "a term of an event's series",
                at: h,
            });
        }
        scaled.push(term);
        power *= h;
    }
    let size: f64 = scaled.iter().map(|c| c.abs()).sum();
    if scaled.is_empty() || 2.0 * scaled[0].abs() > size {
        return Ok(Vec::new());
    }
    while scaled.last().is_some_and(|c| c.abs() < NEGLIGIBLE * size) {
        scaled.pop();
    }
    for c in &mut scaled {
        *c /= size;
    }
    if keeps_sign(&scaled) {
        return Ok(Vec::new());
    }
    let slope = scaled.iter().enumerate().skip(1).map(|(k, c)| c * k as f64);
    let slope: Vec<f64> = slope.collect();
    let mut nodes = if keeps_sign(&slope) {
        Vec::new()
    } else {
        PolyDyn::new(slope).roots_between(0.0, 1.0, f64::EPSILON)
    };
    nodes.retain(|u| *u > 0.0 && *u < 1.0);
    nodes.push(1.0);
    let at = |u: f64| value(&scaled, &u);
    let mut found = Vec::new();
    // The function is surely not zero at `a`, on the side `before` of zero; `zero` is a node since then at which it is zero
    // within rounding.
    let (mut a, mut before, mut zero) = (0.0, scaled[0], None);
    for b in nodes {
        let y = at(b);
        let unsure = if b < 1.0 {
            y.abs() <= rounding(&scaled, b)
        } else {
            y == 0.0
        };
        if unsure {
            zero = zero.or(Some(b));
            continue;
        }
        let through = (y > 0.0) != (before > 0.0);
        let way = if y > 0.0 { Way::Rising } else { Way::Falling };
        match zero.take() {
            Some(u) => found.push(Root {
                at: u * h,
                way: if through { way } else { Way::Touching },
            }),
            None if through => found.push(Root {
                at: root(at, a, b)? * h,
                way,
            }),
            None => {}
        }
        (a, before) = (b, y);
    }
    // What reaches zero at the very end has gone through as far as one can see.
    if let Some(u) = zero {
        let way = if before < 0.0 {
            Way::Rising
        } else {
            Way::Falling
        };
        found.push(Root { at: u * h, way });
    }
    Ok(found)
}

/// Relative size of last terms that no value notices.
const NEGLIGIBLE: f64 = 1e-20;

/// By more than rounding, seen from the Bernstein coefficients on [0, 1]; it may be so without this being seen.
fn keeps_sign(polynomial: &[f64]) -> bool {
    // b_j = Σ C(j, i)/C(n, i) a_i, i ≤ j: the sums of a triangle of a_i/C(n, i), row by row.
    let n = polynomial.len().saturating_sub(1);
    let mut choose = 1.0;
    let mut triangle: Vec<f64> = Vec::with_capacity(polynomial.len());
    for (i, a) in polynomial.iter().enumerate() {
        triangle.push(a / choose);
        choose *= (n - i) as f64 / (i + 1) as f64;
    }
    let size: f64 = polynomial.iter().map(|a| a.abs()).sum();
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for from in 0..triangle.len() {
        (least, most) = (least.min(triangle[0]), most.max(triangle[0]));
        for i in 0..triangle.len() - from - 1 {
            triangle[i] += triangle[i + 1];
        }
    }
    let rounding = n as f64 * f64::EPSILON * size;
    least > rounding || most < -rounding
}

/// Of the value at `u`.
fn rounding(scaled: &[f64], u: f64) -> f64 {
    4.0 * f64::EPSILON * scaled.iter().rev().fold(0.0, |sum, c| sum * u + c.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_with_a_zero_does_not_keep_its_sign() {
        for zero in [1e-9, 0.3, 0.5, 1.0 - 1e-9] {
            for others in [&[][..], &[2.0], &[-1.0, 3.0], &[zero]] {
                let roots = [&[zero], others].concat();
                assert!(!keeps_sign(&with_roots(&roots)), "{roots:?}");
            }
        }
        assert!(keeps_sign(&with_roots(&[-0.1, 1.1])));
        assert!(keeps_sign(&[-1.0, -0.5, 0.2]));
    }

    fn with_roots(given: &[f64]) -> Vec<f64> {
        given.iter().fold(vec![1.0], |p, r| {
            let mut q = vec![0.0; p.len() + 1];
            for (k, c) in p.iter().enumerate() {
                q[k + 1] += c;
                q[k] -= r * c;
            }
            q
        })
    }

    #[test]
    fn simple_roots_in_order_with_their_ways() {
        let found = roots(&with_roots(&[0.25, 1.5, 3.0, -2.0]), 2.0).unwrap();
        assert_eq!(found.len(), 2);
        assert!(
            (found[0].at - 0.25).abs() < 1e-15 && found[0].way == Way::Rising,
            "{found:?}"
        );
        assert!((found[1].at - 1.5).abs() < 3e-15 && found[1].way == Way::Falling);
    }

    #[test]
    fn double_roots_and_near_ones() {
        let found = roots(&with_roots(&[0.5, 0.5, 4.0]), 2.0).unwrap();
        assert_eq!(found.len(), 1, "{found:?}");
        assert!((found[0].at - 0.5).abs() < 1e-7 && found[0].way == Way::Touching);
        let found = roots(&with_roots(&[0.5, 0.500001, 4.0]), 2.0).unwrap();
        assert_eq!(found.len(), 2);
        assert!((found[0].at - 0.5).abs() < 1e-9 && (found[1].at - 0.500001).abs() < 1e-9);
        // (u − ½)² + 10⁻⁸ comes near and does not touch.
        assert!(roots(&[0.25 + 1e-8, -1.0, 1.0], 1.0).unwrap().is_empty());
    }

    #[test]
    fn of_roots_that_rounding_does_not_part_the_first_is_found() {
        // Between the two that it touches the function is below 10⁻¹⁷.
        let series = with_roots(&[0.3, 0.3, 0.3001, 0.3001]);
        for h in [1.0, 0.7] {
            let found = roots(&series, h).unwrap();
            assert_eq!(found.len(), 1, "{found:?}");
            assert!(
                (found[0].at - 0.3).abs() < 2e-5 && found[0].way == Way::Touching,
                "{found:?}"
            );
        }
    }

    #[test]
    fn triple_roots_go_through() {
        let found = roots(&with_roots(&[0.5, 0.5, 0.5]), 2.0).unwrap();
        assert_eq!(found.len(), 1, "{found:?}");
        assert!((found[0].at - 0.5).abs() < 1e-5 && found[0].way == Way::Rising);
    }

    #[test]
    fn the_ends_of_the_step() {
        let found = roots(&[0.0, -1.0, 1.0], 1.0).unwrap();
        assert_eq!(
            found,
            [Root {
                at: 1.0,
                way: Way::Rising
            }]
        );
        assert!(roots(&[0.0, -1.0, 1.0], 0.9).unwrap().is_empty());
        assert!(roots(&[0.0; 5], 1.0).unwrap().is_empty());
        assert!(roots(&[-1.0, f64::INFINITY], 1.0).is_err());
    }

    #[test]
    fn a_long_series() {
        let mut sine = [0.0; 40];
        let mut term = 1.0;
        for k in 1..40 {
            term /= k as f64;
            sine[k] = [0.0, term, 0.0, -term][k % 4];
        }
        let found = roots(&sine, 3.5).unwrap();
        assert_eq!(found.len(), 1);
        assert!(
            (found[0].at - std::f64::consts::PI).abs() < 2e-15,
            "{found:?}"
        );
    }
}
