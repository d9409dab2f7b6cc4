//! Integrals: by a Gauss–Legendre rule where the integrand is smooth, and else through the adaptive
//! Gauss–Kronrod rule of `quad-rs`.
//!
//! Put an end at which the integrand is infinite at 0: numbers are dense there, near 1 they are not.

use super::error::{NumericsError, finite};
#[cfg(all(feature = "trials", not(target_family = "wasm")))]
use quad_rs::{Integrable, IntegratorConfig, integrate_real};

/// An integral and an estimate of its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integral {
    /// The value.
    pub value: f64,
    /// Estimate of the absolute error; usually far too large.
    pub error: f64,
}

#[cfg(all(feature = "trials", not(target_family = "wasm")))]
struct Integrand<'f>(&'f dyn Fn(f64) -> f64);

#[cfg(all(feature = "trials", not(target_family = "wasm")))]
impl Integrable for Integrand<'_> {
    type Float = f64;
    type Input = f64;
    type Output = f64;
    fn integrand(&self, x: &f64) -> f64 {
        (self.0)(*x)
    }
}

/// The integral of `f` from `low` to `high` (either order), to about 10⁻¹⁴ of ∫|f|, without the ends.
///
/// Cost: at most 200,000 evaluations of `f`.
///
/// # Errors
/// [`NumericsError::Argument`] for an end that is not finite, [`NumericsError::Library`] when the rule gives up
/// (an integrand that is not finite inside, or 200,000 evaluations).
pub fn integral(f: impl Fn(f64) -> f64, low: f64, high: f64) -> Result<Integral, NumericsError> {
    integral_within(f, low, high, ABSOLUTE)
}

/// As [`integral`], with an error of `absolute`: for an integral that may be zero.
///
/// # Errors
/// As for [`integral`], and [`NumericsError::Argument`] for an `absolute` that is not finite and positive.
pub fn integral_within(
    f: impl Fn(f64) -> f64,
    low: f64,
    high: f64,
    absolute: f64,
) -> Result<Integral, NumericsError> {
    if !(absolute.is_finite() && absolute > 0.0) {
        return Err(NumericsError::Argument {
            name: "absolute",
            value: absolute,
            range: "finite and positive",
        });
    }
    finite("low", low)?;
    finite("high", high)?;
    if low == high {
        return Ok(Integral {
            value: 0.0,
            error: 0.0,
        });
    }
    let integral = smooth(&f, low, high);
    if integral.value.is_finite() && integral.error <= absolute.max(RELATIVE * integral.value.abs())
    {
        return Ok(integral);
    }
    let integral = adaptive(&f, low, high, absolute)?;
    if integral.value.is_finite() && integral.error.is_finite() {
        return Ok(integral);
    }
    Err(NumericsError::NotFinite {
        what: "the integral",
        at: high,
    })
}

/// The value of [`integral_within`]; not a number where there is none.
pub fn sum(f: impl Fn(f64) -> f64, low: f64, high: f64, absolute: f64) -> f64 {
    integral_within(f, low, high, absolute).map_or(f64::NAN, |sum| sum.value)
}

#[cfg(all(feature = "trials", not(target_family = "wasm")))]
fn adaptive(
    f: &dyn Fn(f64) -> f64,
    low: f64,
    high: f64,
    absolute: f64,
) -> Result<Integral, NumericsError> {
    let config = IntegratorConfig::default()
        .with_minimum_segment_width(1e-300)
        .with_max_function_evalutions(EVALUATIONS)
        .with_relative_tolerance(RELATIVE)
        .with_absolute_tolerance(absolute);
    let result = integrate_real(Integrand(f), vec![low, high], config).map_err(|error| {
        NumericsError::Library {
            method: "adaptive quadrature",
            message: error.to_string(),
        }
    })?;
    Ok(Integral {
        value: result.integral,
        error: result.error,
    })
}

/// By halves of halves: in a page of the book the library asks for a clock that is not there.
#[cfg(not(all(feature = "trials", not(target_family = "wasm"))))]
fn adaptive(
    f: &dyn Fn(f64) -> f64,
    low: f64,
    high: f64,
    absolute: f64,
) -> Result<Integral, NumericsError> {
    let mut sum = Integral {
        value: 0.0,
        error: 0.0,
    };
    let mut open = vec![(low, high)];
    let mut evaluations = 0;
    while let Some((from, to)) = open.pop() {
        evaluations += 60;
        let piece = smooth(f, from, to);
        let middle = 0.5 * (from + to);
        let short = (to - from).abs() <= 1e-300 || middle == from || middle == to;
        let scale = RELATIVE * (piece.value + sum.value).abs();
        if short || piece.error <= absolute.max(scale) {
            sum.value += piece.value;
            sum.error += piece.error;
        } else if evaluations > EVALUATIONS {
            return Err(NumericsError::Library {
                method: "adaptive quadrature",
                message: "too many evaluations".to_owned(),
            });
        } else {
            open.extend([(from, middle), (middle, to)]);
        }
    }
    Ok(sum)
}

/// By the rule on both halves. Its difference from the rule on the whole is far more than its error.
fn smooth(f: impl Fn(f64) -> f64, low: f64, high: f64) -> Integral {
    let rule = |from: f64, to: f64| {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let pair =
            |(x, weight): &(f64, f64)| weight * (f(middle - half * x) + f(middle + half * x));
        half * GAUSS.iter().map(pair).sum::<f64>()
    };
    let middle = 0.5 * (low + high);
    let value = rule(low, middle) + rule(middle, high);
    Integral {
        value,
        error: (value - rule(low, high)).abs() + ROUNDING * value.abs(),
    }
}

/// With 20 nodes on [−1, 1]: the positive ones, and their weights.
const GAUSS: [(f64, f64); 10] = [
    (0.07652652113349734, 0.15275338713072584),
    (0.22778585114164507, 0.14917298647260374),
    (0.37370608871541955, 0.14209610931838204),
    (0.5108670019508271, 0.13168863844917664),
    (0.636053680726515, 0.11819453196151841),
    (0.7463319064601508, 0.10193011981724044),
    (0.8391169718222188, 0.08327674157670475),
    (0.912234428251326, 0.06267204833410907),
    (0.9639719272779138, 0.04060142980038694),
    (0.9931285991850949, 0.017614007139152118),
];

/// What the rule's rounding errors amount to.
const ROUNDING: f64 = 2.0 * f64::EPSILON;

/// A logarithmic or root singularity takes a few thousand.
const EVALUATIONS: usize = 200_000;
/// Just above what the library's own estimate can reach (50 units of rounding).
const RELATIVE: f64 = 1.2e-14;
const ABSOLUTE: f64 = 1e-300;

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn close(found: Result<Integral, NumericsError>, expected: f64) {
        let found = found.unwrap();
        let off = (found.value - expected).abs();
        assert!(off <= 1e-13 * expected.abs(), "{found:?} {expected}");
        assert!(
            off <= found.error.max(1e-15 * expected.abs()),
            "{found:?} {expected}"
        );
    }

    #[test]
    fn smooth_integrands() {
        close(integral(libm::exp, 0.0, 1.0), libm::expm1(1.0));
        close(integral(libm::exp, 1.0, 0.0), -libm::expm1(1.0));
        close(integral(|x| libm::exp(-x * x), -8.0, 8.0), libm::sqrt(PI));
        close(
            integral(|x| 1.0 / (1e-4 + x * x), -1.0, 1.0),
            200.0 * libm::atan(100.0),
        );
        close(integral(|x| 1e-200 * x, 0.0, 1.0), 0.5e-200);
    }

    #[test]
    fn the_rule_is_exact_up_to_its_degree() {
        for degree in 0..40 {
            let found = smooth(|x| libm::pow(x, f64::from(degree)), 0.0, 1.0);
            let expected = 1.0 / f64::from(degree + 1);
            assert!(
                (found.value - expected).abs() < 1e-15 * expected.max(0.1),
                "{degree}"
            );
            assert!(found.error < 1e-15, "{degree} {found:?}");
        }
    }

    #[test]
    fn no_integral_no_number() {
        assert!(integral(|x| 1.0 / x, 0.0, 1.0).is_err());
        assert!(integral(|_| f64::NAN, 0.0, 1.0).is_err());
        assert!(matches!(
            integral(|x| x, 0.0, f64::NAN),
            Err(NumericsError::Argument { name: "high", .. })
        ));
        assert_eq!(integral(|x| x, 1.0, 1.0).unwrap().value, 0.0);
        assert_eq!(integral(|_| 0.0, 0.0, 1.0).unwrap().value, 0.0);
    }
}
