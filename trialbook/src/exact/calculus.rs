//! Elements of a ring: zero-testing, division, differentiation, putting values in.

use super::error::ExactError;
use super::origin::{below, made_of};
use super::polynomial::Polynomial;
use super::rational::Rational;
use super::ring::{PI, Ring, Rule};
use std::collections::{BTreeMap, BTreeSet};

type Values<'a> = BTreeMap<usize, &'a Rational>;

/// The rates of the free symbols along a motion, or by one of them; 0 for all others.
#[derive(Debug, Clone, Default)]
pub struct Derivation {
    rates: BTreeMap<usize, Rational>,
}

impl Ring {
    /// The normal form: powers of roots below their degree above the line, and as bare factors below it.
    pub fn normal(&self, x: &Rational) -> Rational {
        self.reduced(x).made_so(x.made())
    }

    fn reduced(&self, x: &Rational) -> Rational {
        let mut x = x.clone();
        for (g, rule) in self.rules.iter().enumerate().rev() {
            let Rule::Root { radicand, degree } = rule else {
                continue;
            };
            let generator = Polynomial::generator(g);
            let below = x.factors().iter().find(|(f, _)| *f == generator);
            // A root of a number never stays below the line.
            let number =
                radicand.factors().is_empty() && radicand.numerator().as_constant().is_some();
            let whole = |k: u32| match number {
                true => k.div_ceil(*degree),
                false => k / degree,
            };
            if let Some(whole) = below.map(|(_, k)| whole(*k)).filter(|whole| *whole > 0)
                && let Some(inverse) = radicand.reciprocal()
            {
                let raised = Rational::from(generator.pow(whole * degree));
                x = &x * &raised * inverse.pow(whole);
            }
            if x.numerator().degree_in(g) < *degree {
                continue;
            }
            let parts = x.numerator().coefficients_in(g);
            let mut reduced = Rational::int(0);
            for (k, part) in parts {
                let low = &Rational::from(part) * &Rational::generator(g).pow(k % degree);
                reduced = reduced + low * radicand.pow(k / degree);
            }
            x = reduced * x.denominator_inverse();
        }
        x
    }

    /// Whether an element is zero.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] if something below the line is zero by a relation.
    pub fn is_zero(&self, x: &Rational) -> Result<bool, ExactError> {
        for (factor, _) in x.factors() {
            let factor = Rational::from(factor.clone());
            if self.normal(&factor).is_literally_zero() {
                let divisor = self.text(&factor);
                return Err(ExactError::DivisionByZero(divisor));
            }
        }
        Ok(self.normal(x).is_literally_zero())
    }

    /// One element over another.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] if the divisor is zero in the ring.
    pub fn divide(&self, x: &Rational, y: &Rational) -> Result<Rational, ExactError> {
        let inverse = self.normal(y).reciprocal();
        let inverse = inverse.ok_or_else(|| ExactError::DivisionByZero(self.text(y)))?;
        Ok(self.normal(&(x * &inverse)))
    }

    /// The derivation with respect to a free symbol, all others fixed.
    ///
    /// # Errors
    /// [`ExactError::UnknownSymbol`] or [`ExactError::NotFree`].
    pub fn by(&self, name: &str) -> Result<Derivation, ExactError> {
        self.along(&[(name, Rational::int(1))])
    }

    /// The derivation along a motion with these rates; all other free symbols keep still.
    ///
    /// # Errors
    /// [`ExactError::UnknownSymbol`] or [`ExactError::NotFree`].
    pub fn along(&self, rates: &[(&str, Rational)]) -> Result<Derivation, ExactError> {
        let rate = |(name, rate): &(&str, Rational)| Ok((self.free_index(name)?, rate.clone()));
        Ok(Derivation {
            rates: rates.iter().map(rate).collect::<Result<_, _>>()?,
        })
    }

    /// The derivative of an element.
    ///
    /// # Errors
    /// [`ExactError::VaryingExponent`] for b^e with varying e, unless ln b is declared.
    pub fn derivative(&self, x: &Rational, by: &Derivation) -> Result<Rational, ExactError> {
        Ok(self.slope(x, by)?.formed())
    }

    fn slope(&self, x: &Rational, by: &Derivation) -> Result<Rational, ExactError> {
        let mut slope = self.of_polynomial(x.numerator(), by)? * x.denominator_inverse();
        for (factor, k) in x.factors() {
            let factor_slope = self.of_polynomial(factor, by)?;
            if factor_slope.is_literally_zero() {
                continue;
            }
            let relative = self.divide(&factor_slope, &Rational::from(factor.clone()))?;
            slope = slope - x * &relative * Rational::int(i64::from(*k));
        }
        Ok(self.normal(&slope))
    }

    fn of_polynomial(&self, p: &Polynomial, by: &Derivation) -> Result<Rational, ExactError> {
        let mut slope = Rational::int(0);
        for g in p.degrees().into_keys() {
            let rate = self.rate(g, by)?;
            if !rate.is_literally_zero() {
                slope = slope + Rational::from(p.partial(g)) * rate;
            }
        }
        Ok(slope)
    }

    fn rate(&self, g: usize, by: &Derivation) -> Result<Rational, ExactError> {
        let own = Rational::generator(g);
        let half = |index: usize| self.divide(&self.rate(index, by)?, &Rational::int(2));
        match &self.rules[g] {
            Rule::Constant => Ok(Rational::int(0)),
            Rule::Free => {
                let rate = by.rates.get(&g).cloned();
                Ok(rate.unwrap_or_else(|| Rational::int(0)))
            }
            Rule::HalfTangent { angle } => Ok((Rational::int(1) + &own * &own) * half(*angle)?),
            Rule::HalfExponential { argument } => Ok(own * half(*argument)?),
            Rule::Logarithm { of } => self.divide(&self.derivative(of, by)?, of),
            Rule::Root { radicand, degree } => {
                let below = radicand * &Rational::int(i64::from(*degree));
                Ok(own * self.divide(&self.derivative(radicand, by)?, &below)?)
            }
            Rule::Power { base, exponent } => {
                let mut relative = exponent * &self.divide(&self.derivative(base, by)?, base)?;
                let growing = self.derivative(exponent, by)?;
                if !growing.is_literally_zero() {
                    let ln = self
                        .ln(base)
                        .map_err(|_| ExactError::VaryingExponent(self.names[g].clone()))?;
                    relative = relative + growing * ln;
                }
                Ok(own * relative)
            }
        }
    }

    /// The element with values put in for some of its generators, and for what is made of these; a half
    /// tangent, half exponential or logarithm may have any, if what it is made of does not occur.
    ///
    /// # Errors
    /// [`ExactError::AgainstRule`] if a generator in it does not keep to its rule, [`ExactError::DivisionByZero`] if a
    /// divisor becomes zero.
    pub fn put(
        &self,
        x: &Rational,
        values: &[(&Rational, &Rational)],
    ) -> Result<Rational, ExactError> {
        Ok(self.replaced(x, values)?.formed())
    }

    fn replaced(
        &self,
        x: &Rational,
        values: &[(&Rational, &Rational)],
    ) -> Result<Rational, ExactError> {
        let values: Values<'_> = values
            .iter()
            .filter_map(|(g, value)| Some((g.generators().next()?, *value)))
            .collect();
        let of = |g: usize| made_of(self, below(&self.rules[g]));
        let there: BTreeSet<usize> = x.generators().collect();
        for g in made_of(self, there.clone()) {
            let (own, is_put) = (of(g), values.contains_key(&g));
            if is_put || own.iter().any(|h| values.contains_key(h)) {
                let beside = |h: &usize| {
                    let theirs = of(*h);
                    let shared = own.contains(h) || !own.is_disjoint(&theirs);
                    *h != g && shared && !theirs.contains(&g)
                };
                if !self.keeps(g, &values, is_put && !there.iter().any(beside))? {
                    return Err(ExactError::AgainstRule(self.names[g].clone()));
                }
            }
        }
        self.at(x, &values)
    }

    /// Alone, it may have any.
    fn keeps(&self, g: usize, values: &Values<'_>, alone: bool) -> Result<bool, ExactError> {
        let at = |x: &Rational| self.at(x, values);
        let of = |h: usize| at(&Rational::generator(h));
        let same = |x: &Rational, y: &Rational| self.is_zero(&(x - y));
        let (one, new) = (Rational::int(1), of(g)?);
        match &self.rules[g] {
            Rule::Constant => Ok(false),
            Rule::Free => Ok(true),
            Rule::Root { radicand, degree } => {
                let of = at(radicand)?;
                let is_positive = self.is_zero(&of)? || self.is_positive(&new)?;
                Ok(is_positive && same(&new.pow(*degree), &of)?)
            }
            Rule::Power { base, exponent } => {
                let (base, exponent) = (at(base)?, at(exponent)?);
                if self.is_zero(&base)? {
                    return Ok(self.is_zero(&new)? && self.is_positive(&exponent)?);
                }
                Ok(self.is_positive(&new)? && same(&self.raise(&base, &exponent)?, &new)?)
            }
            Rule::HalfExponential { argument } => Ok(self.is_positive(&new)?
                && (alone || same(&self.exponential(&of(*argument)?)?, &(&new * &new))?)),
            _ if alone => Ok(true),
            Rule::HalfTangent { angle } => {
                let angle = of(*angle)?;
                let turns = angle
                    .as_halves()
                    .is_some_and(|of| of.iter().any(|(g, k)| *g == PI && k.abs() > 1));
                let (cosine, sine) = self.circular(&angle)?;
                let square = &new * &new;
                let all = &one + &square;
                Ok(!turns
                    && same(&(cosine * &all), &(&one - &square))?
                    && same(&(sine * &all), &(&new + &new))?)
            }
            Rule::Logarithm { of } => same(&self.ln(&at(of)?)?, &new),
        }
    }

    fn at(&self, x: &Rational, values: &Values<'_>) -> Result<Rational, ExactError> {
        let into = |p: &Polynomial| {
            p.terms()
                .fold(Rational::int(0), |sum, (monomial, coefficient)| {
                    let start = Rational::from(Polynomial::constant(coefficient.clone()));
                    let powers = monomial.iter().enumerate().filter(|(_, k)| **k > 0);
                    sum + powers.fold(start, |term, (g, k)| {
                        let known = values.get(&g).map(|value| value.pow(*k));
                        term * known.unwrap_or_else(|| Rational::generator(g).pow(*k))
                    })
                })
        };
        let mut result = into(x.numerator());
        for (factor, k) in x.factors() {
            for _ in 0..*k {
                result = self.divide(&result, &into(factor))?;
            }
        }
        Ok(result * x.number_inverse())
    }
}

#[cfg(test)]
mod tests {
    use super::super::expr::Expr;
    use super::*;
    use crate::scalar::Scalar;

    #[test]
    fn roots_stay_below_the_line_only_as_bare_factors() {
        let mut ring = Ring::new();
        let x = ring.symbol("x");
        let root = ring.root(&x, 2).unwrap();
        let three = ring.root(&Rational::int(3), 2).unwrap();
        let inverse = |of: &Rational, k: u32| {
            let power = of.pow(k).reciprocal().unwrap();
            ring.text(&ring.normal(&power))
        };
        assert_eq!(
            [1, 2, 3, 5].map(|k| inverse(&root, k)),
            ["1/√x", "1/x", "1/(√x x)", "1/(√x x^2)"]
        );
        // That of a number never.
        assert_eq!(
            [1, 2, 3].map(|k| inverse(&three, k)),
            ["√3/3", "1/3", "√3/9"]
        );
    }

    #[test]
    fn a_power_has_a_slope_by_its_exponent_where_its_base_has_a_logarithm() {
        let mut ring = Ring::new();
        let (a, b, x) = (ring.symbol("a"), ring.symbol("b"), ring.symbol("x"));
        let [of_a, of_b] = [&a, &b].map(|base| ring.power(base, &x).unwrap());
        let ln = ring.logarithm(&a).unwrap();
        let slope = |ring: &Ring, of: &Rational, by: &str| {
            let by = ring.by(by).unwrap();
            ring.derivative(of, &by)
        };
        let is = |found: Rational, expected: Rational| ring.is_zero(&(found - expected)).unwrap();
        assert!(is(slope(&ring, &of_a, "x").unwrap(), &of_a * &ln));
        let refused = slope(&ring, &of_b, "x");
        assert!(
            matches!(refused, Err(ExactError::VaryingExponent { .. })),
            "{refused:?}"
        );
        // By the base both have one.
        for (base, power, name) in [(&a, &of_a, "a"), (&b, &of_b, "b")] {
            let found = slope(&ring, power, name).unwrap();
            assert!(is(&found * base, power * &x));
        }
    }

    #[test]
    fn a_value_that_is_put_in_keeps_to_its_rule() {
        let mut ring = Ring::new();
        let [x, u, k, lambda] = ["x", "u", "k", "λ"].map(|name| ring.symbol(name));
        let [zero, one, two, three, four] = [0, 1, 2, 3, 4].map(Rational::int);
        let (theta, alpha) = (ring.angle("θ"), ring.hyperbolic("α"));
        let half = ring.half_tangent("θ").unwrap();
        let root = ring.root(&x, 2).unwrap();
        let power = ring.power(&u, &(&lambda - &one)).unwrap();
        let ln = ring.logarithm(&k).unwrap();
        let read = |name: &'static str, f: fn(Expr) -> Expr| {
            ring.read(f(Expr::symbol(name) / Expr::int(2))).unwrap()
        };
        let (cosine, exp) = (read("θ", Expr::cos), read("α", Expr::exp));
        let pi = Rational::generator(PI);
        let [of_root, of_power] = [&x * &root, (&one + &u) * &power];
        let of_angle = &theta * &(&half + &cosine);
        let turned = &theta + &(&pi * &two);
        let minus = -&two;
        for (of, values, gives) in [
            (&of_root, vec![(&x, &four), (&root, &two)], Some(8)),
            (&of_root, vec![(&x, &four), (&root, &three)], None),
            (&of_root, vec![(&x, &four), (&root, &minus)], None),
            (&of_root, vec![(&x, &four)], None),
            (&of_root, vec![(&root, &two)], None),
            (&of_root, vec![(&x, &zero), (&root, &zero)], Some(0)),
            // It is for an exponent above 0 only.
            (&of_power, vec![(&u, &zero), (&power, &zero)], None),
            (&of_power, vec![(&u, &zero), (&power, &one)], None),
            (
                &of_angle,
                vec![(&theta, &zero), (&half, &zero), (&cosine, &one)],
                Some(0),
            ),
            (
                &of_angle,
                vec![(&theta, &zero), (&half, &one), (&cosine, &one)],
                None,
            ),
            (&of_angle, vec![(&theta, &zero), (&half, &zero)], None),
            (&of_angle, vec![(&theta, &turned)], None),
            (&half, vec![(&half, &two)], Some(2)),
            (&(&k + &ln), vec![(&k, &one), (&ln, &zero)], Some(1)),
            (&(&k + &ln), vec![(&k, &one), (&ln, &one)], None),
            (&exp, vec![(&exp, &two)], Some(2)),
            (&exp, vec![(&exp, &-&k)], None),
            (&(&alpha * &exp), vec![(&alpha, &zero), (&exp, &two)], None),
            (&pi, vec![(&pi, &three)], None),
        ] {
            let found = ring.put(of, &values);
            let is_refused = matches!(found, Err(ExactError::AgainstRule(_)));
            let value = found
                .ok()
                .and_then(|found| ring.normal(&found).as_integer());
            assert_eq!(value, gives.map(dashu_int::IBig::from), "{}", ring.text(of));
            assert_eq!(is_refused, gives.is_none(), "{}", ring.text(of));
        }
        let values = [(&u, &zero), (&power, &zero)];
        ring.suppose_positive(&lambda - &one);
        assert!(ring.put(&of_power, &values).unwrap().is_literally_zero());
    }
}
