//! A block on a tray that is shaken to and fro.

use super::posed::{Ask, Posed, Scan, repeated};
use super::{Answer, DIMENSIONLESS, ExamError, Other, Task, fraction, valued};
use crate::drive::{Attractor, Drive, DriveError, DriveState, Friction, PlanarState, Sign};
use crate::validated::{drive, numbers};
use crate::{Plane, Signal, run};
use std::f64::consts::TAU;
use trialbook::certified::{ball::Ball, enclosure::Enclosure, error::CertifiedError};

macro_rules! shaken {
    ($lambda:literal) => {
        concat!(
            "A block lies on a horizontal tray that is shaken along x; in its frame the block feels the pull A sin t. Friction is \
             λ₀ = μg/A = ",
            $lambda,
            ". Units: A = 1, period 2π. Wait until the motion repeats (from rest, it does so within a few periods)."
        )
    };
}

pub(super) const REST_FRACTION: Task = Task {
    id: "rest-fraction",
    setup: shaken!("4/5"),
    posed: repeated!("g=1 mu=0.8", Ask::Rest),
    question: "For which part of the time is the block at rest on the tray?",
    unit: DIMENSIONLESS,
    motion: || rest_fraction(0.8),
    other: Other::Digits(Enclosure(|bits| certified_fraction(4, 5, 2.887, bits))),
};

pub(super) const REST_FRACTION_LOW: Task = Task {
    id: "rest-fraction-low",
    setup: shaken!("3/5"),
    posed: repeated!("g=1 mu=0.6", Ask::Rest),
    question: "For which part of the time is the block at rest on the tray?",
    unit: DIMENSIONLESS,
    motion: || rest_fraction(0.6),
    other: Other::Digits(Enclosure(|bits| certified_fraction(3, 5, 3.523, bits))),
};

/// An arc lasts half a period: 2 cos φ₁ = πλ₀.
pub(super) const NEVER_RESTS: Task = Task {
    id: "never-rests",
    setup: shaken!("2/5"),
    posed: repeated!("g=1 mu=0.4", Ask::Turn),
    question: "At which t, counted from the beginning of a period of the pull, does its velocity change from backward to forward?",
    unit: "1/ω",
    motion: || {
        let drive = sine()?;
        let settled = settled(&drive, 0.4)?;
        Ok(Answer::Number(settled.intervals()[0].start))
    },
    other: Other::Digits(Enclosure(|bits| {
        let cosine = valued(Ball::pi(bits + 16).over(&Ball::int(5, bits + 16)))?;
        let sine = valued((Ball::int(1, bits + 16) - &cosine * &cosine).sqrt())?;
        Ok(valued(sine.asin())?.with_bits(bits))
    })),
};

pub(super) const THRESHOLD: Task = Task {
    id: "threshold",
    setup: "A block lies on a horizontal tray that is shaken along x; in its frame the block feels the pull A sin t.",
    posed: Posed {
        scan: Some(Scan {
            from: 0.4,
            to: 0.8,
            level: 0.0,
            within: 1e-11,
            unit: "1",
        }),
        ..repeated!("g=1 mu={}", Ask::Rest)
    },
    question: "Above which friction λ₀ = μg/A does the block rest for a part of each period?",
    unit: DIMENSIONLESS,
    motion: || {
        let drive = sine()?;
        let (mut low, mut high) = (0.4, 0.8);
        while high - low > 1e-13 {
            let middle = 0.5 * (low + high);
            match rests(&settled(&drive, middle)?) {
                true => high = middle,
                false => low = middle,
            }
        }
        Ok(Answer::Number(0.5 * (low + high)))
    },
    other: Other::Digits(numbers::LAMBDA_C),
};

pub(super) const MIRROR: Task = Task {
    id: "mirror",
    setup: "A block slides on a tray that is shaken along x; in its frame it feels the pull A sin t. Friction is λ₀ = μg/A = 3/10; \
            it starts at t = 0 with the velocity 2 forward. Units: A = 1, period 2π.",
    posed: repeated!("g=1 mu=0.3 throw=2", Ask::X),
    question: "How far does it move from period to period in the end? (Forward and backward are alike: nowhere.)",
    unit: "A/ω²",
    motion: || {
        let drive = sine()?;
        let start = DriveState { phi: 0.0, w: 2.0 };
        let outcome = drive.attractor(Friction::new(0.3, 0.3)?, start, 200)?;
        let settled = outcome
            .settled()
            .ok_or(ExamError::Missing("a motion that repeats"))?;
        Ok(Answer::Number(settled.displacement().abs()))
    },
    other: fraction!(0 / 1),
};

/// Of the arc w = cos φ₁ − cos φ − λ₀(φ − φ₁), 2λ₀∫w dφ.
pub(super) const HEAT: Task = Task {
    id: "heat",
    setup: shaken!("4/5"),
    posed: repeated!("g=1 mu=0.8", Ask::Heat),
    question: "How much energy does friction take from a unit of mass in a period?",
    unit: "A²/ω²",
    motion: || {
        let drive = sine()?;
        Ok(Answer::Number(settled(&drive, 0.8)?.lost()))
    },
    other: Other::Digits(Enclosure(|bits| {
        let [lambda, from, to] = slip(4, 5, 2.887, bits + 16)?;
        let ([s1, c1], [s2, _]) = (from.sin_cos(), to.sin_cos());
        let length = &to - &from;
        let half = valued((&lambda * &length * &length).over(&Ball::int(2, bits + 16)))?;
        let way = &c1 * &length - (s2 - s1) - half;
        Ok((&lambda * &way + &lambda * &way).with_bits(bits))
    })),
};

pub(super) const SIDEWAYS: Task = Task {
    id: "sideways",
    setup: "A block slides on a tray that is shaken along x; in its frame it feels the pull A sin t. Friction is λ₀ = μg/A = 3/10; \
            it starts at t = 0 with the velocity 1 along y. Units: A = 1, period 2π.",
    posed: Posed::of(
        "block mu=0.3 g=1 pull=sin(t) throw=1@1.5707963267948966 until=time=12.566370614359172",
        Ask::LnVY,
    ),
    question: "What is the natural logarithm of its velocity along y after two periods?",
    unit: DIMENSIONLESS,
    motion: || {
        let start = crate::State::moving([0.0, 1.0]);
        let end = run(&shaking(), 0.3, start, 2.0 * TAU)?.end();
        Ok(Answer::Number(libm::log(end.v[1])))
    },
    other: Other::Integrated(|| {
        let start = PlanarState {
            phi: 0.0,
            w_x: 0.0,
            ln_w_y: 0.0,
        };
        let states = sine()?.planar(0.3, start, &[2.0 * TAU])?;
        Ok(Answer::Number(states[0].ln_w_y))
    }),
};

fn shaking() -> Plane {
    let sine = Signal::Sine {
        frequency: 1.0,
        phase: 0.0,
    };
    Plane::along([-1.0, 0.0], sine)
}

pub(super) fn sine() -> Result<Drive, DriveError> {
    Drive::new(libm::sin, &[])
}

fn settled(drive: &Drive, lambda: f64) -> Result<Attractor<'_>, ExamError> {
    let start = DriveState { phi: 0.0, w: 0.0 };
    let outcome = drive.attractor(Friction::new(lambda, lambda)?, start, 200)?;
    outcome
        .settled()
        .ok_or(ExamError::Missing("a motion that repeats"))
}

fn rests(settled: &Attractor<'_>) -> bool {
    settled
        .intervals()
        .iter()
        .any(|part| part.sign == Sign::Rest)
}

fn rest_fraction(lambda: f64) -> Result<Answer, ExamError> {
    let drive = sine()?;
    let settled = settled(&drive, lambda)?;
    let rests = settled
        .intervals()
        .iter()
        .filter(|part| part.sign == Sign::Rest);
    let total: f64 = rests.map(|part| part.length()).sum();
    Ok(Answer::Number(total / TAU))
}

/// λ₀ = n/m, begin and end of the forward slip; the end is near `near`.
fn slip(n: i64, m: i64, near: f64, bits: usize) -> Result<[Ball; 3], CertifiedError> {
    let lambda = super::ratio(n, m, bits + 16)?;
    let from = valued(lambda.asin())?;
    let to = drive::slip_end(&lambda, &from, near, bits)?;
    Ok([lambda, from, to])
}

/// Forward and backward slips are alike.
fn certified_fraction(n: i64, m: i64, near: f64, bits: usize) -> Result<Ball, CertifiedError> {
    let [_, from, to] = slip(n, m, near, bits + 16)?;
    let part = valued((to - from).over(&Ball::pi(bits + 16)))?;
    Ok((Ball::int(1, bits + 16) - part).with_bits(bits))
}
