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

/// The speed where tan(θ/2) has fallen to `r` times its initial value; (length/time). For 0 < r ≤ 1.
pub fn speed<S: Scalar>(lambda: S, v0: S, theta0: S, r: S) -> S {
    let one = S::int(1);
    let half = theta0 / S::int(2);
    v0 * (half.cos().squared() * r.pow(lambda - one) + half.sin().squared() * r.pow(lambda + one))
}

}

/// [`speed`] by ln r, for motions so long that r is below every number.
pub fn speed_by_log(lambda: f64, v0: f64, theta0: f64, ln_r: f64) -> f64 {
    let half = theta0 / 2.0;
    v0 * (Scalar::cos(half).squared() * libm::exp((lambda - 1.0) * ln_r)
        + Scalar::sin(half).squared() * libm::exp((lambda + 1.0) * ln_r))
}

/// The time at which tan(θ/2) has fallen to `r` times its initial value. For 0 < r ≤ 1.
pub fn time(lambda: f64, a: f64, v0: f64, theta0: f64, r: f64) -> f64 {
    time_by_log(lambda, a, v0, theta0, libm::log(r))
}

/// [`time`] by ln r.
pub fn time_by_log(lambda: f64, a: f64, v0: f64, theta0: f64, ln_r: f64) -> f64 {
    let half = theta0 / 2.0;
    let fall = |k: f64| power_fall(ln_r, k);
    v0 / a
        * (Scalar::cos(half).squared() * fall(lambda - 1.0)
            + Scalar::sin(half).squared() * fall(lambda + 1.0))
}

/// \[r; k\] = (1 − r^k)/k, from ln r, without loss of digits near k = 0.
fn power_fall(ln_r: f64, k: f64) -> f64 {
    if k == 0.0 {
        -ln_r
    } else {
        -libm::expm1(k * ln_r) / k
    }
}

/// The angle θ in (−π, π] where tan(θ/2) has fallen to `r` times its initial value.
pub fn angle(theta0: f64, r: f64) -> f64 {
    let half = theta0 / 2.0;
    2.0 * libm::atan2(r * Scalar::sin(half), Scalar::cos(half))
}
