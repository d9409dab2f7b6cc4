//! Section 2.2: a block on a floor that is shaken along a line, with a velocity across it. Units as for the [tray](super::tray).

use super::{Answer, ExplorerError, PICTURES, anisotropic::drive, spread};
use crate::drive::PlanarState;
use std::f64::consts::TAU;

const SHOWN: f64 = 4.0;
/// The logarithm of a velocity across is shown down to here.
const DEEPEST: f64 = -1e3;

/// Four periods from the velocities `along` and `across` the drive sin φ at φ = 0, at equal times, for a moving picture.
///
/// Values: the phase between the pictures, and the phase from which the velocity across is exactly 0 (to a half of that
/// phase; −1 if it is not within four periods). Curves: the displacements along the drive of the floor in the laboratory and
/// of the block on the floor; their velocities; and the displacement of the block across the drive with the negative
/// logarithm of its velocity there, at most 1000. Displacements by Simpson's rule between the pictures.
///
/// # Errors
/// A friction that is negative or not finite, a velocity that is not finite or above 10⁸, `across` negative.
pub fn film(lambda0: f64, along: f64, across: f64) -> Result<Answer, ExplorerError> {
    let step = SHOWN * TAU / f64::from(PICTURES);
    let start = PlanarState {
        phi: 0.0,
        w_x: along,
        ln_w_y: libm::log(across),
    };
    let phases: Vec<f64> = spread(0.0, SHOWN * TAU, 2 * PICTURES).collect();
    let states = drive()?.planar(lambda0, start, &phases)?;
    let gone = states.iter().find(|s| s.ln_w_y == f64::NEG_INFINITY);
    let velocity = |state: &PlanarState| [state.w_x, libm::exp(state.ln_w_y)];
    let mut place = [0.0; 2];
    let mut curves = [Vec::new(), Vec::new(), Vec::new()];
    for (i, state) in states.iter().enumerate().step_by(2) {
        if let (Some(before), Some(middle)) = (i.checked_sub(2), i.checked_sub(1)) {
            let [a, b, c] = [before, middle, i].map(|k| velocity(&states[k]));
            for k in 0..2 {
                place[k] += step / 6.0 * (a[k] + 4.0 * b[k] + c[k]);
            }
        }
        // The floor accelerates by the opposite of the inertial force.
        let (sine, cosine) = libm::sincos(state.phi);
        curves[0].push([sine, place[0]]);
        curves[1].push([cosine, state.w_x]);
        curves[2].push([place[1], -state.ln_w_y.max(DEEPEST)]);
    }
    Ok(Answer {
        values: vec![step, gone.map_or(-1.0, |state| state.phi)],
        curves: curves.into(),
    })
}
