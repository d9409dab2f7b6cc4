//! Section 2.3: what the paper leaves out. The motion of the pulse train below λ_c, and where a threshold
//! must lie for any drive.
//!
//! # Small friction, 0 < λ₀ < η
//! The friction never holds the particle: w is positive for half a period from some φ₀ on, then, by the
//! symmetry (43), the same with the other sign. From 0 at φ₀, w rises at the rate 1 − λ₀ until the pulse
//! ends at ηπ, falls at the rate λ₀ in the gap until π, and at the rate 1 + λ₀ under the next pulse, until
//! it is 0 again at π + φ₀:
//!
//! (1 − λ₀)(ηπ − φ₀) − λ₀(π − ηπ) − (1 + λ₀) φ₀ = 0, so φ₀ = π(η − λ₀)/2.
//!
//! It begins under a pulse, as it must, exactly if 0 ≤ φ₀ < ηπ: for λ₀ ≤ η.
//!
//! # Any drive
//! Let ⟨|h|⟩ be the mean of |h| over a period, and |m| < λ₀ < 1, m being the mean of h.
//!
//! - *λ₀ > ⟨|h|⟩: there is rest.* Over a period w returns. Were there no rest, then, with P and N the sets
//!   where w > 0 and w < 0, ∫_P h = λ₀|P| and −∫_N h = λ₀|N|; the sum is 2πλ₀ = ∫_P h − ∫_N h ≤ ∫|h|.
//! - *m = 0 and |h| > λ₀ wherever |H − c| ≤ πλ₀: there is no rest.* H is an antiderivative of h and c its
//!   median: H > c for half of each period. The friction's own integral oscillates by at most πλ₀, so w
//!   differs from H − c′ by at most πλ₀/2 for some c′. If c′ were above c + πλ₀/2, w would be negative for more
//!   than half of the time, and friction would win; likewise below. So |H − c| ≤ πλ₀ at every zero of w,
//!   where h then overcomes the friction.
//!
//! The pulses attain the first bound: ⟨|h|⟩ = η = λ_c.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// φ₀: the phase (radians) at which w of the pulse train becomes positive, for 0 < λ₀ ≤ η.
claim "eq-46";
pub fn small_friction_start<S: Scalar>(lambda: S, eta: S) -> S {
    S::pi() * (eta - lambda) / S::int(2)
}

/// w(φ) of the pulse train for 0 < λ₀ ≤ η, in the three cases of the half period φ₀ < φ < φ₀ + π.
claim "eq-46";
pub fn small_friction_cases<S: Scalar>(lambda: S, eta: S, phi: S) -> [S; 3] {
    let (one, pi) = (S::int(1), S::pi());
    let top = (one - lambda) * (eta * pi - small_friction_start(lambda, eta));
    let left = top - lambda * (pi - eta * pi);
    [
        (one - lambda) * (phi - small_friction_start(lambda, eta)),
        top - lambda * (phi - eta * pi),
        left - (one + lambda) * (phi - pi),
    ]
}

/// The phases (radians) where the first and the second case end; the third ends at φ₀ + π.
claim "eq-46";
pub fn small_friction_ends<S: Scalar>(eta: S) -> [S; 2] {
    [eta * S::pi(), S::pi()]
}

/// What friction takes from the pulse train's motion in a period with rests, η ≤ λ₀ ≤ 1: per mass, dimensionless.
claim "eq-44";
pub fn loss_with_rests<S: Scalar>(lambda: S, eta: S) -> S {
    (S::int(1) - lambda) * (eta * S::pi()).squared()
}

/// The same without rests, 0 < λ₀ ≤ η.
claim "eq-46";
pub fn loss_without_rest<S: Scalar>(lambda: S, eta: S) -> S {
    let half = S::pi().squared() / S::int(2);
    half * lambda * (S::int(2) * eta - eta.squared() - lambda.squared())
}

/// What becomes nonzero again when the next pulse begins: the drive.
claim "s23-nonzero-again";
pub fn nonzero_again<S: Scalar>(h: S) -> S {
    h
}

}

/// Which case holds at φ, counted from 0; between two cases, the later one.
pub fn small_friction_case(eta: f64, phi: f64) -> usize {
    let ends = small_friction_ends(eta);
    ends.iter().filter(|end| phi >= **end).count()
}
