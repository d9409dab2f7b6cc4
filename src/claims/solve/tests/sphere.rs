//! Spheres.

use super::*;
use crate::claims::solve::constant::At;
use crate::claims::solve::sphere::{SphereProblem, SphereState};
use std::f64::consts::PI;

#[test]
fn spheres_by_time_and_back_by_angle() {
    // γ, u₀, θ₀, κ, τ; u, θ, u_x, u_y, ζ_x, ζ_y.
    let cases = [
        (
            [2.0, 1.0, 1.0, 0.4, 0.3],
            [
                0.3951608695509478,
                0.41717493819888074,
                0.36127078415398106,
                0.16011100318538016,
                -0.4866857011589403,
                0.5564510869386847,
            ],
        ),
        (
            [10.0, 2.0, 2.5, 0.4, 0.5],
            [
                2.5945935691904234,
                0.11617200075947703,
                2.5771050196894842,
                0.30074159468813505,
                -0.6401447810855556,
                0.5861483922976058,
            ],
        ),
        (
            [3.5, 1.0, 2.0, 0.4, 0.2],
            [
                0.34676958041683714,
                0.8179864996408386,
                0.23708358303602045,
                0.2530622780211853,
                -0.46873939200321174,
                0.03340684315488368,
            ],
        ),
        (
            [1.0, 3.0, -1.2, 2.0 / 3.0, 0.7],
            [
                1.5831518406202665,
                -0.9238937273131929,
                0.9541936618793545,
                -1.2632831060726673,
                0.919700491097407,
                0.4997277609303998,
            ],
        ),
    ];
    for ([gamma, u0, theta0, kappa, tau], [u, theta, u_x, u_y, zeta_x, zeta_y]) in cases {
        let problem = |at| SphereProblem {
            gamma,
            u0,
            theta0,
            kappa,
            at,
        };
        let answer = problem(At::Time(tau)).solve().unwrap();
        let slip = [
            ("u", u),
            ("theta", theta),
            ("tau", tau),
            ("u_x", u_x),
            ("u_y", u_y),
        ];
        agrees(&answer, &slip);
        agrees(&answer, &[("zeta_x", zeta_x), ("zeta_y", zeta_y)]);
        let back = problem(At::Theta(answer.best.theta)).solve().unwrap();
        assert!((back.best.tau - tau).abs() < 1e-10, "{}", back.best.tau);
        assert!(back.digits >= Some(11), "{back:?}");
        assert_eq!(answer.best.rolls_at.is_some(), 1.0 + 1.0 / kappa > gamma);
    }
}

#[test]
fn a_sphere_rolls_on_with_the_spin_that_rolling_gives() {
    let problem = |at| SphereProblem {
        gamma: 1.0,
        u0: 1.0,
        theta0: PI,
        kappa: 0.4,
        at,
    };
    let answer = problem(At::Time(2.0)).solve().unwrap();
    // The slip is 0 at 1/(γ + b). κ dζ_y/dτ is the direction of the slip until then, and γ/b in rolling.
    let rolls_at = 1.0 / 4.5;
    let zeta_y = ((2.0 - rolls_at) / 3.5 - rolls_at) / 0.4;
    agrees(&answer, &[("u", 0.0), ("rolls_at", rolls_at)]);
    agrees(&answer, &[("zeta_x", 0.0), ("zeta_y", zeta_y)]);
}

/// A solid sphere: κ = 2/5, where b = 7/2.
fn solid(gamma: f64, u0: f64, theta0: f64, at: At) -> Answer<SphereState> {
    let problem = SphereProblem {
        gamma,
        u0,
        theta0,
        kappa: 0.4,
        at,
    };
    problem.solve().unwrap()
}

#[test]
fn the_printed_time_is_named_only_where_it_is_right() {
    let printed = "the slip by (81) and (82);";
    let lacks =
        "the slip by (81) in its regular form and by (82) with the factor 1/γ that it lacks;";
    for (gamma, u0, theta, note) in [
        (1.0, 1.0, 0.5, printed),
        (1.0, 1e6, 0.5, printed),
        (1.0, 1e-6, 0.5, printed),
        (1.5, 1.0, 0.5, lacks),
        (1.5, 1e-6, 0.5, lacks),
        (0.7, 1.0, 0.5, lacks),
        (1.0 + 1e-7, 1.0, 0.5, lacks),
    ] {
        let answer = solid(gamma, u0, 1.0, At::Theta(theta));
        assert!(answer.digits >= Some(11), "{answer:?}");
        let spin = " the spin by (79) and by (75) with the other sign";
        assert_eq!(answer.note, format!("{note}{spin}"), "{gamma} {u0} {theta}");
    }
}

#[test]
fn slip_along_the_axis_ends_when_uniform_deceleration_says() {
    // With the force: the slip falls at the rate b − γ, to be followed longer than u₀/γ or u₀ (b − γ).
    for (gamma, u0) in [(3.0, 1.0), (1.0, 1e10), (0.5, 1e-3)] {
        let rolls_at = u0 / (3.5 - gamma);
        let answer = solid(gamma, u0, 0.0, At::Time(0.25 * rolls_at));
        agrees(
            &answer,
            &[("u", 0.75 * u0), ("theta", 0.0), ("rolls_at", rolls_at)],
        );
    }
    // Against it, where friction only just holds: it falls at the rate b + γ = 7.
    let solid = |gamma: f64, u0: f64, theta0: f64, at: At| {
        let problem = SphereProblem {
            gamma: Double::from(gamma),
            u0: u0.into(),
            theta0: theta0.into(),
            kappa: "0.4".parse().unwrap(),
            at: at.map(Into::into),
        };
        problem.solve().unwrap()
    };
    for u0 in [1.0, 3.5, 7.0] {
        let answer = solid(3.5, u0, PI, At::Time(0.1 * u0));
        agrees(
            &answer,
            &[("u", 0.3 * u0), ("theta", PI), ("rolls_at", u0 / 7.0)],
        );
        let over = solid(3.5, u0, PI, At::Time(u0));
        agrees(&over, &[("u", 0.0), ("theta", PI), ("rolls_at", u0 / 7.0)]);
    }
}

#[test]
fn slip_that_turns_round_is_zero_at_the_turn_and_has_the_new_angle() {
    let turn = solid(5.0, 1.7, PI, At::Theta(0.0));
    agrees(&turn, &[("u", 0.0), ("theta", 0.0), ("tau", 0.2)]);
    assert_eq!(turn.best.rolls_at, None);
    let later = solid(5.0, 1.7, PI, At::Time(0.6));
    agrees(
        &later,
        &[("u", 0.6), ("theta", 0.0), ("u_x", 0.6), ("u_y", 0.0)],
    );
    let begin = solid(5.0, 1.7, PI, At::Theta(PI));
    agrees(&begin, &[("u", 1.7), ("theta", PI), ("tau", 0.0)]);
    // A motion of no length has the slip of its start.
    let begin = solid(5.0, 1.7, 1.0, At::Theta(1.0));
    agrees(&begin, &[("u", 1.7), ("theta", 1.0), ("tau", 0.0)]);
}

#[test]
fn a_sphere_that_was_thrown_aslant_rolls_with_the_angle_to_which_its_slip_tended() {
    for theta0 in [-2.0, 1.0, 3.0] {
        let answer = solid(2.0, 1.0, theta0, At::Time(5.0));
        // By (74) λu + u_x falls at the rate γ(λ² − 1), to 0 at the end.
        let rolls_at = (1.75 + libm::cos(theta0)) / (2.0 * (1.75 * 1.75 - 1.0));
        agrees(
            &answer,
            &[("u", 0.0), ("theta", 0.0), ("rolls_at", rolls_at)],
        );
    }
}

#[test]
fn an_angle_that_only_the_formula_reaches_has_an_answer() {
    for (gamma, theta) in [(0.1, 0.01), (0.01, 0.5), (1.0, 1e-8)] {
        let problem = SphereProblem {
            gamma,
            u0: 1.0,
            theta0: 1.0,
            kappa: 0.4,
            at: At::Theta(theta),
        };
        let answer = problem.solve().unwrap();
        assert_eq!(
            (answer.by_motion, answer.digits),
            (None, Some(15)),
            "{gamma}"
        );
        assert_eq!(answer.by_formula, Some(answer.best));
        // (81) with λ = b/γ and b = 7/2.
        let part = libm::tan(0.5 * theta) / libm::tan(0.5);
        let u = libm::pow(part, 3.5 / gamma) * libm::sin(1.0) / libm::sin(theta);
        assert!((answer.best.u - u).abs() <= 1e-11 * u, "{answer:?} {u}");
        assert!(Some(answer.best.tau) <= answer.best.rolls_at, "{answer:?}");
    }
}

/// Powers of γ stay numbers: up to the largest one there is an answer, whatever the rest.
#[test]
fn the_strongest_pushes_are_followed_and_faster_ones_refused() {
    let solve = |gamma, theta0, u0, time| {
        let problem = SphereProblem {
            gamma,
            u0,
            theta0,
            kappa: 1e-3,
            at: At::Time(time),
        };
        problem.solve()
    };
    for theta0 in [0.0, 1e-8, 1.2, PI] {
        for u0 in [1e-16, 1.0, 1e18] {
            for time in [1e-28, 1.0, 1e30] {
                let answer = solve(1e9, theta0, u0, time);
                assert!(answer.is_ok(), "{theta0}, {u0}, {time}: {answer:?}");
            }
        }
    }
    let refused = solve(1.1e9, 1.2, 1.0, 1.0).unwrap_err().to_string();
    assert!(refused.contains("gamma"), "{refused}");
}
