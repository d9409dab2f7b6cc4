//! What the conditions of section 2 except.

use crate::evidence::Evidence;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::Compared;
use trialbook::claims::excepted::no_inside;

/// A push at a single instant.
pub fn instants() -> Evidence {
    no_inside(
        Compared::one(
            "whether a push meets the condition (1 if so)",
            "the expectation that only a push without length does not",
        )
        .over("random ones, that one, and some close to it"),
        ["strength", "length"],
        [[1.1, 10.0], [0.0, 1.0]],
        &[[2.0, 0.0], [5.0, 0.0]],
        |[_, length]| length > 0.0,
    )
}

/// No friction at all.
pub fn no_friction() -> Evidence {
    no_inside(
        Compared::one(
            "whether a friction meets the condition (1 if so)",
            r"the expectation that only $\mu=0$ does not",
        )
        .over("random ones, that one, and some close to it"),
        ["μ"],
        [[0.0, 1.0]],
        &[[0.0]],
        |[mu]| mu > 0.0,
    )
}

pub(super) const TRIALS: &[Attempt] = trials![instants, no_friction];
