//! pySLAMMER's harmonic cases: a block that a sine of 1 g shakes, and that slides one way only.

use super::{OURS, Source};
use crate::exam::ExamError;
use crate::motion::drive::{Drive, DriveState, Friction, Sign};
use std::f64::consts::TAU;

/// What `benches/exam/run_pyslammer.py` wrote.
const FILE: &str = include_str!("../../../benches/exam/results/pyslammer.csv");

/// Where they come from.
pub(crate) static PYSLAMMER: Source = Source {
    title: "pySLAMMER, its module analytical_sliding_block and its class RigidAnalysis",
    read: "both files of version 0.2.2, and their 66 closed forms of 2025 in temp/_demos/harmonic_solutions.csv, at commit 1cbbcf02; both were run",
};

/// Standard gravity in the closed forms: the default of their function.
const CLOSED: f64 = 9.81;
/// The one that is built into the time histories.
const HISTORY: f64 = 9.806_65;
const STEP: f64 = 0.001;
/// Below this velocity a history takes the block for resting.
const RESTS: f64 = 1e-5;

/// The cases of one yield acceleration, beside our motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Yield {
    /// The yield acceleration, in g.
    pub at: f64,
    /// The slip in a cycle, in g/ω².
    pub slip: f64,
    /// How long the block slides, as a phase.
    pub lasts: f64,
    /// One for each frequency.
    pub cases: Vec<Shaken>,
}

/// The numbers of pySLAMMER for a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaken {
    /// The frequency, in Hz.
    pub frequency: f64,
    /// The slip by its closed form, in m.
    pub closed: f64,
    /// The slip by its time history, in m.
    pub history: f64,
}

/// A number of pySLAMMER beside ours, in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beside {
    /// The distance.
    pub apart: f64,
    /// What it may be.
    pub allowed: f64,
    /// Our number.
    pub ours: f64,
}

impl Beside {
    /// Whether the distance is allowed.
    pub fn agrees(&self) -> bool {
        self.apart <= self.allowed
    }
}

impl Yield {
    /// A closed form beside ours: it is to be right but for rounding, which is that of terms of the size g/ω².
    pub fn closed(&self, case: &Shaken) -> Beside {
        let scale = case.scale(CLOSED);
        let ours = self.slip * scale;
        Beside {
            apart: (case.closed - ours).abs(),
            allowed: OURS * ours + 64.0 * f64::EPSILON * scale,
            ours,
        }
    }

    /// A time history beside ours. With ε = ωh and a slip that lasts L, the trapezoidal rule errs by at most, in g/ω²: ε²L/12
    /// in the velocity, for |h″| ≤ 1, and ε²/8 for the kink at the start, both over L; ε²L/12 more in the way; and the last
    /// cell is lost, ε²s/2 with a deceleration s < 2. To that comes what a velocity below `RESTS` adds in a cycle.
    pub fn history(&self, case: &Shaken) -> Beside {
        let (scale, step) = (case.scale(HISTORY), TAU * case.frequency * STEP);
        let rule = self.lasts * (self.lasts / 12.0 + 1.0 / 8.0 + 1.0 / 12.0) + 1.0;
        let ours = self.slip * scale;
        Beside {
            apart: (case.history - ours).abs(),
            allowed: rule * step * step * scale + RESTS / case.frequency,
            ours,
        }
    }
}

impl Shaken {
    /// g/ω².
    fn scale(&self, g: f64) -> f64 {
        let omega = TAU * self.frequency;
        g / (omega * omega)
    }
}

/// All cases, by their yield acceleration.
pub(crate) fn yields() -> Result<Vec<Yield>, ExamError> {
    let drive = Drive::new(libm::sin, &[])?;
    let mut yields: Vec<Yield> = Vec::new();
    let lines = FILE.lines().filter(|line| !line.starts_with('#'));
    for line in lines.skip(1) {
        let (at, case) = read(line).ok_or(ExamError::Missing("a case in pyslammer.csv"))?;
        match yields.iter_mut().find(|known| known.at == at) {
            Some(known) => known.cases.push(case),
            None => yields.push(slide(&drive, at, case)?),
        }
    }
    Ok(yields)
}

fn read(line: &str) -> Option<(f64, Shaken)> {
    let mut numbers = line.split(',').map(|cell| cell.parse().ok());
    let mut next = || numbers.next().flatten();
    let (frequency, at) = (next()?, next()?);
    let (closed, history) = (next()?, next()?);
    Some((
        at,
        Shaken {
            frequency,
            closed,
            history,
        },
    ))
}

/// Where no drive is strong enough to move the block back.
fn slide(drive: &Drive, at: f64, case: Shaken) -> Result<Yield, ExamError> {
    let start = DriveState { phi: 0.0, w: 0.0 };
    let outcome = drive.attractor(Friction::new(at, 2.0)?, start, 100)?;
    let settled = outcome
        .settled()
        .ok_or(ExamError::Missing("a motion that repeats"))?;
    let slides = settled
        .intervals()
        .iter()
        .filter(|part| part.sign != Sign::Rest);
    Ok(Yield {
        at,
        slip: settled.displacement(),
        lasts: slides.map(|part| part.length()).sum(),
        cases: vec![case],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_closed_forms_and_histories_agree() {
        let yields = yields().unwrap();
        assert!(!yields.is_empty());
        for known in &yields {
            assert!(!known.cases.is_empty(), "{}", known.at);
            for case in &known.cases {
                for beside in [known.closed(case), known.history(case)] {
                    assert!(beside.agrees(), "{} {case:?} {beside:?}", known.at);
                }
            }
        }
    }

    #[test]
    fn at_a_yield_of_the_whole_drive_nothing_slides() {
        let yields = yields().unwrap();
        let last = yields.iter().find(|known| known.at == 1.0).unwrap();
        assert_eq!((last.slip, last.lasts), (0.0, 0.0));
        assert!(last.cases.iter().all(|case| case.history == 0.0));
    }

    /// A part in 10⁹ is too much for a closed form, and so is for a history what one of g = 9.81 would have.
    #[test]
    fn what_is_wrong_is_found() {
        let yields = yields().unwrap();
        for known in yields.iter().filter(|known| known.slip > 0.0) {
            for case in &known.cases {
                let closed = case.closed * (1.0 + 1e-9);
                assert!(!known.closed(&Shaken { closed, ..*case }).agrees());
            }
        }
        let slow = yields[0].cases[0];
        let history = slow.history * CLOSED / HISTORY;
        assert!(!yields[0].history(&Shaken { history, ..slow }).agrees());
    }
}
