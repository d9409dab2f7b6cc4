//! Section 2.2, sinusoidal acceleration along a line: A = −A₀ sin(ϖt) x̂, λ₀ = μg/A₀, φ = ϖt, 𝔴 = ϖ v_x/A₀.
//!
//! Symbols: `a0` the amplitude A₀ > 0 (length/time²), `varpi` the angular frequency ϖ > 0 (1/time), `lambda0` λ₀
//! (dimensionless), `phi` φ the phase (radians), `w` 𝔴 the velocity (dimensionless); `phi1` to `phi4` φ₁ to φ₄, the
//! phases at which the drive equals friction; `phi_t1`, `phi_t2` φ̃₁, φ̃₂, where 𝔴 turns positive in a motion without
//! rest and where a forward slip ends. Of an inequality, the sides as printed, left and right.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// (21): the plane's acceleration vector at time `t`, (A_x, A_y).
pub fn eq21_acceleration<S: Scalar>(a0: S, varpi: S, t: S) -> [S; 2] {
    [-a0 * (varpi * t).sin(), S::int(0)]
}

/// (22): λ₀ from the friction coefficient `mu` and the gravity acceleration `g`.
pub fn eq22_lambda0<S: Scalar>(mu: S, g: S, a0: S) -> S {
    mu * g / a0
}

/// (23): the phase at time `t`.
pub fn eq23_phase<S: Scalar>(varpi: S, t: S) -> S {
    varpi * t
}

/// (24): the dimensionless velocity, from `vx` along the drive (length/time).
pub fn eq24_w<S: Scalar>(varpi: S, vx: S, a0: S) -> S {
    varpi * vx / a0
}

/// (25): left < right.
pub fn eq25_sides<S: Scalar>(lambda0: S) -> [S; 2] {
    [lambda0, S::int(1)]
}

/// (26): d𝔴/dφ. No value at 𝔴 = 0.
pub fn eq26_rate<S: Scalar>(lambda0: S, phi: S, w: S) -> S {
    phi.sin() - lambda0 * w / w.squared().sqrt()
}

/// v_y at large times.
claim "s22-vy-vanishes";
pub fn s22_late_vy<S: Scalar>() -> S {
    S::int(0)
}

/// Friction across the drive once 𝔴_y is far below 𝔴, in units of A₀: proportional to 𝔴_y. No value at 𝔴 = 0.
claim "s22-friction-across";
pub fn s22_across_friction<S: Scalar>(lambda0: S, w: S, w_y: S) -> S {
    -lambda0 * w_y / w.squared().sqrt()
}

/// The rate of 𝔴_y with the phase as long as 𝔴_y is far above 𝔴.
claim "s22-vy-two-stages";
pub fn s22_first_stage_slope<S: Scalar>(lambda0: S) -> S {
    -lambda0
}

/// By how much more ln 𝔴_y falls in one period than in the one before, once 𝔴_y is small: an exponential.
claim "s22-vy-two-stages";
pub fn s22_second_stage_ratio<S: Scalar>() -> S {
    S::int(1)
}

/// The number of phases in a period at which the drive is as large as the friction.
claim "s22-four-points";
pub fn s22_points<S: Scalar>() -> S {
    S::int(4)
}

/// (27): φ₁, for λ₀ ≤ 1.
pub fn eq27_phi1<S: Scalar>(lambda0: S) -> S {
    lambda0.asin()
}

/// (28): φ₂, for λ₀ ≤ 1.
pub fn eq28_phi2<S: Scalar>(lambda0: S) -> S {
    S::pi() - lambda0.asin()
}

/// (29): φ₃, for λ₀ ≤ 1.
pub fn eq29_phi3<S: Scalar>(lambda0: S) -> S {
    S::pi() + lambda0.asin()
}

/// (30): φ₄, for λ₀ ≤ 1.
pub fn eq30_phi4<S: Scalar>(lambda0: S) -> S {
    S::int(2) * S::pi() - lambda0.asin()
}

/// (31): 𝔴 at φ in \[φ₁, φ̃₂\], after a rest that ended at φ₁.
pub fn eq31_w<S: Scalar>(lambda0: S, phi1: S, phi: S) -> S {
    -lambda0 * (phi - phi1) + phi1.cos() - phi.cos()
}

/// (32): the left side, which vanishes at φ̃₂.
pub fn eq32_left<S: Scalar>(lambda0: S, phi1: S, phi_t2: S) -> S {
    -lambda0 * (phi_t2 - phi1) + phi1.cos() - phi_t2.cos()
}

/// (33): 𝔴 at φ by each of its four cases.
pub fn eq33_w<S: Scalar>(lambda0: S, phi1: S, phi3: S, phi: S) -> [S; 4] {
    let rest = S::int(0);
    [
        -lambda0 * (phi - phi1) + phi1.cos() - phi.cos(),
        rest,
        lambda0 * (phi - phi3) + phi3.cos() - phi.cos(),
        rest,
    ]
}

/// (33): where its four cases begin and the last ends.
pub fn eq33_ends<S: Scalar>(phi1: S, phi_t2: S, phi3: S) -> [S; 5] {
    let pi = S::pi();
    [phi1, phi_t2, phi3, phi_t2 + pi, phi1 + S::int(2) * pi]
}

/// (34): the left side; the right side is 0.
pub fn eq34_left<S: Scalar>(lambda0: S, phi1: S, phi3: S) -> S {
    -lambda0 * (phi3 - phi1) + phi1.cos() - phi3.cos()
}

/// (35): the left side; the right side is 0.
pub fn eq35_left<S: Scalar>(lambda0: S) -> S {
    -S::pi() * lambda0 + S::int(2) * (S::int(1) - lambda0.squared()).sqrt()
}

/// (36): left > right.
pub fn eq36_sides<S: Scalar>(lambda0: S) -> [S; 2] {
    [lambda0, eq37_lambda_c()]
}

/// (37): the critical friction λ_c.
pub fn eq37_lambda_c<S: Scalar>() -> S {
    S::int(2) / (S::int(4) + S::pi().squared()).sqrt()
}

/// (38): 𝔴 at φ by each of its two cases.
pub fn eq38_w<S: Scalar>(lambda0: S, phi_t1: S, phi: S) -> [S; 2] {
    [
        -lambda0 * (phi - phi_t1) + phi_t1.cos() - phi.cos(),
        lambda0 * (phi - phi_t1 - S::pi()) - phi_t1.cos() - phi.cos(),
    ]
}

/// (38): where its two cases begin and the last ends.
pub fn eq38_ends<S: Scalar>(phi_t1: S) -> [S; 3] {
    let pi = S::pi();
    [phi_t1, phi_t1 + pi, phi_t1 + S::int(2) * pi]
}

/// (39): φ̃₁, for λ₀ ≤ 2/π.
pub fn eq39_phi_t1<S: Scalar>(lambda0: S) -> S {
    (S::pi() * lambda0 / S::int(2)).acos()
}

/// (40): left < right.
pub fn eq40_sides<S: Scalar>(lambda0: S) -> [S; 2] {
    [lambda0, eq37_lambda_c()]
}

/// (41): left > right.
pub fn eq41_sides<S: Scalar>(phi_t1: S, phi1: S) -> [S; 2] {
    [phi_t1, phi1]
}

/// Before (38): where the interval ends that follows the slip, in radians.
claim "s22-rest-of-period";
pub fn s22_rest_of_period_end<S: Scalar>(phi: S) -> S {
    phi + S::int(2) * S::pi()
}

}
