//! The surfaces of starts that come to rest close to ρ = 1: hyperbolas around a saddle.

use crate::claims::rest::prelude::*;

/// The lowest order is wanted; one more follows.
const ORDER: i64 = 2;

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["a", "x", "y", "σ", "α"]);
    let [sigma, alpha] = symbols(["σ", "α"]);
    let square = ring.read((1 - sigma).squared() + alpha.squared())?;
    ring.root(&square, 2)?;
    Ok(ring)
}

/// A formula for ∂A/∂σ is that of the surfaces that the motion makes.
pub(crate) fn prove(formula: Expr) -> Proof {
    let title = "The surfaces of constant σ close to ρ = 1";
    Proof::in_ring(title, ring(), |p| {
        rest_on(p, &[&turntable::EQ113, &turntable::EQ114])?;
        let ring = p.ring();
        let scaled = |name| Ok::<_, ExactError>(Series::new(1, vec![ring.named(name)?]));
        let one = Series::constant(Rational::int(1), ORDER);
        let values = [
            ("A", &one.plus(&scaled("a")?)),
            ("α", &scaled("x")?),
            ("ψ", &scaled("y")?),
        ];
        let alpha = symbol("α");
        let mut found = Vec::new();
        for (says, formula, name) in [
            ("dA/dτ by (113)", motion::eq113_a_rate::tree(), "x"),
            ("dα/dτ by (114)", motion::eq114_alpha_rate::tree(), "a"),
        ] {
            let rate = p.expand(says, formula, &values, ("ε", ORDER))?;
            let order = |k| rate.coefficient(k).ok_or(Obstacle::Empty);
            p.zero("It has no term without ε", &order(0)?)?;
            p.equal(
                &format!("At the order ε it is {name}"),
                &order(1)?,
                &ring.named(name)?,
            )?;
            found.push(order(1)?);
        }
        let saddle = ring.along(&[("a", found.remove(0)), ("x", found.remove(0))])?;
        let [a, x, sigma] = symbols(["a", "x", "σ"]);
        let kept = p.read("a² − x²", a.squared() - x.squared())?;
        let rate = p.derivative("Its rate", &kept, &saddle)?;
        p.reads_as(&rate, "", int(0))?;
        p.note(
            "At rest α = 0 and A = σ",
            "so (A − 1)² − α² is (1 − σ)²: A = 1 − √((1 − σ)² + α²)",
        );
        let deficit = 1 - sigma;
        let surface = 1 - (deficit.squared() + alpha.squared()).sqrt();
        p.identity(
            (
                "(A − 1)² − α² with this A",
                (surface - 1).squared() - alpha.squared(),
            ),
            ("", deficit.squared()),
        )?;
        let surface = p.read("A", surface)?;
        let slope = p.slope("∂A/∂σ", &surface, "σ")?;
        p.reads_as(&slope, "the corrected formula", formula)
    })
}

pub(crate) const CORRECTED: Statement = Statement::new(
    Corrected,
    Compared::one(
        r"the corrected $\mathrm dA/\mathrm d\sigma$",
        r"that of the surfaces that (113) and (114) make, to the lowest order in $1-\sigma$ and $\alpha$, with $\psi$ of the order of $\alpha$",
    ),
    corrected::surface_slope::tree,
    prove,
);

attempts![&CORRECTED];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_slope_is_disproved() {
        assert!(CORRECTED.proof().holds(), "{}", CORRECTED.proof());
        let printed = crate::paper::rest::eq146_right::tree();
        let proof = prove(printed);
        assert!(
            matches!(proof.obstacle(), Some(Obstacle::NotZero { .. })),
            "{proof}"
        );
    }
}
