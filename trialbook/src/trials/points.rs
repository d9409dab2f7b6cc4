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

    /// The values of a grid as they are given; in later rounds each at random between it and the next larger one, the largest
    /// between the one before and itself.
    pub fn grid(self, values: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let values = values.into_iter().collect();
        match round() {
            0 => values,
            _ => self.moved(&values),
        }
    }

    fn moved(mut self, values: &[f64]) -> Vec<f64> {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let between = |x: &f64| {
            let next = sorted.partition_point(|other| other <= x);
            let next = next.min(sorted.len() - 1);
            self.uniform(sorted[next.saturating_sub(1)], sorted[next])
        };
        values.iter().map(between).collect()
    }

    /// −1 or 1.
    pub fn sign(&mut self) -> f64 {
        if self.0.bool() { 1.0 } else { -1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::Points;

    #[test]
    fn a_grid_that_moves_stays_in_order_and_in_its_range() {
        let [c, a, d, b] = Points::stream(1).moved(&[2.0, 0.0, 3.0, 1.0])[..] else {
            panic!("one for each");
        };
        assert!(0.0 < a && a < 1.0 && 1.0 < b && b < 2.0, "{a} {b}");
        assert!(
            2.0 < c && c < 3.0 && 2.0 < d && d < 3.0 && c != d,
            "{c} {d}"
        );
        assert_eq!(Points::stream(1).moved(&[7.0]), [7.0]);
        assert_eq!(Points::stream(1).grid([2.0, 0.0]), [2.0, 0.0]);
    }
}
