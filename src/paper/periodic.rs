//! Section 2.3, any periodic acceleration: w' = h(φ) − λ₀ w/|w|, and the train of pulses as an example.
//!
//! Symbols, all dimensionless: `phi` φ, the phase (radians); `lambda` λ₀ ≥ 0, the friction; `eta` η in
//! [0, 1], the share of a half period that a pulse fills.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// (42): h in its two cases, for 0 ≤ φ < ηπ and for ηπ ≤ φ < π.
pub fn eq42_cases<S: Scalar>() -> [S; 2] {
    [S::int(1), S::int(0)]
}

/// (42): the phase where the first case ends, in radians.
pub fn eq42_end<S: Scalar>(eta: S) -> S {
    eta * S::pi()
}

/// (43): h(π + φ), from h(φ).
pub fn eq43_h<S: Scalar>(h: S) -> S {
    -h
}

/// (44), for η < λ₀ < 1: w(φ) in the three cases of the first half period, 0 < φ < π.
pub fn eq44_cases<S: Scalar>(lambda: S, eta: S, phi: S) -> [S; 3] {
    let end = eta * S::pi();
    let slope = S::int(1) - lambda;
    [
        slope * phi,
        slope * eta * S::pi() - lambda * (phi - end),
        S::int(0),
    ]
}

/// (44): the phases where the first and the second case end, in radians; the third ends at π.
pub fn eq44_ends<S: Scalar>(lambda: S, eta: S) -> [S; 2] {
    [eta * S::pi(), eta * S::pi() / lambda]
}

/// (45): w(π + φ), from w(φ).
pub fn eq45_w<S: Scalar>(w: S) -> S {
    -w
}

/// The two sides of 1 < λ₀, from where on every motion comes to rest for ever under a drive whose largest size is 1.
claim "s23-rest-above-one";
pub fn s23_rest_sides<S: Scalar>(lambda: S) -> [S; 2] {
    [S::int(1), lambda]
}

/// Before (42): the fraction of a period that is rest, as λ₀ rises to 1.
claim "s23-mostly-at-rest";
pub fn s23_late_share<S: Scalar>() -> S {
    S::int(1)
}

/// Before (42): whether there are rests (1 if so) with little friction, and with much.
claim "s23-threshold-exists";
pub fn s23_rests<S: Scalar>() -> [S; 2] {
    [S::int(0), S::int(1)]
}

/// (46): λ_c.
pub fn eq46_lambda_c<S: Scalar>(eta: S) -> S {
    eta
}

/// Before (46): what becomes nonzero again when the next pulse begins, by the acceleration that friction gives.
claim "s23-nonzero-again";
pub fn s23_nonzero_again<S: Scalar>(resisted: S) -> S {
    resisted
}

/// Before (42): the largest |h|, pulses of every width included.
claim "s23-pulses-normalised";
pub fn s23_largest<S: Scalar>() -> S {
    S::int(1)
}

}

/// (42): h in the first half period, 0 ≤ φ < π; at a jump, which the paper leaves open, the value after it.
pub fn eq42_h(eta: f64, phi: f64) -> f64 {
    let [pulse, gap] = eq42_cases();
    if phi < eq42_end(eta) { pulse } else { gap }
}

/// (44): which case holds at φ, counted from 0; between two cases, the later one.
pub fn eq44_case(lambda: f64, eta: f64, phi: f64) -> usize {
    let ends = eq44_ends(lambda, eta);
    ends.iter().filter(|end| phi >= **end).count()
}
