//! Newton's law in the frame that turns with the table.
//!
//! ```text
//! v′ = Ω²x + 2Ω v×ẑ − μg v/|v|,    x′ = v
//! ```
//!
//! the centrifugal force, the Coriolis force and friction, per unit of mass. With dt = |v| ds all right-hand sides
//! are regular at v = 0; without friction, dt = ds does.

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

const STOP: f64 = 1e-18;

impl System<f64, 5, TERMS> for Table {
    /// Speed squared, speed (or 1), the acceleration without friction.
    type Work = [[f64; TERMS]; 4];

    fn begin(&self, _: &f64, _: &[f64; 5], _: &mut Self::Work) {}

    #[inline(always)]
    fn derivative(&self, k: usize, x: &[[f64; TERMS]; 5], work: &mut Self::Work) -> [f64; 5] {
        let [_, x, y, u, v] = x;
        let [squared, rate, along_x, along_y] = work;
        if self.friction() > 0.0 {
            squared[k] = square(u, k) + square(v, k);
            rate[k] = sqrt(squared, rate, k);
        } else {
            rate[k] = if k == 0 { 1.0 } else { 0.0 };
        }
        let omega = self.omega;
        along_x[k] = omega * omega * x[k] + 2.0 * omega * v[k];
        along_y[k] = omega * omega * y[k] - 2.0 * omega * u[k];
        [
            rate[k],
            product(rate, u, k),
            product(rate, v, k),
            product(rate, along_x, k) - self.friction() * u[k],
            product(rate, along_y, k) - self.friction() * v[k],
        ]
    }
}

/// The motion from `start`, a state relative to the table, until time `until`. A particle that stops stays where
/// friction [holds](Table::holds) it, and else starts again at once, straight away from the axis.
///
/// # Errors
/// [`MotionError::Argument`] for a parameter out of range, [`MotionError::Steps`] when the motion is not done in
/// [`STEPS`] steps (on the way into the unstable rest at Ω²r = μg), [`MotionError::Numerics`] for numbers beyond
/// what floating point can hold.
pub fn run(table: &Table, start: &State, until: f64) -> Result<Path, MotionError> {
    run_held(table, table.mu, start, until)
}

/// As [`run`], but a particle at rest stays up to Ω²r = μ_s g, with the coefficient `holding` μ_s not below μ.
pub(crate) fn run_held(
    table: &Table,
    holding: f64,
    start: &State,
    until: f64,
) -> Result<Path, MotionError> {
    table.check()?;
    let fit = holding >= table.mu && holding <= super::LARGEST;
    super::argument("holding", holding, fit, "not below mu, at most 1e50")?;
    let grip = Table {
        mu: holding,
        ..*table
    };
    check_start(start, until)?;
    let scale = start.speed() + table.omega.abs() * start.radius();
    let mut path = Path {
        table: *table,
        frame: Frame::Table,
        legs: Vec::new(),
        stops: Vec::new(),
        start: start.t,
        end: until,
    };
    let mut state = *start;
    loop {
        if state.v == [0.0; 2] {
            if grip.holds(state.radius()) {
                path.legs.push(Leg::Rest {
                    from: state.t,
                    place: state.x,
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
        let slide = Clocked::run(table, begin, until, STEPS, |s| {
            table.friction() > 0.0 && libm::hypot(s[3], s[4]) < STOP * scale
        })?;
        let [t, x, y, u, v] = *slide.end();
        path.legs.push(Leg::Slide(slide));
        if t >= until {
            return Ok(path);
        }
        state = State {
            t,
            x: [x, y],
            v: [0.0; 2],
        };
        let speed = libm::hypot(u, v);
        let pull = table.omega * table.omega * (x * u + y * v) / speed;
        state.t = (t + speed / (table.friction() - pull).abs()).min(until);
        path.stops.push(state.t);
    }
}

/// Of a particle at rest at `place`, where friction does not hold it: for how long, and the coefficients of x, y, v_x, v_y.
fn first_moments(
    table: &Table,
    place: [f64; 2],
) -> Result<(f64, Box<[Coefficients; 4]>), MotionError> {
    let omega = table.omega;
    let mut x = [[0.0; TERMS]; 2];
    let start = onset(table.friction(), f64::INFINITY, |m, v| {
        for i in 0..2 {
            x[i][m] = if m == 0 {
                place[i]
            } else {
                v[i][m - 1] / m as f64
            };
        }
        [
            omega * omega * x[0][m] + 2.0 * omega * v[1][m],
            omega * omega * x[1][m] - 2.0 * omega * v[0][m],
        ]
    })?;
    let [u, v] = start.velocity;
    let [x, y] = x;
    Ok((start.h, Box::new([x, y, u, v])))
}
