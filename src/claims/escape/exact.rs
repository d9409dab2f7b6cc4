//! The laws of escape, exactly: against the motion's own series at large times, which Newton's law gives.

pub(crate) mod asymptotic_series;
pub(crate) mod chains;
pub(crate) mod spiral;

use super::prelude::*;
use crate::exact::{Binary, Node};
use asymptotic_series::{Late, agree, from_series, law_series, rate};

fn tau() -> Expr {
    symbol("τ")
}

/// A law with its first correction, as it holds in the time τ − (3√2/4) ln τ: `power` is twice the power of τ in it.
fn delayed(law: Expr, power: i64) -> Expr {
    let delay = corrected::delay::<Expr>() * symbol("L") / tau();
    law * (1 - int(power) / 2 * delay)
}

/// exp(`n` α) for a law α; for α = (ln x)/m without the logarithm, which no series in τ has.
fn exponential(law: Expr, n: i64) -> Expr {
    if let Node::Binary(Binary::Div, above, below) = law.node()
        && let Node::Call(Function::Ln, x) = above.node()
    {
        return x.pow(int(n) / below);
    }
    (int(n) * law).exp()
}

#[track_caller]
const fn as_series(formula: fn() -> Expr, prove: fn(Expr) -> Proof) -> Statement {
    let compared = Compared::one(
        "the corrected law",
        r"the series in $1/\tau$ and $\ln\tau$ that solves (107) to (109), of which it has the first terms",
    );
    Statement::new(Corrected, compared, formula, prove)
}

pub(crate) const EQ128: Statement = as_series(corrected::alpha_rate::tree, eq128);
pub(crate) const EQ129: Statement =
    as_series(|| corrected::product_over_a::<Expr>() * symbol("A"), eq129);
pub(crate) const EQ130: Statement = as_series(corrected::alpha_by_a::tree, eq130);
pub(crate) const EQ131: Statement = as_series(corrected::a_rate::tree, eq131);
pub(crate) const EQ132: Statement = as_series(
    || delayed(corrected::a(tau()), 3),
    |law| in_time(law, "A", true, |late| &late.a),
);
pub(crate) const EQ133: Statement = as_series(
    || corrected::alpha(tau()),
    |law| {
        in_time(exponential(law, 2), "e^(2α)", false, |late| {
            &late.twice_alpha_exp
        })
    },
);
pub(crate) const EQ134: Statement = as_series(
    || delayed(corrected::lag(tau()), -2),
    |law| in_time(law, "π/2 − ψ", true, |late| &late.lag),
);
pub(crate) const EQ135: Statement = as_series(
    || delayed(corrected::rho(tau()), 4),
    |law| in_time(law, "p", true, |late| &late.p),
);
pub(crate) const EQ136: Statement = as_series(
    || delayed(corrected::rho(tau()), 4),
    |law| in_time(law, "ρ", true, |late| &late.rho),
);
pub(crate) const EQ137: Statement = as_series(
    || delayed(corrected::s(tau()), 6),
    |law| in_time(law, "s", true, |late| &late.s),
);

/// With or without the term in (ln τ)/τ.
fn in_time(law: Expr, name: &str, logarithm: bool, quantity: fn(&Late) -> &Series) -> Proof {
    from_series(&format!("{name} at large times"), |p, late| {
        let law = law_series(p, law)?;
        agree(p, &law, quantity(late), logarithm)
    })
}

fn by_state(
    title: &str,
    law: Expr,
    quantity: impl FnOnce(&mut Prover<'_>, &Late) -> Result<Series, Obstacle>,
) -> Proof {
    from_series(title, |p, late| {
        let values = [("A", &late.a), ("exp α", &late.alpha_exp)];
        p.note("A, with z = τ^(−1/2)", late.a.text("z", p.ring()));
        p.note("e^α", late.alpha_exp.text("z", p.ring()));
        let law = p.expand("The law", law, &values, ("z", 2))?;
        let quantity = quantity(p, late)?;
        agree(p, &law, &quantity, false)
    })
}

fn eq128(law: Expr) -> Proof {
    by_state("dα/dτ at large times", law, |p, late| {
        let ring = p.ring();
        let twice = late.twice_alpha_exp.map(|c| Ok::<_, ExactError>(c + c))?;
        Ok(rate(&late.twice_alpha_exp, 2, ring)?.over(&twice, ring)?)
    })
}

fn eq129(law: Expr) -> Proof {
    by_state("cosh α cosh 2α at large times", law, |p, late| {
        let product = printed::eq129_a::tree();
        p.expand(
            "The product",
            product,
            &[("exp α", &late.alpha_exp)],
            ("z", 2),
        )
    })
}

fn eq130(law: Expr) -> Proof {
    by_state("e^(3α) at large A", exponential(law, 3), |p, late| {
        Ok(late.alpha_exp.power(&Rational::int(3), p.ring())?)
    })
}

fn eq131(law: Expr) -> Proof {
    by_state("dA/dτ at large A", law, |p, late| {
        Ok(rate(&late.a, 2, p.ring())?)
    })
}

pub(crate) fn eq126(formula: Expr) -> Proof {
    let ring = Ring::of(["A", "α", "ψ"]);
    Proof::of("(126): dα/dτ near α = 0", &ring, |p| {
        rest_on(p, &[&turntable::EQ114, &turntable::EQ124])?;
        let small = Series::monomial(Rational::int(1), 1, 6);
        let values = [("α", &small)];
        let angle = p.expand("ψ₁ by (124)", motion::eq124_psi1::tree(), &values, ("α", 4))?;
        let values = [("α", &small), ("ψ", &angle)];
        let rate = motion::eq114_alpha_rate::tree();
        let rate = p.expand("(114) there", rate, &values, ("α", 4))?;
        let stated = p.read("(126)", formula)?;
        let first = rate.coefficient(0).ok_or(Obstacle::Empty)?;
        p.equal("It is the first term", &first, &stated)
    })
}

/// (138): A²/2 and s have the same rate, whatever the motion; so the check cannot fail.
pub(crate) fn eq138(formula: Expr) -> Proof {
    let mut ring = Ring::new();
    ring.symbol("A");
    ring.hyperbolic("α");
    Proof::of("d(A²/2)/dτ = ds/dτ, whatever A and α are", &ring, |p| {
        rest_on(p, &[&turntable::EQ113])?;
        let [a, alpha] = symbols(["A", "α"]);
        let half = p.read("(138)", formula)?;
        let rate = p.read("dA/dτ by (113)", motion::eq113_a_rate::tree())?;
        let motion = p.ring().along(&[("A", rate)])?;
        let growth = p.derivative("The rate of (138)", &half, &motion)?;
        p.reads_as(&growth, "ds/dτ = p = A sinh α", a * alpha.sinh())
    })
}

/// A never decreases: its rate is a product of factors that are not negative; and α cannot fall faster back in time than the
/// time itself, so that A grows by a fixed amount whenever α comes to a given value.
fn never_decreases(formula: Expr) -> Proof {
    let mut ring = Ring::new();
    ring.symbol("A");
    ring.angle("ψ");
    ring.hyperbolic("α");
    ring.hyperbolic("s");
    Proof::of("A never decreases", &ring, |p| {
        rest_on(p, &[&turntable::EQ113, &turntable::EQ114])?;
        let [a, alpha, psi, s] = symbols(["A", "α", "ψ", "s"]);
        let half = (alpha / 2).exp();
        let factors = (half - 1) * (half + 1) * (half.squared() + 1);
        p.identity(
            ("dA/dτ by (113)", formula),
            (
                "with h = exp(α/2) ≥ 1, of which no factor is negative",
                factors / (2 * half.squared()),
            ),
        )?;
        let slow = 1 - motion::eq114_alpha_rate::tree();
        let terms = 2 * (psi / 2).sin().squared() + alpha.cosh() / a;
        p.identity(
            ("1 − dα/dτ by (114)", slow),
            ("of which no term is negative", terms),
        )?;
        p.note(
            "Let α be b at some time",
            "at the time s before, α was at least b − s, and the rate of A at least sinh(b − s)",
        );
        let grown = p.read("cosh s − 1, which is 0 at s = 0", s.cosh() - 1)?;
        let slope = p.slope("Its rate", &grown, "s")?;
        p.reads_as(&slope, "", s.sinh())?;
        Ok(())
    })
}

attempts![
    &EQ126 = Statement::new(
        Printed,
        Compared::one("(126)", r"the first term in $\alpha$ of (114) at $\psi_1$"),
        printed::eq126_alpha_rate::tree,
        eq126,
    ),
    &EQ128,
    &EQ129,
    &EQ130,
    &EQ131,
    &EQ132,
    &EQ133,
    &EQ134,
    &EQ135,
    &EQ136,
    &EQ137,
    &EQ138 = Statement::new(
        Printed,
        Compared::one(
            r"$\mathrm d(A^2/2)/\mathrm d\tau$",
            r"$\mathrm ds/\mathrm d\tau$, for any $A$ and $\alpha$",
        ),
        printed::eq138_s::tree,
        eq138,
    ),
    &NEVER_DECREASES = Statement::shown(
        Printed,
        r"by (113) $\dot A=\sinh\alpha\ge0$; by (114) $\dot\alpha<1$, so that $A$ grows by $\cosh b-1$ or more each time that $\alpha$ comes to a $b>0$",
        motion::eq113_a_rate::tree,
        never_decreases
    )
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_laws_are_disproved() {
        let a = symbol("A");
        // The ring has not the roots of 3 and 4 that (131), (132) and (134) need.
        for (statements, printed) in [
            ([EQ128, spiral::EQ128], printed::eq128_alpha_rate::tree()),
            ([EQ129, spiral::EQ129], a),
            ([EQ130, spiral::EQ130], printed::eq130_alpha::tree()),
            ([EQ133, spiral::EQ133], printed::eq133_alpha::tree()),
            ([EQ135, spiral::EQ135], printed::eq135_p::tree()),
            ([EQ136, spiral::EQ136], printed::eq136_rho::tree()),
            ([EQ137, spiral::EQ137], printed::eq137_s::tree()),
        ] {
            for statement in statements {
                let proof = (statement.prove)(printed);
                assert!(
                    matches!(proof.obstacle(), Some(Obstacle::NotZero { .. })),
                    "{proof}"
                );
            }
        }
    }

    #[test]
    fn exponentials_of_logarithms_are_powers() {
        let [x, y] = symbols(["x", "y"]);
        assert_eq!(exponential(x, 3).to_string(), "exp(3 x)");
        let value = |formula: Expr| {
            let number = |name: &str| (name == "x").then_some(1.7);
            formula.evaluate(&number).unwrap()
        };
        // exp(6 ln(x)/3) = x².
        let power = exponential(x.ln() / 3, 6);
        assert!((value(power) - 1.7 * 1.7).abs() < 1e-14, "{power}");
        // Not a logarithm above the line.
        assert_eq!(
            exponential(x / y, 2).to_string(),
            (2 * (x / y)).exp().to_string()
        );
    }
}
