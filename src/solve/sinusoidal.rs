//! A sinusoidal drive: the large-time motion.
//!
#![doc = include_str!("axes/drive.md")]

use super::{
    Answer, Curve, Field, Fields, PHASES, Quantity, RADIANS, ROUNDED, SMALL, Said, SolveError,
    UNITS, check, steps,
};
use crate::motion::drive::{Attractor, Drive, DriveState, Friction, Outcome, Sign};
use crate::numerics::{NumericsError, double::Double, number::Real};
use crate::paper::sinusoidal as printed;
use crate::scalar::Scalar;
use std::f64::consts::TAU;

/// The friction of a sinusoidal drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SinusoidalProblem<T = f64> {
    /// λ₀ = μg/A₀, dimensionless: from 10⁻⁶ to 10⁶. Without friction the start is never forgotten.
    pub lambda0: T,
}

/// The large-time motion of a drive whose second half period is the opposite of its first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// `two-zeros`, `two-rests` or `rest`; `critical` where the first two meet, to all digits that are known.
    pub regime: &'static str,
    /// The phase, radians in [0, 2π), at which forward motion begins; nothing at rest for ever.
    pub positive_start: Option<f64>,
    /// The phase, radians in [0, 4π), at which it ends.
    pub positive_end: Option<f64>,
    /// The share of the time at rest, from 0 to 1.
    pub rest_fraction: f64,
    /// The largest velocity 𝔴, in units of A₀/ω.
    pub w_max: f64,
}

/// The unit of a driven particle's velocity.
pub const VELOCITY: &str = "A₀/ω";

impl Fields for Swing {
    fn fields(&self) -> Vec<Field> {
        vec![
            Field::new("regime", self.regime),
            Field::within(1.0, "positive_start", self.positive_start).of(RADIANS),
            Field::within(1.0, "positive_end", self.positive_end).of(RADIANS),
            Field::within(SMALL, "rest_fraction", self.rest_fraction).out_of(1.0),
            Field::new("w_max", self.w_max).of(VELOCITY),
        ]
    }
}

impl<T: Quantity> SinusoidalProblem<T> {
    /// The large-time motion.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for λ₀ out of range.
    pub fn solve(&self) -> Result<Answer<Swing>, SolveError> {
        let lambda0 = self.lambda0.into();
        friction("lambda0", lambda0)?;
        let motions = swings(libm::sin, &[], lambda0)?;
        let (_, note) = by_formula(self.lambda0.into())?;
        let said = Said::by(|nudge| {
            let given = nudge.map_or(self.lambda0.into(), |by| Double::from(by * lambda0));
            by_formula(given).map(|(swing, _)| swing)
        })?;
        Answer::by_both(said, motions, PHASES, note)
    }

    /// 𝔴 against φ over two periods.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let lambda0 = self.lambda0.into();
        friction("lambda0", lambda0)?;
        let drive = Drive::new(libm::sin, &[])?;
        Ok(two_periods(&settle(
            &drive,
            Friction::new(lambda0, lambda0)?,
        )?))
    }
}

fn by_formula(lambda0: Double) -> Result<(Swing, &'static str), SolveError> {
    let one = Double::from(1.0);
    if lambda0 >= one {
        return Ok((
            AT_REST,
            "at rest by the last of the three cases that follow (41)",
        ));
    }
    let (phi1, phi2) = (printed::eq27_phi1(lambda0), printed::eq28_phi2(lambda0));
    let apart = (lambda0 - printed::eq37_lambda_c()).to_f64();
    let critical = apart.abs() <= ROUNDED;
    if apart <= 0.0 || critical {
        let start = printed::eq39_phi_t1(lambda0);
        let [w_max, _] = printed::eq38_w(lambda0, start, phi2);
        let swing = Swing {
            regime: below(critical),
            positive_start: Some(start.to_f64()),
            positive_end: Some((start + Double::pi()).to_f64()),
            rest_fraction: 0.0,
            w_max: w_max.to_f64(),
        };
        return Ok((swing, "by (38) and (39)"));
    }
    let slip = Slip::from_rest(lambda0);
    let end = phi1 + slip.length()?;
    let swing = Swing {
        regime: "two-rests",
        positive_start: Some(phi1.to_f64()),
        positive_end: Some(end.to_f64()),
        rest_fraction: ((printed::eq29_phi3(lambda0) - end) / Double::pi()).to_f64(),
        w_max: slip.w(lambda0.acos() * 2.0.into()).to_f64(),
    };
    Ok((swing, "by (27) and (31) to (33)"))
}

/// The regime below the critical friction, or at it but for rounding, where no rest has a length.
pub(super) fn below(critical: bool) -> &'static str {
    if critical { "critical" } else { "two-zeros" }
}

/// A slip under the friction λ from rest at the phase φ₀, where the drive does not hold it: (31) with φ = φ₀ + x,
///
/// w = cos φ₀ (1 − cos x) + sin φ₀ (sin x − x) + (sin φ₀ − λ) x,
///
/// in which nothing cancels, however short it is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slip {
    lambda: Double,
    sine: Double,
    cosine: Double,
}

impl Slip {
    /// From rest at the phase at which the drive outgrows the friction.
    pub(super) fn from_rest(lambda: Double) -> Self {
        let one = Double::from(1.0);
        Self {
            lambda,
            sine: lambda,
            cosine: ((one - lambda) * (one + lambda)).sqrt(),
        }
    }

    /// From the end of the motion the other way, at the phase `start`.
    pub(super) fn at_once(lambda: Double, start: Double) -> Self {
        Self {
            lambda,
            sine: start.sin(),
            cosine: start.cos(),
        }
    }

    pub(super) fn w(&self, x: Double) -> Double {
        let (half, two) = ((x * 0.5.into()).sin(), Double::from(2.0));
        self.cosine * two * half * half + self.sine * sine_less(x) + (self.sine - self.lambda) * x
    }

    /// ∫w dx up to `x`.
    pub(super) fn way(&self, x: Double) -> Double {
        let square = x * x * 0.5.into();
        self.sine * cosine_less(x) - self.cosine * sine_less(x) + (self.sine - self.lambda) * square
    }

    /// The way after which it ends: the only zero of w after its largest value, which is where the drive falls below
    /// the friction.
    pub(super) fn length(&self) -> Result<Double, NumericsError> {
        let start = self.sine.atan2(self.cosine);
        let two = Double::from(2.0);
        let fastest = Double::pi() - self.lambda.asin() - start;
        // From there on w falls until the drive outgrows the friction again; in a whole period it falls by 2πλ.
        let last = (Double::pi() + self.lambda.asin() + Double::pi()) - start;
        let (mut low, mut high) = (fastest, last);
        let mut x = (low + high) * 0.5.into();
        for _ in 0..250 {
            let w = self.w(x);
            *if w.to_f64() > 0.0 {
                &mut low
            } else {
                &mut high
            } = x;
            let slope = self.cosine * x.sin()
                - self.sine * two * (x * 0.5.into()).sin() * (x * 0.5.into()).sin()
                + (self.sine - self.lambda);
            let next = x - w / slope;
            let next = if low < next && next < high {
                next
            } else {
                (low + high) * 0.5.into()
            };
            let moved = (next - x).to_f64().abs();
            x = next;
            if moved <= 1e-31 * x.to_f64() {
                return Ok(x);
            }
        }
        Err(NumericsError::Limit {
            what: "steps to the end of a slip",
            limit: 250,
            at: x.to_f64(),
        })
    }
}

/// sin x − x.
fn sine_less(x: Double) -> Double {
    if x.to_f64().abs() > 1.0 {
        return x.sin() - x;
    }
    tail(x * x * x / (-6.0).into(), x * x, 3.0)
}

/// cos x − 1 + x²/2, with the sign changed.
fn cosine_less(x: Double) -> Double {
    let square = x * x;
    if x.to_f64().abs() > 1.0 {
        return Double::from(1.0) - x.cos() - square * 0.5.into();
    }
    tail(square * square / (-24.0).into(), square, 4.0)
}

/// The series of a sine or cosine from the term with x to the power `n` on.
fn tail(mut term: Double, square: Double, mut n: f64) -> Double {
    let mut sum = term;
    while term.to_f64().abs() > 1e-33 * sum.to_f64().abs() {
        term = -(term * square) / ((n + 1.0) * (n + 2.0)).into();
        n += 2.0;
        sum = sum + term;
    }
    sum
}

/// Under the friction `lambda0` both ways; the second in other units.
pub(super) fn swings(
    h: impl Fn(f64) -> f64,
    jumps: &[f64],
    lambda0: f64,
) -> Result<[Swing; 2], SolveError> {
    let in_units = |units: f64| -> Result<Swing, SolveError> {
        let drive = Drive::new(|phi| units * h(phi), jumps)?;
        let friction = Friction::new(units * lambda0, units * lambda0)?;
        let swing = swing(&settle(&drive, friction)?);
        Ok(Swing {
            w_max: swing.w_max / units,
            ..swing
        })
    };
    Ok([in_units(1.0)?, in_units(UNITS)?])
}

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

const PERIODS: u32 = 1000;

/// Of mean zero, from rest at φ = 0.
pub(super) fn settle(drive: &Drive, friction: Friction) -> Result<Attractor<'_>, SolveError> {
    let start = DriveState { phi: 0.0, w: 0.0 };
    match drive.attractor(friction, start, PERIODS)? {
        Outcome::Settles(attractor) => Ok(attractor),
        Outcome::Drifts { .. } => Err(SolveError::NotFinite { name: "w_max" }),
    }
}

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
        units: [RADIANS, VELOCITY],
        equal: false,
        points: steps(2.0 * TAU, 400)
            .map(|phi| [phi, motion.w(phi)])
            .collect(),
    }
}
