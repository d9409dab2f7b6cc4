//! The boundary between rest and escape, in powers of α: A = 1 + α F₁(ψ) + α² F₂(ψ) + …, found order by order.
//!
//! With t = tan(ψ/2), Fₖ = (aₖ + x₁ t + … + x₂ₖ t²ᵏ)/(1 + t²)ᵏ. The equation of the order k gives the xₙ of Fₖ, and the
//! constant aₖ₋₁ of the order before, as the condition that it can be solved at ψ = 0.

use crate::claims::rest::prelude::*;

/// The boundary is stated to the second order; two more follow.
const ORDER: i64 = 4;

pub(super) const ENOUGH: i64 = ORDER + 3;

/// The coefficients of t, t², … at one order.
const UNKNOWN: [&str; 10] = ["x₁", "x₂", "x₃", "x₄", "x₅", "x₆", "x₇", "x₈", "x₉", "x₁₀"];

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    ring.angle("ψ");
    for name in ["a", "a′"].iter().chain(&UNKNOWN) {
        ring.symbol(name);
    }
    // For (147), which has √2.
    ring.root(&Rational::int(2), 2)?;
    Ok(ring)
}

/// What the boundary lacks to consist of motions: dA/dτ less ∂A/∂α dα/dτ and ∂A/∂ψ dψ/dτ.
pub(super) fn imbalance(ring: &Ring, a: &Series) -> Result<Series, ExactError> {
    let small = Series::monomial(Rational::int(1), 1, ENOUGH);
    let values = [("A", a), ("α", &small)];
    let expand = |formula| ring.expand(formula, &values, ENOUGH);
    let by_psi = ring.by("ψ")?;
    let by_alpha = a.euler(&Derivation::default(), ring)?.shifted(-1);
    let turned = a.map(|c| ring.derivative(c, &by_psi))?;
    let along = expand(motion::eq114_alpha_rate::tree())?;
    let turning = expand(motion::eq115_psi_rate::tree())?;
    let moved = by_alpha
        .times(&along, ring)
        .plus(&turned.times(&turning, ring));
    Ok(expand(motion::eq113_a_rate::tree())?.minus(&moved))
}

fn solve(p: &mut Prover<'_>) -> Result<Series, Obstacle> {
    p.shows("A surface A = 1 + α F₁ + α² F₂ + α³ F₃ + α^4 F₄, with F₁ = −cos²(ψ/2) and functions F₂, F₃ and F₄ of ψ, consists of motions by (113) to (115), up to terms of the order α^4.");
    rest_on(
        p,
        &[&turntable::EQ113, &turntable::EQ114, &turntable::EQ115],
    )?;
    let ring = p.ring();
    p.note(
        "To be found",
        "A = 1 + α F₁ + α² F₂ + … with Fₖ = (a + x₁ t + … + x₂ₖ t²ᵏ)/(1 + t²)ᵏ, t = tan(ψ/2); the xₙ and a differ from order to order, and a′ is a of the order before",
    );
    p.note(
        "Solved, order by order, is the condition that the surface consists of motions",
        "dA/dτ = ∂A/∂α dα/dτ + ∂A/∂ψ dψ/dτ, with the rates by (113) to (115)",
    );
    let t = ring.half_tangent("ψ")?;
    let one_over = ring.divide(&Rational::int(1), &(Rational::int(1) + &t * &t))?;
    let [free, before] = [ring.named("a")?, ring.named("a′")?];
    let mut found = vec![Rational::int(1)];
    // Of the two constants of F₁ that the equations allow.
    let way_in = Rational::int(-1);
    // One order more than is kept: it gives the last constant.
    for k in 1..=ORDER + 1 {
        let unknown = &UNKNOWN[..(2 * k) as usize];
        let (mut ansatz, mut power) = (free.clone(), Rational::int(1));
        for name in unknown {
            power = power * &t;
            ansatz = ansatz + ring.named(name)? * &power;
        }
        let ansatz = ansatz * one_over.pow(k as u32);
        let next = found.iter().cloned().chain([ansatz.clone()]);
        let left = imbalance(ring, &Series::new(0, next.collect()))?;
        let left = left.coefficient(k - 1).ok_or(Obstacle::Empty)?;
        let says = format!("At the order α^{}", k - 1);
        if k == 2 {
            let corner = ring.put(&ring.normal(&left), &[(&t, &Rational::int(0))])?;
            p.note("At the order α^1, ψ = 0", ring.text(&corner));
            let root = ring.put(&corner, &[(&before, &way_in)])?;
            p.zero(
                "It vanishes at a′ = −1, where A falls as α grows: of the two motions along ψ = 0 the one that comes in",
                &root,
            )?;
        }
        let known: Vec<_> = match k {
            2 => vec![(before.clone(), way_in.clone())],
            _ => Vec::new(),
        };
        let known: Vec<_> = known.iter().map(|(x, v)| (x, v)).collect();
        let left = ring.put(&ring.normal(&left), &known)?;
        let unknown: Vec<_> = unknown.iter().copied().chain(["a′"]).collect();
        let solved = p.solve(&says, &[left], Some(&t), &unknown)?;
        let values: Vec<_> = solved.iter().map(|(x, v)| (x, v)).chain(known).collect();
        if let Some(last) = found.last_mut() {
            *last = ring.put(last, &values)?;
        }
        found.push(ring.put(&ring.put(&ansatz, &values)?, &[(&free, &before)])?);
    }
    found.pop();
    for (k, f) in found.iter().enumerate().skip(1) {
        p.note(&format!("F{}", ["₁", "₂", "₃", "₄"][k - 1]), ring.text(f));
    }
    let a = Series::new(0, found);
    let left = imbalance(ring, &a)?;
    for k in 0..ORDER {
        let left = left.coefficient(k).ok_or(Obstacle::Empty)?;
        p.zero(
            &format!("With these, the equation holds at the order α^{k}"),
            &left,
        )?;
    }
    Ok(a)
}

static SOLUTION: Derived<(Option<Series>, Proof)> =
    Derived::new(|| Proof::finding("The boundary in powers of α", ring(), solve));

pub(super) fn with_series(
    title: &str,
    steps: impl FnOnce(&mut Prover<'_>, &Series) -> Result<(), Obstacle>,
) -> Proof {
    Proof::in_ring(title, ring(), |p| {
        SOLUTION.with(|(series, proof)| {
            p.rests_on(proof)?;
            steps(p, series.as_ref().ok_or(Obstacle::Empty)?)
        })
    })
}

/// A formula for A agrees with the series up to this power of α.
pub(super) fn agrees(
    p: &mut Prover<'_>,
    formula: Expr,
    order: i64,
    a: &Series,
) -> Result<(), Obstacle> {
    let small = Series::monomial(Rational::int(1), 1, ENOUGH);
    let stated = p.expand("The formula", formula, &[("α", &small)], ("α", order))?;
    for k in 0..=order {
        let [stated, found] =
            [&stated, a].map(|series| series.coefficient(k).ok_or(Obstacle::Empty));
        p.equal(
            &format!("It agrees with A at the order α^{k}"),
            &stated?,
            &found?,
        )?;
    }
    Ok(())
}

/// A formula for A agrees with the boundary up to this power of α.
pub(crate) fn prove(formula: Expr, order: i64) -> Proof {
    with_series("the boundary between rest and escape", |p, a| {
        agrees(p, formula, order, a)
    })
}

/// To second order in α.
pub(crate) fn stated() -> Expr {
    corrected::boundary_a::tree()
}

pub(crate) const CORRECTED: Statement = Statement::new(
    Corrected,
    Compared::one(
        "the corrected formula",
        r"the power series in $\alpha$ that solves the equations of motion, to order four",
    ),
    stated,
    |formula| prove(formula, 2),
);

pub(crate) const PRINTED: Statement = Statement::new(
    Printed,
    Compared::one(
        "(147)",
        r"the power series in $\alpha$ that solves the equations of motion",
    ),
    crate::paper::rest::eq147_a::tree,
    |formula| prove(formula, 1),
);

attempts![&PRINTED, &CORRECTED];
