//! What the conditions of sections 2.2 and 3 except.

use super::prelude::*;

attempts![
    no_friction = no_inside(
        "a friction",
        r"$\lambda_0=0$",
        [("λ₀", [0.0, 1.0])],
        &[[0.0]],
        |[lambda0]| lambda0 > 0.0,
    )
];
