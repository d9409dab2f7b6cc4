//! What the conditions near rest except: single resting places, and starts that come straight in, which lie on a surface.

use super::trajectories::approaches;
use crate::claims::tolerances::NONE;
use crate::evidence::{Evidence, Route, Subject};
use crate::paper::rest as printed;
use crate::scalar::Scalar;
use std::f64::consts::FRAC_PI_2;
use trialbook::certified::interval::Interval;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::{Compared, Pair, Trial};
use trialbook::claims::excepted::{no_inside, no_value};

/// Of starts at random that come to rest none comes straight in: ψ tends to 0, not to π.
pub fn straight_in() -> Evidence {
    let compared = Compared::constant(
        "the expected 1",
        r"whether $\psi$ of the motion ends below a right angle (1 if so)",
    )
    .over("random starts that do not come straight in");
    let trial = Trial::by(Route::Census, Subject::Excepted, compared, NONE);
    trial.over(approaches(), |approach| {
        let approach = approach?;
        Ok(Pair {
            at: approach.at(),
            stated: 1.0,
            found: f64::from(u8::from(approach.run.end().psi().abs() < FRAC_PI_2)),
            scale: 1.0,
        })
    })
}

/// The resting place at which friction is only just as strong as the centrifugal force.
pub fn edge() -> Evidence {
    no_inside(
        Compared::one(
            "whether a resting place meets the condition (1 if so)",
            r"the expectation that only $\sigma=0$ or 1 does not",
        )
        .over("random ones, that one, and some close to it"),
        ["σ"],
        [[0.0, 1.0]],
        &[[1.0], [0.0]],
        |[sigma]| 0.0 < sigma && sigma < 1.0,
    )
}

/// (143) at σ = ½.
fn one_half() -> Evidence {
    let half = Interval::ratio(1, 2);
    no_value(
        Compared::one(
            "whether (143) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\sigma=\frac12$"),
        ["σ", "α", "c"],
        [[0.6, 0.9], [0.1, 0.5], [0.5, 2.0]],
        [[half, half, Interval::int(1)]],
        |[sigma, alpha, c]| printed::eq143_psi(sigma, c, alpha),
    )
}

pub(super) const TRIALS: &[Attempt] = trials![edge, straight_in, one_half];
