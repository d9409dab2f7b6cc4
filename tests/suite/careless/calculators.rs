//! The calculators, and what the book's figures that move compute.

use super::{config, each, finite};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use rayon::prelude::*;
use slipbook::explorers::{QUESTIONS, answer};
use slipbook::solve::constant::At;
use slipbook::solve::*;

const MANY: usize = 32;

fn sound<T: Fields>(answer: Result<Answer<T>, SolveError>) -> bool {
    let Ok(answer) = answer else { return true };
    let numbers = answer
        .best
        .fields()
        .into_iter()
        .filter_map(|f| match f.value {
            Value::Number(x) => Some(x),
            _ => None,
        });
    let all: Vec<_> = numbers.chain(answer.disagreement).collect();
    finite(&all)
}

fn is_drawn(curve: Result<Curve, SolveError>) -> bool {
    curve.is_err() || curve.is_ok_and(|curve| finite(curve.points.as_flattened()))
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_launch_or_a_ball_has_numbers([a, b, c, d, e] in each(), timed: bool) {
        let at = if timed { At::Time(e) } else { At::Theta(e) };
        let (lambda, v0, theta0, accel) = (a, b, c, d);
        for accel in [accel, 1.0] {
            let launch = constant::ConstantProblem { lambda, v0, theta0, accel, at };
            prop_assert!(sound(launch.solve()) && is_drawn(launch.curve()), "{launch:?}");
        }
        for kappa in [d, 0.4] {
            let ball = sphere::SphereProblem { gamma: a, u0: b, theta0: c, kappa, at };
            prop_assert!(sound(ball.solve()) && is_drawn(ball.curve()), "{ball:?}");
        }
    }

    #[test]
    fn a_drive_has_numbers([a, b] in each()) {
        let sine = sinusoidal::SinusoidalProblem { lambda0: a };
        prop_assert!(sound(sine.solve()) && is_drawn(sine.curve()), "{sine:?}");
        let pulse = periodic::PeriodicProblem { eta: b, lambda0: a };
        prop_assert!(sound(pulse.solve()) && is_drawn(pulse.curve()), "{pulse:?}");
        let uneven = anisotropic::AnisotropicProblem { q: b, lambda0: a };
        prop_assert!(sound(uneven.solve()) && is_drawn(uneven.curve()), "{uneven:?}");
    }

    #[test]
    fn a_figure_that_moves_shows_numbers(number in 0..QUESTIONS.len() + 1, arguments in each()) {
        if let Ok(answer) = answer(number, arguments) {
            prop_assert!(finite(&answer.flat()), "{answer:?}");
        }
    }

    #[test]
    fn a_turntable_has_numbers([a, b, c, d, e] in each()) {
        for start in [
            turntable::TurntableProblem::Polar { rho: a, p: b, psi: c },
            turntable::TurntableProblem::Hyperbolic { a, alpha: b, psi: c },
            turntable::TurntableProblem::Cartesian { position: [a, b], velocity: [c, d] },
        ] {
            prop_assert!(sound(start.fate()), "{start:?}");
            prop_assert!(sound(start.at(e)) && sound(start.at(1.0)), "{start:?} {e}");
            prop_assert!(is_drawn(start.curve(Some(e))) && is_drawn(start.curve(None)), "{start:?} {e}");
        }
    }
}

/// The longest: on all cores, not by the macro, for which `PROPTEST_CASES` is the number of times.
#[test]
fn the_boundary_of_rest_has_numbers() {
    let times = config().cases.div_ceil(MANY as u32);
    let config = ProptestConfig {
        cases: times,
        ..config()
    };
    let asked = prop::collection::vec(each(), MANY);
    let tried = TestRunner::new(config).run(&asked, |asked| {
        let problem = |[alpha, psi]: [f64; 2]| rest::BoundaryProblem { alpha, psi };
        let wrong = asked.into_par_iter().map(problem).find_any(|boundary| {
            let numbers = || sound(boundary.solve()) && is_drawn(boundary.curve());
            !std::panic::catch_unwind(numbers).is_ok_and(|sound| sound)
        });
        prop_assert!(wrong.is_none(), "{wrong:?}");
        Ok(())
    });
    if let Err(why) = tried {
        panic!("{why}");
    }
}
