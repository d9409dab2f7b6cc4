//! What the conditions of section 2 except.

use crate::claims::excepted::no_inside;
use crate::evidence::Evidence;

/// A push at a single instant.
pub fn instants() -> Evidence {
    no_inside(
        "whether a push has no length, with that it has one at random and close to it",
        ["strength", "length"],
        [[1.1, 10.0], [0.0, 1.0]],
        &[[2.0, 0.0], [5.0, 0.0]],
        |[_, length]| length > 0.0,
    )
}

/// No friction at all.
pub fn no_friction() -> Evidence {
    no_inside(
        "whether a friction is μ = 0, with that it is not at random and close to it",
        ["μ"],
        [[0.0, 1.0]],
        &[[0.0]],
        |[mu]| mu > 0.0,
    )
}
