//! What the statements on whole ranges take for granted, proved in exact arithmetic.

use super::super::exact::{ring_of_phi_t1, ring_of_phi1};
use crate::claims::sinusoidal::prelude::*;
use crate::exact::folded;

/// By φ₁, here β, the phases are β, π − β and 2π − β, and λ₀ = sin β; and (32)'s left side, of λ₀, φ₁ and φ, has the
/// slope sin φ − λ₀.
pub(super) fn phases(printed: [Expr; 3], left: Expr) -> Proof {
    let [beta, lambda0, phi] = ["β", "λ₀", "φ"].map(symbol);
    Proof::in_ring("the phases by φ₁ = β", ring_of_phi1(), |p| {
        let names = ["φ₁", "φ₂", "φ₄"];
        for ((name, printed), ours) in names.into_iter().zip(printed).zip(by_phi1(beta)) {
            let printed = p.read(name, printed)?;
            let ours = p.ring().read(ours)?;
            p.equal("With λ₀ = sin β it is that", &printed, &ours)?;
        }
        let left = p.read("The left side of (32)", left.with("φ₁", beta))?;
        let slope = p.slope("Its slope by φ", &left, "φ")?;
        let stated = p.ring().read(phi.sin() - lambda0)?;
        p.equal("The slope is sin φ − λ₀", &slope, &stated)
    })
}

/// φ₁, φ₂ and φ₄ by φ₁.
pub(super) fn by_phi1<S: Scalar>(phi1: S) -> [S; 3] {
    [phi1, S::pi() - phi1, S::int(2) * S::pi() - phi1]
}

pub(super) fn turn(printed: Expr) -> Proof {
    Proof::in_ring("(39) by φ̃₁", ring_of_phi_t1(), |p| {
        let printed = p.read("(39) with λ₀ = 2 cos φ̃₁/π", printed)?;
        let ours = p.ring().named("φ̃₁")?;
        p.equal("It is φ̃₁", &printed, &ours)
    })
}

/// A function of b vanishes at b = 0 with its first `order` − 1 derivatives.
pub(super) fn vanishing(f: Expr, order: usize) -> Proof {
    Proof::in_ring("next to the end", Ok(Ring::new()), |p| {
        let last = order as i64;
        let b = Series::monomial(Rational::int(1), 1, last + 1);
        let series = p.expand("In powers of b", f, &[("b", &b)], ("b", last + 1))?;
        for k in 0..last {
            let coefficient = series.coefficient(k).ok_or(Obstacle::Empty)?;
            p.zero(
                &format!("The coefficient of the power {k} is 0"),
                &coefficient,
            )?;
        }
        Ok(())
    })
}

pub(super) fn solution(left: Expr) -> Proof {
    Proof::in_ring("without friction", Ok(Ring::new()), |p| {
        p.vanishes("The left side of (32) at φ₄", folded(left, &|_| None))
    })
}
