//! Newton's law in the laboratory.
//!
//! Friction is the only horizontal force. It opposes the velocity relative to the table under the particle:
//!
//! ```text
//! V′ = −μg w/|w|,    X′ = V,    w = V − Ω ẑ×X
//! ```
//!
//! With dt = |w| ds all right-hand sides are regular at w = 0; without friction, dt = ds does.

use super::{
    State, Table, check_start,
    path::{Frame, Leg, Path},
};
use crate::Coefficients;
use crate::clock::Clocked;
use crate::error::MotionError;
use crate::numerics::{
    series::{product, sqrt, square},
    taylor::{System, TERMS},
};
use crate::onset::onset;

/// Steps that a motion may take before it is given up.
pub const STEPS: usize = 200_000;

/// As a part of the first speeds, below which the velocity relative to the table, a difference, loses its digits: from there on
/// the place counts as fixed until the stop, which is true to the square of this number.
const STOP: f64 = 1e-8;

/// Below this part the particle counts as stopped where friction does not hold it.
const TURN: f64 = 1e-13;

struct Laboratory {
    omega: f64,
    friction: f64,
}

impl System<f64, 5, TERMS> for Laboratory {
    /// The relative velocity, its square, its magnitude (or 1).
    type Work = [[f64; TERMS]; 4];

    fn begin(&self, _: &f64, _: &[f64; 5], _: &mut Self::Work) {}

    #[inline(always)]
    fn derivative(&self, k: usize, state: &[[f64; TERMS]; 5], work: &mut Self::Work) -> [f64; 5] {
        let [_, x, y, u, v] = state;
        let [wx, wy, squared, rate] = work;
        wx[k] = u[k] + self.omega * y[k];
        wy[k] = v[k] - self.omega * x[k];
        if self.friction > 0.0 {
            squared[k] = square(wx, k) + square(wy, k);
            rate[k] = sqrt(squared, rate, k);
        } else {
            rate[k] = if k == 0 { 1.0 } else { 0.0 };
        }
        [
            rate[k],
            product(rate, u, k),
            product(rate, v, k),
            -self.friction * wx[k],
            -self.friction * wy[k],
        ]
    }
}

/// The motion from `start`, a state in the laboratory, until time `until`. A particle that stops on the table
/// stays where friction [holds](Table::holds) it, and else starts again at once, straight away from the axis.
///
/// # Errors
/// As for [`rotating::run`](super::rotating::run).
pub fn run(table: &Table, start: &State, until: f64) -> Result<Path, MotionError> {
    table.check()?;
    check_start(start, until)?;
    let law = Laboratory {
        omega: table.omega,
        friction: table.friction(),
    };
    let omega = table.omega;
    let relative = |s: &State| {
        let w = [s.v[0] + omega * s.x[1], s.v[1] - omega * s.x[0]];
        libm::hypot(w[0], w[1])
    };
    let scale = start.speed() + omega.abs() * start.radius();
    let mut path = Path {
        table: *table,
        frame: Frame::Laboratory,
        legs: Vec::new(),
        stops: Vec::new(),
        start: start.t,
        end: until,
    };
    let mut state = *start;
    loop {
        let held = table.holds(state.radius());
        if relative(&state) <= f64::EPSILON * scale {
            if held {
                let place = table.to_table(&state).x;
                path.legs.push(Leg::Rest {
                    from: state.t,
                    place,
                });
                return Ok(path);
            }
            let (h, series) = first_moments(table, state.x)?;
            path.legs.push(Leg::Onset {
                from: state.t,
                series,
            });
            state = path.at((state.t + h).min(until))?;
            if state.t >= until {
                return Ok(path);
            }
        }
        let begin = [state.t, state.x[0], state.x[1], state.v[0], state.v[1]];
        let slide = Clocked::run(&law, begin, until, STEPS, |s| {
            let state = State {
                t: s[0],
                x: [s[1], s[2]],
                v: [s[3], s[4]],
            };
            let part = if table.holds(state.radius() + STOP * scale) {
                STOP
            } else {
                TURN
            };
            law.friction > 0.0 && relative(&state) < part * scale
        })?;
        let [t, x, y, u, v] = *slide.end();
        path.legs.push(Leg::Slide(slide));
        if t >= until {
            return Ok(path);
        }
        let last = table.to_table(&State {
            t,
            x: [x, y],
            v: [u, v],
        });
        let speed = last.speed();
        let pull = omega * omega * (last.x[0] * last.v[0] + last.x[1] * last.v[1]) / speed;
        let far = omega * omega * libm::hypot(last.x[0], last.x[1]);
        let time = left(speed, law.friction, pull, far);
        path.stops.push((t + time).min(until));
        path.legs.push(Leg::Stopping {
            state: last,
            to: t + time,
        });
        if t + time >= until {
            return Ok(path);
        }
        let place = [0, 1].map(|i| last.x[i] + 0.5 * time * last.v[i]);
        state = table.to_laboratory(&State {
            t: t + time,
            x: place,
            v: [0.0; 2],
        });
    }
}

/// By the friction, and the centrifugal force along the velocity and in all.
fn left(speed: f64, friction: f64, pull: f64, far: f64) -> f64 {
    // With p′ = far cos ψ − μg and p ψ′ = −far sin ψ, p (μg + far cos ψ) falls steadily, at the rate (μg)² − far².
    if friction > far {
        speed * (friction + pull) / ((friction - far) * (friction + far))
    } else {
        speed / (friction - pull).abs()
    }
}

/// Of a particle that rides with the table at `place` (in the laboratory), where friction does not hold it: for how long, and the
/// coefficients of X, Y, V_x, V_y.
///
/// From V = w + Ω ẑ×X follows dw/dt = −Ω ẑ×V − μg w/|w|.
fn first_moments(
    table: &Table,
    place: [f64; 2],
) -> Result<(f64, Box<[Coefficients; 4]>), MotionError> {
    let omega = table.omega;
    let mut x = [[0.0; TERMS]; 2];
    let mut v = [[0.0; TERMS]; 2];
    let start = onset(table.friction(), f64::INFINITY, |m, w| {
        for i in 0..2 {
            x[i][m] = if m == 0 {
                place[i]
            } else {
                v[i][m - 1] / m as f64
            };
        }
        v[0][m] = w[0][m] - omega * x[1][m];
        v[1][m] = w[1][m] + omega * x[0][m];
        [omega * v[1][m], -omega * v[0][m]]
    })?;
    let [u, v] = v;
    let [x, y] = x;
    Ok((start.h, Box::new([x, y, u, v])))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Straight along the force, p′ = far − μg; across it, p (μg + far cos ψ) = μg p at first.
    #[test]
    fn the_last_of_the_speed_takes_its_time() {
        assert_eq!(left(0.5, 2.0, 1.0, 1.0), 0.5);
        assert_eq!(left(0.5, 2.0, -1.0, 1.0), 0.5 / 3.0);
        assert_eq!(left(0.75, 2.0, 0.0, 1.0), 0.5);
        assert_eq!(left(0.5, 1.0, -4.0, 4.0), 0.1);
    }

    #[test]
    fn without_friction_the_time_is_that_of_the_integration() {
        let free = Laboratory {
            omega: 1.3,
            friction: 0.0,
        };
        let state = [[0.3; TERMS]; 5];
        let mut work = Default::default();
        let rates = [0, 1, 2].map(|k| free.derivative(k, &state, &mut work)[0]);
        assert_eq!(rates, [1.0, 0.0, 0.0]);
    }
}
