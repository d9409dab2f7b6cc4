//! A shaken block whose friction is not the same forward and backward.
//!
//! Friction λ₊ and λ₋ is the same as (λ₊ + λ₋)/2 both ways with a steady pull (λ₋ − λ₊)/2 forward: a tilted tray, so an engine
//! without anisotropic friction can sit these tasks.

use super::posed::{self, Ask, Posed, Scan, repeated};
use super::{Answer, DIMENSIONLESS, ExamError, Other, Task, tray::sine};
use crate::drive::{Drive, DriveState, Friction, Sign};
use crate::numerics::roots::root;
use crate::validated::numbers;
use crate::{PhaseKind, Plane, Signal, run};
use std::f64::consts::{PI, TAU};

macro_rules! ratchet {
    ($numbers:literal) => {
        concat!(
            "A block lies on a tray that is shaken along x; in its frame the block feels the pull A sin t. Friction is λ₀A forward \
             and qλ₀A backward (or (1 + q)λ₀A/2 both ways with a steady pull of (q − 1)λ₀A/2 forward: a tilted tray), ",
            $numbers,
            ". Units: A = 1, period 2π. Wait until the motion repeats."
        )
    };
}

pub(super) const ORDERS: Task = Task {
    id: "orders",
    setup: ratchet!(
        "with (q, λ₀) = (1.5, 0.3), (1.5, 0.55), (1.5, 0.65), (2, 0.45), (2, 0.48), (3, 0.2), (3, 0.32), (3, 0.5), (6, 0.1), (6, 0.165)"
    ),
    posed: Posed {
        grid: Some(posed::TEN),
        ..repeated!("g=1 mu=0.3 mu-back=0.45", Ask::Order)
    },
    question: "In which order does the block go forward (F), go backward (B) and rest (R) in a period, beginning with F, for each of \
               the ten?",
    unit: "",
    motion: || {
        let drive = sine()?;
        let orders: Result<Vec<_>, _> = posed::TEN_POINTS
            .iter()
            .map(|&[q, l]| order(&drive, q, l))
            .collect();
        Ok(Answer::Order(orders?.join(" ")))
    },
    other: Other::Integrated(|| {
        let orders: Result<Vec<_>, _> = posed::TEN_POINTS
            .iter()
            .map(|&[q, l]| order_when_tilted(q, l))
            .collect();
        Ok(Answer::Order(orders?.join(" ")))
    }),
};

pub(super) const DRIFT: Task = Task {
    id: "drift",
    setup: ratchet!("with q = 2, λ₀ = 3/10"),
    posed: repeated!("g=1 mu=0.3 mu-back=0.6", Ask::MeanVX),
    question: "What is the mean velocity of the block?",
    unit: "A/ω",
    motion: || {
        let drive = sine()?;
        let start = DriveState { phi: 0.0, w: 0.0 };
        let outcome = drive.attractor(Friction::new(0.3, 0.6)?, start, 200)?;
        let settled = outcome
            .settled()
            .ok_or(ExamError::Missing("a motion that repeats"))?;
        Ok(Answer::Number(settled.displacement() / TAU))
    },
    other: Other::Integrated(|| {
        let motion = tilted(2.0, 0.3)?;
        let way = motion.end().x[0] - motion.at((PERIODS - 1.0) * TAU)?.x[0];
        Ok(Answer::Number(way / TAU))
    }),
};

pub(super) const NO_WAY_BACK: Task = Task {
    id: "no-way-back",
    setup: ratchet!("with q = 6"),
    posed: Posed {
        scan: Some(Scan {
            from: 0.15,
            to: 1.0 / 6.0,
            level: 0.0,
            within: 1e-11,
            unit: "m/s^2",
        }),
        ..repeated!("mu=1 mu-back=6 g={}", Ask::Back)
    },
    question: "Above which λ₀ does the block never go backward?",
    unit: DIMENSIONLESS,
    motion: || {
        let drive = sine()?;
        let (mut low, mut high) = (0.15, 1.0 / 6.0);
        while high - low > 1e-13 {
            let middle = 0.5 * (low + high);
            match order(&drive, 6.0, middle)?.contains('B') {
                true => low = middle,
                false => high = middle,
            }
        }
        Ok(Answer::Number(0.5 * (low + high)))
    },
    other: Other::Digits(numbers::E_6),
};

pub(super) const TOUCHING: Task = Task {
    id: "touching",
    setup: ratchet!("with λ₀ = 1/q, so that the pull can just not move it backward from rest"),
    posed: Posed {
        scan: Some(Scan {
            from: 4.0,
            to: 5.0,
            level: 1.5 * PI,
            within: 1e-11,
            unit: "m/s^2",
        }),
        ..Posed::of("block mu=1 g=1 mu-back=5 pull={}*sin(t) until=stop", Ask::T)
    },
    question: "For which q above 2 does its forward motion end where the pull backward is largest, at t = 3π/2?",
    unit: DIMENSIONLESS,
    motion: || {
        let drive = sine()?;
        let mut failed = None;
        let beyond = |q: f64| match slip_end(&drive, 1.0 / q) {
            Ok(end) => end - 1.5 * PI,
            Err(error) => {
                failed = Some(error);
                f64::NAN
            }
        };
        let q = root(beyond, 4.0, 5.0);
        match failed {
            Some(error) => Err(error),
            None => Ok(Answer::Number(q?)),
        }
    },
    other: Other::Digits(numbers::Q_Y),
};

/// From rest, when nothing moves the block backward.
fn slip_end(drive: &Drive, lambda: f64) -> Result<f64, ExamError> {
    let start = DriveState { phi: 0.0, w: 0.0 };
    let path = drive.advance(Friction::new(lambda, 2.0)?, start, TAU)?;
    let forward = path
        .intervals
        .iter()
        .find(|part| part.sign == Sign::Positive);
    Ok(forward.ok_or(ExamError::Missing("a forward slip"))?.end)
}

/// Beginning with the forward motion.
fn order(drive: &Drive, q: f64, lambda: f64) -> Result<String, ExamError> {
    let start = DriveState { phi: 0.0, w: 0.0 };
    let outcome = drive.attractor(Friction::new(lambda, q * lambda)?, start, 200)?;
    let settled = outcome
        .settled()
        .ok_or(ExamError::Missing("a motion that repeats"))?;
    let letter = |sign| match sign {
        Sign::Positive => 'F',
        Sign::Negative => 'B',
        Sign::Rest => 'R',
    };
    Ok(settled
        .intervals()
        .iter()
        .map(|part| letter(part.sign))
        .collect())
}

const PERIODS: f64 = 60.0;

fn tilted(q: f64, lambda: f64) -> Result<crate::Motion, ExamError> {
    let tilt = 0.5 * (q - 1.0) * lambda;
    let sine = Signal::Sine {
        frequency: 1.0,
        phase: 0.0,
    };
    let pull = Signal::Sum(vec![sine, Signal::constant(tilt)]);
    let start = crate::State::moving([0.0; 2]);
    let friction = 0.5 * (q + 1.0) * lambda;
    Ok(run(
        &Plane::along([-1.0, 0.0], pull),
        friction,
        start,
        PERIODS * TAU,
    )?)
}

fn order_when_tilted(q: f64, lambda: f64) -> Result<String, ExamError> {
    let motion = tilted(q, lambda)?;
    let mut letters = Vec::new();
    let late = motion
        .phases()
        .iter()
        .filter(|phase| phase.to > (PERIODS - 3.0) * TAU);
    for phase in late {
        let middle = 0.5 * (phase.from + phase.to);
        let letter = match phase.kind {
            PhaseKind::Stick => 'R',
            PhaseKind::Slide if motion.at(middle)?.v[0] > 0.0 => 'F',
            PhaseKind::Slide => 'B',
        };
        letters.push(letter);
    }
    let mut forward = letters
        .iter()
        .enumerate()
        .filter(|(_, letter)| **letter == 'F')
        .map(|(n, _)| n);
    match (forward.next(), forward.next()) {
        (Some(from), Some(to)) => Ok(letters[from..to].iter().collect()),
        _ => Err(ExamError::Missing("a second forward motion")),
    }
}
