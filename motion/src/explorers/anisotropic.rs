//! Section 2.4: a sine drive with one friction forwards and another backwards. Velocities in units of A₀/ϖ.

use super::{Answer, ExplorerError, spread, tray};
use crate::drive::{Drive, DriveError, DriveState, Friction, Interval, Sign};
use std::sync::LazyLock;

/// The orders of a period's intervals in the regions I to V.
pub const MANNERS: [&[Sign]; 5] = {
    use Sign::{Negative as N, Positive as P, Rest as O};
    [&[P, N], &[P, N, O], &[P, O, N, O], &[P, O], &[O]]
};

/// Above this λ₀ nothing moves.
const TOP: f64 = 1.4;
/// At λ₀ = 0 nothing ever settles.
const BOTTOM: f64 = 1e-3;

/// The motion with λ₊ = λ₀, λ₋ = qλ₀ from the velocity `w` at φ = 0.
///
/// Values: the region, 1 to 5 (0 for none), then those of [`tray::motion`], whose curves they are.
///
/// # Errors
/// A friction that is negative or not finite or none at all, `w` not finite or above 10⁹.
pub fn motion(q: f64, lambda0: f64, w: f64) -> Result<Answer, ExplorerError> {
    let friction = Friction::new(lambda0, q * lambda0)?;
    let (periodic, mut answer) = tray::motion(drive()?, friction, w)?;
    answer.values.insert(0, region(periodic.intervals()) as f64);
    Ok(answer)
}

/// The map of the regions for q from 1 to `to`.
///
/// Curves: the upper borders of the regions I to IV, λ₀ against q, to 10⁻⁴. Found by bisection on the periodic motion:
/// along a line of constant q the region never falls while λ₀ grows.
///
/// # Errors
/// As for [`motion`].
pub fn map(to: f64) -> Result<Answer, ExplorerError> {
    let mut curves = vec![Vec::new(); MANNERS.len() - 1];
    for q in spread(1.0, to, 80) {
        let mut least = BOTTOM;
        for (below, curve) in (1..).zip(&mut curves) {
            let mut most = TOP;
            while most - least > 1e-4 {
                let middle = 0.5 * (least + most);
                let friction = Friction::new(middle, q * middle)?;
                let start = DriveState { phi: 0.0, w: 0.0 };
                if region(tray::attractor(drive()?, friction, start)?.intervals()) > below {
                    most = middle;
                } else {
                    least = middle;
                }
            }
            curve.push([q, least]);
        }
    }
    Ok(Answer {
        values: Vec::new(),
        curves,
    })
}

/// Four periods from the given velocity at φ = 0, as [`tray::film`] shows them.
///
/// # Errors
/// As for [`motion`].
pub fn film(q: f64, lambda0: f64, w: f64) -> Result<Answer, ExplorerError> {
    let friction = Friction::new(lambda0, q * lambda0)?;
    // The floor accelerates by the opposite of the inertial force.
    tray::film(drive()?, friction, w, |phi| libm::sincos(phi).into())
}

pub(super) fn drive() -> Result<&'static Drive, DriveError> {
    static DRIVE: LazyLock<Result<Drive, DriveError>> =
        LazyLock::new(|| Drive::new(libm::sin, &[]));
    DRIVE.as_ref().map_err(Clone::clone)
}

/// 1 to 5; 0 if the order of intervals is none of the five.
fn region(intervals: &[Interval]) -> usize {
    let fits = |manner: &&[Sign]| manner.iter().copied().eq(intervals.iter().map(|i| i.sign));
    MANNERS.iter().position(fits).map_or(0, |i| i + 1)
}
