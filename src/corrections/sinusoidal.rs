//! Section 2.2: how the velocity across the drive really dies, and how fast the periodic motion is approached.
//!
//! Where 𝔴 passes through zero, the drive has a size s, and over the short passage it is constant. There (10) says that
//! 𝔴_y (tan θ/2)^(−λ₀/s) keeps its value, θ being the velocity's angle with the drive. The particle arrives against the
//! drive, tan(θ/2) ≈ 2|𝔴|/𝔴_y, and leaves along it, tan(θ/2) ≈ 𝔴_y/(2|𝔴|). Take logarithms far from the passage, where
//! |𝔴| is of order one and |ln 𝔴_y| is large:
//!
//! ln 𝔴_y after the passage = (s + λ₀)/(s − λ₀) · ln 𝔴_y before it, up to terms that stay bounded.
//!
//! A motion without rest passes through zero twice in a period, with s = sin φ̃₁, and in between ln 𝔴_y changes by a
//! bounded amount. So |ln 𝔴_y| grows geometrically, and 𝔴_y falls as the exponential of an exponential.
//!
//! Along the line, a motion that is δ𝔴 ahead meets zero δ𝔴/(s + λ₀) later and leaves with the slope s − λ₀: the distance
//! is multiplied by (s − λ₀)/(s + λ₀), the inverse of the same factor.
//!
//! During a rest of 𝔴 the drive h stays below λ₀, and hardly changes in the short time that a small 𝔴_y lasts. So what is
//! left is a motion under strong friction, λ = λ₀/h > 1, from θ = π/2 on: it turns into the line of the drive and, by (20),
//! stops after λ₀ 𝔴_y/(λ₀² − h²).

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// s = sin φ̃₁: the size of the drive where the periodic motion without rest passes through zero. Dimensionless; real
/// for λ₀ ≤ 2/π, and above λ₀ for λ₀ < λ_c.
claim "s22-vy-two-stages";
pub fn drive_at_zero<S: Scalar>(lambda0: S) -> S {
    (S::int(1) - (S::pi() * lambda0 / S::int(2)).squared()).sqrt()
}

/// By what factor ln 𝔴_y grows where 𝔴 passes through zero while the drive has the size `s` > λ₀. Dimensionless.
claim "s22-vy-two-stages";
pub fn passage_factor<S: Scalar>(lambda0: S, s: S) -> S {
    (s + lambda0) / (s - lambda0)
}

/// By what factor a small distance to the periodic motion (38) shrinks in a period, 0 ≤ λ₀ ≤ λ_c. Dimensionless.
claim "s22-vy-two-stages";
pub fn contraction<S: Scalar>(lambda0: S) -> S {
    (S::int(1) / passage_factor(lambda0, drive_at_zero(lambda0))).squared()
}

/// How much more slowly than λ₀ a large velocity `w_y` across the drive falls, relative to λ₀ and times `w_y`², on the
/// mean over a period that begins at φ = 0 with the velocity `w` along the drive: friction leans towards the drive by
/// the ratio of the velocities, along which the motion is nearly free, 𝔴 + 1 − cos φ. Dimensionless.
claim "s22-vy-two-stages";
pub fn first_stage_lean<S: Scalar>(w: S) -> S {
    let half = S::int(1) / S::int(2);
    -half * ((w + S::int(1)).squared() + half)
}

/// For how long (in φ) a small velocity `w_y` straight across a drive of the size `s` < λ₀ lasts until the particle
/// stops, to leading order in `w_y`.
claim "s22-vy-two-stages";
pub fn last_stage<S: Scalar>(lambda0: S, s: S, w_y: S) -> S {
    lambda0 * w_y / (lambda0.squared() - s.squared())
}

/// Where the period ends that begins with the slip at φ₁, in radians.
claim "s22-rest-of-period";
pub fn rest_of_period_end<S: Scalar>(phi1: S) -> S {
    phi1 + S::int(2) * S::pi()
}

}
