//! A number that counts the places of a formula, and makes a mistake at one of them.

use super::{
    Mistake, Parts, Place,
    mistake::{SEED, begin, pass},
};
use crate::scalar::Scalar;
use std::f64::consts::FRAC_1_SQRT_2;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number on its way through a formula.
#[derive(Debug, Clone, Copy)]
pub struct Seeded<'a, S> {
    value: S,
    argument: Option<(usize, &'a [S])>,
}

/// The value of a formula, with the mistake seeded on this thread.
pub fn evaluate<'a, S: Scalar, V: Parts<Seeded<'a, S>>, R: Parts<S>>(
    arguments: &'a [S],
    written: impl FnOnce(&mut dyn FnMut() -> Seeded<'a, S>) -> V,
) -> R {
    begin();
    let mut given = arguments.iter().enumerate().map(|(i, value)| Seeded {
        value: *value,
        argument: Some((i, arguments)),
    });
    let value = written(&mut || given.next().expect("one for each argument"));
    let part = SEED.get().and_then(|seed| seed.mistake.part(arguments));
    let mut parts = Vec::with_capacity(V::COUNT);
    value.lay(&mut parts);
    let mut parts = parts.into_iter().map(|value| {
        let value = value.read();
        part.map_or(value, |part| value + value / S::int(part))
    });
    R::of(&mut || parts.next().expect("as many as were written"))
}

impl<S: Scalar> Seeded<'_, S> {
    fn read(self) -> S {
        let Some((i, arguments)) = self.argument else {
            return self.value;
        };
        match pass(Place::Argument(i)) {
            None => self.value,
            Some(Mistake::Sign) => -self.value,
            Some(Mistake::Factor) => S::int(2) * self.value,
            Some(Mistake::Symbol(other)) => arguments[other],
            Some(Mistake::More) => self.value.squared(),
            // None of these is made here.
            Some(Mistake::Less | Mistake::Branch(_) | Mistake::Part(_) | Mistake::Corner(..)) => {
                self.value
            }
        }
    }

    fn from(value: S, more: Option<&dyn Fn() -> S>, less: Option<&dyn Fn() -> S>) -> Self {
        let can = [more, less].map(|instead| instead.is_some());
        let instead = match pass(Place::Operation(can)) {
            Some(Mistake::Sign) => Some(-value),
            Some(Mistake::Factor) => Some(S::int(2) * value),
            Some(Mistake::More) => more.map(|more| more()),
            Some(Mistake::Less) => less.map(|less| less()),
            _ => None,
        };
        Seeded {
            value: instead.unwrap_or(value),
            argument: None,
        }
    }

    /// `other` is its value on the other branch.
    fn inverse(self, f: fn(S) -> S, more: fn(S) -> S, other: impl Fn(S) -> S) -> Self {
        let x = self.read();
        let value = f(x);
        let upper = || x.nearest().map(|x| x.abs() > FRAC_1_SQRT_2);
        let value = match pass(Place::Inverse) {
            Some(Mistake::Sign) => -value,
            Some(Mistake::Factor) => S::int(2) * value,
            Some(Mistake::More) => more(x),
            Some(Mistake::Branch(half)) if upper() == Some(half) => other(value),
            _ => value,
        };
        Seeded {
            value,
            argument: None,
        }
    }

    fn call(self, f: fn(S) -> S, more: Option<fn(S) -> S>) -> Self {
        let x = self.read();
        match more {
            Some(g) => Self::from(f(x), Some(&|| g(x)), None),
            None => Self::from(f(x), None, None),
        }
    }
}

impl<S: Scalar> Add for Seeded<'_, S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::from(self.read() + other.read(), None, None)
    }
}

impl<S: Scalar> Sub for Seeded<'_, S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::from(self.read() - other.read(), None, None)
    }
}

impl<S: Scalar> Mul for Seeded<'_, S> {
    type Output = Self;
    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "the mistake is made on purpose"
    )]
    fn mul(self, other: Self) -> Self {
        let (x, y) = (self.read(), other.read());
        Self::from(x * y, Some(&|| x / y), None)
    }
}

impl<S: Scalar> Div for Seeded<'_, S> {
    type Output = Self;
    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "the mistake is made on purpose"
    )]
    fn div(self, other: Self) -> Self {
        let (x, y) = (self.read(), other.read());
        Self::from(x / y, Some(&|| x * y), None)
    }
}

impl<S: Scalar> Neg for Seeded<'_, S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::from(-self.read(), None, None)
    }
}

impl<S: Scalar> Scalar for Seeded<'_, S> {
    fn int(n: i64) -> Self {
        Self::from(S::int(n), Some(&|| S::int(n + 1)), Some(&|| S::int(n - 1)))
    }
    fn pi() -> Self {
        Self::from(S::pi(), Some(&|| S::pi().squared()), Some(&|| S::int(1)))
    }
    fn sin(self) -> Self {
        self.call(S::sin, Some(S::cos))
    }
    fn cos(self) -> Self {
        self.call(S::cos, Some(S::sin))
    }
    fn asin(self) -> Self {
        self.inverse(S::asin, S::acos, |value| S::pi() - value)
    }
    fn acos(self) -> Self {
        self.inverse(S::acos, S::asin, |value| -value)
    }
    fn sinh(self) -> Self {
        self.call(S::sinh, Some(S::cosh))
    }
    fn cosh(self) -> Self {
        self.call(S::cosh, Some(S::sinh))
    }
    fn exp(self) -> Self {
        self.call(S::exp, None)
    }
    fn ln(self) -> Self {
        self.call(S::ln, None)
    }
    fn sqrt(self) -> Self {
        self.call(S::sqrt, Some(|x| x))
    }
    fn pow(self, exponent: Self) -> Self {
        let (x, n) = (self.read(), exponent.read());
        Self::from(
            x.pow(n),
            Some(&|| x.pow(n + S::int(1))),
            Some(&|| x.pow(-n)),
        )
    }
    fn exp_fall(self, k: Self) -> Self {
        let (x, n) = (self.read(), k.read());
        let (more, less) = (|| x.exp_fall(n + S::int(1)), || x.exp_fall(-n));
        Self::from(x.exp_fall(n), Some(&more), Some(&less))
    }
    fn tan(self) -> Self {
        self.call(S::tan, Some(S::cot))
    }
    fn cot(self) -> Self {
        self.call(S::cot, Some(S::tan))
    }
    fn tanh(self) -> Self {
        self.call(S::tanh, Some(S::coth))
    }
    fn coth(self) -> Self {
        self.call(S::coth, Some(S::tanh))
    }
    fn squared(self) -> Self {
        let x = self.read();
        Self::from(x.squared(), Some(&|| x.squared() * x), Some(&|| x))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Corner, Mistake, Place, Seed, Symbol, formulas, places, with};
    use crate::scalar::Scalar;

    const SYMBOLS: &[Symbol] = &[Symbol {
        topic: "",
        argument: "v",
        plain: "v",
        parts: &["v_x", "v_y"],
        latex: "v",
        meaning: "velocity",
        unit: "length/time",
        claim: "",
    }];

    formulas! {

    symbols SYMBOLS;

    pub fn energy<S: Scalar>(m: S, v: [S; 2]) -> S {
        m * (v[0].squared() + v[1].squared()) / S::int(2)
    }

    pub fn angle<S: Scalar>(m: S) -> S {
        m.asin()
    }

    }

    fn seed(place: usize, mistake: Mistake) -> Seed {
        let formula = formulas::<f64>()[0].path;
        Seed {
            formula,
            place,
            mistake,
        }
    }

    #[test]
    fn a_mistake_is_made_in_its_place_while_it_is_seeded() {
        assert_eq!(formulas::<f64>()[0].symbols, ["m", "v_x", "v_y"]);
        let value = || energy(2.0, [3.0, 5.0]);
        for (place, mistake, wrong) in [
            (0, Mistake::Symbol(2), 25.0 + 25.0),
            (0, Mistake::More, 81.0 + 25.0),
            (3, Mistake::Sign, 9.0 - 25.0),
            (4, Mistake::Factor, 68.0),
            (6, Mistake::More, 2.0 / 34.0 / 2.0),
            (7, Mistake::More, 68.0 / 3.0),
            (7, Mistake::Less, 68.0),
            (3, Mistake::Less, 9.0 + 5.0),
            (8, Mistake::Sign, -34.0),
            (9, Mistake::Sign, 34.0),
        ] {
            assert_eq!(
                with(seed(place, mistake), value),
                wrong,
                "{mistake:?} at {place}"
            );
            assert_eq!(value(), 34.0);
        }
    }

    #[test]
    fn a_mistake_of_the_value_is_made_everywhere_or_in_its_corner() {
        static HEAVY: Corner = Corner {
            letter: "m",
            low: 3.0,
            high: 9.0,
        };
        let value = |m: f64| energy(m, [3.0, 5.0]);
        let path = formulas::<f64>()[0].path;
        let seeded = |mistake, m| with(Seed::of_value(path, mistake), || value(m));
        assert_eq!(seeded(Mistake::Part(-17), 2.0), 32.0);
        let heavy = Mistake::Corner(&HEAVY, 0);
        assert_eq!(
            [2.0, 3.0, 9.0].map(|m| seeded(heavy, m)),
            [2.0, 3.0, 9.0].map(value)
        );
        assert_eq!(seeded(heavy, 4.0), 68.0 + 0.68);
    }

    #[test]
    fn an_inverse_function_takes_the_other_branch_over_half_its_range() {
        let wrong = |upper, x: f64| {
            let formula = &formulas::<f64>()[1];
            let mistake = Mistake::Branch(upper);
            let seed = formula
                .branches(&[x])
                .into_iter()
                .find(|s| s.mistake == mistake);
            with(seed.unwrap(), || angle(x))
        };
        assert_eq!(wrong(true, 0.9), f64::pi() - angle(0.9));
        assert_eq!(wrong(true, 0.5), angle(0.5));
        assert_eq!(wrong(false, 0.5), f64::pi() - angle(0.5));
        assert_eq!(wrong(false, -0.5), f64::pi() - angle(-0.5));
    }

    #[test]
    fn a_mistake_is_made_on_one_thread() {
        let value = || energy(2.0, [3.0, 5.0]);
        with(seed(8, Mistake::Factor), || {
            assert_eq!(std::thread::spawn(value).join().unwrap(), 34.0);
            assert_eq!(value(), 68.0);
        });
    }

    #[test]
    fn every_place_is_passed() {
        let formula = &formulas::<f64>()[0];
        let passed = places(formula.path, || drop((formula.value)(&[1.0, 2.0, 3.0])));
        let arguments = passed.iter().filter(|p| matches!(p, Place::Argument(_)));
        assert_eq!((passed.len(), arguments.count()), (9, 3));
    }
}
