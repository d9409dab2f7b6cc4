//! The accelerations on which statements about every A(t) are tried.

use super::prelude::*;

pub(super) struct Case {
    /// The acceleration, in the claim's own symbols.
    pub name: String,
    /// A(t).
    pub plane: Plane,
    /// μg.
    pub friction: f64,
    pub start: State,
}

/// The shapes that A(t) may have; all but the growing one are bounded by 1.
pub(super) const SHAPES: [&str; 6] = [
    "constant",
    "rotating",
    "growing",
    "decaying",
    "oscillating",
    "sign-changing",
];

/// The size of A(t) as a function of time, for the shapes along a fixed line; at most 1 but for the growing one.
pub(super) fn along_a_line(shape: usize, rate: f64) -> Signal {
    match SHAPES[shape] {
        "growing" => Signal::Polynomial(vec![1.0, rate]),
        "decaying" => Signal::Exponential { rate: -rate },
        "oscillating" => Signal::Sine {
            frequency: rate,
            phase: 0.3,
        },
        "sign-changing" => Signal::Square {
            start: 0.0,
            half: 1.0 / rate,
        },
        _ => Signal::constant(1.0),
    }
}

pub(super) fn any_start(points: &mut Points, speed: f64) -> State {
    let theta = points.uniform(-3.1, 3.1);
    State::moving([speed * libm::cos(theta), speed * libm::sin(theta)])
}

/// Accelerations of every bounded shape with largest size `amplitude`, friction 1, starts of every direction.
pub(super) fn bounded(amplitude: f64) -> impl Iterator<Item = Case> {
    let mut points = Points::here();
    let shapes = (0..SHAPES.len())
        .filter(|&i| SHAPES[i] != "growing")
        .cycle();
    shapes.take(40).map(move |shape| {
        let rate = points.log_uniform(0.3, 5.0);
        let speed = points.log_uniform(0.2, 5.0);
        let start = any_start(&mut points, speed);
        let plane = if SHAPES[shape] == "rotating" {
            Plane::rotating(Signal::constant(amplitude), rate, 0.5)
        } else {
            let direction = points.uniform(-3.1, 3.1);
            let along = [
                amplitude * libm::cos(direction),
                amplitude * libm::sin(direction),
            ];
            Plane::along(along, along_a_line(shape, rate))
        };
        Case {
            name: format!(
                "{} A, |A| ≤ {amplitude}, rate {rate:.6}, μg = 1, v = ({:.6}, {:.6})",
                SHAPES[shape], start.v[0], start.v[1]
            ),
            plane,
            friction: 1.0,
            start,
        }
    })
}
