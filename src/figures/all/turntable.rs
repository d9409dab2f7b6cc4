//! Figures of section 4, the equations.

use super::AllFiguresError;
use crate::claims::turntable::{drawn, fixed};
use crate::figures::turntable;
use crate::motion::MotionError;
use trialbook::figures::Figure;

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    let [rests, escapes] = drawn::SPEEDS.map(launch);
    let (rests, escapes) = (rests?, escapes?);
    Ok(vec![
        turntable::energy(&rests)?,
        turntable::paths(&[rests, escapes])?,
        following()?,
    ])
}

/// A launch from the axis of the turntable.
fn launch(speed: f64) -> Result<turntable::Launch, MotionError> {
    let launched = drawn::launched(speed)?;
    let point = |m: &drawn::Moment| {
        let ([x, y], [bx, by]) = (m.table, m.laboratory);
        [m.tau, x, y, bx, by, m.p, m.rho, m.s]
    };
    Ok(turntable::Launch {
        speed,
        points: launched.moments.iter().map(point).collect(),
        rest: launched.rest,
    })
}

/// ψ against ψ₁ in escapes.
fn following() -> Result<Figure, AllFiguresError> {
    let escape = |start: [f64; 3]| -> Result<_, MotionError> {
        let all = fixed::following(start)?;
        let point = |m: &fixed::Following| [m.tau, m.psi, m.psi1, m.ratio];
        Ok(turntable::Following {
            a: start[0],
            points: all.iter().map(point).collect(),
        })
    };
    let escapes: Result<Vec<_>, _> = fixed::ESCAPES.into_iter().map(escape).collect();
    Ok(turntable::following(&escapes?)?)
}
