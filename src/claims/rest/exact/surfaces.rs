//! The surfaces of starts that come to rest at one distance σ: A = σ + α² F(ψ) + ….
//!
//! At the lowest order the equation for F has the solutions F + k sin²ψ tan(ψ/2)^(−2/σ), of which one alone, k = 0, stays
//! finite at ψ = 0, where the motions to rest arrive.

use super::boundary::{ENOUGH, imbalance};
use crate::claims::rest::prelude::*;

/// The power of α to which the surface is stated.
const ORDER: i64 = 2;

pub(super) fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    ring.angle("ψ");
    ring.symbols(["σ", "α"]);
    Ok(ring)
}

/// A formula for A consists of motions, and is (145) at ψ = 0.
pub(crate) fn prove(formula: Expr) -> Proof {
    let title = "The surface of starts that come to rest at σ";
    Proof::in_ring(title, ring(), |p| {
        rest_on(
            p,
            &[&turntable::EQ113, &turntable::EQ114, &turntable::EQ115],
        )?;
        let ring = p.ring();
        let small = Series::monomial(Rational::int(1), 1, ENOUGH);
        let a = p.expand("The formula", formula, &[("α", &small)], ("α", ORDER))?;
        let order = |series: &Series, k| series.coefficient(k).ok_or(Obstacle::Empty);
        p.equal("At α = 0 it is σ", &order(&a, 0)?, &ring.named("σ")?)?;
        p.zero("It has no term of the order α", &order(&a, 1)?)?;
        let left = imbalance(ring, &a)?;
        p.zero(
            "dA/dτ less ∂A/∂α dα/dτ and ∂A/∂ψ dψ/dτ, by (113) to (115), is 0 at the order α",
            &order(&left, 1)?,
        )?;
        let level = ring.half_tangent("ψ")?;
        let ahead = ring.put(&order(&a, 2)?, &[(&level, &Rational::int(0))])?;
        let known = p.expand(
            "(145)",
            printed::eq145_a::tree(),
            &[("α", &small)],
            ("α", ORDER),
        )?;
        p.equal(
            "Its coefficient of α² at ψ = 0 is that of (145)",
            &ahead,
            &order(&known, 2)?,
        )?;
        Ok(())
    })
}

pub(crate) const CORRECTED: Statement = Statement::new(
    Corrected,
    Compared::one(
        r"the corrected $A(\sigma,\alpha,\psi)$",
        r"the equations of motion at the order $\alpha$, with (145) at $\psi=0$",
    ),
    corrected::surface_a::tree,
    prove,
);

attempts![&CORRECTED];
