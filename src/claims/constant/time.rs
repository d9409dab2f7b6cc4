//! Trials of (12) to (14): the time against the angle.

use super::launches::{LATE_TURNS, straight, turns_where};
use super::prelude::*;

fn eq13(turn: &Turn) -> Double {
    let number = Double::from;
    printed::eq13_time(
        number(turn.lambda),
        number(turn.a),
        number(turn.v0),
        number(turn.theta0),
        number(turn.theta),
    )
}

/// A dt/dθ by (12), with the derivative λ (tan θ/2)^λ / sin θ of (tan θ/2)^λ put in.
fn eq12_rate(turn: &Turn, theta: f64) -> f64 {
    let power = Scalar::pow(Scalar::tan(theta / 2.0), turn.lambda);
    let d_power = turn.lambda * power / Scalar::sin(theta);
    printed::eq12_time_rate(turn.lambda, turn.v0, turn.theta0, theta, d_power)
}

fn eq13_outside(
    compared: Compared,
    excluded: impl Iterator<Item = Result<Turn, Failure>>,
) -> Evidence {
    Trial::motion(Outside, compared).each(excluded, Turn::at, |turn| {
        let stated = printed::eq13_time(turn.lambda, turn.a, turn.v0, turn.theta0, turn.theta);
        Ok([stated, turn.t, turn.t])
    })
}

fn eq14<S: Scalar + From<f64>>(turn: &Turn) -> S {
    let number = S::from;
    printed::eq14_speed_at_time(
        number(turn.lambda),
        number(turn.a),
        number(turn.v0),
        number(turn.theta0),
        number(turn.theta),
        number(turn.t),
    )
}

pub(super) fn regular_time() -> Evidence {
    Trial::motion(
        Corrected,
        [
            "the regular form of the time, where (13) has a value and where not,",
            "that of the motion",
        ],
    )
    .each(TURNS.each(), Turn::at, |turn| {
        Ok([
            regular(turn, turn.ln_fall()),
            turn.t,
            turn.t * turn.condition(),
        ])
    })
}

/// The regular form of the time at which ln tan(θ/2) has changed by so much.
fn regular(turn: &Turn, ln_r: f64) -> f64 {
    corrected::time(turn.lambda, turn.a, turn.v0, turn.theta0, ln_r)
}

pub(super) fn regular_straight() -> Evidence {
    let trial = Trial::motion(
        Corrected,
        [
            "the regular form of the speed along the line of the acceleration, at the root $r$ of the regular time,",
            "that of the motion",
        ],
    );
    trial.over(straight(), |turn| {
        let Turn {
            lambda,
            a,
            v0,
            theta0,
            ..
        } = turn?;
        let t = 0.3 * v0 / (a * (1.0 + lambda));
        let late = |r| corrected::time(lambda, a, v0, theta0, libm::log(r)) - t;
        let r = root(late, 0.1, 1.0).unwrap_or(f64::NAN);
        let found = Turn::launch(lambda, a, v0, theta0).motion(t)?.end().speed();
        Ok(Pair {
            at: format!("{}, t = {t:.6}", Turn::launch(lambda, a, v0, theta0).at()),
            stated: corrected::speed(lambda, v0, theta0, r),
            found,
            scale: v0,
        })
    })
}

attempts![
    regular_speed = Trial::motion(
        Corrected,
        ["the regular form of the speed", "that of the motion"],
    )
    .each(TURNS.each(), Turn::at, |turn| {
        Ok([
            corrected::speed(turn.lambda, turn.v0, turn.theta0, turn.r()),
            turn.v,
            turn.v * turn.condition(),
        ])
    }),
    regular_straight,
    regular_speed_by_log = Trial::motion(
        Corrected,
        [
            r"the regular form of the speed, by $\ln r$,",
            "that of the motion",
        ],
    )
    .each(LATE_TURNS.each().chain(TURNS.each()), Turn::at, |turn| {
        Ok([
            corrected::speed_by_log(turn.lambda, turn.v0, turn.theta0, turn.ln_fall()),
            turn.v,
            turn.v.max(turn.v0) * turn.condition(),
        ])
    }),
    eq12_quadrature = Trial::quadrature(
        Within,
        [r"the integral of (12) over $\theta$", "$At$ of the motion"],
    )
    .each(
        turns_where(|turn| turn.lambda > 0.0 && turn.theta0 > 0.0 && turn.is_gentle()),
        Turn::at,
        |turn| {
            let found = turn.a * turn.t;
            let enough = 1e-14 * turn.condition() * found;
            let stated = turn.integral(|theta| eq12_rate(turn, theta), enough);
            Ok([stated.unwrap_or(f64::NAN), found, found])
        },
    ),
    // (12) where it has no value, while the motion turns as ever: at λ = 0, and for θ < 0 with friction.
    eq12_outside = {
        let wanted =
            |turn: &Turn| turn.lambda == 0.0 || turn.lambda.fract() != 0.0 && turn.theta0 < 0.0;
        Trial::motion(
            Outside,
            [
                r"(12) per $\mathrm d\theta$",
                r"$A\,\mathrm dt/\mathrm d\theta=-v/\sin\theta$ of the motion",
            ],
        )
        .each(turns_where(wanted), Turn::at, |turn| {
            let found = -turn.v / Scalar::sin(turn.theta);
            Ok([eq12_rate(turn, turn.theta), found, found.abs()])
        })
    },
    eq13_motion = Trial::motion(
        Within,
        [
            "(13)",
            r"the time at which the motion has turned to $\theta$",
        ],
    )
    .over(turns_where(Turn::has_a_time), |turn| {
        let turn = turn?;
        Ok(Pair::wide(turn.at(), eq13(turn), turn.t).within(turn.time_scale()))
    }),
    eq13_quadrature = Trial::quadrature(
        Within,
        [
            "(13)",
            r"$\int\mathrm dt$ over the angle, along and across the velocity",
        ],
    )
    .over(
        turns_where(|turn| turn.has_a_time() && turn.is_gentle()),
        |turn| {
            let turn = turn?;
            let found = turn.time_over_the_angle(turn.ln_fall())?;
            Ok(Pair::wide(turn.at(), eq13(turn), found).within(turn.time_scale()))
        },
    ),
    eq13_root = {
        let wanted =
            |turn: &Turn| turn.has_a_time() && (turn.lambda - 1.0).abs() > 1e-3 && turn.is_gentle();
        Trial::by(
            Root,
            Within,
            [
                r"the root $\theta$ of (13) at $t$",
                "the angle of the motion then",
            ],
            ROOT,
        )
        .each(turns_where(wanted), Turn::at, |turn| {
            let late = |theta| {
                printed::eq13_time(turn.lambda, turn.a, turn.v0, turn.theta0, theta) - turn.t
            };
            let (low, high) = (0.9 * turn.theta, turn.theta0);
            let stated = root(late, low.min(high), low.max(high)).unwrap_or(f64::NAN);
            // What rounding, enlarged by 1/(1 − λ), leaves of the time leaves an angle open by dθ/dt.
            let slope = turn.v / (turn.a * Scalar::sin(turn.theta).abs());
            let open = turn.t * turn.condition() / (1.0 - turn.lambda).abs().min(1.0);
            Ok([stated, turn.theta, turn.theta.abs().max(open / slope)])
        })
    },
    // (13) where it is 0/0 or 0·∞: at λ = 1 and where cos θ₀ = −λ.
    eq13_singular = {
        let compared = Compared::one("(13)", "the time of the motion")
            .over(r"$\lambda=1$ or $\cos\theta_0=-\lambda$");
        let singular = turns_where(|turn| !turn.has_a_time());
        eq13_outside(compared, singular.map(|turn| turn.copied()))
    },
    eq13_straight = eq13_outside(
        Compared::one("(13)", "the time of the motion").over(r"$\theta_0=0$ or $\pi$"),
        straight(),
    ),
    regular_time,
    regular_late = Trial::motion(
        Corrected,
        Compared::one("the regular form of the time", "that of the motion")
            .over("turns to a hundredth of the angle down to $10^{-80}$"),
    )
    .each(LATE_TURNS.each(), Turn::at, |turn| {
        Ok([
            regular(turn, turn.ln_fall()),
            turn.t,
            turn.t * turn.condition(),
        ])
    }),
    regular_angle = {
        let trial = Trial::by(
            Root,
            Corrected,
            [
                r"$\theta$ with $\tan(\theta/2)=r\tan(\theta_0/2)$, at the root $r$ of the regular form of the time,",
                "the angle of the motion then",
            ],
            ROOT,
        );
        let wanted = |turn: &Turn| turn.lambda <= 1.0 && turn.is_gentle();
        trial.each(turns_where(wanted), Turn::at, |turn| {
            let ln_r = root(|ln_r| regular(turn, ln_r) - turn.t, -100.0, 0.0).unwrap_or(f64::NAN);
            let [sine, cosine] = corrected::half_angle(turn.theta0, libm::exp(ln_r));
            Ok([
                2.0 * libm::atan2(sine, cosine),
                turn.theta,
                turn.theta0.abs(),
            ])
        })
    },
    eq14_motion = {
        let all = TURNS.each().map(|turn| turn.copied()).chain(straight());
        Trial::motion(
            Within,
            ["(14) at the angle and time of the motion", "its speed"],
        )
        .over(all, |turn| {
            let turn = &turn?;
            Ok(Pair::wide(turn.at(), eq14(turn), turn.v).within(turn.speed_at_time_scale()))
        })
    },
    eq14_outside = Trial::motion(
        Outside,
        [
            r"(14) where $\cos\theta=-\lambda$",
            "the speed of the motion",
        ],
    )
    .each(super::launches::turns_to_the_gap(), Turn::at, |turn| {
        Ok([eq14::<f64>(turn), turn.v, turn.v])
    })
];
