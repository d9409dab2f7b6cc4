//! Numbers of twice the width: the sum of two `f64`, some 31 digits; the second half is lost below about
//! 10⁻²⁹⁰ (Dekker, Numer. Math. 18, 1971; Knuth, The Art of Computer Programming 2, 4.2.2). The bits are the
//! same on every machine.

use super::number::{Number, Real};
use crate::scalar::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::str::FromStr;
use std::sync::LazyLock;

/// A number of twice the width, `hi + lo` with `lo` at most half a unit of the last place of `hi`.
#[derive(Debug, Clone, Copy, Default, PartialEq, PartialOrd)]
pub struct Double {
    hi: f64,
    lo: f64,
}

/// a + b and what rounding took from it.
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// The same for |a| ≥ |b|.
#[inline(always)]
fn quick_sum(a: f64, b: f64) -> Double {
    let hi = a + b;
    Double {
        hi,
        lo: b - (hi - a),
    }
}

/// a·b and what rounding took from it.
#[inline(always)]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    // Halves of 26 bits, whose products are exact.
    let halves = |x: f64| {
        let large = 134_217_729.0 * x;
        let high = large - (large - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a, a_low), (b, b_low)) = (halves(a), halves(b));
    (
        product,
        ((a * b - product) + a * b_low + a_low * b) + a_low * b_low,
    )
}

impl Add for Double {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (hi, carry) = two_sum(self.hi, other.hi);
        if !hi.is_finite() {
            return hi.into();
        }
        let (low, rest) = two_sum(self.lo, other.lo);
        let Double { hi, lo } = quick_sum(hi, carry + low);
        quick_sum(hi, lo + rest)
    }
}

impl Neg for Double {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Double {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Sub for Double {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (hi, low) = two_product(self.hi, other.hi);
        if !hi.is_finite() {
            return hi.into();
        }
        quick_sum(hi, low + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for Double {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        if !(first.is_finite() && other.hi.is_finite()) {
            return first.into();
        }
        let rest = self - other * first.into();
        let second = rest.hi / other.hi;
        let rest = rest - other * second.into();
        quick_sum(first, second) + (rest.hi / other.hi).into()
    }
}

impl From<f64> for Double {
    #[inline(always)]
    fn from(hi: f64) -> Self {
        Double { hi, lo: 0.0 }
    }
}

impl From<Double> for f64 {
    #[inline(always)]
    fn from(x: Double) -> f64 {
        x.hi
    }
}

/// π, half of it, and ln 2; what they lack is below 10⁻³².
const PI: Double = Double {
    hi: std::f64::consts::PI,
    lo: 1.2246467991473532e-16,
};
const LN_2: Double = Double {
    hi: std::f64::consts::LN_2,
    lo: 2.319046813846299_6e-17,
};
const HALF_PI: [f64; 3] = [
    std::f64::consts::FRAC_PI_2,
    6.123233995736766e-17,
    -1.4973849048591833e-33,
];

/// 1/(n(n − 1)) for n = 2, 4, …, and for n = 3, 5, …
static PRODUCTS: LazyLock<[[Double; 40]; 2]> = LazyLock::new(|| {
    [2.0, 3.0].map(|first| {
        std::array::from_fn(|k| {
            let n = first + 2.0 * k as f64;
            Double::from(1.0) / (n * (n - 1.0)).into()
        })
    })
});

impl Double {
    /// 2ⁿ times the number.
    fn scaled(self, n: i32) -> Self {
        Double {
            hi: libm::ldexp(self.hi, n),
            lo: libm::ldexp(self.lo, n),
        }
    }

    /// x + x³/3!·s + x⁵/5!·s² + … or, from `first` = 0, 1 + x²/2!·s + …, until nothing changes.
    fn factorial_series(self, first: u32, sign: f64) -> Self {
        let square = self * self * sign.into();
        let mut term = if first == 0 { 1.0.into() } else { self };
        let mut sum = term;
        for inverse in PRODUCTS[first as usize].iter() {
            term = term * square * *inverse;
            sum = sum + term;
            if term.hi.abs() <= 1e-34 * sum.hi.abs() {
                break;
            }
        }
        sum
    }

    /// The number without quarter turns, and how many of them in a whole turn; of a number up to 10⁹ or so.
    fn without_quarters(self) -> (Self, u8) {
        let turns = libm::round(self.hi / HALF_PI[0]);
        if !turns.is_finite() {
            return (f64::NAN.into(), 0);
        }
        let [large, small, least] = HALF_PI.map(|part| {
            let (hi, lo) = two_product(turns, part);
            Double { hi, lo }
        });
        (self - large - small - least, turns.rem_euclid(4.0) as u8)
    }

    fn sine(self, on: u8) -> Self {
        let (rest, turns) = self.without_quarters();
        let quarters = (turns + on) % 4;
        let value = rest.factorial_series(1 - u32::from(quarters % 2), -1.0);
        if quarters < 2 { value } else { -value }
    }

    /// e^x − 1 for a small x.
    fn small_exp_m1(self) -> Self {
        let x = self.scaled(-6);
        let (mut term, mut sum) = (x, x);
        for n in 2..20 {
            term = term * x / f64::from(n).into();
            sum = sum + term;
        }
        for _ in 0..6 {
            sum = sum * sum + sum + sum;
        }
        sum
    }

    /// ln (1 + x) for 1 + x between ½ and 2.
    fn small_ln_1p(self) -> Self {
        let first = Double::from(libm::log1p(self.hi));
        let power = first.small_exp_m1();
        let off = (self - power) / (power + 1.0.into());
        first + off - off * off * 0.5.into()
    }

    /// The angle of the vector (`x`, `self`) with the x axis, in (−π, π].
    pub fn atan2(self, x: Self) -> Self {
        let first = libm::atan2(self.hi, x.hi);
        let size = (self * self + x * x).root();
        if size.hi == 0.0 || !size.hi.is_finite() {
            return first.into();
        }
        let (s, c) = Double::from(first).sin_cos();
        Double::from(first) + (self * c - x * s) / size
    }

    /// √(x² + y²).
    pub fn hypot(self, y: Self) -> Self {
        (self * self + y * y).root()
    }

    fn root(self) -> Self {
        let first = libm::sqrt(self.hi);
        if first == 0.0 || !first.is_finite() {
            return first.into();
        }
        let (hi, lo) = two_product(first, first);
        let rest = self - Double { hi, lo };
        quick_sum(first, rest.hi / (2.0 * first))
    }
}

/// A decimal number as typed. Up to fifteen digits are taken as they stand; more were most likely printed by
/// a program: that `f64`.
impl FromStr for Double {
    type Err = std::num::ParseFloatError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let near: f64 = text.parse()?;
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: String = [whole, fraction].concat();
        let significant = digits
            .trim_start_matches(['+', '-', '0'])
            .trim_end_matches('0');
        let power = exponent
            .parse::<i32>()
            .ok()
            .filter(|e| (-249..250).contains(e));
        let (Ok(digits), Some(power), true) =
            (digits.parse::<i64>(), power, significant.len() <= 15)
        else {
            return Ok(near.into());
        };
        let power = power - fraction.len() as i32;
        let ten = (0..power.unsigned_abs()).fold(1.0.into(), |x: Double, _| x * 10.0.into());
        let exact = Double::int(digits);
        let exact = if power < 0 { exact / ten } else { exact * ten };
        Ok(if exact.hi == near { exact } else { near.into() })
    }
}

impl Scalar for Double {
    fn int(n: i64) -> Self {
        let hi = n as f64;
        quick_sum(hi, (i128::from(n) - hi as i128) as f64)
    }
    fn pi() -> Self {
        PI
    }
    fn sin(self) -> Self {
        self.sine(0)
    }
    fn cos(self) -> Self {
        self.sine(1)
    }
    fn asin(self) -> Self {
        let one = Double::from(1.0);
        self.atan2(((one - self) * (one + self)).root())
    }
    fn acos(self) -> Self {
        let one = Double::from(1.0);
        ((one - self) * (one + self)).root().atan2(self)
    }
    fn sinh(self) -> Self {
        if self.hi.abs() < 1.0 {
            return self.factorial_series(1, 1.0);
        }
        let power = Scalar::exp(self);
        (power - Double::from(1.0) / power) * 0.5.into()
    }
    fn cosh(self) -> Self {
        let power = Scalar::exp(self);
        (power + Double::from(1.0) / power) * 0.5.into()
    }
    fn exp(self) -> Self {
        let twos = libm::round(self.hi / LN_2.hi);
        if twos.is_nan() || twos.abs() >= 2000.0 {
            return libm::exp(self.hi).into();
        }
        let rest = self - LN_2 * twos.into();
        (rest.small_exp_m1() + 1.0.into()).scaled(twos as i32)
    }
    fn exp_m1(self) -> Self {
        if self.hi.abs() < 0.5 {
            self.small_exp_m1()
        } else {
            Scalar::exp(self) - 1.0.into()
        }
    }
    fn exp_fall(self, k: Self) -> Self {
        if k.to_f64() == 0.0 {
            -self
        } else {
            -Scalar::exp_m1(k * self) / k
        }
    }
    fn ln(self) -> Self {
        if !(self.hi > 0.0 && self.hi.is_finite()) {
            return libm::log(self.hi).into();
        }
        let twos = if (0.5..2.0).contains(&self.hi) {
            0
        } else {
            libm::ilogb(self.hi)
        };
        let rest = (self.scaled(-twos) - 1.0.into()).small_ln_1p();
        rest + LN_2 * f64::from(twos).into()
    }
    fn ln_1p(self) -> Self {
        if self.hi > -0.5 && self.hi < 1.0 {
            self.small_ln_1p()
        } else {
            Scalar::ln(self + 1.0.into())
        }
    }
    fn sqrt(self) -> Self {
        self.root()
    }
    fn pow(self, exponent: Self) -> Self {
        let whole = exponent.lo == 0.0 && libm::trunc(exponent.hi) == exponent.hi;
        if self.hi < 0.0 && whole {
            let size = Scalar::exp(exponent * Scalar::ln(-self));
            return if exponent.hi % 2.0 == 0.0 {
                size
            } else {
                -size
            };
        }
        Scalar::exp(exponent * Scalar::ln(self))
    }
    #[cfg(feature = "trials")]
    fn nearest(self) -> Option<f64> {
        Some(self.hi)
    }
}

impl Number for Double {
    const TOLERANCE_LOG2: f64 = -112.0;

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        x.into()
    }
    #[inline(always)]
    fn magnitude(&self) -> f64 {
        self.hi.abs()
    }
    fn sqrt(&self) -> Self {
        self.root()
    }
    fn sin_cos(&self) -> (Self, Self) {
        (self.sine(0), self.sine(1))
    }
    fn exp(&self) -> Self {
        Scalar::exp(*self)
    }
    fn ln(&self) -> Self {
        Scalar::ln(*self)
    }
    fn pow(&self, exponent: f64) -> Self {
        Scalar::pow(*self, exponent.into())
    }
}

impl Real for Double {
    const ROUNDING: f64 = f64::EPSILON * f64::EPSILON;

    fn to_f64(self) -> f64 {
        self.hi
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Function, argument, value in two halves, from mpmath at 400 bits.
    #[rustfmt::skip]
    #[allow(clippy::approx_constant)]
    const VALUES: &[(&str, f64, (f64, f64))] = &[
        ("sin", 1e-20, (1e-20, -1.6666666666666664e-61)),
        ("sin", 0.3, (0.29552020666133955, 1.8315357276792536e-17)),
        ("sin", 0.7853981633974483, (0.7071067811865475, 4.1036934489363755e-17)),
        ("sin", 2.5, (0.5984721441039565, -5.521403334082375e-17)),
        ("sin", -100.25, (0.2772828564548513, 1.361336774720287e-17)),
        ("sin", 1000000000.5, (0.8807272059732143, 1.5767302074813963e-17)),
        ("cos", 1e-20, (1.0, -5e-41)),
        ("cos", 0.3, (0.955336489125606, 4.1935600297907467e-17)),
        ("cos", 1.5707963267948966, (6.123233995736766e-17, -1.4973849048591698e-33)),
        ("cos", 2.5, (-0.8011436155469337, -1.8674742705085553e-17)),
        ("cos", -100.25, (0.9607883312760612, -2.1441388741342008e-17)),
        ("asin", 1e-09, (1e-09, 1.6666666666666669e-28)),
        ("asin", 0.3, (0.3046926540153975, -2.7469740051157017e-17)),
        ("asin", -0.99, (-1.4292568534704693, -6.909416818000846e-17)),
        ("asin", 0.9999999999999999, (1.5707963118937354, 6.123233981950422e-17)),
        ("acos", 0.3, (1.2661036727794992, -7.78313736852488e-17)),
        ("acos", -0.99, (3.000053180265366, -9.171809678765519e-17)),
        ("acos", 0.9999999999999999, (1.4901161193847656e-08, 1.378634354255046e-25)),
        ("sinh", 1e-09, (1e-09, 1.6666666666666669e-28)),
        ("sinh", 0.3, (0.3045202934471426, 9.177343117072388e-18)),
        ("sinh", -3.5, (-16.542627287634996, -1.388991286007725e-15)),
        ("sinh", 40.0, (1.1769263341851e+17, -7.296050044625483)),
        ("cosh", 0.3, (1.0453385141288605, 7.371812611119388e-18)),
        ("cosh", 40.0, (1.1769263341851e+17, -7.296050044625483)),
        ("exp", 1e-18, (1.0, 1e-18)),
        ("exp", 0.3, (1.3498588075760032, -9.447314673432387e-17)),
        ("exp", -40.0, (4.248354255291589e-18, 1.2437470802645773e-34)),
        ("exp", 300.0, (1.9424263952412558e+130, 1.1143145370175699e+114)),
        ("exp_m1", 1e-18, (1e-18, 5.0000000000000005e-37)),
        ("exp_m1", 0.3, (0.3498588075760031, 1.6549155728191776e-17)),
        ("exp_m1", -0.7, (-0.5034146962085905, 9.827550225511106e-18)),
        ("exp_m1", 40.0, (2.3538526683702e+17, -15.592100089250966)),
        ("ln", 1e-30, (-69.07755278982137, -2.286179106246918e-15)),
        ("ln", 0.9999999999999999, (-1.1102230246251565e-16, -6.162975822039155e-33)),
        ("ln", 0.3, (-1.2039728043259361, 8.935521583403776e-17)),
        ("ln", 3.0, (1.0986122886681098, -9.07129723500153e-17)),
        ("ln", 1e+200, (460.51701859880916, -2.2129109272629473e-14)),
        ("ln_1p", 1e-18, (1e-18, -5.0000000000000005e-37)),
        ("ln_1p", -1e-09, (-1.0000000005000001e-09, 7.427230737157087e-26)),
        ("ln_1p", 0.4, (0.33647223662121295, -3.704625908593426e-18)),
        ("ln_1p", 5.0, (1.791759469228055, 4.349979825096335e-17)),
        ("sqrt", 2.0, (1.4142135623730951, -9.667293313452913e-17)),
        ("sqrt", 1e-30, (1e-15, -3.6037189572868085e-32)),
    ];

    fn off(found: Double, (hi, lo): (f64, f64)) -> f64 {
        ((found - Double { hi, lo }).hi / hi).abs()
    }

    #[test]
    fn functions_have_thirty_digits() {
        for &(name, x, expected) in VALUES {
            let x = Double::from(x);
            let found = match name {
                "sin" => Scalar::sin(x),
                "cos" => Scalar::cos(x),
                "asin" => Scalar::asin(x),
                "acos" => Scalar::acos(x),
                "sinh" => Scalar::sinh(x),
                "cosh" => Scalar::cosh(x),
                "exp" => Scalar::exp(x),
                "exp_m1" => Scalar::exp_m1(x),
                "ln" => Scalar::ln(x),
                "ln_1p" => Scalar::ln_1p(x),
                _ => Scalar::sqrt(x),
            };
            // Far out, or close to a zero or a branch, the argument's own width shows.
            let allowed = match name {
                "sin" | "cos" if x.hi.abs() > 1.5 => 1e-31 * x.hi.abs().max(1e17),
                "exp" => 1e-31 * x.hi.abs().max(1.0),
                _ => 5e-31,
            };
            assert!(
                off(found, expected) < allowed,
                "{name} {} {}",
                x.hi,
                off(found, expected)
            );
        }
    }

    #[test]
    fn sums_products_and_quotients_keep_what_an_f64_loses() {
        let [one, tiny] = [1.0, 1e-25].map(Double::from);
        assert_eq!(((one + tiny) - one).hi, 1e-25);
        let product = (one + tiny) * (one - tiny) - one;
        assert!(product.hi.abs() < 1e-31, "{product:?}");
        let third = one / Double::from(3.0);
        assert!((third * Double::from(3.0) - one).hi.abs() < 1e-31);
        assert_eq!(off(third, (0.3333333333333333, 1.850371707708594e-17)), 0.0);
        assert_eq!(Double::int(i64::MAX) - Double::int(i64::MAX - 1), one);
        let angle = Double::from(-1.0).atan2(Double::from(-1.0));
        assert!(off(angle, (-2.356194490192345, -9.184850993605148e-17)) < 1e-31);
        assert_eq!(Double::from(3.0).hypot(Double::from(4.0)).hi, 5.0);
    }

    #[test]
    fn short_decimals_are_taken_as_they_stand_and_long_ones_as_the_f64_they_stand_for() {
        let read = |text: &str| text.parse::<Double>().unwrap();
        let ten = Double::from(10.0);
        for (text, tenths) in [
            ("0.1", 1.0),
            ("-.3", -3.0),
            ("+7E-1", 7.0),
            ("0.00012e3", 1.2),
        ] {
            let rest = read(text) * ten - Double::from(tenths);
            let allowed = if tenths == 1.2 { 5e-17 } else { 1e-31 };
            assert!(rest.hi.abs() < allowed, "{text} {rest:?}");
        }
        assert!(read("0.999999").lo != 0.0);
        for text in ["0.7099396579167291", "2", "1e300", "1e-300", "0", "-0.5"] {
            assert_eq!(
                read(text),
                Double::from(text.parse::<f64>().unwrap()),
                "{text}"
            );
        }
        assert!("0,5".parse::<Double>().is_err() && "".parse::<Double>().is_err());
    }

    #[test]
    fn what_is_no_number_shows() {
        let [infinite, nan, zero] = [f64::INFINITY, f64::NAN, 0.0].map(Double::from);
        for x in [infinite, nan] {
            assert!(!Scalar::sin(x).hi.is_finite() && !(x * x).hi.is_finite());
            assert!(!(x + x).hi.is_finite());
        }
        assert!(!(Double::from(1.0) / zero).hi.is_finite());
        assert_eq!(Scalar::exp(Double::from(-1e4)).hi, 0.0);
        assert!(Scalar::ln(Double::from(-1.0)).hi.is_nan());
    }
}
