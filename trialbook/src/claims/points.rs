//! Where claims are tried: seeded random points of a domain, with its edges.

/// The seed of every random point, so that a run can be repeated.
pub const SEED: u64 = 2026;

/// Seeded random numbers; `stream` keeps the trials' points apart.
pub struct Points(fastrand::Rng);

impl Points {
    /// The stream of this number.
    pub fn stream(stream: u64) -> Self {
        Points(fastrand::Rng::with_seed(SEED ^ (stream << 32)))
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
