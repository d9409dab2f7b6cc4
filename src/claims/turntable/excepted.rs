//! What the conditions of section 4 except: a particle at rest on the table, and one on the axis.

use crate::evidence::Evidence;
use crate::paper::turntable as printed;
use crate::scalar::Scalar;
use trialbook::certified::interval::Interval;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::Compared;
use trialbook::claims::excepted::{no_inside, no_value};

const FAR: [f64; 2] = [0.5, 2.0];

fn int(n: i64) -> Interval {
    Interval::int(n)
}

/// A formula by position and velocity, where that velocity vanishes.
fn at_rest(compared: Compared, law: impl Fn([Interval; 2], [Interval; 2]) -> Interval) -> Evidence {
    no_value(
        compared,
        ["x", "y", "v_x", "v_y"],
        [FAR; 4],
        [[int(1), int(2), int(0), int(0)]],
        |[x, y, u, v]| law([x, y], [u, v]),
    )
}

fn sum([x, y]: [Interval; 2]) -> Interval {
    x + y
}

/// (86), at rest.
pub fn eq86() -> Evidence {
    at_rest(
        Compared::one(
            "whether (86) has a value (1 if so)",
            "whether the particle slides",
        )
        .over("some of them random, the others at rest"),
        |r, v| sum(printed::eq86_acceleration(int(1), int(1), int(1), r, v)),
    )
}

/// (89), at rest.
pub fn eq89() -> Evidence {
    at_rest(
        Compared::one(
            "whether (89) has a value (1 if so)",
            "whether the particle slides",
        )
        .over("some of them random, the others at rest"),
        |r, v| sum(printed::eq89_acceleration(r, v)),
    )
}

/// (91), at rest.
pub fn eq91() -> Evidence {
    at_rest(
        Compared::one("whether (91) has a value (1 if so)", "whether $p>0$")
            .over("some of them random, the others at rest"),
        printed::eq91_moment,
    )
}

/// (92), at rest.
pub fn eq92() -> Evidence {
    at_rest(
        Compared::one("whether (92) has a value (1 if so)", "whether $p>0$")
            .over("some of them random, the others at rest"),
        printed::eq92_virial,
    )
}

/// A particle at rest, among all.
pub fn rest() -> Evidence {
    no_inside(
        Compared::one(
            "whether a particle meets the condition (1 if so)",
            "the expectation that only rest does not",
        )
        .over("random ones, that one, and some close to it"),
        ["ρ", "p"],
        [[0.0, 3.0]; 2],
        &[[0.5, 0.0], [2.0, 0.0]],
        |[_, p]| p > 0.0,
    )
}

/// A particle on the axis, among all.
pub fn axis() -> Evidence {
    no_inside(
        Compared::one(
            "whether a particle meets the condition (1 if so)",
            "the expectation that only the axis does not",
        )
        .over("random ones, that one, and some close to it"),
        ["ρ", "p"],
        [[0.0, 3.0]; 2],
        &[[0.0, 0.5], [0.0, 2.0]],
        |[rho, _]| rho > 0.0,
    )
}

/// (100), at rest.
pub fn eq100() -> Evidence {
    no_value(
        Compared::one("whether (100) has a value (1 if so)", "whether $p>0$")
            .over("some of them random, the others at rest"),
        ["p", "ℓ", "ξ"],
        [FAR; 3],
        [[int(0), int(1), int(1)]],
        |[p, ell, xi]| printed::eq100_ell_rate(p, ell, xi),
    )
}

/// (101), at rest.
pub fn eq101() -> Evidence {
    no_value(
        Compared::one("whether (101) has a value (1 if so)", "whether $p>0$")
            .over("some of them random, the others at rest"),
        ["p", "ℓ"],
        [FAR; 2],
        [[int(0), int(1)]],
        |[p, ell]| printed::eq101_xi_rate(p, ell),
    )
}

fn eq109(compared: Compared, excepted: [Interval; 2]) -> Evidence {
    let [p, rho] = excepted;
    no_value(
        compared,
        ["p", "ρ", "ψ"],
        [FAR; 3],
        [[p, rho, int(1)]],
        |[p, rho, psi]| printed::eq109_psi_rate(p, rho, psi),
    )
}

/// (109), at rest.
fn eq109_rest() -> Evidence {
    eq109(
        Compared::one("whether (109) has a value (1 if so)", "whether $p>0$")
            .over("some of them random, the others at rest"),
        [int(0), int(1)],
    )
}

/// (109), on the axis.
fn eq109_axis() -> Evidence {
    eq109(
        Compared::one("whether (109) has a value (1 if so)", r"whether $\rho>0$")
            .over("some of them random, the others on the axis"),
        [int(1), int(0)],
    )
}

/// (115), at rest.
pub fn eq115() -> Evidence {
    no_value(
        Compared::one("whether (115) has a value (1 if so)", r"whether $\alpha>0$")
            .over("some of them random, the others at rest"),
        ["α", "ψ"],
        [FAR; 2],
        [[int(0), int(1)]],
        |[alpha, psi]| printed::eq115_psi_rate(alpha, psi),
    )
}

/// (121), on the axis.
pub fn eq121() -> Evidence {
    no_value(
        Compared::one("whether (121) has a value (1 if so)", r"whether $\beta>0$")
            .over("some of them random, the others on the axis"),
        ["β", "ψ"],
        [FAR; 2],
        [[int(0), int(1)]],
        |[beta, psi]| printed::eq121_psi_rate(beta, psi),
    )
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq86, eq89, eq91, eq92, rest, eq100, eq101, axis, eq109_rest, eq109_axis, eq115, eq121
];
