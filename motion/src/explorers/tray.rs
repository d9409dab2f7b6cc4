//! A block on a floor that is shaken along a line. Velocities in units of A₀/ϖ, lengths in units of A₀/ϖ².

use super::{Answer, ExplorerError, PICTURES, spread};
use crate::drive::{Attractor, Drive, DriveError, DriveState, Friction, Interval, Sign};
use std::f64::consts::TAU;

const SHOWN: f64 = 4.0;
/// Far more than any motion here takes to become periodic.
const PERIODS: u32 = 200;

/// The periodic motion that the velocity `w` at φ = 0 leads to, and what is shown of the way there.
///
/// Values: the mean velocity of the periodic motion, its largest speed, the share of the period in which it rests, the
/// number of its intervals, and for each its sign (−1, 0, 1), its first and its last phase in radians. Curves: velocity
/// against phase from the start, and of the periodic motion, over four periods.
///
/// # Errors
/// `w` not finite or above 10⁹, or a motion that does not become periodic in 200 periods.
pub fn motion(
    drive: &Drive,
    friction: Friction,
    w: f64,
) -> Result<(Attractor<'_>, Answer), ExplorerError> {
    let (mut state, until) = (DriveState { phi: 0.0, w }, SHOWN * TAU);
    let periodic = attractor(drive, friction, state)?;
    let mut shown = vec![[0.0, w]];
    for phi in spread(0.0, until, 400).skip(1) {
        let path = drive.advance(friction, state, phi)?;
        // The corner where a rest begins or ends is a point of the curve.
        shown.extend(path.intervals.iter().skip(1).map(|i| [i.start, 0.0]));
        state = path.end;
        shown.push([phi, state.w]);
    }
    let intervals = periodic.intervals();
    let at_rest = intervals.iter().filter(|i| i.sign == Sign::Rest);
    let mut values = vec![
        periodic.displacement() / TAU,
        periodic.largest().w.abs(),
        at_rest.map(Interval::length).sum::<f64>() / TAU,
        intervals.len() as f64,
    ];
    for interval in intervals {
        values.extend([interval.sign.factor(), interval.start, interval.end]);
    }
    let repeated = spread(0.0, until, 400).map(|phi| [phi, periodic.w(phi)]);
    let curves = vec![shown, repeated.collect()];
    Ok((periodic, Answer { values, curves }))
}

/// Four periods from the velocity `w` at φ = 0, at equal times, for a moving picture. `floor` is the floor's displacement
/// in the laboratory and its velocity at a phase.
///
/// Values: the phase between the pictures. Curves: the displacements of the floor in the laboratory and of the block on
/// the floor (by Simpson's rule between the pictures); and their velocities.
///
/// # Errors
/// `w` not finite or above 10⁹.
pub fn film(
    drive: &Drive,
    friction: Friction,
    w: f64,
    floor: impl Fn(f64) -> [f64; 2],
) -> Result<Answer, ExplorerError> {
    let step = SHOWN * TAU / f64::from(PICTURES);
    let (mut state, mut x) = (DriveState { phi: 0.0, w }, 0.0);
    let mut curves = [Vec::new(), Vec::new()];
    for phi in spread(0.0, SHOWN * TAU, PICTURES) {
        if phi > state.phi {
            let middle = drive.advance(friction, state, phi - 0.5 * step)?.end;
            let end = drive.advance(friction, middle, phi)?.end;
            x += step / 6.0 * (state.w + 4.0 * middle.w + end.w);
            state = end;
        }
        let [place, velocity] = floor(phi);
        curves[0].push([place, x]);
        curves[1].push([velocity, state.w]);
    }
    Ok(Answer {
        values: vec![step],
        curves: curves.into(),
    })
}

/// The drive's mean has to be zero: then none drifts.
pub(super) fn attractor(
    drive: &Drive,
    friction: Friction,
    start: DriveState,
) -> Result<Attractor<'_>, DriveError> {
    let outcome = drive.attractor(friction, start, PERIODS)?;
    outcome.settled().ok_or(DriveError::NotSettled {
        periods: PERIODS,
        change: f64::NAN,
    })
}
