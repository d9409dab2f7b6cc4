//! π and the elementary functions, to any number of bits.

use super::Ball;
use crate::certified::{interval::Interval, root::refine};
use crate::scalar::Scalar;
use dashu_int::ops::{BitTest, SquareRoot, UnsignedAbs};
use dashu_int::{IBig, UBig};

/// Of arguments from 2 to the power of this on, the sine and the cosine are not told.
const LARGEST: usize = 32;

/// Likewise for the exponential function.
const LARGEST_POWER: usize = 10;

impl Ball {
    /// π, by the series of the Chudnovskys, 1/π = 12 Σ (−1)ᵏ (6k)! (13591409 + 545140134 k) / ((3k)! k!³
    /// 640320^(3k+3/2)).
    pub fn pi(bits: usize) -> Self {
        // Terms alternate and fall by more than 2⁴⁷ each: what is left out is below the first one left out.
        let terms = (bits / 47 + 2) as u64;
        let [_, q, t] = chudnovsky(1, terms);
        let work = bits + 32;
        let root: UBig = (UBig::from(10005u32) << (2 * work)).sqrt();
        let sum = &q * 13_591_409u32 + t;
        let mid: IBig = (IBig::from(root) * q * 426_880u32 / sum) >> (work - bits);
        Ball {
            mid,
            rad: UBig::from(2u8),
            bits,
        }
    }

    /// The sine and the cosine.
    pub fn sin_cos(&self) -> [Self; 2] {
        // x is halved so often that few terms are left, and the angle doubled as often.
        let size = self
            .mid
            .clone()
            .unsigned_abs()
            .bit_len()
            .saturating_sub(self.bits);
        if size > LARGEST {
            let anything = Ball {
                mid: IBig::ZERO,
                rad: UBig::ONE << self.bits,
                bits: self.bits,
            };
            return [anything.clone(), anything];
        }
        let halvings = (self.bits as f64).sqrt() as usize / 3 + 3 + size;
        let work = self.bits + 2 * halvings + 16;
        let (mut s, mut miss) = sine_of_small(&self.mid << (work - self.bits - halvings), work);
        let one = IBig::ONE << work;
        // The cosine is above 0.9, so that its error is less than that of the sine, and one unit.
        let square = (&one << work) - &s * &s;
        let mut c = IBig::from(square.unsigned_abs().sqrt());
        miss += 1u8;
        for _ in 0..halvings {
            // sin 2x = 2 sin x cos x, cos 2x = 1 − 2 sin² x: errors grow by less than 4, and a unit is cut off.
            let double = (&s * &c) >> (work - 1);
            c = &one - ((&s * &s) >> (work - 1));
            s = double;
            miss = (miss << 2) + 2u8;
        }
        let extra = work - self.bits;
        // Neither changes faster than the angle.
        let rad = (miss >> extra) + &self.rad + 2u8;
        [s, c].map(|value| Ball {
            mid: value >> extra,
            rad: rad.clone(),
            bits: self.bits,
        })
    }

    /// The inverse sine; `None` unless the ball lies between −1 and 1 and not too close to them, or is one.
    pub fn asin(&self) -> Option<Self> {
        let one = Self::int(1, self.bits);
        if *self == one || *self == -&one {
            let right_angle = Self::pi(self.bits + 1).over(&Self::int(2, self.bits))?;
            let right_angle = right_angle.with_bits(self.bits);
            return Some(if *self == one {
                right_angle
            } else {
                -right_angle
            });
        }
        let middle = self.middle();
        // asin x − asin m = (x − m)/√(1 − y²) with a y between m and x.
        let steepest = (&one - self * self).sqrt()?;
        let spread = (self - &middle).over(&steepest)?;
        // The root θ of sin θ − m, from a box that is surely wide enough.
        let equation = |theta: &Ball| {
            let [s, c] = theta.sin_cos();
            Some([s - &middle, c])
        };
        let near = middle.interval();
        let start = Scalar::asin(near).widened(1e-3 * (1.0 - near.magnitude()));
        let angle = refine(equation, start, self.bits).ok()?;
        Some(if self.rad == UBig::ZERO {
            angle
        } else {
            angle + spread
        })
    }

    /// The exponential function; `None` for a ball that is wider than 1 or reaches 2¹⁰.
    pub fn exp(&self) -> Option<Self> {
        let one = UBig::ONE << self.bits;
        let size = self.mid.clone().unsigned_abs().bit_len();
        let size = size.saturating_sub(self.bits);
        if size > LARGEST_POWER || self.rad > one {
            return None;
        }
        // x is halved so often that few terms are left, and the result squared as often; it is below 2 to the growth.
        let halvings = (self.bits as f64).sqrt() as usize / 3 + 3 + size;
        let growth = (3 << size) / 2 + 2;
        let extra = halvings + growth + 16;
        let work = self.bits + extra;
        let (mut e, mut miss) = exponential_of_small(&self.mid << (extra - halvings), work);
        for _ in 0..halvings {
            // |x² − e²| ≤ (2e + |x − e|) |x − e|, and a unit is cut off.
            miss = (((&e * 2u8 + &miss) * &miss) >> work) + 2u8;
            e = (&e * &e) >> work;
        }
        let mid = e >> extra;
        let rad = (miss >> extra) + 2u8;
        // |exp x − exp m| ≤ 2 exp m |x − m| as far as 1.
        let spread = ((&mid + &rad) * 2u8 * &self.rad) >> self.bits;
        Some(Ball {
            mid: mid.into(),
            rad: rad + spread + 1u8,
            bits: self.bits,
        })
    }

    /// The natural logarithm; `None` unless all of the ball is positive.
    pub fn ln(&self) -> Option<Self> {
        if self.bounds()[0] <= IBig::ZERO {
            return None;
        }
        let work = self.bits + 16;
        let root = |x: &Ball, start: Interval| {
            let equation = |y: &Ball| y.exp().map(|e| [&e - x, e]);
            refine(equation, start, work).ok()
        };
        // The middle is 2ᵏ y, with y from 1/2 to 1.
        let length = self.mid.clone().unsigned_abs().bit_len();
        let k = length as i64 - self.bits as i64;
        let y = Ball {
            mid: self.mid.clone(),
            rad: UBig::ZERO,
            bits: length,
        };
        let y = y.with_bits(work.max(length));
        let of_y = root(&y, Scalar::ln(y.interval()).widened(1e-3))?;
        let of_2 = root(&Self::int(2, work), Interval::new(0.69, 0.7))?;
        let of_middle = (of_y + Self::int(k, work) * of_2).with_bits(self.bits);
        // ln x − ln m = (x − m)/z with a z between m and x.
        Some(of_middle + (self - &self.middle()).over(self)?)
    }

    /// n/m; `None` for m = 0.
    pub fn ratio(n: i64, m: i64, bits: usize) -> Option<Self> {
        Self::int(n, bits).over(&Self::int(m, bits))
    }
}

/// Of the terms from `a` up to `b`: their sum is T/Q, and the next one has the factor P/Q.
fn chudnovsky(a: u64, b: u64) -> [IBig; 3] {
    if b - a == 1 {
        let k = IBig::from(a);
        let p = IBig::from(6 * a - 5) * (2 * a - 1) * (6 * a - 1);
        let q = &k * &k * &k * 10_939_058_860_032_000_u64;
        let t = &p * (k * 545_140_134u32 + 13_591_409u32);
        return [p, q, if a % 2 == 1 { -t } else { t }];
    }
    let middle = a.midpoint(b);
    let ([p, q, t], [p2, q2, t2]) = (chudnovsky(a, middle), chudnovsky(middle, b));
    let t = t * &q2 + &p * t2;
    [p * p2, q * q2, t]
}

/// Of t in units 2⁻ʷᵒʳᵏ, below 1/4; and by how many units it may be off.
fn sine_of_small(t: IBig, work: usize) -> (IBig, UBig) {
    let square = (&t * &t) >> work;
    let (mut sum, mut term) = (t.clone(), t);
    let mut k = 1u32;
    while term != IBig::ZERO && term != IBig::NEG_ONE {
        term = -((term * &square) >> work) / ((k + 1) * (k + 2));
        sum += &term;
        k += 2;
    }
    // Each term is off by less than two units, what is left out by less than the last term and its error.
    (sum, UBig::from(k + 4))
}

/// Of t in units 2⁻ʷᵒʳᵏ, below 1/8; and by how many units it may be off.
fn exponential_of_small(t: IBig, work: usize) -> (UBig, UBig) {
    let (mut sum, mut term) = (IBig::ONE << work, IBig::ONE << work);
    let mut k = 1u32;
    while term != IBig::ZERO {
        term = ((term * &t) >> work) / k;
        sum += &term;
        k += 1;
    }
    // Each term is off by less than two units, and so is all that is left out.
    (sum.unsigned_abs(), UBig::from(2 * k + 2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sine_of_a_small_angle_is_off_by_few_units_for_each_term() {
        // t = 1/16: five terms t²ⁿ⁺¹/(2n + 1)! are above 2⁻⁶⁴, and each is off by less than two units.
        let (_, miss) = sine_of_small(IBig::ONE << 60, 64);
        assert!(
            miss >= UBig::from(10u8) && miss <= UBig::from(16u8),
            "{miss}"
        );
        let (sine, miss) = sine_of_small(IBig::ZERO, 64);
        assert!(sine == IBig::ZERO && miss <= UBig::from(5u8), "{miss}");
    }
}
