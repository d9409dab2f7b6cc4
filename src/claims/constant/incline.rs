//! The inclined plane, in three dimensions, as the case A = g sin β, λ = μ cot β of section 2.1. It is a part of the
//! claim that the article on the inclined plane agrees: that its formulas are right too is not known here.

use super::prelude::*;
use crate::paper::general;
use nalgebra::Vector3;

type Vector = Vector3<f64>;

/// After Rodrigues.
fn turned(vector: Vector, axis: Vector, angle: f64) -> Vector {
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    cosine * vector + sine * axis.cross(&vector) + (1.0 - cosine) * axis.dot(&vector) * axis
}

struct Incline {
    g: f64,
    mu: f64,
    beta: f64,
    /// Down the slope.
    down: Vector,
    /// Along the slope, horizontally.
    across: Vector,
    normal: Vector,
    v0: f64,
    theta0: f64,
}

impl Incline {
    fn any(points: &mut Points) -> Self {
        let beta = points.uniform(0.1, 1.4);
        let [x, y, z] = [Vector::x(), Vector::y(), Vector::z()];
        let direction = points.uniform(0.0, 6.0);
        let axis = turned(y, z, direction);
        let down = turned(turned(x, z, direction), axis, beta);
        let normal = turned(z, axis, beta);
        Incline {
            g: points.uniform(1.0, 20.0),
            mu: points.uniform(0.01, 1.0),
            beta,
            down,
            across: normal.cross(&down),
            normal,
            v0: points.uniform(0.5, 5.0),
            theta0: points.uniform(0.1, 3.0),
        }
    }

    /// On a unit mass that slides with velocity `v`.
    fn acceleration(&self, v: Vector) -> Vector {
        let weight = -self.g * Vector::z();
        let push = -weight.dot(&self.normal);
        weight + push * self.normal - self.mu * push / v.norm() * v
    }

    fn lambda(&self) -> f64 {
        self.mu / libm::tan(self.beta)
    }

    fn a(&self) -> f64 {
        self.g * libm::sin(self.beta)
    }

    fn velocity(&self, v: f64, theta: f64) -> Vector {
        v * libm::cos(theta) * self.down + v * libm::sin(theta) * self.across
    }

    fn at(&self) -> String {
        let Incline {
            g,
            mu,
            beta,
            v0,
            theta0,
            ..
        } = self;
        format!("g = {g:.6}, μ = {mu:.6}, β = {beta:.6}, v₀ = {v0:.6}, θ₀ = {theta0:.6}")
    }
}

/// A printed formula of (λ, A, v₀, θ₀, θ) with what is found of it on the incline, and the size in units of which that is
/// known.
fn slides(compared: Compared, pair: fn([Double; 5], &Turn) -> (Double, f64, f64)) -> Evidence {
    let trial = Trial::by(Integration, Printed, compared, FOREIGN);
    let mut points = Points::here();
    trial
        .over(0..300, |_| {
            let incline = Incline::any(&mut points);
            let duration =
                points.uniform(0.1, 0.5) * incline.v0 / (incline.a() * (1.0 + incline.lambda()));
            let start = incline.velocity(incline.v0, incline.theta0);
            let rate = |_: f64, v: &[f64; 3]| incline.acceleration(Vector::from(*v)).into();
            let end = dop853::end(rate, 0.0, start.into(), duration, 1e-14, 1e-16)?;
            let end = Vector::from(end);
            let theta = libm::atan2(end.dot(&incline.across), end.dot(&incline.down));
            let Incline { v0, theta0, .. } = incline;
            let at = [incline.lambda(), incline.a(), v0, theta0, theta].map(Double::from);
            let turn = Turn {
                theta,
                t: duration,
                v: end.norm(),
                ..Turn::launch(incline.lambda(), incline.a(), v0, theta0)
            };
            let (stated, found, scale) = pair(at, &turn);
            Ok(Pair::wide(incline.at(), stated, found).within(scale))
        })
        .of_a_part()
}

fn same_motion() -> Evidence {
    let trial = Trial::by(
        Integration,
        Printed,
        [
            "the velocity by (1), integrated in the plane, as the component down the slope plus twice that across,",
            "the same sum for the motion on an incline in three dimensions",
        ],
        FOREIGN,
    );
    trial.drawn(0..60, |_, points| {
        let incline = Incline::any(points);
        let (v, theta) = (incline.v0, incline.theta0);
        let duration = 0.4 * v / (incline.a() * (1.0 + incline.lambda()));
        let normal = incline.g * libm::cos(incline.beta);
        let law = |_: f64, v: &[f64; 2]| {
            general::eq1_velocity_rate([-incline.a(), 0.0], incline.mu, normal, *v)
        };
        let flat = [v * libm::cos(theta), v * libm::sin(theta)];
        let stated = dop853::end(law, 0.0, flat, duration, 1e-13, 1e-15);
        let [down, across] = stated.unwrap_or([f64::NAN; 2]);
        let rate = |_: f64, v: &[f64; 3]| incline.acceleration(Vector::from(*v)).into();
        let start = incline.velocity(v, theta);
        let end = dop853::end(rate, 0.0, start.into(), duration, 1e-14, 1e-16)?;
        let end = Vector::from(end);
        Ok(Pair {
            at: incline.at(),
            stated: down + 2.0 * across,
            found: end.dot(&incline.down) + 2.0 * end.dot(&incline.across),
            scale: v,
        })
    })
}

pub(super) fn forces() -> Evidence {
    let trial = Trial::consistency(
        Printed,
        [
            "(6) plus twice (7)",
            "the same sum of the components of weight, normal force and friction",
        ],
    );
    let mut points = Points::here();
    trial
        .over(0..1000, |_| {
            let incline = Incline::any(&mut points);
            let (lambda, a, theta) = (incline.lambda(), incline.a(), incline.theta0);
            let force = incline.acceleration(incline.velocity(incline.v0, theta));
            Ok(Pair {
                at: incline.at(),
                stated: printed::eq6_vx_rate(lambda, a, theta)
                    + 2.0 * printed::eq7_vy_rate(lambda, a, theta),
                found: force.dot(&incline.down) + 2.0 * force.dot(&incline.across),
                scale: a * (1.0 + lambda),
            })
        })
        .of_a_part()
}

attempts![
    eq1 = {
        let trial = Trial::consistency(
            Printed,
            [
                r"(1), with $g\sin\beta$ against the slope for $\bm A$ and $g\cos\beta$ for $g$, as the component down the slope plus twice that across,",
                "the same sum for weight, normal force and friction",
            ],
        );
        trial.drawn(0..200, |_, points| {
            let incline = Incline::any(points);
            let (v, theta) = (incline.v0, incline.theta0);
            let [down, across] = general::eq1_velocity_rate(
                [-incline.a(), 0.0],
                incline.mu,
                incline.g * libm::cos(incline.beta),
                [v * libm::cos(theta), v * libm::sin(theta)],
            );
            let force = incline.acceleration(incline.velocity(v, theta));
            Ok(Pair {
                at: incline.at(),
                stated: down + 2.0 * across,
                found: force.dot(&incline.down) + 2.0 * force.dot(&incline.across),
                scale: incline.a() * (1.0 + incline.lambda()),
            })
        })
    },
    same_motion,
    speed = slides(
        Compared::one(
            "(11)",
            "the speed on an inclined plane in three dimensions, at its angle to the slope",
        ),
        |[lambda, _, v0, theta0, theta], turn| {
            let stated = printed::eq11_speed(lambda, v0, theta0, theta);
            (stated, turn.v, turn.v * turn.condition())
        }
    ),
    time = slides(
        Compared::one(
            "(13) at the angle to the slope that is reached on an inclined plane in three dimensions",
            "the time",
        ),
        |[lambda, a, v0, theta0, theta], turn| {
            let stated = printed::eq13_time(lambda, a, v0, theta0, theta);
            (stated, turn.t, turn.time_scale())
        }
    ),
    forces
];
