//! Numbers, conditions and roots as a witness has them.

use super::{
    ball::Ball,
    interval::Interval,
    jet::{Jet, over},
    taylor::Taylor,
};
use crate::exact::{Expr, folded, tree};
use crate::scalar::Scalar;
use crate::witness::{self, Number, Tree, Witness};
use dashu_int::IBig;
use dashu_int::ops::BitTest;

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
    on_grid(x, GRID)
}

/// A box about another, hardly wider, whose ends are multiples of 2⁻⁴⁴.
pub fn close_box(x: Interval) -> Interval {
    on_grid(x, GRID * 16_777_216.0)
}

fn on_grid(x: Interval, grid: f64) -> Interval {
    Interval::new(
        (x.lo() * grid).floor() / grid,
        (x.hi() * grid).ceil() / grid,
    )
}

/// Steps of short numbers in 1.
const GRID: f64 = 1_048_576.0;

/// Both ends of an interval.
pub fn ends(x: Interval) -> witness::Interval {
    (dyadic(x.lo()), dyadic(x.hi()))
}

/// A number that lies in an interval, as a formula: a decimal of few digits, or else a work number.
pub fn number(x: Interval) -> Tree {
    for digits in 0..=DECIMALS {
        let ten = 10_i64.pow(digits);
        let n = (x.mid() * ten as f64).round() as i64;
        if Interval::ratio(n, ten).meet(x).is_some() {
            return tree(folded(Expr::int(n) / Expr::int(ten), &|_| None));
        }
    }
    Tree::Leaf(dyadic(x.mid()))
}

/// Decimals of a number that is written so.
const DECIMALS: u32 = 6;

/// A decimal to six places, enclosed.
pub fn decimal(x: f64) -> Interval {
    let ten = 10_i64.pow(DECIMALS);
    Interval::ratio((x * ten as f64).round() as i64, ten)
}

/// The nearest whole multiple of 2⁻³⁰, in such units: what a value is known by.
pub fn units(x: f64) -> String {
    ((x * UNITS).round() as i64).to_string()
}

const UNITS: f64 = 1_073_741_824.0;

/// A root to as many bits as its interval tells, some left over so that rounding is certain.
pub fn rounded(x: Interval) -> String {
    let (_, exponent) = libm::frexp(x.width());
    let bits = -exponent - LEFT_OVER;
    format!("{}*2^{}", libm::ldexp(x.mid(), bits).round() as i64, -bits)
}

/// The same of a ball.
pub fn rounded_ball(x: &Ball) -> String {
    let [lo, hi] = x.bounds();
    let width = (&hi - &lo).into_parts().1;
    let off = width.bit_len() + LEFT_OVER as usize;
    let half = IBig::ONE << off;
    let n: IBig = (lo + hi + half) >> (off + 1);
    format!("{n}*2^-{}", x.bits() as i64 - off as i64)
}

const LEFT_OVER: i32 = 6;

/// What is asked of a part of a range: that a coefficient of a formula's Taylor series has a sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asked {
    pub(super) formula: Expr,
    pub(super) by: usize,
    pub(super) power: usize,
    pub(super) way: f64,
}

/// What is asked of parts: all of it, or one of it.
#[derive(Debug, Clone)]
pub enum Condition {
    /// All of these.
    All(Vec<Asked>),
    /// One of these, whichever it is.
    Any(Vec<Asked>),
}

impl From<Asked> for Condition {
    fn from(asked: Asked) -> Self {
        Condition::All(vec![asked])
    }
}

/// The parts of a range.
#[derive(Debug, Clone, Copy)]
pub enum Of {
    /// All that are left.
    Rest,
    /// Those that begin there, in the variable of this number.
    From(usize, f64),
    /// Those that end below, in the variable of this number.
    Below(usize, f64),
}

impl Of {
    pub(super) fn holds(self, cell: &[Interval]) -> bool {
        match self {
            Of::Rest => true,
            Of::From(i, at) => cell[i].lo() == at,
            Of::Below(i, at) => cell[i].hi() < at,
        }
    }

    pub(super) fn written(self) -> witness::Where {
        match self {
            Of::Rest => witness::Where::Rest,
            Of::From(i, at) => witness::Where::From(i, dyadic(at)),
            Of::Below(i, at) => witness::Where::Below(i, dyadic(at)),
        }
    }
}

/// That a function has the sign of `way`.
pub fn sign(formula: Expr, way: f64) -> Asked {
    coefficient_by(formula, 0, 0, way)
}

/// That its derivative by a variable has the sign of `way`.
pub fn slope(formula: Expr, by: usize, way: f64) -> Asked {
    coefficient_by(formula, by, 1, way)
}

/// That a coefficient of its Taylor series has the sign of `way`.
pub fn coefficient(formula: Expr, power: usize, way: f64) -> Asked {
    coefficient_by(formula, 0, power, way)
}

fn coefficient_by(formula: Expr, by: usize, power: usize, way: f64) -> Asked {
    Asked {
        formula: folded(formula, &|_| None),
        by,
        power,
        way,
    }
}

impl Asked {
    /// The coefficients up to the power that is asked for, about all points of a box.
    fn coefficients<const N: usize>(
        &self,
        names: &[&str; N],
        cell: &[Interval; N],
    ) -> Vec<Interval> {
        let place = |name: &str| names.iter().position(|known| *known == name);
        if self.power > 1 {
            let b = Taylor::<4>::variable(cell[self.by]);
            let value = self.formula.evaluate(&|name| place(name).map(|_| b));
            return value.unwrap_or(Taylor::UNKNOWN).coefficients()[..=self.power].to_vec();
        }
        let f = |x: [Jet<N>; N]| {
            let value = self.formula.evaluate(&|name| place(name).map(|i| x[i]));
            value.unwrap_or(Jet::constant(Interval::WHOLE))
        };
        let jet = over(f, cell);
        [jet.value, jet.slope[self.by]][..=self.power].to_vec()
    }

    /// Whether it is so on all of a part, as far as its formula tells.
    pub(super) fn holds<const N: usize>(&self, names: &[&str; N], cell: &[Interval; N]) -> bool {
        let all = self.coefficients(names, cell);
        all[self.power].sign() == Some(self.way)
    }

    /// As a witness has it, where this is the first part.
    pub(super) fn written<const N: usize>(
        &self,
        names: &[&str; N],
        first: &[Interval; N],
    ) -> witness::Condition {
        let middle = first.map(|x| Interval::point(x.mid()));
        let middle = self.coefficients(names, &middle);
        witness::Condition {
            formula: tree(self.formula),
            by: self.by,
            power: self.power,
            sign: if self.way < 0.0 { -1 } else { 1 },
            middle: middle.iter().map(|x| units(x.mid())).collect(),
        }
    }
}

/// Leaves what is stated and what is found, as formulas of the root that was proved last: they are the same, or the one
/// is rounded from the other.
pub fn agree(stated: Expr, found: Expr) {
    let [stated, found] = [stated, found].map(|x| tree(folded(x, &|_| None)));
    witness::last_root(|root| {
        Witness::Number(Number {
            root,
            stated,
            found,
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

    #[test]
    fn a_decimal_is_written_as_one() {
        let text = |x| serde_json::to_string(&number(x)).unwrap_or_default();
        assert_eq!(text(decimal(0.1)), r#"["/","1","10"]"#);
        assert_eq!(text(decimal(-2.0)), r#""-2""#);
        assert_eq!(text(decimal(0.3141594)), r#"["/","314159","1000000"]"#);
        let long = Interval::point(0.123_456_789);
        assert_eq!(text(long), format!("{:?}", dyadic(long.mid())));
    }

    #[test]
    fn a_root_is_rounded_to_what_is_known_of_it() {
        assert_eq!(units(-1.5), "-1610612736");
        let third = Interval::ratio(1, 3);
        let parts = |text: String| -> (f64, i32) {
            let (n, e) = text.split_once("*2^").unwrap();
            (n.parse().unwrap(), e.parse().unwrap())
        };
        let (n, e) = parts(rounded(third));
        assert!(
            (n / 3.0_f64.recip() - libm::ldexp(1.0, -e)).abs() <= 0.5 * 3.0,
            "{n} {e}"
        );
        assert!((-48..=-45).contains(&e), "{e}");
        let ball = Ball::int(1, 40).over(&Ball::int(3, 40)).unwrap();
        let (n, e) = parts(rounded_ball(&ball));
        assert!((n - libm::ldexp(1.0, -e) / 3.0).abs() <= 0.5, "{n} {e}");
        assert!((-34..=-30).contains(&e), "{e}");
    }
}
