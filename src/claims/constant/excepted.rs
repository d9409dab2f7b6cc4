//! What the conditions of section 2.1 except: points at which the formulas have no value, or that fill no stretch.

use crate::evidence::Evidence;
use crate::paper::constant as printed;
use crate::scalar::Scalar;
use std::f64::consts::PI;
use trialbook::certified::interval::Interval;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::Compared;
use trialbook::claims::excepted::{no_inside, no_value};

const LAMBDA: [f64; 2] = [0.1, 0.9];
const SPEED: [f64; 2] = [0.5, 2.0];
/// Angles that are neither 0 nor π, and on one side of where cos θ = −λ.
const ANGLE: [f64; 2] = [0.3, 1.5];

fn int(n: i64) -> Interval {
    Interval::int(n)
}

fn half() -> Interval {
    Interval::ratio(1, 2)
}

/// The angle 2π/3, whose cosine is −½.
fn two_thirds() -> Interval {
    Interval::pi() * Interval::ratio(2, 3)
}

/// 0 and π: along the line of the acceleration.
fn straight() -> [Interval; 2] {
    [int(0), Interval::pi()]
}

/// (8), where dv_x and dv_y both vanish.
pub fn eq8() -> Evidence {
    no_value(
        Compared::one(
            "whether (8) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\lambda=1$, $\theta=0$"),
        ["λ", "θ"],
        [LAMBDA, ANGLE],
        [[int(1), int(0)]],
        |[lambda, theta]| printed::eq8_hodograph_slope(lambda, theta),
    )
}

/// (9), along the line of the acceleration.
pub fn eq9() -> Evidence {
    no_value(
        Compared::one(
            "whether (9) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\theta=0,\pi$"),
        ["λ", "θ"],
        [LAMBDA, ANGLE],
        straight().map(|theta| [half(), theta]),
        |[lambda, theta]| printed::eq9_log_speed_rate(lambda, theta),
    )
}

/// (10), for angles that are not between 0 and π.
pub fn eq10() -> Evidence {
    no_value(
        Compared::one(
            "whether (10) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\theta=-1,0,\pi$"),
        ["λ", "v", "θ"],
        [LAMBDA, SPEED, ANGLE],
        [int(-1), int(0), Interval::pi()].map(|theta| [half(), int(1), theta]),
        |[lambda, v, theta]| printed::eq10_invariant(lambda, v, theta),
    )
}

/// (11), from the line of the acceleration.
pub fn eq11() -> Evidence {
    no_value(
        Compared::one(
            "whether (11) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\theta=\theta_0=0,\pi$"),
        ["λ", "v₀", "θ₀", "θ"],
        [LAMBDA, SPEED, ANGLE, ANGLE],
        straight().map(|theta| [half(), int(1), theta, theta]),
        |[lambda, v0, theta0, theta]| printed::eq11_speed(lambda, v0, theta0, theta),
    )
}

/// (12), for angles that are not between 0 and π, and without friction.
pub fn eq12() -> Evidence {
    let at = |lambda, theta| [lambda, int(1), int(1), theta];
    no_value(
        Compared::one(
            "whether (12) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\theta=-1,0,\pi$ or $\lambda=0$"),
        ["λ", "v₀", "θ₀", "θ"],
        [LAMBDA, SPEED, ANGLE, ANGLE],
        [
            at(half(), int(-1)),
            at(half(), int(0)),
            at(half(), Interval::pi()),
            at(int(0), half()),
        ],
        |[lambda, v0, theta0, theta]| {
            let tangent = (theta / int(2)).tan();
            let secant = int(1) + tangent * tangent;
            // d/dθ of the power.
            let rate = lambda * tangent.pow(lambda - int(1)) * secant / int(2);
            printed::eq12_time_rate(lambda, v0, theta0, theta, rate)
        },
    )
}

fn eq13(compared: Compared, excepted: [[Interval; 3]; 2]) -> Evidence {
    let usual = [LAMBDA, ANGLE, ANGLE];
    no_value(
        compared,
        ["λ", "θ₀", "θ"],
        usual,
        excepted,
        |[lambda, theta0, theta]| printed::eq13_time(lambda, int(1), int(1), theta0, theta),
    )
}

/// (13), at the critical friction, and from the angle at which its first factor vanishes.
fn eq13_friction() -> Evidence {
    eq13(
        Compared::one(
            "whether (13) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\lambda=1$ or $\cos\theta_0=-\lambda$"),
        [[int(1), int(2), int(1)], [half(), two_thirds(), int(1)]],
    )
}

/// (13), from the line of the acceleration.
pub fn eq13_straight() -> Evidence {
    eq13(
        Compared::one(
            "whether (13) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\theta=\theta_0=0,\pi$"),
        straight().map(|theta| [half(), theta, theta]),
    )
}

/// (14), at the angle at which its denominator vanishes.
pub fn eq14() -> Evidence {
    no_value(
        Compared::one(
            "whether (14) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\cos\theta=-\lambda$"),
        ["λ", "θ₀", "θ", "t"],
        [LAMBDA, ANGLE, ANGLE, [0.0, 1.0]],
        [[half(), int(2), two_thirds(), int(1)]],
        |[lambda, theta0, theta, t]| {
            printed::eq14_speed_at_time(lambda, int(1), int(1), theta0, theta, t)
        },
    )
}

/// The one start with λ ≤ 1 that stops for good.
pub fn small_friction() -> Evidence {
    no_inside(
        Compared::one(
            "whether a start meets the condition (1 if so)",
            r"the expectation that only $\lambda=1$, $\theta_0=\pi$ does not",
        )
        .over("random ones, that one, and some close to it"),
        ["λ", "θ₀"],
        [[0.0, 1.0], [0.0, PI]],
        &[[1.0, PI]],
        |start| start != [1.0, PI],
    )
}

/// Starts straight against the inertial force.
fn large_friction() -> Evidence {
    no_inside(
        Compared::one(
            "whether a start meets the condition (1 if so)",
            r"the expectation that only $\theta_0=\pi$ does not",
        )
        .over("random ones, that one, and some close to it"),
        ["λ", "θ₀"],
        [[1.0, 10.0], [0.0, PI]],
        &[[1.5, PI], [5.0, PI]],
        |[_, theta0]| theta0 != PI,
    )
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq8,
    eq9,
    eq10,
    eq11,
    eq12,
    eq13_friction,
    eq13_straight,
    eq14,
    small_friction,
    large_friction
];
