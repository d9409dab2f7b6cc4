//! What the conditions of section 3 except, and a step there.

use crate::certified::interval::Interval;
use crate::claims::compare::Compared;
use crate::claims::excepted::no_value;
use crate::evidence::Evidence;
use crate::paper::sphere as printed;
use crate::scalar::Scalar;

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
