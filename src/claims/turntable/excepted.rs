//! What the conditions of section 4 except: a particle at rest on the table, and one on the axis.

use super::prelude::*;
use trialbook::certified::interval::Interval;

const FAR: [f64; 2] = [0.5, 2.0];

fn int(n: i64) -> Interval {
    Interval::int(n)
}

/// A law in these coordinates, at one point that is excepted.
fn at<const N: usize>(
    excepted: &'static str,
    name: &'static str,
    holds: &'static str,
    coordinates: [&str; N],
    point: [i64; N],
    law: impl Fn([Interval; N]) -> Interval,
) -> Evidence {
    let coordinates = coordinates.map(|name| (name, FAR));
    no_value(name, holds, excepted, coordinates, [point.map(int)], law)
}

const REST: &str = "at rest";
const AXIS: &str = "on the axis";
const MOVES: &str = "$p>0$";

fn eq109([p, rho, psi]: [Interval; 3]) -> Interval {
    printed::eq109_psi_rate(p, rho, psi)
}

/// Position and velocity, and a point of rest.
const MOTION: [&str; 4] = ["x", "y", "v_x", "v_y"];
const STILL: [i64; 4] = [1, 2, 0, 0];

fn sum([x, y]: [Interval; 2]) -> Interval {
    x + y
}

attempts![
    eq86 = at(
        REST,
        "(86)",
        "the particle slides",
        MOTION,
        STILL,
        |[x, y, u, v]| {
            sum(printed::eq86_acceleration(
                int(1),
                int(1),
                int(1),
                [x, y],
                [u, v],
            ))
        }
    ),
    eq89 = at(
        REST,
        "(89)",
        "the particle slides",
        MOTION,
        STILL,
        |[x, y, u, v]| { sum(printed::eq89_acceleration([x, y], [u, v])) }
    ),
    eq91 = at(REST, "(91)", MOVES, MOTION, STILL, |[x, y, u, v]| {
        printed::eq91_moment([x, y], [u, v])
    }),
    eq92 = at(REST, "(92)", MOVES, MOTION, STILL, |[x, y, u, v]| {
        printed::eq92_virial([x, y], [u, v])
    }),
    rest = no_inside(
        "a particle",
        "one at rest",
        ["ρ", "p"].map(|name| (name, [0.0, 3.0])),
        &[[0.5, 0.0], [2.0, 0.0]],
        |[_, p]| p > 0.0,
    ),
    eq100 = at(
        REST,
        "(100)",
        MOVES,
        ["p", "ℓ", "ξ"],
        [0, 1, 1],
        |[p, ell, xi]| { printed::eq100_ell_rate(p, ell, xi) }
    ),
    eq101 = at(REST, "(101)", MOVES, ["p", "ℓ"], [0, 1], |[p, ell]| {
        printed::eq101_xi_rate(p, ell)
    }),
    axis = no_inside(
        "a particle",
        "one on the axis",
        ["ρ", "p"].map(|name| (name, [0.0, 3.0])),
        &[[0.0, 0.5], [0.0, 2.0]],
        |[rho, _]| rho > 0.0,
    ),
    eq109_rest = at(REST, "(109)", MOVES, ["p", "ρ", "ψ"], [0, 1, 1], eq109),
    eq109_axis = at(
        AXIS,
        "(109)",
        r"$\rho>0$",
        ["p", "ρ", "ψ"],
        [1, 0, 1],
        eq109
    ),
    eq115 = at(
        REST,
        "(115)",
        r"$\alpha>0$",
        ["α", "ψ"],
        [0, 1],
        |[alpha, psi]| { printed::eq115_psi_rate(alpha, psi) }
    ),
    eq121 = at(
        AXIS,
        "(121)",
        r"$\beta>0$",
        ["β", "ψ"],
        [0, 1],
        |[beta, psi]| { printed::eq121_psi_rate(beta, psi) }
    )
];
