//! A function of one variable with its Taylor coefficients about every point of a box.

use super::interval::Interval;
use crate::numerics::series::{constant, product, sin_cos};
use crate::scalar::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The coefficients f⁽ᵏ⁾/k!, k < `N`, enclosed for all points of a box at once.
///
/// If f and its first n − 1 derivatives are zero at the end e, then f(x) = cₙ (x − e)ⁿ with a cₙ from the
/// n-th coefficient (Lagrange's remainder).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taylor<const N: usize>([Interval; N]);

impl<const N: usize> Taylor<N> {
    /// The variable itself, on a box.
    pub fn variable(cell: Interval) -> Self {
        Taylor(std::array::from_fn(|k| match k {
            0 => cell,
            1 => Interval::int(1),
            _ => Interval::int(0),
        }))
    }

    /// The coefficients.
    pub fn coefficients(self) -> [Interval; N] {
        self.0
    }

    fn built(mut next: impl FnMut(&[Interval; N], usize) -> Interval) -> Self {
        let mut built = [Interval::int(0); N];
        for k in 0..N {
            built[k] = next(&built, k);
        }
        Taylor(built)
    }

    fn sine_and_cosine(self) -> [Self; 2] {
        let mut cosine = [Interval::int(0); N];
        let sine = Self::built(|sine, k| {
            let (s, c) = sin_cos(&self.0, sine, &cosine, k);
            cosine[k] = c;
            s
        });
        [sine, Taylor(cosine)]
    }

    /// Of a function whose series is not known here.
    pub const UNKNOWN: Self = Taylor([Interval::WHOLE; N]);
}

impl<const N: usize> Neg for Taylor<N> {
    type Output = Self;
    fn neg(self) -> Self {
        Taylor(self.0.map(Interval::neg))
    }
}

impl<const N: usize> Add for Taylor<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::built(|_, k| self.0[k] + other.0[k])
    }
}

impl<const N: usize> Sub for Taylor<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::built(|_, k| self.0[k] - other.0[k])
    }
}

impl<const N: usize> Mul for Taylor<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::built(|_, k| product(&self.0, &other.0, k))
    }
}

impl<const N: usize> Div for Taylor<N> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        // The quotient's coefficient k is still zero in the product.
        Self::built(|quotient, k| (self.0[k] - product(quotient, &other.0, k)) / other.0[0])
    }
}

impl<const N: usize> Scalar for Taylor<N> {
    fn int(n: i64) -> Self {
        Taylor(constant(Interval::int(n)))
    }
    fn pi() -> Self {
        Taylor(constant(Interval::pi()))
    }
    fn sin(self) -> Self {
        let [sine, _] = self.sine_and_cosine();
        sine
    }
    fn cos(self) -> Self {
        let [_, cosine] = self.sine_and_cosine();
        cosine
    }
    fn asin(self) -> Self {
        Self::UNKNOWN
    }
    fn acos(self) -> Self {
        Self::UNKNOWN
    }
    fn sinh(self) -> Self {
        Self::UNKNOWN
    }
    fn cosh(self) -> Self {
        Self::UNKNOWN
    }
    fn exp(self) -> Self {
        Self::UNKNOWN
    }
    fn ln(self) -> Self {
        Self::UNKNOWN
    }
    fn sqrt(self) -> Self {
        Self::UNKNOWN
    }
    fn pow(self, _: Self) -> Self {
        Self::UNKNOWN
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_series_come_out() {
        let x = Taylor::<5>::variable(Interval::int(0));
        let f = (x.sin() + x.cos()) / (Taylor::int(1) - x) - x * x;
        // 1, 1 + 1, 2 − 1/2 − 1, 3/2 − 1/6, 4/3 + 1/24, about 0.
        for (found, (n, m)) in
            f.coefficients()
                .into_iter()
                .zip([(1, 1), (2, 1), (1, 2), (4, 3), (11, 8)])
        {
            assert!(
                found.meet(Interval::ratio(n, m)).is_some(),
                "{found} {n}/{m}"
            );
            assert!(found.width() < 1e-14, "{found}");
        }
    }

    #[test]
    fn a_box_contains_its_points() {
        let f = |x: Taylor<4>| (x * x).sin() / (x + Taylor::int(2));
        let on_box = f(Taylor::variable(Interval::new(0.5, 0.625))).coefficients();
        for i in 0..=8 {
            let x = Interval::point(0.5 + f64::from(i) / 64.0);
            let at = f(Taylor::variable(x)).coefficients();
            for (one, all) in at.into_iter().zip(on_box) {
                assert!(one.within(all), "{one} {all}");
            }
        }
        assert_eq!(
            f(Taylor::variable(Interval::int(0)).ln()).coefficients()[3],
            Interval::WHOLE
        );
    }

    #[test]
    fn no_coefficient_is_bounded_of_what_has_no_value_somewhere() {
        let [zero, one] = [0, 1].map(Taylor::<4>::int);
        for cell in [
            Interval::new(0.0, 1.0),
            Interval::new(-1.0, 1.0),
            Interval::int(0),
        ] {
            let x = Taylor::variable(cell);
            let nowhere = one / x;
            for f in [
                nowhere,
                -nowhere,
                nowhere.sin(),
                nowhere.cos(),
                nowhere * zero,
                x.ln() * zero,
                one / nowhere,
            ] {
                assert!(
                    f.coefficients().iter().all(|c| !c.is_bounded()),
                    "{cell}: {f:?}"
                );
            }
        }
    }
}
