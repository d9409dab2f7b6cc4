//! Section 2.1, constant acceleration: A = −A x̂, v = v (x̂ cos θ + ŷ sin θ), λ = μg/A.
//!
//! Symbols: `lambda` λ ≥ 0 (dimensionless), `a` the plane's acceleration A > 0 (length/time²), `v0` the
//! initial speed v₀ > 0 (length/time), `theta0` θ₀ and `theta` θ, the initial and the present angle of
//! the velocity with the x axis (radians).

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// (3): the plane's acceleration vector, (A_x, A_y).
pub fn eq3_acceleration<S: Scalar>(a: S) -> [S; 2] {
    [-a, S::int(0)]
}

/// (4): the velocity of speed `v` at angle θ, (v_x, v_y).
pub fn eq4_velocity<S: Scalar>(v: S, theta: S) -> [S; 2] {
    [v * theta.cos(), v * theta.sin()]
}

/// (5): the friction λ = μg/A, from the friction coefficient `mu` and the gravity acceleration `g`.
pub fn eq5_lambda<S: Scalar>(mu: S, g: S, a: S) -> S {
    mu * g / a
}

/// (6): d(v cos θ)/dt.
pub fn eq6_vx_rate<S: Scalar>(lambda: S, a: S, theta: S) -> S {
    a * (S::int(1) - lambda * theta.cos())
}

/// (7): d(v sin θ)/dt.
pub fn eq7_vy_rate<S: Scalar>(lambda: S, a: S, theta: S) -> S {
    -a * lambda * theta.sin()
}

/// (8): d(v sin θ)/d(v cos θ), the slope of the hodograph. No value where λ cos θ = 1.
pub fn eq8_hodograph_slope<S: Scalar>(lambda: S, theta: S) -> S {
    -(lambda * theta.sin() / (S::int(1) - lambda * theta.cos()))
}

/// (9): (dv/v)/dθ. No value at θ = 0 and π.
pub fn eq9_log_speed_rate<S: Scalar>(lambda: S, theta: S) -> S {
    (lambda - theta.cos()) / theta.sin()
}

/// (10): the expression that keeps its value. No real value for θ < 0, where the tangent is negative.
pub fn eq10_invariant<S: Scalar>(lambda: S, v: S, theta: S) -> S {
    v * theta.sin() * half_tan(theta).pow(-lambda)
}

/// (11): the speed at angle θ. No value at θ₀ = 0 and π.
pub fn eq11_speed<S: Scalar>(lambda: S, v0: S, theta0: S, theta: S) -> S {
    v0 * (theta0.sin() / theta.sin()) * (half_tan(theta) / half_tan(theta0)).pow(lambda)
}

/// (12): A dt/dθ, with the differential of (tan θ/2)^λ written out by its derivative `d_power`, the
/// derivative of (tan θ/2)^λ with respect to θ. No value at λ = 0.
pub fn eq12_time_rate<S: Scalar>(lambda: S, v0: S, theta0: S, theta: S, d_power: S) -> S {
    -(v0 * theta0.sin() / half_tan(theta0).pow(lambda)) * (d_power / (lambda * theta.sin()))
}

/// (13): the time at angle θ. No value at θ₀ = 0 and π, at λ = 1, and where cos θ₀ = −λ.
pub fn eq13_time<S: Scalar>(lambda: S, a: S, v0: S, theta0: S, theta: S) -> S {
    let one = S::int(1);
    let ratio = half_tan(theta) / half_tan(theta0);
    v0 * (lambda + theta0.cos()) / (a * (one - lambda * lambda))
        * ((lambda + theta.cos()) * theta0.sin() / ((lambda + theta0.cos()) * theta.sin())
            * ratio.pow(lambda)
            - one)
}

/// (14): the speed at angle θ and time t. No value where cos θ = −λ.
pub fn eq14_speed_at_time<S: Scalar>(lambda: S, a: S, v0: S, theta0: S, theta: S, t: S) -> S {
    ((S::int(1) - lambda * lambda) * a * t + v0 * (lambda + theta0.cos())) / (lambda + theta.cos())
}

/// (15), λ = 0: v_x at time t.
pub fn eq15_vx<S: Scalar>(a: S, v0x: S, t: S) -> S {
    v0x + a * t
}

/// (16), λ = 0: v_y at any time.
pub fn eq16_vy<S: Scalar>(v0y: S) -> S {
    v0y
}

/// λ = 0: the place x of the path at `y`, both from the launch on. No value for v_0y = 0.
claim "s21-frictionless-parabola";
pub fn s21_parabola<S: Scalar>(a: S, v0x: S, v0y: S, y: S) -> S {
    let t = y / v0y;
    v0x * t + a * t.squared() / S::int(2)
}

/// The two sides of λ ≤ 1, where the particle keeps moving.
claim "s21-small-friction-aligns";
pub fn s21_keeps_moving_sides<S: Scalar>(lambda: S) -> [S; 2] {
    [lambda, S::int(1)]
}

/// The two sides of λ ≤ 1, where friction is not to keep the particle at rest.
claim "s21-friction-cannot-hold";
pub fn s21_cannot_hold_sides<S: Scalar>(lambda: S) -> [S; 2] {
    [lambda, S::int(1)]
}

/// λ ≤ 1: θ at large times.
claim "s21-small-friction-aligns";
pub fn s21_late_angle<S: Scalar>() -> S {
    S::int(0)
}

/// (17), λ = 1: the expression that keeps its value.
pub fn eq17_invariant<S: Scalar>(v: S, theta: S) -> S {
    v * (S::int(1) + theta.cos())
}

/// (18), λ = 1: v_x at large times.
pub fn eq18_vx_limit<S: Scalar>(v0: S, theta0: S) -> S {
    v0 * (S::int(1) + theta0.cos()) / S::int(2)
}

/// (19), λ = 1: v_y at large times.
pub fn eq19_vy_limit<S: Scalar>() -> S {
    S::int(0)
}

/// (20), λ > 1: the time T at which the particle stops.
pub fn eq20_stop_time<S: Scalar>(lambda: S, a: S, v0: S, theta0: S) -> S {
    v0 * (lambda + theta0.cos()) / (a * (lambda * lambda - S::int(1)))
}

/// After (14), in the figure's caption and beside it: the sense in which the particle slides in the end, as the cosine of
/// the angle between its velocity and the plane's acceleration.
claim "s21-along-acceleration";
pub fn s21_late_sense<S: Scalar>() -> S {
    S::int(1)
}

}

fn half_tan<S: Scalar>(theta: S) -> S {
    (theta / S::int(2)).tan()
}
