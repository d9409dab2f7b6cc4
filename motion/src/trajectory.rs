//! A finished motion: what happened when, and the state at any time in between.

use super::{
    error::MotionError,
    track::{Part, Track},
};
use crate::numerics::{
    events::roots,
    series::{arrival, change, value},
    taylor::{Coefficients, Step, TERMS},
};

/// State of a particle: on a plane in its frame, on a turntable in the frame that is named.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Time.
    pub t: f64,
    /// Velocity, in length/time.
    pub v: [f64; 2],
    /// Position, in length.
    pub x: [f64; 2],
}

impl State {
    /// At the origin at the time 0, with this velocity.
    pub const fn moving(v: [f64; 2]) -> Self {
        State {
            t: 0.0,
            v,
            x: [0.0; 2],
        }
    }

    /// |v|.
    pub fn speed(&self) -> f64 {
        libm::hypot(self.v[0], self.v[1])
    }

    /// Distance |x| from the origin: on a turntable, from the axis.
    pub fn radius(&self) -> f64 {
        libm::hypot(self.x[0], self.x[1])
    }

    /// Angle of v with the x axis in (−π, π]; 0 at rest.
    pub fn direction(&self) -> f64 {
        libm::atan2(self.v[1], self.v[0])
    }
}

/// Sliding or sticking.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PhaseKind {
    /// In motion relative to the plane.
    Slide,
    /// At rest relative to the plane.
    Stick,
}

/// A stretch of time of one kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// Sliding or sticking.
    pub kind: PhaseKind,
    /// When it begins.
    pub from: f64,
    /// When it ends.
    pub to: f64,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Piece {
    /// Sliding; components v_x, v_y, t, x, y as functions of s, dt = |v| ds.
    Slide(Box<Step<f64, 5, TERMS>>),
    /// Sliding close to rest; v and x as functions of t.
    Arc(Box<Arc>),
    Rest {
        from: f64,
        x: [f64; 2],
    },
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Arc {
    pub(super) from: f64,
    pub(super) to: f64,
    /// Of the velocity and of the position.
    pub(super) v: [Coefficients; 2],
    pub(super) x: [Coefficients; 2],
}

impl Arc {
    fn state(&self, t: f64) -> State {
        let tau = t - self.from;
        let both = |c: &[Coefficients; 2]| [value(&c[0], &tau), value(&c[1], &tau)];
        State {
            t,
            v: both(&self.v),
            x: both(&self.x),
        }
    }
}

impl Piece {
    fn from(&self) -> f64 {
        match self {
            Self::Slide(step) => step.t_start(),
            Self::Arc(arc) => arc.from,
            Self::Rest { from, .. } => *from,
        }
    }

    fn begin(&self) -> State {
        match self {
            Self::Slide(step) => step.state(0.0, step.t_start()),
            Self::Arc(arc) => arc.state(arc.from),
            Self::Rest { from, x } => State {
                t: *from,
                v: [0.0; 2],
                x: *x,
            },
        }
    }

    pub(super) fn at(&self, t: f64) -> Result<State, MotionError> {
        Ok(match self {
            Self::Slide(step) => step.state(step.s_at(t - step.t_start()), t),
            Self::Arc(arc) => arc.state(t),
            Self::Rest { x, .. } => State {
                t,
                v: [0.0; 2],
                x: *x,
            },
        })
    }

    /// Where the velocity points at the beginning or, from rest, right after it; zero for a rest.
    fn heading(&self) -> [f64; 2] {
        match self {
            Self::Arc(arc) => {
                let mut orders = (0..TERMS).map(|k| [arc.v[0][k], arc.v[1][k]]);
                orders.find(|v| *v != [0.0; 2]).unwrap_or_default()
            }
            _ => self.begin().v,
        }
    }

    fn along(&self, n: [f64; 2]) -> Result<Option<State>, MotionError> {
        let across = |v: [&Coefficients; 2]| -> Coefficients {
            std::array::from_fn(|k| v[0][k] * n[1] - v[1][k] * n[0])
        };
        let points = |state: &State| state.v[0] * n[0] + state.v[1] * n[1] > 0.0;
        match self {
            Self::Slide(step) => {
                for found in roots(&across([&step.series[0], &step.series[1]]), step.h)? {
                    let t = step.t_start() + change(&step.series[2], &found.at);
                    let state = step.state(found.at, t);
                    if points(&state) {
                        return Ok(Some(state));
                    }
                }
            }
            Self::Arc(arc) => {
                for found in roots(&across([&arc.v[0], &arc.v[1]]), arc.to - arc.from)? {
                    let state = arc.state(arc.from + found.at);
                    if points(&state) {
                        return Ok(Some(state));
                    }
                }
            }
            Self::Rest { .. } => {}
        }
        Ok(None)
    }
}

pub(super) trait SlideStep {
    fn t_start(&self) -> f64;
    /// The s by which the time `elapsed` has gone by.
    fn s_at(&self, elapsed: f64) -> f64;
    fn elapsed(&self) -> f64;
    fn state(&self, s: f64, t: f64) -> State;
}

impl SlideStep for Step<f64, 5, TERMS> {
    fn t_start(&self) -> f64 {
        self.series[2][0]
    }

    fn s_at(&self, elapsed: f64) -> f64 {
        arrival(&self.series[2], elapsed, self.h)
    }

    fn elapsed(&self) -> f64 {
        change(&self.series[2], &self.h)
    }

    fn state(&self, s: f64, t: f64) -> State {
        let [vx, vy, _, x, y] = self.at(&s);
        State {
            t,
            v: [vx, vy],
            x: [x, y],
        }
    }
}

/// A motion from a start to an end.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    pub(super) pieces: Vec<Piece>,
    pub(super) phases: Vec<Phase>,
    pub(super) stops: Vec<f64>,
    pub(super) starts: Vec<f64>,
    pub(super) start: State,
    pub(super) end: State,
    pub(super) drive_error: f64,
}

impl Motion {
    pub(super) fn begin(start: State, drive_error: f64) -> Self {
        let (pieces, phases) = (Vec::new(), Vec::new());
        Self {
            drive_error,
            pieces,
            phases,
            stops: Vec::new(),
            starts: Vec::new(),
            start,
            end: start,
        }
    }

    /// In order, without gaps; one of length zero is left out.
    pub fn phases(&self) -> &[Phase] {
        &self.phases
    }

    /// The times at which a sliding particle comes to v = 0, whether it then sticks or goes on at once.
    pub fn stops(&self) -> &[f64] {
        &self.stops
    }

    /// The times at which a particle with v = 0 begins to slide, at once after a stop included.
    pub fn starts(&self) -> &[f64] {
        &self.starts
    }

    /// Nothing if there was none until the end of the motion.
    pub fn first_stop(&self) -> Option<f64> {
        self.stops.first().copied()
    }

    /// State at the start.
    pub fn start(&self) -> State {
        self.start
    }

    /// State at the end.
    pub fn end(&self) -> State {
        self.end
    }

    /// The [`error`](super::Acceleration::error) e of a component of the acceleration, in length/time². At t the motion is off by
    /// at most √2 e (t − t₀) in velocity, and half of that times t − t₀ in place, beyond the errors of [`run`](super::run).
    pub fn drive_error(&self) -> f64 {
        self.drive_error
    }

    /// State at time `t`.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a time before the start or after the end.
    pub fn at(&self, t: f64) -> Result<State, MotionError> {
        if !(t >= self.start.t && t <= self.end.t) {
            let range = "between the start and the end of the motion";
            return Err(MotionError::Argument {
                name: "t",
                value: t,
                range,
            });
        }
        if t == self.end.t {
            return Ok(self.end);
        }
        let index = self.pieces.partition_point(|piece| piece.from() <= t);
        match self.pieces.get(index.saturating_sub(1)) {
            Some(piece) => piece.at(t),
            None => Ok(self.start),
        }
    }

    /// Its way on the plane. Each unit of it turns μg into heat, per unit of mass. Cost: that of the motion itself.
    pub(crate) fn track(&self) -> Result<Track<'_>, MotionError> {
        let parts = self.pieces.iter().filter_map(|piece| match piece {
            Piece::Slide(step) => {
                let [u, v, t, x, y] = &step.series;
                Some(Part::clocked(t, step.h, [u, v], [x, y]).one_way())
            }
            Piece::Arc(arc) => {
                let (v, x) = (arc.v.each_ref(), arc.x.each_ref());
                Some(Part::timed(arc.from, arc.to - arc.from, v, x).one_way())
            }
            Piece::Rest { .. } => None,
        });
        Track::new([self.start.t, self.end.t], self.start.x, parts.map(Ok))
    }

    /// The states at the ends of the integrator's steps, in order: natural points of a figure.
    pub fn nodes(&self) -> impl Iterator<Item = State> + '_ {
        let begins = self.pieces.iter().map(Piece::begin);
        begins.chain(std::iter::once(self.end))
    }

    /// The first state whose velocity points along `direction` (of any length), the start included; nothing if
    /// there is none until the end. Where it sets out from rest in that direction, the state of rest. A velocity
    /// component below 10⁻⁹⁰ of the other counts as zero.
    ///
    /// Cost: a look at each step.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a direction that is zero or not finite.
    pub fn first_along(&self, direction: [f64; 2]) -> Result<Option<State>, MotionError> {
        let length = libm::hypot(direction[0], direction[1]);
        if !(length.is_finite() && length > 0.0) {
            let range = "finite and not zero";
            return Err(MotionError::Argument {
                name: "length of direction",
                value: length,
                range,
            });
        }
        let n = [direction[0] / length, direction[1] / length];
        for piece in &self.pieces {
            let [x, y] = piece.heading();
            if x * n[1] - y * n[0] == 0.0 && x * n[0] + y * n[1] > 0.0 {
                return Ok(Some(piece.begin()));
            }
            if let Some(state) = piece.along(n)? {
                return Ok(Some(state));
            }
        }
        Ok(None)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Plane, Signal};
    use super::*;
    use crate::particle::run;

    #[test]
    fn a_motion_points_along_its_own_velocity_from_the_start() {
        let still = Plane::constant([0.0; 2]);
        for v in [[3.0, 0.0], [-3.0, 0.0], [0.0, 0.5], [0.0, -2.0], [1.0, 1.0]] {
            let motion = run(&still, 1.0, State::moving(v), 9.0).unwrap();
            assert_eq!(motion.first_along(v).unwrap(), Some(State::moving(v)));
            for other in [[-v[0], -v[1]], [-v[1], v[0]], [v[1], -v[0]]] {
                assert_eq!(motion.first_along(other).unwrap(), None, "{v:?} {other:?}");
            }
        }
    }

    #[test]
    fn across_the_pull_a_motion_points_once() {
        // No friction, −A = (±1, 0), v = (∓2, ±3): straight along y after the time 2, whichever the mirror image.
        for (side, up) in [(1.0, 3.0), (-1.0, 3.0), (1.0, -3.0), (-1.0, -3.0)] {
            for friction in [0.0, 0.1] {
                let pull = Plane::constant([-side, 0.0]);
                let motion = run(&pull, friction, State::moving([-2.0 * side, up]), 9.0).unwrap();
                let found = motion.first_along([0.0, up]).unwrap().unwrap();
                assert!(found.v[0].abs() < 1e-14, "{found:?}");
                assert!(friction > 0.0 || (found.t - 2.0).abs() < 1e-14, "{found:?}");
                assert_eq!(motion.first_along([0.0, -up]).unwrap(), None);
            }
        }
    }

    #[test]
    fn the_first_moments_of_a_slide_know_where_they_point() {
        let pulled = |to| {
            let strength =
                Signal::Product(vec![Signal::Pulse { from: 1.0, to }, Signal::constant(1.5)]);
            let plane = Plane::rotating(strength, 2.0, 0.4);
            run(&plane, 1.0, State::moving([0.0; 2]), 9.0).unwrap()
        };
        let long = pulled(2.0);
        let arc = long.pieces.iter().find_map(|piece| match piece {
            Piece::Arc(arc) => Some(arc),
            _ => None,
        });
        let arc = arc.unwrap();
        assert_eq!(arc.from, 1.0);
        let length = arc.to - arc.from;
        for part in [0.25, 0.5, 0.75] {
            let t = 1.0 + part * length;
            let v = long.at(t).unwrap().v;
            let found = long.first_along(v).unwrap().unwrap();
            assert!((found.t - t).abs() < 1e-12, "{found:?} {t}");
            let short = pulled(1.0 + (part - 0.05) * length);
            assert_eq!(short.first_along(v).unwrap(), None, "{part}");
        }
    }
}
