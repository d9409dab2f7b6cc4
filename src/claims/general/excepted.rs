//! What the conditions of section 2 except.

use super::prelude::*;

attempts![
    instants = no_inside(
        "a push",
        "those without length",
        [("strength", [1.1, 10.0]), ("length", [0.0, 1.0])],
        &[[2.0, 0.0], [5.0, 0.0]],
        |[_, length]| length > 0.0,
    ),
    no_friction = no_inside(
        "a friction",
        r"$\mu=0$",
        [("μ", [0.0, 1.0])],
        &[[0.0]],
        |[mu]| mu > 0.0
    )
];
