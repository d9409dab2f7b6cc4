//! Constant acceleration: where a launched particle is in its velocity, at an angle or at a time.

use super::{Answer, Curve, Field, Fields, SolveError, check, size, steps};
use crate::corrections::constant as corrected;
use crate::motion::trajectory::{Motion, PhaseKind};
use crate::motion::{self, Launch};
use crate::numerics::roots::root;
use crate::paper::constant as printed;
use std::f64::consts::PI;

/// Which moment is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum At {
    /// When the velocity has this angle with the x axis (radians).
    Theta(f64),
    /// This long after the launch.
    Time(f64),
}

/// A launch on a plane with the acceleration −A x̂, and a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Problem {
    /// λ = μg/A, dimensionless: 0, or from 10⁻²⁰ to 10²⁰.
    pub lambda: f64,
    /// The initial speed v₀ (length/time), from 10⁻²⁰ to 10²⁰.
    pub v0: f64,
    /// The initial angle θ₀ of the velocity with the x axis, in (−π, π].
    pub theta0: f64,
    /// A (length/time²), from 10⁻²⁰ to 10²⁰.
    pub accel: f64,
    /// The moment.
    pub at: At,
}

/// The velocity at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Speed.
    pub v: f64,
    /// Angle with the x axis; at rest, what it tended to.
    pub theta: f64,
    /// Time since the launch.
    pub t: f64,
    /// Component along x.
    pub vx: f64,
    /// Component along y.
    pub vy: f64,
    /// When the particle stops for good, if it does.
    pub stop_time: Option<f64>,
}

/// An angle below this is zero for every purpose.
const NO_ANGLE: f64 = 1e-60;

impl Fields for State {
    fn fields(&self) -> Vec<Field> {
        vec![
            Field::new("v", self.v),
            Field::within(NO_ANGLE, "theta", self.theta),
            Field::new("t", self.t),
            Field::within(self.v, "vx", self.vx),
            Field::within(self.v, "vy", self.vy),
            Field::new("stop_time", self.stop_time),
        ]
    }
}

impl Problem {
    /// The velocity at the moment asked for.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for a parameter out of range or an angle that the velocity never has: it turns
    /// from θ₀ towards 0 and gets there only in the limit.
    pub fn solve(&self) -> Result<Answer<State>, SolveError> {
        self.check()?;
        let formulas = self.formulas();
        let formula = match self.at {
            At::Theta(theta) => formulas.at_theta(theta)?,
            At::Time(t) => formulas.at_time(t)?,
        };
        Answer::by_either(formula, self.by_motion()?, formulas.note(&formula))
    }

    /// The path of the velocity.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let answer = self.solve()?.best;
        let shown = answer.stop_time.unwrap_or(3.0 * self.v0 / self.accel);
        let motion = self.launch()?.motion(shown.max(answer.t))?;
        let end = motion.end().t;
        let states: Result<Vec<_>, _> = steps(end, 200).map(|t| motion.at(t)).collect();
        let mut states = states?;
        states.extend(motion.nodes());
        states.sort_by(|a, b| a.t.total_cmp(&b.t));
        Ok(Curve {
            title: "The velocity under constant acceleration",
            x: "v_x",
            y: "v_y",
            equal: false,
            points: states.iter().map(|state| state.v).collect(),
        })
    }

    fn check(&self) -> Result<(), SolveError> {
        let fit = self.lambda == 0.0 || (1e-20..=1e20).contains(&self.lambda);
        check("lambda", self.lambda, fit, "0 or between 1e-20 and 1e20")?;
        size("v0", self.v0)?;
        size("accel", self.accel)?;
        check_moment(self.theta0, self.at)
    }

    fn formulas(&self) -> Formulas {
        Formulas {
            lambda: self.lambda,
            a: self.accel,
            v0: self.v0,
            theta0: self.theta0,
        }
    }

    fn launch(&self) -> Result<Launch, SolveError> {
        let launch = Launch::new(self.lambda, self.accel, self.v0, self.theta0);
        Ok(launch?)
    }

    /// Nothing where the motion stops, as far as its numbers reach, before it has the angle.
    fn by_motion(&self) -> Result<Option<State>, SolveError> {
        let launch = self.launch()?;
        let to_rest = if self.lambda > 1.0 {
            Some(launch.motion_to_rest()?)
        } else {
            // Friction that only just holds: a particle launched against the inertial force stops within v₀/A.
            let motion = launch.motion(self.v0 / self.accel)?;
            let sticks = motion.phases().last().map(|phase| phase.kind) == Some(PhaseKind::Stick);
            sticks.then_some(motion)
        };
        let stop_time = to_rest.as_ref().and_then(Motion::first_stop);
        let state = match self.at {
            At::Time(t) => launch.motion(t)?.end(),
            At::Theta(theta) if theta == self.theta0 => launch.motion(0.0)?.end(),
            At::Theta(theta) => {
                let towards = [libm::cos(theta), libm::sin(theta)];
                let reached = match to_rest {
                    Some(motion) => motion.first_along(towards)?,
                    None => self.first_along(&launch, towards)?,
                };
                let Some(state) = reached else {
                    return Ok(None);
                };
                state
            }
        };
        Ok(Some(State {
            v: state.speed(),
            theta: match state.speed() {
                0.0 if stop_time.is_some_and(|stop| stop <= state.t) => last_angle(self.theta0),
                _ => state.direction(),
            },
            t: state.t,
            vx: state.v[0],
            vy: state.v[1],
            stop_time,
        }))
    }

    /// The first state in this direction of a motion that never stops, followed as long as it takes.
    fn first_along(
        &self,
        launch: &Launch,
        towards: [f64; 2],
    ) -> Result<Option<motion::State>, SolveError> {
        let mut until = self.v0 / self.accel;
        for _ in 0..100 {
            let motion = launch.motion(until)?;
            if let Some(state) = motion.first_along(towards)? {
                return Ok(Some(state));
            }
            until *= 4.0;
        }
        Ok(None)
    }
}

/// Requires an angle in (−π, π] and a moment that can be.
pub(super) fn check_moment(theta0: f64, at: At) -> Result<(), SolveError> {
    let fit = theta0 > -PI && theta0 <= PI;
    check("theta0", theta0, fit, "in (−π, π]")?;
    match at {
        At::Theta(theta) => check("theta", theta, theta.is_finite(), "finite"),
        At::Time(t) => check("time", t, (0.0..=1e40).contains(&t), "between 0 and 1e40"),
    }
}

/// The error of an angle that the velocity never has.
fn unreached(theta: f64, theta0: f64) -> SolveError {
    SolveError::Parameter {
        name: "theta",
        value: theta,
        allowed: format!(
            "between 0 (excluded) and theta0 = {theta0}: the velocity turns from theta0 towards 0, and along the x axis it does not turn"
        ),
    }
}

/// What the angle tends to at a stop for good: 0, but for a launch straight against the inertial force.
fn last_angle(theta0: f64) -> f64 {
    if theta0 == PI { PI } else { 0.0 }
}

/// The formulas of section 2.1 for one launch. Section 3 uses them too.
#[derive(Debug, Clone, Copy)]
pub(super) struct Formulas {
    pub(super) lambda: f64,
    pub(super) a: f64,
    pub(super) v0: f64,
    pub(super) theta0: f64,
}

impl Formulas {
    /// (20), as the limit of the time's regular form, which keeps its digits near λ = 1; on the axis the angle
    /// stays what it is.
    fn stop_time(&self) -> Option<f64> {
        let Formulas {
            lambda,
            a,
            v0,
            theta0,
        } = *self;
        if theta0 == PI {
            (lambda >= 1.0).then(|| v0 / (a * (lambda + 1.0)))
        } else {
            let last = f64::NEG_INFINITY;
            (lambda > 1.0).then(|| corrected::time_by_log(lambda, a, v0, theta0, last))
        }
    }

    fn state(&self, v: f64, theta: f64, t: f64) -> State {
        let [vx, vy] = match theta {
            PI => [-v, 0.0],
            _ => printed::eq4_velocity(v, theta),
        };
        State {
            v,
            theta,
            t,
            vx,
            vy,
            stop_time: self.stop_time(),
        }
    }

    /// On the axis from the start: before the stop if there is one, and after it.
    fn on_axis(&self, t: f64) -> State {
        let Formulas {
            lambda,
            a,
            v0,
            theta0,
        } = *self;
        let stop = v0 / (a * (lambda + 1.0));
        if self.stop_time().is_some_and(|stop| stop <= t) {
            self.state(0.0, last_angle(theta0), t)
        } else if theta0 == 0.0 {
            self.state(v0 + a * (1.0 - lambda) * t, 0.0, t)
        } else if t < stop {
            self.state(v0 - a * (1.0 + lambda) * t, PI, t)
        } else {
            self.state(a * (1.0 - lambda) * (t - stop), 0.0, t)
        }
    }

    fn is_on_axis(&self) -> bool {
        self.theta0 == 0.0 || self.theta0 == PI
    }

    /// Where tan(θ/2) has fallen to a part of its initial value, by the logarithm of that part.
    fn at_log(&self, ln_r: f64, theta: f64, t: f64) -> State {
        let v = corrected::speed_by_log(self.lambda, self.v0, self.theta0, ln_r);
        self.state(v, theta, t)
    }

    /// The state at an angle.
    pub(super) fn at_theta(&self, theta: f64) -> Result<State, SolveError> {
        let Formulas {
            lambda,
            a,
            v0,
            theta0,
        } = *self;
        if theta == theta0 {
            return Ok(self.state(v0, theta, 0.0));
        }
        if theta0 == PI && theta == 0.0 && lambda < 1.0 {
            return Ok(self.on_axis(v0 / (a * (lambda + 1.0))));
        }
        let between = theta != 0.0 && (theta > 0.0) == (theta0 > 0.0) && theta.abs() < theta0.abs();
        if self.is_on_axis() || !between {
            return Err(unreached(theta, theta0));
        }
        // tan(θ₀/2)/tan(θ/2) − 1, without loss of digits where the two are close.
        let sine = libm::sin(0.5 * (theta0 - theta));
        let excess = sine / (libm::sin(0.5 * theta) * libm::cos(0.5 * theta0));
        let ln_r = -libm::log1p(excess);
        let t = corrected::time_by_log(lambda, a, v0, theta0, ln_r);
        Ok(self.at_log(ln_r, theta, t))
    }

    /// The state at a time.
    pub(super) fn at_time(&self, t: f64) -> Result<State, SolveError> {
        let Formulas {
            lambda,
            a,
            v0,
            theta0,
        } = *self;
        if self.is_on_axis() {
            return Ok(self.on_axis(t));
        }
        if t == 0.0 {
            return Ok(self.state(v0, theta0, 0.0));
        }
        let late = |x: f64| corrected::time_by_log(lambda, a, v0, theta0, -x) - t;
        let mut most = 1.0 / (1.0 + lambda);
        for _ in 0..DOUBLINGS {
            if late(most) >= 0.0 {
                break;
            }
            most *= 2.0;
        }
        if self.stop_time().is_some_and(|stop| stop <= t) || late(most) < 0.0 {
            return Ok(self.state(0.0, last_angle(theta0), t));
        }
        let ln_r = -root(late, 0.0, most)?;
        let theta = corrected::angle(theta0, libm::exp(ln_r));
        Ok(self.at_log(ln_r, theta, t))
    }

    /// Which formulas gave a state: the printed ones if they give it too.
    fn note(&self, state: &State) -> String {
        let Formulas {
            lambda,
            a,
            v0,
            theta0,
        } = *self;
        let v = printed::eq11_speed(lambda, v0, theta0, state.theta);
        let t = printed::eq13_time(lambda, a, v0, theta0, state.theta);
        let near = |x: f64, y: f64| (x - y).abs() <= PRINTED * y.abs();
        let formula = if self.is_on_axis() {
            "by uniformly accelerated motion along the x axis, where (11) and (13) have no value"
        } else if state.v == 0.0 {
            "at rest: (20) is over"
        } else if near(v, state.v) && near(t, state.t) {
            "by (11) and (13)"
        } else {
            "by the form that replaces (11) and (13), which as printed have no value here or lose their digits"
        };
        format!("{formula}; the digits are those in which the integrated motion agrees")
    }
}

/// Doublings that lead from any time scale to any other.
const DOUBLINGS: usize = 300;

/// To this the printed formulas must give a state to be named as its source.
const PRINTED: f64 = 1e-9;
