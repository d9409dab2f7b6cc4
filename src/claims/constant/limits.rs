//! Trials of (15) to (20): no friction, critical friction, and the time of stopping.

use super::launches::{SETTLED, STOPS, STOPS_OVER_THE_ANGLE, frictionless};
use super::prelude::*;

fn flown((start, state): &(Turn, State)) -> String {
    format!("{}, t = {:.6}", start.at(), state.t)
}

fn start((start, _): &(Turn, State)) -> String {
    start.at()
}

/// Those that are not straight.
fn parabolas() -> impl Iterator<Item = Result<(Turn, State), Failure>> {
    only(frictionless(), |(start, _)| {
        libm::sin(start.theta0).abs() > 0.01
    })
}

fn eq20(start: &Turn) -> Double {
    let number = Double::from;
    let Turn {
        lambda,
        a,
        v0,
        theta0,
        ..
    } = *start;
    printed::eq20_stop_time(number(lambda), number(a), number(v0), number(theta0))
}

attempts![
    eq15_motion = Trial::motion(Printed, ["(15)", "$v_x$ of the motion without friction"]).each(
        frictionless(),
        flown,
        |(start, state)| {
            let stated = printed::eq15_vx(start.a, start.velocity0()?[0], state.t);
            Ok([stated, state.v[0], start.v0 + start.a * state.t])
        },
    ),
    eq16_motion = Trial::motion(Printed, ["(16)", "$v_y$ of the motion without friction"]).each(
        frictionless(),
        flown,
        |(start, state)| {
            Ok([
                printed::eq16_vy(start.velocity0()?[1]),
                state.v[1],
                start.v0,
            ])
        },
    ),
    eq17_motion = Trial::motion(
        Printed,
        [
            r"(17) at $\theta$ over (17) at $\theta_0$, along the motion,",
            "1",
        ],
    )
    .over(
        super::launches::critical_turns(),
        |turn: Result<Turn, _>| {
            let turn = turn?;
            let number = Double::from;
            let at = |v, theta| printed::eq17_invariant(number(v), number(theta));
            let ratio = at(turn.v, turn.theta) / at(turn.v0, turn.theta0);
            Ok(Pair::wide(turn.at(), ratio, 1.0).within(turn.condition()))
        },
    ),
    eq18_limit = Trial::by(
        Limit,
        Printed,
        ["(18)", "$v_x$ of the motion at 40 times $v_0/A$"],
        TERMINAL,
    )
    .each(SETTLED.each(), start, |(start, state)| {
        Ok([
            printed::eq18_vx_limit(start.v0, start.theta0),
            state.v[0],
            start.v0,
        ])
    }),
    eq18_quadrature = {
        // Nearer to π, where the tangent is infinite, the integral itself loses its digits.
        let gentle = only(SETTLED.each(), |(start, _)| start.is_gentle());
        Trial::quadrature(
            Printed,
            [
                "(18)",
                r"$v_0\exp\int\mathrm dv/v$ over the angle, along and across the velocity",
            ],
        )
        .each(gentle, start, |(start, _)| {
            Ok([
                printed::eq18_vx_limit(start.v0, start.theta0),
                start.last_speed_over_the_angle()?,
                start.v0,
            ])
        })
    },
    eq19_limit = Trial::by(
        Limit,
        Printed,
        ["(19)", "$v_y$ of the motion at 40 times $v_0/A$"],
        TERMINAL,
    )
    .each(SETTLED.each(), start, |(start, state)| {
        Ok([printed::eq19_vy_limit(), state.v[1], start.v0])
    }),
    eq20_motion = Trial::motion(Printed, ["(20)", "the time at which the motion stops"]).over(
        STOPS.each(),
        |stop| {
            let stop = stop?;
            let lambda = stop.start.lambda;
            // The motion knows λA − A to a rounding of λA.
            let scale = stop.t * lambda / (lambda - 1.0);
            let pair = Pair::wide(stop.start.at(), eq20(&stop.start), stop.t);
            Ok(pair.within(scale))
        },
    ),
    eq20_quadrature = Trial::quadrature(
        Printed,
        [
            "(20)",
            r"$\int\mathrm dt$ over the angle, along and across the velocity",
        ],
    )
    .over(STOPS_OVER_THE_ANGLE.each(), |stop| {
        let (start, time) = stop?;
        // ln v falls by λ − 1 per unit of ln tan(θ/2), and the errors of the integrator grow with it.
        Ok(Pair::wide(start.at(), eq20(start), *time).within(time * start.lambda))
    }),
    // The parabola: v_y² x − v_y v_0x y − A y²/2 vanishes along the path, the time being eliminated.
    parabola_motion = Trial::motion(
        Printed,
        [
            "$x(y)$ of the path without friction",
            "the parabola through the launch",
        ],
    )
    .each(parabolas(), flown, |(start, state)| {
        let [vx, vy] = start.velocity0()?;
        Ok([
            printed::s21_parabola(start.a, vx, vy, state.x[1]),
            state.x[0],
            (start.v0 + 0.5 * start.a * state.t) * state.t * (start.v0 / vy).abs(),
        ])
    }),
    parabola_quadrature = Trial::quadrature(
        Printed,
        [
            r"$\int v_x\,\mathrm dy/v_y$, with (15) and (16), over the path",
            "its $x$",
        ],
    )
    .each(parabolas(), flown, |(start, state)| {
        let [vx, vy] = start.velocity0()?;
        let scale = (start.v0 + start.a * state.t) * state.t * (start.v0 / vy).abs();
        let slope = |y: f64| printed::eq15_vx(start.a, vx, y / vy) / printed::eq16_vy(vy);
        Ok([
            sum(slope, 0.0, state.x[1], 1e-13 * scale),
            state.x[0],
            scale,
        ])
    })
];
