//! Theorems about every start close to α = 0: the surfaces of the resting places, and the boundary between rest and escape, with
//! what their expansions leave out.
//!
//! A surface A = P(α, ψ) that solves the equations of motion up to a residual is moved by ±αⁿ: it becomes a barrier that
//! motions cross in one direction only, if the residual is smaller than what the move brings.

use super::boundary::{self, imbalance};
use super::{least, surfaces};
use crate::claims::escape::exact::chains as fates;
use crate::claims::rest::prelude::*;

pub(crate) const SURFACE: Statement = Statement::shown(
    Corrected,
    r"for every $\sigma$ between 0 and 1 there are $\alpha_0>0$ and $K$, whose sizes are not computed, such that every start with $0<\alpha<\alpha_0$, whatever $\psi$ is, from which the particle comes to rest at $\sigma$ has an $A$ that differs from the corrected $A(\sigma,\alpha,\psi)$ by $K\alpha^3$ at most; and for each such $\alpha$ and each $\psi$ there is a start with rest at $\sigma$",
    surfaces::CORRECTED.formulas,
    surface,
);

pub(crate) const BOUNDARY: Statement = Statement::shown(
    Corrected,
    r"there are $\alpha_0>0$ and $K$, whose sizes are not computed, such that from every start with $0<\alpha<\alpha_0$, whatever $\psi$ is, the particle comes to rest if $A$ is below the corrected formula by more than $K\alpha^3$, and escapes if it is above by more; for each $\alpha$ and $\psi$ there is an $A$ between from which it comes to $\rho=1$: in a finite time only if $\psi\to\pi$",
    boundary::stated,
    rest_or_escape,
);

pub(crate) const LEAST: Statement = Statement::shown(
    Corrected,
    r"there are $\alpha_0>0$ and $K$, whose sizes are not computed, such that, with $0<\alpha<\alpha_0$, the particle comes to rest from every start with an $A$ below $1-\alpha+\frac76\alpha^2$ by more than $K\alpha^3$, whatever $\psi$ is, and escapes, if $\psi=2\alpha$, where $A$ is above by more",
    least::CORRECTED.formulas,
    lowest,
);

fn order(series: &Series, power: i64) -> Result<Rational, Obstacle> {
    series.coefficient(power).ok_or(Obstacle::Empty)
}

fn moved() -> Proof {
    let ring = || {
        let mut ring = Ring::of(["A", "P", "b", "d", "K", "s", "σ"]);
        ring.hyperbolic("α");
        ring.angle("ψ");
        Ok(ring)
    };
    Proof::in_ring("The distance of a motion from a barrier", ring(), |p| {
        p.shows("For u = A − P − s K α³, with P(α, ψ), K > 0 and s = 1 or s = −1: du/dτ = R + m (A − P) + 3s K α² f, R being the rate of A − P on the surface A = P. Here f = −dα/dτ is at least 1/A − 1; m is in the steps.");
        rest_on(
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
        rest_on(p, &[&turntable::EQ110, &super::EQ139])?;
        let small = Series::monomial(Rational::int(1), 1, boundary::ENOUGH);
        let a = p.expand("P", formula, &[("α", &small)], ("α", 2))?;
        let left = imbalance(p.ring(), &a)?;
        p.zero("R has no term of the order α^0", &order(&left, 0)?)?;
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
        let slope = p.ring().normal(&-&order(a, 1)?);
        let psi = symbol("ψ");
        let stated = p.read("(1 + cos ψ)/2", (1 + psi.cos()) / 2)?;
        p.equal("It is −b at α = 0", &slope, &stated)?;
        p.note(
            "Let K = 1 in u, and α₀ be so small that what is of the order of α^4 is below α³/4",
            "the K of the theorem is larger, by what P and the formula differ by, over α³",
        );
        above(p)?;
        below(p, formula)?;
        rest_on(p, &[&super::chains::DICHOTOMY])?;
        p.rests_on(&super::arrivals::settles())?;
        Ok(())
    })
}

/// Above the upper barrier a motion escapes.
fn above(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    rest_on(p, &[&fates::ESCAPES])?;
    p.note(
        "Let s = 1, and u > 0 at the start",
        "if A > 1, the motion escapes. While A ≤ 1, α falls, as f > 0; and while u > 0 too, A > P ≥ 1/2: outside du/dτ ≥ −C′αu + 3α² − (C + C′) α^4 ≥ −C′αu, inside du/dτ ≥ m (u + α³) − Cα^4 ≥ u/4",
    );
    Ok(())
}

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
    rest_on(p, &[&turntable::EQ110, &super::EQ139])?;
    p.rests_on(&fates::comes_to_rest(printed::eq139_largest_sigma()))?;
    p.rests_on(&lower_than_one(formula))?;
    p.note(
        "Let s = −1, and u < 0 at the start",
        "where A ≤ 1/2, u is negative if α₀ is small; where A ≥ 1/2, outside, du/dτ ≤ −C′αu + (C + C′) α^4 − 3α² ≤ −C′αu; inside, for every A < 1, du/dτ ≤ m (u − α³) + Cα^4 ≤ u/4. So u stays negative",
    );
    Ok(())
}

fn lowest(formula: Expr) -> Proof {
    let title = "Every start near α = 0, and where the boundary is lowest";
    Proof::in_ring(title, least::ring(), |p| {
        p.rests_on(&least::prove(formula))?;
        rest_on(p, &[&BOUNDARY])?;
        least::where_it_is(p, formula, Rational::int(2))?;
        Ok(())
    })
}

attempts![&LEAST, &SURFACE, &BOUNDARY];
