//! Section 4, escape: the leading behaviour, from the laboratory.
//!
//! *Why (128) to (137) fail.* They put ψ at the quasi-fixed point ψ₁ of (124). Near it ψ relaxes at the rate
//! 2 cos ψ coth 2α ≈ 2(π/2 − ψ), which falls as 1/τ; but ψ₁ itself moves at a relative rate of order 1/τ. The angle
//! never catches up: π/2 − ψ stays √2 times as large as π/2 − ψ₁, and every prefactor inherits that.
//!
//! *What is right.* In the laboratory friction is the only force. Write the position as a complex number R and the
//! time as τ; the velocity relative to the table is w = Ṙ − iR, and
//!
//! R̈ = −w/|w|.
//!
//! A particle that is left behind by the table, |Ṙ| ≪ |R|, has −w/|w| → iR/|R|. The powers balance for
//! R = C τ^(2+ik): R̈ = (2+ik)(1+ik) R/τ², |R| = |C| τ², so that
//!
//! (2+ik)(1+ik) |C| = i,  that is  2 − k² = 0 and 3k|C| = 1:  k = √2, |C| = 1/(3√2).
//!
//! The particle goes away as τ², on a logarithmic spiral: it circles the axis by √2 ln τ. All else follows at leading
//! order: p ≈ ρ = |C| τ²; s = ∫p dτ; A² = ρ² − p² grows at the rate 2p; e^α = 2p/A; ρ̇ = p cos ψ.
//!
//! *The first correction.* With R = C τ^(2+ik) (1 + ε) and the next term of the direction of friction,
//! −w/|w| = (iR/|R|) exp(2i/τ), ε must solve, writing ε = u + iv and D = τ d/dτ,
//!
//! (2+ik+D)(1+ik+D) ε = −3√2 (v + 2/τ).
//!
//! Without the last term ε ∝ τ^m for m = 0 (a turn), m = −1 (a shift of τ), m = −5/2 ± i√23/2. The term 2/τ meets
//! m = −1 and is in resonance with it. ε = (2+ik)(a ln τ + b)/τ + const/τ then demands a = −3√2/4: the law holds in
//! the time
//!
//! T = τ − (3√2/4) ln τ + b,
//!
//! which lags ever further behind τ. The constant b is the start's; what oscillates falls as τ^(−5/2).

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// Near α = 0: ψ/ψ₁ once ψ has relaxed, both being small. For A > ½: put ψ = kα into (115) and dα/dτ = 1 − 1/A.
claim "s4-small-alpha";
pub fn relaxed_ratio<S: Scalar>(a: S) -> S {
    a / (S::int(2) * a - S::int(1))
}

/// k: the angle by which the particle circles the axis, in the laboratory, is k ln τ.
claim "eq-136";
pub fn winding<S: Scalar>() -> S {
    S::int(2).sqrt()
}

/// |C|: ρ/τ² at large times.
claim "eq-135";
pub fn amplitude<S: Scalar>() -> S {
    S::int(1) / (S::int(3) * S::int(2).sqrt())
}

/// By how much τ − T grows per unit of ln τ.
claim "eq-134";
pub fn delay<S: Scalar>() -> S {
    S::int(3) * S::int(2).sqrt() / S::int(4)
}

/// In place of (128): dα/dτ at large times.
claim "eq-128";
pub fn alpha_rate<S: Scalar>(alpha: S, a: S) -> S {
    S::int(2).sqrt() / (S::int(2) * alpha).cosh() - alpha.cosh() / a
}

/// In place of (129): cosh α cosh 2α over A at large times.
claim "eq-129";
pub fn product_over_a<S: Scalar>() -> S {
    S::int(3) * S::int(2).sqrt() / S::int(4)
}

/// exp(3α) at large A.
claim "eq-130";
pub fn thrice_alpha_exp<S: Scalar>(a: S) -> S {
    S::int(3) * S::int(2).sqrt() * a
}

/// In place of (130): α at large A.
claim "eq-130";
pub fn alpha_by_a<S: Scalar>(a: S) -> S {
    thrice_alpha_exp(a).ln() / S::int(3)
}

/// In place of (131): dA/dτ at large A.
claim "eq-131";
pub fn a_rate<S: Scalar>(a: S) -> S {
    (S::int(3) * S::int(2).sqrt() * a).pow(S::int(1) / S::int(3)) / S::int(2)
}

/// In place of (132): A at large times.
claim "eq-132";
pub fn a<S: Scalar>(tau: S) -> S {
    S::int(2).sqrt().sqrt() / S::int(3) * tau.pow(S::int(3) / S::int(2))
}

/// exp(2α) at large times.
claim "eq-133";
pub fn twice_alpha_exp<S: Scalar>(tau: S) -> S {
    S::int(2).sqrt() * tau
}

/// In place of (133): α at large times.
claim "eq-133";
pub fn alpha<S: Scalar>(tau: S) -> S {
    twice_alpha_exp(tau).ln() / S::int(2)
}

/// In place of (134): π/2 − ψ at large times.
claim "eq-134";
pub fn lag<S: Scalar>(tau: S) -> S {
    S::int(2) / tau
}

/// In place of (135) and (136): p and ρ at large times.
claim "eq-135";
pub fn rho<S: Scalar>(tau: S) -> S {
    amplitude::<S>() * tau.squared()
}

/// In place of (137): s at large times.
claim "eq-137";
pub fn s<S: Scalar>(tau: S) -> S {
    amplitude::<S>() / S::int(3) * tau.pow(S::int(3))
}

}
