//! Section 2.4: the curve that the list of regions lacks, and the list with it.
//!
//! Where friction leaves a rest, forward motion begins at sin φ = λ₀, at φ₁ = asin λ₀, and ends at the phase p with
//!
//! cos φ₁ − cos p = λ₀ (p − φ₁).
//!
//! What comes next depends on the drive at p. Backward motion follows at once if sin p < −qλ₀. So forward and
//! backward motion cease to touch where qλ₀ = −sin p: that is one smooth curve in the plane of q and λ₀, with p
//! from below 3π/2 to 2π along it. It has two branches as a formula, for the arcsine knows half of the period:
//!
//! - p = π + asin(qλ₀), on the way down to the drive's minimum: the printed curve B, of (54);
//! - p = 2π − asin(qλ₀), on the way up from it: the curve E below, which the paper does not have.
//!
//! They join at p = 3π/2, where qλ₀ = 1: the point Y. Past E the forward motion outlasts the whole stretch in which
//! the drive could have pulled backwards, and rest follows until the next forward motion.

//!
//! *How far it creeps.* Integrate a slip that begins and ends with 𝔴 = 0, has its middle at the phase m and half the
//! length K. Its ends are m ± K, and with the friction λ
//!
//! 𝔴 = cos(m − K) − cos φ − λ (φ − m + K),  so that 𝔴(m + K) = 0 reads  sin m sin K = λK.
//!
//! Its integral is K (cos(m − K) + cos(m + K)) − sin(m + K) + sin(m − K) = −2 cos m (sin K − K cos K), and cos m < 0. A
//! backward slip is a forward one of the friction qλ₀, half a period later. Without rest the two have the half lengths
//! K = πq/(q + 1) and π − K, in both λK/sin K is the same, and their distances and what friction takes on them add up to
//! the closed forms below.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// Curve E: the two sides, equal on the curve, from λ₀ and the product qλ₀. For q ≥ q_Y, 0 < λ₀ ≤ 1/q; λ₀ = 0
/// solves it too and is no part of E.
claim "s24-region-2";
pub fn e_sides<S: Scalar>(lambda0: S, q_lambda0: S) -> [S; 2] {
    let one = S::int(1);
    [
        (one - lambda0.squared()).sqrt() - (one - q_lambda0.squared()).sqrt(),
        lambda0 * (S::int(2) * S::pi() - q_lambda0.asin() - lambda0.asin()),
    ]
}

/// The point Y as (q, λ₀), from the root x of tan x = x between π and 3π/2: x = 3π/2 − asin λ₀.
claim "s24-Y";
pub fn y_from_root<S: Scalar>(x: S) -> [S; 2] {
    let q = (S::int(1) + x.squared()).sqrt();
    [q, S::int(1) / q]
}

/// The touch at Y as a number: C lies above B and E by this times (q − q_Y)², to lowest order.
claim "s24-Y";
pub fn contact<S: Scalar>(q_y: S) -> S {
    let one = S::int(1);
    (q_y - one) / (S::int(2) * q_y.squared() * q_y * (q_y + one))
}

/// Curve A far out: λ₀, up to a relative error of order q⁻⁴.
claim "eq-53";
pub fn a_far<S: Scalar>(q: S) -> S {
    let pi = S::pi();
    let correction = pi.squared() / (S::int(3) * (q + S::int(2)).squared());
    pi / (q + S::int(1)).squared() * (S::int(1) - correction)
}

/// Curve E far out: λ₀, up to a relative error of order q⁻⁴.
claim "s24-region-2";
pub fn e_far<S: Scalar>(q: S) -> S {
    let two_pi = S::int(2) * S::pi();
    let correction = (two_pi / (q + S::int(7) / S::int(3))).squared();
    S::int(2) * two_pi / (q + S::int(1)).squared() * (S::int(1) - correction)
}

/// How far the particle goes in a slip under the friction `lambda0` that takes the phase 2`k` and begins and ends with
/// 𝔴 = 0, in units of A₀/ϖ². For 0 < k < π, λ₀k ≤ sin k.
claim "eq-51";
pub fn slip_distance<S: Scalar>(lambda0: S, k: S) -> S {
    S::int(2) * (k.sin() - k * k.cos()) * (S::int(1) - (lambda0 * k / k.sin()).squared()).sqrt()
}

/// The mean velocity in region I, in units of A₀/ϖ, from (53)'s K.
claim "s24-region-1";
pub fn drift_without_rest<S: Scalar>(lambda0: S, k: S) -> S {
    -k.cos() * (S::int(1) - (lambda0 * k / k.sin()).squared()).sqrt()
}

/// What friction takes in a period in region I, per mass and in units of A₀²/ϖ², from q and (53)'s K.
claim "s24-region-1";
pub fn loss_without_rest<S: Scalar>(q: S, lambda0: S, k: S) -> S {
    S::int(2) * (S::int(1) + q) * lambda0 * k.sin()
        * (S::int(1) - (lambda0 * k / k.sin()).squared()).sqrt()
}

/// The regions as λ₀ grows: below A, then beyond A, beyond B or E, beyond C and beyond D.
claim "fig-5";
pub fn upwards<S: Scalar>() -> [S; 5] {
    [S::int(1), S::int(2), S::int(3), S::int(4), S::int(5)]
}

}

/// Where the curves stand at one q.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curves {
    /// λ₀ on A.
    pub a: f64,
    /// λ₀ on B for q ≤ q_Y, on E for q ≥ q_Y.
    pub b_or_e: f64,
    /// λ₀ on C for q < q_Y, where it bounds something; none beyond.
    pub c: Option<f64>,
    /// λ₀ on D.
    pub d: f64,
}

/// The region, 1 to 5, of λ₀ at that q: the printed list, but above E the motion is that of region IV.
/// None on a curve.
pub fn region(lambda0: f64, curves: &Curves) -> Option<usize> {
    let Curves { a, b_or_e, c, d } = *curves;
    let bounds = [a, b_or_e, c.unwrap_or(b_or_e), d];
    if bounds.contains(&lambda0) {
        return None;
    }
    let beyond = bounds.iter().filter(|&&bound| bound < lambda0).count();
    let listed: f64 = upwards()[beyond];
    // What is no number of a region, as a mistake makes it, names none.
    (1..=5_u8)
        .find(|region| f64::from(*region) == listed)
        .map(usize::from)
}
