//! Section 2.4: a sine drive with one friction forwards and another backwards. Velocities in units of A₀/ϖ.

use super::{Answer, ExplorerError, spread};
use crate::motion::drive::{Attractor, Drive, DriveError, Friction, Interval, Sign, State};
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// The manners of the periodic motion by the order of a period's intervals, forwards, backwards and rest: the
/// regions I to V.
pub const MANNERS: [&[Sign]; 5] = {
    use Sign::{Negative as N, Positive as P, Rest as O};
    [&[P, N], &[P, N, O], &[P, O, N, O], &[P, O], &[O]]
};

/// Periods shown of the motion from the start.
const SHOWN: f64 = 4.0;
/// Far more periods than any motion here takes to become periodic.
const PERIODS: u32 = 200;
/// Above this λ₀ nothing moves.
const TOP: f64 = 1.4;
/// The map begins here: at λ₀ = 0 without friction nothing ever settles.
const BOTTOM: f64 = 1e-3;

/// The motion with λ₊ = λ₀, λ₋ = qλ₀ from the velocity `w` at φ = 0.
///
/// Values: the region, 1 to 5 (0 for none), the mean velocity of the periodic motion, its largest speed, the share of
/// the period in which it rests, the number of its intervals, and for each its sign (−1, 0, 1), its first and its
/// last phase in radians. Curves: velocity against phase from the start, and of the periodic motion, over four periods.
///
/// # Errors
/// A friction that is negative or not finite or none at all, `w` not finite or above 10⁹.
pub fn motion(q: f64, lambda0: f64, w: f64) -> Result<Answer, ExplorerError> {
    let friction = Friction::new(lambda0, q * lambda0)?;
    let (mut state, until) = (State { phi: 0.0, w }, SHOWN * TAU);
    let periodic = attractor(friction, state)?;
    let mut shown = vec![[0.0, w]];
    for phi in spread(0.0, until, 400).skip(1) {
        let path = drive()?.advance(friction, state, phi)?;
        // The corner where a rest begins or ends is a point of the curve.
        shown.extend(path.intervals.iter().skip(1).map(|i| [i.start, 0.0]));
        state = path.end;
        shown.push([phi, state.w]);
    }
    let intervals = periodic.intervals();
    let at_rest = intervals.iter().filter(|i| i.sign == Sign::Rest);
    let mut values = vec![
        region(intervals) as f64,
        periodic.displacement() / TAU,
        periodic.largest().w.abs(),
        at_rest.map(Interval::length).sum::<f64>() / TAU,
        intervals.len() as f64,
    ];
    for interval in intervals {
        values.extend([interval.sign.factor(), interval.start, interval.end]);
    }
    let repeated = spread(0.0, until, 400).map(|phi| [phi, periodic.w(phi)]);
    Ok(Answer {
        values,
        curves: vec![shown, repeated.collect()],
    })
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
    for q in spread(1.0, to, 120) {
        let mut least = BOTTOM;
        for (below, curve) in (1..).zip(&mut curves) {
            let mut most = TOP;
            while most - least > 1e-4 {
                let middle = 0.5 * (least + most);
                let friction = Friction::new(middle, q * middle)?;
                let start = State { phi: 0.0, w: 0.0 };
                if region(attractor(friction, start)?.intervals()) > below {
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

/// The drive sin φ.
fn drive() -> Result<&'static Drive, DriveError> {
    static DRIVE: LazyLock<Result<Drive, DriveError>> =
        LazyLock::new(|| Drive::new(libm::sin, &[]));
    DRIVE.as_ref().map_err(Clone::clone)
}

/// The periodic motion that a start leads to. The mean of the drive is zero: with friction none drifts.
fn attractor(friction: Friction, start: State) -> Result<Attractor<'static>, DriveError> {
    let outcome = drive()?.attractor(friction, start, PERIODS)?;
    outcome.settled().ok_or(DriveError::NotSettled {
        periods: PERIODS,
        change: f64::NAN,
    })
}

/// The region, 1 to 5, of a periodic motion; 0 if its order of intervals is none of the five.
fn region(intervals: &[Interval]) -> usize {
    let fits = |manner: &&[Sign]| manner.iter().copied().eq(intervals.iter().map(|i| i.sign));
    MANNERS.iter().position(fits).map_or(0, |i| i + 1)
}
