//! Trials of what section 2.1 says in words.

use super::launches::{ALIGNED, Aligned, OTHERS_ALIGNED, STOPS, Stop, held};
use super::prelude::*;

/// 1 for sliding and 0 for rest, at A t/v₀ = 100.
fn moves_late(launch: &Turn) -> Result<f64, MotionError> {
    let late = launch.motion(launch.time(100.0))?.end();
    Ok(if late.speed() > 0.0 { 1.0 } else { 0.0 })
}

/// d ln θ/d ln v at θ = 0, by the last three nodes at which both are normal numbers: what it differs by at small θ goes with
/// θ², so that ln θ = k ln v + c + d θ².
fn last_slope(stop: &Stop) -> f64 {
    let nodes = stop.nodes.iter().map(|s| {
        let theta = s.direction();
        [libm::log(theta.abs()), libm::log(s.speed()), theta * theta]
    });
    let nodes: Vec<_> = nodes
        .filter(|[theta, v, _]| theta.is_finite() && v.is_finite())
        .collect();
    let [.., a, b, c] = nodes[..] else {
        return f64::NAN;
    };
    let change = |i: usize| (b[i] - a[i], c[i] - b[i]);
    let ((theta1, theta2), (v1, v2), (square1, square2)) = (change(0), change(1), change(2));
    let part = square2 / square1;
    (theta2 - part * theta1) / (v2 - part * v1)
}

attempts![
    small_friction_limit = {
        let at = |aligned: &Aligned| aligned.start.at();
        Trial::by(
            Limit,
            Within,
            Compared::constant("the stated 0", "the angle of the velocity at $At/v_0=10^8$"),
            LATE_ANGLE,
        )
        .each(ALIGNED.each(), at, |aligned| {
            Ok([printed::s21_late_angle(), aligned.angle, 1.0])
        })
    },
    small_friction_census = {
        let trial = Trial::census(
            Within,
            [
                r"whether $\lambda\le1$ (1 if so)",
                "whether the particle never rests and its angle grows on no step",
            ],
        );
        let moving = OTHERS_ALIGNED
            .each()
            .map(|aligned| aligned.map(|a| (a.start, a.aligns())));
        let at_rest = |s: &Stop| s.nodes.last().is_some_and(|end| end.speed() == 0.0);
        let stopping = STOPS
            .each()
            .map(|stop| stop.map(|s| (s.start, !at_rest(s))));
        trial.over(moving.chain(stopping), |motion| {
            let (start, aligns) = motion?;
            let [left, right] = printed::s21_keeps_moving_sides(start.lambda);
            Ok(Pair::plain(start.at(), is(left <= right), is(aligns)))
        })
    },
    // λ = 1 and θ₀ = π: static friction holds what kinetic friction has stopped.
    small_friction_outside = Trial::by(
        Integration,
        Outside,
        Compared::constant(
            "1, for motion",
            "what the particle does at $At/v_0=100$ (1 for sliding, 0 for rest)",
        ),
        NONE,
    )
    .over(held(), |launch: Turn| {
        let [left, right] = printed::s21_keeps_moving_sides(launch.lambda);
        Ok(Pair::plain(
            launch.at(),
            is(left <= right),
            moves_late(&launch)?,
        ))
    }),
    // λ > 1: towards the stop, d ln θ/d ln v is positive and that of a motion that turns into the x axis, so θ → 0.
    large_friction_limit = {
        let trial = Trial::by(
            Limit,
            Within,
            [
                r"$1/(\lambda-1)$",
                r"$\mathrm d\ln\theta/\mathrm d\ln v$ over the last steps before the stop, extrapolated to $\theta=0$",
            ],
            SLOPE,
        );
        // Others have not turned yet when their speed is lost in rounding.
        let turns = |s: &Stop| (1.2..4.0).contains(&s.start.lambda) && s.start.theta0.abs() < 3.1;
        let turning = only(STOPS.each(), |s| turns(s) && !s.start.is_straight());
        trial.each(turning, Stop::at, |stop| {
            let found = last_slope(stop);
            Ok([
                corrected::turning_slope(stop.start.lambda, 0.0),
                found,
                found,
            ])
        })
    },
    // λ > 1, however large: all the way down ln v falls as ln tan(θ/2) says, so that θ → 0 with v.
    large_friction_turns = {
        let trial = Trial::by(
            Integration,
            Within,
            [
                r"$\int(\lambda-\cos\theta)\,\mathrm d\ln\tan(\theta/2)$ from the launch to the last step",
                r"$\ln v/v_0$ of the motion there",
            ],
            ROOT,
        );
        let turning = only(STOPS.each(), |s| !s.start.is_straight());
        trial.each(turning, Stop::at, |stop| {
            let Turn {
                lambda, v0, theta0, ..
            } = stop.start;
            let tangent = |theta: f64| libm::log(libm::tan(theta.abs() / 2.0));
            let fall = |s: &State| (tangent(s.direction()), libm::log(s.speed() / v0));
            let mut falls = stop.nodes.iter().map(fall);
            let last = falls.rfind(|(turn, slow)| turn.is_finite() && slow.is_finite());
            let (turned, found) = last.ok_or("no step")?;
            let side = 2f64.copysign(theta0);
            let rate =
                |y: f64| 1.0 / corrected::turning_slope(lambda, side * libm::atan(libm::exp(y)));
            let scale = (1.0 + found.abs()) * stop.start.condition();
            let stated = sum(rate, tangent(theta0), turned, 1e-14 * scale);
            Ok([stated, found, scale])
        })
    },
    large_friction_outside = {
        let backwards = only(STOPS.each(), |s| {
            s.start.is_straight() && s.start.theta0 != 0.0
        });
        Trial::by(
            Integration,
            Outside,
            Compared::constant(
                "the stated 0",
                "the angle of the velocity at 99 % of the time of stopping",
            ),
            LATE_ANGLE,
        )
        .each(backwards, Stop::at, |stop| {
            Ok([
                0.0,
                stop.start.motion_to_rest()?.at(0.99 * stop.t)?.direction(),
                1.0,
            ])
        })
    }
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Along the line of the force a particle stops at A t/v₀ = 1/(λ − 1), against it at 1/(λ + 1).
    #[test]
    fn what_moves_late_is_told_from_what_rests() {
        let moves = |lambda: f64, theta0: f64| {
            moves_late(&Turn::launch(lambda, 0.1, 10.0, theta0)).unwrap()
        };
        assert_eq!(moves(1.0 + 1.0 / 110.0, 0.0), 1.0);
        assert_eq!(moves(1.0 + 1.0 / 90.0, 0.0), 0.0);
        assert_eq!(
            [moves(0.5, 1.0), moves(1.0, std::f64::consts::PI)],
            [1.0, 0.0]
        );
    }
}
