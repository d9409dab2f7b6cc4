//! Section 2.1: one form of (11), (13) and (14) that has a value wherever the motion has one.
//!
//! Let r = tan(θ/2)/tan(θ₀/2), which runs from 1 down to 0 along any motion with 0 < |θ₀| < π. In (11),
//! sin θ = 2 tan(θ/2) cos²(θ/2) turns the ratio of the sines into powers of r:
//!
//! v/v₀ = cos²(θ₀/2) r^(λ−1) + sin²(θ₀/2) r^(λ+1).
//!
//! (7) gives A dt = −v dθ/sin θ = −v dr/r, so that, with \[r; k\] = (1 − r^k)/k, and −ln r for k = 0,
//!
//! A t/v₀ = cos²(θ₀/2) \[r; λ−1\] + sin²(θ₀/2) \[r; λ+1\].
//!
//! Neither has a singular point: λ = 1, cos θ₀ = −λ, θ₀ < 0 are ordinary, and at θ₀ = 0 or π one of the
//! terms is left, in which r is just the parameter along the motion.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// The speed where tan(θ/2) has fallen to `r` times its initial value; (length/time). For 0 < r ≤ 1.
claim "eq-11";
pub fn speed<S: Scalar>(lambda: S, v0: S, theta0: S, r: S) -> S {
    let one = S::int(1);
    let half = theta0 / S::int(2);
    v0 * (half.cos().squared() * r.pow(lambda - one) + half.sin().squared() * r.pow(lambda + one))
}

/// [`speed`] by ln r, for motions so long that r is below every number.
claim "eq-11";
pub fn speed_by_log<S: Scalar>(lambda: S, v0: S, theta0: S, ln_r: S) -> S {
    let (one, half) = (S::int(1), theta0 / S::int(2));
    v0 * (half.cos().squared() * ((lambda - one) * ln_r).exp()
        + half.sin().squared() * ((lambda + one) * ln_r).exp())
}

/// The time at which ln tan(θ/2) has changed by `ln_r` ≤ 0.
claim "eq-13";
pub fn time<S: Scalar>(lambda: S, a: S, v0: S, theta0: S, ln_r: S) -> S {
    let (one, half) = (S::int(1), theta0 / S::int(2));
    v0 / a * (half.cos().squared() * ln_r.exp_fall(lambda - one) + half.sin().squared() * ln_r.exp_fall(lambda + one))
}

/// tan(θ/2) where it has fallen to `r` times its initial value: θ by the sine and the cosine of its half, each times the
/// same number.
claim "eq-13";
pub fn half_angle<S: Scalar>(theta0: S, r: S) -> [S; 2] {
    let half = theta0 / S::int(2);
    [r * half.sin(), half.cos()]
}

/// d ln tan(θ/2)/d ln v, by Newton's law along and across the velocity; 1/(λ − 1) in the end. For λ > 1.
claim "s21-large-friction-stops";
pub fn turning_slope<S: Scalar>(lambda: S, theta: S) -> S {
    S::int(1) / (lambda - theta.cos())
}

/// The sense in which the particle slides in the end: with the inertial force, against the plane's acceleration.
claim "s21-along-acceleration";
pub fn late_sense<S: Scalar>() -> S {
    S::int(-1)
}

}
