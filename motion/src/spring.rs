//! A block on a spring, on a rough plane that may be pulled: one more force in Newton's law, along a line.
//!
//! ```text
//! sliding:   dv/dt = P(t) − ω²x − μg v/|v|
//! sticking:  v = 0 while |P(t) − ω²x| ≤ μg
//! ```
//!
//! P is the pull on a unit of mass, in the plane's frame: −A if the plane [accelerates](super) by A; x counts from where the
//! spring is relaxed. Between events x and v are power series in time.

use super::{
    acceleration::Plane, error::MotionError, particle::Line, signal::Signal, trajectory::State,
};

/// A spring and the friction under the block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// ω of the block on the spring without friction, in 1/time; 0 for no spring.
    pub frequency: f64,
    /// μg, in length/time².
    pub friction: f64,
}

/// Where the block is and how it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpringState {
    /// Time.
    pub t: f64,
    /// Position, in length.
    pub x: f64,
    /// Velocity, in length/time.
    pub v: f64,
}

/// A motion from a start to an end.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringMotion {
    /// Each moment at which the velocity has become zero, in order.
    pub turns: Vec<SpringState>,
    /// The state at the end.
    pub end: SpringState,
}

impl Spring {
    /// The motion from `start` until the time `until` under the pull `pull` (length/time²): that of a block on a [`Line`].
    ///
    /// # Errors
    /// As for [`Line::run`].
    pub fn run(
        &self,
        pull: &Signal,
        start: SpringState,
        until: f64,
    ) -> Result<SpringMotion, MotionError> {
        let line = Line {
            along: [1.0, 0.0],
            plus: self.friction.into(),
            minus: self.friction.into(),
            frequency: self.frequency,
        };
        let start = State {
            t: start.t,
            v: [start.v, 0.0],
            x: [start.x, 0.0],
        };
        let plane = Plane::along([-1.0, 0.0], pull.clone());
        let motion = line.run(&plane, start, until)?;
        let on_line = |state: State| SpringState {
            t: state.t,
            x: state.x[0],
            v: state.v[0],
        };
        let turns = motion.stops().iter().map(|t| motion.at(*t).map(on_line));
        Ok(SpringMotion {
            turns: turns.collect::<Result<_, _>>()?,
            end: on_line(motion.end()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    const NONE: Signal = Signal::Polynomial(Vec::new());

    fn at(x: f64, v: f64) -> SpringState {
        SpringState { t: 0.0, x, v }
    }

    #[test]
    fn each_half_swing_loses_twice_what_friction_can_hold() {
        let spring = Spring {
            frequency: 2.0,
            friction: 0.4,
        };
        // μg/ω² = 0.1: from 1.05 by 0.2 each half period to 0.05, where it is held.
        let motion = spring.run(&NONE, at(1.05, 0.0), 20.0).unwrap();
        assert_eq!(motion.turns.len(), 5);
        for (n, turn) in motion.turns.iter().enumerate() {
            let swing = n as f64 + 1.0;
            let side = if n % 2 == 0 { -1.0 } else { 1.0 };
            assert!((turn.t - swing * PI / 2.0).abs() < 1e-13, "{turn:?}");
            assert!(
                (turn.x - side * (1.05 - 0.2 * swing)).abs() < 1e-13,
                "{turn:?}"
            );
        }
        assert_eq!((motion.end.v, motion.end.t), (0.0, 20.0));
    }

    #[test]
    fn without_a_spring_it_is_a_particle_on_a_shaken_plane() {
        use crate::{Plane, State as Planar, run};
        let sine = Signal::Sine {
            frequency: 1.0,
            phase: 0.3,
        };
        let spring = Spring {
            frequency: 0.0,
            friction: 0.6,
        };
        let motion = spring.run(&sine, at(0.0, 0.7), 3.0 * TAU).unwrap();
        let start = Planar {
            t: 0.0,
            v: [0.7, 0.0],
            x: [0.0; 2],
        };
        let plane = Plane::along([-1.0, 0.0], sine);
        let other = run(&plane, 0.6, start, 3.0 * TAU).unwrap();
        assert_eq!(motion.turns.len(), other.stops().len());
        for (turn, stop) in motion.turns.iter().zip(other.stops()) {
            assert!((turn.t - stop).abs() < 1e-12);
        }
        assert!((motion.end.x - other.end().x[0]).abs() < 1e-12);
    }

    #[test]
    fn a_pull_that_grows_lets_it_go_when_it_outgrows_friction_and_spring() {
        let spring = Spring {
            frequency: 1.0,
            friction: 1.0,
        };
        // At x = −1/2 the spring helps forward: let go at t/2 = 1/2.
        let ramp = Signal::Polynomial(vec![0.0, 0.5]);
        let before = spring.run(&ramp, at(-0.5, 0.0), 0.999).unwrap().end;
        assert_eq!((before.x, before.v), (-0.5, 0.0));
        // From then on x'' = (t − 1)/2 − (x + 1/2): x + 1/2 = (s − sin s)/2.
        let after = spring.run(&ramp, at(-0.5, 0.0), 3.0).unwrap().end;
        assert!(
            (after.x + 0.5 - 0.5 * (2.0 - 2.0_f64.sin())).abs() < 1e-13,
            "{after:?}"
        );
        let back = Signal::Polynomial(vec![0.0, -0.5]);
        let mirrored = spring.run(&back, at(0.5, 0.0), 3.0).unwrap().end;
        assert_eq!((mirrored.x, mirrored.v), (-after.x, -after.v));
    }

    #[test]
    fn a_bad_parameter_is_named() {
        let spring = Spring {
            frequency: -1.0,
            friction: 1.0,
        };
        let error = spring.run(&NONE, at(0.0, 0.0), 1.0).unwrap_err();
        assert!(error.to_string().starts_with("frequency = -1"), "{error}");
    }

    /// 3t − t² passes 1 at (3 − √5)/2 and −1 at (3 + √13)/2, before the end.
    #[test]
    fn of_two_ways_it_goes_the_one_that_opens_first() {
        let free = Spring {
            frequency: 0.0,
            friction: 1.0,
        };
        let from = 0.5 * (3.0 - 5.0_f64.sqrt());
        for side in [1.0, -1.0] {
            let pull = Signal::Polynomial(vec![0.0, 3.0 * side, -side]);
            let held = free.run(&pull, at(0.0, 0.0), 0.999 * from).unwrap();
            assert_eq!((held.end.x, held.end.v), (0.0, 0.0));
            let moved = free.run(&pull, at(0.0, 0.0), 3.4).unwrap();
            let gained = |t: f64| 1.5 * t * t - t * t * t / 3.0 - t;
            let v = side * (gained(3.4) - gained(from));
            assert!((moved.end.v - v).abs() < 1e-13, "{moved:?} {v}");
        }
    }

    /// v = (t − 1)² touches zero and goes on; with a little less pull it stops, with a little more it comes close.
    #[test]
    fn what_grazes_zero_does_not_turn() {
        let free = Spring {
            frequency: 0.0,
            friction: 0.5,
        };
        for (less, turns) in [(0.0, 0), (1e-6, 1), (-1e-6, 0)] {
            for side in [1.0, -1.0] {
                let pull = Signal::Polynomial(vec![side * (-1.5 - less), 2.0 * side]);
                let motion = free.run(&pull, at(0.0, side), 2.0).unwrap();
                assert_eq!(motion.turns.len(), turns, "{less} {motion:?}");
                assert!((motion.end.x - side * 2.0 / 3.0).abs() < 4e-6);
            }
        }
    }
}
