//! What the conditions of section 3 except.

use super::prelude::*;
use crate::claims::constant::excepted::{END, HOLDS, LAMBDA, START, half, int, two_thirds};
use trialbook::certified::interval::Interval;

attempts![
    eq81 = no_value(
        "(81)",
        HOLDS,
        r"with $\theta=\theta_0=0,\pi$",
        [LAMBDA, ("u₀", [0.5, 2.0]), START, END],
        [int(0), Interval::pi()].map(|theta| [half(), int(1), theta, theta]),
        |[lambda, u0, theta0, theta]| printed::eq81_slip(lambda, u0, theta0, theta),
    ),
    eq82 = no_value(
        "(82)",
        HOLDS,
        r"with $\theta=\theta_0=0,\pi$, $\lambda=1$ or $\cos\theta_0=-\lambda$",
        [LAMBDA, START, END],
        [
            [half(), int(0), int(0)],
            [half(), Interval::pi(), Interval::pi()],
            [int(1), int(2), int(1)],
            [half(), two_thirds(), int(1)],
        ],
        |[lambda, theta0, theta]| printed::eq82_time(lambda, int(1), theta0, theta),
    ),
    eq83 = no_value(
        "(83)",
        HOLDS,
        r"with $\cos\theta=-\lambda$",
        [LAMBDA, START, END, ("τ", [0.0, 1.0])],
        [[half(), int(2), two_thirds(), int(1)]],
        |[lambda, theta0, theta, tau]| {
            printed::eq83_slip_at_time(lambda, int(1), theta0, theta, tau)
        },
    )
];
