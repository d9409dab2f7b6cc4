//! Anisotropic friction under a sinusoidal drive: the large-time motion and its region.
//!
#![doc = include_str!("axes/drive.md")]

use super::{
    Answer, Curve, Field, Fields, PHASES, Quantity, RADIANS, SMALL, Said, SolveError, UNITS, check,
    sinusoidal::{Slip, friction, settle, two_periods},
};
use crate::motion::drive::{Attractor, Drive, Friction, Sign};
use crate::numerics::{NumericsError, double::Double, number::Real};
use crate::paper::{anisotropic as printed, sinusoidal};
use crate::scalar::Scalar;
use std::f64::consts::TAU;

/// The two frictions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnisotropicProblem<T = f64> {
    /// q = μ₋/μ₊, from 10⁻³ to 10³. Below 1, which the paper leaves out, forward and backward change roles.
    pub q: T,
    /// λ₀ = μ₊g/A₀, dimensionless. λ₀ and qλ₀ are from 10⁻⁶ to 10⁶.
    pub lambda0: T,
}

/// A period of the large-time motion; the four lengths (in φ) add up to 2π.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Period {
    /// The region, `I` to `V`, by the order of the intervals.
    pub region: &'static str,
    /// Length of forward motion, radians of φ; so are the other three.
    pub positive: f64,
    /// Length of backward motion.
    pub negative: f64,
    /// Length of the rest after forward motion; 2π where there is no motion.
    pub rest_after_positive: f64,
    /// Length of the rest after backward motion.
    pub rest_after_negative: f64,
    /// ∫𝔴 dφ over a period: the way, in units of A₀/ω².
    pub drift_per_period: f64,
}

/// The unit of a driven particle's way.
pub const DISPLACEMENT: &str = "A₀/ω²";

/// The digits of a shorter rest count beside this: where two regions meet, a rest is nothing but rounding.
const SHORT: f64 = 1e-6;

/// A drift below this part of the ways there and back is nothing but rounding.
const BALANCED: f64 = 1e-30;

/// 0 where that is no more than rounding.
fn drift(forward: Double, backward: Double) -> f64 {
    let (left, both) = (forward - backward, forward + backward);
    if left.to_f64().abs() <= BALANCED * both.to_f64() {
        0.0
    } else {
        left.to_f64()
    }
}

impl Period {
    fn longest(&self) -> f64 {
        let length = self.positive.max(self.negative).min(1.0);
        length * length * length
    }
}

impl Fields for Period {
    fn fields(&self) -> Vec<Field> {
        // Without a drift there are no digits to count.
        let beside = if self.drift_per_period == 0.0 {
            1.0
        } else {
            SMALL * self.longest()
        };
        vec![
            Field::new("region", self.region),
            Field::new("positive", self.positive)
                .out_of(1.0)
                .of(RADIANS),
            Field::new("negative", self.negative)
                .out_of(1.0)
                .of(RADIANS),
            Field::within(SHORT, "rest_after_positive", self.rest_after_positive).of(RADIANS),
            Field::within(SHORT, "rest_after_negative", self.rest_after_negative).of(RADIANS),
            Field::within(beside, "drift_per_period", self.drift_per_period)
                .out_of(self.longest())
                .of(DISPLACEMENT),
        ]
    }
}

fn region(positive: f64, negative: f64, rests: usize) -> &'static str {
    match (positive > 0.0, negative > 0.0, rests) {
        (false, false, _) => "V",
        (true, true, 0) => "I",
        (true, true, 1) => "II",
        (true, true, _) => "III",
        _ => "IV",
    }
}

impl<T: Quantity> AnisotropicProblem<T> {
    /// A period of the large-time motion.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for q or λ₀ out of range.
    pub fn solve(&self) -> Result<Answer<Period>, SolveError> {
        let near = self.near();
        let friction = near.friction()?;
        let in_units = |units: f64| -> Result<Period, SolveError> {
            let drive = Drive::new(|phi| units * libm::sin(phi), &[])?;
            let friction = Friction::new(units * friction.plus(), units * friction.minus())?;
            let period = period(&settle(&drive, friction)?);
            Ok(Period {
                drift_per_period: period.drift_per_period / units,
                ..period
            })
        };
        let said = Said::by(|nudge| match nudge {
            None => by_formula(self.q.into(), self.lambda0.into()),
            Some(by) => by_formula(near.q.into(), (by * near.lambda0).into()),
        })?;
        let note = near.note(&said.given);
        let motions = [in_units(1.0)?, in_units(UNITS)?];
        Answer::by_both(said, motions, PHASES, note)
    }

    /// 𝔴 against φ over two periods.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let friction = self.near().friction()?;
        let drive = Drive::new(libm::sin, &[])?;
        Ok(two_periods(&settle(&drive, friction)?))
    }

    fn near(&self) -> AnisotropicProblem {
        AnisotropicProblem {
            q: self.q.into(),
            lambda0: self.lambda0.into(),
        }
    }
}

impl AnisotropicProblem {
    fn friction(&self) -> Result<Friction, SolveError> {
        let fit = (1e-3..=1e3).contains(&self.q);
        check("q", self.q, fit, "between 1e-3 and 1e3")?;
        friction("lambda0", self.lambda0)?;
        let minus = printed::eq50_lambda_minus(self.q, self.lambda0);
        friction("q lambda0", minus)?;
        Ok(Friction::new(
            printed::eq49_lambda_plus(self.lambda0),
            minus,
        )?)
    }

    fn note(&self, period: &Period) -> String {
        let by = "by (51) and (52), integrated";
        if self.q < 1.0 {
            format!("{by}, with forward and backward exchanged: the paper has q ≥ 1 only")
        } else if period.region == "IV" && self.q * self.lambda0 < 1.0 {
            format!("{by}; the printed list calls this region II: it lacks the curve E beyond Y")
        } else {
            by.to_owned()
        }
    }
}

fn by_formula(q: Double, lambda0: Double) -> Result<Period, SolveError> {
    let (plus, minus) = (lambda0, q * lambda0);
    if q >= 1.0.into() {
        return Ok(larger_backwards(plus, minus)?);
    }
    // The mirror image, half a period later.
    let mirrored = larger_backwards(minus, plus)?;
    let at_rest = mirrored.region == "V";
    Ok(Period {
        region: mirrored.region,
        positive: mirrored.negative,
        negative: mirrored.positive,
        rest_after_positive: if at_rest {
            TAU
        } else {
            mirrored.rest_after_negative
        },
        rest_after_negative: if at_rest {
            0.0
        } else {
            mirrored.rest_after_positive
        },
        drift_per_period: -mirrored.drift_per_period,
    })
}

/// A period with the frictions λ₊ = `plus` and λ₋ = `minus`, the latter not less, by slips as (51) gives them.
fn larger_backwards(plus: Double, minus: Double) -> Result<Period, NumericsError> {
    let nothing = Period {
        region: "V",
        positive: 0.0,
        negative: 0.0,
        rest_after_positive: TAU,
        rest_after_negative: 0.0,
        drift_per_period: 0.0,
    };
    let (one, pi) = (Double::from(1.0), Double::pi());
    let turn = pi + pi;
    if plus >= one {
        return Ok(nothing);
    }
    if let Some(period) = without_rest(plus, minus) {
        return Ok(period);
    }
    let begins = sinusoidal::eq27_phi1(plus);
    let forward = Slip::from_rest(plus);
    let positive = forward.length()?;
    let ends = begins + positive;
    // Backward motion begins where the drive pulls strongly enough: at once, later, or not in this period.
    let pulls = if minus < one { pi + minus.asin() } else { turn };
    let ceases = turn + pi - pulls;
    if minus >= one || ends >= ceases {
        return Ok(Period {
            region: "IV",
            positive: positive.to_f64(),
            rest_after_positive: (turn - positive).to_f64(),
            drift_per_period: forward.way(positive).to_f64(),
            ..nothing
        });
    }
    let waits = if pulls > ends {
        pulls - ends
    } else {
        0.0.into()
    };
    let backward = if pulls > ends {
        Slip::from_rest(minus)
    } else {
        Slip::at_once(minus, ends - pi)
    };
    let negative = backward.length()?;
    let rest = turn - positive - waits - negative;
    Ok(Period {
        region: if pulls > ends { "III" } else { "II" },
        positive: positive.to_f64(),
        negative: negative.to_f64(),
        rest_after_positive: waits.to_f64(),
        rest_after_negative: rest.to_f64().max(0.0),
        drift_per_period: drift(forward.way(positive), backward.way(negative)),
    })
}

/// Region I: both slips last until the other begins. The momentum given back in a period, λ₊ times one length plus
/// −λ₋ times the other, is zero; so the lengths are 2K and 2π − 2K with K of (53), and the middle m of forward
/// motion is where the integral of (51) vanishes, sin m = λ₀ K/sin K. None if friction would hold in between.
fn without_rest(plus: Double, minus: Double) -> Option<Period> {
    let k = printed::eq53_k(minus / plus);
    let sine = plus * k / k.sin();
    if sine > 1.0.into() {
        return None;
    }
    let pi = Double::pi();
    let middle = pi - sine.asin();
    let (begins, ends) = (middle - k, middle + k);
    // The other begin holds if this one does: it asks for less, 1 + 2K cot(π − K) ≥ q = K/(π − K) for K ≥ π/2.
    if begins.sin() < plus {
        return None;
    }
    let (positive, negative) = (k + k, pi + pi - k - k);
    let forward = Slip::at_once(plus, begins).way(positive);
    let backward = Slip::at_once(minus, ends - pi).way(negative);
    Some(Period {
        region: "I",
        positive: positive.to_f64(),
        negative: negative.to_f64(),
        rest_after_positive: 0.0,
        rest_after_negative: 0.0,
        drift_per_period: drift(forward, backward),
    })
}

fn period(motion: &Attractor<'_>) -> Period {
    let intervals = motion.intervals();
    let sum = |sign| -> f64 {
        let of_sign = intervals.iter().filter(|i| i.sign == sign);
        of_sign.map(|i| i.length()).sum()
    };
    let (positive, negative) = (sum(Sign::Positive), sum(Sign::Negative));
    let mut rests = [0.0; 2];
    let mut count = 0;
    for (i, rest) in intervals.iter().enumerate() {
        if rest.sign == Sign::Rest {
            let before = intervals[(i + intervals.len() - 1) % intervals.len()];
            rests[usize::from(before.sign == Sign::Negative)] += rest.length();
            count += 1;
        }
    }
    Period {
        region: region(positive, negative, count),
        positive,
        negative,
        rest_after_positive: rests[0],
        rest_after_negative: rests[1],
        drift_per_period: motion.displacement(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounding_leaves_is_no_drift() {
        let way = |more: f64| Double::from(0.1) + Double::from(more);
        assert_eq!(drift(way(1e-31), way(0.0)), 0.0);
        assert_eq!(drift(way(0.0), way(1e-31)), 0.0);
        assert!((drift(way(3e-30), way(0.0)) / 3e-30 - 1.0).abs() < 0.1);
        assert_eq!(drift(0.75.into(), 0.5.into()), 0.25);
    }

    /// A rest that is longer than rounding has digits of its own, however short it is beside the period.
    #[test]
    fn a_short_rest_is_compared_by_its_own_length() {
        let with = |rest_after_positive| Period {
            region: "III",
            positive: 3.0,
            negative: 2.0,
            rest_after_positive,
            rest_after_negative: 1.0,
            drift_per_period: 0.5,
        };
        for (length, expected) in [(1e-2, 0.5), (1e-4, 0.5), (2e-6, 0.5), (1e-7, 5e-2)] {
            let [rest, half] = [length, 0.5 * length].map(|length| with(length).fields());
            let apart = rest[3].difference(&half[3]);
            assert!((apart - expected).abs() < 1e-12, "{length}: {apart}");
        }
    }
}
