//! Section 3, a sphere: radius R, mass m, moment of inertia I, on a plane with the acceleration A.
//!
//! Vectors have three components, with z upwards; A, the velocity dr/dt of the centre and the friction
//! force F have none along z. Symbols: `radius` R, `m` m, `inertia` I, `mu` μ, `g` g, `kappa` κ, `b` b,
//! `velocity` dr/dt, `omega` the angular velocity ω, `contact` **R**, from the centre to the contact.
//! From (68) on all is dimensionless, a dot is d/dτ.

use crate::scalar::Scalar;
use crate::seeded::formulas;

/// A vector (x, y, z).
pub type Vector<S> = [S; 3];

fn plus<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn minus<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn negative<S: Scalar>(a: Vector<S>) -> Vector<S> {
    a.map(|c| -c)
}

fn times<S: Scalar>(factor: S, a: Vector<S>) -> Vector<S> {
    a.map(|c| factor * c)
}

fn cross<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn unit_z<S: Scalar>() -> Vector<S> {
    [S::int(0), S::int(0), S::int(1)]
}

/// a/|a|. No value at a = 0.
fn direction<S: Scalar>(a: Vector<S>) -> Vector<S> {
    let size = (a[0].squared() + a[1].squared() + a[2].squared()).sqrt();
    a.map(|c| c / size)
}

/// dr/dt + ω × **R**: the velocity of the sphere's point at the contact (length/time). Part of (63) to (66), (71).
pub fn slip<S: Scalar>(velocity: Vector<S>, omega: Vector<S>, contact: Vector<S>) -> Vector<S> {
    plus(velocity, cross(omega, contact))
}

formulas! {

symbols crate::symbols::SYMBOLS;

/// (59): m d²r/dt², under the friction force `force`.
pub fn eq59_momentum_rate<S: Scalar>(m: S, a: Vector<S>, force: Vector<S>) -> Vector<S> {
    plus(times(-m, a), force)
}

/// (60): I dω/dt, under the friction force `force`.
pub fn eq60_spin_rate<S: Scalar>(contact: Vector<S>, force: Vector<S>) -> Vector<S> {
    cross(contact, force)
}

/// (61): **R**, from the centre to the contact (length).
pub fn eq61_contact<S: Scalar>(radius: S) -> Vector<S> {
    times(-radius, unit_z())
}

/// (62): κ, dimensionless; 2/5 for a solid sphere, 2/3 for a hollow one.
pub fn eq62_kappa<S: Scalar>(inertia: S, m: S, radius: S) -> S {
    inertia / (m * radius.squared())
}

/// (63): d²r/dt² while the sphere slides. No value where it rolls.
pub fn eq63_velocity_rate<S: Scalar>(
    a: Vector<S>,
    mu: S,
    g: S,
    velocity: Vector<S>,
    omega: Vector<S>,
    contact: Vector<S>,
) -> Vector<S> {
    let along = direction(slip(velocity, omega, contact));
    minus(negative(a), times(mu * g, along))
}

/// (64): κ R² dω/dt while the sphere slides. No value where it rolls.
pub fn eq64_spin_rate<S: Scalar>(
    mu: S,
    g: S,
    velocity: Vector<S>,
    omega: Vector<S>,
    contact: Vector<S>,
) -> Vector<S> {
    let along = direction(slip(velocity, omega, contact));
    times(-(mu * g), cross(contact, along))
}

/// (65): d(ω × **R**)/dt while the sphere slides. No value where it rolls.
pub fn eq65_spin_slip_rate<S: Scalar>(
    kappa: S,
    mu: S,
    g: S,
    velocity: Vector<S>,
    omega: Vector<S>,
    contact: Vector<S>,
) -> Vector<S> {
    let along = direction(slip(velocity, omega, contact));
    times(-(mu * g / kappa), along)
}

/// (66): d(dr/dt + ω × **R**)/dt while the sphere slides, from the slip velocity `slip`. No value where it rolls.
pub fn eq66_slip_rate<S: Scalar>(a: Vector<S>, b: S, mu: S, g: S, slip: Vector<S>) -> Vector<S> {
    minus(negative(a), times(b * mu * g, direction(slip)))
}

/// (67): b, dimensionless; 7/2 for a solid sphere, 5/2 for a hollow one.
pub fn eq67_factor<S: Scalar>(kappa: S) -> S {
    S::int(1) + S::int(1) / kappa
}

/// (68): ρ.
pub fn eq68_position<S: Scalar>(radius: S, r: Vector<S>) -> Vector<S> {
    r.map(|c| c / radius)
}

/// (69): τ.
pub fn eq69_time<S: Scalar>(radius: S, mu: S, g: S, t: S) -> S {
    (mu * g / radius).sqrt() * t
}

/// (70): ζ.
pub fn eq70_spin<S: Scalar>(radius: S, mu: S, g: S, omega: Vector<S>) -> Vector<S> {
    times((radius / (mu * g)).sqrt(), omega)
}

/// (71): u, from the slip velocity `slip`.
pub fn eq71_slip<S: Scalar>(radius: S, mu: S, g: S, slip: Vector<S>) -> Vector<S> {
    times(S::int(1) / (mu * g * radius).sqrt(), slip)
}

/// (72): γ.
pub fn eq72_acceleration<S: Scalar>(mu: S, g: S, a: Vector<S>) -> Vector<S> {
    a.map(|c| c / (mu * g))
}

/// (73): d²ρ/dτ² while the sphere slides. No value at u = 0.
pub fn eq73_velocity_rate<S: Scalar>(gamma: Vector<S>, u: Vector<S>) -> Vector<S> {
    minus(negative(gamma), direction(u))
}

/// (74): du/dτ while the sphere slides. No value at u = 0.
pub fn eq74_slip_rate<S: Scalar>(b: S, gamma: Vector<S>, u: Vector<S>) -> Vector<S> {
    minus(negative(gamma), times(b, direction(u)))
}

/// (75): ζ, from its vertical component, u and dρ/dτ.
pub fn eq75_spin<S: Scalar>(zeta3: S, u: Vector<S>, rho_rate: Vector<S>) -> Vector<S> {
    plus(times(zeta3, unit_z()), cross(unit_z(), minus(u, rho_rate)))
}

/// (76): dν/dτ.
pub fn eq76_nu_rate<S: Scalar>(gamma: Vector<S>) -> Vector<S> {
    gamma
}

/// (77): d(dρ/dτ + ν)/dτ while the sphere slides. No value at u = 0.
pub fn eq77_rate<S: Scalar>(u: Vector<S>) -> Vector<S> {
    negative(direction(u))
}

/// (78): d(u + ν)/dτ while the sphere slides. No value at u = 0.
pub fn eq78_rate<S: Scalar>(b: S, u: Vector<S>) -> Vector<S> {
    times(-b, direction(u))
}

/// (79): dρ/dτ, with the constant `c`.
pub fn eq79_velocity<S: Scalar>(b: S, nu: Vector<S>, u: Vector<S>, c: Vector<S>) -> Vector<S> {
    let one = S::int(1);
    let from_nu = times(-(one - one / b), nu);
    plus(plus(from_nu, u.map(|x| x / b)), c)
}

/// (80): λ under the constant acceleration of size `a`.
pub fn eq80_lambda<S: Scalar>(b: S, mu: S, g: S, a: S) -> S {
    b * mu * g / a
}

/// (81): u at the angle θ. No value at θ₀ = 0 and π.
pub fn eq81_slip<S: Scalar>(lambda: S, u0: S, theta0: S, theta: S) -> S {
    u0 * (theta0.sin() / theta.sin()) * (half_tan(theta) / half_tan(theta0)).pow(lambda)
}

/// (82): τ at the angle θ. No value at θ₀ = 0 and π, at λ = 1, and where cos θ₀ = −λ.
pub fn eq82_time<S: Scalar>(lambda: S, u0: S, theta0: S, theta: S) -> S {
    let one = S::int(1);
    let start = lambda + theta0.cos();
    let sines = (lambda + theta.cos()) * theta0.sin() / (start * theta.sin());
    let bracket = sines * (half_tan(theta) / half_tan(theta0)).pow(lambda) - one;
    u0 * start / (one - lambda.squared()) * bracket
}

/// (83): u at the angle θ and the time τ. No value where cos θ = −λ.
pub fn eq83_slip_at_time<S: Scalar>(lambda: S, u0: S, theta0: S, theta: S, tau: S) -> S {
    ((S::int(1) - lambda.squared()) * tau + u0 * (lambda + theta0.cos())) / (lambda + theta.cos())
}

/// (84): λ₀ under a drive of the amplitude `a0`.
pub fn eq84_lambda<S: Scalar>(b: S, mu: S, g: S, a0: S) -> S {
    b * mu * g / a0
}

/// (85): λ₀ under a drive of the amplitude `a0`, with the friction coefficient `mu_plus` μ₊ for slip towards +x.
pub fn eq85_lambda<S: Scalar>(b: S, mu_plus: S, g: S, a0: S) -> S {
    b * mu_plus * g / a0
}

/// "ζ₃ is constant": dζ₃/dτ.
claim "s3-spin-constant";
pub fn s3_zeta3_rate<S: Scalar>() -> S {
    S::int(0)
}

}

fn half_tan<S: Scalar>(angle: S) -> S {
    (angle / S::int(2)).tan()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_have_three_components() {
        let (a, b) = ([1.0, 2.0, 3.0], [4.0, -5.0, 6.0]);
        assert_eq!(plus(a, b), [5.0, -3.0, 9.0]);
        assert_eq!(minus(a, b), [-3.0, 7.0, -3.0]);
        assert_eq!(cross(a, b), [27.0, 6.0, -13.0]);
        assert_eq!(direction([2.0, 3.0, 6.0]), [2.0, 3.0, 6.0].map(|c| c / 7.0));
    }
}
