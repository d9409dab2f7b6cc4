//! What the conditions of sections 2.2 and 3 except.

use crate::evidence::Evidence;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::Compared;
use trialbook::claims::excepted::no_inside;

/// No friction at all.
pub fn no_friction() -> Evidence {
    no_inside(
        Compared::one(
            "whether a friction meets the condition (1 if so)",
            r"the expectation that only $\lambda_0=0$ does not",
        )
        .over("random ones, that one, and some close to it"),
        ["λ₀"],
        [[0.0, 1.0]],
        &[[0.0]],
        |[lambda0]| lambda0 > 0.0,
    )
}

pub(in crate::claims) const TRIALS: &[Attempt] = trials![no_friction];
