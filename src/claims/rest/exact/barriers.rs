//! Theorems about every start close to α = 0: the surfaces of the resting places, and the boundary between rest and escape, with
//! what their expansions leave out.
//!
//! A surface A = P(α, ψ) that solves the equations of motion up to a residual is moved by ±αⁿ: it becomes a barrier that
//! motions cross in one direction only, if the residual is smaller than what the move brings.

use super::boundary::{self, imbalance};
use super::{least, surfaces};
use crate::claims::escape::exact::chains as fates;
use crate::claims::rest::prelude::*;

/// The surface of starts that come to rest at σ.
pub const SURFACE: Statement = Statement::shown(
    Corrected,
    r"for every $\sigma$ between 0 and 1 there are $\alpha_0>0$ and $K$, whose sizes are not computed, such that every start with $0<\alpha<\alpha_0$, whatever $\psi$ is, from which the particle comes to rest at $\sigma$ has an $A$ that differs from the corrected $A(\sigma,\alpha,\psi)$ by $K\alpha^3$ at most; and for each such $\alpha$ and each $\psi$ there is a start with rest at $\sigma$",
    surfaces::CORRECTED.formulas,
    surface,
);

/// The boundary between rest and escape.
pub const BOUNDARY: Statement = Statement::shown(
    Corrected,
    r"there are $\alpha_0>0$ and $K$, whose sizes are not computed, such that from every start with $0<\alpha<\alpha_0$, whatever $\psi$ is, the particle comes to rest if $A$ is below the corrected formula by more than $K\alpha^3$, and escapes if it is above by more; for each $\alpha$ and $\psi$ there is an $A$ between from which it comes to $\rho=1$: in a finite time only if $\psi\to\pi$",
    boundary::stated,
    rest_or_escape,
);

/// Its lowest points.
pub const LEAST: Statement = Statement::shown(
    Corrected,
    r"there are $\alpha_0>0$ and $K$, whose sizes are not computed, such that, with $0<\alpha<\alpha_0$, the particle comes to rest from every start with an $A$ below $1-\alpha+\frac76\alpha^2$ by more than $K\alpha^3$, whatever $\psi$ is, and escapes, if $\psi=2\alpha$, where $A$ is above by more",
    least::CORRECTED.formulas,
    lowest,
);

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
    Proof::in_ring("The distance of a motion from a barrier", ring(), |p| {
        p.shows("For u = A − P − s K α³, with P(α, ψ), K > 0 and s = 1 or s = −1: du/dτ = R + m (A − P) + 3s K α² f, R being the rate of A − P on the surface A = P. Here f = −dα/dτ is at least 1/A − 1; m is in the steps.");
        given(
            p,
            &[&turntable::EQ113, &turntable::EQ114, &turntable::EQ115],
        )?;
        let [a, alpha, psi, sigma] = symbols(["A", "α", "ψ", "σ"]);
        let [surface, b, d, k, s] = symbols(["P", "b", "d", "K", "s"]);
        p.note(
            "Let A = P(α, ψ) be a surface with the slopes b by α and d by ψ, K > 0, and s = 1 or s = −1",
            "the barrier is the surface moved by s K α³, and u = A − P − s K α³ is the distance of a motion from it",
        );
        let falls = |a| -motion::eq114_alpha_rate(a, alpha, psi);
        let [growth, turning] = [motion::eq113_a_rate::tree(), motion::eq115_psi_rate::tree()];
        let rate = growth + b * falls(a) - d * turning + 3 * s * k * alpha.squared() * falls(a);
        let residual = growth + b * falls(surface) - d * turning;
        let pull = -(b * alpha.cosh() / (a * surface)) * (a - surface);
        let parts = residual + pull + 3 * s * k * alpha.squared() * falls(a);
        p.identity(
            ("du/dτ by (113) to (115)", rate),
            ("which is R + m (A − P) + 3s K α² f: the residual R is the rate of A − P on the surface itself, m = −b cosh α/(A P), and f = −dα/dτ", parts),
        )?;
        let parts =
            2 * (psi / 2).sin().squared() + 2 * (alpha / 2).sinh().squared() / a + (1 / a - 1);
        p.identity(("f", falls(a)), ("at least 1/A − 1", parts))?;
        p.identity(
            ("1/A − 1 less 1/σ − 1", 1 / a - 1 / sigma),
            ("not negative where A ≤ σ", (sigma - a) / (sigma * a)),
        )
    })
}

fn surface(formula: Expr) -> Proof {
    let title = "Every start from which the particle comes to rest at σ";
    Proof::in_ring(title, surfaces::ring(), |p| {
        p.rests_on(&moved())?;
        p.rests_on(&surfaces::prove(formula))?;
        given(p, &[&turntable::EQ110, &super::EQ139])?;
        let small = Series::monomial(Rational::int(1), 1, boundary::ENOUGH);
        let a = p.expand("P", formula, &[("α", &small)], ("α", 2))?;
        let left = imbalance(p.ring(), &a)?;
        p.zero("R has no term of the order α^0", &order(&left, 0)?)?;
        p.note(
            "Nor has R a term of the order α, as shown before",
            "its coefficients as a series in α are polynomials in cos(ψ/2) and sin(ψ/2), so that |R| ≤ Cα² for all ψ, with a constant C",
        );
        p.note(
            "While A ≤ σ",
            "f ≥ 1/σ − 1 > 0, so that α falls, to 0 within the time α/(1/σ − 1). If A ≤ σ still, the particle is at rest there, at ρ = A. By (113) A never falls",
        );
        p.note(
            "Where A ≥ σ/2, as P is if α₀ is small, |m| ≤ C′α with a constant C′, as b is of the order of α",
            "choose K with 3K (1/σ − 1) > C + 1, then α₀ with C′Kα₀² < 1",
        );
        p.note(
            "Let s = 1, and u > 0 at the start",
            "A > P ≥ σ/2, and while A ≤ σ, du/dτ ≥ −C′αu + α² (3K (1/σ − 1) − C − C′Kα²) ≥ −C′αu, so that u stays positive. At rest at σ or inside, u = A − σ would be 0 or less: the particle does not come to rest there",
        );
        p.note(
            "Let s = −1, and u < 0 at the start",
            "where A ≤ σ/2, u is negative if α₀ is small; where A ≥ σ/2, du/dτ ≤ −C′αu by the same bounds. So u stays negative, and A < P < σ until α is 0, as P is σ less a positive multiple of α². The particle comes to rest inside σ, as u = A − σ < 0 there",
        );
        p.note(
            "So, if it comes to rest at σ, neither holds",
            "|A − P| ≤ Kα³",
        );
        p.note(
            "For given α and ψ the A with rest inside σ form an open set, and so do those with A > σ at some time",
            "shortly before rest little time is left for A to grow, also in neighbouring motions. Both have members, by the last case and with A > σ at the start, and none in common",
        );
        p.note(
            "So some A is in neither set",
            "from there A ≤ σ for ever: the particle comes to rest, not inside σ, and so at σ",
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
            "Let P be the series up to the order α^4",
            "it differs from the formula by a bounded number times α³",
        );
        p.note(
            "R has no term below the order α^4, as shown before",
            "the coefficients of P and R as series in α are polynomials in cos(ψ/2) and sin(ψ/2), so that |R| ≤ Cα^4 for all ψ, with a constant C",
        );
        let slope = p.ring().normal(&-&order(a, 1)?);
        let psi = symbol("ψ");
        let stated = p.read("(1 + cos ψ)/2", (1 + psi.cos()) / 2)?;
        p.equal("It is −b at α = 0", &slope, &stated)?;
        p.note(
            "Inside: where |ψ| ≤ π/2",
            "m ≥ 1/4 where A ≤ 1, if α₀ is small; and no motion leaves, as dψ/dτ = 2 − 2 coth 2α < 0 at ψ = π/2, and dψ/dτ = 2 + 2 coth 2α > 0 at ψ = −π/2",
        );
        p.note(
            "Outside: where cos ψ < 0",
            "f ≥ 1 where A ≤ 1, and m ≥ −C′α where A ≥ 1/2, with a constant C′: while A ≤ 1, α falls to 0 or the motion comes inside within the time α₀",
        );
        p.note(
            "Let K = 1 in u, and α₀ be so small that what is of the order of α^4 is below α³/4",
            "the K of the theorem is larger, by what P and the formula differ by, over α³",
        );
        above(p)?;
        below(p, formula)?;
        p.note(
            "For given α and ψ the A with rest inside ρ = 1 form an open set, and so do those with A > 1 at some time",
            "shortly before rest p + ρ < 1, also in neighbouring motions. Both have members, by the cases s = −1 and s = 1, and none in common: some A between is in neither",
        );
        given(p, &[&super::chains::DICHOTOMY])?;
        p.rests_on(&super::chains::settles())?;
        p.note(
            "From there A ≤ 1 for ever",
            "α falls, and ρ = A cosh α stays bounded: the particle stops at ρ = A ≤ 1, and so at ρ = 1, with ψ → 0 or ψ → π, or else creeps towards ρ = 1",
        );
        p.note(
            "Suppose that it stops, at a time T, with ψ → 0",
            "α ≤ c (T − τ) with a constant c, so that the time θ with dθ = dτ/α grows without end. As f → 0, d(ψ/α)/dθ = 2 − (1 + o(1)) ψ/α, and ψ/α stays bounded. And 1 − A ≤ (T − τ) sinh α, as dA/dτ = sinh α falls",
        );
        p.note(
            "So f is at most α (α + T − τ) times a constant",
            "ln α falls at a bounded rate, and α is not 0 at T: a contradiction, and ψ → π is left",
        );
        Ok(())
    })
}

/// Above the upper barrier a motion escapes.
fn above(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    given(p, &[&fates::ESCAPES])?;
    p.note(
        "Let s = 1, and u > 0 at the start",
        "if A > 1, the motion escapes. While A ≤ 1, α falls, as f > 0; and while u > 0 too, A > P ≥ 1/2: outside du/dτ ≥ −C′αu + 3α² − (C + C′) α^4 ≥ −C′αu, inside du/dτ ≥ m (u + α³) − Cα^4 ≥ u/4",
    );
    p.note(
        "So u stays positive while A ≤ 1",
        "α does not come to 0, where u = A − 1; so the motion comes inside, where u grows without end. As u < A, A passes 1, and the particle escapes",
    );
    Ok(())
}

/// How far the formula is below 1.
fn lower_than_one(formula: Expr) -> Proof {
    let [alpha, psi] = symbols(["α", "ψ"]);
    let half = psi / 2;
    let (c, s) = (half.cos(), half.sin());
    let ratio = |n, m| int(n) / int(m);
    let h = ratio(11, 12) * c.pow(int(3)) + 2 * s * c.squared() - s.squared() * c
        + ratio(2, 3) * s.pow(int(3))
        + c / 2;
    let parts = alpha * (c - alpha * h / 2).squared() + alpha.squared() / 4
        - alpha.pow(int(3)) * h.squared() / 4;
    Proof::in_ring("The boundary is below A = 1", least::ring(), |p| {
        p.shows("For every ψ, 1 less the corrected formula for the boundary is at least α²/4 less a bounded number times α³: positive if α > 0 is small enough.");
        p.identity(
            ("1 less the formula", 1 - formula),
            (
                "at least α²/4 less a bounded number times α³: positive for small α",
                parts,
            ),
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
        "with s = −1, A < 1 while u < 0, and α falls",
    );
    p.note(
        "Let s = −1, and u < 0 at the start",
        "where A ≤ 1/2, u is negative if α₀ is small; where A ≥ 1/2, outside, du/dτ ≤ −C′αu + (C + C′) α^4 − 3α² ≤ −C′αu; inside, for every A < 1, du/dτ ≤ m (u − α³) + Cα^4 ≤ u/4. So u stays negative",
    );
    p.note(
        "Inside u would fall without end, but it is above −2",
        "so α comes to 0 after a finite time, with ρ = A < 1, where static friction holds the particle",
    );
    Ok(())
}

fn lowest(formula: Expr) -> Proof {
    let title = "Every start near α = 0, and where the boundary is lowest";
    Proof::in_ring(title, least::ring(), |p| {
        p.rests_on(&least::prove(formula))?;
        given(p, &[&BOUNDARY])?;
        p.note(
            "The corrected boundary is nowhere below the formula, up to the order α³",
            "so from every start below the formula by more than Kα³, with a larger K, the particle comes to rest",
        );
        p.note(
            "At ψ = 2α",
            "the boundary is the formula, up to the order α³:",
        );
        least::where_it_is(p, formula, Rational::int(2))?;
        p.note(
            "So from every start there with A above the formula by more than Kα³",
            "the particle escapes",
        );
        Ok(())
    })
}

attempts![&LEAST, &SURFACE, &BOUNDARY];
