//! Roots of one equation in one unknown, from a bracket. [`root`] needs only values (Chandrupatla, "A new
//! hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function without using
//! derivatives", Adv. Eng. Softw. 28, 1997); [`falling_root`] is Newton's method.

use super::error::{NumericsError, finite};

/// A root of `f` between `low` and `high`, to two units in the last place of the root, or of the smallest
/// normal number; or the place where `f` jumps across zero.
///
/// Cost: at most 4,224 evaluations of `f`.
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
    // The newest end of the bracket is `a`; `c` is the end that it has replaced, or the other's predecessor.
    let mut part = 0.5;
    for step in 1..=LIMIT {
        let x = a + part * (b - a);
        let y = at(x)?;
        let (c, yc);
        if (y > 0.0) == (ya > 0.0) {
            (c, yc) = (a, ya);
        } else {
            (c, yc) = (b, yb);
            (b, yb) = (a, ya);
        }
        (a, ya) = (x, y);
        let (best, least) = if ya.abs() < yb.abs() {
            (a, ya)
        } else {
            (b, yb)
        };
        let middle = a + 0.5 * (b - a);
        let tolerance = (f64::EPSILON * middle.abs()).max(f64::MIN_POSITIVE);
        let between = middle > a.min(b) && middle < a.max(b);
        if least == 0.0 || (b - a).abs() <= 2.0 * tolerance || !between {
            return Ok(best);
        }
        // Never nearer to an end than the tolerance: the step after a good guess closes the bracket.
        let margin = tolerance / (b - a).abs();
        part = if step > PATIENCE {
            0.5
        } else {
            interpolated([a, b, c], [ya, yb, yc]).clamp(margin, 1.0 - margin)
        };
    }
    Err(NumericsError::Limit {
        what: "evaluations of a root-finder",
        limit: LIMIT,
        at: a,
    })
}

/// Steps after which [`root`] only bisects.
const PATIENCE: usize = 60;

/// Bisection of the whole range of f64 takes half as many (2¹¹ binary orders, 53 bits).
const LIMIT: usize = 2 * (2048 + 64);

fn interpolated([a, b, c]: [f64; 3], [ya, yb, yc]: [f64; 3]) -> f64 {
    let xi = (a - b) / (c - b);
    let phi = (ya - yb) / (yc - yb);
    // False also for values that are not finite.
    if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
        let near = ya / (yb - ya) * (yc / (yb - yc));
        let far = (c - a) / (b - a) * (ya / (yc - ya)) * (yb / (yc - yb));
        near + far
    } else {
        0.5
    }
}

/// Halving alone needs fewer.
const STEPS: usize = 128;

/// The root of a function that is positive at `low` and negative at `high`, by Newton's method from `guess`;
/// `function` returns value and slope.
pub fn falling_root(
    mut low: f64,
    mut high: f64,
    guess: f64,
    function: impl Fn(f64) -> (f64, f64),
) -> f64 {
    // Not `clamp`, which panics at ends in the wrong order.
    let mut x = guess.max(low).min(high);
    let mut last_step = f64::INFINITY;
    let mut last = None;
    for _ in 0..STEPS {
        let (value, slope) = function(x);
        if value > 0.0 {
            low = x;
        } else if value < 0.0 {
            high = x;
        } else {
            return x;
        }
        let mut next = x - value / slope;
        let newton = next >= low && next <= high;
        if !newton {
            next = 0.5 * (low + high);
        }
        let step = (next - x).abs();
        if step <= f64::EPSILON * x.abs() || next == low && next == high {
            return next;
        }
        if newton {
            // What Newton's step leaves is step² times half the relative curvature.
            if let Some((x0, slope0)) = last {
                let curvature: f64 = (slope - slope0) / (x - x0);
                if (0.5 * curvature / slope).abs() * step * step <= 0.1 * f64::EPSILON * x.abs()
                    && step < 0.1 * last_step
                {
                    return next;
                }
            }
            if step < 1e-11 * x.abs() && step >= 0.5 * last_step {
                return next;
            }
        }
        last = Some((x, slope));
        last_step = step;
        x = next;
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

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
