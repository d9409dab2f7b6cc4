//! Section 2.3: a drive that is no sine, a sine with its third harmonic. Velocities in units of A₀/ϖ, where A₀ is the drive's
//! largest size.

use super::{Answer, ExplorerError, spread, tray};
use crate::motion::drive::{Drive, DriveError, Friction};
use std::f64::consts::TAU;

/// The drive sin φ + a sin 3φ over its largest size, and that size.
fn drive(third: f64) -> Result<(Drive, f64), DriveError> {
    let sum = |phi: f64| libm::sin(phi) + third * libm::sin(3.0 * phi);
    let size = Drive::new(sum, &[])?.shape().size();
    Ok((Drive::new(|phi| sum(phi) / size, &[])?, size))
}

/// The motion from the velocity `w` at φ = 0, with `third` times as much of the third harmonic as of the sine.
///
/// Values: those of [`tray::motion`]. Curves: its own, then the drive over four periods.
///
/// # Errors
/// A friction that is not positive and finite, `third` not finite, `w` not finite or above 10⁹.
pub fn motion(third: f64, lambda0: f64, w: f64) -> Result<Answer, ExplorerError> {
    let (drive, _) = drive(third)?;
    let friction = Friction::new(lambda0, lambda0)?;
    let (_, mut answer) = tray::motion(&drive, friction, w)?;
    let shape = spread(0.0, 4.0 * TAU, 400).map(|phi| [phi, drive.h(phi)]);
    answer.curves.push(shape.collect());
    Ok(answer)
}

/// Four periods of it, as [`tray::film`] shows them.
///
/// # Errors
/// As for [`motion`].
pub fn film(third: f64, lambda0: f64, w: f64) -> Result<Answer, ExplorerError> {
    let (drive, size) = drive(third)?;
    let friction = Friction::new(lambda0, lambda0)?;
    // The floor accelerates by the opposite of the inertial force.
    tray::film(&drive, friction, w, |phi| {
        let [(s, c), (s3, c3)] = [libm::sincos(phi), libm::sincos(3.0 * phi)];
        [(s + third * s3 / 9.0) / size, (c + third * c3 / 3.0) / size]
    })
}
