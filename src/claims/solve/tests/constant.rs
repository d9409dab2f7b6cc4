//! Launched particles.

use super::*;
use crate::claims::solve::constant::{At, ConstantProblem, Formulas};
use crate::corrections::constant as corrected;
use crate::scalar::Scalar;
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

/// λ, v₀, θ₀, A, t; v, θ, v_x, v_y.
const LAUNCHES: [([f64; 5], [f64; 4]); 5] = [
    (
        [0.5, 1.0, 1.0, 1.0, 2.0],
        [
            1.7219967700957113,
            0.22314018240859393,
            1.679303920820284,
            0.3810658968442107,
        ],
    ),
    (
        [1.0, 2.0, 2.5, 1.5, 3.0],
        [
            0.19885638445306664,
            8.28944641394507e-8,
            0.19885638445306594,
            1.6484093429945537e-8,
        ],
    ),
    (
        [1.7, 1.3, 2.0, 1.0, 0.5],
        [
            0.3707367520572657,
            1.3151273023343835,
            0.09375663399136318,
            0.35868570212454814,
        ],
    ),
    (
        [0.0, 1.0, 2.0, 1.0, 1.0],
        [
            1.0806046117362795,
            1.0,
            0.5838531634528576,
            0.9092974268256817,
        ],
    ),
    (
        [2.5, 3.0, 0.4, 0.7, 1.1],
        [
            1.7987891830501443,
            0.28993912997248084,
            1.7237100243832941,
            0.5142628480638568,
        ],
    ),
];

#[test]
fn launches_by_time_and_back_by_angle() {
    for ([lambda, v0, theta0, accel, t], [v, theta, vx, vy]) in LAUNCHES {
        let given = [lambda, v0, theta0, accel];
        let answer = constant(given, At::Time(t)).solve().unwrap();
        agrees(
            &answer,
            &[("v", v), ("theta", theta), ("t", t), ("vx", vx), ("vy", vy)],
        );
        let back = constant(given, At::Theta(answer.best.theta))
            .solve()
            .unwrap();
        assert!((back.best.t - t).abs() < 1e-9 * t, "{} {t}", back.best.t);
        assert!(back.digits >= Some(8), "{back:?}");
        assert_eq!(answer.best.stop_time.is_some(), lambda > 1.0);
    }
}

#[test]
fn launches_along_the_axis() {
    let at = |lambda, theta0, at| constant([lambda, 2.0, theta0, 1.0], at).solve();
    let ahead = at(0.5, 0.0, At::Time(3.0)).unwrap();
    agrees(
        &ahead,
        &[("v", 3.5), ("theta", 0.0), ("vx", 3.5), ("vy", 0.0)],
    );
    agrees(
        &at(3.0, 0.0, At::Time(0.5)).unwrap(),
        &[("v", 1.0), ("stop_time", 1.0)],
    );
    agrees(&at(1.0, 0.0, At::Time(5.0)).unwrap(), &[("v", 2.0)]);
    let back = at(0.5, PI, At::Time(1.0)).unwrap();
    agrees(
        &back,
        &[("v", 0.5), ("theta", PI), ("vx", -0.5), ("vy", 0.0)],
    );
    assert_eq!(back.best.stop_time, None);
    let turned = at(0.5, PI, At::Time(3.0)).unwrap();
    agrees(&turned, &[("v", 0.5 * (3.0 - 4.0 / 3.0)), ("theta", 0.0)]);
    agrees(
        &at(0.5, PI, At::Theta(0.0)).unwrap(),
        &[("v", 0.0), ("t", 4.0 / 3.0)],
    );
    agrees(
        &at(1.0, PI, At::Time(7.0)).unwrap(),
        &[("v", 0.0), ("theta", PI), ("stop_time", 1.0)],
    );
    agrees(
        &at(2.0, PI, At::Theta(PI)).unwrap(),
        &[("v", 2.0), ("t", 0.0)],
    );
    for (lambda, theta0, theta) in [
        (0.5, 0.0, 0.1),
        (1.0, PI, 0.0),
        (2.0, PI, 0.0),
        (0.5, PI, 1.0),
        (0.5, 1.0, 0.0),
        (0.5, 1.0, 2.0),
        (2.0, 1.0, -0.5),
    ] {
        let error = at(lambda, theta0, At::Theta(theta)).unwrap_err();
        assert!(
            matches!(error, SolveError::Parameter { name: "theta", .. }),
            "{error}"
        );
    }
}

#[test]
fn a_stopped_particle_keeps_the_angle_to_which_it_tended() {
    let rest = constant([1.5, 1.0, 2.0, 1.0], At::Time(9.0))
        .solve()
        .unwrap();
    agrees(
        &rest,
        &[
            ("v", 0.0),
            ("theta", 0.0),
            ("t", 9.0),
            ("stop_time", (1.5 + 2_f64.cos()) / 1.25),
        ],
    );
}

#[test]
fn bad_parameters_are_named() {
    let good = [0.5, 1.0, 1.0, 1.0];
    for (i, name, bad) in [
        (0, "lambda", -1.0),
        (1, "v0", 0.0),
        (2, "theta0", 4.0),
        (3, "accel", f64::NAN),
    ] {
        let mut given = good;
        given[i] = bad;
        match constant(given, At::Time(1.0)).solve() {
            Err(SolveError::Parameter { name: found, .. }) => assert_eq!(found, name),
            other => panic!("{other:?}"),
        }
    }
    let error = constant(good, At::Time(-1.0)).solve().unwrap_err();
    assert_eq!(error.to_string(), "time = -1 must be between 0 and 1e40");
}

#[test]
fn a_note_says_which_formulas_gave_the_state() {
    let note = |given, at| constant(given, at).solve().unwrap().note;
    let printed = "by (11) and (13)";
    for (given, at, begins) in [
        ([0.5, 1.0, 1.0, 1.0], At::Time(2.0), printed),
        ([1.7, 1.3, 2.0, 1.0], At::Theta(1.0), printed),
        // Large numbers and small ones: only relative errors count.
        ([0.5, 1e9, 1.0, 1.0], At::Time(2e9), printed),
        ([0.5, 1e-9, 1.0, 1.0], At::Time(2e-9), printed),
        (
            [1.0, 2.0, 2.5, 1.5],
            At::Time(3.0),
            "by the form that replaces",
        ),
        // So near λ = 1 the printed time has lost ten of its digits, whatever its size.
        (
            [1.0 + 1e-10, 2.0, 1.0, 1.0],
            At::Time(1.0),
            "by the form that replaces",
        ),
        (
            [1.0 + 1e-10, 2e-9, 1.0, 1.0],
            At::Time(1e-9),
            "by the form that replaces",
        ),
        (
            [0.5, 2.0, 0.0, 1.0],
            At::Time(1.0),
            "by uniformly accelerated motion",
        ),
        (
            [0.5, 2.0, PI, 1.0],
            At::Time(1.0),
            "by uniformly accelerated motion",
        ),
        ([1.5, 1.0, 2.0, 1.0], At::Time(9.0), "at rest: (20) is over"),
        (
            [400.0, 1.0, 0.3, 1.0],
            At::Theta(0.003),
            "by the limit of (11) and (13): it still moves there, slower than any floating-point number",
        ),
    ] {
        let note = note(given, at);
        assert!(note.starts_with(begins), "{given:?} {at:?}: {note}");
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
fn against_the_force_there_is_no_velocity_across() {
    let at = |lambda, accel, t| constant([lambda, 3.0, PI, accel], At::Time(t)).solve();
    let answer = at(0.5, 2.0, 0.25).unwrap();
    agrees(&answer, &[("v", 2.25), ("theta", PI), ("vx", -2.25)]);
    assert_eq!(answer.by_formula.unwrap().vy, 0.0);
    // Friction that only just holds: the stop is at v₀/(2A), later than v₀A where A is small.
    for accel in [0.25, 4.0] {
        let answer = at(1.0, accel, 0.1).unwrap();
        agrees(
            &answer,
            &[("stop_time", 1.5 / accel), ("v", 3.0 - 0.2 * accel)],
        );
    }
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
fn late_times_are_reached() {
    // At λ = 1 the angle falls for ever, v + v_x stays, and so v tends to half of it.
    let late = constant([1.0, 2.0, 1.0, 1.0], At::Time(1e4))
        .solve()
        .unwrap();
    agrees(&late, &[("v", 1.0 + libm::cos(1.0)), ("theta", 0.0)]);
    assert_eq!(late.best.stop_time, None);
    // Friction so strong that nothing else counts.
    let strong = constant([1e20, 1.0, 1.0, 1.0], At::Time(0.5e-20))
        .solve()
        .unwrap();
    agrees(&strong, &[("v", 0.5), ("theta", 1.0), ("stop_time", 1e-20)]);
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

#[test]
fn an_angle_that_only_the_formula_reaches_has_an_answer() {
    for (lambda, theta) in [(10.0, 0.01), (5.0, 1e-8), (100.0, 0.5)] {
        let launch = constant([lambda, 1.0, 1.0, 1.0], At::Theta(theta));
        let answer = launch.solve().unwrap();
        assert_eq!(
            (answer.by_motion, answer.digits, answer.disagreement),
            (None, Some(15), None)
        );
        // (11): sin θ v = sin θ₀ v₀ (tan θ/2 / tan θ₀/2)^λ.
        let part = libm::tan(0.5 * theta) / libm::tan(0.5);
        let v = libm::pow(part, lambda) * libm::sin(1.0) / libm::sin(theta);
        assert!((answer.best.v - v).abs() <= 1e-12 * v, "{answer:?}");
        assert!(answer.note.contains("the formula alone"), "{}", answer.note);
    }
    // Friction weaker: the motion gets there.
    assert!(
        constant([3.0, 1.0, 1.0, 1.0], At::Theta(0.01))
            .solve()
            .unwrap()
            .digits
            >= Some(7)
    );
    let wrong = constant([10.0, 1.0, 1.0, 1.0], At::Theta(1.5));
    assert!(matches!(
        wrong.solve(),
        Err(SolveError::Parameter { name: "theta", .. })
    ));
}

/// A launch straight against the inertial force, at the moment at which it turns round: v = 0, by hand.
#[test]
fn where_a_launch_turns_round_it_stands_still() {
    for (lambda, v0, accel) in [
        (0.0, 1.0, 1.0),
        (0.0, 2.0, 0.5),
        (0.25, 1.0, 1.0),
        (0.6, 3.0, 7.0),
    ] {
        let wide = |x: f64| format!("{x}").parse::<Double>().unwrap();
        let [lambda, v0, accel] = [lambda, v0, accel].map(wide);
        let turn = v0 / (accel * (lambda + 1.0.into()));
        let theta0 = Double::pi();
        let at = At::Time(turn);
        let launch = ConstantProblem {
            lambda,
            v0,
            theta0,
            accel,
            at,
        };
        let answer = launch.solve().unwrap();
        let report = answer.report("");
        assert_eq!(answer.digits, Some(15), "{launch:?}");
        for (name, right) in [("v", 0.0), ("t", turn.into()), ("vx", 0.0), ("vy", 0.0)] {
            let field = report
                .fields
                .iter()
                .find(|field| field.name == name)
                .unwrap();
            let Value::Number(found) = field.value else {
                panic!("{field:?}")
            };
            assert!(
                (found - right).abs() <= 1e-14 * right,
                "{launch:?}: {field:?}"
            );
        }
    }
    let [gamma, u0, kappa] = ["9", "1.3", "0.4"].map(|x| x.parse::<Double>().unwrap());
    let at = At::Time(u0 / "12.5".parse().unwrap());
    let theta0 = Double::pi();
    let ball = crate::claims::solve::sphere::SphereProblem {
        gamma,
        u0,
        theta0,
        kappa,
        at,
    };
    let answer = ball.solve().unwrap();
    assert_eq!(
        (answer.digits, answer.report("").fields[0].value),
        (Some(15), Value::Number(0.0))
    );
}
