//! Theorems about every acceleration of the plane, as chains of inequalities: each link is an identity of the ring, with 𝐀 any
//! vector at that instant, and a term that has a sign.

use super::prelude::*;
use super::two_frames::{eq2, eq2_proof, ring};

pub(crate) const STOPS: Statement = Statement::shown(
    Printed,
    r"with $\lvert\bm A\rvert\le a<\mu g$, (2) gives $\mathrm dv/\mathrm dt\le a-\mu g<0$, so that the particle is at rest after $v_0/(\mu g-a)$ at the latest, and stays: static friction holds it",
    eq2,
    stops,
);

pub(crate) const ACROSS: Statement<([Expr; 2], [Expr; 2])> = Statement::shown(
    Within,
    r"with $\bm A$ along $x$ and $\mu>0$, (1) gives $v_y^2$ the rate $-2\mu g\,v_y^2/v$; with $\lvert\bm A\rvert\le a$ as well, $v\le v_0+at$, and $v_y^2\,(v_0+at)^{2\mu g/a}$ never grows, so that $v_y\to0$",
    || {
        let said = [printed::s2_across_trend(), printed::s2_across_limit()];
        (eq1(), said)
    },
    across,
);

/// The ring of the law, with a bound a of |𝐀|, the speed v₀ at the beginning, and the time.
fn with_bound() -> Result<Ring, ExactError> {
    let mut ring = ring()?;
    ring.symbols(["a", "v₀", "t", "C", "ε"]);
    Ok(ring)
}

/// −𝐀·𝐯/v ≤ |𝐀|, by Lagrange's identity.
pub(in crate::claims) fn at_most_its_size(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    let [ax, ay, _, _, vx, vy] = NAMES.map(symbol);
    let sizes = (ax.squared() + ay.squared()) * (vx.squared() + vy.squared());
    let rest = sizes - (ax * vx + ay * vy).squared();
    p.identity(
        (
            "A²v² less the squared scalar product, with A for the size of the acceleration",
            rest,
        ),
        (
            "a square, so that the component along the velocity is A at most",
            (ax * vy - ay * vx).squared(),
        ),
    )
}

pub(in crate::claims) fn stops(formula: Expr) -> Proof {
    Proof::in_ring("A weak drive lets the particle stop", with_bound(), |p| {
        p.rests_on(&eq2_proof(formula))?;
        let [ax, ay, mu, g, vx, vy] = NAMES.map(symbol);
        let [a, v0, t] = symbols(["a", "v₀", "t"]);
        let rate = p.read("dv/dt by (2)", formula)?;
        let speed = (vx.squared() + vy.squared()).sqrt();
        let above = p.read("a − μg less that", a - mu * g)? - &rate;
        p.reads_as(
            &above,
            "a and the part of the acceleration along the velocity",
            a + (ax * vx + ay * vy) / speed,
        )?;
        at_most_its_size(p)?;
        let bound = v0 - (mu * g - a) * t;
        let line = p.read("The line v₀ − (μg − a) t", bound)?;
        let slope = p.slope("Its rate", &line, "t")?;
        p.reads_as(&slope, "", a - mu * g)?;
        p.vanishes(
            "At t = v₀/(μg − a) it is",
            bound.with("t", v0 / (mu * g - a)),
        )?;
        Ok(())
    })
}

/// The ring of a coefficient μ that may change with the direction of the velocity, and of its least value.
pub(in crate::claims) fn ring_across(least: Expr) -> Result<Ring, ExactError> {
    let mut ring = with_bound()?;
    let [a, v0, t, g] = symbols(["a", "v₀", "t", "g"]);
    ring.symbol("m");
    let base = ring.read(v0 + a * t)?;
    let exponent = ring.read(2 * least * g / a)?;
    ring.power(&base, &exponent)?;
    Ok(ring)
}

/// That v_y, of which (1) as given says the rate, decays under a drive along x of the size a at most, with a coefficient of the
/// value `least` at least. `trend` is the sign of its rate as stated, and `limit` that to which it tends.
pub(in crate::claims) fn decays(
    p: &mut Prover<'_>,
    law: [Expr; 2],
    least: Expr,
    [trend, limit]: [Expr; 2],
) -> Result<(), Obstacle> {
    p.rests_on(&eq1_proof(law))?;
    let [_, _, mu, g, vx, vy] = NAMES.map(symbol);
    let [a, v0, t] = symbols(["a", "v₀", "t"]);
    let along = law.map(|rate| rate.with("A_y", int(0)));
    let speed = (vx.squared() + vy.squared()).sqrt();
    let rate = p.read("dv_y/dt by (1), with an acceleration along x", along[1])?;
    let motion = p.ring().along(&[("v_y", rate.clone())])?;
    let square = p.read("The square of v_y", vy.squared())?;
    let fall = p.derivative("Its rate", &square, &motion)?;
    let stated = trend * (2 * mu * g * vy.squared() / speed);
    p.reads_as(&fall, "which is not positive", stated)?;
    at_most_its_size(p)?;
    let base = v0 + a * t;
    let weight = base.pow(2 * least * g / a);
    let weighted = p.read("v_y² times a growing weight", vy.squared() * weight)?;
    let motion = p.ring().along(&[("v_y", rate), ("t", Rational::int(1))])?;
    let growth = p.derivative("Its rate", &weighted, &motion)?;
    let excess = least * (1 / speed - 1 / base);
    let factor = match mu == least {
        true => p.read("Not negative, as v is not above v₀ + a t", excess)?,
        false => p.read(
            "Terms of which none is negative, as friction is not below its least value and v not above v₀ + a t",
            (mu - least) / speed + excess,
        )?,
    };
    let lost = p.ring().read(-(2 * g))? * &factor * &weighted;
    p.equal(
        "The rate is −2g times this, times the weighted square",
        &growth,
        &lost,
    )?;
    let [c, small] = symbols(["C", "ε"]);
    let bound = p.read("The bound", c * small)?;
    let small = p.ring().read(small)?;
    let late = p.ring().put(&bound, &[(&small, &Rational::int(0))])?;
    let limit = p.read("The square of what v_y is said to tend to", limit.squared())?;
    p.equal("It is the bound at ε = 0", &limit, &late)
}

fn across((law, said): ([Expr; 2], [Expr; 2])) -> Proof {
    let mu = symbol("μ");
    Proof::in_ring(
        "The velocity across the drive decays",
        ring_across(mu),
        |p| decays(p, law, mu, said),
    )
}

attempts![&STOPS, &ACROSS];
