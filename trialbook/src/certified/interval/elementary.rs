//! Enclosures of the elementary functions, from Taylor's series with their remainders. An inverse function
//! corrects libm's value by how far the enclosed function misses: nothing depends on libm being right.

use super::rounding;
use super::{Interval, PI};
use crate::numerics::number::Number;
use crate::scalar::Scalar;

const ONE: Interval = Interval { lo: 1.0, hi: 1.0 };
const UNIT: Interval = Interval { lo: 0.0, hi: 1.0 };
const BOTH_SIDES: Interval = Interval { lo: -1.0, hi: 1.0 };

/// π/2 in two parts: 33 bits, and what is left, which is known to 53 bits more.
const HALF_PI_HIGH: f64 = 1.570_796_326_734_125_6;
const HALF_PI_LOW: Interval = Interval {
    lo: 6.077_100_506_506_192e-11_f64.next_down(),
    hi: 6.077_100_506_506_192e-11_f64.next_up(),
};

/// ln 2 in two parts, in the same way.
const LN_2_HIGH: f64 = 0.693_147_180_369_123_8;
const LN_2_LOW: Interval = Interval {
    lo: 1.908_214_929_270_587_7e-10_f64.next_down(),
    hi: 1.908_214_929_270_587_7e-10_f64.next_up(),
};

/// Arguments of the sine beyond this are not reduced: a multiple of [`HALF_PI_HIGH`] has to be exact.
const FARTHEST: f64 = 1e5;

fn int(n: u32) -> Interval {
    Interval::point(f64::from(n))
}

/// 1 − z/(m(m+1)) (1 − z/((m+2)(m+3)) (1 − …)), for 0 ≤ z < 1, with factors up to 20.
fn alternating(z: Interval, m: u32) -> Interval {
    // The bracket that is left out lies between 0 and 1.
    let mut sum = UNIT;
    for k in (m..20).step_by(2).rev() {
        sum = ONE - z * sum / int(k * (k + 1));
    }
    sum
}

fn sine_at(x: f64, quarters: f64) -> Interval {
    if x.abs() > FARTHEST {
        return BOTH_SIDES;
    }
    let n = (x * std::f64::consts::FRAC_2_PI).round();
    let turns = Interval::point(n);
    let r = Interval::point(x) - turns * Interval::point(HALF_PI_HIGH) - turns * HALF_PI_LOW;
    let z = r.squared();
    match (n + quarters).rem_euclid(4.0) as u8 {
        0 => r * alternating(z, 2),
        1 => alternating(z, 1),
        2 => -(r * alternating(z, 2)),
        _ => -alternating(z, 1),
    }
}

/// Whether a number of the form (2k + `offset`)π may lie in `x`.
fn reaches(x: Interval, offset: f64) -> bool {
    let t = (x / PI - Interval::point(offset)) / int(2);
    t.lo.ceil() <= t.hi.floor()
}

fn with_extremes(ends: Interval, top: bool, bottom: bool) -> Interval {
    let lo = if bottom { -1.0 } else { ends.lo.max(-1.0) };
    let hi = if top { 1.0 } else { ends.hi.min(1.0) };
    Interval::new(lo, hi)
}

fn any_sine(x: Interval) -> Interval {
    if x.is_bounded() {
        BOTH_SIDES
    } else {
        Interval::WHOLE
    }
}

fn sizes(x: Interval) -> Interval {
    if x == Interval::WHOLE {
        x
    } else {
        Interval::new(x.mignitude(), x.magnitude())
    }
}

fn asin_at(x: f64) -> Interval {
    if x.abs() > 0.75 {
        // asin |x| = π/2 − 2 asin √((1 − |x|)/2)
        let half = ((ONE - Interval::point(x.abs())) / int(2)).sqrt();
        let rest = asin_at(half.lo).hull(asin_at(half.hi));
        let angle = PI / int(2) - (rest + rest);
        return if x < 0.0 { -angle } else { angle };
    }
    asin_from(libm::asin(x), x)
}

/// The same of |x| ≤ 0.75, from a guess of whatever quality.
fn asin_from(guess: f64, x: f64) -> Interval {
    let guess = guess.clamp(-0.9, 0.9);
    let miss = Interval::point(x) - sine_at(guess, 0.0);
    // sin θ − sin y = (θ − y) cos η with η between θ and y, and |θ|, |y| ≤ 0.9: cos 0.9 > 0.6.
    Interval::point(guess) + miss / Interval::new(0.6, 1.0)
}

fn exp_at(x: f64) -> Interval {
    if x < -700.0 {
        return Interval::new(0.0, 1e-300);
    }
    if x > 700.0 {
        return Interval::new(1e300, f64::INFINITY);
    }
    let n = (x * std::f64::consts::LOG2_E).round();
    let twos = Interval::point(n);
    let r = Interval::point(x) - twos * Interval::point(LN_2_HIGH) - twos * LN_2_LOW;
    // eʳ = 1 + r (1 + r/2 (1 + … r/16 (1 + R))), |R| ≤ |r|/17 · e^|r| ≤ 0.06 for |r| ≤ 0.36.
    let mut sum = Interval::new(0.94, 1.06);
    for k in (1..=16).rev() {
        sum = ONE + r * sum / int(k);
    }
    sum * Interval::point(libm::ldexp(1.0, n as i32))
}

/// For x > 0.
fn ln_at(x: f64) -> Interval {
    if !(1e-290..=1e290).contains(&x) {
        return if x > 1.0 {
            Interval::new(667.0, f64::INFINITY)
        } else {
            Interval::new(f64::NEG_INFINITY, -667.0)
        };
    }
    ln_from(libm::log(x), x)
}

/// For x from 1e-290 to 1e290, from a guess of whatever quality.
fn ln_from(guess: f64, x: f64) -> Interval {
    let guess = guess.clamp(-668.0, 668.0);
    // ln x = y + ln(1 + u) with u = x e⁻ʸ − 1, and u − u² ≤ ln(1 + u) ≤ u for u ≥ −1/2.
    let u = Interval::point(x) * exp_at(-guess) - ONE;
    if u.lo < -0.5 {
        return Interval::WHOLE;
    }
    Interval::point(guess) + Interval::new((u - u.squared()).lo, u.hi)
}

/// From its values at the ends; the whole line if not all of `x` lies in its domain.
fn growing(x: Interval, domain: Interval, at: fn(f64) -> Interval) -> Interval {
    if !x.within(domain) {
        return Interval::WHOLE;
    }
    let bound = |x: f64| {
        if x.is_finite() {
            at(x)
        } else {
            Interval::WHOLE
        }
    };
    Interval::new(bound(x.lo).lo, bound(x.hi).hi)
}

impl Scalar for Interval {
    fn int(n: i64) -> Self {
        let x = n as f64;
        if n.unsigned_abs() <= 1 << 53 {
            Self::point(x)
        } else {
            Self::new(x.next_down(), x.next_up())
        }
    }
    fn pi() -> Self {
        PI
    }
    fn sin(self) -> Self {
        if self.width() >= 6.3 {
            return any_sine(self);
        }
        let ends = sine_at(self.lo, 0.0).hull(sine_at(self.hi, 0.0));
        with_extremes(ends, reaches(self, 0.5), reaches(self, -0.5))
    }
    fn cos(self) -> Self {
        if self.width() >= 6.3 {
            return any_sine(self);
        }
        let ends = sine_at(self.lo, 1.0).hull(sine_at(self.hi, 1.0));
        with_extremes(ends, reaches(self, 0.0), reaches(self, 1.0))
    }
    fn asin(self) -> Self {
        growing(self, BOTH_SIDES, asin_at)
    }
    fn acos(self) -> Self {
        PI / int(2) - Scalar::asin(self)
    }
    fn sinh(self) -> Self {
        let at = |x: f64| {
            let x = Interval::point(x);
            (Scalar::exp(x) - Scalar::exp(-x)) / int(2)
        };
        growing(self, Self::WHOLE, at)
    }
    fn cosh(self) -> Self {
        let at = |x: f64| {
            let x = Interval::point(x);
            (Scalar::exp(x) + Scalar::exp(-x)) / int(2)
        };
        growing(sizes(self), Self::WHOLE, at)
    }
    fn exp(self) -> Self {
        growing(self, Self::WHOLE, exp_at)
    }
    fn ln(self) -> Self {
        growing(self, Self::new(f64::MIN_POSITIVE, f64::INFINITY), ln_at)
    }
    fn sqrt(self) -> Self {
        if self.lo < 0.0 {
            return Self::WHOLE;
        }
        Self::new(rounding::sqrt(self.lo)[0], rounding::sqrt(self.hi)[1])
    }
    /// The whole line unless the base is positive, though whole powers of other numbers exist.
    fn pow(self, exponent: Self) -> Self {
        Scalar::exp(exponent * Scalar::ln(self))
    }
    fn squared(self) -> Self {
        let sizes = sizes(self);
        sizes * sizes
    }
}

/// So that the Taylor integrator's recurrences run on intervals.
impl Number for Interval {
    fn from_f64(x: f64) -> Self {
        Self::point(x)
    }
    fn magnitude(&self) -> f64 {
        Interval::magnitude(*self)
    }
    fn sqrt(&self) -> Self {
        Scalar::sqrt(*self)
    }
    fn sin_cos(&self) -> (Self, Self) {
        (Scalar::sin(*self), Scalar::cos(*self))
    }
    fn exp(&self) -> Self {
        Scalar::exp(*self)
    }
    fn ln(&self) -> Self {
        Scalar::ln(*self)
    }
    fn pow(&self, exponent: f64) -> Self {
        Scalar::pow(*self, Self::point(exponent))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bad_guess_costs_width_and_nothing_else() {
        let holds = |of: Interval, from: Interval| {
            // The one at the guess itself is narrow.
            assert!(of.width() < 1e-12 && from.meet(of).is_some(), "{from} {of}");
            from.lo <= of.hi && of.lo <= from.hi && from.width() > of.width()
        };
        for off in [-0.3, -0.05, -1e-3, 1e-3, 0.05, 0.3] {
            for x in [-0.75, -0.5, -0.1, 0.0, 0.2, 0.6, 0.75] {
                let right = libm::asin(x);
                assert!(
                    holds(asin_from(right, x), asin_from(right + off, x)),
                    "{x} {off}"
                );
            }
            for x in [1e-200, 0.3, 1.0, 2.0, 1e250] {
                let right = libm::log(x);
                assert!(
                    holds(ln_from(right, x), ln_from(right + off, x)),
                    "{x} {off}"
                );
            }
        }
        // Farther off nothing is known, or next to nothing.
        assert_eq!(ln_from(1.0, 1.0), Interval::WHOLE);
        assert!(asin_from(-0.9, 0.75).contains(0.848_062_078_981_481));
    }

    #[test]
    fn the_bounds_of_a_slope_are_those_between_the_ends() {
        // At ±0.9, the farthest that a guess is taken, the cosine is above 0.6; at 0 it is 1.
        assert!(Scalar::cos(Interval::point(0.9)).lo > 0.6);
        let both = asin_from(0.9, 0.0);
        assert!(
            both.contains(0.0) && asin_from(-0.9, 0.0).contains(0.0),
            "{both}"
        );
    }
}
