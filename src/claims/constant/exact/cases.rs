//! The special cases: λ = 0, (15) and (16); λ = 1, (17) to (19); λ > 1, (20).

use super::sliding::constant_of_motion;
use super::{EQ11, EQ13, EQ14, Newton, Regime, at_start, by_newton, prove};
use crate::claims::constant::prelude::*;
use crate::paper::constant as paper;

pub(super) fn eq15() -> Expr {
    let [a, v0x, t] = symbols(["A", "v₀x", "t"]);
    paper::eq15_vx(a, v0x, t)
}

/// A component of the velocity as a function of time: its rate by (1), and its value at the start.
fn component(
    p: &mut Prover<'_>,
    newton: &Newton,
    [component, printed]: [Expr; 2],
) -> Result<(), Obstacle> {
    let start = at_start(component).with("v", symbol("v₀"));
    let component = p.read("The component", component)?;
    let expected = p.derivative("Its rate by (1)", &component, &newton.motion)?;
    let value = p.read("As printed", printed)?;
    let rate = p.slope("The rate of that", &value, "t")?;
    p.equal("The rate by (1) is the printed one", &expected, &rate)?;
    let ring = p.ring();
    let first = ring.put(&value, &[(&ring.named("t")?, &Rational::int(0))])?;
    p.note("That at t = 0", ring.text(&first));
    let start = p.read("The component at the start", start)?;
    p.equal("It is the start", &first, &start)
}

/// λ = 1: the speed, after a proof that θ reaches 0 at no finite time.
pub(super) fn late_speed(p: &mut Prover<'_>, newton: &Newton) -> Result<Expr, Obstacle> {
    let [v0, theta0, theta, a] = symbols(["v₀", "θ₀", "θ", "A"]);
    rest_on(p, &[&EQ11])?;
    let speed = paper::eq11_speed::tree();
    let read = p.read("The speed by (11)", speed)?;
    let (half, half0) = (theta / 2, theta0 / 2);
    let r = half.tan() / half0.tan();
    let time =
        v0 / a * (half0.sin().squared() * (1 - r.squared()) / 2 - half0.cos().squared() * r.ln());
    let time = p.read("The time at angle θ is", time)?;
    let rate = p.slope("Its derivative", &time, "θ")?;
    p.equal("That is dt/dθ by (1)", &rate, &newton.time_rate(&read)?)?;
    Ok(speed)
}

/// λ = 1: the limit of a component of the velocity, which is the speed times a function of θ.
fn late_component(title: &str, name: &str, direction: Expr, printed: Expr) -> Proof {
    prove(title, Regime::One, |p, newton| {
        let speed = late_speed(p, newton)?;
        let component = p.read(name, speed * direction)?;
        let limit = newton.at_zero_angle(&component)?;
        p.note("For θ → 0", p.ring().text(&limit));
        p.reads_as(&limit, "the printed limit", printed)
    })
}

pub const EQ18: Statement = by_newton(Printed, paper::eq18_vx_limit::tree, |printed| {
    let title = "(18): v_x at large times, λ = 1";
    late_component(title, "v_x", symbol("θ").cos(), printed)
});

attempts![
    &EQ15 = by_newton(Printed, eq15, |printed| {
        prove("(15): v_x without friction", Regime::Zero, |p, newton| {
            let [v, theta] = symbols(["v", "θ"]);
            component(p, newton, [v * theta.cos(), printed])
        })
    }),
    &EQ16 = by_newton(Printed, paper::eq16_vy::tree, |printed| {
        prove("(16): v_y without friction", Regime::Zero, |p, newton| {
            let [v, theta] = symbols(["v", "θ"]);
            component(p, newton, [v * theta.sin(), printed])
        })
    }),
    &EQ17 = by_newton(Printed, paper::eq17_invariant::tree, |printed| {
        prove(
            "(17): an expression keeps its value, λ = 1",
            Regime::OneAnyAngle,
            |p, newton| constant_of_motion(p, newton, printed),
        )
    }),
    &EQ18,
    &EQ19 = by_newton(Printed, paper::eq19_vy_limit::tree, |printed| {
        let title = "(19): v_y at large times, λ = 1";
        late_component(title, "v_y", symbol("θ").sin(), printed)
    }),
    // v is a quotient by (14): what is above falls, to 0 at T, and what is below is positive.
    &EQ20 = by_newton(Printed, paper::eq20_stop_time::tree, |printed| {
        prove("(20): where (14) is 0", Regime::BeyondOne, |p, _| {
            rest_on(p, &[&EQ14])?;
            let [lambda, theta] = symbols(["λ", "θ"]);
            let below = p.read("λ + cos θ", lambda + theta.cos())?;
            p.positive("Below the line in (14)", &below)?;
            let speed = p.read("(14)", paper::eq14_speed_at_time::tree())?;
            let fall = p.slope("It changes with t by", &speed, "t")?;
            p.positive("Times −(λ + cos θ) that is", &-(&fall * &below))?;
            let stop = paper::eq14_speed_at_time::tree().with("t", printed);
            p.vanishes("(14) at the printed time", stop)
        })
    }),
    // The angle tends to 0 at the same time.
    &EQ20_WITHIN = by_newton(Within, paper::eq20_stop_time::tree, |printed| {
        prove(
            "(20): the time at which the particle stops",
            Regime::BeyondOne,
            |p, newton| {
                rest_on(p, &[&EQ11, &EQ13])?;
                let speed = p.read("The speed by (11)", paper::eq11_speed::tree())?;
                p.zero(
                    "For θ → 0 the speed goes to 0",
                    &newton.at_zero_angle(&speed)?,
                )?;
                let time = p.read("The time by (13)", paper::eq13_time::tree())?;
                let stop = newton.at_zero_angle(&time)?;
                p.note("For θ → 0", p.ring().text(&stop));
                p.reads_as(&stop, "the printed time", printed)
            },
        )
    }),
];
