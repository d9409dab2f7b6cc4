//! Constant acceleration: the velocity of a launched particle and its place, at an angle, at a time or at the stop.
//!
#![doc = include_str!("axes/line.md")]

use super::{
    Answer, Curve, Field, Fields, LEAST_ANGLE, Quantity, RADIANS, SMALL, Said, SolveError, UNITS,
    UNSEEN_ANGLE, check, followed, size, steps,
};
use crate::corrections::constant as corrected;
use crate::motion::{self, Launch, Motion};
use crate::numerics::{double::Double, number::Real};
use crate::paper::constant as printed;
use crate::scalar::Scalar;
use std::f64::consts::PI;

/// Which moment is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum At<T = f64> {
    /// When the velocity has this angle with the x axis (radians).
    Theta(T),
    /// This long after the launch.
    Time(T),
    /// When it stops for good; of a sphere, when it begins to roll.
    Stop,
}

impl<T> At<T> {
    pub(super) fn map<U>(self, f: impl Fn(T) -> U) -> At<U> {
        match self {
            At::Theta(theta) => At::Theta(f(theta)),
            At::Time(time) => At::Time(f(time)),
            At::Stop => At::Stop,
        }
    }
}

/// A launch on a plane with the acceleration −A x̂, and a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConstantProblem<T = f64> {
    /// λ = μg/A, dimensionless: 0, or from 10⁻²⁰ to 10²⁰.
    pub lambda: T,
    /// The initial speed v₀ (length/time), from 10⁻²⁰ to 10²⁰.
    pub v0: T,
    /// The initial angle θ₀ of the velocity with the x axis, radians in (−π, π].
    pub theta0: T,
    /// A (length/time²), from 10⁻²⁰ to 10²⁰.
    pub accel: T,
    /// The moment.
    pub at: At<T>,
}

/// The velocity at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConstantState {
    /// Speed, in length/time.
    pub v: f64,
    /// Angle with the x axis, radians; at rest, what it tended to.
    pub theta: f64,
    /// Time since the launch.
    pub t: f64,
    /// Component along x, in length/time.
    pub vx: f64,
    /// Component along y, in length/time.
    pub vy: f64,
    /// Place along x since the launch, in length.
    pub x: f64,
    /// Place along y.
    pub y: f64,
    /// When the particle stops for good, if it does.
    pub stop_time: Option<f64>,
    /// Where it turns round, speeds are differences of larger ones: those that count beside them. Else 0.
    turning: f64,
    start: f64,
}

/// The units of speeds and times, which are whatever those of v₀ and A make them.
pub const SPEED: &str = "that of v0";
/// See [`SPEED`].
pub const TIME: &str = "that of v0/A";
/// See [`SPEED`].
pub const LENGTH: &str = "that of v0²/A";

impl Fields for ConstantState {
    fn fields(&self) -> Vec<Field> {
        let lasts = self.stop_time.map_or(self.t, |stop| stop.min(self.t));
        let way = self.v.max(self.start) * lasts;
        vec![
            Field::within(self.turning, "v", self.v).of(SPEED),
            Field::within(LEAST_ANGLE, "theta", self.theta)
                .unseen_below(UNSEEN_ANGLE)
                .of(RADIANS),
            Field::new("t", self.t).of(TIME),
            Field::within(self.v.max(self.turning), "vx", self.vx).of(SPEED),
            Field::within(self.v.max(self.turning), "vy", self.vy).of(SPEED),
            Field::within(way, "x", self.x).of(LENGTH),
            Field::within(way, "y", self.y).of(LENGTH),
            Field::new("stop_time", self.stop_time).of(TIME),
        ]
    }
}

impl<T: Quantity> ConstantProblem<T> {
    /// The velocity at the moment asked for.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for a parameter out of range or an angle that the velocity never has: it turns
    /// from θ₀ towards 0 and gets there only in the limit. [`SolveError::NoStop`] for the stop of one that goes on.
    pub fn solve(&self) -> Result<Answer<ConstantState>, SolveError> {
        let near = self.near();
        near.check()?;
        let said = Said::by(|nudge| {
            let there = match nudge {
                None => self.formulas().at(self.at.map(Into::into)),
                Some(by) => {
                    let lambda = by * near.lambda;
                    // Without friction what is rounded is the speed.
                    let v0 = if lambda == 0.0 { by * near.v0 } else { near.v0 };
                    let nudged = ConstantProblem { lambda, v0, ..near };
                    nudged.formulas().at(near.at.map(Into::into))
                }
            };
            there.map(|exactly| exactly.rounded(&near))
        })?;
        let note = near.note(&said.given);
        Answer::by_either(said, near.motions(), 0.0, note)
    }

    /// The path of the velocity.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let (near, answer) = (self.near(), self.solve()?.best);
        let shown = answer.stop_time.unwrap_or(3.0 * near.v0 / near.accel);
        let motion = near.launch()?.motion(shown.max(answer.t))?;
        let end = motion.end().t;
        let states: Result<Vec<_>, _> = steps(end, 200).map(|t| motion.at(t)).collect();
        let mut states = states?;
        states.extend(motion.nodes());
        states.sort_by(|a, b| a.t.total_cmp(&b.t));
        Ok(Curve {
            title: "The velocity under constant acceleration",
            x: "v_x",
            y: "v_y",
            units: [SPEED; 2],
            equal: false,
            points: states.iter().map(|state| state.v).collect(),
        })
    }

    fn near(&self) -> ConstantProblem {
        ConstantProblem {
            lambda: self.lambda.into(),
            v0: self.v0.into(),
            theta0: self.theta0.into(),
            accel: self.accel.into(),
            at: self.at.map(Into::into),
        }
    }

    fn formulas(&self) -> Formulas {
        Formulas {
            lambda: self.lambda.into(),
            a: self.accel.into(),
            v0: self.v0.into(),
            theta0: self.theta0.into(),
        }
    }
}

impl ConstantProblem {
    fn check(&self) -> Result<(), SolveError> {
        let fit = self.lambda == 0.0 || (1e-20..=1e20).contains(&self.lambda);
        check("lambda", self.lambda, fit, "0 or between 1e-20 and 1e20")?;
        size("v0", self.v0)?;
        size("accel", self.accel)?;
        check_moment(self.theta0, self.at)
    }

    fn turning(&self) -> f64 {
        if self.theta0 == PI && self.lambda < 1.0 {
            SMALL * self.v0
        } else {
            0.0
        }
    }

    fn launch(&self) -> Result<Launch, SolveError> {
        let launch = Launch::new(self.lambda, self.accel, self.v0, self.theta0);
        Ok(launch?)
    }

    /// The motion, and the motion in other units of length.
    fn motions(&self) -> Option<[ConstantState; 2]> {
        let other = ConstantProblem {
            v0: UNITS * self.v0,
            accel: UNITS * self.accel,
            ..*self
        };
        let back = |state: ConstantState| ConstantState {
            v: state.v / UNITS,
            vx: state.vx / UNITS,
            vy: state.vy / UNITS,
            x: state.x / UNITS,
            y: state.y / UNITS,
            turning: self.turning(),
            start: self.v0,
            ..state
        };
        let motion = followed(self.by_motion())?;
        Some([motion, followed(other.by_motion()).map_or(motion, back)])
    }

    /// Nothing where the motion stops, as far as its numbers reach, before it has the angle.
    fn by_motion(&self) -> Result<Option<ConstantState>, SolveError> {
        let launch = self.launch()?;
        let rests = launch.comes_to_rest();
        let to_rest = rests.then(|| launch.motion_to_rest()).transpose()?;
        let stop_time = to_rest.as_ref().and_then(Motion::first_stop);
        let state = match self.at {
            At::Time(t) => launch.motion(t)?.end(),
            At::Stop => match &to_rest {
                Some(motion) => motion.end(),
                None => return Ok(None),
            },
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
        Ok(Some(ConstantState {
            v: state.speed(),
            theta: match state.speed() {
                0.0 if stop_time.is_some_and(|stop| stop <= state.t) => last_angle(self.theta0),
                _ => state.direction(),
            },
            t: state.t,
            vx: state.v[0],
            vy: state.v[1],
            x: state.x[0],
            y: state.x[1],
            stop_time,
            turning: self.turning(),
            start: self.v0,
        }))
    }

    /// The first state in this direction of a motion that never stops, followed as long as it takes.
    fn first_along(
        &self,
        launch: &Launch,
        towards: [f64; 2],
    ) -> Result<Option<motion::State>, SolveError> {
        let mut until = self.v0 / self.accel;
        while until <= LATEST {
            let motion = launch.motion(until)?;
            if let Some(state) = motion.first_along(towards)? {
                return Ok(Some(state));
            }
            until *= 4.0;
        }
        Ok(None)
    }
}

pub(super) fn check_moment(theta0: f64, at: At) -> Result<(), SolveError> {
    let fit = theta0 > -PI && theta0 <= PI;
    check("theta0", theta0, fit, "in (−π, π]")?;
    match at {
        At::Theta(theta) => check("theta", theta, theta.is_finite(), "finite"),
        At::Time(t) => check("time", t, (0.0..=1e40).contains(&t), "between 0 and 1e40"),
        At::Stop => Ok(()),
    }
}

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

/// The formulas of section 2.1 for one launch, in numbers of twice the width; section 3 uses them too.
#[derive(Debug, Clone, Copy)]
pub(super) struct Formulas {
    pub(super) lambda: Double,
    pub(super) a: Double,
    pub(super) v0: Double,
    pub(super) theta0: Double,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Exactly {
    pub(super) v: Double,
    pub(super) theta: Double,
    pub(super) t: Double,
    pub(super) velocity: [Double; 2],
    place: [Double; 2],
    pub(super) stop_time: Option<Double>,
}

impl Exactly {
    fn rounded(&self, launch: &ConstantProblem) -> ConstantState {
        let [vx, vy] = self.velocity.map(Double::to_f64);
        let [x, y] = self.place.map(Double::to_f64);
        ConstantState {
            v: self.v.to_f64(),
            theta: self.theta.to_f64(),
            t: self.t.to_f64(),
            vx,
            vy,
            x,
            y,
            stop_time: self.stop_time.map(Double::to_f64),
            turning: launch.turning(),
            start: launch.v0,
        }
    }
}

impl Formulas {
    /// (20), as the limit of the time's regular form, which keeps its digits near λ = 1; on the axis the angle
    /// stays what it is.
    fn stop_time(&self) -> Option<Double> {
        let Formulas { lambda, a, v0, .. } = *self;
        let one = Double::from(1.0);
        if self.straight_against() {
            (lambda >= one).then(|| v0 / (a * (lambda + one)))
        } else {
            (lambda > one).then(|| self.time(f64::NEG_INFINITY.into()))
        }
    }

    /// The time by ln r, r being the part to which tan(θ/2) has fallen.
    fn time(&self, ln_r: Double) -> Double {
        corrected::time(self.lambda, self.a, self.v0, self.theta0, ln_r)
    }

    /// The place by ln r, see [`time`](Self::time): v_x is v₀ (c r^(λ−1) − s r^(λ+1)) and v_y is v₀ sin θ₀ r^λ, with c and s
    /// the squares of the cosine and the sine of θ₀/2, and A dt = −v dr/r.
    fn place(&self, ln_r: Double) -> [Double; 2] {
        let Formulas {
            lambda,
            v0,
            theta0,
            a,
        } = *self;
        let (one, two) = (Double::from(1.0), Double::from(2.0));
        let half = theta0 / two;
        let [c, s] = [half.cos().squared(), half.sin().squared()];
        let fall = |k: Double| ln_r.exp_fall(k);
        [
            c.squared() * fall(two * (lambda - one)) - s.squared() * fall(two * (lambda + one)),
            theta0.sin() * (c * fall(two * lambda - one) + s * fall(two * lambda + one)),
        ]
        .map(|part| part * v0.squared() / a)
    }

    fn straight_against(&self) -> bool {
        self.theta0.to_f64() == PI
    }

    fn state(&self, v: Double, theta: Double, t: Double, place: [Double; 2]) -> Exactly {
        let velocity = match theta.to_f64() {
            PI => [-v, 0.0.into()],
            _ => printed::eq4_velocity(v, theta),
        };
        Exactly {
            v,
            theta,
            t,
            velocity,
            place,
            stop_time: self.stop_time(),
        }
    }

    fn stopped(&self, t: Double, place: [Double; 2]) -> Exactly {
        let theta = last_angle(self.theta0.to_f64());
        self.state(0.0.into(), theta.into(), t, place)
    }

    fn on_axis(&self, t: Double) -> Exactly {
        let Formulas {
            lambda,
            a,
            v0,
            theta0,
        } = *self;
        let (one, two, zero) = (Double::from(1.0), Double::from(2.0), 0.0.into());
        let stop = v0 / (a * (lambda + one));
        let way = |speed: Double, lasts: Double| [speed / two * lasts, zero];
        if let Some(end) = self.stop_time().filter(|end| *end <= t) {
            let sense = if theta0 == zero { v0 } else { -v0 };
            self.stopped(t, way(sense, end))
        } else if theta0 == zero {
            let v = v0 + a * (one - lambda) * t;
            self.state(v, zero, t, way(v0 + v, t))
        } else if t < stop {
            let v = v0 - a * (one + lambda) * t;
            self.state(v, PI.into(), t, way(-(v0 + v), t))
        } else {
            let v = a * (one - lambda) * (t - stop);
            let place = [way(v, t - stop)[0] - way(v0, stop)[0], zero];
            self.state(v, zero, t, place)
        }
    }

    fn is_on_axis(&self) -> bool {
        self.theta0.to_f64() == 0.0 || self.straight_against()
    }

    /// By the logarithm of the part to which tan(θ/2) has fallen.
    fn at_log(&self, ln_r: Double, theta: Double, t: Double) -> Exactly {
        let v = corrected::speed_by_log(self.lambda, self.v0, self.theta0, ln_r);
        self.state(v, theta, t, self.place(ln_r))
    }

    pub(super) fn at(&self, at: At<Double>) -> Result<Exactly, SolveError> {
        match at {
            At::Theta(theta) => self.at_theta(theta),
            At::Time(t) => Ok(self.at_time(t)),
            At::Stop => {
                let stop = self.stop_time().ok_or(SolveError::NoStop)?;
                Ok(self.at_time(stop))
            }
        }
    }

    fn at_theta(&self, theta: Double) -> Result<Exactly, SolveError> {
        let Formulas {
            lambda,
            a,
            v0,
            theta0,
        } = *self;
        let (one, zero) = (Double::from(1.0), Double::from(0.0));
        if theta == theta0 {
            return Ok(self.state(v0, theta, zero, [zero; 2]));
        }
        if self.straight_against() && theta == zero && lambda < one {
            return Ok(self.on_axis(v0 / (a * (lambda + one))));
        }
        let size = |angle: Double| if angle < zero { -angle } else { angle };
        let between =
            theta != zero && (theta > zero) == (theta0 > zero) && size(theta) < size(theta0);
        if self.is_on_axis() || !between {
            return Err(unreached(theta.to_f64(), theta0.to_f64()));
        }
        // tan(θ₀/2)/tan(θ/2) − 1, without loss of digits where the two are close.
        let half = Double::from(0.5);
        let excess =
            ((theta0 - theta) * half).sin() / ((theta * half).sin() * (theta0 * half).cos());
        let ln_r = -excess.ln_1p();
        Ok(self.at_log(ln_r, theta, self.time(ln_r)))
    }

    fn at_time(&self, t: Double) -> Exactly {
        let zero = Double::from(0.0);
        if self.is_on_axis() {
            return self.on_axis(t);
        }
        if t == zero {
            return self.state(self.v0, self.theta0, zero, [zero; 2]);
        }
        let stopped = self.stop_time().is_some_and(|stop| stop <= t);
        let Some(ln_r) = self.log_at(t).filter(|_| !stopped) else {
            return self.stopped(t, self.place(f64::NEG_INFINITY.into()));
        };
        let [sine, cosine] = corrected::half_angle(self.theta0, ln_r.exp());
        let theta = sine.atan2(cosine) * 2.0.into();
        self.at_log(ln_r, theta, t)
    }

    /// ln r at the time `t` > 0: a time falls from there to 0 while ln r rises, ever more steeply. Nothing if it is never
    /// that late.
    fn log_at(&self, t: Double) -> Option<Double> {
        let (two, half) = (Double::from(2.0), Double::from(0.5));
        let mut early = Double::from(0.0);
        let mut late = Double::from(-1.0) / (Double::from(1.0) + self.lambda);
        for _ in 0..DOUBLINGS {
            if self.time(late) >= t {
                break;
            }
            (early, late) = (late, late * two);
        }
        if self.time(late) < t {
            return None;
        }
        let mut at = (early + late) * half;
        for _ in 0..HALVINGS {
            let off = self.time(at) - t;
            *if off.to_f64() < 0.0 {
                &mut early
            } else {
                &mut late
            } = at;
            // dt/d(ln r) = −v/A.
            let slope = -corrected::speed_by_log(self.lambda, self.v0, self.theta0, at) / self.a;
            let next = at - off / slope;
            let inside = late < next && next < early;
            let next = if inside { next } else { (early + late) * half };
            let moved = (next - at).to_f64().abs();
            at = next;
            if moved <= f64::EPSILON * f64::EPSILON * at.to_f64().abs() {
                break;
            }
        }
        Some(at)
    }
}

impl ConstantProblem {
    /// The printed formulas, if they give the state too.
    fn note(&self, state: &ConstantState) -> String {
        let ConstantProblem {
            lambda,
            accel: a,
            v0,
            theta0,
            ..
        } = *self;
        let v = printed::eq11_speed(lambda, v0, theta0, state.theta);
        let t = printed::eq13_time(lambda, a, v0, theta0, state.theta);
        let near = |x: f64, y: f64| (x - y).abs() <= PRINTED * y.abs();
        let formula = if self.formulas().is_on_axis() {
            "by uniformly accelerated motion along the x axis, where (11) and (13) have no value"
        } else if state.v == 0.0 && matches!(self.at, At::Theta(theta) if theta != 0.0) {
            "by the limit of (11) and (13): it still moves there, slower than any floating-point number"
        } else if state.v == 0.0 {
            "at rest: (20) is over"
        } else if near(v, state.v) && near(t, state.t) {
            "by (11) and (13)"
        } else {
            "by the form that replaces (11) and (13), which as printed have no value here or lose their digits"
        };
        formula.to_owned()
    }
}

/// Later than this no motion is followed.
const LATEST: f64 = 1e50;
/// Doublings that lead from any time scale to any other.
const DOUBLINGS: usize = 300;
/// Steps in which a number is found to all its digits, even if each only halves the room.
const HALVINGS: usize = 250;

/// To this the printed formulas must give a state to be named as its source.
const PRINTED: f64 = 1e-9;
