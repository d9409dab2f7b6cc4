//! Coefficients of Taylor series, one order at a time.
//!
//! A series about t₀ is a slice of coefficients: `a[k]` multiplies (t − t₀)ᵏ. Each function returns the
//! coefficient `k` of its result from the coefficients up to `k` of what goes in and those below `k` of what
//! comes out; called for k = 0, 1, 2, … it costs O(k) each time, O(N²) in all (automatic differentiation in
//! the sense of Moore, as in the integrators TIDES and heyoka).

use super::number::Number;

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

/// Σ a_j b_{n−1−j}, j = 0 … n−1, over two slices of equal length n; zero for n = 0.
#[inline(always)]
pub fn convolution<T: Number>(a: &[T], b: &[T]) -> T {
    // Two chains of additions, since one alone waits for its own last sum.
    let mut even = T::from_f64(0.0);
    let mut odd = T::from_f64(0.0);
    let mut pairs = a.iter().zip(b.iter().rev());
    while let Some((x, y)) = pairs.next() {
        even = even + x.clone() * y.clone();
        if let Some((x, y)) = pairs.next() {
            odd = odd + x.clone() * y.clone();
        }
    }
    even + odd
}

/// Coefficient `k` of a·b.
#[inline(always)]
pub fn product<T: Number>(a: &[T], b: &[T], k: usize) -> T {
    convolution(&a[..=k], &b[..=k])
}

/// Coefficient `k` of a².
#[inline(always)]
pub fn square<T: Number>(a: &[T], k: usize) -> T {
    if k == 0 {
        return a[0].clone() * a[0].clone();
    }
    let half = k.div_ceil(2);
    let twice = convolution(&a[..half], &a[k + 1 - half..=k]);
    let sum = twice.clone() + twice;
    if k.is_multiple_of(2) {
        sum + a[k / 2].clone() * a[k / 2].clone()
    } else {
        sum
    }
}

/// Coefficient `k` of q = a/b, b₀ ≠ 0.
pub fn quotient<T: Number>(a: &[T], b: &[T], q: &[T], k: usize) -> T {
    (a[k].clone() - convolution(&b[1..=k], &q[..k])) / b[0].clone()
}

/// Coefficient `k` of r = √a, a₀ > 0.
pub fn sqrt<T: Number>(a: &[T], r: &[T], k: usize) -> T {
    if k == 0 {
        return a[0].sqrt();
    }
    let known = convolution(&r[1..k], &r[1..k]);
    (a[k].clone() - known) / (r[0].clone() + r[0].clone())
}

/// Σ j u_j f_{k−j} / k, j = 1 … k: the coefficient `k` of the function whose derivative is u′f.
fn chain<T: Number>(u: &[T], f: &[T], k: usize) -> T {
    let mut sum = T::from_f64(0.0);
    for j in 1..=k {
        sum = sum + T::from_f64(j as f64) * u[j].clone() * f[k - j].clone();
    }
    sum / T::from_f64(k as f64)
}

/// Coefficient `k` of s = sin u and of c = cos u.
pub fn sin_cos<T: Number>(u: &[T], s: &[T], c: &[T], k: usize) -> (T, T) {
    if k == 0 {
        return u[0].sin_cos();
    }
    (chain(u, c, k), -chain(u, s, k))
}

/// Coefficient `k` of e = exp u.
pub fn exp<T: Number>(u: &[T], e: &[T], k: usize) -> T {
    if k == 0 {
        return u[0].exp();
    }
    chain(u, e, k)
}

/// Coefficient `k` of p = u^`exponent`, u₀ > 0 (p′u = `exponent` u′p).
pub fn power<T: Number>(u: &[T], exponent: f64, p: &[T], k: usize) -> T {
    if k == 0 {
        return u[0].pow(exponent);
    }
    let mut sum = T::from_f64(0.0);
    for j in 1..=k {
        let weight = T::from_f64(exponent * j as f64 - (k - j) as f64);
        sum = sum + weight * u[j].clone() * p[k - j].clone();
    }
    sum / (T::from_f64(k as f64) * u[0].clone())
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

/// Value without the constant term: what the series changes over the distance `t`.
#[inline(always)]
pub fn change<T: Number>(a: &[T], t: &T) -> T {
    value(&a[1..], t) * t.clone()
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
        let [mut p, mut s2, mut q, mut r, mut s, mut c, mut e, mut w] = [[0.0; N]; 8];
        for k in 0..N {
            p[k] = product(&a, &b, k);
            s2[k] = square(&a, k);
            q[k] = quotient(&b, &a, &q, k);
            r[k] = sqrt(&a, &r, k);
            (s[k], c[k]) = sin_cos(&a, &s, &c, k);
            e[k] = exp(&a, &e, k);
            w[k] = power(&a, -1.7, &w, k);
        }
        close(&p, at * b_at);
        close(&s2, at * at);
        close(&q, b_at / at);
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
