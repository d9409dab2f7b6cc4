//! The special cases: λ = 0, (15) and (16); λ = 1, (17) to (19); λ > 1, (20).

use super::sliding::{constant_of_motion, eq11, eq13, prove_eq11, prove_eq13};
use super::{Newton, Regime, prove};
use crate::paper::constant as paper;
use trialbook::prelude::*;

pub(super) fn eq15() -> Expr {
    let [a, v0x, t] = Expr::symbols(["A", "v₀x", "t"]);
    paper::eq15_vx(a, v0x, t)
}

/// A component of the velocity as a function of time: its rate by (1), and its value at the start.
fn component(
    p: &mut Prover<'_>,
    newton: &Newton,
    [component, start, printed]: [Expr; 3],
) -> Result<(), Obstacle> {
    let component = p.read("The component", component)?;
    let expected = p.derivative("Its rate by (1)", &component, &newton.motion)?;
    let value = p.read("As printed", printed)?;
    let rate = p.slope("The rate of that", &value, "t")?;
    p.equal("Rate by (1) against printed rate", &expected, &rate)?;
    let at_start = p.read("At t = 0", printed.with("t", Expr::int(0)))?;
    p.equal("Against the start", &at_start, &p.ring().read(start)?)
}

pub(super) fn prove_eq15(printed: Expr) -> Proof {
    prove("(15): v_x without friction", Regime::Zero, |p, newton| {
        let [v, theta, start] = Expr::symbols(["v", "θ", "v₀x"]);
        component(p, newton, [v * theta.cos(), start, printed])
    })
}

pub(super) fn eq16() -> Expr {
    paper::eq16_vy(Expr::symbol("v₀y"))
}

pub(super) fn prove_eq16(printed: Expr) -> Proof {
    prove("(16): v_y without friction", Regime::Zero, |p, newton| {
        let [v, theta, start] = Expr::symbols(["v", "θ", "v₀y"]);
        component(p, newton, [v * theta.sin(), start, printed])
    })
}

pub(super) fn eq17() -> Expr {
    let [v, theta] = Expr::symbols(["v", "θ"]);
    paper::eq17_invariant(v, theta)
}

pub(super) fn prove_eq17(printed: Expr) -> Proof {
    prove(
        "(17): an expression keeps its value, λ = 1",
        Regime::One,
        |p, newton| constant_of_motion(p, newton, printed),
    )
}

pub(super) fn eq18() -> Expr {
    let [v0, theta0] = Expr::symbols(["v₀", "θ₀"]);
    paper::eq18_vx_limit(v0, theta0)
}

/// λ = 1: the speed, after a proof that θ reaches 0 at no finite time.
pub(super) fn late_speed(p: &mut Prover<'_>, newton: &Newton) -> Result<Expr, Obstacle> {
    let [lambda, v0, theta0, theta, a] = Expr::symbols(["λ", "v₀", "θ₀", "θ", "A"]);
    p.rests_on(&prove_eq11(eq11()))?;
    let speed = paper::eq11_speed(lambda, v0, theta0, theta);
    let read = p.read("The speed by (11)", speed)?;
    let two = Expr::int(2);
    let (half, half0) = (theta / two, theta0 / two);
    let r = half.tan() / half0.tan();
    let time = v0 / a
        * (half0.sin().squared() * (Expr::int(1) - r.squared()) / two
            - half0.cos().squared() * r.ln());
    let time = p.read("The time at angle θ is", time)?;
    let rate = p.slope("for its derivative", &time, "θ")?;
    p.equal("is dt/dθ by (1)", &rate, &newton.time_rate(&read)?)?;
    p.note(
        "For θ → 0 it grows beyond bounds",
        "−ln tan(θ/2) → ∞, all else stays finite",
    );
    Ok(speed)
}

pub(super) fn prove_eq18(printed: Expr) -> Proof {
    prove(
        "(18): v_x at large times, λ = 1",
        Regime::One,
        |p, newton| {
            let speed = late_speed(p, newton)?;
            let vx = p.read("v_x", speed * Expr::symbol("θ").cos())?;
            let limit = newton.at_zero_angle(&vx)?;
            p.note("For θ → 0", p.ring().text(&limit));
            p.reads_as(&limit, "the printed limit", printed)
        },
    )
}

pub(super) fn eq19() -> Expr {
    paper::eq19_vy_limit()
}

pub(super) fn prove_eq19(printed: Expr) -> Proof {
    prove(
        "(19): v_y at large times, λ = 1",
        Regime::One,
        |p, newton| {
            let speed = late_speed(p, newton)?;
            let vy = p.read("v_y", speed * Expr::symbol("θ").sin())?;
            let limit = newton.at_zero_angle(&vy)?;
            p.note("For θ → 0", p.ring().text(&limit));
            p.reads_as(&limit, "the printed limit", printed)
        },
    )
}

pub(super) fn eq20() -> Expr {
    let [lambda, a, v0, theta0] = Expr::symbols(["λ", "A", "v₀", "θ₀"]);
    paper::eq20_stop_time(lambda, a, v0, theta0)
}

pub(super) fn prove_eq20(printed: Expr) -> Proof {
    prove(
        "(20): the time at which the particle stops",
        Regime::BeyondOne,
        |p, newton| {
            p.rests_on(&prove_eq11(eq11()))?;
            p.rests_on(&prove_eq13(eq13()))?;
            let speed = p.read("The speed by (11)", eq11())?;
            p.zero("For θ → 0 the speed", &newton.at_zero_angle(&speed)?)?;
            let time = p.read("The time by (13)", eq13())?;
            let stop = newton.at_zero_angle(&time)?;
            p.note("For θ → 0", p.ring().text(&stop));
            p.reads_as(&stop, "the printed time", printed)
        },
    )
}
