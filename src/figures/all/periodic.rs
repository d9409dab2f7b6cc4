//! Figures of section 2.3.

use super::AllFiguresError;
use crate::claims::periodic::{drawn, drives::Phase};
use crate::figures::periodic as periodic_figures;
use trialbook::figures::Figure;

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    Ok(vec![
        drive_census()?,
        pulse_waves()?,
        rest_shares()?,
        come_and_go()?,
    ])
}

/// Rests per period of the named drives.
fn drive_census() -> Result<Figure, AllFiguresError> {
    let rows: Vec<_> = drawn::census(400)?
        .into_iter()
        .map(|row| periodic_figures::CensusRow {
            name: row.name.into(),
            mean_size: row.mean_size,
            fates: row.phases.into_iter().map(fate).collect(),
        })
        .collect();
    Ok(periodic_figures::census(&rows)?)
}

fn fate(phase: Phase) -> periodic_figures::Fate {
    match phase {
        Phase::Drifts => periodic_figures::Fate::Drifts,
        Phase::Rests(rests) => periodic_figures::Fate::Rests(rests),
        // At rest for ever is one rest.
        Phase::Still => periodic_figures::Fate::Rests(1),
    }
}

fn waves(list: Vec<drawn::Wave>) -> Vec<periodic_figures::Wave> {
    let wave = |wave: drawn::Wave| periodic_figures::Wave {
        lambda: wave.lambda,
        rests: wave.rests,
        points: wave.points,
    };
    list.into_iter().map(wave).collect()
}

/// The pulses' motion below and above λ_c.
fn pulse_waves() -> Result<Figure, AllFiguresError> {
    let list = waves(drawn::pulse_waves()?);
    Ok(periodic_figures::pulse_waves(drawn::ETA, &list)?)
}

/// How long the pulses let rest.
fn rest_shares() -> Result<Figure, AllFiguresError> {
    let side = 140;
    Ok(periodic_figures::rest_shares(side, &drawn::shares(side)?)?)
}

/// Rests that come and go with growing friction.
fn come_and_go() -> Result<Figure, AllFiguresError> {
    Ok(periodic_figures::come_and_go(
        &waves(drawn::come_and_go()?),
    )?)
}
