//! Section 4, rest: how a particle on the turntable comes to rest at ρ = σ, (139) to (147).
//!
//! Everything is dimensionless, as in [`escape`](super::escape): `sigma` is the distance σ from the axis at rest,
//! `alpha`, `a` and `psi` are α, A and ψ, `tau` the time τ counted from the moment of rest (τ ≤ 0), `c` the constant
//! of (143).

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// (139): the largest σ.
pub fn eq139_largest_sigma<S: Scalar>() -> S {
    S::int(1)
}

/// (140): dα/dτ near rest.
pub fn eq140_alpha_rate<S: Scalar>(sigma: S) -> S {
    S::int(1) - S::int(1) / sigma
}

/// (141): α near rest.
pub fn eq141_alpha<S: Scalar>(sigma: S, tau: S) -> S {
    (sigma - S::int(1)) * tau / sigma
}

/// (142), left side: `psi_slope` is dψ/dα.
pub fn eq142_left<S: Scalar>(sigma: S, psi_slope: S) -> S {
    (sigma - S::int(1)) / sigma * psi_slope
}

/// (142), right side. No value at α = 0.
pub fn eq142_right<S: Scalar>(alpha: S, psi: S) -> S {
    S::int(2) * (S::int(1) - psi / (S::int(2) * alpha))
}

/// (143): the exponent of α beside the constant c. No value at σ = 1.
pub fn eq143_exponent<S: Scalar>(sigma: S) -> S {
    (S::int(2) * sigma - S::int(1)) / (S::int(1) - sigma)
}

/// (143): the term in brackets without c. No value at σ = 1/2.
pub fn eq143_constant<S: Scalar>(sigma: S) -> S {
    sigma / (S::int(2) * sigma - S::int(1))
}

/// (143): ψ near rest. No value at σ = 1/2 and σ = 1.
pub fn eq143_psi<S: Scalar>(sigma: S, c: S, alpha: S) -> S {
    S::int(2) * alpha * (eq143_constant(sigma) + c * alpha.pow(eq143_exponent(sigma)))
}

/// (144), left side: `a_slope` is dA/dα.
pub fn eq144_left<S: Scalar>(sigma: S, a_slope: S) -> S {
    (sigma - S::int(1)) / sigma * a_slope
}

/// (144), right side.
pub fn eq144_right<S: Scalar>(alpha: S) -> S {
    alpha
}

/// (145): A near rest. No value at σ = 1.
pub fn eq145_a<S: Scalar>(sigma: S, alpha: S) -> S {
    sigma + sigma / (sigma - S::int(1)) * (alpha.squared() / S::int(2))
}

/// (146), right side, which is to vanish. No value at σ = 1.
pub fn eq146_right<S: Scalar>(sigma: S, alpha: S) -> S {
    S::int(1) - S::int(1) / (sigma - S::int(1)).squared() * (alpha.squared() / S::int(2))
}

/// (147): A on the envelope.
pub fn eq147_a<S: Scalar>(alpha: S) -> S {
    (S::int(1) - alpha / S::int(2).sqrt()).squared()
}

/// After (139): the limits of α and ψ as the particle nears its rest.
claim "s4-near-rest";
pub fn s4_near_rest_limits<S: Scalar>() -> [S; 2] {
    [S::int(0), S::int(0)]
}

/// Before (146): starts that lead neither to rest nor to an unbounded motion.
claim "s4-dichotomy";
pub fn s4_third_fates<S: Scalar>() -> S {
    S::int(0)
}

}
