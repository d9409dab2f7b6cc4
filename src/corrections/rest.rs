//! Section 4, rest: ψ near rest, the motions that come straight in, and the boundary.
//!
//! *σ = 1/2.* (142) is linear in ψ; (143) splits its solution into two terms that both blow up there. With
//! e = (2σ−1)/(1−σ) and C for c + σ/(2σ−1),
//!
//! ψ = 2α [σ/(1−σ) · (1 − α^e)/e + C α^e],
//!
//! where (1 − α^e)/e is −ln α at e = 0.
//!
//! *Straight in.* Near p = 0 the angle has two equilibria, ψ = 0 and ψ = π. The second one repels, but ln p falls faster: on a
//! surface of starts the particle stops before it has turned.
//!
//! ```
//! use slipbook::paper::turntable::{eq107_p_rate, eq109_psi_rate};
//! use std::f64::consts::PI;
//!
//! let (sigma, p, h) = (0.7, 1e-3, 1e-4);
//! let away = (eq109_psi_rate(p, sigma, PI + h) - eq109_psi_rate(p, sigma, PI - h)) / (2.0 * h);
//! assert!((away * p / sigma - 1.0).abs() < 1e-2);
//! assert_eq!(-eq107_p_rate(sigma, PI), 1.0 + sigma);
//! ```
//!
//! With φ = π − ψ small, (114) and (115) are α̇ = −1 − 1/σ, φ̇ = −2(1 − φ/(2α)), and the solution that
//! stays is φ = 2α/(2 + 1/σ).
//!
//! *The surfaces.* (145) is the equation of the motions to rest, once ψ has relaxed. On the way to it, for small α, (114) and
//! (115) give d ln α/dψ = (1/σ − cos ψ)/sin ψ, so that α ∝ t^(1/σ)/sin ψ with t = tan(ψ/2), and by (113)
//! dA/dψ = −α²/sin ψ. With dψ/sin ψ = dt/t and sin ψ = 2t/(1 + t²) this is
//!
//! dA/dt = −(α₀²/4) k² t^(2/σ−3) (1 + t²)²,  k = sin ψ₀ t₀^(−1/σ),
//!
//! a sum of three powers. From t = 0, where A = σ, to the start at t₀ it comes to
//!
//! A = σ − σα² [C⁴/(2(1−σ)) + S²C² + S⁴/(2(1+σ))],  C = cos(ψ/2), S = sin(ψ/2).
//!
//! *The boundary.* (145) needs α ≪ 1 − σ; on the envelope of the surfaces (145) 1 − σ = α/√2. As σ → 1 they close up against the states
//! that tend to A = 1, α = 0, where in the slow motion (ψ ≈ 2α, a = A − 1) α̇ = a, ȧ = α: a saddle, whose incoming
//! line is a = −α, while a = −√((1−σ)² + α²) on the surface of σ. Away from the slow motion let the boundary be A = 1 − α f₁(ψ) + α² f₂(ψ) + …. In the time with
//! dτ = p ds, (113) to (115) read
//!
//! dA/ds = α² + …, dα/ds = α (A cos ψ − 1) + …, dψ/ds = −A sin ψ + 2α + …,
//!
//! and the boundary consists of motions, order by order in α:
//!
//! f₁′ sin ψ = −f₁ (1 − cos ψ),
//! f₂′ sin ψ + 2 f₂ (1 − cos ψ) = −1 + f₁² cos ψ − f₁′ (2 + f₁ sin ψ) = −1 + sin ψ + f₁²,
//!
//! with f₁ = 1 and, from the next order along the incoming line (ψ = 2α + 2α², A = 1 − α + 7α²/6), f₂ = 7/6 at ψ = 0.
//! With C = cos(ψ/2), S = sin(ψ/2),
//!
//! f₁ = C²,  f₂ = (7/6) C⁴ + 2SC³ − S²C² + (2/3) S³C − S⁴/4.
//!
//! *Its lowest points.* f₁ = 1 − S² and f₂ = 7/6 + SG with a bounded G, so that A = 1 − α + 7α²/6 + α (S + αG/2)² − α³G²/4: no
//! less than 1 − α + 7α²/6 but for terms of the order α³, and no more where ψ is of the order of α.

use crate::scalar::Scalar;
use crate::seeded::formulas;

formulas! {

symbols crate::symbols::SYMBOLS;

/// dα/dτ on the way into a stop with ψ → π.
claim "eq-140";
pub fn alpha_rate_straight_in<S: Scalar>(sigma: S) -> S {
    -(S::int(1) + S::int(1) / sigma)
}

/// π − ψ on the way into a stop with ψ → π.
claim "s4-near-rest";
pub fn angle_straight_in<S: Scalar>(sigma: S, alpha: S) -> S {
    S::int(2) * alpha / (S::int(2) + S::int(1) / sigma)
}

/// In place of (143) at σ = 1/2: ψ near rest; `c` is the constant C.
claim "eq-143";
pub fn psi_at_one_half<S: Scalar>(c: S, alpha: S) -> S {
    S::int(2) * alpha * (c - alpha.ln())
}

/// In place of (146): ∂A/∂σ of the surfaces of constant σ, which close up as σ → 1.
claim "eq-146";
pub fn surface_slope<S: Scalar>(sigma: S, alpha: S) -> S {
    let deficit = S::int(1) - sigma;
    deficit / (deficit.squared() + alpha.squared()).sqrt()
}

/// With ψ free in place of (145): the coefficient of −σα² on the surface of starts that come to rest at σ.
claim "s4-psi-free";
pub fn surface_bend<S: Scalar>(sigma: S, psi: S) -> S {
    let (one, two) = (S::int(1), S::int(2));
    let half = psi / two;
    let (c2, s2) = (half.cos().squared(), half.sin().squared());
    c2.squared() / (two * (one - sigma)) + s2 * c2 + s2.squared() / (two * (one + sigma))
}

/// With ψ free in place of (145): A on the surface of starts that come to rest at σ, for α ≪ 1 − σ.
claim "s4-psi-free";
pub fn surface_a<S: Scalar>(sigma: S, alpha: S, psi: S) -> S {
    sigma - sigma * alpha.squared() * surface_bend(sigma, psi)
}

/// f₁: how fast A falls with α on the boundary at α = 0.
claim "s4-envelope-is-boundary";
pub fn boundary_slope<S: Scalar>(psi: S) -> S {
    (psi / S::int(2)).cos().squared()
}

/// f₂: the coefficient of α² on the boundary.
claim "s4-envelope-is-boundary";
pub fn boundary_curvature<S: Scalar>(psi: S) -> S {
    let (c, s) = ((psi / S::int(2)).cos(), (psi / S::int(2)).sin());
    let (c2, s2) = (c.squared(), s.squared());
    let ratio = |n: i64, m: i64| S::int(n) / S::int(m);
    ratio(7, 6) * c2 * c2 + S::int(2) * s * c * c2 - s2 * c2 + ratio(2, 3) * s * s2 * c
        - ratio(1, 4) * s2 * s2
}

/// In place of (147): the least A on the boundary between rest and escape at a given α, to second order in α; the boundary has it
/// where ψ is of the order of α.
claim "eq-147";
pub fn boundary_least<S: Scalar>(alpha: S) -> S {
    S::int(1) - alpha + S::int(7) / S::int(6) * alpha.squared()
}

/// In place of (147): A on the boundary between rest and escape, to second order in α, for every ψ.
claim "s4-envelope-is-boundary";
pub fn boundary_a<S: Scalar>(alpha: S, psi: S) -> S {
    S::int(1) - alpha * boundary_slope(psi) + alpha.squared() * boundary_curvature(psi)
}

}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angle_near_rest_obeys_its_equation_at_one_half() {
        // (σ − 1)/σ · dψ/dα = 2 (1 − ψ/(2α)) at σ = 1/2, the equation before the solution.
        for (c, alpha) in [(0.0, 0.01), (1.3, 0.1), (-0.7, 0.4)] {
            let psi = |alpha: f64| psi_at_one_half(c, alpha);
            let h = 1e-3 * alpha;
            let slope = |h: f64| (psi(alpha + h) - psi(alpha - h)) / (2.0 * h);
            let slope = (4.0 * slope(h) - slope(2.0 * h)) / 3.0;
            let right = 2.0 * (1.0 - psi(alpha) / (2.0 * alpha));
            assert!((-slope - right).abs() < 1e-9, "{c} {alpha}");
            // The constant is what is left at α = 1.
            assert!((psi(1.0) - 2.0 * c).abs() < 1e-14);
        }
    }
}
