//! A block on a plane of constant acceleration, which in its frame is a steady pull.

use super::posed::{self, Ask, Posed};
use super::{Answer, Other, Task, fraction};
use crate::{Launch, MotionError, Plane, Signal, State, run};
use std::f64::consts::FRAC_PI_2;
use trialbook::certified::{ball::Ball, enclosure::Enclosure, interval::Interval, root::refine};

const ACROSS: &str = "A block slides on a horizontal plane with friction λ = μg/A = 3/2 under a steady pull A along x (an inclined \
     plane serves as well). It starts at the origin with the speed v₀ along y. Units: A = v₀ = 1.";

const STRONG: &str = "block mu=1.5 g=1 pull=1 throw=1@1.5707963267948966 until=stop";

/// With d|v|/dt = A cos θ − λA and dv_x/dt = A − λA cos θ, λ|v| + v_x changes at the rate A (1 − λ²).
pub(super) const STOP_TIME: Task = Task {
    id: "stop-time",
    setup: ACROSS,
    posed: Posed::of(STRONG, Ask::T),
    question: "When does it stop?",
    unit: "v₀/A",
    motion: || Ok(Answer::Number(stopped()?.t)),
    other: fraction!(6 / 5),
};

/// With u = tan(θ/2) the hodograph is |v| = uλ⁻¹(1 + u²)/2, so that y = ½∫u(1 + u²)du = 3/8 and x = ¼∫(1 − u⁴)du = 1/5.
pub(super) const STOP_PLACE: Task = Task {
    id: "stop-place",
    setup: ACROSS,
    posed: Posed {
        grid: Some(posed::THROWN),
        ..Posed::of(STRONG, Ask::Distance)
    },
    question: "How far from the start does it stop? (It is at x = 1/5, y = 3/8.)",
    unit: "v₀²/A",
    motion: || {
        let [x, y] = stopped()?.x;
        Ok(Answer::Number(libm::hypot(x, y)))
    },
    other: fraction!(17 / 40),
};

fn stopped() -> Result<State, MotionError> {
    Ok(Launch::new(1.5, 1.0, 1.0, FRAC_PI_2)?
        .motion_to_rest()?
        .end())
}

/// λ|v| + v_x = 2 at t = 2, and with v_y = s = √u on the hodograph this is s⁴ + 8s = 3.
pub(super) const TURNING: Task = Task {
    id: "turning",
    setup: "A block slides on a horizontal plane with friction λ = μg/A = 1/2 under a steady pull A along x. It starts with the \
            speed v₀ along y. Units: A = v₀ = 1.",
    posed: Posed::of(
        "block mu=0.5 g=1 pull=1 throw=1@1.5707963267948966 until=time=2",
        Ask::VY,
    ),
    question: "What is its velocity along y at t = 2?",
    unit: "v₀",
    motion: || {
        let motion = Launch::new(0.5, 1.0, 1.0, FRAC_PI_2)?.motion(2.0)?;
        Ok(Answer::Number(motion.end().v[1]))
    },
    other: Other::Digits(Enclosure(|bits| {
        let int = |n: i64, s: &Ball| Ball::int(n, s.bits());
        let quartic = |s: &Ball| {
            let cube = s * s * s;
            let value = &cube * s + int(8, s) * s - int(3, s);
            Some([value, int(4, s) * &cube + int(8, s)])
        };
        refine(quartic, Interval::new(0.3, 0.4), bits)
    })),
};

pub(super) const CREEP: Task = Task {
    id: "creep",
    setup: "A block lies at rest on a horizontal plane under a steady pull of 95 parts in 100 of what friction can hold: μg = 1, \
            A = 0.95 (an inclined plane serves as well).",
    posed: Posed {
        grid: Some(posed::HELD),
        ..Posed::of("block mu=1 g=1 pull=0.95 until=time=10", Ask::Distance)
    },
    question: "How far is it from its place at t = 10? (Static friction holds it: nowhere.)",
    unit: "μgT², T being the unit of t",
    motion: || {
        let end = run(&Plane::constant([-0.95, 0.0]), 1.0, at_rest(), 10.0)?.end();
        Ok(Answer::Number(libm::hypot(end.x[0], end.x[1])))
    },
    other: fraction!(0 / 1),
};

/// It leaves at t = 2, then dv/dt = (t − 2)/2.
pub(super) const BREAKAWAY: Task = Task {
    id: "breakaway",
    setup: "A block lies at rest on a horizontal plane with μg = 1. From t = 0 on it is pulled ever harder, A = t/2.",
    posed: Posed::of("block mu=1 g=1 pull=t/2 until=time=4", Ask::X),
    question: "How far has it come at t = 4?",
    unit: "μgT², T being the unit of t",
    motion: || {
        let pull = Signal::Polynomial(vec![0.0, 0.5]);
        let end = run(&Plane::along([-1.0, 0.0], pull), 1.0, at_rest(), 4.0)?.end();
        Ok(Answer::Number(end.x[0]))
    },
    other: fraction!(2 / 3),
};

fn at_rest() -> State {
    State::moving([0.0; 2])
}
