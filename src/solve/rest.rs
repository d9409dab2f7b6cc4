//! The turntable's boundary between rest and escape.
//!
#![doc = include_str!("axes/table.md")]

use super::{Answer, Curve, DIMENSIONLESS, Field, Fields, Quantity, Said, SolveError, check};
use crate::corrections::rest as corrected;
use crate::motion::{
    turntable::boundary::between,
    turntable::fate::{Certain, Ending, follow},
    turntable::intrinsic::Exact,
    turntable::{Start, boundary},
};
use crate::numerics::{double::Double, number::Real};
use crate::paper::turntable as printed;
use crate::scalar::Scalar;

/// A point of the boundary between rest and escape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryProblem<T = f64> {
    /// α, dimensionless, in [0, 20].
    pub alpha: T,
    /// ψ, radians, in [−10³, 10³].
    pub psi: T,
}

/// A on the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boundary {
    /// A, dimensionless.
    pub a: f64,
}

impl Fields for Boundary {
    fn fields(&self) -> Vec<Field> {
        vec![Field::new("A", self.a)]
    }
}

/// Beyond this α the expansion is tried by no claim, and soon means nothing.
const FAR: f64 = 0.3;
/// Between these α the boundary is found in `f64` first.
const NARROW: std::ops::RangeInclusive<f64> = 1e-3..=10.0;
/// To this it is right.
const MISSED: f64 = 1e-13;
/// To this part of itself A is searched for.
const WIDTH: f64 = 1e-17;
/// Between sides so close, in parts of A, the line is drawn that ends at the border.
const EVEN: f64 = 1e-11;
/// Terms of the series of numbers of twice the width.
const ORDER: usize = 44;

impl<T: Quantity> BoundaryProblem<T> {
    /// A on the boundary, by closing in on it with the motion and by the expansion to second order in α.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for α or ψ out of range.
    pub fn solve(&self) -> Result<Answer<Boundary>, SolveError> {
        let BoundaryProblem { alpha, psi } = self.checked()?;
        let [rest, escape] = self.sides()?;
        let motion = Boundary {
            a: ((rest + escape) * 0.5.into()).to_f64(),
        };
        let width = (escape - rest).to_f64() / motion.a;
        // Half the distance of the sides, and the last rounding.
        let digits = Some(super::digits(width));
        let by = "by the motion, in numbers of 31 digits: the particle comes to rest on the one side and goes away on the other, closer than the digits show";
        if alpha <= FAR {
            let formula = Boundary {
                a: corrected::boundary_a(alpha, psi),
            };
            let note = format!(
                "{by}; the formula is the expansion to second order in α that replaces (147), to the digits that the motion bears out"
            );
            return Ok(Answer {
                best: motion,
                digits,
                ..Answer::by_both(
                    Said::by(|_| Ok::<_, SolveError>(formula))?,
                    [motion; 2],
                    0.0,
                    note,
                )?
            });
        }
        let note = format!("{by}; the formula that replaces (147) is for small α");
        Ok(Answer {
            disagreement: None,
            digits,
            ..Answer::by_motions(motion, &motion, note)?
        })
    }

    fn checked(&self) -> Result<BoundaryProblem, SolveError> {
        let (alpha, psi) = (self.alpha.into(), self.psi.into());
        let fit = (0.0..=20.0).contains(&alpha);
        check("alpha", alpha, fit, "between 0 and 20")?;
        check("psi", psi, f64::abs(psi) <= 1e3, "between -1e3 and 1e3")?;
        Ok(BoundaryProblem { alpha, psi })
    }

    /// An A from which the particle comes to rest and one from which it does not, closer to each other than `f64` can say.
    fn sides(&self) -> Result<[Double; 2], SolveError> {
        let BoundaryProblem { alpha, psi } = self.checked()?;
        let (wide, angle): (Double, Double) = (self.alpha.into(), self.psi.into());
        let ending = |a: Double, closely: bool| -> Result<Ending<Double>, SolveError> {
            let (rho, p) = (printed::eq112_rho(a, wide), printed::eq111_p(a, wide));
            Ok(follow::<_, ORDER>(&Exact::polar(rho, p, angle), closely)?.0)
        };
        let rests = |a: Double| Ok::<_, SolveError>(ending(a, false)?.rests());
        // (1 − σ)², which near the border grows evenly with the distance from it.
        let gap = |a: Double| -> Result<Option<Double>, SolveError> {
            Ok(match ending(a, true)? {
                Ending::Certain(Certain::Rest(rest)) => Some(rest.gap * rest.gap),
                _ => None,
            })
        };
        let close_in = |[rest, escape]: [Double; 2], a: Double, part: f64| {
            let off = a * part.into();
            let (below, above) = (a - off, a + off);
            let lower = below > rest && rests(below)? == Some(true);
            let upper = above < escape && rests(above)? == Some(false);
            Ok::<_, SolveError>([
                if lower { below } else { rest },
                if upper { above } else { escape },
            ])
        };
        // p + ρ < 1 is a rest, ρ² − p² ≥ 1 an escape.
        let mut sides = [Scalar::exp(-wide), Double::from(1.0)];
        if NARROW.contains(&alpha) {
            let near = boundary(alpha, psi)?;
            sides = close_in(sides, near.into(), MISSED / near)?;
        }
        let mut drawn = false;
        loop {
            let [rest, escape] = sides;
            let width = escape - rest;
            if width.to_f64() <= WIDTH * rest.to_f64() {
                return Ok(sides);
            }
            if !drawn && width.to_f64() < EVEN * rest.to_f64() {
                drawn = true;
                if let (Some(near), Some(far)) = (gap(rest)?, gap(rest - width)?) {
                    sides = close_in(sides, rest + width * near / (far - near), 0.4 * WIDTH)?;
                }
                continue;
            }
            let middle = (rest + escape) * 0.5.into();
            match rests(middle)? {
                Some(true) => sides[0] = middle,
                Some(false) => sides[1] = middle,
                None => return Ok(sides),
            }
        }
    }

    /// A against α at the same ψ, by the motion.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let near = self.checked()?;
        let points: Result<Vec<_>, _> = (0..=40).map(|i| near.point(i)).collect();
        Ok(Curve {
            title: "The boundary between rest and escape",
            x: "α",
            y: "A",
            units: [DIMENSIONLESS; 2],
            equal: false,
            points: points?,
        })
    }
}

impl BoundaryProblem {
    /// Point `i` of the 41 of the curve, which reaches at least to α = 1.
    fn point(&self, i: u32) -> Result<[f64; 2], SolveError> {
        let most = self.alpha.max(1.0);
        let alpha = most * f64::from(i) / 40.0;
        let a = match i {
            0 => 1.0,
            _ => BoundaryProblem { alpha, ..*self }.bisect(1e-4)?,
        };
        Ok([alpha, a])
    }

    /// A by bisection on the motion, to this width in units of the least that it can be.
    fn bisect(&self, width: f64) -> Result<f64, SolveError> {
        let BoundaryProblem { alpha, psi } = *self;
        let least = (1.0 - 1e-9) * libm::exp(-alpha);
        let start = |a| Start::hyperbolic(a, alpha, psi);
        Ok(between(start, least, 1.0 + 1e-9, width * least)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROBLEM: BoundaryProblem = BoundaryProblem {
        alpha: 0.1,
        psi: 1.0,
    };
    /// Its boundary, from an extrapolating integrator in extended precision.
    const A: f64 = 0.931534356734;

    #[test]
    fn the_boundary_lies_where_another_integrator_has_it() {
        let [rest, escape] = PROBLEM.sides().unwrap();
        assert!((rest.to_f64() - A).abs() < 1e-12 && rest < escape);
        assert!((escape - rest).to_f64() < 2.0 * WIDTH);
        let answer = PROBLEM.solve().unwrap();
        assert_eq!((answer.best.a, answer.digits), (rest.to_f64(), Some(15)));
        assert_eq!(answer.by_motion, Some(answer.best));
        let by_formula = answer.by_formula.unwrap().a;
        let difference = answer.disagreement.unwrap();
        assert_eq!(
            difference,
            (by_formula - answer.best.a).abs() / by_formula.max(answer.best.a)
        );
        assert!(difference > 1e-12 && difference < 5.2e-3);
    }

    #[test]
    fn close_to_the_corner_the_motion_meets_the_expansion() {
        for alpha in [1e-4, 1e-6, 1e-9, 1e-20] {
            let near = BoundaryProblem { alpha, psi: 0.5 };
            let answer = near.solve().unwrap();
            let formula = answer.by_formula.unwrap().a;
            let left_out = 8.0 * alpha * alpha * alpha + 1e-15;
            assert!(
                (answer.best.a - formula).abs() < left_out,
                "{alpha} {answer:?}"
            );
            assert_eq!(answer.digits, Some(15));
        }
        let corner = BoundaryProblem {
            alpha: 0.0,
            psi: 0.5,
        };
        assert_eq!(corner.solve().unwrap().best.a, 1.0);
    }

    #[test]
    fn far_from_the_corner_the_motion_stands_alone() {
        let far = BoundaryProblem {
            alpha: 1.01,
            psi: 1.0,
        };
        let far = far.solve().unwrap();
        assert_eq!((far.by_formula, far.disagreement), (None, None));
        assert_eq!(far.by_motion, Some(far.best));
        assert_eq!(far.best.fields(), [Field::new("A", far.best.a)]);
    }

    #[test]
    fn points_of_the_curve_lie_on_the_boundary() {
        let point = |problem: BoundaryProblem, i| problem.point(i).unwrap();
        assert_eq!(point(PROBLEM, 0), [0.0, 1.0]);
        let [alpha, a] = point(PROBLEM, 4);
        // Half the width to which it is bisected, as a part of e^−α.
        let room = 0.5e-4 * libm::exp(-alpha);
        assert!(alpha == 0.1 && (a - A).abs() <= room, "{alpha} {a}");
    }

    #[test]
    fn the_search_begins_below_the_boundary_even_at_its_lowest() {
        // Here the boundary is (2/3) α² above e^−α, less than a billionth.
        let lowest = BoundaryProblem {
            alpha: 1.1e-5,
            psi: 0.0,
        };
        let a = lowest.bisect(1e-4).unwrap();
        assert!((a - 1.0).abs() < 0.5e-4);
    }
}
