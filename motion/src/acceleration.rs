//! The acceleration of the plane, as the integrator wants it: by its Taylor series about any time.

use super::error::MotionError;
use super::signal::Signal;
use crate::numerics::taylor::Coefficients;

/// The acceleration A(t) of the plane in the laboratory, in length/time²; a body is pulled [the other way](super).
///
/// [`Plane`] makes one of signals, [`Fitted`](super::Fitted) one of a function's values or of a table, [`Series`] one of a
/// function's Taylor coefficients.
pub trait Acceleration: Sync {
    /// Taylor coefficients of A_x and A_y about `t`; where A jumps, those of what comes after.
    fn coefficients(&self, t: f64) -> [Coefficients; 2];

    /// The next time after `t` at which A or a derivative of it jumps. Between breaks A is analytic.
    fn next_break(&self, _t: f64) -> Option<f64> {
        None
    }

    /// The first and the last time at which it is known.
    fn times(&self) -> [f64; 2] {
        [f64::NEG_INFINITY, f64::INFINITY]
    }

    /// How many pieces it is stored in, each of which allows a motion a hundred steps more: 0 for a formula.
    fn pieces(&self) -> usize {
        0
    }

    /// How far a component may be from the acceleration that is meant, in length/time², beyond rounding.
    fn error(&self) -> f64 {
        0.0
    }
}

pub(super) fn check_time(plane: &dyn Acceleration, t: f64) -> Result<(), MotionError> {
    let [from, to] = plane.times();
    let fit = t >= from && t <= to;
    fit.then_some(())
        .ok_or(MotionError::Outside { t, from, to })
}

pub(super) fn most_steps(plane: &dyn Acceleration) -> usize {
    plane.pieces().saturating_mul(100).saturating_add(50_000)
}

/// An acceleration by a function from the time to the Taylor coefficients of (A_x, A_y), without breaks. The coefficients
/// are tried: values alone are refused.
#[derive(Debug, Clone, Copy)]
pub struct Series<F>(F);

/// How often coefficients are tried, and by which part of the range a series is followed there.
const TRIED: u32 = 16;
const SHARE: f64 = 1e-3;
/// What may be missing, as a part of the largest change on the way.
const MISSING: f64 = 1e-6;

impl<F: Fn(f64) -> [Coefficients; 2] + Sync> Series<F> {
    /// From the coefficients about any time in `[from, to]`.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a time after which the series of a component does not lead to the value that it has a
    /// thousandth of the range later: those of a constant, where the function is none.
    pub fn new(function: F, [from, to]: [f64; 2]) -> Result<Self, MotionError> {
        for k in 0..TRIED {
            let t = from + (to - from) * (f64::from(k) + 0.5) / f64::from(TRIED);
            let h = SHARE * (to - from);
            let (here, there) = (function(t), function(t + h));
            for (here, there) in here.iter().zip(&there) {
                let led = here.iter().rev().fold(0.0, |sum, c| sum * h + c);
                let change = (there[0] - here[0]).abs().max(1e-6 * there[0].abs());
                let missing = (led - there[0]).abs();
                if missing.is_nan() || missing > MISSING * change {
                    return Err(MotionError::Argument {
                        name: "the series after t",
                        value: t,
                        range: "that of the function, to all orders: `Fitted::from_fn` takes values alone",
                    });
                }
            }
        }
        Ok(Self(function))
    }
}

impl<F: Fn(f64) -> [Coefficients; 2] + Sync> Acceleration for Series<F> {
    fn coefficients(&self, t: f64) -> [Coefficients; 2] {
        (self.0)(t)
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// A_x, in length/time².
    pub x: Signal,
    /// A_y, in length/time².
    pub y: Signal,
}

impl Plane {
    /// The plane gets faster along `a`, and a body on it is pulled along −`a`.
    pub fn constant(a: [f64; 2]) -> Self {
        Self {
            x: Signal::constant(a[0]),
            y: Signal::constant(a[1]),
        }
    }

    /// The plane accelerates by A(t) = direction · signal(t).
    pub fn along(direction: [f64; 2], signal: Signal) -> Self {
        Self {
            x: signal.clone().times(direction[0]),
            y: signal.times(direction[1]),
        }
    }

    /// A(t) = amplitude(t) · (cos φ, sin φ), φ = frequency · t + phase.
    pub fn rotating(amplitude: Signal, frequency: f64, phase: f64) -> Self {
        let turned =
            |phase| Signal::Product(vec![amplitude.clone(), Signal::Sine { frequency, phase }]);
        Self {
            x: turned(phase + std::f64::consts::FRAC_PI_2),
            y: turned(phase),
        }
    }
}

impl Acceleration for Plane {
    fn coefficients(&self, t: f64) -> [Coefficients; 2] {
        [self.x.coefficients(t), self.y.coefficients(t)]
    }

    fn next_break(&self, t: f64) -> Option<f64> {
        match (self.x.next_break(t), self.y.next_break(t)) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::taylor::TERMS;

    #[test]
    fn a_value_alone_is_not_taken_for_a_series() {
        let sine = Signal::Sine {
            frequency: 1.0,
            phase: 0.0,
        };
        let whole = |t: f64| [sine.coefficients(t), [0.0; TERMS]];
        for i in 0..2 {
            let beside = |t: f64, own: &[f64]| {
                let mut c = [sine.coefficients(t); 2];
                c[i] = [0.0; TERMS];
                c[i][..own.len()].copy_from_slice(own);
                c
            };
            let all = |t: f64| beside(t, &sine.coefficients(t));
            assert!(Series::new(all, [0.0, 10.0]).is_ok());
            let value = |t: f64| beside(t, &[libm::sin(t)]);
            let refused = Series::new(value, [0.0, 10.0]).err().unwrap().to_string();
            assert!(refused.contains("Fitted::from_fn"), "{refused}");
            // Nor are value and slope.
            let slope = |t: f64| beside(t, &[libm::sin(t), libm::cos(t)]);
            assert!(Series::new(slope, [0.0, 10.0]).is_err());
        }
        let constant = |_: f64| {
            let mut c = [[0.0; TERMS]; 2];
            c[1][0] = -3.0;
            c
        };
        assert!(Series::new(constant, [0.0, 10.0]).is_ok());
        assert!(Series::new(whole, [0.0, f64::NAN]).is_err());
    }

    #[test]
    fn breaks_of_both_components_are_met_in_order() {
        let pulse = |from, to| Signal::Pulse { from, to };
        let (early, late) = (pulse(1.0, 3.0), pulse(2.0, 4.0));
        for [x, y] in [[&early, &late], [&late, &early]] {
            let plane = Plane {
                x: x.clone(),
                y: y.clone(),
            };
            let breaks = [0.0, 1.0, 2.0, 3.0, 4.0].map(|t| plane.next_break(t));
            assert_eq!(breaks, [Some(1.0), Some(2.0), Some(3.0), Some(4.0), None]);
        }
        // Where one has none, those of the other are left.
        let still = || Signal::constant(1.0);
        for plane in [
            Plane {
                x: early.clone(),
                y: still(),
            },
            Plane {
                x: still(),
                y: early.clone(),
            },
        ] {
            let breaks = [0.0, 1.0, 3.0].map(|t| plane.next_break(t));
            assert_eq!(breaks, [Some(1.0), Some(3.0), None]);
        }
    }
}
