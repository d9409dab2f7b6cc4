//! Series in powers of one small quantity x, known up to some order: x^start (c₀ + c₁ x + … + cₙ xⁿ) +
//! O(x^(start+n+1)), with coefficients in a [`Ring`].

use super::calculus::Derivation;
use super::error::ExactError;
use super::rational::Rational;
use super::ring::Ring;

/// A power series, cut off; negative powers may occur.
#[derive(Debug, Clone)]
pub struct Series {
    start: i64,
    coefficients: Vec<Rational>,
}

impl Series {
    /// The series of these coefficients, from that of x^`start` on.
    pub fn new(start: i64, coefficients: Vec<Rational>) -> Self {
        Series {
            start,
            coefficients,
        }
    }

    /// An element free of x, up to the order `order`.
    pub fn constant(value: Rational, order: i64) -> Self {
        Self::monomial(value, 0, order)
    }

    /// value × x^power, up to the order `order`.
    pub fn monomial(value: Rational, power: i64, order: i64) -> Self {
        let mut coefficients = vec![Rational::int(0); (order - power).max(-1) as usize + 1];
        if let Some(first) = coefficients.first_mut() {
            *first = value;
        }
        Series::new(power, coefficients)
    }

    /// The lowest power that is kept.
    pub fn start(&self) -> i64 {
        self.start
    }

    /// The same in terms of a small quantity whose power `n` ≥ 1 this one is.
    pub fn in_root(&self, n: usize) -> Self {
        let mut coefficients = vec![Rational::int(0); self.coefficients.len() * n];
        for (k, c) in self.coefficients.iter().enumerate() {
            coefficients[k * n] = c.clone();
        }
        Series::new(self.start * n as i64, coefficients)
    }

    pub(super) fn mapped(self, f: impl Fn(i64, Rational) -> Rational) -> Self {
        let powers = self.start..;
        let mapped = powers.zip(self.coefficients).map(|(power, c)| f(power, c));
        Series::new(self.start, mapped.collect())
    }

    /// The highest power whose coefficient is known.
    pub fn order(&self) -> i64 {
        self.start + self.coefficients.len() as i64 - 1
    }

    /// The coefficient of x^power; `None` where it is not known.
    pub fn coefficient(&self, power: i64) -> Option<Rational> {
        if power > self.order() {
            return None;
        }
        let place = usize::try_from(power - self.start).ok();
        Some(place.map_or_else(|| Rational::int(0), |i| self.coefficients[i].clone()))
    }

    /// The same times x^power.
    pub fn shifted(mut self, power: i64) -> Self {
        self.start += power;
        self
    }

    /// The negative.
    pub(crate) fn negated(self) -> Self {
        self.mapped(|_, c| -&c)
    }

    /// A sum, known as far as both are.
    pub fn plus(&self, other: &Self) -> Self {
        let start = self.start.min(other.start);
        let known = start..=self.order().min(other.order());
        let sum = known.filter_map(|k| Some(self.coefficient(k)? + other.coefficient(k)?));
        Series::new(start, sum.collect())
    }

    /// A difference, known as far as both are.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.clone().negated())
    }

    /// A product.
    pub fn times(&self, other: &Self, ring: &Ring) -> Self {
        // Leading zeros would only cost known orders.
        let zeros = |s: &Self| {
            let leading = s.coefficients.iter().take_while(|c| c.is_literally_zero());
            leading.count()
        };
        let (i, j) = (zeros(self), zeros(other));
        let (a, b) = (&self.coefficients[i..], &other.coefficients[j..]);
        let product = (0..a.len().min(b.len())).map(|n| {
            let terms = (0..=n).map(|k| &a[k] * &b[n - k]);
            ring.normal(&terms.fold(Rational::int(0), |sum, term| sum + term))
        });
        let start = self.start + other.start + (i + j) as i64;
        Series::new(start, product.collect())
    }

    /// A quotient.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] if the divisor is zero as far as it is known.
    pub fn over(&self, other: &Self, ring: &Ring) -> Result<Self, ExactError> {
        let other = other.clone().trimmed(ring)?;
        let Some(first) = other.coefficients.first() else {
            let divisor = "a series without a term".to_owned();
            return Err(ExactError::DivisionByZero(divisor));
        };
        let mut quotient: Vec<Rational> = Vec::new();
        for n in 0..self.coefficients.len().min(other.coefficients.len()) {
            let mut rest = self.coefficients[n].clone();
            for (k, q) in quotient.iter().enumerate() {
                rest = rest - q * &other.coefficients[n - k];
            }
            quotient.push(ring.divide(&ring.normal(&rest), first)?);
        }
        Ok(Series::new(self.start - other.start, quotient))
    }

    /// A power of the series, whole or not; c x^k + … needs (c)^exponent in the ring and k × exponent whole.
    ///
    /// # Errors
    /// As [`Ring::read`] for that power; [`ExactError::NoSeries`] where powers of x would not be whole.
    pub fn power(&self, exponent: &Rational, ring: &Ring) -> Result<Self, ExactError> {
        let own = self.clone().trimmed(ring)?;
        let leading = own.coefficients.first().cloned();
        let start = (&Rational::int(own.start) * exponent).as_integer();
        let start = start.and_then(|n| i64::try_from(n).ok());
        let (Some(leading), Some(start)) = (leading, start) else {
            let what = format!("to the power {}", ring.text(exponent));
            return Err(ExactError::NoSeries(what));
        };
        // y = xᵉ obeys x y′ = e x′ y.
        let mut y = vec![ring.raise(&leading, exponent)?];
        for n in 1..own.coefficients.len() {
            let mut sum = Rational::int(0);
            for k in 1..=n {
                let weight = exponent * &Rational::int(k as i64) - Rational::int((n - k) as i64);
                sum = sum + weight * &own.coefficients[k] * &y[n - k];
            }
            let divisor = &leading * &Rational::int(n as i64);
            y.push(ring.divide(&ring.normal(&sum), &divisor)?);
        }
        Ok(Series::new(start, y))
    }

    /// x d/dx, where `moving` is what x d/dx is of the quantities in the coefficients.
    ///
    /// # Errors
    /// As [`Ring::derivative`].
    pub fn euler(&self, moving: &Derivation, ring: &Ring) -> Result<Self, ExactError> {
        let slope = |(i, c): (usize, &Rational)| {
            let own = c * &Rational::int(self.start + i as i64);
            Ok(ring.normal(&(own + ring.derivative(c, moving)?)))
        };
        let slopes = self.coefficients.iter().enumerate().map(slope);
        Ok(Series::new(self.start, slopes.collect::<Result<_, _>>()?))
    }

    /// Each coefficient by a function.
    ///
    /// # Errors
    /// Those of the function.
    pub fn map<E>(&self, f: impl FnMut(&Rational) -> Result<Rational, E>) -> Result<Self, E> {
        let mapped: Result<_, E> = self.coefficients.iter().map(f).collect();
        Ok(Series::new(self.start, mapped?))
    }

    /// The terms that are not zero, and the order of what is left out.
    pub fn text(&self, small: &str, ring: &Ring) -> String {
        let power = |k: i64| match k {
            0 => String::new(),
            1 => format!(" {small}"),
            k if k < 0 => format!(" {small}^(−{})", -k),
            k => format!(" {small}^{k}"),
        };
        let terms = self.coefficients.iter().zip(self.start..);
        let mut text: String = terms
            .filter(|(c, _)| !c.is_literally_zero())
            .map(|(c, k)| format!("[{}]{} + ", ring.text(c), power(k)))
            .collect();
        text += match self.order() + 1 {
            0 => "O(1)".to_owned(),
            k => format!("O({})", power(k).trim_start()),
        }
        .as_str();
        text
    }

    fn trimmed(mut self, ring: &Ring) -> Result<Self, ExactError> {
        let mut zeros = 0;
        while let Some(c) = self.coefficients.get(zeros) {
            if !ring.is_zero(c)? {
                break;
            }
            zeros += 1;
        }
        self.coefficients.drain(..zeros);
        self.start += zeros as i64;
        Ok(self)
    }

    pub(super) fn split(&self, ring: &Ring) -> Result<(Rational, Vec<Rational>), ExactError> {
        for power in self.start..0 {
            if !ring.is_zero(&self.coefficient(power).unwrap_or(Rational::int(0)))? {
                let what = format!("about the power {power} of the small quantity");
                return Err(ExactError::NoSeries(what));
            }
        }
        let all = (0..=self.order()).filter_map(|k| self.coefficient(k));
        let all: Vec<_> = all.collect();
        match all.first() {
            Some(first) => Ok((first.clone(), all)),
            None => Err(ExactError::NoSeries("of which no term is known".into())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_series_is_written_with_its_powers_and_its_order() {
        let mut ring = Ring::new();
        let a = ring.symbol("a");
        let [one, zero] = [1, 0].map(Rational::int);
        let all = vec![one.clone(), -&a, zero.clone(), &a * &a, one.clone(), a];
        let text = |start| Series::new(start, all.clone()).text("x", &ring);
        assert_eq!(
            text(-2),
            "[1] x^(−2) + [−a] x^(−1) + [a^2] x + [1] x^2 + [a] x^3 + O(x^4)"
        );
        assert_eq!(
            text(-1),
            "[1] x^(−1) + [−a] + [a^2] x^2 + [1] x^3 + [a] x^4 + O(x^5)"
        );
        assert_eq!(
            Series::new(-1, vec![one.clone()]).text("x", &ring),
            "[1] x^(−1) + O(1)"
        );
        assert_eq!(Series::new(0, vec![zero]).text("x", &ring), "O(x)");
        assert_eq!(
            Series::new(-3, vec![one]).text("x", &ring),
            "[1] x^(−3) + O(x^(−2))"
        );
    }
}
