//! Anisotropic friction under a sinusoidal drive: the large-time motion and its region.

pub mod row;

use super::sinusoidal::{friction, settle, two_periods};
use super::{Answer, Curve, Field, Fields, SolveError, check};
use crate::motion::drive::{Attractor, Drive, Friction, Sign};
use crate::numerics::NumericsError;
use crate::numerics::roots::root;
use crate::paper::{anisotropic as printed, sinusoidal};
use std::f64::consts::{PI, TAU};

/// The two frictions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Problem {
    /// q = μ₋/μ₊, from 10⁻³ to 10³. Below 1, which the paper leaves out, forward and backward change roles.
    pub q: f64,
    /// λ₀ = μ₊g/A₀, dimensionless. λ₀ and qλ₀ are from 10⁻⁶ to 10⁶.
    pub lambda0: f64,
}

/// A period of the large-time motion; the four lengths (in φ) add up to 2π.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Period {
    /// The region, `I` to `V`, by the order of the intervals.
    pub region: &'static str,
    /// Length of forward motion.
    pub positive: f64,
    /// Length of backward motion.
    pub negative: f64,
    /// Length of the rest after forward motion; 2π where there is no motion.
    pub rest_after_positive: f64,
    /// Length of the rest after backward motion.
    pub rest_after_negative: f64,
    /// ∫𝔴 dφ over a period.
    pub drift_per_period: f64,
}

/// The digits of a shorter rest count beside this: where two regions meet, a rest is nothing but rounding.
const SHORT: f64 = 1e-6;

/// A drift below this part of the ways there and back is nothing but rounding.
const BALANCED: f64 = 1e-15;

/// What is left of the ways there and back, 0 where that is no more than rounding.
fn drift(forward: f64, backward: f64) -> f64 {
    let left = forward - backward;
    if left.abs() <= BALANCED * (forward + backward) {
        0.0
    } else {
        left
    }
}

impl Fields for Period {
    fn fields(&self) -> Vec<Field> {
        // Without a drift there are no digits to count.
        let beside = if self.drift_per_period == 0.0 {
            1.0
        } else {
            0.0
        };
        vec![
            Field::new("region", self.region),
            Field::new("positive", self.positive),
            Field::new("negative", self.negative),
            Field::within(SHORT, "rest_after_positive", self.rest_after_positive),
            Field::within(SHORT, "rest_after_negative", self.rest_after_negative),
            Field::within(beside, "drift_per_period", self.drift_per_period),
        ]
    }
}

/// The regions by whether there is motion both ways and how many rests.
fn region(positive: f64, negative: f64, rests: usize) -> &'static str {
    match (positive > 0.0, negative > 0.0, rests) {
        (false, false, _) => "V",
        (true, true, 0) => "I",
        (true, true, 1) => "II",
        (true, true, _) => "III",
        _ => "IV",
    }
}

impl Problem {
    /// A period of the large-time motion.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for q or λ₀ out of range.
    pub fn solve(&self) -> Result<Answer<Period>, SolveError> {
        let friction = self.friction()?;
        let drive = Drive::new(libm::sin, &[])?;
        let motion = period(&settle(&drive, friction)?);
        let formula = self.by_formula()?;
        Answer::by_both(formula, motion, self.note(&formula))
    }

    /// 𝔴 against φ over two periods.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let friction = self.friction()?;
        let drive = Drive::new(libm::sin, &[])?;
        Ok(two_periods(&settle(&drive, friction)?))
    }

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

    fn by_formula(&self) -> Result<Period, SolveError> {
        let (plus, minus) = (self.lambda0, self.q * self.lambda0);
        if self.q >= 1.0 {
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

/// A slip under the friction `lambda` from rest at the phase `start`, where the drive exceeds it: its length and
/// the way ∫𝔴 dφ, by the integral of (51).
fn slip(lambda: f64, start: f64) -> Result<(f64, f64), NumericsError> {
    let left = |phi: f64| sinusoidal::eq32_left(lambda, start, phi);
    // It is fastest at φ₂, where the drive falls below friction, and over before φ₄, where it falls below −λ no more.
    let (fastest, over) = (sinusoidal::eq28_phi2(lambda), sinusoidal::eq30_phi4(lambda));
    let end = root(left, fastest, over)?;
    Ok((end - start, way(lambda, start, end)))
}

/// ∫𝔴 dφ of a slip.
fn way(lambda: f64, start: f64, end: f64) -> f64 {
    let length = end - start;
    libm::cos(start) * length - 0.5 * lambda * length * length + libm::sin(start) - libm::sin(end)
}

/// A period with the frictions λ₊ = `plus` and λ₋ = `minus`, the latter not less.
fn larger_backwards(plus: f64, minus: f64) -> Result<Period, NumericsError> {
    let nothing = Period {
        region: "V",
        positive: 0.0,
        negative: 0.0,
        rest_after_positive: TAU,
        rest_after_negative: 0.0,
        drift_per_period: 0.0,
    };
    if plus >= 1.0 {
        return Ok(nothing);
    }
    if let Some(period) = without_rest(plus, minus) {
        return Ok(period);
    }
    let begins = sinusoidal::eq27_phi1(plus);
    let (positive, forward) = slip(plus, begins)?;
    let ends = begins + positive;
    // Backward motion begins where the drive pulls strongly enough: at once, later, or not in this period.
    let pulls = if minus < 1.0 {
        PI + libm::asin(minus)
    } else {
        TAU
    };
    let ceases = 3.0 * PI - pulls;
    if minus >= 1.0 || ends >= ceases {
        return Ok(Period {
            region: "IV",
            positive,
            rest_after_positive: TAU - positive,
            drift_per_period: forward,
            ..nothing
        });
    }
    let turns = ends.max(pulls);
    let (negative, backward) = slip(minus, turns - PI)?;
    let waits = turns - ends;
    Ok(Period {
        region: if waits > 0.0 { "III" } else { "II" },
        positive,
        negative,
        rest_after_positive: waits,
        rest_after_negative: (TAU - positive - waits - negative).max(0.0),
        drift_per_period: drift(forward, backward),
    })
}

/// Region I: both slips last until the other begins. The momentum given back in a period, λ₊ times one length plus
/// −λ₋ times the other, is zero; so the lengths are 2K and 2π − 2K with K of (53), and the middle m of forward
/// motion is where the integral of (51) vanishes, sin m = λ₀ K/sin K. None if friction would hold in between.
fn without_rest(plus: f64, minus: f64) -> Option<Period> {
    let k = printed::eq53_k(minus / plus);
    let sine = plus * k / libm::sin(k);
    if sine > 1.0 {
        return None;
    }
    let middle = PI - libm::asin(sine);
    let (begins, ends) = (middle - k, middle + k);
    // The other begin holds if this one does: it asks for less, 1 + 2K cot(π − K) ≥ q = K/(π − K) for K ≥ π/2.
    if libm::sin(begins) < plus {
        return None;
    }
    let (forward, backward) = (way(plus, begins, ends), way(minus, ends - PI, begins + PI));
    Some(Period {
        region: "I",
        positive: 2.0 * k,
        negative: TAU - 2.0 * k,
        rest_after_positive: 0.0,
        rest_after_negative: 0.0,
        drift_per_period: drift(forward, backward),
    })
}

/// What a simulated motion is.
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

    /// Steps of a number near 0.1: 10⁻¹⁵ of the sum are fourteen.
    #[test]
    fn what_rounding_leaves_is_no_drift() {
        let more = |steps: u64| f64::from_bits(0.1f64.to_bits() + steps);
        assert_eq!(drift(more(2), 0.1), 0.0);
        assert_eq!(drift(0.1, more(6)), 0.0);
        assert_eq!(drift(more(20), 0.1), more(20) - 0.1);
        assert_eq!(drift(0.75, 0.5), 0.25);
    }
}
