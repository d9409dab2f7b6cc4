//! Taylor steps of several independent motions at once, one in each lane, each with its own step.
//!
//! Without sums with a carry: for nine digits of many motions.

use trialbook::numerics::{lanes::Lanes, series::change, taylor::System};

/// `D` components to `N` terms, of `L` motions about where they are.
#[derive(Debug, Clone)]
pub(crate) struct Batch<const D: usize, const N: usize, const L: usize> {
    series: [[Lanes<L>; N]; D],
}

impl<const D: usize, const N: usize, const L: usize> Batch<D, N, L> {
    pub(crate) fn new() -> Self {
        let series = [[Lanes::all(0.0); N]; D];
        Self { series }
    }

    pub(crate) fn set(&mut self, lane: usize, state: &[f64; D]) {
        for (x, value) in self.series.iter_mut().zip(state) {
            x[0].0[lane] = *value;
        }
    }

    pub(crate) fn lane(&self, lane: usize) -> [[f64; N]; D] {
        std::array::from_fn(|i| std::array::from_fn(|k| self.series[i][k].0[lane]))
    }

    /// For a system that does not depend on the time.
    #[inline(always)]
    pub(crate) fn expand<S: System<Lanes<L>, D, N>>(&mut self, system: &S) {
        let mut work = S::Work::default();
        for k in 0..N - 1 {
            let slope = system.derivative(k, &self.series, &mut work);
            let inverse = Lanes::all(1.0 / (k + 1) as f64);
            for (x, d) in self.series.iter_mut().zip(slope) {
                x[k + 1] = d * inverse;
            }
        }
    }

    /// As far as its last two terms are below `2^tolerance` times the largest component (at least 2⁻¹⁰⁰), to within a tenth.
    #[inline(always)]
    pub(crate) fn reach(&self, tolerance: f64) -> Lanes<L> {
        let size = self.size(0) + Lanes::all(tolerance);
        let last = (size - self.size(N - 1)) * Lanes::all(1.0 / (N - 1) as f64);
        let before = (size - self.size(N - 2)) * Lanes::all(1.0 / (N - 2) as f64);
        last.min(before).map(exp2)
    }

    /// Binary logarithm of the largest coefficient `k`.
    #[inline(always)]
    fn size(&self, k: usize) -> Lanes<L> {
        let mut largest = Lanes::all(TINY);
        for x in &self.series {
            largest = largest.max(x[k].abs());
        }
        largest.map(log2)
    }

    #[inline(always)]
    pub(crate) fn after(&self, h: &Lanes<L>) -> [Lanes<L>; D] {
        let mut states = [Lanes::all(0.0); D];
        for (state, x) in states.iter_mut().zip(&self.series) {
            *state = x[0] + change(x, h);
        }
        states
    }

    #[inline(always)]
    pub(crate) fn go(&mut self, states: &[Lanes<L>; D]) {
        for (x, state) in self.series.iter_mut().zip(states) {
            x[0] = *state;
        }
    }
}

impl<const D: usize, const N: usize, const L: usize> Default for Batch<D, N, L> {
    fn default() -> Self {
        Self::new()
    }
}

/// 2⁻¹⁰⁰: keeps the logarithms finite.
const TINY: f64 = 7.888609052210118e-31;

/// Binary logarithm to within 0.09, from the bits of a positive number.
#[inline(always)]
fn log2(x: f64) -> f64 {
    f64::from((x.to_bits() >> 32) as i32) / f64::from(1 << 20) - 1023.0
}

#[inline(always)]
fn exp2(x: f64) -> f64 {
    // `reach` asks for exponents far inside the range.
    f64::from_bits((((x + 1023.0) * f64::from(1 << 20)) as i32 as u64) << 32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::number::Number;

    /// x″ = −x as x′ = v, v′ = −x.
    struct Swing;

    impl<T: Number, const N: usize> System<T, 2, N> for Swing {
        type Work = ();

        fn begin(&self, _: &T, _: &[T; 2], (): &mut ()) {}

        fn derivative(&self, k: usize, x: &[[T; N]; 2], (): &mut ()) -> [T; 2] {
            [x[1][k].clone(), -x[0][k].clone()]
        }
    }

    #[test]
    fn each_lane_swings_at_its_own_pace_and_well() {
        let mut batch = Batch::<2, 20, 4>::new();
        let amplitudes = [1.0, 3.0, 0.01, 1e6];
        for (lane, amplitude) in amplitudes.into_iter().enumerate() {
            batch.set(lane, &[amplitude, 0.0]);
        }
        let mut time = [0.0; 4];
        for _ in 0..20 {
            batch.expand(&Swing);
            let h = batch.reach(-50.0);
            for (sum, h) in time.iter_mut().zip(h.0) {
                *sum += h;
            }
            let states = batch.after(&h);
            batch.go(&states);
        }
        for (lane, amplitude) in amplitudes.into_iter().enumerate() {
            let [x, v] = batch.lane(lane).map(|series| series[0] / amplitude);
            assert!(time[lane] > 20.0, "{}", time[lane]);
            assert!((x - libm::cos(time[lane])).abs() < 1e-12);
            assert!((v + libm::sin(time[lane])).abs() < 1e-12);
        }
    }

    #[test]
    fn rough_logarithms_are_near_and_undo_each_other() {
        for x in [1e-30, 3e-7, 0.1, 0.999, 1.0, 1.5, 2.0, 7e5] {
            assert!((log2(x) - libm::log2(x)).abs() < 0.09, "{x}");
            assert!((exp2(log2(x)) / x - 1.0).abs() < 1e-5, "{x}");
        }
    }

    #[test]
    fn a_series_that_ends_or_overflows_gives_a_finite_step() {
        let mut batch = Batch::<2, 20, 2>::new();
        batch.set(1, &[1e300, -1e300]);
        batch.expand(&Swing);
        for h in batch.reach(-50.0).0 {
            assert!(h.is_finite() && h > 0.0, "{h}");
        }
    }
}
