//! Any friction: (6) to (14), and the form of (11) that replaces it.

use super::{Newton, Regime, at_start, prove};
use crate::corrections;
use crate::paper::constant as paper;
use trialbook::claims::compare::where_defined;
use trialbook::prelude::*;

pub(super) fn eq6() -> Expr {
    let [lambda, a, theta] = Expr::symbols(["λ", "A", "θ"]);
    paper::eq6_vx_rate(lambda, a, theta)
}

pub(super) fn prove_eq6(printed: Expr) -> Proof {
    prove("(6): d(v cos θ)/dt", Regime::Any, |p, newton| {
        let [v, theta] = Expr::symbols(["v", "θ"]);
        let vx = p.read("The component along x", v * theta.cos())?;
        let rate = p.derivative("Its rate by (1)", &vx, &newton.motion)?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("Rate by (1) against printed rate", &rate, &printed)
    })
}

pub(super) fn eq7() -> Expr {
    let [lambda, a, theta] = Expr::symbols(["λ", "A", "θ"]);
    paper::eq7_vy_rate(lambda, a, theta)
}

pub(super) fn prove_eq7(printed: Expr) -> Proof {
    prove("(7): d(v sin θ)/dt", Regime::Any, |p, newton| {
        let [v, theta] = Expr::symbols(["v", "θ"]);
        let vy = p.read("The component along y", v * theta.sin())?;
        let rate = p.derivative("Its rate by (1)", &vy, &newton.motion)?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("Rate by (1) against printed rate", &rate, &printed)
    })
}

pub(super) fn eq8() -> Expr {
    let [lambda, theta] = Expr::symbols(["λ", "θ"]);
    paper::eq8_hodograph_slope(lambda, theta)
}

pub(super) fn prove_eq8(printed: Expr) -> Proof {
    prove("(8): d(v sin θ)/d(v cos θ)", Regime::Any, |p, newton| {
        let [v, theta] = Expr::symbols(["v", "θ"]);
        let [vx, vy] = [v * theta.cos(), v * theta.sin()].map(|c| newton.ring.read(c));
        let x = p.derivative("d(v cos θ)/dt by (1)", &vx?, &newton.motion)?;
        let y = p.derivative("d(v sin θ)/dt by (1)", &vy?, &newton.motion)?;
        let slope = p.quotient("Their quotient", &y, &x)?;
        let printed = p.read("The printed slope", printed)?;
        p.equal("Quotient against printed slope", &slope, &printed)
    })
}

pub(super) fn eq9() -> Expr {
    let [lambda, theta] = Expr::symbols(["λ", "θ"]);
    paper::eq9_log_speed_rate(lambda, theta)
}

/// d ln v/dθ by (1).
fn log_speed_rate(p: &mut Prover<'_>, newton: &Newton) -> Result<Rational, Obstacle> {
    let growth = newton.ring.divide(&newton.speed_rate, &newton.v)?;
    p.quotient("(dv/v)/dθ by (1)", &growth, &newton.angle_rate)
}

pub(super) fn prove_eq9(printed: Expr) -> Proof {
    prove("(9): (dv/v)/dθ", Regime::Any, |p, newton| {
        let rate = log_speed_rate(p, newton)?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("Rate by (1) against printed rate", &rate, &printed)
    })
}

pub(super) fn eq10() -> Expr {
    let [lambda, v, theta] = Expr::symbols(["λ", "v", "θ"]);
    paper::eq10_invariant(lambda, v, theta)
}

pub(super) fn constant_of_motion(
    p: &mut Prover<'_>,
    newton: &Newton,
    formula: Expr,
) -> Result<(), Obstacle> {
    let value = p.read("The printed expression", formula)?;
    let constant = value.generators().all(|g| {
        let own = Rational::generator(g);
        let rate = p.ring().derivative(&own, &newton.motion);
        where_defined(rate).is_some_and(|rate| rate.is_literally_zero())
    });
    if constant {
        // A number keeps its value along any motion: that would say nothing about this one.
        let normal_form = p.ring().text(&value);
        let says = "It must depend on the state of motion".into();
        return Err(Obstacle::NotZero { says, normal_form });
    }
    let rate = p.derivative("Its rate by (1)", &value, &newton.motion)?;
    p.zero("The rate", &rate)
}

pub(super) fn prove_eq10(printed: Expr) -> Proof {
    prove(
        "(10): an expression keeps its value",
        Regime::Any,
        |p, newton| constant_of_motion(p, newton, printed),
    )
}

pub(super) fn eq11() -> Expr {
    let [lambda, v0, theta0, theta] = Expr::symbols(["λ", "v₀", "θ₀", "θ"]);
    paper::eq11_speed(lambda, v0, theta0, theta)
}

pub(super) fn prove_eq11(printed: Expr) -> Proof {
    prove("(11): the speed at angle θ", Regime::Any, |p, newton| {
        let expected = log_speed_rate(p, newton)?;
        let speed = p.read("The printed speed", printed)?;
        let slope = p.slope("Its derivative with respect to θ", &speed, "θ")?;
        let rate = p.quotient("Divided by itself", &slope, &speed)?;
        p.equal("Against (dv/v)/dθ by (1)", &rate, &expected)?;
        let start = p.read("At θ = θ₀", at_start(printed))?;
        p.equal("Against v₀", &start, &p.ring().named("v₀")?)
    })
}

pub(super) fn eq12() -> Expr {
    let [lambda, v0, theta0, theta, d_power] = Expr::symbols(["λ", "v₀", "θ₀", "θ", "D"]);
    paper::eq12_time_rate(lambda, v0, theta0, theta, d_power)
}

pub(super) fn prove_eq12(printed: Expr) -> Proof {
    let title = "(12): A dt/dθ";
    let with_power = || {
        let mut newton = Newton::new(Regime::Any)?;
        let power = (Expr::symbol("θ") / Expr::int(2))
            .tan()
            .pow(Expr::symbol("λ"));
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
        p.rests_on(&prove_eq11(eq11()))?;
        let speed = p.read("The speed", eq11())?;
        let rate = newton.time_rate(&speed)? * p.ring().named("A")?;
        p.note("A dt/dθ by (1), with that speed", p.ring().text(&rate));
        p.read("D, the derivative of tan(θ/2)^λ", Expr::symbol("D"))?;
        let printed = p.read("The printed rate", printed)?;
        p.equal("Rate by (1) against printed rate", &rate, &printed)
    })
}

pub(super) fn eq13() -> Expr {
    let [lambda, a, v0, theta0, theta] = Expr::symbols(["λ", "A", "v₀", "θ₀", "θ"]);
    paper::eq13_time(lambda, a, v0, theta0, theta)
}

pub(super) fn prove_eq13(printed: Expr) -> Proof {
    prove("(13): the time at angle θ", Regime::Any, |p, newton| {
        p.rests_on(&prove_eq11(eq11()))?;
        let speed = p.read("The speed", eq11())?;
        let expected = newton.time_rate(&speed)?;
        p.note("dt/dθ by (1), with that speed", p.ring().text(&expected));
        let time = p.read("The printed time", printed)?;
        let rate = p.slope("Its derivative with respect to θ", &time, "θ")?;
        p.equal("Against dt/dθ by (1)", &rate, &expected)?;
        let start = p.read("At θ = θ₀", at_start(printed))?;
        p.zero("The printed time at the start", &start)
    })
}

pub(super) fn eq14() -> Expr {
    let [lambda, a, v0, theta0, theta, t] = Expr::symbols(["λ", "A", "v₀", "θ₀", "θ", "t"]);
    paper::eq14_speed_at_time(lambda, a, v0, theta0, theta, t)
}

pub(super) fn prove_eq14(printed: Expr) -> Proof {
    prove(
        "(14): the speed at angle θ and time t",
        Regime::Any,
        |p, _| {
            p.rests_on(&prove_eq11(eq11()))?;
            p.rests_on(&prove_eq13(eq13()))?;
            p.identity(
                (
                    "The printed speed, with t from (13)",
                    printed.with("t", eq13()),
                ),
                ("the speed by (11)", eq11()),
            )
        },
    )
}

pub(super) fn corrected_speed() -> Expr {
    let [lambda, v0, theta0, theta] = Expr::symbols(["λ", "v₀", "θ₀", "θ"]);
    let half_tan = |angle: Expr| (angle / Expr::int(2)).tan();
    corrections::constant::speed(lambda, v0, theta0, half_tan(theta) / half_tan(theta0))
}

pub(super) fn prove_corrected_speed(corrected: Expr) -> Proof {
    prove(
        "The speed in powers of r = tan(θ/2)/tan(θ₀/2)",
        Regime::Any,
        |p, newton| {
            let expected = log_speed_rate(p, newton)?;
            let speed = p.read("The speed", corrected)?;
            let slope = p.slope("Its derivative with respect to θ", &speed, "θ")?;
            let rate = p.quotient("Divided by itself", &slope, &speed)?;
            p.equal("Against (dv/v)/dθ by (1)", &rate, &expected)?;
            let start = p.read("At θ = θ₀", at_start(corrected))?;
            p.equal("Against v₀", &start, &p.ring().named("v₀")?)?;
            p.reads_as(&speed, "the speed by (11)", eq11())
        },
    )
}
