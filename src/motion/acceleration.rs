//! The acceleration of the plane, as the integrator wants it: by its Taylor series about any time.

use super::signal::Signal;
use crate::numerics::taylor::TERMS;

/// Taylor coefficients of a function of time, to the order of the integrator.
pub type Coefficients = [f64; TERMS];

/// The acceleration A(t) of the plane, in length/time².
///
/// Any function or closure from the time to the coefficients of (A_x, A_y) is one, without breaks.
pub trait Acceleration: Sync {
    /// Taylor coefficients of A_x and A_y about `t`; where A jumps, those of what comes after.
    fn coefficients(&self, t: f64) -> [Coefficients; 2];

    /// The next time after `t` at which A or a derivative of it jumps. Between breaks A is analytic.
    fn next_break(&self, _t: f64) -> Option<f64> {
        None
    }
}

impl<F: Fn(f64) -> [Coefficients; 2] + Sync> Acceleration for F {
    fn coefficients(&self, t: f64) -> [Coefficients; 2] {
        self(t)
    }
}

/// An acceleration given by two signals.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// A_x, in length/time².
    pub x: Signal,
    /// A_y, in length/time².
    pub y: Signal,
}

impl Plane {
    /// The same acceleration at all times.
    pub fn constant(a: [f64; 2]) -> Self {
        Self {
            x: Signal::constant(a[0]),
            y: Signal::constant(a[1]),
        }
    }

    /// A(t) = direction · signal(t).
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
