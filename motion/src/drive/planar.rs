//! The motion with a velocity across the drive, which may become smaller than any number.
//!
//! With the velocity (w_x, w_y), w_y > 0, and w = |(w_x, w_y)|: w_x' = h − λ w_x/w, w_y' = −λ w_y/w. For tiny w_y, w_x passes
//! zero within a layer as thin as w_y. In
//!
//! - a = ln(w + w_x), b = ln(w − w_x), so that ln w_y = (a + b)/2, and
//! - the measure dσ = dφ/w of the path,
//!
//! the layer has disappeared: da/dσ = h − λ, db/dσ = −h − λ, dφ/dσ = (eᵃ + eᵇ)/2. (For w' = h w_x/w − λ, so
//! (w ± w_x)' = (±h − λ)(w ± w_x)/w.) In σ, ln w_y falls at the constant rate λ, whatever its size.
//!
//! Where both a and b are below [`DEEP`], the phase stands still to 1e-20, so a and b are linear in σ: the passage is exact. If
//! |h| ≤ λ there, both fall for ever: the particle stops, and w_y is 0 from then on.

use super::{Drive, DriveError, DriveState, Friction};
use crate::numerics::{
    NumericsError,
    piecewise::Piece,
    series::{Series, arrival, convolution, exp},
    taylor::{Control, Integrator, Step, System, TERMS},
};
use std::f64::consts::TAU;

/// Below this logarithm of the speed the phase does not advance any more.
const DEEP: f64 = -50.0;
/// Logarithms below this would soon leave the range of f64: w_y counts as 0 from there on.
const LOWEST: f64 = -1e290;
/// So that an exponential that underflows stays negligible over a step.
const LONGEST: f64 = 300.0;
/// Between two of the phases asked for, per period; a period takes about 200.
const STEPS_PER_PERIOD: f64 = 20_000.0;

/// A phase and a velocity in the plane, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanarState {
    /// The phase φ, radians.
    pub phi: f64,
    /// The velocity along the drive.
    pub w_x: f64,
    /// ln w_y; −∞ where w_y is 0 (or below about e^−1e290).
    pub ln_w_y: f64,
}

impl Drive {
    /// The states at `phases`, which must not decrease, of the motion in the plane from `start`, with isotropic friction λ.
    /// `start.ln_w_y` may lie between −1e12 and 20.
    ///
    /// # Errors
    /// A λ that is negative or no number, a bad start, phases that decrease or reach beyond 1e5 after the start.
    pub fn planar(
        &self,
        lambda: f64,
        start: PlanarState,
        phases: &[f64],
    ) -> Result<Vec<PlanarState>, DriveError> {
        let friction = Friction::new(lambda, lambda)?;
        let PlanarState { phi, w_x, ln_w_y } = start;
        DriveState { phi, w: w_x }.check()?;
        if ln_w_y != f64::NEG_INFINITY && !(-1e12..=20.0).contains(&ln_w_y) {
            return Err(DriveError::Parameter {
                name: "ln_w_y",
                allowed: "in [-1e12, 20] or -∞",
                value: ln_w_y,
            });
        }
        let mut last = phi;
        for &value in phases {
            if !(value >= last && value - phi <= 1e5) {
                return Err(DriveError::Parameter {
                    name: "phases",
                    allowed: "in increasing order, in [phi, phi + 1e5]",
                    value,
                });
            }
            last = value;
        }
        let mut flight = Flight::new(self, lambda, start);
        let mut states = Vec::with_capacity(phases.len());
        let mut at = DriveState { phi, w: w_x };
        for &phi in phases {
            if ln_w_y == f64::NEG_INFINITY {
                at = self.advance(friction, at, phi)?.end;
            } else if let Some(stop) = flight.run_to(phi)? {
                // From here on it moves on a line.
                let from = if at.phi < stop {
                    DriveState { phi: stop, w: 0.0 }
                } else {
                    at
                };
                at = self.advance(friction, from, phi)?.end;
            } else {
                let (w_x, ln_w_y) = flight.velocity();
                states.push(PlanarState { phi, w_x, ln_w_y });
                continue;
            }
            states.push(PlanarState {
                phi,
                w_x: at.w,
                ln_w_y: f64::NEG_INFINITY,
            });
        }
        Ok(states)
    }
}

/// On one piece of h; the state is (s, a, b) with s the distance from the piece's left end.
struct Layer<'p> {
    piece: &'p Piece,
    lambda: f64,
}

#[derive(Default)]
struct Work {
    exponentials: [[f64; TERMS]; 2],
    /// In powers of the distance from the begin of the step.
    h: Vec<f64>,
    /// Of the partial sums of Horner's scheme for h.
    partial: Vec<[f64; TERMS]>,
}

impl System<f64, 3, TERMS> for Layer<'_> {
    type Work = Work;

    fn begin(&self, _: &f64, [s, ..]: &[f64; 3], work: &mut Work) {
        work.h.clear();
        work.h.extend_from_slice(self.piece.coefficients());
        let last = work.h.len() - 1;
        for from in 0..last {
            for j in (from..last).rev() {
                work.h[j] += s * work.h[j + 1];
            }
        }
        // What is read of the others has been written in the same step.
        work.partial.resize(last + 1, [0.0; TERMS]);
        work.partial[last] = [0.0; TERMS];
    }

    #[inline(always)]
    fn derivative(&self, k: usize, x: &[Series<f64, TERMS>; 3], work: &mut Work) -> [f64; 3] {
        let [s, a, b] = x;
        for (e, u) in work.exponentials.iter_mut().zip([a, b]) {
            e[k] = exp(u, e, k);
        }
        if k == 0 {
            for (partial, h) in work.partial.iter_mut().zip(&work.h) {
                partial[0] = *h;
            }
        } else {
            // The distance begins with order 1: of the sum `j`, h needs only the orders up to k − j.
            let last = work.h.len() - 1;
            for j in (0..last.min(k)).rev() {
                let order = k - j;
                work.partial[j][order] = convolution(&s[1..=order], &work.partial[j + 1][..order]);
            }
        }
        let h = work.partial[0][k];
        let friction = if k == 0 { self.lambda } else { 0.0 };
        let speed = 0.5 * (work.exponentials[0][k] + work.exponentials[1][k]);
        [speed, h - friction, -h - friction]
    }
}

struct Flight<'d> {
    drive: &'d Drive,
    lambda: f64,
    /// Phase at the left end of the present piece, not reduced.
    origin: f64,
    piece: usize,
    state: [f64; 3],
    stopped: Option<f64>,
}

impl<'d> Flight<'d> {
    fn new(drive: &'d Drive, lambda: f64, start: PlanarState) -> Self {
        let (piece, s) = drive.shape().locate(start.phi.rem_euclid(TAU));
        let speed = libm::hypot(start.w_x, libm::exp(start.ln_w_y));
        // The larger of w ± w_x has no cancellation; the other follows, as their product is w_y².
        let (a, b) = if speed == 0.0 {
            (start.ln_w_y, start.ln_w_y)
        } else {
            let larger = libm::log(speed + start.w_x.abs());
            let smaller = 2.0 * start.ln_w_y - larger;
            if start.w_x >= 0.0 {
                (larger, smaller)
            } else {
                (smaller, larger)
            }
        };
        Flight {
            drive,
            lambda,
            origin: start.phi - s,
            piece,
            state: [s, a, b],
            stopped: None,
        }
    }

    /// (w_x, ln w_y).
    fn velocity(&self) -> (f64, f64) {
        let [_, a, b] = self.state;
        // 2 w_x = eᵃ − eᵇ = ± e^max (1 − e^−|a−b|).
        let size = -0.5 * libm::exp(a.max(b)) * libm::expm1(-(a - b).abs());
        (size.copysign(a - b), 0.5 * (a + b))
    }

    fn run_to(&mut self, phi: f64) -> Result<Option<f64>, DriveError> {
        let allowed = STEPS_PER_PERIOD * (1.0 + (phi - self.origin) / TAU);
        let mut steps = 0.0;
        loop {
            if self.stopped.is_some() {
                return Ok(self.stopped);
            }
            let pieces = self.drive.shape().pieces();
            let piece = &pieces[self.piece];
            let here = (phi - self.origin).min(piece.length());
            while self.state[0] < here && self.stopped.is_none() {
                self.step(piece, here)?;
                steps += 1.0;
                if steps > allowed {
                    return Err(NumericsError::Limit {
                        what: "steps of the planar motion",
                        limit: allowed as usize,
                        at: self.origin + self.state[0],
                    }
                    .into());
                }
            }
            if self.stopped.is_some() {
                continue;
            }
            if phi - self.origin < piece.length() {
                return Ok(None);
            }
            self.origin += piece.length();
            self.piece = (self.piece + 1) % pieces.len();
            self.state[0] = 0.0;
        }
    }

    fn step(&mut self, piece: &Piece, end: f64) -> Result<(), DriveError> {
        let [s, a, b] = self.state;
        if a.max(b) < DEEP {
            let h = piece.value(s);
            let (up, down) = (h - self.lambda, -h - self.lambda);
            // The growing one comes back to DEEP exactly, however far down it was.
            self.state = if up > 0.0 && a > LOWEST {
                [s, DEEP, b + down * ((DEEP - a) / up)]
            } else if down > 0.0 && b > LOWEST {
                [s, a + up * ((DEEP - b) / down), DEEP]
            } else {
                self.stopped = Some(self.origin + s);
                return Ok(());
            };
            return Ok(());
        }
        let system = Layer {
            piece,
            lambda: self.lambda,
        };
        let mut integrator = Integrator::new(&system, 0.0, self.state, Control::Each);
        let mut step = Step::empty();
        integrator.expand(&mut step)?;
        let steepest = step.series[1][1].abs().max(step.series[2][1].abs());
        // Finite, where neither drive nor friction changes anything.
        step.h = step.h.min(LONGEST / steepest.max(1e-200));
        let reaches = step.at(&step.h)[0] >= end;
        if reaches {
            step.h = arrival(&step.series[0], end - s, step.h);
        }
        integrator.advance(&step);
        self.state = *integrator.state();
        if reaches {
            self.state[0] = end;
        }
        Ok(())
    }
}

#[cfg(all(test, feature = "trials"))]
mod tests;
