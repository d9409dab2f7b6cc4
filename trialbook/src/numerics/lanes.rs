//! Several numbers that go through the same arithmetic at once, one in each lane of a vector register; the
//! bits of each are those of a single `f64`.

use super::number::Number;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `L` numbers side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Lanes<const L: usize>(pub [f64; L]);

impl<const L: usize> Lanes<L> {
    /// The same number in every lane.
    #[inline(always)]
    pub fn all(x: f64) -> Self {
        Lanes([x; L])
    }

    /// `f` of every lane.
    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        // A loop, since closures within library functions are not compiled for the wide registers.
        let mut out = [0.0; L];
        for (out, x) in out.iter_mut().zip(self.0) {
            *out = f(x);
        }
        Lanes(out)
    }

    /// `f` of every pair of lanes.
    #[inline(always)]
    pub fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut out = [0.0; L];
        for (out, (x, y)) in out.iter_mut().zip(self.0.into_iter().zip(other.0)) {
            *out = f(x, y);
        }
        Lanes(out)
    }

    /// Absolute value of every lane.
    #[inline(always)]
    pub fn abs(self) -> Self {
        self.map(f64::abs)
    }

    /// The larger of every pair of lanes; not that which is no number.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        self.with(
            other,
            #[inline(always)]
            |a, b| if a > b { a } else { b },
        )
    }

    /// The smaller of every pair of lanes.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        self.with(
            other,
            #[inline(always)]
            |a, b| if a < b { a } else { b },
        )
    }
}

impl<const L: usize> Add for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl<const L: usize> Sub for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl<const L: usize> Mul for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl<const L: usize> Div for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(other, |a, b| a / b)
    }
}

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl<const L: usize> Number for Lanes<L> {
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self::all(x)
    }
    /// The largest over the lanes.
    fn magnitude(&self) -> f64 {
        let sizes = self.0.iter().map(Number::magnitude);
        // A lane that is no number shows.
        sizes.fold(0.0, |a, b| if a.is_nan() || a > b { a } else { b })
    }
    fn sqrt(&self) -> Self {
        self.map(|x| Number::sqrt(&x))
    }
    fn sin_cos(&self) -> (Self, Self) {
        let both = self.0.map(|x| Number::sin_cos(&x));
        (Lanes(both.map(|b| b.0)), Lanes(both.map(|b| b.1)))
    }
    fn exp(&self) -> Self {
        self.map(|x| Number::exp(&x))
    }
    fn ln(&self) -> Self {
        self.map(|x| Number::ln(&x))
    }
    fn pow(&self, exponent: f64) -> Self {
        self.map(|x| Number::pow(&x, exponent))
    }
    #[inline(always)]
    fn over(&self, n: usize) -> Self {
        self.map(
            #[inline(always)]
            |x| Number::over(&x, n),
        )
    }
}

/// Work that gains from wide registers. Whatever in `call` is not inlined, as closures in library functions
/// are not, is compiled for the narrow ones.
pub trait Wide {
    /// What comes out.
    type Output;
    /// Does the work where a register holds `WIDTH` numbers; to be marked `#[inline(always)]`.
    fn call<const WIDTH: usize>(self) -> Self::Output;
}

/// Does the work in code for the widest registers of this machine; the bits are the same on all.
// The only place: the compiler cannot know what the machine has.
#[allow(unsafe_code)]
pub fn widest<W: Wide>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    {
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        fn by_eight<W: Wide>(work: W) -> W::Output {
            work.call::<8>()
        }
        #[target_feature(enable = "avx2")]
        fn by_four<W: Wide>(work: W) -> W::Output {
            work.call::<4>()
        }
        let has_eight = is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512vl");
        if has_eight {
            // SAFETY: the machine has what the function is compiled for.
            return unsafe { by_eight(work) };
        }
        if is_x86_feature_detected!("avx2") {
            // SAFETY: as above.
            return unsafe { by_four(work) };
        }
    }
    work.call::<2>()
}

#[cfg(test)]
mod tests {
    use super::*;

    const X: Lanes<4> = Lanes([1.5, -0.3, 0.0, 1e300]);
    const Y: Lanes<4> = Lanes([0.2, 7.0, 4.0, -1e300]);

    #[test]
    fn every_lane_is_computed_as_a_single_number() {
        let pairs = [
            (X + Y, [1.7, 6.7, 4.0, 0.0]),
            (X - Y, [1.3, -7.3, -4.0, 2e300]),
            (X * Y, [1.5 * 0.2, -0.3 * 7.0, 0.0, f64::NEG_INFINITY]),
            (X / Y, [7.5, -0.3 / 7.0, 0.0, -1.0]),
            (-X, [-1.5, 0.3, 0.0, -1e300]),
            (X.abs(), [1.5, 0.3, 0.0, 1e300]),
            (X.max(Y), [1.5, 7.0, 4.0, 1e300]),
            (X.min(Y), [0.2, -0.3, 0.0, -1e300]),
            (X.abs().sqrt(), [1.5, 0.3, 0.0, 1e300].map(libm::sqrt)),
            (
                Lanes([0.1, 0.2, 0.3, 0.4]).exp(),
                [0.1, 0.2, 0.3, 0.4].map(libm::exp),
            ),
        ];
        for (found, expected) in pairs {
            assert_eq!(found.0, expected);
        }
        let (s, c) = Y.sin_cos();
        assert_eq!(s.0, Y.0.map(libm::sin));
        assert_eq!(c.0, Y.0.map(libm::cos));
        assert_eq!(X.abs().ln().0[0], libm::log(1.5));
        assert_eq!(X.abs().pow(0.3).0[1], libm::pow(0.3, 0.3));
    }

    #[test]
    fn the_largest_lane_is_the_magnitude_and_nan_shows() {
        assert_eq!(X.magnitude(), 1e300);
        assert!(Lanes([1.0, f64::NAN, 2.0]).magnitude().is_nan());
    }
}
