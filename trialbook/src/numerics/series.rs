//! Coefficients of Taylor series, one order at a time: in a series about t₀, `a[k]` multiplies (t − t₀)ᵏ.
//! Coefficient `k` of a result comes from those up to `k` of what goes in and those below `k` of what comes
//! out, in O(k) (Moore).

use super::number::Number;
use super::roots::falling_root;

/// A truncated series of `N` terms.
pub type Series<T, const N: usize> = [T; N];

/// The series that is constantly `value`.
pub fn constant<T: Number, const N: usize>(value: T) -> Series<T, N> {
    std::array::from_fn(|k| {
        if k == 0 {
            value.clone()
        } else {
            T::from_f64(0.0)
        }
    })
}

/// One chain of additions alone waits for its own last sum.
const LANES: usize = 4;

/// Σ a_j b_{n−1−j}, j = 0 … n−1, over two slices of equal length n; zero for n = 0. The newest coefficients
/// come last: all else can be summed before.
#[inline(always)]
pub fn convolution<T: Number>(a: &[T], b: &[T]) -> T {
    match (a, b) {
        ([a_first, a @ .., a_last], [b_first, b @ .., b_last]) => {
            let newest = a_first.clone() * b_last.clone() + a_last.clone() * b_first.clone();
            between(a, b) + newest
        }
        _ => between(a, b),
    }
}

/// In any order.
#[inline(always)]
fn between<T: Number>(a: &[T], b: &[T]) -> T {
    let (a, a_rest) = a.as_chunks::<LANES>();
    let (b_rest, b) = b.as_rchunks::<LANES>();
    let zero = T::from_f64(0.0);
    let mut sums = [zero.clone(), zero.clone(), zero.clone(), zero];
    for (x, y) in a.iter().zip(b.iter().rev()) {
        for (i, sum) in sums.iter_mut().enumerate() {
            *sum = sum.clone() + x[i].clone() * y[LANES - 1 - i].clone();
        }
    }
    for (sum, (x, y)) in sums.iter_mut().zip(a_rest.iter().zip(b_rest.iter().rev())) {
        *sum = sum.clone() + x.clone() * y.clone();
    }
    let [p, q, r, s] = sums;
    (p + q) + (r + s)
}

/// Coefficient `k` of a·b.
#[inline(always)]
pub fn product<T: Number>(a: &[T], b: &[T], k: usize) -> T {
    convolution(&a[..=k], &b[..=k])
}

/// Coefficient `k` of a².
#[inline(always)]
pub fn square<T: Number>(a: &[T], k: usize) -> T {
    symmetric(&a[..=k])
}

/// Σ a_j a_{n−1−j}, j = 0 … n−1, over a slice of length n: half the products serve twice.
#[inline(always)]
fn symmetric<T: Number>(a: &[T]) -> T {
    let n = a.len();
    let twice = convolution(&a[..n / 2], &a[n - n / 2..]);
    let sum = twice.clone() + twice;
    if n.is_multiple_of(2) {
        sum
    } else {
        sum + a[n / 2].clone() * a[n / 2].clone()
    }
}

/// Coefficient `k` of r = √a, a₀ > 0.
#[inline(always)]
pub fn sqrt<T: Number>(a: &[T], r: &[T], k: usize) -> T {
    if k == 0 {
        return a[0].sqrt();
    }
    // The inverse is ready before the sum is.
    let half = T::from_f64(0.5) / r[0].clone();
    (a[k].clone() - symmetric(&r[1..k])) * half
}

/// Σ j u_j f_{k−j} / k, j = 1 … k: the coefficient `k` of the function whose derivative is u′f. What `u`
/// lacks up to k + 1, here and in what builds on it, is zero.
#[inline(always)]
fn chain<T: Number>(u: &[T], f: &[T], k: usize) -> T {
    if let [_, slope] = u {
        return (slope.clone() * f[k - 1].clone()).over(k);
    }
    let mut sum = T::from_f64(0.0);
    let mut weight = 0.0;
    for (u, f) in u.iter().skip(1).zip(f[..k].iter().rev()) {
        weight += 1.0;
        sum = sum + T::from_f64(weight) * u.clone() * f.clone();
    }
    sum.over(k)
}

/// Coefficient `k` of s = sin u and of c = cos u.
#[inline(always)]
pub fn sin_cos<T: Number>(u: &[T], s: &[T], c: &[T], k: usize) -> (T, T) {
    if k == 0 {
        return u[0].sin_cos();
    }
    (chain(u, c, k), -chain(u, s, k))
}

/// Coefficient `k` of e = exp u.
#[inline(always)]
pub fn exp<T: Number>(u: &[T], e: &[T], k: usize) -> T {
    if k == 0 {
        return u[0].exp();
    }
    chain(u, e, k)
}

/// Coefficient `k` of p = u^`exponent`, u₀ > 0 (p′u = `exponent` u′p).
#[inline(always)]
pub fn power<T: Number>(u: &[T], exponent: f64, p: &[T], k: usize) -> T {
    if k == 0 {
        return u[0].pow(exponent);
    }
    let mut sum = T::from_f64(0.0);
    for (j, (u, p)) in (1..).zip(u[1..].iter().zip(p[..k].iter().rev())) {
        let weight = T::from_f64(exponent * f64::from(j) - (k as f64 - f64::from(j)));
        sum = sum + weight * u.clone() * p.clone();
    }
    sum.over(k) * (T::from_f64(1.0) / u[0].clone())
}

/// Value of the series at distance `t` from its centre (Horner's rule).
#[inline(always)]
pub fn value<T: Number>(a: &[T], t: &T) -> T {
    let mut sum = T::from_f64(0.0);
    for c in a.iter().rev() {
        sum = sum * t.clone() + c.clone();
    }
    sum
}

/// Value and slope at distance `t` from the centre.
pub fn value_slope(a: &[f64], t: f64) -> (f64, f64) {
    let (mut value, mut slope) = (0.0, 0.0);
    for c in a.iter().rev() {
        slope = slope * t + value;
        value = value * t + c;
    }
    (value, slope)
}

/// Value without the constant term: what the series changes over the distance `t`.
#[inline(always)]
pub fn change<T: Number>(a: &[T], t: &T) -> T {
    value(&a[1..], t) * t.clone()
}

/// [`change`] of several series at once.
#[inline(always)]
pub fn changes<T: Number, const D: usize, const N: usize>(
    series: &[Series<T, N>; D],
    t: &T,
) -> [T; D] {
    let mut sums: [T; D] = std::array::from_fn(|_| T::from_f64(0.0));
    for k in (1..N).rev() {
        for (sum, c) in sums.iter_mut().zip(series) {
            *sum = sum.clone() * t.clone() + c[k].clone();
        }
    }
    sums.map(|sum| sum * t.clone())
}

/// The distance from the centre, up to `h`, over which a series that never falls changes by `amount`: 0 or
/// `h` where it does so before or only later.
pub fn arrival(a: &[f64], amount: f64, h: f64) -> f64 {
    if amount <= 0.0 {
        return 0.0;
    }
    if change(a, &h) <= amount {
        return h;
    }
    falling_root(0.0, h, amount / a[1], |t| {
        let (mean, slope) = value_slope(&a[1..], t);
        (amount - t * mean, -(mean + t * slope))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const N: usize = 30;

    /// A polynomial without pattern, constant term 1.3, small enough that all series below converge at 0.5.
    fn sample() -> Series<f64, N> {
        let mut a = [0.0; N];
        a[..5].copy_from_slice(&[1.3, 0.2, -0.15, 0.07, 0.11]);
        a
    }

    fn close(series: &Series<f64, N>, expected: f64) {
        let found = value(series, &0.5);
        assert!(
            (found - expected).abs() < 2e-15 * expected.abs(),
            "{found} {expected}"
        );
    }

    #[test]
    fn recurrences_reproduce_the_functions() {
        let a = sample();
        let at = value(&a, &0.5);
        let b: Series<f64, N> =
            std::array::from_fn(|k| if k < 4 { 2.0 - 0.4 * k as f64 } else { 0.0 });
        let b_at = value(&b, &0.5);
        let [mut p, mut s2, mut r, mut s, mut c, mut e, mut w] = [[0.0; N]; 7];
        for k in 0..N {
            p[k] = product(&a, &b, k);
            s2[k] = square(&a, k);
            r[k] = sqrt(&a, &r, k);
            (s[k], c[k]) = sin_cos(&a, &s, &c, k);
            e[k] = exp(&a, &e, k);
            w[k] = power(&a, -1.7, &w, k);
        }
        close(&p, at * b_at);
        close(&s2, at * at);
        close(&r, libm::sqrt(at));
        close(&s, libm::sin(at));
        close(&c, libm::cos(at));
        close(&e, libm::exp(at));
        close(&w, libm::pow(at, -1.7));
        assert!((change(&a, &0.5) - (at - 1.3)).abs() < 1e-15);
    }

    #[test]
    fn a_lost_bit_is_carried() {
        let (mut sum, mut carry) = (1e16, 0.0);
        for _ in 0..1000 {
            (sum, carry) = f64::accumulate(&sum, &carry, &0.3);
        }
        assert!((sum - 1e16 + carry - 300.0).abs() < 1e-9, "{sum} {carry}");
    }
}
