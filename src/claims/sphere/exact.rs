//! Section 3, exactly: proofs from the laws of Newton and Euler for a rigid sphere, component by component.
//!
//! Only those laws and Coulomb's friction are entered here, at the contact point below the centre; the printed
//! formulas come from [`crate::paper::sphere`], as trees.

mod angle;
mod body;
pub(crate) mod carried;
mod newton;
#[cfg(test)]
mod tests;

use super::prelude::*;
pub(crate) use angle::*;
pub(crate) use body::*;
pub(crate) use newton::*;

/// Components of a vector, as trees; a scalar has one.
pub(crate) type Components = Vec<Expr>;

/// A statement about the sphere, by components.
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

/// Names of a vector's components, for the steps of a proof.
const AXES: [&str; 3] = ["along x", "along y", "along z"];

attempts![
    &EQ59,
    &EQ60,
    &EQ62,
    &EQ63,
    &EQ64,
    &EQ65,
    &EQ66,
    &EQ68,
    &EQ69,
    &EQ70,
    &EQ71,
    &EQ72,
    &EQ73,
    &EQ74,
    &EQ75,
    &CORRECTED_75,
    &EQ77,
    &EQ78,
    &EQ79,
    &EQ81,
    &EQ82,
    &CORRECTED_82,
    &EQ83,
    &CORRECTED_83,
    &S3_REDUCTION,
    &S3_SPIN_CONSTANT
];
