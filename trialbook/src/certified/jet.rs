//! A function with its slopes, enclosed: a formula evaluated on jets is differentiated on the way.

use super::interval::Interval;
use crate::scalar::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The value of a function of `N` variables on a box and its derivatives; unknown where it has no value
/// somewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet<const N: usize> {
    /// The values.
    pub value: Interval,
    /// The derivatives.
    pub slope: [Interval; N],
}

const ZERO: Interval = Interval::point_unchecked(0.0);
const ONE: Interval = Interval::point_unchecked(1.0);

impl<const N: usize> Jet<N> {
    /// A constant.
    pub fn constant(value: Interval) -> Self {
        Jet {
            value,
            slope: [ZERO; N],
        }
    }

    /// The variables themselves, on a box.
    pub fn variables(cell: &[Interval; N]) -> [Self; N] {
        std::array::from_fn(|i| {
            let mut jet = Self::constant(cell[i]);
            jet.slope[i] = ONE;
            jet
        })
    }

    fn chain(self, value: Interval, derivative: Interval) -> Self {
        let derivative = if value == Interval::WHOLE {
            value
        } else {
            derivative
        };
        Jet {
            value,
            slope: self.slope.map(|s| s * derivative),
        }
    }

    fn joined(self, other: Self, value: Interval, by: [Interval; 2]) -> Self {
        let [a, b] = by;
        Jet {
            value,
            slope: std::array::from_fn(|i| self.slope[i] * a + other.slope[i] * b),
        }
    }
}

impl<const N: usize> Neg for Jet<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.value, -ONE)
    }
}

impl<const N: usize> Add for Jet<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.joined(other, self.value + other.value, [ONE, ONE])
    }
}

impl<const N: usize> Sub for Jet<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.joined(other, self.value - other.value, [ONE, -ONE])
    }
}

impl<const N: usize> Mul for Jet<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.joined(other, self.value * other.value, [other.value, self.value])
    }
}

impl<const N: usize> Div for Jet<N> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        self.joined(
            other,
            quotient,
            [ONE / other.value, -quotient / other.value],
        )
    }
}

impl<const N: usize> Scalar for Jet<N> {
    fn int(n: i64) -> Self {
        Self::constant(Interval::int(n))
    }
    fn pi() -> Self {
        Self::constant(Interval::pi())
    }
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }
    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }
    fn asin(self) -> Self {
        let derivative = ONE / (ONE - self.value.squared()).sqrt();
        self.chain(self.value.asin(), derivative)
    }
    fn acos(self) -> Self {
        let derivative = -ONE / (ONE - self.value.squared()).sqrt();
        self.chain(self.value.acos(), derivative)
    }
    fn sinh(self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }
    fn cosh(self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }
    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }
    fn ln(self) -> Self {
        self.chain(self.value.ln(), ONE / self.value)
    }
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        self.chain(value, ONE / (value + value))
    }
    fn pow(self, exponent: Self) -> Self {
        (exponent * self.ln()).exp()
    }
    fn squared(self) -> Self {
        self.chain(self.value.squared(), self.value + self.value)
    }
}

/// Value and slopes of a function on a box, the value narrowed by the slopes: f(box) ⊂ f(m) + f′(box)(box − m).
pub fn over<const N: usize>(f: impl Fn([Jet<N>; N]) -> Jet<N>, cell: &[Interval; N]) -> Jet<N> {
    let mut jet = f(Jet::variables(cell));
    let middle = cell.map(|x| Interval::point(x.mid()));
    let mut value = f(middle.map(Jet::constant)).value;
    for i in 0..N {
        value = value + jet.slope[i] * (cell[i] - middle[i]);
    }
    // Both contain the true values, so that they have some in common.
    jet.value = jet.value.meet(value).unwrap_or(jet.value);
    jet
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn all<S: Scalar>([x, y]: [S; 2]) -> S {
        (x * y).sin().exp() / (y.squared() + S::int(1)).sqrt()
            + x.asin() * y.acos()
            + x.pow(y) * (x - y).cosh()
            - (x.cos() + S::pi()).ln() * y.sinh()
    }

    fn formulas<S: Scalar>(x: S) -> [S; 17] {
        let [one, two, three] = [1, 2, 3].map(S::int);
        [
            x.sin(),
            x.cos(),
            x.tan(),
            x.asin(),
            x.acos(),
            x.sinh(),
            x.cosh(),
            x.exp(),
            x.ln(),
            x.sqrt(),
            x.squared(),
            x.pow(three / two),
            x.pow(x),
            two / x,
            x / (x - one),
            x.asin().sin(),
            x.ln().cos() * S::int(0),
        ]
    }

    proptest! {
        #[test]
        fn no_slope_is_told_of_what_has_no_value_and_others_bound_the_differences(
            lo in prop_oneof![-3.0..3.0, -1.1..1.1, prop::sample::select(&[-1.0, 0.0, 1.0][..])],
            width in prop_oneof![Just(0.0), 0.0..0.1, 0.0..4.0],
            parts in prop::array::uniform2(0.0..1.0),
        ) {
            let cell = Interval::new(lo, lo + width);
            let [a, b] = parts.map(|part: f64| Interval::point((lo + part * width).min(cell.hi())));
            let (values, [at_a, at_b]) = (formulas(cell), [a, b].map(formulas));
            let [x] = Jet::variables(&[cell]);
            for (i, jet) in formulas(x).into_iter().enumerate() {
                let ([slope], value) = (jet.slope, over(|[x]| formulas(x)[i], &[cell]).value);
                prop_assert!(values[i] == jet.value && value.within(jet.value), "{i} on {cell}");
                prop_assert!(jet.value != Interval::WHOLE || slope == Interval::WHOLE, "{i} on {cell}: {jet:?}");
                for one in [at_a[i], at_b[i]] {
                    prop_assert!(one.meet(value).is_some(), "{i} on {cell}: {value}, but {one}");
                    prop_assert!(one.is_bounded() || !value.is_bounded(), "{i} on {cell}: {value}");
                }
                // The mean value theorem.
                let change = at_b[i] - at_a[i];
                prop_assert!(change.meet(slope * (b - a)).is_some(), "{i} on {cell}: {slope} and {change}");
            }
        }
    }

    #[test]
    fn a_box_contains_its_points() {
        let cell = [Interval::new(0.2, 0.3), Interval::new(0.4, 0.5)];
        let jet = over(all, &cell);
        for k in 0..100 {
            let at = [
                0.2 + 0.001 * f64::from(k),
                0.5 - 0.001 * f64::from(k * k % 100),
            ];
            let one = over(all, &at.map(Interval::point));
            assert!(one.value.within(jet.value.widened(1e-14)));
            assert!(
                one.slope
                    .iter()
                    .zip(jet.slope)
                    .all(|(a, b)| a.within(b.widened(1e-14)))
            );
        }
        assert!(jet.value.width() < 1.0);
    }
}
