//! What the conditions of section 2.1 except: points at which the formulas have no value, or that fill no stretch.

use super::prelude::*;
use trialbook::certified::interval::Interval;

pub(in crate::claims) const LAMBDA: (&str, [f64; 2]) = ("λ", [0.1, 0.9]);
const SPEED: (&str, [f64; 2]) = ("v₀", [0.5, 2.0]);
/// Angles that are neither 0 nor π, and on one side of where cos θ = −λ.
const ANGLE: [f64; 2] = [0.3, 1.5];
pub(in crate::claims) const START: (&str, [f64; 2]) = ("θ₀", ANGLE);
pub(in crate::claims) const END: (&str, [f64; 2]) = ("θ", ANGLE);

pub(in crate::claims) const HOLDS: &str = "the condition holds";

pub(in crate::claims) fn int(n: i64) -> Interval {
    Interval::int(n)
}

pub(in crate::claims) fn half() -> Interval {
    Interval::ratio(1, 2)
}

pub(in crate::claims) fn two_thirds() -> Interval {
    Interval::pi() * Interval::ratio(2, 3)
}

/// 0 and π: along the line of the acceleration.
fn straight() -> [Interval; 2] {
    [int(0), Interval::pi()]
}

/// (12), with d/dθ of its power put in.
fn eq12_rate([lambda, v0, theta0, theta]: [Interval; 4]) -> Interval {
    let tangent = (theta / int(2)).tan();
    let secant = int(1) + tangent * tangent;
    let rate = lambda * tangent.pow(lambda - int(1)) * secant / int(2);
    printed::eq12_time_rate(lambda, v0, theta0, theta, rate)
}

fn eq13_time([lambda, theta0, theta]: [Interval; 3]) -> Interval {
    printed::eq13_time(lambda, int(1), int(1), theta0, theta)
}

attempts![
    eq8 = no_value(
        "(8)",
        HOLDS,
        r"with $\lambda=1$, $\theta=0$",
        [LAMBDA, END],
        [[int(1), int(0)]],
        |[lambda, theta]| printed::eq8_hodograph_slope(lambda, theta),
    ),
    eq9 = no_value(
        "(9)",
        HOLDS,
        r"with $\theta=0,\pi$",
        [LAMBDA, END],
        straight().map(|theta| [half(), theta]),
        |[lambda, theta]| printed::eq9_log_speed_rate(lambda, theta),
    ),
    eq10 = no_value(
        "(10)",
        HOLDS,
        r"with $\theta=-1,0,\pi$",
        [LAMBDA, ("v", [0.5, 2.0]), END],
        [int(-1), int(0), Interval::pi()].map(|theta| [half(), int(1), theta]),
        |[lambda, v, theta]| printed::eq10_invariant(lambda, v, theta),
    ),
    eq11 = no_value(
        "(11)",
        HOLDS,
        r"with $\theta=\theta_0=0,\pi$",
        [LAMBDA, SPEED, START, END],
        straight().map(|theta| [half(), int(1), theta, theta]),
        |[lambda, v0, theta0, theta]| printed::eq11_speed(lambda, v0, theta0, theta),
    ),
    eq12 = no_value(
        "(12)",
        HOLDS,
        r"with $\theta=-1,0,\pi$ or $\lambda=0$",
        [LAMBDA, SPEED, START, END],
        [
            [half(), int(1), int(1), int(-1)],
            [half(), int(1), int(1), int(0)],
            [half(), int(1), int(1), Interval::pi()],
            [int(0), int(1), int(1), half()],
        ],
        eq12_rate,
    ),
    eq13_friction = no_value(
        "(13)",
        HOLDS,
        r"with $\lambda=1$ or $\cos\theta_0=-\lambda$",
        [LAMBDA, START, END],
        [[int(1), int(2), int(1)], [half(), two_thirds(), int(1)]],
        eq13_time,
    ),
    eq13_straight = no_value(
        "(13)",
        HOLDS,
        r"with $\theta=\theta_0=0,\pi$",
        [LAMBDA, START, END],
        straight().map(|theta| [half(), theta, theta]),
        eq13_time,
    ),
    eq14 = no_value(
        "(14)",
        HOLDS,
        r"with $\cos\theta=-\lambda$",
        [LAMBDA, START, END, ("t", [0.0, 1.0])],
        [[half(), int(2), two_thirds(), int(1)]],
        |[lambda, theta0, theta, t]| {
            printed::eq14_speed_at_time(lambda, int(1), int(1), theta0, theta, t)
        },
    ),
    // The one start with λ ≤ 1 that stops for good.
    small_friction = no_inside(
        "a start",
        r"$\lambda=1$, $\theta_0=\pi$",
        [("λ", [0.0, 1.0]), ("θ₀", [0.0, PI])],
        &[[1.0, PI]],
        |start| start != [1.0, PI],
    ),
    large_friction = no_inside(
        "a start",
        r"$\theta_0=\pi$",
        [("λ", [1.0, 10.0]), ("θ₀", [0.0, PI])],
        &[[1.5, PI], [5.0, PI]],
        |[_, theta0]| theta0 != PI,
    )
];
