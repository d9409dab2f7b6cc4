//! Trials of (6) to (11): the two components of Newton's law, the hodograph's slope, the speed against the
//! angle.

use super::launches::{straight, turns_where};
use super::prelude::*;

/// What is read from a turn: stated, found, and the scale in units of A (1 + λ).
type Reading = fn(&Turn) -> [f64; 3];

fn rates(compared: Compared, reading: Reading) -> Evidence {
    // Later, the time itself is too coarse for differences.
    let turning = turns_where(|turn| turn.v > 0.01 * turn.v0).map(|turn| turn.copied());
    Trial::by(Integration, Printed, compared, DIFFERENCES).each(
        turning.chain(straight()),
        Turn::at,
        |turn| {
            let [stated, found, scale] = reading(turn);
            Ok([stated, found, scale * turn.a * (1.0 + turn.lambda)])
        },
    )
}

fn eq10(subject: Subject, wanted: fn(&Turn) -> bool) -> Evidence {
    Trial::motion(
        subject,
        [
            r"(10) at $\theta$ over (10) at $\theta_0$, along the motion,",
            "1",
        ],
    )
    .over(turns_where(wanted), |turn| {
        let turn = turn?;
        let number = Double::from;
        let at = |v, theta| printed::eq10_invariant(number(turn.lambda), number(v), number(theta));
        let ratio = at(turn.v, turn.theta) / at(turn.v0, turn.theta0);
        Ok(Pair::wide(turn.at(), ratio, 1.0).within(turn.condition()))
    })
}

attempts![
    eq6_motion = rates(
        Compared::one("(6)", r"$\mathrm dv_x/\mathrm dt$ of the motion"),
        |turn| {
            let rate = printed::eq6_vx_rate(turn.lambda, turn.a, turn.theta);
            [rate, turn.rate[0], 1.0]
        },
    ),
    eq7_motion = rates(
        Compared::one("(7)", r"$\mathrm dv_y/\mathrm dt$ of the motion"),
        |turn| {
            let rate = printed::eq7_vy_rate(turn.lambda, turn.a, turn.theta);
            [rate, turn.rate[1], 1.0]
        },
    ),
    // (8) with the motion, as an angle, so that an infinite slope is one like any other.
    eq8_motion = rates(
        Compared::one(
            "the angle whose tangent is (8)",
            r"that of $(\mathrm dv_x,\mathrm dv_y)$ of the motion, up to half turns",
        ),
        |turn| {
            let slope = printed::eq8_hodograph_slope(turn.lambda, turn.theta);
            let [x, y] = turn.rate;
            let found = libm::atan2(y, x);
            let off = libm::remainder(libm::atan(slope) - found, std::f64::consts::PI);
            [found + off, found, 1.0 / libm::hypot(x, y)]
        }
    ),
    // (8) where the velocity stays as it is.
    eq8_outside = {
        let compared = Compared::one(
            r"(8) at $\lambda=1$, $\theta=0$",
            "the change of the velocity in half a unit of time",
        );
        Trial::motion(Outside, compared).drawn(0..20, |_, points| {
            let (a, v0) = (points.uniform(0.5, 2.0), points.uniform(0.5, 2.0));
            let launch = Turn::launch(1.0, a, v0, 0.0);
            let end = launch.motion(0.5)?.at(0.5)?;
            Ok(Pair::plain(
                launch.at(),
                printed::eq8_hodograph_slope(1.0, 0.0),
                libm::hypot(end.v[0] - v0, end.v[1]),
            ))
        })
    },
    eq9_quadrature = Trial::quadrature(
        Within,
        [
            r"the exponential of the integral of (9) over $\theta$",
            "$v/v_0$ of the motion",
        ],
    )
    .each(turns_where(Turn::is_gentle), Turn::at, |turn| {
        let rate = |theta| printed::eq9_log_speed_rate(turn.lambda, theta);
        let log_ratio = turn.integral(rate, 1e-13 * turn.condition());
        let found = turn.v / turn.v0;
        Ok([
            libm::exp(log_ratio.unwrap_or(f64::NAN)),
            found,
            found * turn.condition(),
        ])
    }),
    // (9) where dθ = 0 all the way, although the speed changes.
    eq9_outside = Trial::motion(
        Outside,
        [
            r"the exponential of (9) with $\mathrm d\theta=0$",
            "$v/v_0$ of the motion half a unit of time after the launch",
        ],
    )
    .each(straight(), Turn::at, |turn| {
        let found = turn.v / turn.v0;
        let exponent =
            printed::eq9_log_speed_rate(turn.lambda, turn.theta) * (turn.theta - turn.theta0);
        Ok([libm::exp(exponent), found, found])
    }),
    eq10_motion = eq10(Within, |turn| turn.theta0 > 0.0),
    eq10_outside = eq10(Outside, |turn| { turn.theta0 < 0.0 && turn.lambda > 0.0 }),
    eq11_motion = Trial::motion(
        Within,
        [
            "(11)",
            r"the speed of the motion when it has turned to $\theta$",
        ],
    )
    .over(TURNS.each(), |turn| {
        let turn = turn?;
        let speed = turn.formula(printed::eq11_speed);
        Ok(Pair::wide(turn.at(), speed, turn.v).within(turn.v * turn.condition()))
    }),
    eq11_quadrature = {
        let trial = Trial::quadrature(
            Within,
            [
                "(11)",
                r"$v_0\exp\int\mathrm dv/v$, with $\mathrm dv/v$ from the two components of Newton's law",
            ],
        );
        trial.over(turns_where(Turn::is_gentle), |turn| {
            let turn = turn?;
            // Along and across the velocity, with A along x: dv/dt = A cos θ − λA, v dθ/dt = −A sin θ.
            let rate = |theta: f64| -(Scalar::cos(theta) - turn.lambda) / Scalar::sin(theta);
            let log_ratio = turn.integral(rate, 1e-13 * turn.condition())?;
            let found = turn.v0 * libm::exp(log_ratio);
            let speed = turn.formula(printed::eq11_speed);
            Ok(Pair::wide(turn.at(), speed, found).within(found * turn.condition()))
        })
    },
    // (11) where the particle starts along the line of the acceleration: the angle stays, the speed does not.
    eq11_outside = Trial::motion(
        Outside,
        [
            r"(11) at $\theta=\theta_0$",
            "the speed of the motion half a unit of time after the launch",
        ],
    )
    .over(straight(), |turn| {
        let turn = &turn?;
        let speed = turn.formula(printed::eq11_speed);
        Ok(Pair::wide(turn.at(), speed, turn.v))
    })
];
