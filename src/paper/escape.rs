//! Section 4, escape: how a particle on the turntable goes away, (126) to (138).
//!
//! Everything is dimensionless: lengths in μg/Ω², times in 1/Ω. `p` is the speed p relative to the table, `rho` the
//! distance ρ from the axis, `psi` the angle ψ from the velocity to the position (radians), `s` the arc length on
//! the table; `a` and `alpha` stand for A and α with p = A sinh α, ρ = A cosh α, where p < ρ; `tau` is the time τ.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// (126): dα/dτ near α = 0.
pub fn eq126_alpha_rate<S: Scalar>(a: S) -> S {
    S::int(1) - S::int(1) / a
}

/// (127): the number that A has to exceed.
pub fn eq127_least_a<S: Scalar>() -> S {
    S::int(1)
}

/// (128): dα/dτ with ψ at its attractor.
pub fn eq128_alpha_rate<S: Scalar>(alpha: S, a: S) -> S {
    S::int(1) / (S::int(2) * alpha).cosh() - alpha.cosh() / a
}

/// (129): what A is approximately equal to.
pub fn eq129_a<S: Scalar>(alpha: S) -> S {
    alpha.cosh() * (S::int(2) * alpha).cosh()
}

/// (130): α at large A.
pub fn eq130_alpha<S: Scalar>(a: S) -> S {
    (S::int(4) * a).ln() / S::int(3)
}

/// (131): dA/dτ at large A.
pub fn eq131_a_rate<S: Scalar>(a: S) -> S {
    (S::int(4) * a).pow(S::int(1) / S::int(3)) / S::int(2)
}

/// (132): A at large times.
pub fn eq132_a<S: Scalar>(tau: S) -> S {
    S::int(2) * tau.pow(S::int(3) / S::int(2)) / S::int(27).sqrt()
}

/// (133): α at large times.
pub fn eq133_alpha<S: Scalar>(tau: S) -> S {
    (S::int(4) * tau / S::int(3)).ln() / S::int(2)
}

/// (134), by its distance from π/2: what π/2 − ψ is at large times.
pub fn eq134_lag<S: Scalar>(tau: S) -> S {
    (S::int(3) / tau).pow(S::int(1) / S::int(2))
}

/// (135): p at large times.
pub fn eq135_p<S: Scalar>(tau: S) -> S {
    S::int(2) * tau.squared() / S::int(9)
}

/// (136): ρ at large times.
pub fn eq136_rho<S: Scalar>(tau: S) -> S {
    S::int(2) * tau.squared() / S::int(9)
}

/// (137): s at large times.
pub fn eq137_s<S: Scalar>(tau: S) -> S {
    S::int(2) * tau.pow(S::int(3)) / S::int(27)
}

/// (138): s at large times, by A.
pub fn eq138_s<S: Scalar>(a: S) -> S {
    a.squared() / S::int(2)
}

/// Before (126) and after (127): the sign of the rate of A.
claim "s4-A-never-decreases";
pub fn s4_a_trend<S: Scalar>() -> S {
    S::int(1)
}

}
