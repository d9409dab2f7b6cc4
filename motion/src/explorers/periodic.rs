//! Section 2.3: a drive that is no sine, a sine with its third harmonic or a train of pulses. Velocities in units of A₀/ϖ, where
//! A₀ is the drive's largest size.

use super::{Answer, ExplorerError, spread, tray};
use crate::MotionError;
use crate::drive::{Drive, DriveError, Friction};
use std::f64::consts::{PI, TAU};

/// The drive, and the displacement and velocity of the floor that it shakes, in the laboratory.
struct Shaken {
    drive: Drive,
    floor: Box<dyn Fn(f64) -> [f64; 2]>,
}

impl Shaken {
    /// In the share η of each half period; without any, the sine.
    fn new(third: f64, eta: f64) -> Result<Self, ExplorerError> {
        match eta {
            0.0 => Ok(Self::sine(third)?),
            eta if 0.0 < eta && eta < 1.0 => Ok(Self::pulses(eta)?),
            value => Err(ExplorerError::Motion(MotionError::Argument {
                name: "eta",
                value,
                range: "at least 0 and below 1",
            })),
        }
    }

    /// sin φ + a sin 3φ over its largest size.
    fn sine(third: f64) -> Result<Self, DriveError> {
        let sum = move |phi: f64| libm::sin(phi) + third * libm::sin(3.0 * phi);
        let size = Drive::new(sum, &[])?.shape().size();
        // The floor accelerates by the opposite of the inertial force.
        let floor = move |phi: f64| {
            let [(s, c), (s3, c3)] = [libm::sincos(phi), libm::sincos(3.0 * phi)];
            [(s + third * s3 / 9.0) / size, (c + third * c3 / 3.0) / size]
        };
        Ok(Shaken {
            drive: Drive::new(|phi| sum(phi) / size, &[])?,
            floor: Box::new(floor),
        })
    }

    /// 1 for 0 < φ < ηπ, −1 half a period later, 0 in the gaps.
    fn pulses(eta: f64) -> Result<Self, DriveError> {
        let end = eta * PI;
        let half = |phi: f64| match phi.rem_euclid(TAU) {
            phi if phi < PI => (1.0, phi),
            phi => (-1.0, phi - PI),
        };
        let h = move |phi: f64| {
            let (sign, phi) = half(phi);
            if phi < end { sign } else { 0.0 }
        };
        // In a gap the floor keeps its velocity.
        let floor = move |phi: f64| {
            let (sign, phi) = half(phi);
            let pushed = phi.min(end);
            let place = 0.25 * end * (PI - end) + 0.5 * pushed * (end - pushed)
                - 0.5 * end * (phi - pushed);
            [sign * place, sign * (0.5 * end - pushed)]
        };
        Ok(Shaken {
            drive: Drive::new(h, &[end, PI, PI + end])?,
            floor: Box::new(floor),
        })
    }
}

/// The motion from the velocity `w` at φ = 0, with `third` times as much of the third harmonic as of the sine; or, if `eta` is
/// not 0, under pulses of size 1 that fill this share of each half period.
///
/// Values: those of [`tray::motion`]. Curves: its own, then the drive over four periods.
///
/// # Errors
/// A friction that is not positive and finite, `third` not finite, `eta` outside [0, 1), `w` not finite or above 10⁹.
pub fn motion(third: f64, lambda0: f64, w: f64, eta: f64) -> Result<Answer, ExplorerError> {
    let Shaken { drive, .. } = Shaken::new(third, eta)?;
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
pub fn film(third: f64, lambda0: f64, w: f64, eta: f64) -> Result<Answer, ExplorerError> {
    let Shaken { drive, floor } = Shaken::new(third, eta)?;
    let friction = Friction::new(lambda0, lambda0)?;
    tray::film(&drive, friction, w, floor)
}
