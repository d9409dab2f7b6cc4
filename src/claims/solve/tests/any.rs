//! Whatever is given.

use crate::claims::solve::constant::At;
use crate::claims::solve::*;
use proptest::prelude::*;

/// Any bit pattern, or a number of ordinary size.
fn any() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => prop::num::f64::ANY,
        4 => -4.0..4.0,
        1 => prop::sample::select(vec![0.0, 1.0, -1.0, std::f64::consts::PI, 1e-20, 1e20]),
        1 => (-20.0..20.0).prop_map(libm::exp10),
    ]
}

/// All numbers of an answer are finite.
fn sound<T: Fields + Clone>(answer: Result<Answer<T>, SolveError>) -> bool {
    let Ok(answer) = answer else { return true };
    let numbers = answer
        .best
        .fields()
        .into_iter()
        .filter_map(|f| match f.value {
            Value::Number(x) => Some(x),
            _ => None,
        });
    let finite = |x: f64| x.is_finite();
    numbers.into_iter().all(finite) && answer.disagreement.is_none_or(finite)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn whatever_is_given_there_are_numbers_or_an_error([a, b, c, d, e] in [any(), any(), any(), any(), any()], timed: bool) {
        let at = if timed { At::Time(e) } else { At::Theta(e) };
        let (lambda, v0, theta0, accel) = (a, b, c, d);
        let launch = constant::Problem { lambda, v0, theta0, accel, at };
        prop_assert!(sound(launch.solve()), "{launch:?}");
        let ball = sphere::Problem { gamma: a, u0: b, theta0: c, kappa: d, at };
        prop_assert!(sound(ball.solve()), "{ball:?}");
        prop_assert!(sound(sinusoidal::Problem { lambda0: a }.solve()), "{a}");
        prop_assert!(sound(periodic::Problem { eta: b, lambda0: a }.solve()), "{b} {a}");
        prop_assert!(sound(anisotropic::Problem { q: b, lambda0: a }.solve()), "{b} {a}");
        prop_assert!(sound(rest::Problem { alpha: a, psi: b }.solve()), "{a} {b}");
        for start in [
            turntable::Problem::Polar { rho: a, p: b, psi: c },
            turntable::Problem::Hyperbolic { a, alpha: b, psi: c },
            turntable::Problem::Cartesian { position: [a, b], velocity: [c, d] },
        ] {
            prop_assert!(sound(start.fate()), "{start:?}");
            prop_assert!(sound(start.at(e.min(100.0))), "{start:?} {e}");
        }
    }
}
