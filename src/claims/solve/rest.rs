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
        if alpha < NEAR {
            let formula = Boundary {
                a: corrected::boundary_a(alpha, psi),
            };
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
        let motion = Boundary {
            a: self.bisect(1e-15)?,
        };
        self.compared(motion, self.digits(motion.a)?)
    }

    /// A by bisection on the motion, to this width in units of the least that it can be.
    fn bisect(&self, width: f64) -> Result<f64, SolveError> {
        let Problem { alpha, psi } = *self;
        let least = (1.0 - 1e-9) * libm::exp(-alpha);
        let start = |a| Start::hyperbolic(a, alpha, psi);
        Ok(between(start, least, 1.0 + 1e-9, width * least)?)
    }

    /// What the motion found, to so many digits, beside the formula where that means something.
    fn compared(&self, motion: Boundary, digits: u32) -> Result<Answer<Boundary>, SolveError> {
        let compared = if self.alpha <= FAR {
            let formula = Boundary {
                a: corrected::boundary_a(self.alpha, self.psi),
            };
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
            digits: Some(digits),
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
        told_apart(a, rests)
    }

    /// A against α at the same ψ, by the motion.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let points: Result<Vec<_>, _> = (0..=40).map(|i| self.point(i)).collect();
        Ok(Curve {
            title: "The boundary between rest and escape",
            x: "α",
            y: "A",
            equal: false,
            points: points?,
        })
    }

    /// Point `i` of the 41 of the curve, which reaches at least to α = 1.
    fn point(&self, i: u32) -> Result<[f64; 2], SolveError> {
        let most = self.alpha.max(1.0);
        let alpha = most * f64::from(i) / 40.0;
        let a = match i {
            0 => 1.0,
            _ => Problem { alpha, ..*self }.bisect(1e-4)?,
        };
        Ok([alpha, a])
    }
}

/// To how many digits it is known that the particle rests below `a` and escapes above it.
fn told_apart(
    a: f64,
    rests: impl Fn(f64) -> Result<Option<bool>, SolveError>,
) -> Result<u32, SolveError> {
    for digits in (1..=MOST_DIGITS).rev() {
        let width = libm::exp10(-f64::from(digits));
        if rests(a * (1.0 - width))? == Some(true) && rests(a * (1.0 + width))? == Some(false) {
            return Ok(digits);
        }
    }
    Ok(0)
}

/// To so many digits a separate integration, in extended precision, has the same boundary.
const MOST_DIGITS: u32 = 12;

#[cfg(test)]
mod tests {
    use super::*;

    const PROBLEM: Problem = Problem {
        alpha: 0.1,
        psi: 1.0,
    };
    /// Its boundary, from an extrapolating integrator in extended precision.
    const A: f64 = 0.931534356734;

    #[test]
    fn a_wrong_boundary_has_no_more_digits_than_are_right() {
        // Boundaries at 1 and 2; nothing is known nearer than 3e-7.
        let rests = |b: f64| {
            move |a: f64| -> Result<Option<bool>, SolveError> {
                Ok(((a - b).abs() >= 3e-7).then_some(a < b))
            }
        };
        for b in [1.0, 2.0] {
            for (error, digits) in [
                (0.0, 6),
                (3e-6, 5),
                (-3e-6, 5),
                (2e-4, 3),
                (0.05, 1),
                (-0.05, 1),
                (0.5, 0),
                (-0.5, 0),
            ] {
                let found = told_apart(b * (1.0 + error), rests(b)).unwrap();
                assert_eq!(found, digits, "{b} {error}");
            }
        }
        assert_eq!(told_apart(1.0, |a| Ok(Some(a < 1.0))).unwrap(), MOST_DIGITS);
    }

    #[test]
    fn the_motion_tells_the_sides_of_the_boundary_apart() {
        assert_eq!(PROBLEM.digits(A).unwrap(), 12);
    }

    #[test]
    fn near_the_corner_the_formula_stands_alone_and_far_from_it_the_motion() {
        let near = Problem {
            alpha: 0.9e-5,
            psi: 0.5,
        };
        let near = near.solve().unwrap();
        assert_eq!(near.by_formula, Some(near.best));
        let rest = (near.by_motion, near.disagreement, near.digits);
        assert_eq!(rest, (None, None, Some(14)));

        let motion = Boundary { a: A };
        let both = PROBLEM.compared(motion, 12).unwrap();
        assert_eq!((both.best, both.by_motion), (motion, Some(motion)));
        assert_eq!(both.digits, Some(12));
        let difference = both.disagreement.unwrap();
        let by_formula = both.by_formula.unwrap().a;
        assert_eq!(difference, (by_formula - A).abs() / by_formula.max(A));
        // What the expansion leaves out.
        assert!(difference > 1e-12 && difference < 5.2e-3);

        let far = Problem {
            alpha: 1.01,
            psi: 1.0,
        };
        let far = far.compared(motion, 11).unwrap();
        assert_eq!((far.best, far.by_motion), (motion, Some(motion)));
        assert_eq!((far.by_formula, far.disagreement), (None, None));
        assert_eq!(far.digits, Some(11));
        assert_eq!(far.best.fields(), [Field::new("A", A)]);
    }

    #[test]
    fn points_of_the_curve_lie_on_the_boundary() {
        let point = |problem: Problem, i| problem.point(i).unwrap();
        assert_eq!(point(PROBLEM, 0), [0.0, 1.0]);
        let [alpha, a] = point(PROBLEM, 4);
        // Half the width to which it is bisected, as a part of e^−α.
        let room = 0.5e-4 * libm::exp(-alpha);
        assert!(alpha == 0.1 && (a - A).abs() <= room, "{alpha} {a}");
    }

    #[test]
    fn the_search_begins_below_the_boundary_even_at_its_lowest() {
        // Here the boundary is (2/3) α² above e^−α, less than a billionth.
        let lowest = Problem {
            alpha: 1.1e-5,
            psi: 0.0,
        };
        let a = lowest.bisect(1e-4).unwrap();
        assert!((a - 1.0).abs() < 0.5e-4);
    }
}
