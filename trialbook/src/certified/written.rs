//! Numbers, conditions and roots as a witness has them.

use super::ball::Ball;
use super::interval::Interval;
use crate::exact::{Expr, tree};
use crate::witness::{self, Condition, Number, Tree, Witness};

/// A number exactly, as `m*2^e`.
pub fn dyadic(x: f64) -> String {
    let (mantissa, exponent) = libm::frexp(x);
    // Exact: 53 bits.
    let mut whole = libm::ldexp(mantissa, 53) as i64;
    let mut exponent = i64::from(exponent) - 53;
    if whole == 0 {
        return "0".into();
    }
    let zeros = whole.trailing_zeros();
    whole >>= zeros;
    exponent += i64::from(zeros);
    format!("{whole}*2^{exponent}")
}

/// A number of so few digits that each counts: a multiple of 2⁻²⁰.
pub fn short(x: f64) -> f64 {
    (x * GRID).round() / GRID
}

/// A box about another whose ends have as few digits.
pub fn short_box(x: Interval) -> Interval {
    Interval::new(
        (x.lo() * GRID).floor() / GRID,
        (x.hi() * GRID).ceil() / GRID,
    )
}

/// Steps of short numbers in 1.
const GRID: f64 = 1_048_576.0;

/// Both ends of an interval.
pub fn ends(x: Interval) -> witness::Interval {
    (dyadic(x.lo()), dyadic(x.hi()))
}

/// Both ends of a ball.
pub fn ends_of_ball(x: &Ball) -> witness::Interval {
    let [lo, hi] = x.bounds();
    let text = |n| format!("{n}*2^-{}", x.bits());
    (text(lo), text(hi))
}

/// A work number as a leaf of a formula.
pub fn number(x: f64) -> Tree {
    Tree::Leaf(dyadic(x))
}

fn sign_of(way: f64) -> i32 {
    if way < 0.0 { -1 } else { 1 }
}

/// That a function has the sign of `way`.
pub fn sign(f: Expr, way: f64) -> Condition {
    Condition::Sign(tree(f), sign_of(way))
}

/// That its derivative by a variable has the sign of `way`.
pub fn slope(f: Expr, by: usize, way: f64) -> Condition {
    Condition::Slope(tree(f), by, sign_of(way))
}

/// That a coefficient of its Taylor series has the sign of `way`.
pub fn coefficient(f: Expr, power: usize, way: f64) -> Condition {
    Condition::Coefficient(tree(f), power, sign_of(way))
}

/// Leaves what is stated and what is found, as formulas of the root that was proved last.
pub fn agree(stated: Expr, found: Expr, within: Expr) {
    witness::last_root(|root| {
        Witness::Number(Number {
            root,
            stated: tree(stated),
            found: tree(found),
            within: tree(within),
        })
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_exactly() {
        for (x, text) in [
            (0.0, "0"),
            (1.0, "1*2^0"),
            (-0.75, "-3*2^-2"),
            (f64::MIN_POSITIVE / 4.0, "1*2^-1024"),
            (f64::MAX, "9007199254740991*2^971"),
        ] {
            assert_eq!(dyadic(x), text);
        }
    }
}
