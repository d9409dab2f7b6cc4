//! Complex numbers, for formulas with an imaginary unit.

use crate::scalar::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A complex number; roots, powers and logarithms are principal values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Complex {
    pub re: f64,
    pub im: f64,
}

impl Complex {
    pub(super) const I: Self = Complex { re: 0.0, im: 1.0 };

    /// A real number.
    pub(super) fn real(re: f64) -> Self {
        Complex { re, im: 0.0 }
    }

    fn half(self) -> Self {
        Complex {
            re: 0.5 * self.re,
            im: 0.5 * self.im,
        }
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Complex {
            re: self.re + other.re,
            im: self.im + other.im,
        }
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Complex {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

impl Div for Complex {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let square = other.re * other.re + other.im * other.im;
        let product = self
            * Complex {
                im: -other.im,
                ..other
            };
        Complex {
            re: product.re / square,
            im: product.im / square,
        }
    }
}

impl Neg for Complex {
    type Output = Self;
    fn neg(self) -> Self {
        Complex {
            re: -self.re,
            im: -self.im,
        }
    }
}

impl Scalar for Complex {
    fn nearest(self) -> Option<f64> {
        (self.im == 0.0).then_some(self.re)
    }
    fn int(n: i64) -> Self {
        Self::real(n as f64)
    }
    fn pi() -> Self {
        Self::real(f64::pi())
    }
    fn sin(self) -> Self {
        -(Self::I * (Self::I * self).sinh())
    }
    fn cos(self) -> Self {
        (Self::I * self).cosh()
    }
    fn asin(self) -> Self {
        -(Self::I * (Self::I * self + (Self::int(1) - self * self).sqrt()).ln())
    }
    fn acos(self) -> Self {
        Self::pi().half() - self.asin()
    }
    fn sinh(self) -> Self {
        (self.exp() - (-self).exp()).half()
    }
    fn cosh(self) -> Self {
        (self.exp() + (-self).exp()).half()
    }
    fn exp(self) -> Self {
        let (sine, cosine) = libm::sincos(self.im);
        let size = libm::exp(self.re);
        Complex {
            re: size * cosine,
            im: size * sine,
        }
    }
    fn ln(self) -> Self {
        Complex {
            re: libm::log(libm::hypot(self.re, self.im)),
            im: libm::atan2(self.im, self.re),
        }
    }
    fn sqrt(self) -> Self {
        if self == Self::int(0) {
            return self;
        }
        self.ln().half().exp()
    }
    fn pow(self, exponent: Self) -> Self {
        (exponent * self.ln()).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn real_arguments_give_what_real_functions_give() {
        type Pair = (fn(Complex) -> Complex, fn(f64) -> f64);
        let pairs: [Pair; 9] = [
            (Scalar::sin, Scalar::sin),
            (Scalar::cos, Scalar::cos),
            (Scalar::asin, Scalar::asin),
            (Scalar::acos, Scalar::acos),
            (Scalar::sinh, Scalar::sinh),
            (Scalar::cosh, Scalar::cosh),
            (Scalar::exp, Scalar::exp),
            (Scalar::ln, Scalar::ln),
            (Scalar::sqrt, Scalar::sqrt),
        ];
        for (complex, real) in pairs {
            let value = complex(Complex::real(0.7));
            assert!((value.re - real(0.7)).abs() < 1e-15 && value.im.abs() < 1e-15);
        }
    }

    #[test]
    fn the_unit_squared_is_minus_one_by_every_way() {
        let minus_one = Complex::int(-1);
        let ways = [
            Complex::I * Complex::I,
            (Complex::I * Complex::pi()).exp(),
            Complex::I.pow(Complex::int(2)),
            Complex::int(1) / (Complex::I * Complex::I),
            Complex::I * minus_one.sqrt(),
        ];
        for way in ways {
            let apart = way - minus_one;
            assert!(libm::hypot(apart.re, apart.im) < 1e-15, "{way:?}");
        }
    }
}
