//! Theorems about every start close to α = 0: the surfaces of the resting places, and the boundary between rest and escape, with
//! what their expansions leave out.
//!
//! A surface A = P(α, ψ) that solves the equations of motion up to a residual is moved by ±αⁿ: it becomes a barrier that
//! motions cross in one direction only, if the residual is smaller than what the move brings.

use super::boundary::{self, imbalance};
use super::{least, surfaces};
use crate::claims::escape::exact::chains as fates;
use crate::claims::turntable::exact as turntable;
use crate::exact::Series;
use crate::paper::{rest as printed, turntable as motion};
use trialbook::prelude::*;

/// The surface of starts that come to rest at σ.
pub const SURFACE: Statement = Statement::new(
    Corrected,
    Compared::shown(
        r"for every $\sigma$ between 0 and 1 there are $\alpha_0>0$ and $K$ such that every start with $0<\alpha<\alpha_0$, whatever $\psi$ is, from which the particle comes to rest at $\sigma$ has an $A$ that differs from the corrected $A(\sigma,\alpha,\psi)$ by $K\alpha^3$ at most; and for each $\alpha$ and $\psi$ there is such an $A$",
    ),
    surfaces::CORRECTED.formulas,
    surface,
);

/// The boundary between rest and escape.
pub const BOUNDARY: Statement = Statement::new(
    Corrected,
    Compared::shown(
        r"there are $\alpha_0>0$ and $K$ such that from every start with $0<\alpha<\alpha_0$, whatever $\psi$ is, the particle comes to rest if $A$ is below $1-\alpha f_1(\psi)+\alpha^2f_2(\psi)$ by more than $K\alpha^3$, and escapes if it is above by more; for each $\alpha$ and $\psi$ there is an $A$ between, from which the particle comes to $\rho=1$, in a finite time only if $\psi\to\pi$",
    ),
    boundary::stated,
    rest_or_escape,
);

/// Its lowest points.
pub const LEAST: Statement = Statement::new(
    Corrected,
    Compared::shown(
        r"there are $\alpha_0>0$ and $K$ such that, with $0<\alpha<\alpha_0$, the particle comes to rest from every start with an $A$ below $1-\alpha+\frac76\alpha^2$ by more than $K\alpha^3$, whatever $\psi$ is, and escapes, if $\psi=2\alpha$, where $A$ is above by more",
    ),
    least::CORRECTED.formulas,
    lowest,
);

fn int(n: i64) -> Expr {
    Expr::int(n)
}

fn order(series: &Series, power: i64) -> Result<Rational, Obstacle> {
    series.coefficient(power).ok_or(Obstacle::Empty)
}

/// How far a motion is from a barrier, and how that changes.
fn moved() -> Proof {
    let ring = || {
        let mut ring = Ring::of(["A", "P", "b", "d", "K", "s", "σ"]);
        ring.hyperbolic("α");
        ring.angle("ψ");
        Ok(ring)
    };
    Proof::in_ring("How far a motion is from a barrier", ring(), |p| {
        given(
            p,
            &[&turntable::EQ113, &turntable::EQ114, &turntable::EQ115],
        )?;
        let [a, alpha, psi, sigma] = Expr::symbols(["A", "α", "ψ", "σ"]);
        let [surface, b, d, k, s] = Expr::symbols(["P", "b", "d", "K", "s"]);
        p.note(
            "Let b and d be the slopes of a surface A = P(α, ψ) by α and ψ",
            "u = A − P − sKα³ is how far a motion is from the surface, moved; s is 1 or −1",
        );
        let falls = |a| -motion::eq114_alpha_rate(a, alpha, psi);
        let [growth, turning] = [
            motion::eq113_a_rate(alpha),
            motion::eq115_psi_rate(alpha, psi),
        ];
        let rate =
            growth + b * falls(a) - d * turning + int(3) * s * k * alpha.squared() * falls(a);
        let residual = growth + b * falls(surface) - d * turning;
        let pull = -(b * alpha.cosh() / (a * surface)) * (a - surface);
        let parts = residual + pull + int(3) * s * k * alpha.squared() * falls(a);
        p.identity(("du/dτ by (113) to (115)", rate), ("the sum of the residual R, which is that of the surface at A = P; of m (A − P) with m = −b cosh α/(AP); and of 3sKα² f with f = −dα/dτ", parts))?;
        let parts = int(2) * (psi / int(2)).sin().squared()
            + int(2) * (alpha / int(2)).sinh().squared() / a
            + (int(1) / a - int(1));
        p.identity(("f", falls(a)), ("two squares and 1/A − 1", parts))?;
        p.identity(
            ("1/A − 1 less 1/σ − 1", int(1) / a - int(1) / sigma),
            ("", (sigma - a) / (sigma * a)),
        )
    })
}

fn surface(formula: Expr) -> Proof {
    let title = "Every start from which the particle comes to rest at σ";
    Proof::in_ring(title, surfaces::ring(), |p| {
        p.rests_on(&moved())?;
        p.rests_on(&surfaces::prove(formula))?;
        given(p, &[&turntable::EQ110])?;
        let small = Series::monomial(Rational::int(1), 1, boundary::ENOUGH);
        let a = p.expand("P", formula, &[("α", &small)], ("α", 2))?;
        let left = imbalance(p.ring(), &a)?;
        p.zero("R at the order α^0", &order(&left, 0)?)?;
        p.note(
            "At the order α it is 0 too, as just found",
            "R, analytic in α, is bounded for all ψ, as the coefficients are polynomials in cos(ψ/2) and sin(ψ/2): |R| ≤ Cα²",
        );
        p.note(
            "Let a motion come to rest at σ < 1",
            "A never falls: A ≤ σ, f ≥ 1/σ − 1 > 0, and it lasts for α/(1/σ − 1) at most, so that A ≥ σ/2 if α₀ is small, as P ≥ σ/2",
        );
        p.note(
            "So |m| ≤ C′α, as b is of the order of α",
            "choose K with 3K (1/σ − 1) > C + 1, then α₀ so small that C′Kα₀² < 1",
        );
        p.note(
            "If u > 0 at the start, with s = 1",
            "du/dτ ≥ −C′αu + α² (3K (1/σ − 1) − C − C′Kα²) ≥ −C′αu: u is still positive at rest, against u = σ − P(0) = 0",
        );
        p.note(
            "If u < 0 at the start, with s = −1",
            "so it would be at rest, with all signs turned: A differs from P by Kα³ at most",
        );
        p.note(
            "In the same way no start with u > 0, s = 1 rests at σ or inside, where u is 0 or less",
            "and one with u < 0, s = −1 rests inside σ: A does not pass σ, where u > 0 as P < σ",
        );
        p.rests_on(&fates::comes_to_rest(printed::eq139_largest_sigma()))?;
        p.note(
            "For given α and ψ the starts that rest inside σ are open, as little way is left just before, and those whose A passes σ",
            "neither set is empty, and they do not meet: from some A between, A ≤ σ for ever, and as f ≥ 1/σ − 1 the particle rests, at σ",
        );
        Ok(())
    })
}

fn rest_or_escape(formula: Expr) -> Proof {
    let title = "Every start near α = 0 and the boundary between rest and escape";
    boundary::with_series(title, |p, a| {
        p.rests_on(&moved())?;
        boundary::agrees(p, formula, 2, a)?;
        p.note(
            "P being the series to the order α^4",
            "it differs from the formula by a bounded number times α³",
        );
        p.note(
            "R has no term below the order α^4, as just found",
            "R and m, analytic in α, are bounded for all ψ, as the coefficients are polynomials in cos(ψ/2) and sin(ψ/2): |R| ≤ Cα^4",
        );
        let slope = p.ring().normal(&-&order(a, 1)?);
        let psi = Expr::symbol("ψ");
        let stated = p.read("(1 + cos ψ)/2", (int(1) + psi.cos()) / int(2))?;
        p.equal("It is −b at α = 0", &slope, &stated)?;
        p.note(
            "Inside |ψ| ≤ π/2",
            "m ≥ 1/4 where A ≤ 1, if α₀ is small, and no motion goes out, as dψ/dτ = 2 ∓ 2 coth 2α at its ends",
        );
        p.note(
            "Outside",
            "f ≥ 1 where A ≤ 1, and m ≥ −C′α where A ≥ 1/2: α falls to 0, or the motion comes inside, before τ = α₀",
        );
        p.note(
            "Let K = 1 in u; that of the theorem is larger by what P and the formula differ",
            "and α₀ so small that what is of the order of α^4 is below α³/4",
        );
        above(p)?;
        below(p, formula)?;
        p.note(
            "For given α and ψ the starts that come to rest inside ρ = 1 are open, as p + ρ < 1 just before, and those whose A passes 1",
            "neither set is empty, and they do not meet: some A between belongs to none",
        );
        given(p, &[&super::chains::DICHOTOMY])?;
        p.note(
            "From there A ≤ 1 for ever, α falls, and ρ stays bounded",
            "the particle stops at ρ = A ≤ 1, and so at ρ = 1, or by the dichotomy creeps towards it",
        );
        p.note(
            "Let it stop at a time T with ψ → 0",
            "α ≤ c (T − τ), so that the time s with ds = dτ/α grows without end; d(ψ/α)/ds = 2 − (1 + o(1)) ψ/α + o(1) ψ/α keeps ψ/α bounded; 1 − A ≤ (T − τ) sinh α, as dA/dτ = sinh α falls",
        );
        p.note(
            "So f ≤ Cα (α + T − τ)",
            "ln α falls at a bounded rate and α is not 0 at T: by the limits of ψ at a stop, ψ → π is left",
        );
        Ok(())
    })
}

/// Above the upper barrier a motion escapes.
fn above(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    given(p, &[&fates::ESCAPES])?;
    p.note(
        "With s = 1, u > 0 at the start",
        "if A > 1, it escapes; while A ≤ 1, α falls, as f > 0, and A > P ≥ 1/2: outside du/dτ ≥ −C′αu + 3α² − (C + C′) α^4 ≥ −C′αu, inside du/dτ ≥ m (u + α³) − Cα^4 ≥ u/4",
    );
    p.note(
        "So u stays positive, and inside it grows without end",
        "not for ever, as A ≤ 1; nor does α come to 0, where u is A − 1: A passes 1, and the particle escapes",
    );
    Ok(())
}

/// How far the formula is below 1.
fn lower_than_one(formula: Expr) -> Proof {
    let [alpha, psi] = Expr::symbols(["α", "ψ"]);
    let half = psi / int(2);
    let (c, s) = (half.cos(), half.sin());
    let ratio = |n, m| int(n) / int(m);
    let h = ratio(11, 12) * c.pow(int(3)) + int(2) * s * c.squared() - s.squared() * c
        + ratio(2, 3) * s.pow(int(3))
        + c / int(2);
    let parts = alpha * (c - alpha * h / int(2)).squared() + alpha.squared() / int(4)
        - alpha.pow(int(3)) * h.squared() / int(4);
    Proof::in_ring("The formula is below 1", least::ring(), |p| {
        p.identity(
            ("1 less the formula", int(1) - formula),
            ("where H is bounded", parts),
        )
    })
}

/// Below the lower barrier it comes to rest.
fn below(p: &mut Prover<'_>, formula: Expr) -> Result<(), Obstacle> {
    given(p, &[&turntable::EQ110, &super::EQ139])?;
    p.rests_on(&fates::comes_to_rest(printed::eq139_largest_sigma()))?;
    p.rests_on(&lower_than_one(formula))?;
    p.note(
        "So P < 1 if α₀ is small",
        "with s = −1, A < 1 while u < 0, and then α falls",
    );
    p.note(
        "With u < 0 at the start",
        "it stays: where A ≤ 1/2, u is near −1/2 or less; where A ≥ 1/2, du/dτ ≤ C′α |u| + (C + C′) α^4 − 3α² ≤ C′α |u| outside; inside, whatever A < 1 is, du/dτ ≤ m (u − α³) + Cα^4 ≤ u/4",
    );
    p.note(
        "Inside u would fall without end, but it is above −2",
        "so α comes to 0 after a finite time, with ρ = A < 1, where static friction holds",
    );
    Ok(())
}

fn lowest(formula: Expr) -> Proof {
    let title = "Every start near α = 0, and where the boundary is lowest";
    Proof::in_ring(title, least::ring(), |p| {
        p.rests_on(&least::prove(formula))?;
        given(p, &[&BOUNDARY])?;
        p.note(
            "The corrected boundary is nowhere below the formula but for the order α³",
            "below the formula by more than Kα³, with another K, every start comes to rest",
        );
        p.note(
            "At ψ = 2α",
            "the boundary is the formula but for the order α³",
        );
        least::where_it_is(p, formula, Rational::int(2))?;
        p.note(
            "So",
            "from there every start escapes whose A is above the formula by more than Kα³",
        );
        Ok(())
    })
}

pub(in crate::claims) const TRIALS: &[Attempt] = trials![&LEAST, &SURFACE, &BOUNDARY];
