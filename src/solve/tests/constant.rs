//! Launched particles.

use super::*;
use crate::corrections::constant as corrected;
use crate::solve::constant::{At, ConstantProblem, Formulas};
use std::f64::consts::PI;

fn constant([lambda, v0, theta0, accel]: [f64; 4], at: At) -> ConstantProblem {
    ConstantProblem {
        lambda,
        v0,
        theta0,
        accel,
        at,
    }
}

#[test]
fn the_formulas_refuse_an_angle_that_the_velocity_never_has() {
    let at = |theta0: f64, theta: f64| {
        let formulas = Formulas {
            lambda: 0.5.into(),
            a: 1.0.into(),
            v0: 1.0.into(),
            theta0: theta0.into(),
        };
        formulas.at(At::Theta(theta.into()))
    };
    for theta in [0.0, 1.1, 2.0, -0.5, -1.0, -2.0, PI] {
        assert!(at(1.0, theta).is_err(), "{theta}");
        assert!(at(-1.0, -theta).is_err(), "{theta}");
    }
    assert!(at(1.0, 0.5).is_ok());
    assert!(at(-1.0, -0.5).is_ok());
}

#[test]
fn at_the_moment_of_the_stop_both_ways_have_the_angle_to_which_it_tended() {
    // Against the force the stop is at v₀/(λ + 1), a number without rounding here.
    let frictions = [1.0, 3.0, 7.0, 15.0, 31.0];
    let launches = frictions.map(|lambda| (1..=16).map(move |n| (lambda, f64::from(n) / 4.0)));
    for (lambda, v0) in launches.into_iter().flatten() {
        let stop = v0 / (lambda + 1.0);
        let answer = constant([lambda, v0, PI, 1.0], At::Time(stop)).solve();
        let answer = answer.unwrap();
        for state in [
            answer.best,
            answer.by_formula.unwrap(),
            answer.by_motion.unwrap(),
        ] {
            assert!(
                state.v < 1e-15 && state.theta == PI,
                "{lambda} {v0}: {answer:?}"
            );
            assert!(
                (state.stop_time.unwrap() - stop).abs() <= 1e-15 * stop,
                "{answer:?}"
            );
        }
    }
}

#[test]
fn at_the_stop_itself_the_particle_is_at_rest_and_before_it_moves() {
    let [lambda, one, theta0] = [1.5, 1.0, 2.0].map(Double::from);
    let formulas = Formulas {
        lambda,
        a: one,
        v0: one,
        theta0,
    };
    let at = |formulas: Formulas, t| formulas.at(At::Time(t)).unwrap();
    let stop = at(formulas, 0.1.into()).stop_time.unwrap();
    let state = at(formulas, stop);
    assert_eq!((f64::from(state.v), f64::from(state.theta)), (0.0, 0.0));
    assert!(f64::from(at(formulas, stop * (1.0 - 1e-15).into()).v) > 0.0);
    // Where the search for the time begins, it may have found it.
    for lambda in [0.0, 1.0, 3.0].map(Double::from) {
        let formulas = Formulas { lambda, ..formulas };
        let ln_r = -one / (one + lambda);
        let t = corrected::time(lambda, one, one, theta0, ln_r);
        let theta = f64::from(at(formulas, t).theta);
        let ratio = libm::tan(0.5 * theta) / libm::tan(1.0);
        assert!(
            (libm::log(ratio) - f64::from(ln_r)).abs() < 1e-15,
            "{theta}"
        );
    }
}
