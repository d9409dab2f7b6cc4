//! What the conditions of section 4 except: a particle at rest on the table, and one on the axis.

use crate::certified::interval::Interval;
use crate::claims::excepted::{no_inside, no_value};
use crate::evidence::Evidence;
use crate::paper::turntable as printed;
use crate::scalar::Scalar;

const FAR: [f64; 2] = [0.5, 2.0];

fn int(n: i64) -> Interval {
    Interval::int(n)
}

/// A formula by position and velocity, where that velocity vanishes.
fn at_rest(
    compared: &'static str,
    law: impl Fn([Interval; 2], [Interval; 2]) -> Interval,
) -> Evidence {
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
        "whether (86) has a value, at random and at rest, with whether the particle slides",
        |r, v| sum(printed::eq86_acceleration(int(1), int(1), int(1), r, v)),
    )
}

/// (89), at rest.
pub fn eq89() -> Evidence {
    at_rest(
        "whether (89) has a value, at random and at rest, with whether the particle slides",
        |r, v| sum(printed::eq89_acceleration(r, v)),
    )
}

/// (91), at rest.
pub fn eq91() -> Evidence {
    at_rest(
        "whether (91) has a value, at random and at rest, with whether p > 0",
        printed::eq91_moment,
    )
}

/// (92), at rest.
pub fn eq92() -> Evidence {
    at_rest(
        "whether (92) has a value, at random and at rest, with whether p > 0",
        printed::eq92_virial,
    )
}

/// A particle at rest, among all.
pub fn rest() -> Evidence {
    no_inside(
        "whether a particle is at rest, with that it is not at random and close to it",
        ["ρ", "p"],
        [[0.0, 3.0]; 2],
        &[[0.5, 0.0], [2.0, 0.0]],
        |[_, p]| p > 0.0,
    )
}

/// A particle on the axis, among all.
pub fn axis() -> Evidence {
    no_inside(
        "whether a particle is on the axis, with that it is not at random and close to it",
        ["ρ", "p"],
        [[0.0, 3.0]; 2],
        &[[0.0, 0.5], [0.0, 2.0]],
        |[rho, _]| rho > 0.0,
    )
}

/// (100), at rest.
pub fn eq100() -> Evidence {
    no_value(
        "whether (100) has a value, at random and at rest, with whether p > 0",
        ["p", "ℓ", "ξ"],
        [FAR; 3],
        [[int(0), int(1), int(1)]],
        |[p, ell, xi]| printed::eq100_ell_rate(p, ell, xi),
    )
}

/// (101), at rest.
pub fn eq101() -> Evidence {
    no_value(
        "whether (101) has a value, at random and at rest, with whether p > 0",
        ["p", "ℓ"],
        [FAR; 2],
        [[int(0), int(1)]],
        |[p, ell]| printed::eq101_xi_rate(p, ell),
    )
}

fn eq109(compared: &'static str, excepted: [Interval; 2]) -> Evidence {
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
pub fn eq109_rest() -> Evidence {
    eq109(
        "whether (109) has a value, at random and at rest, with whether p > 0",
        [int(0), int(1)],
    )
}

/// (109), on the axis.
pub fn eq109_axis() -> Evidence {
    eq109(
        "whether (109) has a value, at random and on the axis, with whether ρ > 0",
        [int(1), int(0)],
    )
}

/// (115), at rest.
pub fn eq115() -> Evidence {
    no_value(
        "whether (115) has a value, at random and at rest, with whether α > 0",
        ["α", "ψ"],
        [FAR; 2],
        [[int(0), int(1)]],
        |[alpha, psi]| printed::eq115_psi_rate(alpha, psi),
    )
}

/// (121), on the axis.
pub fn eq121() -> Evidence {
    no_value(
        "whether (121) has a value, at random and on the axis, with whether β > 0",
        ["β", "ψ"],
        [FAR; 2],
        [[int(0), int(1)]],
        |[beta, psi]| printed::eq121_psi_rate(beta, psi),
    )
}
