//! Trials of (6) to (11): the two components of Newton's law, the hodograph's slope, the speed against the
//! angle.

use super::runs::{Turn, straight, turns, turns_where};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::conditioned::Conditioned;
use crate::evidence::{Evidence, Subject};
use crate::numerics::quadrature::integral_within;
use crate::paper::constant as printed;
use crate::scalar::Scalar;

/// A rate, integrated over time along the motion, with the change of a component of the velocity.
fn summed_rate(compared: &'static str, component: usize, rate: fn(&Turn, f64) -> f64) -> Evidence {
    Trial::quadrature(Subject::Printed, compared).over(turns(), |turn| {
        let turn = &turn?;
        let motion = turn.motion(turn.t)?;
        let along = |t: f64| {
            let [vx, vy] = motion.at(t).map_or([f64::NAN; 2], |state| state.v);
            rate(turn, libm::atan2(vy, vx))
        };
        let change = integral_within(along, 0.0, turn.t, 1e-14 * turn.v0)?.value;
        let (before, after) = (turn.velocity0()[component], turn.velocity()[component]);
        Ok::<_, Failure>(Pair {
            at: turn.at(),
            stated: change,
            found: after - before,
            scale: turn.v0.max(turn.v),
        })
    })
}

/// (6) along the motion.
pub fn eq6_quadrature() -> Evidence {
    summed_rate(
        "∫ (6) dt along the motion with its change of v_x",
        0,
        |turn, theta| printed::eq6_vx_rate(turn.lambda, turn.a, theta),
    )
}

/// (7) along the motion.
pub fn eq7_quadrature() -> Evidence {
    summed_rate(
        "∫ (7) dt along the motion with its change of v_y",
        1,
        |turn, theta| printed::eq7_vy_rate(turn.lambda, turn.a, theta),
    )
}

/// (8) along the motion.
pub fn eq8_quadrature() -> Evidence {
    let compared = "∫ (8) dv_x along the motion, dv_x = (6) dt, with its change of v_y";
    summed_rate(compared, 1, |turn, theta| {
        let slope = printed::eq8_hodograph_slope(turn.lambda, theta);
        slope * printed::eq6_vx_rate(turn.lambda, turn.a, theta)
    })
}

/// (9), integrated over the angle.
pub fn eq9_quadrature() -> Evidence {
    let compared = "exp ∫ (9) dθ with v/v₀ of the motion";
    Trial::quadrature(Subject::Printed, compared).over(turns_where(Turn::is_gentle), |turn| {
        let turn = &turn?;
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
        let turn = &turn?;
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
        let turn = &turn?;
        let speed = turn.formula(printed::eq11_speed);
        Ok::<_, Failure>(Pair::conditioned(turn.at(), speed, turn.v))
    })
}

/// (11) with the integral of dv/v.
pub fn eq11_quadrature() -> Evidence {
    let compared = "(11) with v₀ exp ∫ dv/v, dv/v from the two components of Newton's law";
    Trial::quadrature(Subject::Within, compared).over(turns_where(Turn::is_gentle), |turn| {
        let turn = &turn?;
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
