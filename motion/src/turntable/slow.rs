//! The slow end of a motion that comes to rest close to ρ = 1, where friction hardly outweighs the pull.
//!
//! Close to p = w = ζ = 0 the equations of [`intrinsic`](super::intrinsic) have one fast direction, in which ζ falls
//! like e^−s, and two slow ones: p and w change at rates of their own size. After a short while ζ is a function of
//! them, ζ = −p G(w, p²), whatever it was at the beginning. Put into dζ/ds = −p − ζ + wζ, with dp/ds = −pw and
//! dw/ds = −ζ², this demands, for P = p²,
//!
//! ```text
//! G = 1 + 2wG + P G² ∂G/∂w + 2Pw ∂G/∂P,
//! ```
//!
//! which gives the coefficients of G in powers of w and P one after the other, whole numbers all of them. They grow like
//! factorials, so that the series serves only close to rest: with |w| and p below [`Width::TUBE`], terms up to [`WEIGHT`] (p and
//! w count 1, P counts 2) leave out less than the numbers can show.
//!
//! What is left are two slow equations whose series have steps as long as their own time scale: the motion that takes
//! 10¹² steps of ζ is over in a hundred.

use crate::numerics::{
    double::Double,
    number::{Number, Real},
    series::{product, square},
    taylor::System,
};
use std::sync::LazyLock;

/// Largest weight of the terms of G.
const WEIGHT: usize = 18;
/// One more than the largest power of P.
const POWERS: usize = WEIGHT / 2 + 1;

/// A width of numbers, and how close to rest it needs the slow equations.
pub trait Width: Real {
    /// The first term left out, some 10²¹ times the twentieth power of this, and what follows is below the spacing of the
    /// numbers.
    const TUBE: f64;
    /// For a place and a time of rest.
    const CLOSE: f64;
}

impl Width for f64 {
    const TUBE: f64 = 0.006;
    const CLOSE: f64 = 2e-13;
}

impl Width for Double {
    const TUBE: f64 = 0.0015;
    const CLOSE: f64 = 1e-26;
}

/// As a part of a rounding, for terms of G.
const UNSEEN: f64 = 1e-3;

/// In roundings, of ζ.
const REACHED: f64 = 16.0;

/// Of wⁱPʲ, by j and i.
static COEFFICIENTS: LazyLock<[[i128; WEIGHT + 1]; POWERS]> = LazyLock::new(|| {
    let mut g = [[0; WEIGHT + 1]; POWERS];
    let mut square = g;
    g[0][0] = 1;
    for weight in 0..=WEIGHT {
        if weight > 0 {
            for j in 0..=weight / 2 {
                let i = weight - 2 * j;
                let mut sum = if i > 0 {
                    (2 + 2 * j as i128) * g[j][i - 1]
                } else {
                    0
                };
                // Of weight − 2, so that all of it is known.
                for b in 0..j {
                    for a in 0..=i {
                        sum += square[b][a] * (i - a + 1) as i128 * g[j - 1 - b][i - a + 1];
                    }
                }
                g[j][i] = sum;
            }
        }
        for j in 0..=weight / 2 {
            let i = weight - 2 * j;
            let products = (0..=j).flat_map(|b| (0..=i).map(move |a| g[b][a] * g[j - b][i - a]));
            square[j][i] = products.sum();
        }
    }
    g
});

/// Of τ, p, w, χ and the arc length, in a time of their own, s times the size of p and w at the beginning of a step, so that no
/// coefficient leaves the range of the numbers.
pub(super) struct Slow<T> {
    coefficients: Vec<Vec<T>>,
    /// Of the coefficients of each weight.
    sizes: [f64; WEIGHT + 1],
}

impl<T: Width> Slow<T> {
    pub(super) fn new() -> Self {
        let number = |n: i128| {
            let near = n as f64;
            T::from_f64(near) + T::from_f64((n - near as i128) as f64)
        };
        let row = |(j, row): (usize, &[i128; WEIGHT + 1])| {
            row[..=WEIGHT - 2 * j].iter().map(|n| number(*n)).collect()
        };
        Self {
            coefficients: COEFFICIENTS.iter().enumerate().map(row).collect(),
            sizes: std::array::from_fn(|weight| {
                let of = |j: usize| COEFFICIENTS[j][weight - 2 * j] as f64;
                (0..=weight / 2).map(of).sum()
            }),
        }
    }

    /// ζ as far as it follows from p and w.
    pub(super) fn zeta(&self, p: T, w: T) -> T {
        let square = p * p;
        let mut sum = T::from_f64(0.0);
        for row in self.coefficients.iter().rev() {
            let inner = row
                .iter()
                .rev()
                .fold(T::from_f64(0.0), |sum, c| sum * w + *c);
            sum = sum * square + inner;
        }
        -(p * sum)
    }

    /// Where p grows, they have to last for a step.
    pub(super) fn serves(&self, p: T, w: T, zeta: T) -> bool {
        let size = if w.to_f64() < 0.0 {
            T::TUBE / 8.0
        } else {
            T::TUBE
        };
        p.magnitude() < size
            && w.magnitude() < size
            && (zeta - self.zeta(p, w)).magnitude() <= REACHED * T::ROUNDING * p.magnitude()
    }
}

/// ds by the time of the equations, the largest weight that shows, and the series of P, powers of w from the second on, the
/// stages of Horner's rule for G by the power of P, and G².
pub(super) struct Work<T> {
    pace: T,
    weight: usize,
    square: Vec<T>,
    powers: Vec<Vec<T>>,
    stages: Vec<Vec<T>>,
    g_square: Vec<T>,
}

impl<T: Number> Default for Work<T> {
    fn default() -> Self {
        Self {
            pace: T::from_f64(1.0),
            weight: WEIGHT,
            square: Vec::new(),
            powers: (2..=WEIGHT).map(|_| Vec::new()).collect(),
            stages: (0..POWERS).map(|_| Vec::new()).collect(),
            g_square: Vec::new(),
        }
    }
}

impl<T: Width, const N: usize> System<T, 5, N> for Slow<T> {
    type Work = Work<T>;

    fn begin(&self, _: &T, [_, p, w, ..]: &[T; 5], work: &mut Work<T>) {
        let size = p.magnitude().max(w.magnitude());
        work.pace = T::from_f64(libm::ldexp(1.0, -libm::ilogb(size)));
        // Within a step neither p nor w doubles.
        let shows = |weight: &usize| {
            self.sizes[*weight] * libm::pow(2.0 * size, *weight as f64) > UNSEEN * T::ROUNDING
        };
        work.weight = (2..=WEIGHT).rev().find(shows).unwrap_or(1);
        work.square.clear();
        work.g_square.clear();
        for series in work.powers.iter_mut().chain(&mut work.stages) {
            series.clear();
        }
    }

    fn derivative(&self, k: usize, x: &[[T; N]; 5], work: &mut Work<T>) -> [T; 5] {
        let [_, p, w, _, _] = x;
        work.square.push(square(p, k));
        for i in 0..work.weight - 1 {
            let (lower, rest) = work.powers.split_at_mut(i);
            let below = lower.last().map_or(&w[..], |series| series);
            rest[0].push(product(below, w, k));
        }
        for j in (0..=work.weight / 2).rev() {
            let row = &self.coefficients[j][..=work.weight - 2 * j];
            let constant = if k == 0 { row[0] } else { T::from_f64(0.0) };
            let powers = std::iter::once(&w[k]).chain(work.powers.iter().map(|series| &series[k]));
            let terms = row[1..].iter().zip(powers);
            let mut sum = terms.fold(constant, |sum, (c, power)| sum + *c * *power);
            if let Some(higher) = work.stages[j + 1..]
                .first()
                .filter(|series| !series.is_empty())
            {
                sum = sum + product(higher, &work.square, k);
            }
            work.stages[j].push(sum);
        }
        let g = &work.stages[0];
        work.g_square.push(square(g, k));
        let slopes = [
            p[k],
            -product(p, w, k),
            -product(&work.square, &work.g_square, k),
            product(p, g, k) - p[k],
            work.square[k],
        ];
        slopes.map(|slope| slope * work.pace)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_coefficients_are_those_found_by_hand() {
        // G = 1 + 2w + 4w² + 2P + 8w³ + 24wP + …: at p = 0 it is 1/(1 − 2w).
        let g = &*COEFFICIENTS;
        assert_eq!(g[0][..5], [1, 2, 4, 8, 16]);
        assert_eq!(g[1][..3], [2, 24, 176]);
        assert_eq!(g[2][0], 32);
    }
}
