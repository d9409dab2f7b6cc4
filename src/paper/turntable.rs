//! Section 4, a point particle on a rough turntable: (86) to (125).
//!
//! Vectors are pairs of components in axes that turn with the table. With dimensions: `r` 𝐫 (length) and `v`
//! d𝐫/dt (length/time), `omega` Ω > 0 (1/time), `mu` the friction coefficient μ > 0, `g` the gravity acceleration
//! (length/time²), `m` the mass. Dimensionless: `position` 𝛒 and `rate` d𝛒/dτ, `rho` ρ = |𝛒|, `p` p = |d𝛒/dτ|,
//! `psi` ψ the angle from the velocity to the position, counterclockwise (radians), `xi` ξ and `ell` ℓ the
//! position along and across the velocity, `s` the arc length, `a` A and `alpha` α for p < ρ, `b` B and `beta` β
//! for p > ρ.

use crate::scalar::Scalar;
use crate::seeded::formulas;

fn dot<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[0] + a[1] * b[1]
}

/// ẑ·(𝐚 × 𝐛).
fn moment<S: Scalar>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[1] - a[1] * b[0]
}

/// 𝐚 × ẑ.
fn cross_z<S: Scalar>(a: [S; 2]) -> [S; 2] {
    [a[1], -a[0]]
}

fn length<S: Scalar>(a: [S; 2]) -> S {
    dot(a, a).sqrt()
}

formulas! {

symbols crate::symbols::SYMBOLS;

/// (86): d²𝐫/dt². No value at rest.
pub fn eq86_acceleration<S: Scalar>(omega: S, mu: S, g: S, r: [S; 2], v: [S; 2]) -> [S; 2] {
    let (coriolis, speed) = (cross_z(v), length(v));
    [0, 1].map(|i| {
        omega.squared() * r[i] + S::int(2) * omega * coriolis[i]
            - mu * g * (S::int(1) / speed) * v[i]
    })
}

/// (87): the dimensionless position 𝛒.
pub fn eq87_position<S: Scalar>(omega: S, mu: S, g: S, r: [S; 2]) -> [S; 2] {
    r.map(|x| omega.squared() / (mu * g) * x)
}

/// (88): the dimensionless time τ.
pub fn eq88_time<S: Scalar>(omega: S, t: S) -> S {
    omega * t
}

/// (89): d²𝛒/dτ². No value at rest.
pub fn eq89_acceleration<S: Scalar>(position: [S; 2], rate: [S; 2]) -> [S; 2] {
    let (coriolis, speed) = (cross_z(rate), length(rate));
    [0, 1].map(|i| position[i] + S::int(2) * coriolis[i] - rate[i] / speed)
}

/// (90): (d𝛒/dτ)·(d²𝛒/dτ²), the right-hand side.
pub fn eq90_power<S: Scalar>(position: [S; 2], rate: [S; 2]) -> S {
    dot(position, rate) - length(rate)
}

/// (91): ẑ·(𝛒 × d²𝛒/dτ²), the right-hand side. No value at rest.
pub fn eq91_moment<S: Scalar>(position: [S; 2], rate: [S; 2]) -> S {
    -S::int(2) * dot(position, rate) - moment(position, rate) / length(rate)
}

/// (92): 𝛒·(d²𝛒/dτ²) + |d𝛒/dτ|², the right-hand side. No value at rest.
pub fn eq92_virial<S: Scalar>(position: [S; 2], rate: [S; 2]) -> S {
    dot(position, position) + S::int(2) * moment(position, rate)
        - dot(position, rate) / length(rate)
        + dot(rate, rate)
}

/// (93): the speed p.
pub fn eq93_speed<S: Scalar>(rate: [S; 2]) -> S {
    length(rate)
}

/// (94): ξ.
pub fn eq94_xi<S: Scalar>(rho: S, psi: S) -> S {
    rho * psi.cos()
}

/// (95): ℓ.
pub fn eq95_ell<S: Scalar>(rho: S, psi: S) -> S {
    -rho * psi.sin()
}

/// (96): the left-hand side p ℓ and the right-hand side.
pub fn eq96_angular_momentum<S: Scalar>(p: S, ell: S, position: [S; 2], rate: [S; 2]) -> [S; 2] {
    [p * ell, moment(position, rate)]
}

/// (97): the left-hand side p ξ and the right-hand side.
pub fn eq97_radial<S: Scalar>(p: S, xi: S, position: [S; 2], rate: [S; 2]) -> [S; 2] {
    [p * xi, dot(position, rate)]
}

/// (98): the left-hand side 𝛒·𝛒 and the right-hand side.
pub fn eq98_distance<S: Scalar>(position: [S; 2], ell: S, xi: S) -> [S; 2] {
    [dot(position, position), ell.squared() + xi.squared()]
}

/// (99): dp/dτ.
pub fn eq99_p_rate<S: Scalar>(xi: S) -> S {
    xi - S::int(1)
}

/// (100): dℓ/dτ. No value at rest.
pub fn eq100_ell_rate<S: Scalar>(p: S, ell: S, xi: S) -> S {
    -(xi * (S::int(2) * p + ell) / p)
}

/// (101): dξ/dτ. No value at rest.
pub fn eq101_xi_rate<S: Scalar>(p: S, ell: S) -> S {
    (p + ell).squared() / p
}

/// (102): its three right-hand sides, each equal to ρ dρ/dτ, from ℓ, ξ, p and their rates.
pub fn eq102_rate<S: Scalar>(ell: [S; 2], xi: [S; 2], p: [S; 2]) -> [S; 3] {
    [
        ell[0] * ell[1] + xi[0] * xi[1],
        xi[0] * p[0],
        p[0] * (p[1] + S::int(1)),
    ]
}

/// (103): the energy whose rate it gives.
pub fn eq103_energy<S: Scalar>(p: S, rho: S) -> S {
    (p.squared() - rho.squared()) / S::int(2)
}

/// (103): the rate of that energy.
pub fn eq103_energy_rate<S: Scalar>(p: S) -> S {
    -p
}

/// (104): the expression that keeps its value.
pub fn eq104_constant<S: Scalar>(p: S, rho: S, s: S) -> S {
    (p.squared() - rho.squared()) / S::int(2) + s
}

/// (105): ds/dτ.
pub fn eq105_arc_rate<S: Scalar>(p: S) -> S {
    p
}

/// (106): the expression that is to keep its value; an energy. `s` is the arc length, a length.
pub fn eq106_constant<S: Scalar>(m: S, g: S, omega: S, r: [S; 2], v: [S; 2], s: S) -> S {
    m / S::int(2) * dot(v, v) - m * omega.squared() * dot(r, r) / S::int(2) + m * g * s
}

/// After (106): the work of the friction along a way of length `s`; an energy.
claim "s4-coriolis-no-work";
pub fn friction_work<S: Scalar>(m: S, g: S, s: S) -> S {
    -(m * g * s)
}

/// After (106): the power of the Coriolis force, the second term of (86), which is to vanish.
claim "s4-coriolis-no-work";
pub fn coriolis_power<S: Scalar>(m: S, omega: S, v: [S; 2]) -> S {
    m * S::int(2) * omega * dot(cross_z(v), v)
}

/// (107): dp/dτ.
pub fn eq107_p_rate<S: Scalar>(rho: S, psi: S) -> S {
    rho * psi.cos() - S::int(1)
}

/// (108): dρ/dτ.
pub fn eq108_rho_rate<S: Scalar>(p: S, psi: S) -> S {
    p * psi.cos()
}

/// (109): dψ/dτ. No value at rest and on the axis.
pub fn eq109_psi_rate<S: Scalar>(p: S, rho: S, psi: S) -> S {
    S::int(2) - (p / rho + rho / p) * psi.sin()
}

/// (110): negative in the first case.
pub fn eq110_case<S: Scalar>(p: S, rho: S) -> S {
    p.squared() - rho.squared()
}

/// (111): p.
pub fn eq111_p<S: Scalar>(a: S, alpha: S) -> S {
    a * alpha.sinh()
}

/// (112): ρ.
pub fn eq112_rho<S: Scalar>(a: S, alpha: S) -> S {
    a * alpha.cosh()
}

/// (113): dA/dτ.
pub fn eq113_a_rate<S: Scalar>(alpha: S) -> S {
    alpha.sinh()
}

/// (114): dα/dτ.
pub fn eq114_alpha_rate<S: Scalar>(a: S, alpha: S, psi: S) -> S {
    psi.cos() - alpha.cosh() / a
}

/// (115): dψ/dτ. No value at α = 0.
pub fn eq115_psi_rate<S: Scalar>(alpha: S, psi: S) -> S {
    S::int(2) * (S::int(1) - psi.sin() * (S::int(2) * alpha).coth())
}

/// (116): positive in the second case.
pub fn eq116_case<S: Scalar>(p: S, rho: S) -> S {
    p.squared() - rho.squared()
}

/// (117): p.
pub fn eq117_p<S: Scalar>(b: S, beta: S) -> S {
    b * beta.cosh()
}

/// (118): ρ.
pub fn eq118_rho<S: Scalar>(b: S, beta: S) -> S {
    b * beta.sinh()
}

/// (119): dB/dτ.
pub fn eq119_b_rate<S: Scalar>(beta: S) -> S {
    -beta.cosh()
}

/// (120): dβ/dτ.
pub fn eq120_beta_rate<S: Scalar>(b: S, beta: S, psi: S) -> S {
    psi.cos() + beta.sinh() / b
}

/// (121): dψ/dτ. No value at β = 0.
pub fn eq121_psi_rate<S: Scalar>(beta: S, psi: S) -> S {
    S::int(2) * (S::int(1) - psi.sin() * (S::int(2) * beta).coth())
}

/// (122): A, with `i` the imaginary unit.
pub fn eq122_a<S: Scalar>(i: S, b: S) -> S {
    -i * b
}

/// (123): α, with `i` the imaginary unit.
pub fn eq123_alpha<S: Scalar>(i: S, beta: S) -> S {
    i * S::pi() / S::int(2) + beta
}

/// (124): the first quasi-fixed point ψ₁.
pub fn eq124_psi1<S: Scalar>(alpha: S) -> S {
    (S::int(2) * alpha).tanh().asin()
}

/// (125): the second quasi-fixed point ψ₂.
pub fn eq125_psi2<S: Scalar>(alpha: S) -> S {
    S::pi() - (S::int(2) * alpha).tanh().asin()
}

/// After (101): dp/dτ by the projection of (89) on the velocity. No value at rest.
claim "s4-projection-tangential";
pub fn s4_tangential_rate<S: Scalar>(position: [S; 2], rate: [S; 2]) -> S {
    dot(eq89_acceleration(position, rate), rate) / length(rate)
}

/// After (101): dℓ/dτ by the law (91) of the angular momentum and the rate of u.
claim "s4-projection-azimuthal";
pub fn s4_azimuthal_rate<S: Scalar>(p: S, ell: S, xi: S, u_rate: S) -> S {
    -(S::int(2) * p * xi + ell + u_rate * ell) / p
}

/// After (101): dξ/dτ by the law (92) along the radius and the rate of u.
claim "s4-projection-radial";
pub fn s4_radial_rate<S: Scalar>(p: S, ell: S, xi: S, u_rate: S) -> S {
    ((p + ell).squared() + xi.squared() - xi - u_rate * xi) / p
}

}
