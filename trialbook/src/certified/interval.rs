//! Intervals of real numbers between two f64, rounded outwards. Where an operation has no value it gives the
//! whole line (a quotient by numbers from 0 up, or down, has one bound), and what is unbounded stays so: a
//! [bounded](Interval::is_bounded) interval says that there is a value everywhere.

mod elementary;
mod rounding;

use rounding::{product_down, product_up, quotient_down, quotient_up, sum_down, sum_up};
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All real numbers from `lo` to `hi`; a bound may be infinite.
#[derive(Clone, Copy, PartialEq)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

/// The circle's ratio: it lies above the nearest f64.
pub const PI: Interval = Interval {
    lo: std::f64::consts::PI,
    hi: std::f64::consts::PI.next_up(),
};

impl Interval {
    /// The whole line: what is known when nothing is, not even that there is a value.
    pub const WHOLE: Interval = Interval {
        lo: f64::NEG_INFINITY,
        hi: f64::INFINITY,
    };

    /// From `lo` to `hi`; the whole line if they are in the wrong order or not numbers.
    pub fn new(lo: f64, hi: f64) -> Self {
        if lo <= hi && lo < f64::INFINITY && hi > f64::NEG_INFINITY {
            Interval { lo, hi }
        } else {
            Self::WHOLE
        }
    }

    /// The single number `x`; the whole line if it is not finite.
    pub fn point(x: f64) -> Self {
        Self::new(x, x)
    }

    /// Of a finite `x`.
    pub(super) const fn point_unchecked(x: f64) -> Self {
        Interval { lo: x, hi: x }
    }

    /// n/m, for whole numbers below 2⁵³.
    pub fn ratio(n: i64, m: i64) -> Self {
        Self::point(n as f64) / Self::point(m as f64)
    }

    /// The decimal of six places that is nearest to `x`.
    pub fn decimal(x: f64) -> Self {
        Self::ratio((x * 1e6).round() as i64, 1_000_000)
    }

    /// The lower bound.
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// The upper bound.
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// Whether both bounds are finite. If it was computed, there is a value everywhere.
    pub fn is_bounded(self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// A number inside, near the middle; zero for the whole line.
    pub fn mid(self) -> f64 {
        if self == Self::WHOLE {
            return 0.0;
        }
        let mid = 0.5 * self.lo + 0.5 * self.hi;
        mid.clamp(self.lo.max(f64::MIN), self.hi.min(f64::MAX))
    }

    /// Not less than the distance of the bounds.
    pub fn width(self) -> f64 {
        sum_up(self.hi, -self.lo)
    }

    /// The largest absolute value.
    pub fn magnitude(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// The smallest absolute value.
    pub fn mignitude(self) -> f64 {
        if self.contains(0.0) {
            0.0
        } else {
            self.lo.abs().min(self.hi.abs())
        }
    }

    /// Whether `x` lies in it.
    pub fn contains(self, x: f64) -> bool {
        self.lo <= x && x <= self.hi
    }

    /// Whether all of it lies in the other one.
    pub fn within(self, other: Self) -> bool {
        other.lo <= self.lo && self.hi <= other.hi
    }

    /// Whether all of it lies strictly inside the other one.
    pub fn inside(self, other: Self) -> bool {
        other.lo < self.lo && self.hi < other.hi
    }

    /// Whether every number in it is below every number of the other one.
    pub fn below(self, other: Self) -> bool {
        self.hi < other.lo
    }

    /// The sign, if all numbers in it have the same one and none is zero.
    pub fn sign(self) -> Option<f64> {
        if self.lo > 0.0 {
            Some(1.0)
        } else if self.hi < 0.0 {
            Some(-1.0)
        } else {
            None
        }
    }

    /// The smallest interval that contains both.
    pub fn hull(self, other: Self) -> Self {
        Self::new(self.lo.min(other.lo), self.hi.max(other.hi))
    }

    /// What both have in common; `None` if that is nothing.
    pub fn meet(self, other: Self) -> Option<Self> {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then_some(Interval { lo, hi })
    }

    /// Its two halves.
    pub fn halves(self) -> [Self; 2] {
        let mid = self.mid();
        [Self::new(self.lo, mid), Self::new(mid, self.hi)]
    }

    /// As wide as it is and `by` more at either end, for `by` ≥ 0.
    pub fn widened(self, by: f64) -> Self {
        self + Self::new(-by, by)
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Interval {
            lo: -self.hi,
            hi: -self.lo,
        }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(sum_down(self.lo, other.lo), sum_up(self.hi, other.hi))
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b, c, d) = (self.lo, self.hi, other.lo, other.hi);
        let corners = |low: [f64; 2], high: [f64; 2]| {
            Self::new(product_down(low[0], low[1]), product_up(high[0], high[1]))
        };
        // Where the products are least and greatest hangs on the signs.
        if a >= 0.0 {
            if c >= 0.0 {
                corners([a, c], [b, d])
            } else {
                corners([b, c], [if d > 0.0 { b } else { a }, d])
            }
        } else if b <= 0.0 {
            if c >= 0.0 {
                corners([a, d], [b, c])
            } else {
                corners([if d > 0.0 { a } else { b }, d], [a, c])
            }
        } else if c >= 0.0 {
            corners([a, d], [b, d])
        } else if d <= 0.0 {
            corners([b, c], [a, c])
        } else {
            Self::new(
                product_down(a, d).min(product_down(b, c)),
                product_up(a, c).max(product_up(b, d)),
            )
        }
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.lo < 0.0 {
            return if other.hi <= 0.0 {
                -self / -other
            } else {
                Self::WHOLE
            };
        }
        let (a, b, c, d) = (self.lo, self.hi, other.lo, other.hi);
        if c > 0.0 && d < f64::INFINITY {
            return Self::new(
                quotient_down(a, if a >= 0.0 { d } else { c }),
                quotient_up(b, if b >= 0.0 { c } else { d }),
            );
        }
        // Divisors from 0 up: the quotients by those that are not 0. And divisors without an upper bound.
        if a >= 0.0 && d > 0.0 {
            Self::new(quotient_down(a, d), f64::INFINITY)
        } else if b <= 0.0 && d > 0.0 {
            Self::new(f64::NEG_INFINITY, quotient_up(b, d))
        } else {
            Self::WHOLE
        }
    }
}

impl fmt::Debug for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{:e}, {:e}]", self.lo, self.hi)
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}, {}]", self.lo, self.hi)
    }
}

#[cfg(test)]
mod tests;
