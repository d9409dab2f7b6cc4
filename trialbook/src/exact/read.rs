//! From a syntax tree to an element of the ring.

use super::error::ExactError;
use super::expr::{Binary, Expr, Function, Node};
use super::rational::Made;
use super::rational::Rational;
use super::ring::{PI, Ring};
use dashu_int::IBig;

/// Larger ones are not multiplied out.
const LARGEST_POWER: i64 = 64;
const MOST_HALVES: i64 = 32;
const MOST_MULTIPLES: i64 = 8;

impl Ring {
    /// Reads a formula as an element of the ring.
    ///
    /// # Errors
    /// [`ExactError`] for a symbol, an angle, a power, a logarithm that is not declared, and for a division
    /// by zero.
    pub fn read(&self, formula: Expr) -> Result<Rational, ExactError> {
        let made = Made::Read(formula.index());
        Ok(self.understood(formula)?.made_so(made))
    }

    fn understood(&self, formula: Expr) -> Result<Rational, ExactError> {
        match formula.node() {
            Node::Int(n) => Ok(Rational::int(n)),
            Node::Pi => Ok(Rational::generator(PI)),
            Node::Symbol(name) => self.named(name),
            Node::Neg(x) => Ok(-self.read(x)?),
            Node::Binary(op, x, y) => {
                let (x, y) = (self.read(x)?, self.read(y)?);
                match op {
                    Binary::Add => Ok(x + y),
                    Binary::Sub => Ok(x - y),
                    Binary::Mul => Ok(self.normal(&(x * y))),
                    Binary::Div => self.divide(&x, &y),
                    Binary::Pow => self.raise(&x, &y),
                }
            }
            Node::Call(function, x) => self.call(function, &self.read(x)?),
        }
    }

    pub(super) fn call(&self, function: Function, x: &Rational) -> Result<Rational, ExactError> {
        match function {
            Function::Sin => Ok(self.circular(x)?.1),
            Function::Cos => Ok(self.circular(x)?.0),
            Function::Tan => {
                let (cosine, sine) = self.circular(x)?;
                self.divide(&sine, &cosine)
            }
            Function::Cot => {
                let (cosine, sine) = self.circular(x)?;
                self.divide(&cosine, &sine)
            }
            Function::Sinh => Ok(self.hyperbolic_pair(x)?.1),
            Function::Cosh => Ok(self.hyperbolic_pair(x)?.0),
            Function::Tanh => {
                let (cosh, sinh) = self.hyperbolic_pair(x)?;
                self.divide(&sinh, &cosh)
            }
            Function::Coth => {
                let (cosh, sinh) = self.hyperbolic_pair(x)?;
                self.divide(&cosh, &sinh)
            }
            Function::Exp => self.exponential(x),
            Function::Ln => self.ln(x),
            Function::Sqrt => self.raise(x, &self.half()?),
            Function::Asin | Function::Acos => {
                let known = self.inverses.iter();
                for known in known.filter(|k| k.function == function) {
                    if self.is_zero(&(&known.of - x))? {
                        return Ok(known.angle.clone());
                    }
                }
                Err(ExactError::NoInverse {
                    function: function.name(),
                    of: self.text(x),
                })
            }
        }
    }

    /// Cosine and sine: the powers of h (1 + i u) = exp(iθ/2) of each angle, multiplied.
    pub(super) fn circular(&self, angle: &Rational) -> Result<(Rational, Rational), ExactError> {
        let error = || ExactError::NoAngle(self.text(angle));
        let (mut cosine, mut sine) = (Rational::int(1), Rational::int(0));
        for (g, halves) in angle.as_halves().ok_or_else(error)? {
            let (c, s) = if g == PI {
                (Rational::int(0), Rational::int(1))
            } else {
                let known = self.angles.iter().find(|[angle, ..]| *angle == g);
                let [_, tangent, half_cosine] = known.ok_or_else(error)?;
                let h = Rational::generator(*half_cosine);
                let s = &h * &Rational::generator(*tangent);
                (h, s)
            };
            if halves.abs() > MOST_HALVES {
                return Err(error());
            }
            let s = if halves < 0 { -s } else { s };
            for _ in 0..halves.abs() {
                let next = self.normal(&(&cosine * &c - &sine * &s));
                sine = self.normal(&(&cosine * &s + &sine * &c));
                cosine = next;
            }
        }
        Ok((cosine, sine))
    }

    pub(super) fn exponential(&self, argument: &Rational) -> Result<Rational, ExactError> {
        let error = || ExactError::NoArgument(self.text(argument));
        let mut product = Rational::int(1);
        for (g, halves) in argument.as_halves().ok_or_else(error)? {
            let known = self.arguments.iter().find(|[argument, _]| *argument == g);
            let [_, exponential] = known.ok_or_else(error)?;
            if halves.abs() > MOST_HALVES {
                return Err(error());
            }
            product = product * self.whole_power(&Rational::generator(*exponential), halves)?;
        }
        Ok(product)
    }

    pub(super) fn hyperbolic_pair(&self, x: &Rational) -> Result<(Rational, Rational), ExactError> {
        let (up, down) = (self.exponential(x)?, self.exponential(&-x)?);
        let two = Rational::int(2);
        Ok((
            self.divide(&(&up + &down), &two)?,
            self.divide(&(&up - &down), &two)?,
        ))
    }

    pub(super) fn whole_power(&self, base: &Rational, n: i64) -> Result<Rational, ExactError> {
        let size = u32::try_from(n.abs())
            .ok()
            .filter(|_| n.abs() <= LARGEST_POWER);
        let size = size.ok_or_else(|| ExactError::NoPower {
            base: self.text(base),
            exponent: n.to_string(),
        })?;
        if n < 0 {
            let inverse = self.divide(&Rational::int(1), base)?;
            return Ok(self.normal(&inverse.pow(size)));
        }
        Ok(self.normal(&base.pow(size)))
    }

    /// Whole powers by multiplication; others n e + m, with a declared exponent e and whole n and m, where
    /// the base is a product of bases declared with e.
    pub(super) fn raise(
        &self,
        base: &Rational,
        exponent: &Rational,
    ) -> Result<Rational, ExactError> {
        Ok(self.raised(base, exponent)?.formed())
    }

    fn raised(&self, base: &Rational, exponent: &Rational) -> Result<Rational, ExactError> {
        let error = || ExactError::NoPower {
            base: self.text(base),
            exponent: self.text(exponent),
        };
        let small = |n: IBig| i64::try_from(n).ok().filter(|n| n.abs() <= LARGEST_POWER);
        if let Some(n) = exponent.as_integer() {
            return self.whole_power(base, small(n).ok_or_else(error)?);
        }
        if base.as_integer() == Some(IBig::ONE) {
            return Ok(Rational::int(1));
        }
        let mut tried: Vec<&Rational> = Vec::new();
        for e in self.powers.iter().map(|known| &known.exponent) {
            if tried.iter().any(|t| (*t - e).is_literally_zero()) {
                continue;
            }
            tried.push(e);
            let multiples = (1..=MOST_MULTIPLES).flat_map(|n| [n, -n]);
            let split = multiples.into_iter().find_map(|n| {
                let rest = exponent - &(e * &Rational::int(n));
                Some((n, small(rest.as_integer()?)?))
            });
            let Some((n, m)) = split else { continue };
            if let Some(power) = self.known_product(base, e)? {
                let whole = self.whole_power(base, m)?;
                return Ok(self.normal(&(self.whole_power(&power, n)? * whole)));
            }
        }
        Err(error())
    }

    /// If the base is a product of whole powers of bases declared with e; if e is 1/n, also of a number with
    /// a root of degree n, or with one over a declared number.
    fn known_product(&self, base: &Rational, e: &Rational) -> Result<Option<Rational>, ExactError> {
        let mut rest = base.clone();
        let mut product = Rational::int(1);
        let mut numbers = Vec::new();
        for known in &self.powers {
            if !(&known.exponent - e).is_literally_zero() {
                continue;
            }
            let Some(prime) = &known.prime else {
                numbers.push(known);
                continue;
            };
            let k = rest.valuation(prime);
            if k != 0 {
                rest = self.divide(&rest, &self.whole_power(&known.base, k)?)?;
                product = product * self.whole_power(&known.value, k)?;
            }
        }
        // What is left has to be a number, which shows only when all else is divided out.
        let degree = e.reciprocal().and_then(|n| n.as_integer());
        let degree = degree.and_then(|n| u32::try_from(n).ok());
        let whole_root = |x: &Rational| degree.and_then(|n| x.whole_root(n));
        if let Some(root) = whole_root(&rest) {
            return Ok(Some(product * root));
        }
        for known in numbers {
            if let Some(root) = whole_root(&self.divide(&rest, &known.base)?) {
                return Ok(Some(product * &known.value * root));
            }
        }
        let complete = self.is_zero(&(rest - Rational::int(1)))?;
        Ok(complete.then_some(product))
    }

    pub(super) fn ln(&self, of: &Rational) -> Result<Rational, ExactError> {
        let mut rest = of.clone();
        let mut sum = Rational::int(0);
        for known in &self.logarithms {
            let k = rest.valuation(&known.prime);
            if k != 0 {
                rest = self.divide(&rest, &self.whole_power(&known.base, k)?)?;
                sum = sum + &known.value * &Rational::int(k);
            }
        }
        if self.is_zero(&(rest - Rational::int(1)))? {
            Ok(sum)
        } else {
            Err(ExactError::NoLogarithm(self.text(of)))
        }
    }
}

#[cfg(test)]
mod tests;
