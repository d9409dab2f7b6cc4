//! Theorems about every motion that comes to rest on the table: (140) to (145).
//!
//! At rest α and ψ vanish and A is σ. There the rates (113) to (115) have limits, and with the mean-value theorem the limits give
//! all but (143). For that one, α dψ/dα = kψ − 2kα but for terms of the third order, with k = σ/(1 − σ): an equation that
//! (143) solves, and to whose solutions every other comes as fast as those terms fall.

use super::series;
use crate::claims::escape::exact::chains::{polar, stops_along};
use crate::claims::rest::prelude::*;

macro_rules! of_every_rest {
    ($what:literal) => {
        Compared::shown(concat!(
            r"for every motion with $p<\rho$ that comes to rest at a $\sigma$ between 0 and 1, with $\psi\to0$, ",
            $what
        ))
    };
}

pub(crate) const EQ140: Statement = Statement::new(
    Within,
    of_every_rest!(r"$\mathrm d\alpha/\mathrm d\tau$ tends to the right side of (140)"),
    series::EQ140.formulas,
    eq140,
);
pub(crate) const EQ141: Statement = Statement::new(
    Within,
    of_every_rest!(
        r"with $\tau=0$ at rest, the ratio of $\alpha$ to the right side of (141) tends to 1"
    ),
    series::EQ141.formulas,
    eq141,
);
pub(crate) const EQ142: Statement<[Expr; 2]> = Statement::new(
    Within,
    of_every_rest!(
        r"the two sides of (142) differ by less than $\varepsilon(1+\lvert\psi\rvert/\alpha)$ from some time on, however small $\varepsilon>0$ is"
    ),
    series::EQ142.formulas,
    eq142,
);
pub(crate) const EQ143: Statement = Statement::new(
    Within,
    of_every_rest!(
        r"$\frac14<\sigma<\frac34$ and $\sigma\ne\frac12$, there is a constant $c$ with which $\psi$ differs from the right side of (143) by $(\alpha+\alpha^{\sigma/(1-\sigma)})^3$ times a bounded number: by what is of smaller order than $\alpha$ and than $\alpha^{\sigma/(1-\sigma)}$"
    ),
    series::EQ143.formulas,
    eq143,
);
pub(crate) const EQ144: Statement<[Expr; 2]> = Statement::new(
    Within,
    of_every_rest!(r"the ratio of the two sides of (144) tends to 1"),
    series::EQ144.formulas,
    eq144,
);
pub(crate) const EQ145: Statement = Statement::new(
    Within,
    of_every_rest!(
        r"$(A-\sigma)/\alpha^2$ tends to the coefficient of $\alpha^2$ in (145), which has no other term beside $\sigma$"
    ),
    series::EQ145.formulas,
    eq145,
);

/// Powers of ε, the size of α and ψ, to which is compared.
const ORDER: i64 = 3;

fn ring() -> Ring {
    Ring::of(["σ", "c", "τ", "slope", "ψ", "x", "y", "a", "α"])
}

/// The same, with the power of α that (143) has.
fn with_power() -> Result<Ring, ExactError> {
    let mut ring = ring();
    let exponent = ring.read(printed::eq143_exponent::tree())?;
    ring.power(&ring.named("α")?, &exponent)?;
    Ok(ring)
}

pub(crate) fn settles() -> Proof {
    let (limits, ahead) = (
        printed::s4_near_rest_limits(),
        motion::eq101_xi_rate::tree(),
    );
    polar("α and ψ at rest", |p| {
        p.shows("If a motion with p < ρ comes to rest after a finite time, then α → 0, and, up to whole turns, ψ → 0, unless the particle comes straight in, with ψ → π.");
        settle(p, limits, ahead)
    })
}

pub(super) fn settle(
    p: &mut Prover<'_>,
    [alpha, psi]: [Expr; 2],
    ahead: Expr,
) -> Result<(), Obstacle> {
    rest_on(
        p,
        &[
            &turntable::EQ103,
            &turntable::EQ110,
            &turntable::EQ111,
            &turntable::EQ112,
        ],
    )?;
    p.note(
        "At rest",
        "ρ = σ > 0, as A² = ρ² − p² is positive at the start and never falls; so A → σ, and tanh α = p/ρ → 0",
    );
    p.vanishes("The stated limit of α", alpha)?;
    p.rests_on(&stops_along(ahead))?;
    p.vanishes("The stated limit of ψ", psi)
}

fn arriving(
    title: &str,
    ring: Result<Ring, ExactError>,
    steps: impl FnOnce(&mut Prover<'_>) -> Result<(), Obstacle>,
) -> Proof {
    Proof::in_ring(title, ring, |p| {
        p.rests_on(&settles())?;
        rest_on(
            p,
            &[&turntable::EQ113, &turntable::EQ114, &turntable::EQ115],
        )?;
        steps(p)
    })
}

/// A formula in powers of ε, A being σ + aεⁿ.
fn near(p: &mut Prover<'_>, says: &str, formula: Expr, n: i64) -> Result<Series, Obstacle> {
    let ring = p.ring();
    let named =
        |name, power| Ok::<_, ExactError>(Series::monomial(ring.named(name)?, power, ORDER + 3));
    let sigma = Series::constant(ring.named("σ")?, ORDER + 3);
    let values = [
        ("A", &sigma.plus(&named("a", n)?)),
        ("α", &named("x", 1)?),
        ("ψ", &named("y", 1)?),
    ];
    p.expand(says, formula, &values, ("ε", ORDER))
}

fn order(series: &Series, power: i64) -> Result<Rational, Obstacle> {
    series.coefficient(power).ok_or(Obstacle::Empty)
}

fn alpha_rate() -> Expr {
    motion::eq114_alpha_rate::tree()
}

/// The limit of dα/dτ.
fn inwards(p: &mut Prover<'_>) -> Result<Rational, Obstacle> {
    let rate = near(p, "dα/dτ by (114), with A = σ + aε", alpha_rate(), 1)?;
    order(&rate, 0)
}

fn eq140(formula: Expr) -> Proof {
    arriving("(140) of every motion to rest", Ok(ring()), |p| {
        let limit = inwards(p)?;
        p.reads_as(&limit, "by (140)", formula)
    })
}

fn eq141(formula: Expr) -> Proof {
    arriving("(141) of every motion to rest", Ok(ring()), |p| {
        let limit = inwards(p)?;
        p.note(
            "With τ = 0 at rest",
            "by the mean-value theorem α/τ is dα/dτ at a time between: it has the same limit",
        );
        p.reads_as(&limit, "(141) over τ", formula / symbol("τ"))
    })
}

/// The left side of (142) or (144) is the slope times the limit of dα/dτ.
fn left_side(p: &mut Prover<'_>, left: Expr) -> Result<(), Obstacle> {
    let limit = inwards(p)?;
    let left = p.read("Left side", left)?;
    p.equal(
        "It is the slope times the limit",
        &left,
        &(limit * p.ring().named("slope")?),
    )
}

fn eq142([left, right]: [Expr; 2]) -> Proof {
    arriving("(142) of every motion to rest", Ok(ring()), |p| {
        left_side(p, left)?;
        let [alpha, psi] = symbols(["α", "ψ"]);
        let turning = motion::eq115_psi_rate::tree();
        let share = (2 - turning) * alpha / psi;
        let share = near(p, "2 less dψ/dτ by (115), over ψ/α", share, 1)?;
        p.equal("Its limit is 1", &order(&share, 0)?, &Rational::int(1))?;
        p.identity(("Right side", right), ("", 2 - psi / alpha))
    })
}

fn eq144([left, right]: [Expr; 2]) -> Proof {
    arriving("(144) of every motion to rest", Ok(ring()), |p| {
        left_side(p, left)?;
        growth(p)?;
        let right = p.read("Right side", right)?;
        let alpha = p.ring().named("α")?;
        p.equal("It is α", &right, &alpha)?;
        Ok(())
    })
}

/// dA/dτ is as small as α.
fn growth(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    let alpha = symbol("α");
    let ratio = near(
        p,
        "dA/dτ by (113), over α",
        motion::eq113_a_rate(alpha) / alpha,
        1,
    )?;
    p.equal("Its limit is 1", &order(&ratio, 0)?, &Rational::int(1))
}

fn eq145(formula: Expr) -> Proof {
    arriving("(145) of every motion to rest", Ok(ring()), |p| {
        let limit = inwards(p)?;
        growth(p)?;
        p.note(
            "At rest A is σ and α is 0",
            "by Cauchy's mean-value theorem (A − σ)/α² is dA/dτ over 2α dα/dτ at a time between: it tends to 1 over twice the limit of dα/dτ",
        );
        let twice = limit * Rational::int(2);
        let coefficient = p.quotient("1 over that", &Rational::int(1), &twice)?;
        let [sigma, alpha] = symbols(["σ", "α"]);
        p.reads_as(
            &coefficient,
            "(145) less σ, over α²",
            (formula - sigma) / alpha.squared(),
        )
    })
}

fn eq143(formula: Expr) -> Proof {
    arriving("(143) of every motion to rest", with_power(), |p| {
        p.rests_on(&EQ145.proof())?;
        let [sigma, alpha, psi] = symbols(["σ", "α", "ψ"]);
        let k = sigma / (1 - sigma);
        let slope = alpha * motion::eq115_psi_rate::tree() / alpha_rate();
        let slope = near(p, "α dψ/dα by (114) and (115)", slope, 2)?;
        p.zero("It has no term without ε", &order(&slope, 0)?)?;
        let linear = k * psi - 2 * k * alpha;
        let linear = near(p, "With k = σ/(1 − σ), kψ − 2kα", linear, 2)?;
        p.equal(
            "The first terms are equal",
            &order(&slope, 1)?,
            &order(&linear, 1)?,
        )?;
        p.zero("Its second term is 0", &order(&slope, 2)?)?;
        let stated = p.read("(143)", formula)?;
        let ring = p.ring();
        let slope = p.slope("Its slope", &stated, "α")?;
        let left = slope * ring.named("α")? - ring.read(k)? * &stated;
        let right = ring.read(-2 * k * alpha)?;
        p.equal("α times that, less k times (143), is −2kα", &left, &right)?;
        let free = p.slope("Its slope by c", &stated, "c")?;
        p.reads_as(&free, "", 2 * alpha * alpha.pow(k - 1))?;
        Ok(())
    })
}

attempts![&EQ140, &EQ141, &EQ142, &EQ143, &EQ144, &EQ145];
