//! A sinusoidal drive: the large-time motion.

use super::{Answer, Curve, Field, Fields, SolveError, check, steps};
use crate::motion::drive::{Attractor, Drive, DriveError, Friction, Outcome, Sign, State};
use crate::numerics::roots::root;
use crate::paper::sinusoidal as printed;
use std::f64::consts::{PI, TAU};

/// The friction of a sinusoidal drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Problem {
    /// λ₀ = μg/A₀, dimensionless: from 10⁻⁶ to 10⁶. Without friction the start is never forgotten.
    pub lambda0: f64,
}

/// The large-time motion of a drive whose second half period is the opposite of its first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// `two-zeros`, `two-rests` or `rest`.
    pub regime: &'static str,
    /// The phase in [0, 2π) at which forward motion begins.
    pub positive_start: Option<f64>,
    /// The phase in [0, 4π) at which it ends.
    pub positive_end: Option<f64>,
    /// The share of the time at rest.
    pub rest_fraction: f64,
    /// The largest velocity 𝔴.
    pub w_max: f64,
}

impl Fields for Swing {
    fn fields(&self) -> Vec<Field> {
        vec![
            Field::new("regime", self.regime),
            Field::within(1.0, "positive_start", self.positive_start),
            Field::within(1.0, "positive_end", self.positive_end),
            Field::new("rest_fraction", self.rest_fraction),
            Field::new("w_max", self.w_max),
        ]
    }
}

impl Problem {
    /// The large-time motion.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for λ₀ out of range.
    pub fn solve(&self) -> Result<Answer<Swing>, SolveError> {
        let motion = swing(&settle(&self.drive()?, self.friction()?)?);
        let (formula, note) = self.by_formula()?;
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

    fn drive(&self) -> Result<Drive, DriveError> {
        Drive::new(libm::sin, &[])
    }

    fn friction(&self) -> Result<Friction, SolveError> {
        friction("lambda0", self.lambda0)?;
        Ok(Friction::new(self.lambda0, self.lambda0)?)
    }

    fn by_formula(&self) -> Result<(Swing, &'static str), SolveError> {
        let lambda0 = self.lambda0;
        if lambda0 >= 1.0 {
            return Ok((
                AT_REST,
                "at rest by the last of the three cases that follow (41)",
            ));
        }
        let (phi1, phi2) = (printed::eq27_phi1(lambda0), printed::eq28_phi2(lambda0));
        if lambda0 <= printed::eq37_lambda_c() {
            let start = printed::eq39_phi_t1(lambda0);
            let swing = Swing {
                regime: "two-zeros",
                positive_start: Some(start),
                positive_end: Some(start + PI),
                rest_fraction: 0.0,
                w_max: printed::eq38_w(lambda0, start, phi2)[0],
            };
            return Ok((swing, "by (38) and (39)"));
        }
        let phi3 = printed::eq29_phi3(lambda0);
        let end = root(|phi| printed::eq32_left(lambda0, phi1, phi), phi2, phi3)?;
        let swing = Swing {
            regime: "two-rests",
            positive_start: Some(phi1),
            positive_end: Some(end),
            rest_fraction: (phi3 - end) / PI,
            w_max: printed::eq31_w(lambda0, phi1, phi2),
        };
        Ok((swing, "by (27) and (31) to (33)"))
    }
}

/// The particle at rest for ever.
pub(super) const AT_REST: Swing = Swing {
    regime: "rest",
    positive_start: None,
    positive_end: None,
    rest_fraction: 1.0,
    w_max: 0.0,
};

/// Requires a friction whose motion is settled within the periods allowed.
pub(super) fn friction(name: &'static str, value: f64) -> Result<(), SolveError> {
    let fit = (1e-6..=1e6).contains(&value);
    let allowed = "between 1e-6 and 1e6 (without friction the start is never forgotten)";
    check(name, value, fit, allowed)
}

/// Periods that may be followed.
const PERIODS: u32 = 1000;

/// The large-time motion of a drive whose mean is zero, from rest at φ = 0.
pub(super) fn settle(drive: &Drive, friction: Friction) -> Result<Attractor<'_>, SolveError> {
    let start = State { phi: 0.0, w: 0.0 };
    match drive.attractor(friction, start, PERIODS)? {
        Outcome::Settles(attractor) => Ok(attractor),
        Outcome::Drifts { .. } => Err(SolveError::NotFinite { name: "w_max" }),
    }
}

/// What a simulated motion is.
pub(super) fn swing(motion: &Attractor<'_>) -> Swing {
    let intervals = motion.intervals();
    let of = |sign| intervals.iter().filter(move |i| i.sign == sign);
    let rest: f64 = of(Sign::Rest).map(|i| i.length()).sum();
    let Some(positive) = of(Sign::Positive).next() else {
        return AT_REST;
    };
    Swing {
        regime: if rest > 0.0 { "two-rests" } else { "two-zeros" },
        positive_start: Some(positive.start),
        positive_end: Some(positive.end),
        rest_fraction: rest / TAU,
        w_max: motion.largest().w.abs(),
    }
}

/// 𝔴 against φ over two periods.
pub(super) fn two_periods(motion: &Attractor<'_>) -> Curve {
    Curve {
        title: "The large-time motion",
        x: "φ",
        y: "𝔴",
        equal: false,
        points: steps(2.0 * TAU, 400)
            .map(|phi| [phi, motion.w(phi)])
            .collect(),
    }
}
