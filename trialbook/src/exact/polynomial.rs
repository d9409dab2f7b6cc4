//! Sparse polynomials in several generators with whole coefficients.

use dashu_int::IBig;
use dashu_int::ops::{Abs, DivRem, Gcd};
use smallvec::SmallVec;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fmt::Write;
use std::ops::{Add, Mul, Neg, Sub};

/// Exponents of the generators 0, 1, 2, …; trailing zeros left out. Multiplication respects the order. Few
/// rings have more than twenty generators.
type Monomial = SmallVec<[u32; 20]>;

type Term = (Monomial, IBig);

/// A polynomial over ℤ in generators known by their index; zero only if it has no terms.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Polynomial {
    /// In ascending order, each monomial once, no coefficient 0.
    terms: Vec<Term>,
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
        Self::collect(vec![(Monomial::new(), value)])
    }

    /// The generator of this index, to the first power.
    pub fn generator(index: usize) -> Self {
        let mut monomial = Monomial::from_elem(0, index + 1);
        monomial[index] = 1;
        let terms = vec![(monomial, IBig::ONE)];
        Polynomial { terms }
    }

    /// True for the polynomial without terms.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value, if no generator occurs.
    pub(crate) fn as_constant(&self) -> Option<IBig> {
        match self.terms.as_slice() {
            [] => Some(IBig::ZERO),
            [(m, c)] => m.is_empty().then(|| c.clone()),
            _ => None,
        }
    }

    /// The terms: the exponents of generators 0, 1, 2, … and the coefficient.
    pub fn terms(&self) -> impl Iterator<Item = (&[u32], &IBig)> {
        self.terms.iter().map(|(m, c)| (m.as_slice(), c))
    }

    pub(super) fn len(&self) -> usize {
        self.terms.len()
    }

    /// The coefficient of each generator, if this is a sum of multiples of them.
    pub(crate) fn as_linear(&self) -> Option<Vec<(usize, IBig)>> {
        let linear = |(m, c): &Term| {
            let single = m.iter().sum::<u32>() == 1;
            single.then(|| (m.len() - 1, c.clone()))
        };
        self.terms.iter().map(linear).collect()
    }

    /// The greatest common divisor of the coefficients, with the sign of the leading one; 0 of 0.
    pub fn content(&self) -> IBig {
        let Some(((_, leading), others)) = self.terms.split_last() else {
            return IBig::ZERO;
        };
        let mut gcd = leading.clone().abs();
        for (_, c) in others {
            if gcd == IBig::ONE {
                break;
            }
            gcd = (&gcd).gcd(c).into();
        }
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
        let lower = |(m, c): &Term| {
            let k = *m.get(generator).filter(|k| **k > 0)?;
            let mut lower = m.clone();
            lower[generator] -= 1;
            Some((trim(lower), c * IBig::from(k)))
        };
        // One power less of the same generator keeps the order.
        let terms = self.terms.iter().filter_map(lower).collect();
        Polynomial { terms }
    }

    /// The highest power of a generator.
    pub(crate) fn degree_in(&self, generator: usize) -> u32 {
        let powers = self.terms.iter().filter_map(|(m, _)| m.get(generator));
        powers.max().copied().unwrap_or(0)
    }

    /// The coefficients of the powers of one generator, as polynomials in the others.
    pub(crate) fn coefficients_in(&self, generator: usize) -> BTreeMap<u32, Polynomial> {
        let mut parts: BTreeMap<u32, Polynomial> = BTreeMap::new();
        for (m, c) in &self.terms {
            let mut rest = m.clone();
            let k = rest.get_mut(generator).map_or(0, std::mem::take);
            let part = parts.entry(k).or_default();
            part.terms.push((trim(rest), c.clone()));
        }
        parts
    }

    /// The generators that occur, each with its highest power.
    pub fn degrees(&self) -> BTreeMap<usize, u32> {
        let mut degrees = BTreeMap::new();
        for (m, _) in &self.terms {
            for (g, &k) in m.iter().enumerate().filter(|(_, k)| **k > 0) {
                let highest = degrees.entry(g).or_insert(0);
                *highest = k.max(*highest);
            }
        }
        degrees
    }

    fn common(&self) -> Monomial {
        let mut monomials = self.terms.iter().map(|(m, _)| m);
        let first = monomials.next().cloned().unwrap_or_default();
        trim(monomials.fold(first, |common, m| {
            let shared = common.iter().zip(m).map(|(a, b)| *a.min(b));
            shared.collect()
        }))
    }

    /// A number times powers of generators, and what that leaves when divided out.
    pub(crate) fn split_monomial(&self) -> (Polynomial, Polynomial) {
        let monomial = Self::collect(vec![(self.common(), self.content())]);
        match self.divide_exact(&monomial) {
            Some(rest) => (monomial, rest),
            None => (Self::one(), self.clone()),
        }
    }

    /// The quotient, if `divisor` divides without a remainder; `None` also for divisor 0.
    pub(crate) fn divide_exact(&self, divisor: &Polynomial) -> Option<Polynomial> {
        let ((lead, lead_c), below) = divisor.terms.split_last()?;
        let over_lead = |(m, c): (&Monomial, &IBig)| {
            let (factor, rest) = c.div_rem(lead_c);
            (rest == IBig::ZERO).then_some((quotient(m, lead)?, factor))
        };
        if below.is_empty() {
            let terms = self.terms.iter().map(|(m, c)| over_lead((m, c)));
            let terms = terms.collect::<Option<_>>()?;
            return Some(Polynomial { terms });
        }
        if let (Some((lowest, _)), Some((highest, _))) = (self.terms.first(), self.terms.last()) {
            quotient(lowest, &below[0].0)?;
            quotient(highest, lead)?;
        }
        let mut rest: BTreeMap<_, _> = self.terms.iter().cloned().collect();
        let mut terms = Vec::new();
        while let Some((m, c)) = rest.pop_last() {
            let (q, factor) = over_lead((&m, &c))?;
            for (n, d) in below {
                let change = -(d * &factor);
                match rest.entry(product(n, &q)) {
                    Entry::Vacant(free) => {
                        free.insert(change);
                    }
                    Entry::Occupied(mut taken) => {
                        *taken.get_mut() += change;
                        if *taken.get() == IBig::ZERO {
                            taken.remove();
                        }
                    }
                }
            }
            terms.push((q, factor));
        }
        terms.reverse();
        Some(Polynomial { terms })
    }

    /// The value where generator `g` is `at[g]`, in floating point, for tests.
    #[cfg(test)]
    pub fn value(&self, at: &[f64]) -> f64 {
        let term = |(m, c): &Term| {
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

    fn collect(mut terms: Vec<Term>) -> Self {
        terms.sort_unstable_by(|(m, _), (n, _)| m.cmp(n));
        terms.dedup_by(|(m, c), (n, sum)| {
            let like = m == n;
            if like {
                *sum += &*c;
            }
            like
        });
        terms.retain(|(_, c)| *c != IBig::ZERO);
        Polynomial { terms }
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
    let mut m = Monomial::from_slice(long);
    for (k, j) in m.iter_mut().zip(short) {
        *k += j;
    }
    m
}

fn quotient(a: &[u32], b: &[u32]) -> Option<Monomial> {
    if a.len() < b.len() {
        return None;
    }
    let mut m = Monomial::from_slice(a);
    for (k, j) in m.iter_mut().zip(b) {
        *k = k.checked_sub(*j)?;
    }
    Some(trim(m))
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        let mut terms = Vec::with_capacity(self.len() + other.len());
        let (mut left, mut right) = (self.terms.as_slice(), other.terms.as_slice());
        while let ([(m, c), later @ ..], [(n, d), after @ ..]) = (left, right) {
            let order = m.cmp(n);
            let (monomial, sum) = match order {
                Ordering::Less => (m, c.clone()),
                Ordering::Greater => (n, d.clone()),
                Ordering::Equal => (m, c + d),
            };
            if sum != IBig::ZERO {
                terms.push((monomial.clone(), sum));
            }
            if order.is_le() {
                left = later;
            }
            if order.is_ge() {
                right = after;
            }
        }
        terms.extend_from_slice(left);
        terms.extend_from_slice(right);
        Polynomial { terms }
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
        let times = |(m, c): &Term| {
            let (m, c) = (m.clone(), c.clone());
            let with = move |(n, d): &Term| (product(&m, n), &c * d);
            other.terms.iter().map(with)
        };
        let terms: Vec<_> = self.terms.iter().flat_map(times).collect();
        if self.len().min(other.len()) == 1 {
            // One term keeps the order.
            return Polynomial { terms };
        }
        Polynomial::collect(terms)
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
        assert_eq!(x.divide_exact(&x.scale(&IBig::from(2))), None);
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

    #[test]
    fn what_divides_every_term_is_told() {
        let [x, y, z] = [0, 1, 2].map(Polynomial::generator);
        let sum = &(&x.pow(3) * &y.pow(2)) + &(&(&x.pow(2) * &y.pow(4)) * &z);
        assert_eq!(sum.common().as_slice(), [2, 2]);
        assert!((&sum + &int(1)).common().is_empty());
    }
}
