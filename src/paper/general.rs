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

/// The first item of the list: the bound of max |𝐀|, below which the particle stops.
claim "s2-stops-if-weak";
pub fn s2_stops_below<S: Scalar>(mu: S, g: S) -> S {
    mu * g
}

/// The second item: the bound that |𝐀| exceeds again after every time, so that no rest lasts.
claim "s2-no-permanent-rest";
pub fn s2_rest_ends_above<S: Scalar>(mu: S, g: S) -> S {
    mu * g
}

/// The third item: the bound above which |𝐀|, of fixed direction, is at all times, so that v increases at last.
claim "s2-speeds-up-if-strong";
pub fn s2_speeds_up_above<S: Scalar>(mu: S, g: S) -> S {
    mu * g
}

/// The fourth item: the sign of the rate of |𝐯⊥|.
claim "s2-perpendicular-decays";
pub fn s2_across_trend<S: Scalar>() -> S {
    -S::int(1)
}

/// The fourth item: the limit of 𝐯⊥.
claim "s2-perpendicular-decays";
pub fn s2_across_limit<S: Scalar>() -> S {
    S::int(0)
}

}

fn length<S: Scalar>([x, y]: [S; 2]) -> S {
    (x.squared() + y.squared()).sqrt()
}
