//! Trials of (6) to (11): the two components of Newton's law, the hodograph's slope, the speed against the
//! angle.

use super::runs::{Turn, straight, turns, turns_where};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::conditioned::Conditioned;
use crate::claims::tolerances::DIFFERENCES;
use crate::evidence::{Evidence, Route, Subject};
use crate::numerics::quadrature::integral_within;
use crate::paper::constant as printed;
use crate::scalar::Scalar;

/// A printed rate with that of the motion.
fn rates(compared: &'static str, pair: fn(&Turn) -> (f64, f64)) -> Evidence {
    let trial = Trial::by(Route::Integration, Subject::Printed, compared, DIFFERENCES);
    // Later, the time itself is too coarse for differences.
    trial.over(turns_where(|turn| turn.v > 0.01 * turn.v0), |turn| {
        let turn = turn?;
        let (stated, found) = pair(turn);
        Ok::<_, Failure>(Pair {
            at: turn.at(),
            stated,
            found,
            scale: turn.a * (1.0 + turn.lambda),
        })
    })
}

/// (6) with the motion.
pub fn eq6_motion() -> Evidence {
    rates("(6) with dv_x/dt of the motion", |turn| {
        let rate = printed::eq6_vx_rate(turn.lambda, turn.a, turn.theta);
        (rate, turn.rate[0])
    })
}

/// (7) with the motion.
pub fn eq7_motion() -> Evidence {
    rates("(7) with dv_y/dt of the motion", |turn| {
        let rate = printed::eq7_vy_rate(turn.lambda, turn.a, turn.theta);
        (rate, turn.rate[1])
    })
}

/// (8) with the motion, as a direction: its sine times dv_x is its cosine times dv_y.
pub fn eq8_motion() -> Evidence {
    rates(
        "(8) as a direction, with that of (dv_x, dv_y) of the motion: the part of the one across the other with 0",
        |turn| {
            let slope = printed::eq8_hodograph_slope(turn.lambda, turn.theta);
            let length = libm::hypot(1.0, slope);
            ((slope * turn.rate[0] - turn.rate[1]) / length, 0.0)
        },
    )
}

/// (9), integrated over the angle.
pub fn eq9_quadrature() -> Evidence {
    let compared = "exp ∫ (9) dθ with v/v₀ of the motion";
    Trial::quadrature(Subject::Printed, compared).over(turns_where(Turn::is_gentle), |turn| {
        let turn = turn?;
        let rate = |theta| printed::eq9_log_speed_rate(turn.lambda, theta);
        let log_ratio =
            integral_within(rate, turn.theta0, turn.theta, 1e-13 * turn.condition())?.value;
        let found = turn.v / turn.v0;
        Ok::<_, Failure>(Pair {
            at: turn.at(),
            stated: libm::exp(log_ratio),
            found,
            scale: found * turn.condition(),
        })
    })
}

/// (10): the invariant at θ over that at θ₀.
fn eq10(subject: Subject, wanted: fn(&Turn) -> bool) -> Evidence {
    let compared = "(10) at θ over (10) at θ₀, along the motion, with 1";
    Trial::motion(subject, compared).over(turns_where(wanted), |turn| {
        let turn = turn?;
        let number = Conditioned::measured;
        let at = |v, theta| printed::eq10_invariant(number(turn.lambda), number(v), number(theta));
        let ratio = at(turn.v, turn.theta) / at(turn.v0, turn.theta0);
        Ok::<_, Failure>(Pair::conditioned(turn.at(), ratio, 1.0))
    })
}

/// (10) for θ > 0.
pub fn eq10_motion() -> Evidence {
    eq10(Subject::Within, |turn| turn.theta0 > 0.0)
}

/// (10) for θ < 0, with friction.
pub fn eq10_outside() -> Evidence {
    eq10(Subject::Outside, |turn| {
        turn.theta0 < 0.0 && turn.lambda > 0.0
    })
}

/// (11) with the speed of the motion.
pub fn eq11_motion() -> Evidence {
    let compared = "(11) with the speed of the motion when it has turned to θ";
    Trial::motion(Subject::Within, compared).over(turns(), |turn| {
        let turn = turn?;
        let speed = turn.formula(printed::eq11_speed);
        Ok::<_, Failure>(Pair::conditioned(turn.at(), speed, turn.v))
    })
}

/// (11) with the integral of dv/v.
pub fn eq11_quadrature() -> Evidence {
    let compared = "(11) with v₀ exp ∫ dv/v, dv/v from the two components of Newton's law";
    Trial::quadrature(Subject::Within, compared).over(turns_where(Turn::is_gentle), |turn| {
        let turn = turn?;
        // Along and across the velocity, with A along x: dv/dt = A cos θ − λA, v dθ/dt = −A sin θ.
        let rate = |theta: f64| -(Scalar::cos(theta) - turn.lambda) / Scalar::sin(theta);
        let log_ratio =
            integral_within(rate, turn.theta0, turn.theta, 1e-13 * turn.condition())?.value;
        let found = turn.v0 * libm::exp(log_ratio);
        let speed = turn.formula(printed::eq11_speed);
        let mut pair = Pair::conditioned(turn.at(), speed, found);
        pair.scale = pair.scale.max(found * turn.condition());
        Ok::<_, Failure>(pair)
    })
}

/// (11) where the particle starts along the line of the acceleration: the angle stays, the speed does not.
pub fn eq11_outside() -> Evidence {
    let compared =
        "(11) at θ = θ₀ with the speed of the motion half a unit of time after the launch";
    Trial::motion(Subject::Outside, compared).over(straight(), |turn| {
        let turn = &turn?;
        let speed = turn.formula(printed::eq11_speed);
        Ok::<_, Failure>(Pair::conditioned(turn.at(), speed, turn.v))
    })
}
