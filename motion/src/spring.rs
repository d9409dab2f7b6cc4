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
    acceleration::Coefficients,
    error::check,
    error::{MotionError, finite},
    signal::Signal,
};
use crate::numerics::{
    events::{Way, roots},
    series::value,
    taylor::{TERMS, reach},
};

/// A spring and the friction under the block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Frequency ω of the block on the spring without friction, in 1/time; 0 for no spring.
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

/// Steps that a motion may take.
const STEPS: usize = 50_000;
/// A pull within this part of the friction counts as held.
const HELD: f64 = 4.0 * f64::EPSILON;

impl Spring {
    /// The motion from `start` until the time `until` under the pull `pull` (length/time²).
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a frequency or friction that is negative or above 10⁵⁰, a start or an end that is
    /// not finite, an end before the start; [`MotionError::Steps`] after 50,000 steps; [`MotionError::Numerics`] when
    /// the motion leaves the finite numbers.
    pub fn run(
        &self,
        pull: &Signal,
        start: SpringState,
        until: f64,
    ) -> Result<SpringMotion, MotionError> {
        for (name, size) in [("frequency", self.frequency), ("friction", self.friction)] {
            check(
                name,
                size,
                (0.0..=1e50).contains(&size),
                "between 0 and 1e50",
            )?;
        }
        for (name, number) in [("t", start.t), ("x", start.x), ("v", start.v)] {
            check(
                name,
                number,
                number.abs() <= 1e50,
                "finite, at most 1e50 in absolute value",
            )?;
        }
        let fit = until >= start.t && until <= 1e50;
        check("until", until, fit, "not before the start, at most 1e50")?;
        let mut state = start;
        let mut turns = Vec::new();
        // The direction in which it has just been let go, where velocity does not tell yet.
        let mut released = None;
        for _ in 0..STEPS {
            if state.t >= until {
                finite(state.t, &[state.x, state.v])?;
                return Ok(SpringMotion { turns, end: state });
            }
            let series = pull.coefficients(state.t);
            let horizon = pull
                .next_break(state.t)
                .map_or(until, |next| next.min(until));
            let left = (horizon - state.t).min(reach(&series));
            let net = series[0] - self.frequency * self.frequency * state.x;
            let held = state.v == 0.0 && released.is_none();
            if held && net.abs() <= self.friction * (1.0 + HELD) {
                let (after, way) = self.stick(&series, state, left)?;
                state = after;
                released = way;
                continue;
            }
            let smooth = released.is_some();
            let sign = match released.take() {
                Some(sign) => sign,
                None if state.v == 0.0 => net.signum(),
                None => state.v.signum(),
            };
            let (after, turned) = self.slide(&series, state, (sign, smooth), left)?;
            state = if after.t + left * f64::EPSILON >= horizon && !turned {
                SpringState {
                    t: horizon,
                    ..after
                }
            } else {
                after
            };
            if turned {
                turns.push(state);
            }
        }
        Err(MotionError::Steps {
            limit: STEPS,
            t: state.t,
        })
    }

    /// Rests for at most `left`, or until the pull outgrows friction in a direction.
    fn stick(
        &self,
        pull: &Coefficients,
        state: SpringState,
        left: f64,
    ) -> Result<(SpringState, Option<f64>), MotionError> {
        let mut first: Option<(f64, f64)> = None;
        for sign in [1.0, -1.0] {
            let mut excess = pull.map(|c| sign * c);
            excess[0] -= sign * self.frequency * self.frequency * state.x + self.friction;
            if excess[0].abs() <= HELD * self.friction {
                excess[0] = 0.0;
                // On the threshold: it goes at once if the pull grows.
                if excess.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0) {
                    first = Some((0.0, sign));
                }
            }
            let found = roots(&excess, left)?;
            let rising = found.iter().find(|root| root.way == Way::Rising);
            if let Some(root) = rising.filter(|root| first.is_none_or(|(at, _)| root.at < at)) {
                first = Some((root.at, sign));
            }
        }
        Ok(match first {
            Some((at, sign)) => (
                SpringState {
                    t: state.t + at,
                    ..state
                },
                Some(sign),
            ),
            None => (
                SpringState {
                    t: state.t + left,
                    ..state
                },
                None,
            ),
        })
    }

    /// Slides in the direction `sign` for at most `left`, or until the velocity is zero; `smooth` if it begins without a force.
    fn slide(
        &self,
        pull: &Coefficients,
        state: SpringState,
        (sign, smooth): (f64, bool),
        left: f64,
    ) -> Result<(SpringState, bool), MotionError> {
        let stiffness = self.frequency * self.frequency;
        let (mut x, mut v) = ([0.0; TERMS], [0.0; TERMS]);
        (x[0], v[0]) = (state.x, state.v);
        for k in 0..TERMS - 1 {
            let friction = if k == 0 { sign * self.friction } else { 0.0 };
            v[k + 1] = (pull[k] - stiffness * x[k] - friction) / (k + 1) as f64;
            // Let go when the pull has just outgrown friction, it begins without a force.
            if k == 0 && smooth {
                v[1] = 0.0;
            }
            x[k + 1] = v[k] / (k + 1) as f64;
        }
        let h = left.min(reach(&x)).min(reach(&v));
        // One that grazes zero goes on.
        let turn = roots(&v, h)?
            .into_iter()
            .find(|root| root.way != Way::Touching);
        let at = turn.map_or(h, |root| root.at);
        let next = SpringState {
            t: state.t + at,
            x: value(&x, &at),
            v: if turn.is_some() { 0.0 } else { value(&v, &at) },
        };
        Ok((next, turn.is_some()))
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
        // All of it from the other side.
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

    /// P t stays a number where P t²/2 does not.
    #[test]
    fn a_place_beyond_all_numbers_is_no_answer() {
        let free = Spring {
            frequency: 0.0,
            friction: 1.0,
        };
        for side in [1.0, -1.0] {
            let pull = Signal::Polynomial(vec![side * 1e300]);
            let before = free.run(&pull, at(0.0, 0.0), 1e3).unwrap().end;
            assert!(before.x.is_finite() && before.v.is_finite());
            let beyond = free.run(&pull, at(0.0, 0.0), 1e5);
            assert!(
                matches!(beyond, Err(MotionError::Numerics(_))),
                "{beyond:?}"
            );
        }
    }
}
