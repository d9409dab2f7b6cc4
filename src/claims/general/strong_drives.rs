//! Theorems about drives that exceed the friction: that no rest lasts, and that the speed grows in the end if the
//! direction is fixed.

use super::prelude::*;
use super::two_frames::{eq2, eq2_proof, ring};

pub(crate) const MOVES: Statement = Statement::shown(
    Within,
    r"at rest friction has to balance $-\bm A$, and can give $\mu g$ at most: for every $\bm A$ the lack $\lvert\bm A\rvert-\mu g$ is positive exactly where $\lvert\bm A\rvert$ exceeds the stated bound, so that no rest outlasts the beginning of a stretch of time on which it does",
    printed::s2_rest_ends_above::tree,
    moves,
);

fn moves(bound: Expr) -> Proof {
    let ring = || {
        let mut ring = Ring::new();
        let [_, _, ax, ay] = ring.symbols(["μ", "g", "A_x", "A_y"]);
        ring.root(&(ax.pow(2) + ay.pow(2)), 2)?;
        Ok(ring)
    };
    Proof::in_ring("A strong drive ends every rest", ring(), |p| {
        let [ax, ay, mu, g, ..] = NAMES.map(symbol);
        let size = (ax.squared() + ay.squared()).sqrt();
        let needed = p.read("Its size squared", size.squared())?;
        let components = p.ring().read(ax.squared() + ay.squared())?;
        p.equal(
            "It is the squares of the components, added",
            &needed,
            &components,
        )?;
        p.identity(
            ("What is needed less the greatest friction", size - mu * g),
            (
                "what the size of the drive is above the stated bound",
                size - bound,
            ),
        )?;
        Ok(())
    })
}

/// The ring of the law, with the margin δ and what the drive has beyond it, e.
pub(in crate::claims) fn with_margin() -> Result<Ring, ExactError> {
    let mut ring = ring()?;
    ring.symbols(["δ", "e"]);
    Ok(ring)
}

pub(in crate::claims) fn speeds_up((bound, law, speed_rate): (Expr, [Expr; 2], Expr)) -> Proof {
    Proof::in_ring(
        "A strong drive speeds the particle up",
        with_margin(),
        |p| {
            p.rests_on(&eq1_proof(law))?;
            p.rests_on(&eq2_proof(speed_rate))?;
            let [_, _, mu, g, vx, vy] = NAMES.map(symbol);
            let [margin, more] = symbols(["δ", "e"]);
            let speed = (vx.squared() + vy.squared()).sqrt();
            let (cosine, most) = (vx / speed, mu * g);
            let pull = bound + margin + more;
            let driven = |rate: Expr| rate.with("A_x", -pull).with("A_y", int(0));

            let along = p.read("dv_x/dt by (1)", driven(law[0]))?;
            let terms = margin + more + most * (1 - cosine);
            p.reads_as(&along, "of which no term is negative", terms)?;

            let across = p.read("dv_y/dt by (1)", driven(law[1]))?;
            let motion = p.ring().along(&[("v_x", along), ("v_y", across)])?;
            let square = p.read("The square of v_y", vy.squared())?;
            let fall = p.derivative("Its rate", &square, &motion)?;
            let lost = -(2 * most * vy.squared() / speed);
            p.reads_as(&fall, "which is not positive", lost)?;

            let direction = p.read("v_x/v", cosine)?;
            let turn = p.derivative("Its rate", &direction, &motion)?;
            p.reads_as(
                &turn,
                "which is not negative",
                pull * vy.squared() / speed.pow(int(3)),
            )?;
            let enough = most / (most + margin);
            let least = cosine.squared() - enough.squared();
            let room = vx.squared() * (1 - enough.squared()) - enough.squared() * vy.squared();
            p.identity(("(v_x/v)² less the square of μg/(μg + δ)", least), ("positive from some time on, as v_x grows beyond all bounds, v_y does not and μg/(μg + δ) < 1", room / speed.squared()))?;

            let terms = (most + margin) * (cosine - enough) + more * cosine;
            p.identity(
                ("dv/dt by (2)", driven(speed_rate)),
                (
                    "the first term positive and the other not negative from that time on",
                    terms,
                ),
            )?;
            Ok(())
        },
    )
}

attempts![
    &MOVES,
    &SPEEDS_UP = Statement::shown(
        Within,
        r"with $\bm A=-a\,\hat{\bm x}$ and $a\ge\mu g+\delta$, $\delta>0$, at all times, from every start: by (1) $\mathrm dv_x/\mathrm dt\ge\delta$, $v_y^2$ never grows, and $v_x/v$ never falls; it comes above $\mu g/(\mu g+\delta)$ and stays there, and by (2) $\mathrm dv/\mathrm dt>0$ from then on",
        || {
            let bound = printed::s2_speeds_up_above::tree();
            (bound, eq1(), eq2())
        },
        speeds_up
    )
];
