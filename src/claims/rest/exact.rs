//! Rest, exactly: where it is possible, (139); the envelope of the truncated surfaces, (146) and (147). The motions to rest
//! and the boundary are power series, in [`series`] and [`boundary`].

pub(crate) mod arrivals;
pub(crate) mod barriers;
pub(crate) mod boundary;
pub(crate) mod chains;
pub(crate) mod least;
pub(crate) mod saddle;
pub(crate) mod series;
pub(crate) mod surfaces;

use super::prelude::*;

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["σ", "α"]);
    ring.angle("ψ");
    ring.root(&Rational::int(2), 2)?;
    Ok(ring)
}

fn prove(title: &str, steps: impl FnOnce(&mut Prover<'_>) -> Result<(), Obstacle>) -> Proof {
    Proof::in_ring(title, ring(), steps)
}

/// (139): no push starts a motion, dp/dτ ≤ 0 in every direction ψ, exactly where σ is not above the bound.
pub(crate) fn eq139(bound: Expr) -> Proof {
    prove("(139): where a push starts no motion", |p| {
        rest_on(p, &[&turntable::EQ107])?;
        let [sigma, psi] = symbols(["σ", "ψ"]);
        let excess = sigma - bound;
        let less = 2 * sigma * (psi / 2).sin().squared();
        p.identity(
            ("dp/dτ by (107) at ρ = σ", motion::eq107_p_rate(sigma, psi)),
            ("σ less the bound, less what is not negative", excess - less),
        )?;
        Ok(())
    })
}

pub(crate) fn eq146(formula: Expr) -> Proof {
    prove("(146) is the derivative of (145) by σ", |p| {
        let a = p.read("(145)", printed::eq145_a::tree())?;
        let slope = p.slope("∂A/∂σ", &a, "σ")?;
        p.reads_as(&slope, "the right side of (146)", formula)
    })
}

pub(crate) fn eq147(formula: Expr) -> Proof {
    prove("(147) is (145) with (146) put in", |p| {
        let alpha = symbol("α");
        let solved = 1 - alpha / int(2).sqrt();
        p.note("(146) solved for σ < 1", "σ = 1 − α/√2");
        let right = printed::eq146_right::tree().with("σ", solved);
        let right = p.read("(146) there", right)?;
        p.zero("It holds", &right)?;
        p.identity(
            ("(145) there", printed::eq145_a::tree().with("σ", solved)),
            ("by (147)", formula),
        )
    })
}

pub(crate) const EQ139: Statement = Statement::new(
    Printed,
    Compared::one(
        "(107) at rest",
        r"the difference of $\sigma$ and the bound, less $2\sigma\sin^2(\psi/2)$",
    ),
    printed::eq139_largest_sigma,
    eq139,
);

#[cfg(test)]
mod tests;

attempts![
    &EQ139,
    &EQ146 = Statement::new(
        Step,
        Compared::one(
            "(146)",
            "the derivative of (145), the terms left out being dropped",
        ),
        printed::eq146_right::tree,
        eq146,
    ),
    &EQ147 = Statement::new(
        Step,
        Compared::one(
            "(147)",
            "(145) where (146) holds, the terms left out being dropped",
        ),
        printed::eq147_a::tree,
        eq147,
    )
];
