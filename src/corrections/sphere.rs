//! Section 3: what replaces (75), (82) and (83), and a form of (81) that has a value for every start.
//!
//! **(75).** Take **R** = −R ẑ in the slip velocity w = dr/dt + ω × **R**:
//!
//! w − dr/dt = −R ω × ẑ = R ẑ × ω,
//!
//! and multiply by ẑ × from the left. With ẑ × (ẑ × ω) = ẑ ω_z − ω,
//!
//! ω = ẑ ω_z − ẑ × (w − dr/dt)/R,
//!
//! which (69) to (71) turn into ζ = ẑ ζ₃ − ẑ × (u − dρ/dτ). The paper has the other sign.
//!
//! **(82), (83).** By (74), u moves as the velocity v of a particle does by (1), with γ in the place of A, b in
//! that of μg, τ in that of t, so that λ = b/γ. With these, (13) gives
//!
//! τ = u₀ (λ + cos θ₀)/\[γ (1 − λ²)\] { … },
//!
//! and (14) gives u = \[(1 − λ²) γ τ + u₀ (λ + cos θ₀)\]/(λ + cos θ). The paper lacks the γ = A/(μg) that stands
//! for the A of (13) and (14). With γ = 1 the printed time is right:
//!
//! ```
//! use slipbook::motion::{Plane, State, run};
//! use slipbook::paper::sphere::eq82_time;
//! use std::f64::consts::FRAC_PI_2;
//!
//! for (gamma, right) in [(1.0, true), (3.5, false)] {
//!     let slip = State { t: 0.0, x: [0.0; 2], v: [0.0, 1.0] };
//!     let theta = FRAC_PI_2 - 0.1;
//!     let turned = run(&Plane::constant([-gamma, 0.0]), 3.5, slip, 1.0)?.first_along([theta.cos(), theta.sin()])?;
//!     let printed = eq82_time(3.5 / gamma, 1.0, FRAC_PI_2, theta);
//!     assert_eq!((printed - turned.ok_or("never")?.t).abs() < 1e-9, right);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Neither has a value at λ = 1 or cos θ₀ = −λ; [`speed`](super::constant::speed) and
//! [`time`](super::constant::time) of section 2.1, with A = γ, have.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// (75) with the right sign: ζ, dimensionless.
claim "eq-75";
pub fn spin<S: Scalar>(zeta3: S, u: [S; 3], rho_rate: [S; 3]) -> [S; 3] {
    // −ẑ × (x, y, z) = (y, −x, 0).
    [u[1] - rho_rate[1], rho_rate[0] - u[0], zeta3]
}

/// (82) with its factor 1/γ: τ at the angle θ. No value at θ₀ = 0 and π, at λ = 1, and where cos θ₀ = −λ.
claim "eq-82";
pub fn time<S: Scalar>(lambda: S, gamma: S, u0: S, theta0: S, theta: S) -> S {
    let (one, two) = (S::int(1), S::int(2));
    let half_tan = |angle: S| (angle / two).tan();
    let start = lambda + theta0.cos();
    let sines = (lambda + theta.cos()) * theta0.sin() / (start * theta.sin());
    let bracket = sines * (half_tan(theta) / half_tan(theta0)).pow(lambda) - one;
    u0 * start / (gamma * (one - lambda.squared())) * bracket
}

/// (83) with its factor γ: u at the angle θ and the time τ. No value where cos θ = −λ.
claim "eq-83";
pub fn slip_at_time<S: Scalar>(lambda: S, gamma: S, u0: S, theta0: S, theta: S, tau: S) -> S {
    let gained = (S::int(1) - lambda.squared()) * gamma * tau;
    (gained + u0 * (lambda + theta0.cos())) / (lambda + theta.cos())
}

}
