//! The turntable's boundary between rest and escape.

use super::{Answer, Curve, Field, Fields, SolveError, check};
use crate::corrections::rest as corrected;
use crate::motion::turntable::boundary::between;
use crate::motion::turntable::{Fate, Start, fate};

/// A point of the boundary between rest and escape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Problem {
    /// α, in [0, 20].
    pub alpha: f64,
    /// ψ, radians.
    pub psi: f64,
}

/// A on the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boundary {
    /// A.
    pub a: f64,
}

impl Fields for Boundary {
    fn fields(&self) -> Vec<Field> {
        vec![Field::new("A", self.a)]
    }
}

/// Below this α the second-order formula is the better one: it leaves out at most 5.2 α³.
const NEAR: f64 = 1e-5;
/// Beyond this α it means nothing.
const FAR: f64 = 1.0;

impl Problem {
    /// A on the boundary, by bisection on the motion and by the expansion to second order in α.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for α or ψ out of range.
    pub fn solve(&self) -> Result<Answer<Boundary>, SolveError> {
        let Problem { alpha, psi } = *self;
        check(
            "alpha",
            alpha,
            (0.0..=20.0).contains(&alpha),
            "between 0 and 20",
        )?;
        check("psi", psi, psi.abs() <= 1e3, "between -1e3 and 1e3")?;
        let formula = Boundary {
            a: corrected::boundary_a(alpha, psi),
        };
        if alpha < NEAR {
            let note = "by the expansion that replaces (147); what it leaves out is of order α³";
            return Ok(Answer {
                best: formula,
                by_formula: Some(formula),
                by_motion: None,
                disagreement: None,
                digits: Some(14),
                note: note.to_owned(),
            });
        }
        let least = (1.0 - 1e-9) * libm::exp(-alpha);
        let start = |a| Start::hyperbolic(a, alpha, psi);
        let motion = Boundary {
            a: between(start, least, 1.0 + 1e-9, 1e-15 * least)?,
        };
        let compared = if alpha <= FAR {
            let note = "by bisection on the motion; the formula is the expansion to second order in α that replaces (147)";
            Answer::by_both(formula, motion, note)?
        } else {
            let note = "by bisection on the motion; the formula that replaces (147) is for small α";
            Answer {
                disagreement: None,
                ..Answer::by_motions(motion, &motion, note)?
            }
        };
        Ok(Answer {
            best: motion,
            digits: Some(self.digits(motion.a)?),
            ..compared
        })
    }

    /// To how many digits the motion tells one side from the other: closer by, it hovers at the brink of rest for
    /// longer than it can be followed.
    fn digits(&self, a: f64) -> Result<u32, SolveError> {
        let rests = |a: f64| -> Result<Option<bool>, SolveError> {
            Ok(match fate(&Start::hyperbolic(a, self.alpha, self.psi)?)? {
                Fate::Rest { .. } => Some(true),
                Fate::Escape { .. } => Some(false),
                Fate::Undecided { .. } => None,
            })
        };
        for digits in (1..=MOST_DIGITS).rev() {
            let width = libm::exp10(-f64::from(digits));
            if rests(a * (1.0 - width))? == Some(true) && rests(a * (1.0 + width))? == Some(false) {
                return Ok(digits);
            }
        }
        Ok(0)
    }

    /// A against α at the same ψ, by the motion.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let most = self.alpha.max(1.0);
        let point = |i: u32| -> Result<[f64; 2], SolveError> {
            let alpha = most * f64::from(i) / 40.0;
            let start = |a| Start::hyperbolic(a, alpha, self.psi);
            let least = (1.0 - 1e-9) * libm::exp(-alpha);
            let a = match i {
                0 => 1.0,
                _ => between(start, least, 1.0 + 1e-9, 1e-4 * least)?,
            };
            Ok([alpha, a])
        };
        let points: Result<Vec<_>, _> = (0..=40).map(point).collect();
        Ok(Curve {
            title: "The boundary between rest and escape",
            x: "α",
            y: "A",
            equal: false,
            points: points?,
        })
    }
}

/// To so many digits a separate integration, in extended precision, has the same boundary.
const MOST_DIGITS: u32 = 12;
