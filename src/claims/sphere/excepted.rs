//! What the conditions of section 3 except.

use crate::evidence::Evidence;
use crate::paper::sphere as printed;
use crate::scalar::Scalar;
use trialbook::certified::interval::Interval;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::Compared;
use trialbook::claims::excepted::no_value;

/// (81), from the line of the acceleration.
pub fn eq81() -> Evidence {
    let straight = [Interval::int(0), Interval::pi()];
    no_value(
        Compared::one(
            "whether (81) has a value (1 if so)",
            "whether the condition holds",
        )
        .over(r"some of them random, the others with $\theta=\theta_0=0,\pi$"),
        ["λ", "u₀", "θ₀", "θ"],
        [[0.1, 0.9], [0.5, 2.0], [0.3, 1.5], [0.3, 1.5]],
        straight.map(|theta| [Interval::ratio(1, 2), Interval::int(1), theta, theta]),
        |[lambda, u0, theta0, theta]| printed::eq81_slip(lambda, u0, theta0, theta),
    )
}

/// cos θ = −½.
fn two_thirds() -> Interval {
    Interval::pi() * Interval::ratio(2, 3)
}

/// (82), from the line of the acceleration, at the critical friction, and where its first factor vanishes.
pub fn eq82() -> Evidence {
    let (one, half) = (Interval::int(1), Interval::ratio(1, 2));
    no_value(
        Compared::one("whether (82) has a value", "whether the condition holds").over(
            r"at random, at $\theta=\theta_0=0,\pi$, at $\lambda=1$ and at $\cos\theta_0=-\lambda$",
        ),
        ["λ", "θ₀", "θ"],
        [[0.1, 0.9], [0.3, 1.5], [0.3, 1.5]],
        [
            [half, Interval::int(0), Interval::int(0)],
            [half, Interval::pi(), Interval::pi()],
            [one, Interval::int(2), one],
            [half, two_thirds(), one],
        ],
        |[lambda, theta0, theta]| printed::eq82_time(lambda, one, theta0, theta),
    )
}

/// (83), where its denominator vanishes.
pub fn eq83() -> Evidence {
    let one = Interval::int(1);
    no_value(
        Compared::one("whether (83) has a value", "whether the condition holds")
            .over(r"at random and at $\cos\theta=-\lambda$"),
        ["λ", "θ₀", "θ", "τ"],
        [[0.1, 0.9], [0.3, 1.5], [0.3, 1.5], [0.0, 1.0]],
        [[Interval::ratio(1, 2), Interval::int(2), two_thirds(), one]],
        |[lambda, theta0, theta, tau]| printed::eq83_slip_at_time(lambda, one, theta0, theta, tau),
    )
}

pub(super) const TRIALS: &[Attempt] = trials![eq81, eq82, eq83];
