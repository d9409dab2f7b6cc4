//! What the conditions of sections 2.2 and 3 except.

use crate::claims::attempt::{Attempt, trials};
use crate::claims::compare::Compared;
use crate::claims::excepted::no_inside;
use crate::evidence::Evidence;

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
