//! A train of pulses: the large-time motion.
//!
#![doc = include_str!("axes/drive.md")]

use super::{
    Answer, Curve, PHASES, Quantity, ROUNDED, Said, SolveError, check,
    sinusoidal::{AT_REST, Swing, below, friction, settle, swings, two_periods},
};
use crate::corrections::periodic as corrected;
use crate::motion::drive::{Drive, Friction};
use crate::numerics::{double::Double, number::Real};
use crate::paper::periodic as printed;
use crate::scalar::Scalar;
use std::f64::consts::PI;

/// Pulses of both signs, one in each half period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeriodicProblem<T = f64> {
    /// η, the share of a half period that a pulse fills, in [0, 1].
    pub eta: T,
    /// λ₀ = μg/A₀, dimensionless: from 10⁻⁶ to 10⁶.
    pub lambda0: T,
}

impl<T: Quantity> PeriodicProblem<T> {
    /// The large-time motion.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for η or λ₀ out of range.
    pub fn solve(&self) -> Result<Answer<Swing>, SolveError> {
        let near = self.near()?;
        let motions = swings(near.h(), &near.jumps(), near.lambda0)?;
        let (_, note) = by_formula(self.eta.into(), self.lambda0.into());
        let said = Said::by(|nudge| {
            let (swing, _) = match nudge {
                None => by_formula(self.eta.into(), self.lambda0.into()),
                Some(by) => by_formula(near.eta.into(), (by * near.lambda0).into()),
            };
            Ok::<_, SolveError>(swing)
        })?;
        // A pulse that is shorter than the rounding of phases is none for the motion.
        let seen = near.eta == 0.0 || near.eta > PHASES;
        Answer::by_either(said, seen.then_some(motions), PHASES, note)
    }

    /// 𝔴 against φ over two periods.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let near = self.near()?;
        let drive = Drive::new(near.h(), &near.jumps())?;
        let friction = Friction::new(near.lambda0, near.lambda0)?;
        Ok(two_periods(&settle(&drive, friction)?))
    }

    /// The same in `f64`, if it is in range.
    fn near(&self) -> Result<PeriodicProblem, SolveError> {
        let (eta, lambda0) = (self.eta.into(), self.lambda0.into());
        check("eta", eta, (0.0..=1.0).contains(&eta), "between 0 and 1")?;
        friction("lambda0", lambda0)?;
        Ok(PeriodicProblem { eta, lambda0 })
    }
}

impl PeriodicProblem {
    fn h(&self) -> impl Fn(f64) -> f64 {
        let eta = self.eta;
        move |phi: f64| match phi {
            phi if phi < PI => printed::eq42_h(eta, phi),
            phi => printed::eq43_h(printed::eq42_h(eta, phi - PI)),
        }
    }

    fn jumps(&self) -> [f64; 3] {
        [self.eta * PI, PI, PI + self.eta * PI]
    }
}

fn by_formula(eta: Double, lambda0: Double) -> (Swing, &'static str) {
    let zero = Double::from(0.0);
    if lambda0 >= 1.0.into() || eta == zero {
        return (AT_REST, "at rest: friction is never overcome");
    }
    let apart = lambda0 - printed::eq46_lambda_c(eta);
    let critical = apart > zero && apart <= Double::from(ROUNDED) * eta;
    if apart > zero && !critical {
        let [top, end] = printed::eq44_ends(lambda0, eta);
        let [w_max, ..] = printed::eq44_cases(lambda0, eta, top);
        let swing = Swing {
            regime: "two-rests",
            positive_start: Some(0.0),
            positive_end: Some(end.to_f64()),
            rest_fraction: ((lambda0 - eta) / lambda0).to_f64(),
            w_max: w_max.to_f64(),
        };
        return (swing, "by (44)");
    }
    let start = corrected::small_friction_start(lambda0, eta);
    let [top, _] = corrected::small_friction_ends(eta);
    let [w_max, ..] = corrected::small_friction_cases(lambda0, eta, top);
    let swing = Swing {
        regime: below(critical),
        positive_start: Some(start.to_f64()),
        positive_end: Some((start + Double::pi()).to_f64()),
        rest_fraction: 0.0,
        w_max: w_max.to_f64(),
    };
    (
        swing,
        "by the solution below λ_c = η, which the paper leaves out: forward motion begins at π(η − λ₀)/2",
    )
}
