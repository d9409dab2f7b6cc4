//! What the chapter's figures show: the same drives and motions that are tried.

use super::drives::{motion, named, phase, phase_of, rest_share, third_harmonic};
use super::prelude::*;

/// One drive of the census.
#[derive(Debug, Clone)]
pub struct Row {
    /// The drive's name.
    pub name: &'static str,
    /// The mean of |h|, above which there must be rest.
    pub mean_size: f64,
    /// What becomes of the motion in the middle of each of equally wide cells of 0 < λ₀ < 1.
    pub phases: Vec<Phase>,
}

/// The friction in the middle of a cell.
pub fn friction(cell: usize, cells: usize) -> f64 {
    (cell as f64 + 0.5) / cells as f64
}

/// All named drives, each at `cells` values of λ₀.
pub fn census(cells: usize) -> Result<Vec<Row>, DriveError> {
    let row = |one: &super::drives::Named| {
        let phases = (0..cells).map(|k| phase(&one.drive, friction(k, cells)));
        Ok(Row {
            name: one.name,
            mean_size: super::threshold::mean_size(&one.drive),
            phases: phases.collect::<Result<_, _>>()?,
        })
    };
    named()?.iter().map(row).collect()
}

/// A periodic motion over two periods.
#[derive(Debug, Clone)]
pub struct Wave {
    /// λ₀.
    pub lambda: f64,
    /// Rests per period.
    pub rests: usize,
    /// (φ, h, w) from φ = 0 to 4π.
    pub points: Vec<[f64; 3]>,
}

/// The pulses' share in the figure of their motion.
pub(crate) const ETA: f64 = 0.6;
/// Friction below and above λ_c of these pulses.
pub(crate) const BELOW_AND_ABOVE: [f64; 2] = [0.3, 0.8];
/// The third harmonic whose motions are drawn.
pub const THIRD: f64 = 1.5;
/// Friction at which its rests are absent, there, gone, and back.
pub(crate) const COME_AND_GO: [f64; 4] = [0.04, 0.08, 0.16, 0.32];

/// The motion under the pulses below and above λ_c.
pub(crate) fn pulse_waves() -> Result<Vec<Wave>, DriveError> {
    waves(&pulses(ETA)?, &BELOW_AND_ABOVE)
}

/// The motion under sin φ + 1.5 sin 3φ, scaled, at four frictions.
pub(crate) fn come_and_go() -> Result<Vec<Wave>, DriveError> {
    waves(&third_harmonic(THIRD)?, &COME_AND_GO)
}

fn waves(drive: &Drive, frictions: &[f64]) -> Result<Vec<Wave>, DriveError> {
    let mut list = Vec::new();
    for &lambda in frictions {
        // None of these drives has a mean: none drifts.
        let Some(wave) = motion(drive, lambda)? else {
            continue;
        };
        // 80 steps a period: the joints of the pulses of 0.6 are among them.
        let points = (0..=160).map(|k| {
            let phi = TAU * f64::from(k) / 80.0;
            [phi, drive.h(phi), wave.w(phi)]
        });
        list.push(Wave {
            lambda,
            rests: match phase_of(&wave) {
                Phase::Rests(rests) => rests,
                Phase::Still | Phase::Drifts => 0,
            },
            points: points.collect(),
        });
    }
    Ok(list)
}

/// The share of the period at rest over the square of η and λ₀, `side` cells each way, row by row from the
/// lowest λ₀, each row from the lowest η.
pub fn shares(side: usize) -> Result<Vec<f64>, DriveError> {
    let drives: Vec<Drive> = (0..side)
        .map(|k| pulses(friction(k, side)))
        .collect::<Result<_, _>>()?;
    let mut shares = Vec::with_capacity(side * side);
    for row in 0..side {
        for drive in &drives {
            let wave = motion(drive, friction(row, side))?;
            shares.push(wave.map_or(0.0, |wave| rest_share(&wave)));
        }
    }
    Ok(shares)
}

attempts![
    shares_motion = {
        let side = 33;
        Trial::motion(
            Printed,
            [
                r"the share of the third case of (44), 0 for $\lambda_0$ below (46),",
                "the share of the period at rest in the motion",
            ],
        )
        .over(parts(shares(side)).enumerate(), |(cell, found)| {
            let (eta, lambda) = (friction(cell % side, side), friction(cell / side, side));
            let [_, stop] = printed::eq44_ends(lambda, eta);
            let share = 1.0 - stop / std::f64::consts::PI;
            let large = lambda > printed::eq46_lambda_c(eta);
            Ok(Pair::plain(
                format!("η = {eta:.6}, λ₀ = {lambda:.6}"),
                if large { share } else { 0.0 },
                found?,
            ))
        })
    }
];
