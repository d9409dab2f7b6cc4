//! Section 4: the energy theorem on the turntable with its dimensions.
//!
//! Scalar multiplication of (86) with m d𝐫/dt: the Coriolis force drops out, because it is perpendicular to the
//! velocity; the centrifugal force gives d(mΩ²r²/2)/dt; friction gives −mμg |d𝐫/dt|. Hence
//!
//! d/dt \[m v²/2 − m Ω² r²/2\] = −m μ g v,
//!
//! and, with ds = v dt, m v²/2 − m Ω² r²/2 + m μ g s keeps its value. It is (104) times m (μg)²/Ω². In (106) the
//! factor μ of the last term is missing: as printed it would hold only for μ = 1.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// The energy that keeps its value: kinetic, centrifugal, and what friction has taken along the way `s` (a length).
claim "eq-106";
pub fn constant<S: Scalar>(m: S, mu: S, g: S, omega: S, r: [S; 2], v: [S; 2], s: S) -> S {
    let square = |a: [S; 2]| a[0].squared() + a[1].squared();
    m / S::int(2) * square(v) - m * omega.squared() * square(r) / S::int(2) + m * mu * g * s
}

/// The work of the friction along a way of length `s`.
claim "s4-coriolis-no-work";
pub fn friction_work<S: Scalar>(m: S, mu: S, g: S, s: S) -> S {
    -(m * mu * g * s)
}

/// dℓ/dτ by the law of the angular momentum and the rate of p, which is ξ − 1.
claim "s4-projection-azimuthal";
pub fn azimuthal_rate<S: Scalar>(p: S, ell: S, xi: S) -> S {
    -(S::int(2) * p * xi + ell + (xi - S::int(1)) * ell) / p
}

/// dξ/dτ by the law along the radius and the rate of p.
claim "s4-projection-radial";
pub fn radial_rate<S: Scalar>(p: S, ell: S, xi: S) -> S {
    ((p + ell).squared() + xi.squared() - xi - (xi - S::int(1)) * xi) / p
}

}
