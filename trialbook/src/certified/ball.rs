//! Balls: numbers of any length, with a radius that bounds all rounding: a whole number of units 2⁻ᵇ, b its
//! *bits*, and a radius in the same units, computed with whole numbers only.

mod elementary;

use super::interval::Interval;
use dashu_int::ops::{Abs, BitTest, SquareRoot, UnsignedAbs};
use dashu_int::{IBig, UBig};
use std::ops::{Add, Mul, Neg, Sub};

/// All real numbers within `rad` units of `mid` units, the unit being 2⁻ᵇⁱᵗˢ.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ball {
    mid: IBig,
    rad: UBig,
    bits: usize,
}

/// Bits for `digits` decimals, with a few to spare.
pub(crate) fn bits_for(digits: usize) -> usize {
    // log₂ 10 < 3.322
    digits * 3322 / 1000 + 16
}

impl Ball {
    /// The whole number `n`, exactly.
    pub fn int(n: i64, bits: usize) -> Self {
        Ball {
            mid: IBig::from(n) << bits,
            rad: UBig::ZERO,
            bits,
        }
    }

    /// An interval with finite bounds, as closely as the bits allow; `None` for others.
    pub fn enclosing(x: Interval, bits: usize) -> Option<Self> {
        let (lo, hi) = (units(x.lo(), bits)?, units(x.hi(), bits)?);
        let mid: IBig = (&lo + &hi) >> 1;
        // Bounds and middle are rounded down, by less than a unit each.
        let rad = (hi - &mid).unsigned_abs() + 2u8;
        Some(Ball { mid, rad, bits })
    }

    /// How many bits after the point it is written with.
    pub fn bits(&self) -> usize {
        self.bits
    }

    /// Bits after the point that are known, about.
    pub fn known_bits(&self) -> usize {
        self.bits.saturating_sub(self.rad.bit_len())
    }

    /// The same numbers with other bits: exact if these are more, wider by at most two units if they are fewer.
    #[must_use]
    pub fn with_bits(&self, bits: usize) -> Self {
        let (mid, rad) = match bits.checked_sub(self.bits) {
            Some(more) => (&self.mid << more, &self.rad << more),
            None => (
                &self.mid >> (self.bits - bits),
                (&self.rad >> (self.bits - bits)) + 2u8,
            ),
        };
        Ball { mid, rad, bits }
    }

    /// Its middle alone, exactly.
    #[must_use]
    pub fn middle(&self) -> Self {
        Ball {
            mid: self.mid.clone(),
            rad: UBig::ZERO,
            bits: self.bits,
        }
    }

    pub(super) fn bounds(&self) -> [IBig; 2] {
        [&self.mid - &self.rad, &self.mid + &self.rad]
    }

    /// An interval around it.
    pub fn interval(&self) -> Interval {
        // 2⁻⁹⁰ of what is left would not show in an f64 of order one; beyond 2¹⁰²³ units there is no f64.
        let size = self.mid.bit_len().max(self.rad.bit_len());
        let fit = (self.bits + 1000).saturating_sub(size);
        let narrow = self.with_bits(self.bits.min(90).min(fit));
        let [lo, hi] = narrow.bounds().map(|x| x.to_f64().value());
        let unit = libm::ldexp(1.0, -(narrow.bits as i32));
        Interval::new((lo * unit).next_down(), (hi * unit).next_up())
    }

    /// Whether all of it lies strictly inside the other one.
    pub fn inside(&self, other: &Self) -> bool {
        let bits = self.bits.max(other.bits);
        let [a, b] = self.with_bits(bits).bounds();
        let [c, d] = other.with_bits(bits).bounds();
        c < a && b < d
    }

    /// Whether the two have a number in common.
    pub fn meets(&self, other: &Self) -> bool {
        (self - other).holds_zero()
    }

    /// Whether 0 lies in it.
    pub(crate) fn holds_zero(&self) -> bool {
        self.mid.clone().unsigned_abs() <= self.rad
    }

    /// The quotient, with the bits of the dividend; `None` if the divisor may be 0.
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        if divisor.holds_zero() {
            return None;
        }
        let least = divisor.mid.clone().unsigned_abs() - &divisor.rad;
        let mid = (&self.mid << divisor.bits) / &divisor.mid;
        // |a/b − a₀/b₀| ≤ (|a − a₀| + |a₀/b₀| |b − b₀|)/|b|, and less than a unit from cutting off.
        let size = mid.clone().unsigned_abs() + 1u8;
        let miss = (&self.rad << divisor.bits) + size * &divisor.rad;
        Some(Ball {
            mid,
            rad: miss / least + 2u8,
            bits: self.bits,
        })
    }

    /// The square root; `None` if a number of the ball may be negative.
    pub fn sqrt(&self) -> Option<Self> {
        if self.mid == IBig::ZERO && self.rad == UBig::ZERO {
            return Some(self.clone());
        }
        let [lo, _] = self.bounds();
        let square = UBig::try_from(self.mid.clone()).ok()? << self.bits;
        let root = square.sqrt();
        if lo < IBig::ZERO || root == UBig::ZERO {
            return None;
        }
        // |√x − √m| ≤ |x − m|/√m
        let rad = (&self.rad << self.bits) / &root + 2u8;
        Some(Ball {
            mid: root.into(),
            rad,
            bits: self.bits,
        })
    }

    /// Its decimals, correctly rounded to `digits` after the point; `None` if it is too wide to tell.
    pub fn decimal(&self, digits: usize) -> Option<String> {
        let ten = IBig::from(10).pow(digits);
        // ⌊x 10ᵈ + 1/2⌋ at both bounds, twice over.
        let half = IBig::ONE << self.bits;
        let [lo, hi]: [IBig; 2] = self
            .bounds()
            .map(|x| (x * &ten * 2u8 + &half) >> (self.bits + 1));
        if lo != hi {
            return None;
        }
        let sign = if lo < IBig::ZERO { "-" } else { "" };
        let text = format!("{:0>width$}", lo.abs().to_string(), width = digits + 1);
        let (whole, decimals) = text.split_at(text.len() - digits);
        let point = if digits > 0 { "." } else { "" };
        Some(format!("{sign}{whole}{point}{decimals}"))
    }
}

fn units(x: f64, bits: usize) -> Option<IBig> {
    let (mantissa, exponent) = if x.is_finite() {
        libm::frexp(x)
    } else {
        return None;
    };
    // Exact: 53 bits.
    let whole = IBig::from(libm::ldexp(mantissa, 53) as i64);
    let shift = i64::try_from(bits).ok()? + i64::from(exponent) - 53;
    let size = usize::try_from(shift.unsigned_abs()).ok()?;
    Some(if shift >= 0 {
        whole << size
    } else {
        whole >> size
    })
}

impl Add for &Ball {
    type Output = Ball;
    fn add(self, other: Self) -> Ball {
        if self.bits < other.bits {
            return other + self;
        }
        let more = self.bits - other.bits;
        Ball {
            mid: &self.mid + (&other.mid << more),
            rad: &self.rad + (&other.rad << more),
            bits: self.bits,
        }
    }
}

impl Neg for &Ball {
    type Output = Ball;
    fn neg(self) -> Ball {
        Ball {
            mid: -&self.mid,
            rad: self.rad.clone(),
            bits: self.bits,
        }
    }
}

impl Sub for &Ball {
    type Output = Ball;
    fn sub(self, other: Self) -> Ball {
        self + &-other
    }
}

/// The product, with the bits of the finer operand.
impl Mul for &Ball {
    type Output = Ball;
    fn mul(self, other: Self) -> Ball {
        let coarse = self.bits.min(other.bits);
        let miss = self.mid.clone().unsigned_abs() * &other.rad
            + other.mid.clone().unsigned_abs() * &self.rad
            + &self.rad * &other.rad;
        let product = &self.mid * &other.mid;
        let exact = miss == UBig::ZERO && product.trailing_zeros().is_none_or(|n| n >= coarse);
        Ball {
            mid: product >> coarse,
            rad: if exact { miss } else { (miss >> coarse) + 2u8 },
            bits: self.bits.max(other.bits),
        }
    }
}

impl Neg for Ball {
    type Output = Ball;
    fn neg(self) -> Ball {
        -&self
    }
}

macro_rules! by_value {
    ($($operation:ident $function:ident),*) => {$(
        impl $operation for Ball {
            type Output = Ball;
            fn $function(self, other: Self) -> Ball {
                $operation::$function(&self, &other)
            }
        }
        impl $operation<&Ball> for Ball {
            type Output = Ball;
            fn $function(self, other: &Ball) -> Ball {
                $operation::$function(&self, other)
            }
        }
        impl $operation<Ball> for &Ball {
            type Output = Ball;
            fn $function(self, other: Ball) -> Ball {
                $operation::$function(self, &other)
            }
        }
    )*};
}

by_value!(Add add, Sub sub, Mul mul);

#[cfg(test)]
mod tests;
