//! Rational functions in several generators over ℚ: a numerator over a product of factors, cancelled by exact
//! division. That keeps degrees low without a greatest common divisor.

use super::polynomial::Polynomial;
use dashu_int::IBig;
use dashu_int::ops::Gcd;
use std::ops::{Add, Mul, Neg, Sub};

/// How it came about.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Made {
    #[default]
    Given,
    Read(u32),
    Formed,
}

/// A rational function: numerator / (number × product of factors to positive powers).
///
/// No operator divides: the [`Ring`](super::ring::Ring) knows whether a divisor is zero.
#[derive(Debug, Clone)]
pub struct Rational {
    numerator: Polynomial,
    number: IBig,
    /// Not constant, primitive, leading coefficient positive, powers at least 1.
    factors: Vec<(Polynomial, u32)>,
    made: Made,
}

impl Rational {
    /// A whole number.
    pub fn int(n: i64) -> Self {
        Polynomial::constant(IBig::from(n)).into()
    }

    /// The generator of this index.
    pub fn generator(index: usize) -> Self {
        Polynomial::generator(index).into()
    }

    /// The polynomial above the line.
    pub(crate) fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The factors below the line with their powers, without the number.
    pub fn factors(&self) -> &[(Polynomial, u32)] {
        &self.factors
    }

    pub(super) fn made(&self) -> Made {
        self.made
    }

    pub(super) fn made_so(self, made: Made) -> Self {
        Rational { made, ..self }
    }

    pub(super) fn formed(self) -> Self {
        self.made_so(Made::Formed)
    }

    /// However both were formed.
    pub(super) fn is_written_as(&self, other: &Rational) -> bool {
        (&self.numerator, &self.number, &self.factors)
            == (&other.numerator, &other.number, &other.factors)
    }

    /// The numerator is 0; says nothing about relations among generators.
    pub(crate) fn is_literally_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// The value, if it is a whole number.
    pub fn as_integer(&self) -> Option<IBig> {
        let whole = self.factors.is_empty() && self.number == IBig::ONE;
        whole.then(|| self.numerator.as_constant()).flatten()
    }

    /// If this is a quotient of whole numbers up to 10⁶ that have whole roots.
    pub(super) fn whole_root(&self, n: u32) -> Option<Self> {
        let root = |x: &IBig| {
            let x = i64::try_from(x.clone())
                .ok()
                .filter(|x| (0..1_000_000).contains(x))?;
            let mut candidates = (0..1000_i64).map_while(|r| Some((r, r.checked_pow(n)?)));
            let found = candidates.find(|(_, power)| *power >= x)?;
            (found.1 == x).then(|| Self::int(found.0))
        };
        let below = Some(&self.number).filter(|_| self.factors.is_empty())?;
        Some(&root(&self.numerator.as_constant()?)? * &root(below)?.reciprocal()?)
    }

    /// The coefficient of each generator, if this is a sum of multiples of 1/2 of them.
    pub(crate) fn as_halves(&self) -> Option<Vec<(usize, i64)>> {
        let twice = self + self;
        if !twice.factors.is_empty() || twice.number != IBig::ONE {
            return None;
        }
        let terms = twice.numerator.as_linear()?.into_iter();
        terms
            .map(|(g, c)| Some((g, i64::try_from(c).ok()?)))
            .collect()
    }

    /// The indices of the generators that occur.
    pub(crate) fn generators(&self) -> impl Iterator<Item = usize> {
        let below = self
            .factors
            .iter()
            .flat_map(|(f, _)| f.degrees().into_keys());
        self.numerator.degrees().into_keys().chain(below)
    }

    /// To the power `n` ≥ 0.
    pub fn pow(&self, n: u32) -> Self {
        (0..n).fold(Self::int(1), |power, _| &power * self)
    }

    /// Does not ask whether it is zero by a relation; `None` where the numerator is 0.
    pub(super) fn reciprocal(&self) -> Option<Self> {
        let rest = &self.numerator;
        if rest.is_zero() {
            return None;
        }
        let content = rest.content();
        let (monomial, rest) = rest.split_monomial();
        let mut factors: Vec<_> = monomial
            .degrees()
            .into_iter()
            .map(|(g, k)| (Polynomial::generator(g), k))
            .collect();
        let (linear, rest) = rest.split_linear();
        factors.extend(linear);
        let mut numerator = Polynomial::constant(self.number.clone());
        match rest.as_constant() {
            // The factors are primitive with positive leading coefficients: what is left over can be −1.
            Some(sign) => numerator = numerator.scale(&sign),
            None => factors.push((rest, 1)),
        }
        for (factor, k) in &self.factors {
            numerator = &numerator * &factor.pow(*k);
        }
        Some(Self::cancelled(numerator, content, factors))
    }

    pub(super) fn denominator_inverse(&self) -> Self {
        Rational {
            numerator: Polynomial::one(),
            made: Made::Given,
            ..self.clone()
        }
    }

    pub(super) fn number_inverse(&self) -> Self {
        Rational {
            factors: Vec::new(),
            ..self.denominator_inverse()
        }
    }

    /// How many times `p` divides it: positive above the line, negative below; 0 for a constant `p`.
    pub(crate) fn valuation(&self, p: &Polynomial) -> i64 {
        if self.numerator.is_zero() || p.as_constant().is_some() {
            return 0;
        }
        let count = |q: &Polynomial| {
            let next = |q: &Polynomial| q.divide_exact(p);
            std::iter::successors(next(q), next).count() as i64
        };
        let below = self.factors.iter().map(|(f, k)| count(f) * i64::from(*k));
        count(&self.numerator) - below.sum::<i64>()
    }

    fn cancelled(
        mut numerator: Polynomial,
        mut number: IBig,
        mut factors: Vec<(Polynomial, u32)>,
    ) -> Self {
        if numerator.is_zero() {
            return numerator.into();
        }
        for (factor, k) in &mut factors {
            while *k > 0
                && let Some(quotient) = numerator.divide_exact(factor)
            {
                numerator = quotient;
                *k -= 1;
            }
        }
        factors.retain(|(_, k)| *k > 0);
        if number < IBig::ZERO {
            number = -number;
            numerator = -&numerator;
        }
        if number != IBig::ONE {
            let gcd: IBig = (&number).gcd(&numerator.content()).into();
            if gcd != IBig::ONE {
                number /= &gcd;
                let reduced = numerator.divide_exact(&Polynomial::constant(gcd));
                numerator = reduced.unwrap_or(numerator);
            }
        }
        Rational {
            numerator,
            number,
            factors,
            made: Made::Given,
        }
    }

    /// The value where generator `g` is `at[g]`, in floating point, for tests.
    #[cfg(test)]
    pub fn value(&self, at: &[f64]) -> f64 {
        let below = self
            .factors
            .iter()
            .map(|(f, k)| libm::pow(f.value(at), f64::from(*k)));
        self.numerator.value(at) / (self.number.to_f64().value() * below.product::<f64>())
    }

    /// Plain text, with the generators' names.
    pub fn text(&self, names: &[String]) -> String {
        let (monomial, rest) = self.numerator.split_monomial();
        let above = if self.numerator.len() < 2 {
            self.numerator.text(names)
        } else if monomial == Polynomial::one() {
            let text = rest.text(names);
            let alone = self.number == IBig::ONE && self.factors.is_empty();
            if alone { text } else { format!("({text})") }
        } else if monomial == -&Polynomial::one() {
            format!("−({})", rest.text(names))
        } else {
            format!("{} ({})", monomial.text(names), rest.text(names))
        };
        let mut below = Vec::new();
        if self.number != IBig::ONE {
            below.push(self.number.to_string());
        }
        for (factor, k) in &self.factors {
            let mut text = factor.text(names);
            if factor.len() > 1 || *k > 1 && text.contains('^') {
                text = format!("({text})");
            }
            below.push(if *k > 1 { format!("{text}^{k}") } else { text });
        }
        match below.as_slice() {
            [] => above,
            [one] => format!("{above}/{one}"),
            many => format!("{above}/({})", many.join(" ")),
        }
    }
}

impl From<Polynomial> for Rational {
    fn from(numerator: Polynomial) -> Self {
        Rational {
            numerator,
            number: IBig::ONE,
            factors: Vec::new(),
            made: Made::Given,
        }
    }
}

impl Rational {
    fn plus(&self, other: &Self) -> Self {
        if self.numerator.is_zero() {
            return other.clone();
        }
        if other.numerator.is_zero() {
            return self.clone();
        }
        let gcd: IBig = (&self.number).gcd(&other.number).into();
        let mut left = self.numerator.scale(&(&other.number / &gcd));
        let mut right = other.numerator.scale(&(&self.number / &gcd));
        let mut factors = self.factors.clone();
        for (factor, k) in &other.factors {
            match factors.iter_mut().find(|(f, _)| f == factor) {
                Some((_, common)) => {
                    if *k > *common {
                        left = &left * &factor.pow(*k - *common);
                        *common = *k;
                    }
                }
                None => {
                    left = &left * &factor.pow(*k);
                    factors.push((factor.clone(), *k));
                }
            }
        }
        for (factor, common) in &factors {
            let has = other
                .factors
                .iter()
                .find(|(f, _)| f == factor)
                .map_or(0, |(_, k)| *k);
            right = &right * &factor.pow(common - has);
        }
        Self::cancelled(&left + &right, &self.number / &gcd * &other.number, factors)
    }

    fn negated(&self) -> Self {
        Rational {
            numerator: -&self.numerator,
            ..self.clone()
        }
    }
}

impl Add for &Rational {
    type Output = Rational;
    fn add(self, other: Self) -> Rational {
        self.plus(other).formed()
    }
}

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        self.negated().formed()
    }
}

impl Sub for &Rational {
    type Output = Rational;
    fn sub(self, other: Self) -> Rational {
        self.plus(&other.negated()).formed()
    }
}

impl Mul for &Rational {
    type Output = Rational;
    fn mul(self, other: Self) -> Rational {
        let mut factors = self.factors.clone();
        for (factor, k) in &other.factors {
            match factors.iter_mut().find(|(f, _)| f == factor) {
                Some((_, power)) => *power += k,
                None => factors.push((factor.clone(), *k)),
            }
        }
        let numerator = &self.numerator * &other.numerator;
        Rational::cancelled(numerator, &self.number * &other.number, factors).formed()
    }
}

macro_rules! owned {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Rational {
            type Output = Rational;
            fn $method(self, other: Self) -> Rational {
                (&self).$method(&other)
            }
        }
        impl $trait<&Rational> for Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational {
                (&self).$method(other)
            }
        }
        impl $trait<Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational {
                self.$method(&other)
            }
        }
    )*};
}
owned!(Add add, Sub sub, Mul mul);

impl Neg for Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        -&self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn over(a: &Rational, b: &Rational) -> Rational {
        a * &b.reciprocal().expect("not zero")
    }

    #[test]
    fn partial_fractions_add_up() {
        let [x, one] = [Rational::generator(0), Rational::int(1)];
        let (more, less) = (&x + &one, &x - &one);
        // 1/(x−1) − 1/(x+1) = 2/(x²−1)
        let left = over(&one, &less) - over(&one, &more);
        let right = over(&Rational::int(2), &(&more * &less));
        assert!((&left - &right).is_literally_zero());
        assert!(!(&left + &right).is_literally_zero());
        assert!(over(&(&x * &x - &one), &more).factors().is_empty());
    }

    #[test]
    fn numbers_and_valuations() {
        let x = Rational::generator(0);
        let half = over(&x, &Rational::int(-2));
        assert_eq!(half.text(&["x".into()]), "−x/2");
        assert_eq!((&half + &half + &x).numerator(), &Polynomial::zero());
        let p = Polynomial::generator(0);
        assert_eq!(half.pow(3).valuation(&p), 3);
        assert_eq!((&half.pow(7) + &half.pow(9)).valuation(&p), 7);
        assert_eq!(half.reciprocal().expect("not zero").valuation(&p), -1);
        assert!((over(&x, &half) + Rational::int(2)).is_literally_zero());
        assert!(Rational::int(0).reciprocal().is_none());
        assert_eq!(half.text(&[]), "−#0/2");
    }

    #[test]
    fn a_power_below_the_line_counts_as_often_as_it_stands_there() {
        let x = Rational::generator(0);
        let more = &x + &Rational::int(1);
        let cube = over(&x.pow(2), &more.pow(3));
        assert_eq!(cube.valuation(more.numerator()), -3);
        assert_eq!(cube.valuation(x.numerator()), 2);
        // Numbers do not count.
        let two = Polynomial::constant(IBig::from(2));
        assert_eq!((&x * &Rational::int(4)).valuation(&two), 0);
        assert_eq!(Rational::int(0).valuation(x.numerator()), 0);
    }
}
