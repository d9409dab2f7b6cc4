//! A coin on a turntable: small, so that it is a particle.

use super::posed::{Ask, Posed, Scan};
use super::{Answer, ExamError, Other, Task};
use crate::turntable::{
    Fate, Start, State, Table, boundary::between, critical_radius, critical_speed, fate, inertial,
    intrinsic::Run,
};
use crate::validated::turntable::{Fate as Proved, fate_launched, fate_put_down};
use trialbook::certified::{error::CertifiedError, interval::Interval};

macro_rules! table {
    ($start:literal) => {
        concat!(
            "A coin, small enough for a particle, on a table that turns at the steady rate Ω. ",
            $start,
            " Units: Ω = μg = 1."
        )
    };
}

/// Where a border is, in this unit: whether it rests in the last second of fifty.
const fn bordered(scene: &'static str, unit: &'static str) -> Posed {
    Posed {
        window: Some(1.0),
        scan: Some(Scan {
            from: 0.5,
            to: 1.5,
            level: 0.0,
            within: 1e-7,
            unit,
        }),
        ..Posed::of(scene, Ask::Rest)
    }
}

const WIDTH: f64 = 1e-13;

/// Half the width of what is not proved to rest or to escape by the book's proof (`book/src/rest.md`).
const BAND: f64 = 3e-7;

pub(super) const CRITICAL_RADIUS: Task = Task {
    id: "critical-radius",
    setup: table!("It is put down at rest in the laboratory, at a distance from the axis."),
    posed: bordered("block mu=1 g=1 turn=1 at={} set-down until=time=50", "m"),
    question: "What is the largest distance from which it comes to rest on the table?",
    unit: "μg/Ω²",
    motion: || Ok(Answer::Number(between(Start::put_down, 0.5, 1.5, WIDTH)?)),
    other: Other::Within(|| border(critical_radius(), fate_put_down)),
};

pub(super) const CRITICAL_SPEED: Task = Task {
    id: "critical-speed",
    setup: table!("It is launched from the axis."),
    posed: bordered("block mu=1 g=1 turn=1 throw={} until=time=50", "m/s"),
    question: "What is the largest speed with which it comes to rest on the table?",
    unit: "μg/Ω",
    motion: || Ok(Answer::Number(between(Start::launched, 0.5, 1.5, WIDTH)?)),
    other: Other::Within(|| border(critical_speed(), fate_launched)),
};

/// From its lower end a coin is proved to rest, from its upper end to escape.
fn border<E>(
    near: Result<f64, E>,
    fate: fn(Interval, f64) -> Result<Proved, CertifiedError>,
) -> Result<Interval, CertifiedError> {
    let near = near.map_err(|_| CertifiedError::unproved("no border is found", &[]))?;
    let (low, high) = (near - BAND, near + BAND);
    let fates = [low, high].map(|start| fate(Interval::point(start), 1.0));
    match fates {
        [Ok(Proved::Rest { .. }), Ok(Proved::Escape { .. })] => Ok(Interval::new(low, high)),
        [Err(error), _] | [_, Err(error)] => Err(error),
        _ => Err(CertifiedError::unproved(
            "the border is not there",
            &[Interval::new(low, high)],
        )),
    }
}

pub(super) const PLACE_OF_REST: Task = Task {
    id: "place-of-rest",
    setup: table!("It is put down at rest in the laboratory at the distance 1/2 from the axis."),
    posed: Posed::of(
        "block mu=1 g=1 turn=1 at=0.5 set-down until=rest",
        Ask::Distance,
    ),
    question: "At which distance from the axis does it come to rest?",
    unit: "μg/Ω²",
    motion: || match fate(&Start::put_down(0.5)?)? {
        Fate::Rest { sigma, .. } => Ok(Answer::Number(sigma)),
        _ => Err(ExamError::Missing("rest")),
    },
    other: Other::Within(|| match fate_put_down(Interval::point(0.5), 1e-13)? {
        Proved::Rest { sigma, .. } => Ok(sigma),
        Proved::Escape { .. } => Err(CertifiedError::unproved("it escapes", &[])),
    }),
};

const LATE: f64 = 20.0;

/// In components along and across the velocity, and in axes at rest in the laboratory.
pub(super) const ESCAPE: Task = Task {
    id: "escape",
    setup: table!("It is put down at rest in the laboratory at the distance 3/2 from the axis."),
    posed: Posed::of(
        "block mu=1 g=1 turn=1 at=1.5 set-down until=time=20",
        Ask::Distance,
    ),
    question: "At which distance from the axis is it at t = 20? (In the end the distance grows as t²/(3√2).)",
    unit: "μg/Ω²",
    motion: || {
        Ok(Answer::Number(
            Run::new(&Start::put_down(1.5)?, LATE)?.end().rho(),
        ))
    },
    other: Other::Integrated(|| {
        let start = State {
            t: 0.0,
            x: [1.5, 0.0],
            v: [0.0; 2],
        };
        let path = inertial::run(&Table::default(), &start, LATE)?;
        Ok(Answer::Number(path.on_table(LATE)?.radius()))
    }),
};
