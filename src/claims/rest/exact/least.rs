//! The least A of the boundary between rest and escape, over all ψ: what there is in place of the envelope (147).

use super::boundary;
use crate::claims::rest::prelude::*;

/// The boundary is stated to this power of α.
const ORDER: i64 = 2;

pub(super) fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["α", "y"]);
    ring.angle("ψ");
    // For (147), which has √2.
    ring.root(&Rational::int(2), 2)?;
    Ok(ring)
}

/// A formula for A is the boundary's where ψ = yα.
pub(super) fn where_it_is(p: &mut Prover<'_>, formula: Expr, y: Rational) -> Result<(), Obstacle> {
    let [small, angle] =
        [Rational::int(1), y].map(|value| Series::monomial(value, 1, boundary::ENOUGH));
    let values = [("α", &small), ("ψ", &angle)];
    let there = p.expand("A there", boundary::stated(), &values, ("α", ORDER))?;
    let stated = p.expand("The formula", formula, &[("α", &small)], ("α", ORDER))?;
    for k in 0..=ORDER {
        let [stated, found] =
            [&stated, &there].map(|series| series.coefficient(k).ok_or(Obstacle::Empty));
        p.equal(
            &format!("It agrees with A at the order α^{k}"),
            &stated?,
            &found?,
        )?;
    }
    Ok(())
}

/// A formula for A is the boundary's where ψ is of the order of α, and A is nowhere less.
pub(crate) fn prove(formula: Expr) -> Proof {
    let title = "The least A of the boundary between rest and escape";
    Proof::in_ring(title, ring(), |p| {
        p.rests_on(&boundary::prove(boundary::stated(), ORDER))?;
        p.note(
            "Where ψ is of the order of α",
            "ψ = y α, with any y; on the way to rest y → 2",
        );
        let y = p.ring().named("y")?;
        where_it_is(p, formula, y)?;

        let [alpha, psi] = symbols(["α", "ψ"]);
        let half = psi / 2;
        let (c, s) = (half.cos(), half.sin());
        let ratio = |n, m| int(n) / int(m);
        p.remark("With any ψ let S be sin(ψ/2), C be cos(ψ/2), and G as follows, of the size 25/4 at most");
        let above = p.read("A less the formula", boundary::stated() - formula)?;
        let g = 2 * c.pow(int(3)) - ratio(7, 6) * s * (1 + c.squared()) - s * c.squared()
            + ratio(2, 3) * s.squared() * c
            - ratio(1, 4) * s.pow(int(3));
        p.read("G", g)?;
        let square = alpha * (s + alpha * g / 2).squared();
        let parts = square - alpha.pow(int(3)) * g.squared() / 4;
        p.reads_as(&above, "which is α (S + αG/2)² − α³G²/4", parts)?;
        Ok(())
    })
}

pub(crate) const CORRECTED: Statement = Statement::new(
    Corrected,
    Compared::one(
        r"$1-\alpha+\frac76\alpha^2$",
        r"the least $A$, over all $\psi$, of the power series in $\alpha$ that solves the equations of motion, to the order $\alpha^2$",
    ),
    corrected::boundary_least::tree,
    prove,
);

pub(crate) const PRINTED: Statement = Statement::new(
    Printed,
    Compared::one(
        "(147)",
        r"the power series in $\alpha$ that solves the equations of motion, with $\psi$ of the order of $\alpha$",
    ),
    crate::paper::rest::eq147_a::tree,
    prove,
);

attempts![&PRINTED, &CORRECTED];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_below_the_boundary_by_the_third_order_is_refused() {
        let below = (CORRECTED.formulas)() - symbol("α").pow(int(3));
        assert!(!prove(below).holds());
    }
}
