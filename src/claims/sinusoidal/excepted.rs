//! What the conditions of sections 2.2 and 3 except.

use crate::claims::excepted::no_inside;
use crate::evidence::Evidence;

/// No friction at all.
pub fn no_friction() -> Evidence {
    no_inside(
        "whether a friction is λ₀ = 0, with that it is not at random and close to it",
        ["λ₀"],
        [[0.0, 1.0]],
        &[[0.0]],
        |[lambda0]| lambda0 > 0.0,
    )
}
