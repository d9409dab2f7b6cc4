//! The motions that come straight in: starts from which the particle stops before its velocity has turned, ψ → π.
//!
//! Found by shooting: near ψ = π the angle runs away to one side or to the other; between two starts that do the one
//! and the other lies one that does neither.

use super::prelude::*;
use super::trajectories::alpha;

/// A start that comes straight in.
#[derive(Debug)]
pub struct StraightIn {
    /// ρ at the start.
    pub rho: f64,
    /// p at the start.
    pub p: f64,
    /// ψ at the start.
    pub psi: f64,
    /// The motion, past the stop.
    pub run: Run,
}

impl StraightIn {
    /// The state of least speed.
    pub fn stop(&self) -> Intrinsic {
        let slower = |a: Intrinsic, b: Intrinsic| if b.p() < a.p() { b } else { a };
        self.run.nodes().fold(self.run.end(), slower)
    }

    /// The first state with α below the given number: on the way in.
    pub fn with_alpha_below(&self, small: f64) -> Intrinsic {
        let found = self.run.nodes().find(|s| alpha(s) < small);
        found.unwrap_or_else(|| self.run.end())
    }

    /// The start in the paper's symbols.
    pub fn at(&self) -> String {
        let (a, alpha) = (
            libm::sqrt((self.rho - self.p) * (self.rho + self.p)),
            libm::atanh(self.p / self.rho),
        );
        let psi = self.psi;
        format!("A = {a:.6}, α = {alpha:.6}, ψ = {psi:.6} at the start")
    }
}

/// The time left to a stop that is near: at ψ = π the deceleration is 1 + ρ.
pub(crate) fn time_to_stop(state: &Intrinsic) -> f64 {
    state.p() / (1.0 + state.rho())
}

fn run(rho: f64, p: f64, psi: f64) -> Result<Run, MotionError> {
    Run::new(&Start::polar(rho, p, psi)?, 1.3 * p / (1.0 + rho))
}

/// The ψ between π − 0.7 and π from which a particle comes straight in.
///
/// # Errors
/// Those of the motion.
pub fn straight_in(rho: f64, p: f64) -> Result<StraightIn, MotionError> {
    let (mut low, mut high) = (PI - 0.7, PI);
    for _ in 0..52 {
        let middle = 0.5 * (low + high);
        let run = run(rho, p, middle)?;
        let turned = run.nodes().find(|s| s.parts.xi > 0.0);
        if turned.unwrap_or_else(|| run.end()).psi() > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let psi = 0.5 * (low + high);
    Ok(StraightIn {
        rho,
        p,
        psi,
        run: run(rho, p, psi)?,
    })
}

/// Starts with A > 1 that come straight in, and stop beyond ρ = 1.
pub(crate) static BEYOND_ONE: Runs<Vec<StraightIn>> = Runs::new(|| from(1.3, 2.5));

/// Starts that come straight in and stay at rest.
pub(crate) static WITHIN_ONE: Runs<Vec<StraightIn>> = Runs::new(|| from(0.02, 0.95));

fn from(nearest: f64, farthest: f64) -> Result<Vec<StraightIn>, Failure> {
    let mut points = Points::here();
    every((0..20).map(|_| {
        let rho = points.log_uniform(nearest, farthest);
        straight_in(rho, rho * points.uniform(0.05, 0.3))
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1.3 · 0.3/(1 + 2).
    #[test]
    fn motions_are_followed_past_the_stop() {
        let run = run(2.0, 0.3, PI - 0.5).unwrap();
        assert!((run.end().tau - 0.13).abs() < 1e-15);
    }

    #[test]
    fn the_stop_is_the_slowest_moment_and_its_time_is_known_before() {
        let straight = straight_in(2.0, 0.3).unwrap();
        let stop = straight.stop();
        assert!(stop.p() < 1e-4 * straight.p, "{stop:?}");
        assert!(straight.run.nodes().all(|s| s.p() >= stop.p()));
        let before = straight.with_alpha_below(1e-2);
        let left = time_to_stop(&before);
        let really = stop.tau - before.tau;
        assert!((left - really).abs() < 0.02 * really, "{left}, {really}");
    }
}
