//! Section 2, a point particle on an accelerating rough plane, before 2.1.
//!
//! Symbols: `acceleration` 𝐀, the plane's acceleration (length/time²), `mu` the friction coefficient μ ≥ 0,
//! `g` the gravity acceleration (length/time²), `velocity` 𝐯 relative to the plane (length/time), not zero.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// (1): d𝐯/dt of a sliding particle, seen from the plane.
pub fn eq1_velocity_rate<S: Scalar>(acceleration: [S; 2], mu: S, g: S, velocity: [S; 2]) -> [S; 2] {
    let v = length(velocity);
    [0, 1].map(|i| -acceleration[i] - mu * g * (velocity[i] / v))
}

/// (2): dv/dt of a sliding particle, seen from the plane.
pub fn eq2_speed_rate<S: Scalar>(acceleration: [S; 2], mu: S, g: S, velocity: [S; 2]) -> S {
    let v = length(velocity);
    let [ax, ay] = acceleration;
    let [vx, vy] = velocity;
    -(ax * (vx / v) + ay * (vy / v)) - mu * g
}

}

fn length<S: Scalar>([x, y]: [S; 2]) -> S {
    (x.squared() + y.squared()).sqrt()
}
