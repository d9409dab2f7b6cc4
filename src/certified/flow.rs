//! Validated integration: steps that enclose every motion from every start of a box.
//!
//! A step of length h does three things (Moore; Lohner). It finds a box that no motion from the start box leaves
//! during the step, by Picard's iteration: B with x + \[0, h\] f(B) ⊂ B. It sums Taylor's series about the start box,
//! with the last coefficient taken over all of B: that bounds what the series leaves out. And it does the same for
//! the middle m of the start box and for the matrix J of derivatives by the start, so that the result is also
//! within φ(m) + J (x − m), in which the widths shrink where the motions approach each other.

use super::error::CertifiedError;
use super::interval::Interval;
use crate::numerics::number::Number;
use crate::numerics::series::Series;
use crate::numerics::taylor::{Control, Integrator, System};

/// Coefficients of a series; the last one is that of the remainder.
pub const TERMS: usize = 14;

/// The longest step that is tried, and how often it is halved before the integration is given up.
const LONGEST: f64 = 0.25;
const HALVINGS: u32 = 30;

/// A state of three components and its derivatives by three of the start: the state, then row by row.
pub type Extended = [Interval; 12];

/// The components at the start of a step: those of the state, and the unit matrix.
fn extended(state: [Interval; 3]) -> Extended {
    std::array::from_fn(|i| match i {
        0..3 => state[i],
        _ => Interval::point(if (i - 3) % 4 == 0 { 1.0 } else { 0.0 }),
    })
}

/// One step of a system that does not depend on the time, as long as it can well be; the state after it.
///
/// # Errors
/// [`CertifiedError::NotProved`] if no box is found that the motions do not leave.
pub fn step<S: System<Interval, 12, TERMS>>(
    system: &S,
    state: &[Interval; 3],
) -> Result<[Interval; 3], CertifiedError> {
    let mut h = LONGEST;
    for _ in 0..HALVINGS {
        if let Some(next) = attempt(system, state, h) {
            return Ok(next);
        }
        h *= 0.5;
    }
    Err(CertifiedError::unproved("no step encloses the motion", state))
}

fn attempt<S: System<Interval, 12, TERMS>>(
    system: &S,
    state: &[Interval; 3],
    h: f64,
) -> Option<[Interval; 3]> {
    let start = extended(*state);
    let walls = walls(system, &start, h)?;
    let rest = series(system, &walls)?;
    let sum = |start: &Extended| -> Option<Extended> {
        let series = series(system, start)?;
        Some(std::array::from_fn(|i| {
            let length = Interval::point(h);
            (0..TERMS - 1).rev().fold(rest[i][TERMS - 1], |sum, k| sum * length + series[i][k])
        }))
    };
    let middle = state.map(|x| Interval::point(x.mid()));
    let (all, centre) = (sum(&start)?, sum(&extended(middle))?);
    let mut next = *state;
    for i in 0..3 {
        let mut value = centre[i];
        for j in 0..3 {
            value = value + all[3 + 3 * i + j] * (state[j] - middle[j]);
        }
        next[i] = value.meet(all[i])?;
    }
    Some(next)
}

/// Coefficients of the series about each start of a box.
fn series<S: System<Interval, 12, TERMS>>(
    system: &S,
    start: &Extended,
) -> Option<[Series<Interval, TERMS>; 12]> {
    let zero = Interval::from_f64(0.0);
    let mut integrator = Integrator::new(system, zero, *start, Control::Largest);
    Some(integrator.expand().ok()?.series)
}

/// A box that no motion from `start` leaves within the time `h`.
fn walls<S: System<Interval, 12, TERMS>>(system: &S, start: &Extended, h: f64) -> Option<Extended> {
    let time = Interval::new(0.0, h);
    let reached = |walls: &Extended| -> Extended {
        let mut work = S::Work::default();
        system.begin(&Interval::point(0.0), walls, &mut work);
        let zero = Interval::point(0.0);
        let constant = walls.map(|x| std::array::from_fn(|k| if k == 0 { x } else { zero }));
        let slope = system.derivative(0, &constant, &mut work);
        std::array::from_fn(|i| start[i] + time * slope[i])
    };
    let mut walls = *start;
    for _ in 0..8 {
        let next = reached(&walls);
        if next.iter().zip(&walls).all(|(a, b)| a.within(*b)) {
            return Some(next);
        }
        // Farther than necessary, or the iteration would not end.
        walls = next.map(|x| x.widened(0.2 * x.width() + 1e-9));
    }
    None
}
