//! Any friction: (6) to (14).

use super::{Newton, Regime, at_start, by_newton, prove};
use crate::claims::constant::prelude::*;
use crate::paper::constant as paper;

fn component_rate(title: &str, says: &str, component: Expr, printed: Expr) -> Proof {
    prove(title, Regime::AnyAngle, |p, newton| {
        let component = p.read(says, component)?;
        let rate = p.derivative("Its rate by (1)", &component, &newton.motion)?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("The rate by (1) is the printed one", &rate, &printed)
    })
}

pub(crate) const EQ6: Statement = by_newton(Printed, paper::eq6_vx_rate::tree, |printed| {
    let along = symbol("v") * symbol("θ").cos();
    component_rate(
        "(6): d(v cos θ)/dt",
        "The component along x",
        along,
        printed,
    )
});

pub(crate) const EQ7: Statement = by_newton(Printed, paper::eq7_vy_rate::tree, |printed| {
    let across = symbol("v") * symbol("θ").sin();
    component_rate(
        "(7): d(v sin θ)/dt",
        "The component along y",
        across,
        printed,
    )
});

/// d ln v/dθ by (1).
fn log_speed_rate(p: &mut Prover<'_>, newton: &Newton) -> Result<Rational, Obstacle> {
    let growth = newton.ring.divide(&newton.speed_rate, &newton.v)?;
    p.quotient("(dv/v)/dθ by (1)", &growth, &newton.angle_rate)
}

pub(crate) const EQ9: Statement = by_newton(Within, paper::eq9_log_speed_rate::tree, |printed| {
    prove("(9): (dv/v)/dθ", Regime::AnyAngle, |p, newton| {
        let rate = log_speed_rate(p, newton)?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("The rate by (1) is the printed one", &rate, &printed)
    })
});

pub(super) fn constant_of_motion(
    p: &mut Prover<'_>,
    newton: &Newton,
    formula: Expr,
) -> Result<(), Obstacle> {
    let value = p.read("The printed expression", formula)?;
    p.constant(&value, &newton.motion)
}

/// A proof with powers of the quotient of tan(θ/2) and tan(θ₀/2), for positive angles and for negative ones.
pub(super) fn at_both_sides(
    title: &str,
    steps: impl Fn(&mut Prover<'_>, &Newton) -> Result<(), Obstacle>,
) -> Proof {
    Proof::for_both_signs(|sign| {
        prove(title, Regime::Any(sign), |p, newton| {
            p.note("The sign of both angles", sign.to_string());
            steps(p, newton)
        })
    })
}

pub const EQ11: Statement = by_newton(Within, paper::eq11_speed::tree, |printed| {
    at_both_sides("(11): the speed at angle θ", |p, newton| {
        let expected = log_speed_rate(p, newton)?;
        let speed = p.read("The printed speed", printed)?;
        let slope = p.slope("Its derivative with respect to θ", &speed, "θ")?;
        let rate = p.quotient("Divided by itself", &slope, &speed)?;
        p.equal("It is (dv/v)/dθ by (1)", &rate, &expected)?;
        let start = p.read("At θ = θ₀", at_start(printed))?;
        p.equal("It is v₀", &start, &p.ring().named("v₀")?)
    })
});

pub(super) fn eq12() -> Expr {
    let [lambda, v0, theta0, theta, d_power] = symbols(["λ", "v₀", "θ₀", "θ", "D"]);
    paper::eq12_time_rate(lambda, v0, theta0, theta, d_power)
}

pub const EQ12: Statement = by_newton(Within, eq12, |printed| {
    let title = "(12): A dt/dθ";
    let with_power = || {
        let mut newton = Newton::new(Regime::Any(1))?;
        let power = (symbol("θ") / 2).tan().pow(symbol("λ"));
        let power = newton.ring.read(power)?;
        let slope = newton.ring.derivative(&power, &newton.ring.by("θ")?)?;
        newton.ring.define("D", slope)?;
        Ok(newton)
    };
    let newton = match with_power() {
        Ok(newton) => newton,
        Err(error) => return Proof::impossible(title, error),
    };
    Proof::of(title, &newton.ring, |p| {
        rest_on(p, &[&EQ11])?;
        let speed = p.read("The speed", paper::eq11_speed::tree())?;
        let rate = newton.time_rate(&speed)? * p.ring().named("A")?;
        p.note("A dt/dθ by (1), with that speed", p.ring().text(&rate));
        p.read("D, the derivative of tan(θ/2)^λ", symbol("D"))?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("The rate by (1) is the printed one", &rate, &printed)
    })
});

pub const EQ13: Statement = by_newton(Within, paper::eq13_time::tree, |printed| {
    at_both_sides("(13): the time at angle θ", |p, newton| {
        rest_on(p, &[&EQ11])?;
        let speed = p.read("The speed", paper::eq11_speed::tree())?;
        let expected = newton.time_rate(&speed)?;
        p.note("dt/dθ by (1), with that speed", p.ring().text(&expected));
        let time = p.read("The printed time", printed)?;
        let rate = p.slope("Its derivative with respect to θ", &time, "θ")?;
        p.equal("It is dt/dθ by (1)", &rate, &expected)?;
        let start = p.read("At θ = θ₀", at_start(printed))?;
        p.zero("The printed time is 0 at the start", &start)
    })
});

pub const EQ14: Statement = by_newton(Within, paper::eq14_speed_at_time::tree, |printed| {
    let title = "(14): the speed at angle θ and time t";
    prove(title, Regime::AnyAngle, |p, newton| {
        let [v, v0, lambda, theta] = symbols(["v", "v₀", "λ", "θ"]);
        let weight = lambda + theta.cos();
        let sum = p.read("λv + v_x", v * weight)?;
        let rate = p.derivative("Its rate by (1)", &sum, &newton.motion)?;
        let weight = p.ring().read(weight)?;
        let printed = p.read("The printed speed", printed)? * weight;
        let linear = p.slope("Times λ + cos θ it has the rate", &printed, "t")?;
        p.equal("The two rates", &rate, &linear)?;
        let t = p.ring().named("t")?;
        let first = p.ring().put(&printed, &[(&t, &Rational::int(0))])?;
        p.note("That product at t = 0", p.ring().text(&first));
        let start = p.read("λv + v_x at the start", v0 * at_start(lambda + theta.cos()))?;
        p.equal("The two", &first, &start)
    })
});

attempts![
    &EQ6,
    &EQ7,
    &EQ8 = by_newton(Printed, paper::eq8_hodograph_slope::tree, |printed| {
        prove(
            "(8): d(v sin θ)/d(v cos θ)",
            Regime::AnyAngle,
            |p, newton| {
                let [v, theta] = symbols(["v", "θ"]);
                let [vx, vy] = [v * theta.cos(), v * theta.sin()].map(|c| newton.ring.read(c));
                let x = p.derivative("d(v cos θ)/dt by (1)", &vx?, &newton.motion)?;
                let y = p.derivative("d(v sin θ)/dt by (1)", &vy?, &newton.motion)?;
                let slope = p.quotient("Their quotient", &y, &x)?;
                let printed = p.read("The printed slope", printed)?;
                p.equal("The quotient is the printed slope", &slope, &printed)
            },
        )
    }),
    &EQ9,
    &EQ10 = by_newton(Within, paper::eq10_invariant::tree, |printed| {
        prove(
            "(10): an expression keeps its value",
            Regime::Any(1),
            |p, newton| constant_of_motion(p, newton, printed),
        )
    }),
    &EQ11,
    &EQ12,
    &EQ13,
    &EQ14,
];
