//! What the conditions near rest except: single resting places, and starts that come straight in, which lie on a surface.

use super::prelude::*;
use super::trajectories::{APPROACHES, Approach};
use trialbook::certified::interval::Interval;

pub(crate) fn straight_in() -> Evidence {
    Trial::census(
        Excepted,
        Compared::constant(
            "the expected 1",
            r"whether $\psi$ of the motion ends below a right angle (1 if so)",
        )
        .over("random starts that do not come straight in"),
    )
    .each(APPROACHES.each(), Approach::at, |approach| {
        Ok([1.0, is(approach.run.end().psi().abs() < FRAC_PI_2), 1.0])
    })
}

attempts![
    // The resting place at which friction is only just as strong as the centrifugal force.
    edge = no_inside(
        "a resting place",
        r"$\sigma=0$ and $\sigma=1$",
        [("σ", [0.0, 1.0])],
        &[[1.0], [0.0]],
        |[sigma]| 0.0 < sigma && sigma < 1.0,
    ),
    straight_in,
    one_half = no_value(
        "(143)",
        "the condition holds",
        r"with $\sigma=\frac12$",
        [("σ", [0.6, 0.9]), ("α", [0.1, 0.5]), ("c", [0.5, 2.0])],
        [[
            Interval::ratio(1, 2),
            Interval::ratio(1, 2),
            Interval::int(1)
        ]],
        |[sigma, alpha, c]| printed::eq143_psi(sigma, c, alpha),
    )
];
