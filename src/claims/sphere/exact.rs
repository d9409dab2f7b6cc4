//! Section 3, exactly: proofs from the laws of Newton and Euler for a rigid sphere, component by component.
//!
//! Only those laws and Coulomb's friction are entered here, at the contact point below the centre.

pub(crate) mod angle;
pub(crate) mod body;
pub(crate) mod carried;
pub(crate) mod newton;
#[cfg(test)]
mod tests;

use super::prelude::*;
pub(crate) use body::*;

/// Components of a vector, as trees; a scalar has one.
pub(crate) type Components = Vec<Expr>;

pub(crate) type Vectorial = Statement<Components>;

const BY_COMPONENTS: Compared = Compared::one(
    "the formula",
    "the laws of Newton and Euler for the sphere, component by component",
);
const BY_DEFINITION: Compared = Compared::one(
    "(74), with the quantity by the definition,",
    "the laws of Newton and Euler for the sphere",
);
const AS_A_PARTICLE: Compared = Compared::one(
    "the formula",
    r"(11), (13) and (14), proved from (1), with $\gamma$ for $A$, $b$ for $\mu g$ and $\tau$ for $t$, as (74) has them",
);

const AXES: [&str; 3] = ["along x", "along y", "along z"];
