//! The one vocabulary of numbers that both sides share. A formula of the paper is written once, generic over
//! [`Scalar`], and is then a number (`f64`) or a syntax tree (`exact::Expr`).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, or something that stands for one.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The whole number `n`.
    fn int(n: i64) -> Self;
    /// The circle's ratio π.
    fn pi() -> Self;
    /// Sine; the angle in radians.
    fn sin(self) -> Self;
    /// Cosine; the angle in radians.
    fn cos(self) -> Self;
    /// Inverse sine, in [−π/2, π/2].
    fn asin(self) -> Self;
    /// Inverse cosine, in [0, π].
    fn acos(self) -> Self;
    /// Hyperbolic sine.
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    fn cosh(self) -> Self;
    /// Exponential function.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// `self` to the power `exponent`.
    fn pow(self, exponent: Self) -> Self;

    /// e^x − 1, where the number can tell it from zero.
    fn exp_m1(self) -> Self {
        self.exp() - Self::int(1)
    }
    /// ln (1 + x), where the number can tell it from zero.
    fn ln_1p(self) -> Self {
        (Self::int(1) + self).ln()
    }
    /// Tangent; the angle in radians.
    fn tan(self) -> Self {
        self.sin() / self.cos()
    }
    /// Cotangent; the angle in radians.
    fn cot(self) -> Self {
        self.cos() / self.sin()
    }
    /// Hyperbolic tangent.
    fn tanh(self) -> Self {
        self.sinh() / self.cosh()
    }
    /// Hyperbolic cotangent.
    fn coth(self) -> Self {
        self.cosh() / self.sinh()
    }
    /// The work number nearest to it; `None` if it stands for none.
    #[cfg(feature = "trials")]
    fn nearest(self) -> Option<f64> {
        None
    }
    /// (1 − eᵏˣ)/k, where the number can tell k from zero also there: −x.
    fn exp_fall(self, k: Self) -> Self {
        (Self::int(1) - (k * self).exp()) / k
    }
    /// `self` times itself.
    fn squared(self) -> Self {
        self * self
    }
}

/// Work numbers. The elementary functions are libm's, so that a result has the same bits everywhere.
impl Scalar for f64 {
    fn int(n: i64) -> Self {
        n as f64
    }
    fn pi() -> Self {
        std::f64::consts::PI
    }
    fn sin(self) -> Self {
        libm::sin(self)
    }
    fn cos(self) -> Self {
        libm::cos(self)
    }
    fn asin(self) -> Self {
        libm::asin(self)
    }
    fn acos(self) -> Self {
        libm::acos(self)
    }
    fn sinh(self) -> Self {
        libm::sinh(self)
    }
    fn cosh(self) -> Self {
        libm::cosh(self)
    }
    fn exp(self) -> Self {
        libm::exp(self)
    }
    fn ln(self) -> Self {
        libm::log(self)
    }
    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }
    fn pow(self, exponent: Self) -> Self {
        libm::pow(self, exponent)
    }
    fn exp_m1(self) -> Self {
        libm::expm1(self)
    }
    fn ln_1p(self) -> Self {
        libm::log1p(self)
    }
    fn exp_fall(self, k: Self) -> Self {
        if k == 0.0 {
            -self
        } else {
            -libm::expm1(k * self) / k
        }
    }
    #[cfg(feature = "trials")]
    fn nearest(self) -> Option<f64> {
        Some(self)
    }
    fn tan(self) -> Self {
        libm::tan(self)
    }
    fn tanh(self) -> Self {
        libm::tanh(self)
    }
}
