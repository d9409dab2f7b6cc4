//! Spheres.

use crate::solve::{constant::At, sphere::SphereProblem};
use std::f64::consts::PI;

/// Powers of γ stay numbers: up to the largest one there is an answer, whatever the rest.
#[test]
fn the_strongest_pushes_are_followed() {
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
}
