//! What the conditions of section 4 on escapes except: starts that come straight in, which lie on a surface.

use super::prelude::*;
use super::trajectories::{FLIGHTS, Flight, Relaxed, a, alpha, relaxed};

pub(crate) fn escaping() -> Evidence {
    let beyond = only(FLIGHTS.each(), |flight| flight.launch.a > 1.0);
    Trial::census(
        Excepted,
        Compared::constant(
            "the expected 1, for an escape",
            "whether $A$ of the motion exceeds $10^4$ (1 if so)",
        )
        .over("random starts with $A>1$ that do not come straight in"),
    )
    .each(beyond, Flight::at, |flight| {
        Ok([1.0, is(a(&flight.run.end()) > 1e4), 1.0])
    })
}

attempts![
    escaping,
    small_alpha = Trial::census(
        Excepted,
        Compared::constant(
            r"the expected 1, for a fall of $\psi$ to 0",
            r"whether $\psi$ of the motion has fallen below $10^{-3}$ (1 if so)",
        )
        .over(r"random starts with tiny $\alpha$ that do not come straight in"),
    )
    .each(relaxed(), Relaxed::at, |relaxed| {
        let near = alpha(&relaxed.state) < 1e-3 && relaxed.state.psi().abs() < 1e-3;
        Ok([1.0, is(near), 1.0])
    })
];
