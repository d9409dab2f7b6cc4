//! Sparse polynomials in several generators with whole coefficients.

use dashu_int::IBig;
use dashu_int::ops::{Abs, Gcd};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::ops::{Add, Mul, Neg, Sub};

/// Exponents of the generators 0, 1, 2, …; trailing zeros left out. Ordered lexicographically, which is an
/// order that multiplication respects.
type Monomial = Vec<u32>;

/// A polynomial over ℤ in generators that are known by their index. Exact; zero only if it has no terms.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Polynomial {
    terms: BTreeMap<Monomial, IBig>,
}

impl Polynomial {
    /// The polynomial without terms.
    pub fn zero() -> Self {
        Self::default()
    }

    /// The constant 1.
    pub fn one() -> Self {
        Self::constant(IBig::ONE)
    }

    /// A constant.
    pub fn constant(value: IBig) -> Self {
        let mut p = Self::zero();
        p.add_term(Vec::new(), value);
        p
    }

    /// The generator of this index, to the first power.
    pub fn generator(index: usize) -> Self {
        let mut monomial = vec![0; index + 1];
        monomial[index] = 1;
        let terms = BTreeMap::from([(monomial, IBig::ONE)]);
        Polynomial { terms }
    }

    /// True for the polynomial without terms.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value, if no generator occurs.
    pub fn as_constant(&self) -> Option<IBig> {
        match self.terms.len() {
            0 => Some(IBig::ZERO),
            1 => self.terms.get(&Vec::new()).cloned(),
            _ => None,
        }
    }

    /// The terms: the exponents of generators 0, 1, 2, … and the coefficient.
    pub fn terms(&self) -> impl Iterator<Item = (&[u32], &IBig)> {
        self.terms.iter().map(|(m, c)| (m.as_slice(), c))
    }

    /// How many terms there are.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// True for the polynomial without terms; [`Polynomial::is_zero`] by the name that goes with `len`.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// The coefficient of each generator, if the polynomial is a sum of multiples of generators.
    pub fn as_linear(&self) -> Option<Vec<(usize, IBig)>> {
        let linear = |(m, c): (&Monomial, &IBig)| {
            let single = m.iter().sum::<u32>() == 1;
            single.then(|| (m.len() - 1, c.clone()))
        };
        self.terms.iter().map(linear).collect()
    }

    /// The greatest common divisor of the coefficients, with the sign of the leading one; 0 of 0.
    pub fn content(&self) -> IBig {
        let Some((_, leading)) = self.terms.last_key_value() else {
            return IBig::ZERO;
        };
        let gcd = self.terms.values().fold(IBig::ZERO, |gcd, c| {
            if gcd == IBig::ZERO {
                c.clone().abs()
            } else {
                (&gcd).gcd(c).into()
            }
        });
        if *leading < IBig::ZERO { -gcd } else { gcd }
    }

    /// Every coefficient times `factor`.
    pub fn scale(&self, factor: &IBig) -> Self {
        if *factor == IBig::ZERO {
            return Self::zero();
        }
        let terms = self.terms.iter().map(|(m, c)| (m.clone(), c * factor));
        Polynomial {
            terms: terms.collect(),
        }
    }

    /// To the power `n`; the power 0 is 1.
    pub fn pow(&self, n: u32) -> Self {
        (0..n).fold(Self::one(), |power, _| &power * self)
    }

    /// The partial derivative with respect to a generator.
    pub fn partial(&self, generator: usize) -> Self {
        let mut p = Self::zero();
        for (m, c) in &self.terms {
            let Some(&k) = m.get(generator).filter(|k| **k > 0) else {
                continue;
            };
            let mut lower = m.clone();
            lower[generator] -= 1;
            p.add_term(trim(lower), c * IBig::from(k));
        }
        p
    }

    /// The coefficients of the powers of one generator, as polynomials in the others.
    pub fn coefficients_in(&self, generator: usize) -> BTreeMap<u32, Polynomial> {
        let mut parts: BTreeMap<u32, Polynomial> = BTreeMap::new();
        for (m, c) in &self.terms {
            let mut rest = m.clone();
            let k = rest.get_mut(generator).map_or(0, std::mem::take);
            parts.entry(k).or_default().add_term(trim(rest), c.clone());
        }
        parts
    }

    /// The indices of the generators that occur, each with its highest power.
    pub fn degrees(&self) -> BTreeMap<usize, u32> {
        let mut degrees = BTreeMap::new();
        for m in self.terms.keys() {
            for (g, &k) in m.iter().enumerate().filter(|(_, k)| **k > 0) {
                let highest = degrees.entry(g).or_insert(0);
                *highest = k.max(*highest);
            }
        }
        degrees
    }

    /// The largest power of each generator that divides the polynomial.
    pub fn monomial_divisor(&self) -> Vec<u32> {
        let mut keys = self.terms.keys();
        let first = keys.next().cloned().unwrap_or_default();
        trim(keys.fold(first, |common, m| {
            let shared = common.iter().zip(m).map(|(a, b)| *a.min(b));
            shared.collect()
        }))
    }

    /// A number times powers of generators, and what is left when that is divided out.
    pub fn split_monomial(&self) -> (Polynomial, Polynomial) {
        let terms = BTreeMap::from([(self.monomial_divisor(), self.content())]);
        let monomial = Polynomial { terms };
        match self.divide_exact(&monomial) {
            Some(rest) => (monomial, rest),
            None => (Self::one(), self.clone()),
        }
    }

    /// The quotient, if `divisor` divides the polynomial without a remainder; `None` also for divisor 0.
    pub fn divide_exact(&self, divisor: &Polynomial) -> Option<Polynomial> {
        let (lead, lead_c) = divisor.terms.last_key_value()?;
        if let (Some((lowest, _)), Some((low, _))) = (
            self.terms.first_key_value(),
            divisor.terms.first_key_value(),
        ) {
            quotient(lowest, low)?;
        }
        let mut rest = self.clone();
        let mut result = Self::zero();
        while let Some((m, c)) = rest.terms.last_key_value() {
            let q = quotient(m, lead)?;
            if c % lead_c != IBig::ZERO {
                return None;
            }
            let factor = c / lead_c;
            for (n, d) in &divisor.terms {
                rest.add_term(product(n, &q), -(d * &factor));
            }
            result.add_term(q, factor);
        }
        Some(result)
    }

    /// The value where generator `g` has the value `at[g]`, in floating point: for tests against numbers.
    #[cfg(test)]
    pub fn value(&self, at: &[f64]) -> f64 {
        let term = |(m, c): (&Monomial, &IBig)| {
            let powers = m.iter().zip(at).map(|(k, x)| libm::pow(*x, f64::from(*k)));
            c.to_f64().value() * powers.product::<f64>()
        };
        self.terms.iter().map(term).sum()
    }

    /// Plain text, with the generators' names; the leading term first.
    pub fn text(&self, names: &[String]) -> String {
        let mut text = String::new();
        for (m, c) in self.terms.iter().rev() {
            let negative = *c < IBig::ZERO;
            text += match (text.is_empty(), negative) {
                (true, false) => "",
                (true, true) => "−",
                (false, false) => " + ",
                (false, true) => " − ",
            };
            let size = c.clone().abs();
            let mut factors = Vec::new();
            if m.is_empty() || size != IBig::ONE {
                factors.push(size.to_string());
            }
            for (g, k) in m.iter().enumerate().filter(|(_, k)| **k > 0) {
                let mut factor = names.get(g).cloned().unwrap_or_else(|| format!("#{g}"));
                if *k > 1 {
                    if factor.contains('^') {
                        factor = format!("({factor})");
                    }
                    let _ = write!(factor, "^{k}");
                }
                factors.push(factor);
            }
            text += &factors.join(" ");
        }
        if text.is_empty() { "0".into() } else { text }
    }

    fn add_term(&mut self, monomial: Monomial, coefficient: IBig) {
        use std::collections::btree_map::Entry;
        if coefficient == IBig::ZERO {
            return;
        }
        match self.terms.entry(monomial) {
            Entry::Vacant(free) => {
                free.insert(coefficient);
            }
            Entry::Occupied(mut taken) => {
                *taken.get_mut() += coefficient;
                if *taken.get() == IBig::ZERO {
                    taken.remove();
                }
            }
        }
    }
}

fn trim(mut monomial: Monomial) -> Monomial {
    while monomial.last() == Some(&0) {
        monomial.pop();
    }
    monomial
}

fn product(a: &[u32], b: &[u32]) -> Monomial {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let mut m = long.to_vec();
    for (k, j) in m.iter_mut().zip(short) {
        *k += j;
    }
    m
}

fn quotient(a: &[u32], b: &[u32]) -> Option<Monomial> {
    if a.len() < b.len() {
        return None;
    }
    let mut m = a.to_vec();
    for (k, j) in m.iter_mut().zip(b) {
        *k = k.checked_sub(*j)?;
    }
    Some(trim(m))
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        let mut sum = self.clone();
        for (m, c) in &other.terms {
            sum.add_term(m.clone(), c.clone());
        }
        sum
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        self.scale(&-IBig::ONE)
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        self + &-other
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        let mut p = Polynomial::zero();
        for (m, c) in &self.terms {
            for (n, d) in &other.terms {
                p.add_term(product(m, n), c * d);
            }
        }
        p
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn int(n: i64) -> Polynomial {
        Polynomial::constant(IBig::from(n))
    }

    #[test]
    fn a_product_divides_by_its_factors_and_by_nothing_else() {
        let [x, y, z] = [0, 1, 2].map(Polynomial::generator);
        let a = &(&x.pow(2) - &(&y * &z)) + &int(3);
        let b = &(&z.pow(3) + &x) - &int(7);
        let ab = &a * &b;
        assert_eq!(ab.divide_exact(&a), Some(b.clone()));
        assert_eq!(ab.divide_exact(&b), Some(a.clone()));
        assert_eq!((&ab + &int(1)).divide_exact(&a), None);
        assert_eq!(x.divide_exact(&y), None);
        assert_eq!(x.divide_exact(&Polynomial::zero()), None);
        assert_eq!(
            Polynomial::zero().divide_exact(&a),
            Some(Polynomial::zero())
        );
    }

    #[test]
    fn difference_of_squares_is_what_it_is() {
        let [x, y] = [3, 1].map(Polynomial::generator);
        let left = &(&x + &y) * &(&x - &y);
        assert!((&left - &(&x.pow(2) - &y.pow(2))).is_zero());
        assert_eq!(left.partial(3), x.scale(&IBig::from(2)));
        assert_eq!(left.coefficients_in(1)[&2], int(-1));
        assert_eq!(left.scale(&IBig::from(-6)).content(), IBig::from(6));
        let names = ["a", "b", "c", "d"].map(String::from);
        assert_eq!(left.text(&names), "−b^2 + d^2");
    }
}
