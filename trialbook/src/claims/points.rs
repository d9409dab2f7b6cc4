//! Where claims are tried: seeded random points of a domain, with its edges.

use std::sync::atomic::{AtomicU64, Ordering};

/// The seed of every random point, so that a run can be repeated.
pub const SEED: u64 = 2026;

/// The round of a deep run: 0 for a usual one.
static ROUND: AtomicU64 = AtomicU64::new(0);

/// Has all points drawn from here on belong to the round of this number, each round elsewhere. What trials share is made
/// once, so this comes before the first trial of a process or not at all.
pub fn set_round(round: u64) {
    ROUND.store(round, Ordering::Relaxed);
}

/// The round that is under way.
pub fn round() -> u64 {
    ROUND.load(Ordering::Relaxed)
}

/// Seeded random numbers; `stream` keeps the trials' points apart.
pub struct Points(fastrand::Rng);

impl Points {
    /// The stream of this number.
    pub fn stream(stream: u64) -> Self {
        // An odd number spreads the rounds over all seeds.
        let round = round().wrapping_mul(0x9e37_79b9_7f4a_7c15);
        Points(fastrand::Rng::with_seed(SEED ^ (stream << 32) ^ round))
    }

    /// Uniform between `low` and `high`.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.f64()
    }

    /// Uniform in the logarithm between `low` and `high`, both positive.
    pub fn log_uniform(&mut self, low: f64, high: f64) -> f64 {
        libm::exp(self.uniform(libm::log(low), libm::log(high)))
    }

    /// So many points, each coordinate uniform between its two ends.
    pub fn within<const N: usize>(mut self, count: usize, ends: [[f64; 2]; N]) -> Vec<[f64; N]> {
        let point = |_| ends.map(|[low, high]| self.uniform(low, high));
        (0..count).map(point).collect()
    }

    /// −1 or 1.
    pub fn sign(&mut self) -> f64 {
        if self.0.bool() { 1.0 } else { -1.0 }
    }
}
