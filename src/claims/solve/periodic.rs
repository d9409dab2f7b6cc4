//! A train of pulses: the large-time motion.

use super::sinusoidal::{AT_REST, Swing, friction, settle, swing, two_periods};
use super::{Answer, Curve, SolveError, check};
use crate::corrections::periodic as corrected;
use crate::motion::drive::{Drive, DriveError, Friction};
use crate::paper::periodic as printed;
use std::f64::consts::PI;

/// Pulses of both signs, one in each half period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Problem {
    /// η, the share of a half period that a pulse fills, in [0, 1].
    pub eta: f64,
    /// λ₀ = μg/A₀, dimensionless: from 10⁻⁶ to 10⁶.
    pub lambda0: f64,
}

impl Problem {
    /// The large-time motion.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for η or λ₀ out of range.
    pub fn solve(&self) -> Result<Answer<Swing>, SolveError> {
        let friction = self.friction()?;
        let motion = swing(&settle(&self.drive()?, friction)?);
        let (formula, note) = self.by_formula();
        Answer::by_both(formula, motion, note)
    }

    /// 𝔴 against φ over two periods.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let friction = self.friction()?;
        Ok(two_periods(&settle(&self.drive()?, friction)?))
    }

    fn friction(&self) -> Result<Friction, SolveError> {
        check(
            "eta",
            self.eta,
            (0.0..=1.0).contains(&self.eta),
            "between 0 and 1",
        )?;
        friction("lambda0", self.lambda0)?;
        Ok(Friction::new(self.lambda0, self.lambda0)?)
    }

    fn drive(&self) -> Result<Drive, DriveError> {
        let eta = self.eta;
        let h = move |phi: f64| match phi {
            phi if phi < PI => printed::eq42_h(eta, phi),
            phi => printed::eq43_h(printed::eq42_h(eta, phi - PI)),
        };
        Drive::new(h, &[eta * PI, PI, PI + eta * PI])
    }

    fn by_formula(&self) -> (Swing, &'static str) {
        let Problem { eta, lambda0 } = *self;
        if lambda0 >= 1.0 || eta == 0.0 {
            return (AT_REST, "at rest: friction is never overcome");
        }
        if lambda0 > printed::eq46_lambda_c(eta) {
            let [top, end] = printed::eq44_ends(lambda0, eta);
            let swing = Swing {
                regime: "two-rests",
                positive_start: Some(0.0),
                positive_end: Some(end),
                rest_fraction: (lambda0 - eta) / lambda0,
                w_max: printed::eq44_cases(lambda0, eta, top)[0],
            };
            return (swing, "by (44)");
        }
        let start = corrected::small_friction_start(lambda0, eta);
        let [top, _] = corrected::small_friction_ends(eta);
        let swing = Swing {
            regime: "two-zeros",
            positive_start: Some(start),
            positive_end: Some(start + PI),
            rest_fraction: 0.0,
            w_max: corrected::small_friction_cases(lambda0, eta, top)[0],
        };
        (
            swing,
            "by the solution below λ_c = η, which the paper leaves out: forward motion begins at π(η − λ₀)/2",
        )
    }
}
