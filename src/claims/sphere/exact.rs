//! Section 3, exactly: proofs from the laws of Newton and Euler for a rigid sphere, component by component.
//!
//! Only those laws and Coulomb's friction are entered here, at the contact point below the centre; the printed
//! formulas come from [`crate::paper::sphere`], as trees.

mod angle;
mod body;
pub mod carried;
mod newton;
#[cfg(test)]
mod tests;

use trialbook::prelude::*;

/// Components of a vector, as trees; a scalar has one.
pub type Components = Vec<Expr>;

/// A statement about the sphere, by components.
pub type Vectorial = Statement<Components>;

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

const EQ59: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(
        "the formula",
        "Newton's law in the laboratory, where friction alone acts",
    ),
    newton::eq59,
    newton::prove_eq59,
);
const EQ60: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(
        "the formula",
        "Newton's law for six point masses that move as one body",
    ),
    newton::eq60,
    newton::prove_eq60,
);
const EQ62: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(
        r"(64), with $\kappa$ by the definition,",
        "Euler's law for the sphere",
    ),
    body::eq62,
    body::prove_eq62,
);
const EQ63: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq63,
    body::prove_eq63,
);
const EQ64: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq64,
    body::prove_eq64,
);
const EQ65: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq65,
    body::prove_eq65,
);
const EQ66: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq66,
    body::prove_eq66,
);
const EQ68: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(
        r"(73), with $\bm\rho$ by the definition,",
        "Newton's law for the sphere",
    ),
    body::eq68,
    body::prove_eq68,
);
const EQ69: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_DEFINITION,
    body::eq69,
    body::prove_eq69,
);
const EQ70: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(
        r"$\bm\zeta\,\mathrm d\tau$, with $\tau$ by (69),",
        r"$\bm\omega\,\mathrm dt$",
    ),
    body::eq70,
    body::prove_eq70,
);
const EQ71: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_DEFINITION,
    body::eq71,
    body::prove_eq71,
);
const EQ72: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_DEFINITION,
    body::eq72,
    body::prove_eq72,
);
const EQ73: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq73,
    body::prove_eq73,
);
const EQ74: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq74,
    body::prove_eq74,
);
const EQ75: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq75,
    body::prove_eq75,
);
const CORRECTED_75: Vectorial = Vectorial::new(
    Subject::Corrected,
    BY_COMPONENTS,
    body::corrected75,
    body::prove_eq75,
);
const EQ77: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq77,
    body::prove_eq77,
);
const EQ78: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq78,
    body::prove_eq78,
);
const EQ79: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::eq79,
    body::prove_eq79,
);
const EQ81: Vectorial = Vectorial::new(
    Subject::Within,
    AS_A_PARTICLE,
    angle::eq81,
    angle::prove_eq81,
);
const EQ82: Vectorial = Vectorial::new(
    Subject::Printed,
    AS_A_PARTICLE,
    angle::eq82,
    angle::prove_eq82,
);
const CORRECTED_82: Vectorial = Vectorial::new(
    Subject::Corrected,
    AS_A_PARTICLE,
    angle::corrected82,
    angle::prove_eq82,
);
const EQ83: Vectorial = Vectorial::new(
    Subject::Printed,
    AS_A_PARTICLE,
    angle::eq83,
    angle::prove_eq83,
);
const CORRECTED_83: Vectorial = Vectorial::new(
    Subject::Corrected,
    AS_A_PARTICLE,
    angle::corrected83,
    angle::prove_eq83,
);
pub const S3_REDUCTION: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::reduction,
    body::prove_reduction,
);
const S3_SPIN_CONSTANT: Vectorial = Vectorial::new(
    Subject::Printed,
    BY_COMPONENTS,
    body::spin_rate,
    body::prove_spin_constant,
);

/// Names of a vector's components, for the steps of a proof.
const AXES: [&str; 3] = ["along x", "along y", "along z"];

pub(super) const TRIALS: &[Attempt] = trials![
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
