//! The motions that the printed formulas of section 2.1 are held against: launches at a speed v₀ and an
//! angle θ₀, followed until the velocity has turned to an angle θ.

use super::prelude::*;
use crate::motion::Launch;
use crate::numerics::NumericsError;
use std::cell::Cell;

const EVALUATIONS: usize = 20_000;

/// A launch, and the moment at which the velocity has turned to θ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Turn {
    /// Friction λ = μg/A.
    pub lambda: f64,
    pub a: f64,
    pub v0: f64,
    pub theta0: f64,
    pub theta: f64,
    pub t: f64,
    pub v: f64,
    /// dv/dt there, by differences.
    pub rate: [f64; 2],
}

impl Turn {
    pub(crate) fn velocity0(&self) -> Result<[f64; 2], MotionError> {
        Ok(self.checked()?.velocity())
    }

    /// True if the launch is exactly with or against the inertial force.
    pub(crate) fn is_straight(&self) -> bool {
        self.theta0 == 0.0 || self.theta0 == PI
    }

    pub(crate) fn formula(&self, speed: fn(Double, Double, Double, Double) -> Double) -> Double {
        let [lambda, v0, theta0, theta] =
            [self.lambda, self.v0, self.theta0, self.theta].map(Double::from);
        speed(lambda, v0, theta0, theta)
    }

    /// How much a relative error of the angles grows in the speed and the time: tan(θ/2) is steep near π.
    pub(crate) fn condition(&self) -> f64 {
        let steep = |theta: f64| (1.0 + self.lambda) * (theta / libm::sin(theta)).abs();
        steep(self.theta0).max(steep(self.theta))
    }

    /// The size in units of which the time is known: it grows with the errors of the angles by A dt = −v dθ/sin θ too.
    pub(crate) fn time_scale(&self) -> f64 {
        let moved = |v: f64, theta: f64| (v * theta / (self.a * libm::sin(theta))).abs();
        let ends = moved(self.v0, self.theta0).max(moved(self.v, self.theta));
        ends.max(self.t * self.condition())
    }

    /// What a unit of relative rounding of the time and the angles makes of the speed that they determine together: little
    /// where λ + cos θ is small.
    pub(crate) fn speed_at_time_scale(&self) -> f64 {
        let of = |v: f64, theta: f64| v * (self.lambda + theta.abs());
        let gained = self.a * self.t * (1.0 + self.lambda);
        let largest = gained
            .max(of(self.v0, self.theta0))
            .max(of(self.v, self.theta));
        self.v
            .max(largest / (self.lambda + libm::cos(self.theta)).abs())
    }

    /// tan(θ/2) over its initial value.
    pub(crate) fn r(&self) -> f64 {
        Scalar::tan(self.theta / 2.0) / Scalar::tan(self.theta0 / 2.0)
    }

    pub(crate) fn has_a_time(&self) -> bool {
        self.lambda != 1.0 && self.lambda + libm::cos(self.theta0) != 0.0
    }

    /// True where [`condition`](Self::condition) costs at most two digits or so; the other points are left to other
    /// routes.
    pub(crate) fn is_gentle(&self) -> bool {
        self.condition() < 300.0
    }

    /// ∫ f dθ from θ₀ to θ, to within `enough`, in y = ln tan(θ/2) with dθ = sin θ dy: there a power of the tangent
    /// is an exponential function, smooth however steep. A wrong law may have no integral after its twenty thousand
    /// values.
    pub(crate) fn integral(
        &self,
        f: impl Fn(f64) -> f64,
        enough: f64,
    ) -> Result<f64, NumericsError> {
        let side = 1f64.copysign(self.theta0);
        let y = |theta: f64| libm::log(libm::tan(theta.abs() / 2.0));
        let left = Cell::new(EVALUATIONS);
        let rate = |y: f64| {
            left.set(left.get().saturating_sub(1));
            if left.get() == 0 {
                return f64::NAN;
            }
            let theta = side * 2.0 * libm::atan(libm::exp(y));
            f(theta) * libm::sin(theta)
        };
        Ok(integral_within(rate, y(self.theta0), y(self.theta), enough)?.value)
    }

    /// ln tan(θ/2), less what it was at the start.
    pub(crate) fn ln_fall(&self) -> f64 {
        let ln = |theta: f64| libm::log(libm::tan(theta.abs() / 2.0));
        ln(self.theta) - ln(self.theta0)
    }

    /// ln tan(θ₀/2).
    fn start_over_the_angle(&self) -> f64 {
        libm::log(libm::tan(self.theta0.abs() / 2.0))
    }

    /// d ln v/dy with y for ln tan(θ/2): Newton's law says d ln v = (λ − cos θ) dy along the velocity and A dt = −v dy across
    /// it, where cos θ = −tanh y.
    fn along(&self, y: f64) -> f64 {
        self.lambda + libm::tanh(y)
    }

    /// The speed when the velocity has turned into the line of the acceleration; for λ = 1, with which it keeps that
    /// speed.
    pub(crate) fn last_speed_over_the_angle(&self) -> Result<f64, NumericsError> {
        let rate = |y: f64| self.along(y);
        // At y = −20 the tangent is 1e-9, and ln v is its square away from the last one.
        let fall = integral_within(rate, self.start_over_the_angle(), -20.0, 1e-14)?;
        Ok(self.v0 * libm::exp(fall.value))
    }

    pub(crate) fn time_over_the_angle(&self, ln_fall: f64) -> Result<f64, NumericsError> {
        let start = self.start_over_the_angle();
        let rate = |s: f64, [ln_v, _]: &[f64; 2]| [-self.along(start - s), libm::exp(*ln_v)];
        let [_, time] = dop853::end(rate, 0.0, [0.0; 2], -ln_fall, 1e-14, 1e-14)?;
        Ok(time * self.v0 / self.a)
    }

    pub(crate) fn time(&self, units: f64) -> f64 {
        units * self.v0 / self.a
    }

    pub(crate) fn motion(&self, until: f64) -> Result<Motion, MotionError> {
        self.checked()?.motion(until)
    }

    /// For λ > 1.
    pub(crate) fn motion_to_rest(&self) -> Result<Motion, MotionError> {
        self.checked()?.motion_to_rest()
    }

    pub(crate) fn launch(lambda: f64, a: f64, v0: f64, theta0: f64) -> Self {
        Turn {
            lambda,
            a,
            v0,
            theta0,
            theta: theta0,
            t: 0.0,
            v: v0,
            rate: [0.0; 2],
        }
    }

    fn checked(&self) -> Result<Launch, MotionError> {
        Launch::new(self.lambda, self.a, self.v0, self.theta0)
    }

    pub(crate) fn at(&self) -> String {
        let Turn {
            lambda,
            a,
            v0,
            theta0,
            theta,
            ..
        } = self;
        format!("λ = {lambda:.6}, A = {a:.6}, v₀ = {v0:.6}, θ₀ = {theta0:.6}, θ = {theta:.6}")
    }
}

pub(crate) static TURNS: Runs<Vec<Turn>> = Runs::new(|| every(launches().into_iter().map(turn)));

pub(crate) fn turns_where(
    wanted: impl Fn(&Turn) -> bool,
) -> impl Iterator<Item = Result<&'static Turn, Failure>> {
    only(TURNS.each(), move |turn| wanted(turn))
}

const LAMBDAS: [f64; 10] = [
    0.0,
    1e-6,
    0.3,
    1.0 - 1e-9,
    1.0,
    1.0 + 1e-9,
    1.5,
    3.0,
    10.0,
    30.0,
];

const ANGLES: [f64; 7] = [1e-6, 0.4, 1.3, PI / 2.0, 2.2, 3.0, PI - 1e-6];

/// (λ, A, v₀, θ₀, θ): the edges of the domain, launches with cos θ₀ = −λ and nearly so, turns to where the
/// hodograph is upright, λ cos θ = 1, and almost into the line of the acceleration, and random points.
fn launches() -> Vec<[f64; 5]> {
    let mut points = Points::here();
    let mut launches = Vec::new();
    let add = |lambda: f64, theta0: f64, launches: &mut Vec<_>, points: &mut Points| {
        let (a, v0) = (points.log_uniform(0.1, 10.0), points.log_uniform(0.1, 10.0));
        // As far round as leaves a millionth of the speed, or a fiftieth of the tangent of the half angle.
        let least = libm::log(1e-6) / (lambda + 1.0);
        let r = libm::exp(points.uniform(least.max(libm::log(0.02)), -0.02));
        let theta = 2.0 * libm::atan(r * libm::tan(theta0 / 2.0));
        launches.push([lambda, a, v0, theta0, theta]);
    };
    for theta0 in [2.0, 1.8, 2.9] {
        for off in [0.0, 1e-9, -1e-9] {
            add(off - libm::cos(theta0), theta0, &mut launches, &mut points);
        }
    }
    for upright in [0.3, 0.8, 1.2] {
        launches.push([1.0 / libm::cos(upright), 1.0, 2.0, 2.0, upright]);
    }
    for lambda in [0.0, 0.5, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.2] {
        for theta0 in ANGLES {
            launches.push([lambda, 1.0, 2.0, theta0, 1e-5 * theta0]);
        }
    }
    for lambda in LAMBDAS {
        for theta0 in ANGLES {
            for sign in [1.0, -1.0] {
                add(lambda, sign * theta0, &mut launches, &mut points);
            }
        }
    }
    for i in 0..1200 {
        let lambda = if i % 2 == 0 {
            points.uniform(0.0, 1.0)
        } else {
            points.uniform(1.0, 8.0)
        };
        let theta0 = points.sign() * points.uniform(0.01, PI - 0.01);
        add(lambda, theta0, &mut launches, &mut points);
    }
    launches
}

fn turn([lambda, a, v0, theta0, theta]: [f64; 5]) -> Result<Turn, MotionError> {
    let launch = Turn::launch(lambda, a, v0, theta0);
    let mut until = 4.0 * v0 / a;
    while until < 1e9 * v0 / a {
        let motion = launch.motion(until)?;
        if let Some(state) = motion.first_along([libm::cos(theta), libm::sin(theta)])?
            && state.t < 0.9 * until
        {
            let v = state.speed();
            // A thousandth of the time in which the forces can change the velocity by itself.
            let h = 1e-3 * state.t.min(v / (a * (1.0 + lambda)));
            let turned = Turn {
                theta,
                t: state.t,
                v,
                ..launch
            };
            let rate = rate(&motion, state.t, h)?;
            return Ok(Turn { rate, ..turned });
        }
        until *= 16.0;
    }
    Err(MotionError::Argument {
        name: "θ",
        value: theta,
        range: "an angle that the motion reaches",
    })
}

/// By central differences of fourth order.
fn rate(motion: &Motion, t: f64, h: f64) -> Result<[f64; 2], MotionError> {
    let difference = |h: f64| -> Result<[f64; 2], MotionError> {
        let (after, before) = (motion.at(t + h)?.v, motion.at(t - h)?.v);
        Ok([0, 1].map(|i| (after[i] - before[i]) / (2.0 * h)))
    };
    let (near, far) = (difference(h)?, difference(2.0 * h)?);
    Ok([0, 1].map(|i| (4.0 * near[i] - far[i]) / 3.0))
}

fn at_random(lambda: f64, theta0: f64, points: &mut Points) -> Turn {
    let [a, v0] = [0.1, 0.1].map(|low| points.log_uniform(low, 10.0));
    Turn::launch(lambda, a, v0, theta0)
}

/// Over the angle, for λ > 1.1; later than forty times the time in which the speed falls to an e-th nothing is left.
pub(crate) static STOPS_OVER_THE_ANGLE: Runs<Vec<(Turn, f64)>> = Runs::new(|| {
    let starts = every(STOPS.each())?.into_iter().map(|stop| stop.start);
    every(starts.filter(|start| start.lambda > 1.1).map(|start| {
        let time = start.time_over_the_angle(-40.0 / (start.lambda - 1.0));
        time.map(|time| (start, time))
    }))
});

/// Below, at and above the critical friction, so far round that next to no angle is left.
pub(crate) static LATE_TURNS: Runs<Vec<Turn>> = Runs::new(|| {
    let mut points = Points::here();
    every((0..60).map(|i| {
        let lambda = match i % 4 {
            0 => 1.0,
            1 => points.uniform(0.0, 1.0),
            2 => 1.0 + points.sign() * points.log_uniform(1e-6, 0.1),
            _ => points.uniform(1.0, 3.0),
        };
        let theta0 = points.sign() * points.uniform(0.05, 3.0);
        // The speed changes by a factor of a million at most.
        let most = (14.0 / (lambda - 1.0).abs()).min(180.0);
        let r = libm::exp(-points.uniform(5.0, most));
        let theta = 2.0 * libm::atan(r * libm::tan(theta0 / 2.0));
        let [a, v0] = [0.1, 0.1].map(|low| points.log_uniform(low, 10.0));
        turn([lambda, a, v0, theta0, theta])
    }))
});

/// Half a unit of time later: the angle has stayed.
pub(crate) fn straight() -> impl Iterator<Item = Result<Turn, Failure>> {
    let mut points = Points::here();
    (0..40).map(move |i| {
        let theta0 = if i % 2 == 0 { 0.0 } else { PI };
        let launch = Turn::launch(
            points.uniform(0.0, 0.9),
            points.uniform(0.5, 2.0),
            points.uniform(4.0, 8.0),
            theta0,
        );
        let t = 0.5;
        let motion = launch.motion(2.0 * t)?;
        Ok(Turn {
            t,
            v: motion.at(t)?.speed(),
            rate: rate(&motion, t, 1e-3)?,
            ..launch
        })
    })
}

/// For λ < 1, where cos θ = −λ.
pub(crate) fn turns_to_the_gap() -> impl Iterator<Item = Result<Turn, MotionError>> {
    let mut points = Points::here();
    (0..40).map(move |_| {
        let theta = points.uniform(PI / 2.0 + 0.05, PI - 0.3);
        let theta0 = points.uniform(theta + 0.05, PI - 0.05);
        let lambda = -libm::cos(theta);
        turn([
            lambda,
            points.uniform(0.5, 2.0),
            points.uniform(0.5, 2.0),
            theta0,
            theta,
        ])
    })
}

pub(crate) fn critical_turns() -> impl Iterator<Item = Result<Turn, MotionError>> {
    let mut points = Points::here();
    (0..1000).map(move |_| {
        let theta0 = points.sign() * points.uniform(0.01, PI - 0.01);
        let theta = theta0 * points.uniform(0.05, 0.98);
        turn([
            1.0,
            points.log_uniform(0.1, 10.0),
            points.log_uniform(0.1, 10.0),
            theta0,
            theta,
        ])
    })
}

pub(crate) fn frictionless() -> impl Iterator<Item = Result<(Turn, State), Failure>> {
    let mut points = Points::here();
    (0..1000).map(move |i| {
        let theta0 = match i {
            0 => 0.0,
            1 => PI,
            _ => points.sign() * points.uniform(0.0, PI),
        };
        let launch = at_random(0.0, theta0, &mut points);
        let late = match i % 4 {
            0 => points.log_uniform(5.0, 1e5),
            _ => points.uniform(0.1, 5.0),
        };
        let t = late * launch.v0 / launch.a;
        Ok((launch, launch.motion(t)?.at(t)?))
    })
}

/// Units v₀/A of time after which a motion at λ = 1 has settled: v_y falls as exp(−A t/v_x(∞)), v_x(∞) ≤ v₀.
const LATE: f64 = 40.0;

pub(crate) static SETTLED: Runs<Vec<(Turn, State)>> = Runs::new(|| every(all_settled()));

fn all_settled() -> impl Iterator<Item = Result<(Turn, State), Failure>> {
    let mut points = Points::here();
    (0..1000).map(move |i| {
        let theta0 = match i {
            0 => 0.0,
            1 => PI,
            2 => PI - 1e-6,
            3 => 1e-6,
            _ => points.sign() * points.uniform(0.0, PI),
        };
        let launch = at_random(1.0, theta0, &mut points);
        let t = launch.time(LATE);
        Ok((launch, launch.motion(t)?.at(t)?))
    })
}

#[derive(Debug, Clone)]
pub(crate) struct Stop {
    pub start: Turn,
    /// At the ends of the integrator's steps.
    pub nodes: Vec<State>,
    pub t: f64,
}

impl Stop {
    pub(crate) fn at(&self) -> String {
        self.start.at()
    }
}

/// From both ends of the angles and from friction just above the critical one.
pub(crate) static STOPS: Runs<Vec<Stop>> = Runs::new(|| every(all_stops()));

fn all_stops() -> impl Iterator<Item = Result<Stop, Failure>> {
    let mut points = Points::here();
    (0..700).map(move |i| {
        let lambda = match i % 4 {
            0 => 1.0 + points.log_uniform(1e-9, 1e-1),
            1 => points.uniform(1.1, 3.0),
            2 => points.uniform(3.0, 30.0),
            _ => points.log_uniform(30.0, 1e5),
        };
        let theta0 = match i % 20 {
            0 => 0.0,
            1 => PI,
            2 => PI - 1e-6,
            3 => 1e-6,
            _ => points.sign() * points.uniform(0.0, PI),
        };
        let start = at_random(lambda, theta0, &mut points);
        let motion = start.motion_to_rest()?;
        Ok(Stop {
            start,
            nodes: motion.nodes().collect(),
            t: motion.end().t,
        })
    })
}

/// A launch with λ ≤ 1, followed for a hundred million times v₀/A.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Aligned {
    pub start: Turn,
    /// Of the velocity at the end.
    pub angle: f64,
    /// The steps on which the angle grew, and the phases of rest.
    pub broken: usize,
}

impl Aligned {
    pub(crate) fn aligns(&self) -> bool {
        self.broken == 0
    }
}

/// Without those that friction stops for good.
pub(crate) static ALIGNED: Runs<Vec<Aligned>> = Runs::new(all_aligned);

pub(crate) static OTHERS_ALIGNED: Runs<Vec<Aligned>> = Runs::new(|| others(all_aligned));

fn all_aligned() -> Result<Vec<Aligned>, Failure> {
    let aligned = |start: Turn| -> Result<_, Failure> {
        let motion = start.motion(start.time(1e8))?;
        Ok(Aligned {
            start,
            angle: motion.end().direction(),
            broken: unlike_aligning(&motion),
        })
    };
    every(launches_below_critical().map(aligned))
}

fn unlike_aligning(motion: &Motion) -> usize {
    let angles: Vec<_> = motion.nodes().map(|s| s.direction().abs()).collect();
    let rests = motion
        .phases()
        .iter()
        .filter(|p| p.kind == PhaseKind::Stick);
    angles.windows(2).filter(|w| grows(w[0], w[1])).count() + rests.count()
}

/// By more than its rounding.
fn grows(before: f64, after: f64) -> bool {
    after > before * (1.0 + 1e-14)
}

fn launches_below_critical() -> impl Iterator<Item = Turn> {
    let mut points = Points::here();
    (0..120).map(move |i| {
        let lambda = match i % 4 {
            0 => 1.0,
            1 => 1.0 - points.log_uniform(1e-9, 1e-2),
            _ => points.uniform(0.0, 1.0),
        };
        let theta0 = match i % 25 {
            0 => 0.0,
            1 if lambda < 1.0 => PI,
            2 if lambda < 1.0 => PI - 1e-6,
            _ => points.sign() * points.uniform(0.0, PI - 0.1),
        };
        at_random(lambda, theta0, &mut points)
    })
}

/// At λ = 1, straight against the inertial force.
pub(crate) fn held() -> impl Iterator<Item = Turn> {
    let mut points = Points::here();
    (0..40).map(move |_| at_random(1.0, PI, &mut points))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{Plane, run};

    #[test]
    fn times_are_counted_in_units_of_the_launch() {
        assert_eq!(Turn::launch(1.0, 0.5, 10.0, 0.0).time(40.0), 800.0);
    }

    #[test]
    fn one_step_of_turning_away_is_one_too_many() {
        let aligns = |broken| {
            let start = Turn::launch(1.0, 0.5, 10.0, 0.0);
            Aligned {
                start,
                angle: 0.0,
                broken,
            }
            .aligns()
        };
        assert_eq!([0, 1, 2].map(aligns), [true, false, false]);
    }

    /// The last digit of an angle is no growth; the third last is.
    #[test]
    fn an_angle_grows_if_it_does_so_beyond_rounding() {
        let grown = [1e-15, 2e-14].map(|by| grows(3.0, 3.0 * (1.0 + by)));
        assert_eq!(grown, [false, true]);
        assert!(!grows(3.0, 2.0));
    }

    #[test]
    fn growing_angles_and_rests_are_counted() {
        let start = State::moving([1.0, 1.0]);
        let motion = |a: f64, friction: f64, until: f64| {
            run(&Plane::constant([a, 0.0]), friction, start, until).unwrap()
        };
        let away = motion(1.0, 0.5, 1.0);
        let times: Vec<_> = away.nodes().map(|s| s.t).collect();
        let steps = times.windows(2).filter(|w| w[0] < w[1]).count();
        assert!(steps > 1);
        assert_eq!(unlike_aligning(&away), steps);
        assert_eq!(unlike_aligning(&motion(-1.0, 0.5, 1.0)), 0);
        assert_eq!(unlike_aligning(&motion(-1.0, 2.0, 5.0)), 1);
    }
}
