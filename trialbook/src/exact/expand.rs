//! A formula read as a power series: each symbol may stand for one.

use super::error::ExactError;
use super::expr::{Binary, Expr, Function, Node};
use super::rational::Rational;
use super::ring::Ring;
use super::series::Series;

impl Ring {
    /// Reads a formula in which some symbols stand for series; all else is read as by [`Ring::read`]. Nothing
    /// is kept beyond `order`.
    ///
    /// # Errors
    /// As [`Ring::read`], and [`ExactError::NoSeries`] where the formula has no series in whole powers.
    pub fn expand(
        &self,
        formula: Expr,
        series: &[(&str, &Series)],
        order: i64,
    ) -> Result<Series, ExactError> {
        let expanded = self.expanded(formula, series, order)?;
        Ok(expanded.mapped(|_, c| c.formed()))
    }

    fn expanded(
        &self,
        formula: Expr,
        series: &[(&str, &Series)],
        order: i64,
    ) -> Result<Series, ExactError> {
        let expand = |x: Expr| self.expand(x, series, order);
        match formula.node() {
            Node::Int(_) | Node::Pi => Ok(Series::constant(self.read(formula)?, order)),
            Node::Symbol(name) => match series.iter().find(|(known, _)| *known == name) {
                Some((_, known)) => Ok((*known).clone()),
                None => Ok(Series::constant(self.named(name)?, order)),
            },
            Node::Neg(x) => Ok(expand(x)?.negated()),
            Node::Call(function, x) => match self.exponential_of(x, series)? {
                Some(pair) => self.by_pair(function, pair),
                None => self.call_on_series(function, &expand(x)?, order),
            },
            Node::Binary(op, x, y) => {
                let (x, y) = (expand(x)?, expand(y)?);
                match op {
                    Binary::Add => Ok(x.plus(&y)),
                    Binary::Sub => Ok(x.minus(&y)),
                    Binary::Mul => Ok(x.times(&y, self)),
                    Binary::Div => x.over(&y, self),
                    Binary::Pow => {
                        let (exponent, rest) = y.split(self)?;
                        for c in rest.iter().skip(1) {
                            if !self.is_zero(c)? {
                                let what = "with an exponent that varies".into();
                                return Err(ExactError::NoSeries(what));
                            }
                        }
                        x.power(&exponent, self)
                    }
                }
            }
        }
    }

    fn call_on_series(
        &self,
        function: Function,
        x: &Series,
        order: i64,
    ) -> Result<Series, ExactError> {
        match function {
            Function::Sqrt => x.power(&self.half()?, self),
            Function::Sin => Ok(self.pair(x, -1)?.1),
            Function::Cos => Ok(self.pair(x, -1)?.0),
            Function::Tan => {
                let (cosine, sine) = self.pair(x, -1)?;
                sine.over(&cosine, self)
            }
            Function::Cot => {
                let (cosine, sine) = self.pair(x, -1)?;
                cosine.over(&sine, self)
            }
            Function::Sinh | Function::Cosh | Function::Tanh | Function::Coth | Function::Exp => {
                self.by_pair(function, self.pair(x, 1)?)
            }
            Function::Ln => {
                let (first, _) = x.split(self)?;
                self.integrated(self.ln(&first)?, x, x)
            }
            Function::Asin | Function::Acos => {
                let (first, _) = x.split(self)?;
                let start = match (first.is_literally_zero(), function) {
                    (true, Function::Asin) => Rational::int(0),
                    (true, _) => self.read(Expr::new(Node::Pi))? * self.half()?,
                    (false, _) => self.call(function, &first)?,
                };
                let one = Series::constant(Rational::int(1), order);
                let root = one.minus(&x.times(x, self)).power(&self.half()?, self)?;
                match function {
                    Function::Asin => self.integrated(start, x, &root),
                    _ => self.integrated(start, x, &root.negated()),
                }
            }
        }
    }

    fn exponential_of(
        &self,
        x: Expr,
        series: &[(&str, &Series)],
    ) -> Result<Option<(Series, Series)>, ExactError> {
        let (n, name) = match x.node() {
            Node::Symbol(name) => (1, name),
            Node::Binary(Binary::Mul, n, x) => match (n.node(), x.node()) {
                (Node::Int(n), Node::Symbol(name)) => (n, name),
                _ => return Ok(None),
            },
            _ => return Ok(None),
        };
        let is_it = |known: &str| known.strip_prefix("exp ") == Some(name);
        let Some((_, exponential)) = series.iter().find(|(known, _)| is_it(known)) else {
            return Ok(None);
        };
        let power = |n| exponential.power(&Rational::int(n), self);
        let (up, down) = (power(n)?, power(-n)?);
        let half = self.half()?;
        let halved = |s: Series| s.map(|c| Ok::<_, ExactError>(c * &half));
        Ok(Some((halved(up.plus(&down))?, halved(up.minus(&down))?)))
    }

    fn by_pair(
        &self,
        function: Function,
        (cosh, sinh): (Series, Series),
    ) -> Result<Series, ExactError> {
        match function {
            Function::Cosh => Ok(cosh),
            Function::Sinh => Ok(sinh),
            Function::Tanh => sinh.over(&cosh, self),
            Function::Coth => cosh.over(&sinh, self),
            Function::Exp => Ok(cosh.plus(&sinh)),
            _ => Err(ExactError::NoSeries(format!(
                "of {} of what only its exponential is known",
                function.name()
            ))),
        }
    }

    pub(super) fn half(&self) -> Result<Rational, ExactError> {
        self.divide(&Rational::int(1), &Rational::int(2))
    }

    /// start + ∫ dx/y.
    fn integrated(&self, start: Rational, x: &Series, y: &Series) -> Result<Series, ExactError> {
        let slope = |(k, c): (usize, &Rational)| c * &Rational::int(k as i64);
        let (_, coefficients) = x.split(self)?;
        let weighted = coefficients.iter().enumerate().map(slope).collect();
        let rate = Series::new(0, weighted).over(y, self)?;
        let mut sum = vec![start];
        for k in 1..=rate.order() {
            let c = rate.coefficient(k).unwrap_or(Rational::int(0));
            sum.push(self.divide(&c, &Rational::int(k))?);
        }
        Ok(Series::new(0, sum))
    }

    /// For `sign` −1 or, hyperbolic, +1: s′ = x′ c and c′ = `sign` x′ s.
    fn pair(&self, x: &Series, sign: i64) -> Result<(Series, Series), ExactError> {
        let (first, x) = x.split(self)?;
        let (c, s) = if sign < 0 {
            self.circular(&first)?
        } else {
            self.hyperbolic_pair(&first)?
        };
        let (mut c, mut s) = (vec![c], vec![s]);
        for n in 1..x.len() {
            let [mut to_c, mut to_s] = [0, 0].map(Rational::int);
            for k in 1..=n {
                let rate = &x[k] * &Rational::int(k as i64);
                to_s = to_s + &rate * &c[n - k];
                to_c = to_c + &rate * &s[n - k] * Rational::int(sign);
            }
            let over_n = |x: &Rational| self.divide(&self.normal(x), &Rational::int(n as i64));
            c.push(over_n(&to_c)?);
            s.push(over_n(&to_s)?);
        }
        Ok((Series::new(0, c), Series::new(0, s)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Scalar;

    fn coefficients(formula: Expr, from: i64) -> Vec<String> {
        let ring = Ring::new();
        let x = Series::monomial(Rational::int(1), 1, 7);
        let series = ring.expand(formula, &[("x", &x)], 7).unwrap();
        let known = (from..from + 5).map(|k| series.coefficient(k).unwrap());
        known.map(|c| ring.text(&c)).collect()
    }

    #[test]
    fn known_series_come_out() {
        let (x, one) = (Expr::symbol("x"), Expr::int(1));
        for (formula, from, expected) in [
            (x.tan(), 1, ["1", "0", "1/3", "0", "2/15"]),
            (x.coth(), -1, ["1", "0", "1/3", "0", "−1/45"]),
            (x.exp(), 0, ["1", "1", "1/2", "1/6", "1/24"]),
            (x.asin(), 1, ["1", "0", "1/6", "0", "3/40"]),
            (x.acos(), 0, ["π/2", "−1", "0", "−1/6", "0"]),
            ((one + x).sqrt(), 0, ["1", "1/2", "−1/8", "1/16", "−5/128"]),
            (one / (one - x).squared(), 0, ["1", "2", "3", "4", "5"]),
            (
                (x.cosh() - x.cos()) / x.squared(),
                0,
                ["1", "0", "0", "0", "1/360"],
            ),
        ] {
            assert_eq!(coefficients(formula, from), expected, "{formula}");
        }
    }

    #[test]
    fn what_has_no_series_is_refused() {
        let ring = Ring::new();
        let x = Series::monomial(Rational::int(1), 1, 7);
        for formula in [
            Expr::symbol("x").sqrt(),
            (Expr::int(1) / Expr::symbol("x")).sin(),
            Expr::int(1) / (Expr::symbol("x") - Expr::symbol("x")),
            Expr::symbol("x").ln(),
        ] {
            assert!(ring.expand(formula, &[("x", &x)], 7).is_err(), "{formula}");
        }
    }

    #[test]
    fn a_power_whose_exponent_varies_is_refused() {
        let ring = Ring::new();
        let small = Series::monomial(Rational::int(1), 1, 7);
        let (x, one) = (Expr::symbol("x"), Expr::int(1));
        let power = |exponent| ring.expand((one + x).pow(exponent), &[("x", &small)], 7);
        assert!(power(one + one).is_ok());
        for order in 1..=7 {
            let what = power(one + x.pow(Expr::int(order)));
            assert!(matches!(what, Err(ExactError::NoSeries { .. })), "{order}");
        }
    }

    #[test]
    fn what_is_expanded_about_a_pole_is_refused() {
        let ring = Ring::new();
        let small = Series::monomial(Rational::int(1), 1, 9);
        let (x, one) = (Expr::symbol("x"), Expr::int(1));
        for order in 1..=4 {
            let pole = one / x.pow(Expr::int(order));
            for y in [pole, pole + one + x, one - pole] {
                for formula in [
                    y.sin(),
                    y.cos(),
                    y.tan(),
                    y.exp(),
                    y.sinh(),
                    y.ln(),
                    y.asin(),
                    y.acos(),
                    (one + x).pow(y),
                ] {
                    let what = ring.expand(formula, &[("x", &small)], 5);
                    assert!(
                        matches!(what, Err(ExactError::NoSeries { .. })),
                        "{formula}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_series_known_less_far_spoils_no_more_than_it_must() {
        let ring = Ring::new();
        let x = Series::monomial(Rational::int(1), 1, 2);
        let formula = Expr::symbol("x").squared();
        let square = ring.expand(formula, &[("x", &x)], 9).unwrap();
        assert_eq!(square.order(), 3);
        assert!(square.coefficient(4).is_none());
    }
}
