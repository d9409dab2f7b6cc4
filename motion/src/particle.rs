//! A particle on the plane: it slides and sticks, one phase after the other.

mod line;
mod slide;
mod start;
mod stick;

#[cfg(all(test, feature = "trials"))]
mod tests;

pub use line::Line;

use super::{
    acceleration::{Acceleration, check_time, most_steps},
    error::{MotionError, check, finite},
    trajectory::{Arc, Motion, Phase, PhaseKind, Piece, State},
};
use crate::numerics::{
    series::value,
    taylor::{Coefficients, reach},
};

/// Coulomb friction per unit of mass, in length/time². A number holds as much as it brakes: `0.3 * g`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// μg, against a body that slides.
    pub kinetic: f64,
    /// μ_s g, up to which one at rest is held: not below `kinetic`.
    pub holding: f64,
}

impl From<f64> for Friction {
    fn from(kinetic: f64) -> Self {
        Self {
            kinetic,
            holding: kinetic,
        }
    }
}

impl Friction {
    fn check(&self) -> Result<(), MotionError> {
        size("friction", self.kinetic)?;
        let fit = self.holding >= self.kinetic && self.holding <= LARGEST;
        check(
            "holding",
            self.holding,
            fit,
            "not below the kinetic friction, at most 1e50",
        )
    }
}

/// Its square has to be a number.
fn size(name: &'static str, value: f64) -> Result<(), MotionError> {
    let fit = value == 0.0 || (SMALLEST..=LARGEST).contains(&value);
    check(name, value, fit, "0 or between 1e-50 and 1e50")
}

/// The motion of a particle from `start` until the time `until`, on a plane that accelerates by A(t), [pulled](super) along −A,
/// with the `friction` (μg, or a [`Friction`] that holds more than it brakes). A start with v = 0 is allowed: it sticks or begins
/// to slide.
///
/// Stop and start times, v and t are right to about 10⁻¹² relative where the problem is well conditioned, but for the
/// acceleration's own error: see [`Motion::drive_error`]. The time scales of the acceleration should lie between 10⁻¹⁰ and 10¹⁰
/// of the unit of time.
///
/// # Errors
/// [`MotionError::Argument`] for a parameter that is not finite or out of range: friction, speed and |A| are 0 or
/// between 10⁻⁵⁰ and 10⁵⁰, what holds is not below what brakes, times and positions at most 10⁵⁰ in absolute value, `until` not before the start.
/// [`MotionError::Numerics`] when the motion leaves the finite numbers.
/// [`MotionError::Outside`] for times at which the acceleration is not known.
/// [`MotionError::Steps`] for a motion of more than 50,000 steps, and a hundred for each piece of the acceleration.
pub fn run(
    plane: &dyn Acceleration,
    friction: impl Into<Friction>,
    start: State,
    until: f64,
) -> Result<Motion, MotionError> {
    let run = Run::new(plane, friction.into(), start, until)?;
    check_time(plane, until)?;
    run.finish(false)
}

/// As [`run`], in cost too, but ends with the first stop, up to which the acceleration has to be known. If there is none before
/// `until`, [`Motion::first_stop`] is empty.
///
/// # Errors
/// As for [`run`].
pub fn run_to_stop(
    plane: &dyn Acceleration,
    friction: impl Into<Friction>,
    start: State,
    until: f64,
) -> Result<Motion, MotionError> {
    Run::new(plane, friction.into(), start, until)?.finish(true)
}

/// Largest and smallest sizes whose squares and high powers are still numbers.
const LARGEST: f64 = 1e50;
const SMALLEST: f64 = 1e-50;

struct Run<'a> {
    plane: &'a dyn Acceleration,
    friction: f64,
    holding: f64,
    until: f64,
    steps: usize,
    state: State,
    motion: Motion,
}

struct Local {
    a: [Coefficients; 2],
    /// What its last coefficients allow, up to the next break or the end of the motion.
    left: f64,
    /// The time at which `left` is over, if a break or the end ends it.
    landing: Option<f64>,
}

impl<'a> Run<'a> {
    fn new(
        plane: &'a dyn Acceleration,
        friction: Friction,
        start: State,
        until: f64,
    ) -> Result<Self, MotionError> {
        friction.check()?;
        for (name, value) in [
            ("t of the start", start.t),
            ("x of the start", start.x[0]),
            ("y of the start", start.x[1]),
            ("v_x of the start", start.v[0]),
            ("v_y of the start", start.v[1]),
        ] {
            check(
                name,
                value,
                value.abs() <= LARGEST,
                "finite, at most 1e50 in absolute value",
            )?;
        }
        size("speed of the start", start.speed())?;
        let fit = until >= start.t && until <= LARGEST;
        check("until", until, fit, "not before the start, at most 1e50")?;
        check_time(plane, start.t)?;
        let motion = Motion::begin(start, plane.error());
        Ok(Self {
            plane,
            friction: friction.kinetic,
            holding: friction.holding,
            until,
            steps: 0,
            state: start,
            motion,
        })
    }

    fn finish(mut self, to_stop: bool) -> Result<Motion, MotionError> {
        while self.state.t < self.until {
            if self.state.v == [0.0; 2] {
                let from = self.state.t;
                let release = self.stick()?;
                self.close(PhaseKind::Stick, from);
                let Some(release) = release else { break };
                let from = self.state.t;
                self.depart(release)?;
                if self.state.v == [0.0; 2] {
                    continue;
                }
                self.motion.starts.push(from);
                self.close(PhaseKind::Slide, from);
            }
            let from = self.state.t;
            let stopped = self.slide()?;
            self.close(PhaseKind::Slide, from);
            if stopped {
                self.motion.stops.push(self.state.t);
                if to_stop {
                    break;
                }
            }
        }
        self.done()
    }

    fn done(mut self) -> Result<Motion, MotionError> {
        let State { t, v, x } = self.state;
        finite(t, &[v, x].concat())?;
        self.motion.end = self.state;
        Ok(self.motion)
    }

    fn local(&mut self) -> Result<Local, MotionError> {
        let t = self.state.t;
        self.steps += 1;
        let limit = most_steps(self.plane);
        if self.steps > limit {
            return Err(MotionError::Steps { limit, t });
        }
        if t >= self.plane.times()[1] {
            check_time(self.plane, self.until)?;
        }
        let a = self.plane.coefficients(t);
        let size = libm::hypot(a[0][0], a[1][0]);
        check("|A|", size, size <= LARGEST, "finite, at most 1e50")?;
        if let Some(c) = a.iter().flatten().find(|c| !c.is_finite()) {
            check("a Taylor coefficient of A", *c, false, "finite")?;
        }
        let landing = self
            .plane
            .next_break(t)
            .map_or(self.until, |b| b.min(self.until));
        let trusted = reach(&a[0]).min(reach(&a[1]));
        Ok(if trusted < landing - t {
            Local {
                a,
                left: trusted,
                landing: None,
            }
        } else {
            Local {
                a,
                left: landing - t,
                landing: Some(landing),
            }
        })
    }

    /// Over the time `h`, or until it lands, with a velocity known by its series.
    fn arc(&mut self, v: [Coefficients; 2], h: f64, landing: Option<f64>) {
        let State { t, x, .. } = self.state;
        let path: [Coefficients; 2] = [0, 1].map(|i| {
            let order = |k: usize| k.checked_sub(1).map_or(x[i], |j| v[i][j] / k as f64);
            std::array::from_fn(order)
        });
        let to = landing.unwrap_or(t + h).min(self.until);
        let both = |c: &[Coefficients; 2]| [value(&c[0], &h), value(&c[1], &h)];
        let end = State {
            t: to,
            v: both(&v),
            x: both(&path),
        };
        let arc = Arc {
            from: t,
            to,
            v,
            x: path,
        };
        self.push(Piece::Arc(Box::new(arc)), end);
    }

    fn push(&mut self, piece: Piece, state: State) {
        self.motion.pieces.push(piece);
        self.state = state;
    }

    /// Two slides that follow each other without a stop are one.
    fn close(&mut self, kind: PhaseKind, from: f64) {
        let to = self.state.t;
        let stopped_here = self.motion.stops.last() == Some(&from);
        match self.motion.phases.last_mut() {
            Some(last) if last.kind == kind && !stopped_here => last.to = to,
            _ if to > from => self.motion.phases.push(Phase { kind, from, to }),
            _ => {}
        }
    }
}
