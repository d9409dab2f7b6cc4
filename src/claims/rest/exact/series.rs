//! The motions that end in rest, as power series in α: (140) to (145).
//!
//! ψ = α P₁ + α³ P₃ + …, A = σ + α² Q₂ + α⁴ Q₄ + …, with polynomials Pₖ and Qₖ in ζ = c αᵉ, whose exponent e is the one
//! that (143) prints. The coefficients are found order by order from the equations of motion (113) to (115), which are
//! proved from Newton's law.

use crate::claims::rest::prelude::*;

const UNKNOWN: [&str; 7] = ["x₀", "x₁", "x₂", "x₃", "x₄", "x₅", "x₆"];

/// The highest power of α: (143) and (145) need the second, and two more orders are four more powers.
const ORDER: i64 = 6;

/// To which power numbers and α itself are carried along.
const ENOUGH: i64 = ORDER + 3;

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    for name in ["σ", "c", "ζ", "slope", "y", "a₂"].iter().chain(&UNKNOWN) {
        ring.symbol(name);
    }
    let alpha = ring.symbol("α");
    let exponent = ring.read(printed::eq143_exponent::tree())?;
    ring.power(&alpha, &exponent)?;
    Ok(ring)
}

fn small() -> Series {
    Series::monomial(Rational::int(1), 1, ENOUGH)
}

/// What α d/dα is of ζ.
fn moving(ring: &Ring) -> Result<Derivation, ExactError> {
    let zeta = symbol("ζ");
    ring.along(&[("ζ", ring.read(zeta * printed::eq143_exponent::tree())?)])
}

/// A polynomial in ζ of this degree, from a residual that has to vanish.
fn next(
    p: &mut Prover<'_>,
    says: &str,
    degree: i64,
    residual: impl FnOnce(&Rational) -> Result<Option<Rational>, ExactError>,
) -> Result<Rational, Obstacle> {
    let ring = p.ring();
    let unknown = &UNKNOWN[..=degree as usize];
    let zeta = ring.named("ζ")?;
    let (mut ansatz, mut power) = (Rational::int(0), Rational::int(1));
    for name in unknown {
        ansatz = ansatz + ring.named(name)? * &power;
        power = power * &zeta;
    }
    let residual = residual(&ansatz)?.ok_or(Obstacle::Empty)?;
    let solved = p.solve(says, &[residual], Some(&zeta), unknown)?;
    let values: Vec<_> = solved.iter().map(|(x, value)| (x, value)).collect();
    Ok(ring.put(&ansatz, &values)?)
}

/// α d/dα of a series times dα/dτ over α, less a rate.
fn imbalance(
    ring: &Ring,
    series: &Series,
    [alpha_rate, rate]: [&Series; 2],
) -> Result<Series, ExactError> {
    let slope = series.euler(&moving(ring)?, ring)?.shifted(-1);
    Ok(slope.times(alpha_rate, ring).minus(rate))
}

/// dα/dτ by (114), dA/dτ by (113), dψ/dτ by (115).
fn rates(ring: &Ring, psi: &Series, a: &Series) -> Result<[Series; 3], ExactError> {
    let values = [("A", a), ("α", &small()), ("ψ", psi)];
    let expand = |formula| ring.expand(formula, &values, ENOUGH);
    Ok([
        expand(motion::eq114_alpha_rate::tree())?,
        expand(motion::eq113_a_rate::tree())?,
        expand(motion::eq115_psi_rate::tree())?,
    ])
}

fn with(known: &[Rational], next: &Rational, start: i64) -> Series {
    Series::new(start, known.iter().chain([next]).cloned().collect())
}

fn solve(p: &mut Prover<'_>) -> Result<[Series; 3], Obstacle> {
    p.shows("ψ up to α^5 and A = σ + … up to α^6, as series in α whose coefficients are polynomials in ζ, with α dζ/dα = ζ (2σ − 1)/(1 − σ), meet (113) to (115) at six orders; ζ contains a constant that is free.");
    rest_on(
        p,
        &[&turntable::EQ113, &turntable::EQ114, &turntable::EQ115],
    )?;
    let ring = p.ring();
    let (mut psi, mut a) = (Vec::new(), vec![ring.named("σ")?]);
    p.note(
        "To be found",
        "ψ odd and A even in α, in which they stand by their polynomials in ζ",
    );
    for k in 1..=ORDER {
        if k % 2 == 1 {
            let size = with(&a, &Rational::int(0), 0);
            let says = format!(
                "dψ/dα dα/dτ = dψ/dτ by (115) at the order {}, for Σ xₙ ζⁿ in ψ at the order {k}",
                k - 1
            );
            let mut found = next(p, &says, k, |x| {
                let angle = with(&psi, x, 1);
                let [alpha_rate, _, turning] = rates(ring, &angle, &size)?;
                Ok(imbalance(ring, &angle, [&alpha_rate, &turning])?.coefficient(k - 1))
            })?;
            if k == 1 {
                let free = ring.named("x₁")?;
                let slope = ring.derivative(&found, &ring.by("x₁")?)?;
                p.equal(
                    "The coefficient x₁ of ζ is left free",
                    &slope,
                    &ring.named("ζ")?,
                )?;
                found = ring.put(&found, &[(&free, &Rational::int(2))])?;
            }
            psi.extend([found, Rational::int(0)]);
            a.push(Rational::int(0));
        } else {
            let angle = Series::new(1, psi.clone());
            let says = format!(
                "dA/dα dα/dτ = dA/dτ by (113) at the order {}, for Σ xₙ ζⁿ in A at the order {k}",
                k - 1
            );
            a.push(next(p, &says, k, |x| {
                let size = with(&a, x, 0);
                let [alpha_rate, growth, _] = rates(ring, &angle, &size)?;
                Ok(imbalance(ring, &size, [&alpha_rate, &growth])?.coefficient(k - 1))
            })?);
        }
    }
    let (psi, a) = (Series::new(1, psi), Series::new(0, a));
    p.note("ψ", psi.text("α", ring));
    p.note("A", a.text("α", ring));
    let [alpha_rate, growth, turning] = rates(ring, &psi, &a)?;
    for (says, series, rate) in [("(115)", &psi, &turning), ("(113)", &a, &growth)] {
        let left = imbalance(ring, series, [&alpha_rate, rate])?;
        for k in 0..ORDER {
            let left = left.coefficient(k).ok_or(Obstacle::Empty)?;
            p.zero(
                &format!("{says} holds with these series at the order {k}"),
                &left,
            )?;
        }
    }
    p.note("dα/dτ", alpha_rate.text("α", ring));
    Ok([psi, a, alpha_rate])
}

static SOLUTION: Derived<(Option<[Series; 3]>, Proof)> =
    Derived::new(|| Proof::finding("The motions to rest in powers of α", ring(), solve));

fn from_series(
    title: &str,
    steps: impl FnOnce(&mut Prover<'_>, &[Series; 3]) -> Result<(), Obstacle>,
) -> Proof {
    Proof::in_ring(title, ring(), |p| {
        SOLUTION.with(|(series, proof)| {
            p.rests_on(proof)?;
            steps(p, series.as_ref().ok_or(Obstacle::Empty)?)
        })
    })
}

fn order(series: &Series, power: i64) -> Result<Rational, Obstacle> {
    series.coefficient(power).ok_or(Obstacle::Empty)
}

pub(crate) fn eq140(formula: Expr) -> Proof {
    from_series("(140): dα/dτ near rest", |p, [_, _, rate]| {
        let stated = p.read("(140)", formula)?;
        p.equal("It is the first term of dα/dτ", &order(rate, 0)?, &stated)
    })
}

pub(crate) fn eq141(formula: Expr) -> Proof {
    from_series("(141): α near rest", |p, [_, _, rate]| {
        let ring = p.ring();
        let integrand = small().over(rate, ring)?;
        let mut time = Vec::new();
        for k in 1..ORDER {
            let says = format!("α dτ/dα = α/(dα/dτ) at the order {k}, for τ");
            time.push(next(p, &says, k, |x| {
                let slope = with(&time, x, 1).euler(&moving(ring)?, ring)?;
                Ok(slope.minus(&integrand).coefficient(k))
            })?);
        }
        let time = Series::new(1, time);
        let stated = p.expand("(141) with that", formula, &[("τ", &time)], ("α", ORDER))?;
        p.zero("It has no term without α", &order(&stated, 0)?)?;
        p.equal(
            "Its first term is α",
            &order(&stated, 1)?,
            &Rational::int(1),
        )
    })
}

/// The first terms of dα/dτ, dA/dτ and dψ/dτ where ψ = y α, whatever y is.
fn first_terms(p: &mut Prover<'_>) -> Result<[Series; 3], Obstacle> {
    let ring = p.ring();
    let psi = Series::monomial(ring.named("y")?, 1, 4);
    let a = Series::new(
        0,
        vec![ring.named("σ")?, Rational::int(0), ring.named("a₂")?],
    );
    p.note(
        "To be compared",
        "first terms in α, with ψ = y α and A = σ + a₂ α² + …",
    );
    let rates = rates(ring, &psi, &a)?;
    let names = ["dα/dτ by (114)", "dA/dτ by (113)", "dψ/dτ by (115)"];
    for (name, rate) in names.into_iter().zip(&rates) {
        p.note(name, rate.text("α", ring));
    }
    Ok(rates)
}

/// dα/dτ times a slope against the left side of (142) or (144).
fn left_side(p: &mut Prover<'_>, rate: &Series, left: Expr) -> Result<(), Obstacle> {
    let product = order(rate, 0)? * p.ring().named("slope")?;
    let left = p.read("Left side", left)?;
    p.equal("It is the slope times dα/dτ", &left, &product)
}

pub(crate) fn eq142([left, right]: [Expr; 2]) -> Proof {
    from_series("(142): dψ/dα near rest", |p, _| {
        let [rate, _, turning] = first_terms(p)?;
        left_side(p, &rate, left)?;
        let psi = Series::monomial(p.ring().named("y")?, 1, ENOUGH);
        let values = [("α", &small()), ("ψ", &psi)];
        let right = p.expand("Right side", right, &values, ("α", 1))?;
        p.equal(
            "It is that of dψ/dτ",
            &order(&right, 0)?,
            &order(&turning, 0)?,
        )
    })
}

pub(crate) fn eq144([left, right]: [Expr; 2]) -> Proof {
    from_series("(144): dA/dα near rest", |p, _| {
        let [rate, growth, _] = first_terms(p)?;
        left_side(p, &rate, left)?;
        let right = p.expand("Right side", right, &[("α", &small())], ("α", 1))?;
        for k in [0, 1] {
            let says = format!("It agrees with dA/dτ at the order {k}");
            p.equal(&says, &order(&right, k)?, &order(&growth, k)?)?;
        }
        Ok(())
    })
}

pub(crate) fn eq143(formula: Expr) -> Proof {
    from_series("(143): ψ near rest", |p, [psi, ..]| {
        let ring = p.ring();
        let [alpha, c] = symbols(["α", "c"]);
        let zeta = p.read(
            "ζ",
            c * crate::scalar::Scalar::pow(alpha, printed::eq143_exponent::tree()),
        )?;
        let first = ring.put(&order(psi, 1)?, &[(&ring.named("ζ")?, &zeta)])?;
        let stated = p.read("(143)", formula)?;
        p.equal(
            "It is the first term of ψ",
            &stated,
            &(first * ring.named("α")?),
        )
    })
}

pub(crate) fn eq145(formula: Expr) -> Proof {
    from_series("(145): A near rest", |p, [_, a, _]| {
        let stated = p.expand("(145)", formula, &[("α", &small())], ("α", 3))?;
        for k in 0..=2 {
            let says = format!("It agrees with A at the order {k}");
            p.equal(&says, &order(&stated, k)?, &order(a, k)?)?;
        }
        Ok(())
    })
}

const SERIES: Compared = Compared::one(
    "the claim",
    r"the first term of the power series in $\alpha$ and $\zeta$ that solves (113) to (115), which three orders of it confirm",
);

pub(crate) const EQ140: Statement =
    Statement::new(Within, SERIES, printed::eq140_alpha_rate::tree, eq140);
pub(crate) const EQ141: Statement =
    Statement::new(Within, SERIES, printed::eq141_alpha::tree, eq141);
pub(crate) const EQ142: Statement<[Expr; 2]> = Statement::new(
    Within,
    SERIES,
    || {
        let [sigma, slope] = symbols(["σ", "slope"]);
        [
            printed::eq142_left(sigma, slope),
            printed::eq142_right::tree(),
        ]
    },
    eq142,
);
pub(crate) const EQ143: Statement = Statement::new(Within, SERIES, printed::eq143_psi::tree, eq143);
pub(crate) const EQ144: Statement<[Expr; 2]> = Statement::new(
    Within,
    SERIES,
    || {
        let [sigma, slope] = symbols(["σ", "slope"]);
        [
            printed::eq144_left(sigma, slope),
            printed::eq144_right::tree(),
        ]
    },
    eq144,
);
pub(crate) const EQ145: Statement = Statement::new(Within, SERIES, printed::eq145_a::tree, eq145);

attempts![&EQ140, &EQ141, &EQ142, &EQ143, &EQ144, &EQ145];
