//! Spheres.

use super::*;
use crate::claims::solve::constant::At;
use crate::claims::solve::sphere::Problem;
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
        let problem = |at| Problem {
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
        assert_eq!(answer.best.rolls_at.is_some(), 1.0 + 1.0 / kappa > gamma);
    }
}

#[test]
fn a_sphere_rolls_on_with_the_spin_that_rolling_gives() {
    let problem = |at| Problem {
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
