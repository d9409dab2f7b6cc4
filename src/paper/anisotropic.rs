//! Section 2.4, anisotropic friction: the sinusoidal drive with a friction that depends on the direction.
//!
//! Symbols, all dimensionless but those of (47) and (48): `lambda0` λ₀ > 0, the friction while 𝔴 > 0; `q` ≥ 1,
//! by what factor the friction is larger while 𝔴 < 0; `phi` φ, the phase (radians).

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// (47): λ₊, from the friction coefficient μ₊ of forward motion, gravity g and the drive's amplitude A₀.
pub fn eq47_lambda_plus<S: Scalar>(mu_plus: S, g: S, a0: S) -> S {
    mu_plus * g / a0
}

/// (48): λ₋, from the friction coefficient μ₋ of backward motion, gravity g and the drive's amplitude A₀.
pub fn eq48_lambda_minus<S: Scalar>(mu_minus: S, g: S, a0: S) -> S {
    mu_minus * g / a0
}

/// (49): λ₊.
pub fn eq49_lambda_plus<S: Scalar>(lambda0: S) -> S {
    lambda0
}

/// (50): λ₋.
pub fn eq50_lambda_minus<S: Scalar>(q: S, lambda0: S) -> S {
    q * lambda0
}

/// (51): d𝔴/dφ while 𝔴 > 0.
pub fn eq51_rate<S: Scalar>(lambda0: S, phi: S) -> S {
    phi.sin() - lambda0
}

/// (52): d𝔴/dφ while 𝔴 < 0.
pub fn eq52_rate<S: Scalar>(q: S, lambda0: S, phi: S) -> S {
    phi.sin() + q * lambda0
}

/// (53), curve A, its first half: K.
pub fn eq53_k<S: Scalar>(q: S) -> S {
    S::pi() * q / (q + S::int(1))
}

/// (53), curve A, its second half: the two sides, equal on the curve. For 0 < λ₀ ≤ 1 and 0 < K < π.
pub fn eq53_sides<S: Scalar>(k: S, lambda0: S) -> [S; 2] {
    let one = S::int(1);
    [
        (one - lambda0.squared()).sqrt() / lambda0,
        k / k.sin().squared() - k.cot(),
    ]
}

/// (54), curve B: the two sides, equal on the curve, from λ₀ and the product qλ₀: the formula has q nowhere
/// else, and where B meets C the product is 1 and not its rounded value. For λ₀ ≤ 1 and qλ₀ ≤ 1.
pub fn eq54_sides<S: Scalar>(lambda0: S, q_lambda0: S) -> [S; 2] {
    let one = S::int(1);
    [
        (one - lambda0.squared()).sqrt() + (one - q_lambda0.squared()).sqrt(),
        lambda0 * (S::pi() + q_lambda0.asin() - lambda0.asin()),
    ]
}

/// (55), curve C: λ₀.
pub fn eq55_lambda0<S: Scalar>(q: S) -> S {
    S::int(1) / q
}

/// (56), curve D: λ₀.
pub fn eq56_lambda0<S: Scalar>() -> S {
    S::int(1)
}

/// (57): the point X as (q, λ₀), with λ_c of (37).
pub fn eq57_x<S: Scalar>() -> [S; 2] {
    let two = S::int(2);
    [S::int(1), two / (S::int(4) + S::pi() * S::pi()).sqrt()]
}

/// (58): the point Y as (q, λ₀), to the three decimals given.
pub fn eq58_y<S: Scalar>() -> [S; 2] {
    let thousand = S::int(1000);
    [S::int(4603) / thousand, S::int(217) / thousand]
}

/// v_y at large times, under a friction that depends on the direction.
claim "s24-vy-vanishes";
pub fn s24_late_vy<S: Scalar>() -> S {
    S::int(0)
}

/// "Without loss of generality": q and λ₀ of the motion that is the mirror image of that with these.
claim "s24-q-at-least-one";
pub fn s24_mirrored<S: Scalar>(q: S, lambda0: S) -> [S; 2] {
    [S::int(1) / q, q * lambda0]
}

/// Region I: the signs of 𝔴 on the intervals of a period in their order, forward motion first; 0 is rest.
claim "fig-6";
pub fn s24_first_signs<S: Scalar>() -> [S; 2] {
    [S::int(1), S::int(-1)]
}

/// Region II: the signs of 𝔴.
claim "fig-6";
pub fn s24_second_signs<S: Scalar>() -> [S; 3] {
    [S::int(1), S::int(-1), S::int(0)]
}

/// Region III: the signs of 𝔴.
claim "fig-6";
pub fn s24_third_signs<S: Scalar>() -> [S; 4] {
    [S::int(1), S::int(0), S::int(-1), S::int(0)]
}

/// Region IV: the signs of 𝔴.
claim "fig-6";
pub fn s24_fourth_signs<S: Scalar>() -> [S; 2] {
    [S::int(1), S::int(0)]
}

/// Region V: the signs of 𝔴.
claim "fig-6";
pub fn s24_fifth_signs<S: Scalar>() -> [S; 1] {
    [S::int(0)]
}

}

/// Where the curves A to D stand at one q.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curves {
    /// λ₀ on A.
    pub a: f64,
    /// λ₀ on B; none where (54) has no solution.
    pub b: Option<f64>,
    /// λ₀ on C.
    pub c: f64,
    /// λ₀ on D.
    pub d: f64,
}

/// The region, 1 to 5, that the list gives to λ₀ at that q. None on a curve, of which the list says nothing.
pub fn region(lambda0: f64, curves: &Curves) -> Option<usize> {
    let Curves { a, b, c, d } = *curves;
    let above_b = b.is_some_and(|b| lambda0 > b);
    let below_b = b.is_none_or(|b| lambda0 < b);
    if lambda0 < a {
        Some(1)
    } else if a < lambda0 && below_b && lambda0 < c {
        Some(2)
    } else if above_b && lambda0 < c {
        Some(3)
    } else if c < lambda0 && lambda0 < d {
        Some(4)
    } else if d < lambda0 {
        Some(5)
    } else {
        None
    }
}

/// What the list says of a period in the regions I to V: the signs of 𝔴 on its intervals, forward motion first.
pub fn signs() -> [Vec<f64>; 5] {
    [
        s24_first_signs().to_vec(),
        s24_second_signs().to_vec(),
        s24_third_signs().to_vec(),
        s24_fourth_signs().to_vec(),
        s24_fifth_signs().to_vec(),
    ]
}
