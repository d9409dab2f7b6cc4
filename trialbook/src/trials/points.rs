//! Where claims are tried: seeded random points of a domain, with its edges.

use std::cell::Cell;
use std::sync::atomic::{AtomicU64, Ordering};

/// The seed of every random point.
pub(crate) const SEED: u64 = 2026;

/// 0 for a usual one.
static ROUND: AtomicU64 = AtomicU64::new(0);

/// Has all points drawn from here on belong to this round; only before the first trial of a process, as what
/// trials share is made once.
pub(crate) fn set_round(round: u64) {
    ROUND.store(round, Ordering::Relaxed);
}

/// The round that is under way.
pub fn round() -> u64 {
    ROUND.load(Ordering::Relaxed)
}

thread_local! {
    /// For what points are drawn, and how many streams it has begun.
    static SEAT: Cell<Option<[u64; 2]>> = const { Cell::new(None) };
}

/// Each stream that `f` begins is the seat's own.
pub(super) fn seated<T>(seat: u64, f: impl FnOnce() -> T) -> T {
    struct Before(Option<[u64; 2]>);
    impl Drop for Before {
        fn drop(&mut self) {
            SEAT.set(self.0);
        }
    }
    let _before = Before(SEAT.replace(Some([seat, 0])));
    f()
}

pub(super) fn shared<T>(f: impl FnOnce() -> T) -> T {
    seated(0, f)
}

/// What `f` makes, of other points than it draws by itself.
pub fn others<T>(f: impl FnOnce() -> T) -> T {
    seated(1, f)
}

pub(super) fn mixed(words: impl IntoIterator<Item = u64>) -> u64 {
    let mix = |sum, word| fastrand::Rng::with_seed(sum ^ word).u64(..);
    words.into_iter().fold(SEED, mix)
}

/// Seeded random numbers. A stream is told by its trial's claim and number and by how many the trial has
/// begun; for what trials share, by the ends of every range and [`others`].
pub struct Points(fastrand::Rng);

impl Points {
    /// The next stream of what is under way on this thread.
    pub fn here() -> Self {
        let [seat, begun] = SEAT.get().unwrap_or_default();
        SEAT.set(SEAT.get().map(|_| [seat, begun + 1]));
        Points(fastrand::Rng::with_seed(mixed([seat, begun, round()])))
    }

    /// Uniform between `low` and `high`.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        // Not to the last bit, which a range that is computed owes to the machine.
        let ends = [low, high].map(|end| (end as f32).to_bits().into());
        let last = self.0.u64(..);
        self.0.seed(mixed([last].into_iter().chain(ends)));
        low + (high - low) * self.0.f64()
    }

    /// Uniform in the logarithm between two positive numbers.
    pub fn log_uniform(&mut self, low: f64, high: f64) -> f64 {
        libm::exp(self.uniform(libm::log(low), libm::log(high)))
    }

    /// So many points, each coordinate uniform between its two ends.
    pub fn within<const N: usize>(mut self, count: usize, ends: [[f64; 2]; N]) -> Vec<[f64; N]> {
        let point = |_| ends.map(|[low, high]| self.uniform(low, high));
        (0..count).map(point).collect()
    }

    /// The values of a grid as they are given; in later rounds each at random up to the next larger one.
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
    use super::{Points, others, seated, shared};

    #[test]
    fn each_place_draws_points_of_its_own_and_the_same_ones_again() {
        let draw = |ends: [f64; 2]| Points::here().within(2, [ends]);
        let two = || [draw([0.0, 1.0]), draw([0.0, 1.0])].concat();
        let made = || [two(), draw([0.0, 2.0])].concat();
        let all = || {
            let inside = || [two(), shared(made), two()].concat();
            [seated(7, inside), seated(8, two), shared(|| others(made))].concat()
        };
        let mut drawn = all();
        assert_eq!(drawn, all());
        drawn.sort_by(|a, b| a[0].total_cmp(&b[0]));
        assert!(drawn.windows(2).all(|pair| pair[0] != pair[1]), "{drawn:?}");
        // Whoever asks first.
        assert_eq!(shared(made), seated(9, || shared(made)));
        assert_eq!(two()[..2], two()[2..]);
    }

    #[test]
    fn a_grid_that_moves_stays_in_order_and_in_its_range() {
        let [c, a, d, b] = Points::here().moved(&[2.0, 0.0, 3.0, 1.0])[..] else {
            panic!("one for each");
        };
        assert!(0.0 < a && a < 1.0 && 1.0 < b && b < 2.0, "{a} {b}");
        assert!(
            2.0 < c && c < 3.0 && 2.0 < d && d < 3.0 && c != d,
            "{c} {d}"
        );
        assert_eq!(Points::here().moved(&[7.0]), [7.0]);
        assert_eq!(Points::here().grid([2.0, 0.0]), [2.0, 0.0]);
    }
}
