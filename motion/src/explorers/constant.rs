//! Section 2.1: a launch under constant acceleration. Speeds in units of v₀, times in v₀/A, lengths in v₀²/A.

use super::{Answer, ExplorerError, PICTURES, flag, spread};
use crate::{Launch, Motion, MotionError, Plane, State, run};
use std::f64::consts::PI;

/// Where it need not come to rest.
const WHILE: f64 = 10.0;
/// On a path, at most.
const MARKS: u32 = 200;
const DIRECTIONS: u32 = 12;

/// The motion with friction λ from the launch angle `theta`, in degrees in (−180, 180].
///
/// Values: whether it comes to rest (1 or 0), the time at the end, v_x, v_y, x, y there. The end is the rest, or the
/// time 10 where λ ≤ 1 and the particle still moves. Curves: the velocity, the path, and the places at the times
/// 0, ½, 1, …, 100 at most.
///
/// # Errors
/// λ not 0 or between 10⁻²⁰ and 10²⁰, an angle out of range.
pub fn motion(lambda: f64, theta: f64) -> Result<Answer, ExplorerError> {
    let motion = followed(lambda, theta)?;
    let end = motion.end();
    let at = |t| motion.at(t);
    let halves = (0..=MARKS).map(|i| 0.5 * f64::from(i));
    let marks: Vec<State> = halves
        .take_while(|t| *t <= end.t)
        .map(at)
        .collect::<Result<_, _>>()?;
    let states = states(&motion, 120)?;
    Ok(Answer {
        values: vec![
            flag(end.speed() == 0.0),
            end.t,
            end.v[0],
            end.v[1],
            end.x[0],
            end.x[1],
        ],
        curves: vec![
            states.iter().map(|s| s.v).collect(),
            states.iter().map(|s| s.x).collect(),
            marks.iter().map(|s| s.x).collect(),
        ],
    })
}

/// What friction λ does to launches in all directions.
///
/// Curves: first the time until rest against the launch angle in degrees, without a point where λ ≤ 1; then the
/// velocity for each launch angle, every 30°.
///
/// # Errors
/// λ not 0 or between 10⁻²⁰ and 10²⁰.
pub fn portrait(lambda: f64) -> Result<Answer, ExplorerError> {
    let mut times = Vec::new();
    if lambda > 1.0 {
        for theta in spread(0.0, 180.0, 24) {
            times.push([theta, followed(lambda, theta)?.end().t]);
        }
    }
    let mut curves = vec![times];
    for k in 1..=DIRECTIONS {
        let theta = 360.0 * f64::from(k) / f64::from(DIRECTIONS) - 180.0;
        let states = states(&followed(lambda, theta)?, 60)?;
        curves.push(states.iter().map(|s| s.v).collect());
    }
    Ok(Answer {
        values: Vec::new(),
        curves,
    })
}

/// The same motion at equal times, for a moving picture.
///
/// Values: the time between the pictures. Curves: place and velocity relative to the plane, and the place of a particle launched
/// alike on a plane at rest.
///
/// # Errors
/// As for [`motion`].
pub fn film(lambda: f64, theta: f64) -> Result<Answer, ExplorerError> {
    let motion = followed(lambda, theta)?;
    let end = motion.end().t;
    let alike = run(&Plane::constant([0.0; 2]), lambda, motion.at(0.0)?, end)?;
    let mut curves = vec![Vec::new(); 3];
    for t in spread(0.0, end, PICTURES) {
        let State { x, v, .. } = motion.at(t)?;
        let points = [x, v, alike.at(t)?.x];
        curves
            .iter_mut()
            .zip(points)
            .for_each(|(curve, point)| curve.push(point));
    }
    Ok(Answer {
        values: vec![end / f64::from(PICTURES)],
        curves,
    })
}

fn followed(lambda: f64, theta: f64) -> Result<Motion, MotionError> {
    let launch = Launch::new(lambda, 1.0, 1.0, PI * (theta / 180.0))?;
    if launch.comes_to_rest() {
        launch.motion_to_rest()
    } else {
        launch.motion(WHILE)
    }
}

/// Equal steps in time, and the integrator's own nodes, where it turns fast.
fn states(motion: &Motion, n: u32) -> Result<Vec<State>, MotionError> {
    let mut states: Vec<State> = motion.nodes().collect();
    for t in spread(0.0, motion.end().t, n) {
        states.push(motion.at(t)?);
    }
    states.sort_by(|a, b| a.t.total_cmp(&b.t));
    Ok(states)
}
