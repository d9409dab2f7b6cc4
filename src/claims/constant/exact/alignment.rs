//! Small friction, λ ≤ 1: it cannot hold the particle, and the velocity aligns with the pull.

use super::cases::late_speed;
use super::{DEFINED, EQ6, EQ7, Regime, prove};
use crate::claims::constant::prelude::*;
use crate::paper::constant as paper;

/// λ ≤ 1: v_x grows for ever, or, at λ = 1, the angle falls below every other.
pub(crate) const ALIGNS: Statement<([Expr; 2], Expr)> = Statement::shown(
    Within,
    r"for every $\lambda<1$ and every start $v_x$ grows by $A(1-\lambda)$ in each unit of time at least and $v_y^2$ never grows, so that $\tan\theta=v_y/v_x\to0$; for $\lambda=1$ and $\theta_0\neq\pi$ the time at which the velocity has the angle $\theta$ is finite for every $\theta$ between $\theta_0$ and 0, and beyond all bounds as $\theta\to0$",
    || {
        let sides = paper::s21_keeps_moving_sides::tree();
        (sides, paper::s21_late_angle())
    },
    aligns,
);

fn aligns(([left, right], angle): ([Expr; 2], Expr)) -> Proof {
    prove("The velocity aligns", Regime::AnyAngle, |p, newton| {
        rest_on(p, &[&EQ6, &EQ7])?;
        p.rests_on(&at_the_border())?;
        let [a, lambda, v, theta] = symbols(["A", "λ", "v", "θ"]);
        let [vx, vy] = [v * theta.cos(), v * theta.sin()];
        let terms = a * (right - left) + a * lambda * (1 - theta.cos());
        p.identity(
            ("(6)", paper::eq6_vx_rate::tree()),
            (
                "A times the right side less the left one, and what is not negative",
                terms,
            ),
        )?;
        let square = p.read("The square of v_y", vy.squared())?;
        let fall = p.derivative("Its rate", &square, &newton.motion)?;
        p.reads_as(&fall, "by (7)", 2 * vy * paper::eq7_vy_rate::tree())?;
        let lost = 2 * a * lambda * v * theta.sin().squared();
        let lost = p.read("2Aλ v sin²θ, which is not negative", lost)?;
        p.equal("The rate is less than 0 by that", &-&fall, &lost)?;
        p.identity(("tan θ", theta.tan()), ("", vy / vx))?;
        p.vanishes("tan θ → 0 with v_x > 0; the stated angle", angle)
    })
}

/// λ = 1, from 0 < θ₀ < π; from θ₀ < 0 the mirror, and at θ₀ = 0 nothing changes.
fn at_the_border() -> Proof {
    prove("The velocity aligns at λ = 1", Regime::One, |p, newton| {
        p.shows("For λ = 1 and 0 < θ₀ < π the angle θ of the velocity with the x axis falls all the time, to 0 as t → ∞.");
        late_speed(p, newton)?;
        let [a, v, theta] = symbols(["A", "v", "θ"]);
        let falls = p.read("A sin θ/v, which is positive", a * theta.sin() / v)?;
        p.equal("dθ/dt is less than 0 by that", &-&newton.angle_rate, &falls)?;
        Ok(())
    })
}

/// In the end the particle slides against the plane's acceleration.
pub(crate) const AGAINST: Statement<(Expr, [Expr; 2])> = Statement::shown(
    Corrected,
    r"for every $\lambda\le1$, but for $\lambda=1$ with $\theta_0=\pi$: by (3) the cosine of the angle between $\bm v$ and $\bm A$ is $-\cos\theta$, and $\theta\to0$ is proved",
    || {
        let drive = paper::eq3_acceleration::tree();
        (corrected::late_sense(), drive)
    },
    against,
);

fn against((sense, [ax, ay]): (Expr, [Expr; 2])) -> Proof {
    prove("Which way it slides", Regime::AnyAngle, |p, _| {
        rest_on(p, &[&ALIGNS])?;
        let [a, v, theta] = symbols(["A", "v", "θ"]);
        let product = v * theta.cos() * ax + v * theta.sin() * ay;
        p.identity(
            ("The cosine of the angle between the two", product / (v * a)),
            ("", -theta.cos()),
        )?;
        p.identity(
            ("It at θ = 0", (product / (v * a)).with("θ", int(0))),
            ("the stated sense", sense),
        )
    })
}

attempts![
    &CANNOT_HOLD = Statement::shown(
        Within,
        r"at rest friction has to balance the pull $A$ and can give $\mu g=\lambda A$ at most: for every $\lambda<1$ it lacks $A(1-\lambda)>0$, and at this rate a particle begins to move, by (6) at $\theta=0$",
        paper::s21_cannot_hold_sides::tree,
        |[left, right]| {
            prove("Friction cannot hold", Regime::AnyAngle, |p, _| {
                rest_on(p, &[&DEFINED, &EQ6])?;
                let [a, lambda] = symbols(["A", "λ"]);
                p.note("μg by (5)", "λA");
                let lack = p.read("The pull less the greatest friction", a - lambda * a)?;
                p.reads_as(
                    &lack,
                    "A times the right side less the left one",
                    a * (right - left),
                )?;
                let begins =
                    p.read("(6) at θ = 0", paper::eq6_vx_rate::tree().with("θ", int(0)))?;
                p.equal("The rate from rest is that too", &begins, &lack)
            })
        },
    ),
    &ALIGNS,
    &AGAINST,
];
