//! What is algebra in (143), (145) to (147), and the second order of the boundary, exactly.

pub mod boundary;
pub mod near;

use crate::claims::compare::proved;
use crate::corrections::rest as corrected;
use crate::evidence::{Evidence, Subject};
use crate::exact::{ExactError, Expr, Obstacle, Proof, Prover, Rational, Ring};
use crate::paper::rest as printed;
use crate::scalar::Scalar;

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    let sigma = ring.symbol("σ");
    let alpha = ring.symbol("α");
    for name in ["A", "c"] {
        ring.symbol(name);
    }
    ring.angle("ψ");
    ring.root(&Rational::int(2), 2)?;
    let one = Rational::int(1);
    let exponent = ring.divide(&(&sigma + &sigma - &one), &(&one - &sigma))?;
    ring.power(&alpha, &exponent)?;
    Ok(ring)
}

fn prove(title: &str, steps: impl FnOnce(&mut Prover<'_>) -> Result<(), Obstacle>) -> Proof {
    match ring() {
        Ok(ring) => Proof::of(title, &ring, steps),
        Err(error) => Proof::impossible(title, error),
    }
}

fn symbols() -> [Expr; 4] {
    ["σ", "α", "c", "ψ"].map(Expr::symbol)
}

/// (143) solves (142), for every c.
pub fn eq143(formula: Expr) -> Proof {
    prove("(143) solves (142)", |p| {
        let [sigma, alpha, ..] = symbols();
        let psi = p.read("(143)", formula)?;
        let slope = p.derivative("dψ/dα", &psi, &p.ring().by("α")?)?;
        let factor = p.ring().read(printed::eq142_left(sigma, Expr::int(1)))?;
        let free = p.ring().read(Expr::int(2) * alpha)?;
        let ratio = p.quotient("ψ/(2α)", &psi, &free)?;
        let right = (Rational::int(1) - ratio) * Rational::int(2);
        p.equal("The two sides of (142)", &(factor * slope), &right)
    })
}

/// (145) solves (144) and is σ at α = 0.
pub fn eq145(formula: Expr) -> Proof {
    prove("(145) solves (144)", |p| {
        let [sigma, alpha, ..] = symbols();
        let a = p.read("(145)", formula)?;
        let slope = p.derivative("dA/dα", &a, &p.ring().by("α")?)?;
        let factor = p.ring().read(printed::eq144_left(sigma, Expr::int(1)))?;
        let right = p.read("Right side of (144)", printed::eq144_right(alpha))?;
        p.equal("The two sides of (144)", &(factor * slope), &right)?;
        let start = p.read("At α = 0", formula.with("α", Expr::int(0)))?;
        p.equal("Against σ", &start, &p.ring().read(sigma)?)
    })
}

/// (146) is the derivative of (145) with respect to σ.
pub fn eq146(formula: Expr) -> Proof {
    prove("(146) is the derivative of (145) by σ", |p| {
        let [sigma, alpha, ..] = symbols();
        let a = p.read("(145)", printed::eq145_a(sigma, alpha))?;
        let slope = p.derivative("∂A/∂σ", &a, &p.ring().by("σ")?)?;
        let right = p.read("Right side of (146)", formula)?;
        p.equal("The two", &slope, &right)
    })
}

/// (147) is (145) where (146) holds, with σ < 1.
pub fn eq147(formula: Expr) -> Proof {
    prove("(147) is (145) with (146) put in", |p| {
        let [sigma, alpha, ..] = symbols();
        let solved = Expr::int(1) - alpha / Expr::int(2).sqrt();
        p.note("(146) solved for σ < 1", "σ = 1 − α/√2");
        let right = printed::eq146_right(sigma, alpha).with("σ", solved);
        let right = p.read("(146) there", right)?;
        p.zero("It holds", &right)?;
        let a = p.read(
            "(145) there",
            printed::eq145_a(sigma, alpha).with("σ", solved),
        )?;
        let envelope = p.read("(147)", formula)?;
        p.equal("The two", &a, &envelope)
    })
}

/// The boundary's second order: A = 1 − α f₁ + α² f₂ consists of motions up to α².
pub fn boundary() -> Proof {
    prove(
        "the boundary consists of motions, to second order in α",
        |p| {
            let psi = Expr::symbol("ψ");
            let by_psi = p.ring().by("ψ")?;
            let one = Rational::int(1);
            let f1 = p.read("f₁", corrected::boundary_slope(psi))?;
            let f2 = p.read("f₂", corrected::boundary_curvature(psi))?;
            let (slope1, slope2) = (
                p.derivative("f₁′", &f1, &by_psi)?,
                p.derivative("f₂′", &f2, &by_psi)?,
            );
            let (cos, sin) = (p.ring().read(psi.cos())?, p.ring().read(psi.sin())?);
            p.note(
                "(113) to (115), dτ = p ds",
                "A′ = α² + …, α′ = α(A cos ψ − 1) + …, ψ′ = −A sin ψ + 2α + …",
            );
            // A = 1 − α f₁ + α² f₂ along the motion: the coefficients of α and of α².
            let first = &slope1 * &sin - &f1 * (&cos - &one);
            p.zero("Order α", &first)?;
            let two = Rational::int(2);
            let alpha_rate = &f1 * &f1 * &cos + &two * &f2 * (&cos - &one);
            let psi_rate = &slope1 * (&two + &f1 * &sin) + &slope2 * &sin;
            p.equal("Order α²", &(alpha_rate - psi_rate), &one)?;
            let corner = |x: Expr| x.with("ψ", Expr::int(0));
            let at_zero = p.read("f₁ at ψ = 0", corner(corrected::boundary_slope(psi)))?;
            p.equal("as on the saddle's incoming line", &at_zero, &one)?;
            let at_zero = p.read("f₂ at ψ = 0", corner(corrected::boundary_curvature(psi)))?;
            let expected = p.ring().read(Expr::int(7) / Expr::int(6))?;
            p.equal("as on the saddle's incoming line", &at_zero, &expected)
        },
    )
}

/// The evidence of a proof of a printed formula.
pub fn evidence(id: &str) -> Evidence {
    let [sigma, alpha, c, _] = symbols();
    let (proof, compared) = match id {
        "eq-143" => (
            eq143(printed::eq143_psi(sigma, c, alpha)),
            "(143) put into (142)",
        ),
        "eq-145" => (
            eq145(printed::eq145_a(sigma, alpha)),
            "(145) put into (144)",
        ),
        "eq-146" => (
            eq146(printed::eq146_right(sigma, alpha)),
            "(146) with the derivative of (145), the terms left out being dropped",
        ),
        "eq-147" => (
            eq147(printed::eq147_a(alpha)),
            "(147) with (145) where (146) holds, the terms left out being dropped",
        ),
        _ => (
            Proof::impossible(
                id,
                ExactError::UnknownSymbol {
                    name: id.to_owned(),
                },
            ),
            "",
        ),
    };
    proved(&proof, Subject::Within, compared)
}

/// The evidence of the boundary's proof.
pub fn boundary_evidence() -> Evidence {
    let compared = "1 − α f₁(ψ) + α² f₂(ψ) with the equations of motion, order by order in α";
    proved(&boundary(), Subject::Corrected, compared)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::mutations;

    #[test]
    fn all_are_proved_and_no_changed_formula_is() {
        let [sigma, alpha, c, _] = symbols();
        // In (143) another sign of the free constant c, or another name for it, says the same.
        type Statement = (Expr, fn(Expr) -> Proof, usize);
        let statements: [Statement; 4] = [
            (printed::eq143_psi(sigma, c, alpha), eq143, 2),
            (printed::eq145_a(sigma, alpha), eq145, 0),
            (printed::eq146_right(sigma, alpha), eq146, 0),
            (printed::eq147_a(alpha), eq147, 0),
        ];
        for (formula, prove, same) in statements {
            let proof = prove(formula);
            assert!(proof.holds(), "{proof}");
            let still: Vec<_> = mutations(formula)
                .into_iter()
                .filter(|m| prove(m.formula).holds())
                .map(|m| m.change)
                .collect();
            assert_eq!(still.len(), same, "{still:?}");
        }
        assert!(boundary().holds(), "{}", boundary());
    }
}
