//! The two numbers of each case by hand. The words are in the claims' entries.

use super::prelude::*;
use super::projections;
use crate::motion::State;

/// In the paper's order: what the printed formula says, and what the motion does.
pub(super) static CASES: [Numbers; 4] = [
    Numbers::new(
        "s4-projection-azimuthal",
        || Ok(printed::s4_azimuthal_rate(1.0, 1.0, 2.0, 0.0)),
        || projections::in_the_motion(|v| v.ell),
    ),
    Numbers::new(
        "s4-projection-radial",
        || Ok(printed::s4_radial_rate(1.0, 1.0, 2.0, 0.0)),
        || projections::in_the_motion(|v| v.xi),
    ),
    Numbers::new(
        "eq-106",
        || Ok(-printed::friction_work(1.0, 10.0, way()?)),
        energy_lost,
    ),
    Numbers::new(
        "s4-coriolis-no-work",
        || Ok(printed::friction_work(1.0, 10.0, way()?)),
        || Ok(-energy_lost()?),
    ),
];

/// The motion of a particle that friction of 5 slows down from the velocity 5: its end.
fn stopped() -> Result<State, Failure> {
    let start = State {
        t: 0.0,
        v: [5.0, 0.0],
        x: [0.0, 0.0],
    };
    Ok(run(&Plane::constant([0.0, 0.0]), 5.0, start, 2.0)?.end())
}

fn way() -> Result<f64, Failure> {
    Ok(stopped()?.x[0])
}

/// The kinetic energy that it loses, mass 1.
fn energy_lost() -> Result<f64, Failure> {
    let v = stopped()?.v[0];
    Ok(0.5 * (25.0 - v * v))
}
