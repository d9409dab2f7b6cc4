//! Linear equations for free symbols: how the coefficients of a power series are found.

use super::error::ExactError;
use super::rational::Made;
use super::rational::Rational;
use super::ring::Ring;

impl Ring {
    /// Solves equations linear in free symbols, each with the coefficients of the powers of `monomials`
    /// compared. Symbols left free keep themselves.
    ///
    /// # Errors
    /// [`ExactError::Unsolvable`] if they contradict each other; as [`Ring::derivative`] and [`Ring::divide`].
    pub fn solve(
        &self,
        equations: &[Rational],
        powers_of: Option<&Rational>,
        unknowns: &[&str],
    ) -> Result<Vec<(Rational, Rational)>, ExactError> {
        let solved = self.solved(equations, powers_of, unknowns)?.into_iter();
        let given = |x: Rational| x.made_so(Made::Given);
        Ok(solved.map(|(x, value)| (given(x), given(value))).collect())
    }

    fn solved(
        &self,
        equations: &[Rational],
        powers_of: Option<&Rational>,
        unknowns: &[&str],
    ) -> Result<Vec<(Rational, Rational)>, ExactError> {
        let mut open = Vec::new();
        for equation in equations {
            let equation = Rational::from(self.normal(equation).numerator().clone());
            match powers_of {
                None => open.push(equation),
                Some(generator) => {
                    let Some(index) = generator.generators().next() else {
                        continue;
                    };
                    let parts = equation.numerator().coefficients_in(index);
                    open.extend(parts.into_values().map(Rational::from));
                }
            }
        }
        let mut solved: Vec<(Rational, Rational)> = Vec::new();
        for name in unknowns {
            let (symbol, by) = (self.named(name)?, self.by(name)?);
            let mut pivot = None;
            for (i, equation) in open.iter().enumerate() {
                let slope = self.derivative(equation, &by)?;
                if !self.is_zero(&slope)? {
                    pivot = Some((i, slope));
                    break;
                }
            }
            let Some((i, slope)) = pivot else { continue };
            let equation = open.swap_remove(i);
            let rest = self.put(&equation, &[(&symbol, &Rational::int(0))])?;
            let value = self.divide(&-&rest, &slope)?;
            let into = |x: &Rational| Ok(self.normal(&self.put(x, &[(&symbol, &value)])?));
            open = open.iter().map(into).collect::<Result<_, ExactError>>()?;
            for (_, earlier) in &mut solved {
                *earlier = into(earlier)?;
            }
            solved.push((symbol, value));
        }
        for equation in open {
            if !self.is_zero(&equation)? {
                let left = self.text(&equation);
                return Err(ExactError::Unsolvable(left));
            }
        }
        Ok(solved)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Expr;
    use crate::scalar::Scalar;

    fn solved(equations: &[Expr]) -> Result<Vec<String>, ExactError> {
        let mut ring = Ring::new();
        for name in ["x", "y", "t", "p"] {
            ring.symbol(name);
        }
        let equations: Result<Vec<_>, _> = equations.iter().map(|e| ring.read(*e)).collect();
        let solved = ring.solve(&equations?, Some(&ring.named("t")?), &["x", "y"])?;
        let text = |(x, value)| format!("{} = {}", ring.text(&x), ring.text(&value));
        Ok(solved.into_iter().map(text).collect())
    }

    #[test]
    fn each_power_gives_an_equation() {
        let [x, y, t, p] = ["x", "y", "t", "p"].map(Expr::symbol);
        let one = Expr::int(1);
        // p x − 1 + (x + y) t = 0 for all t.
        let both = solved(&[p * x - one + (x + y) * t]);
        assert_eq!(both.unwrap(), ["x = 1/p", "y = −1/p"]);
        assert_eq!(solved(&[(x + y - p) * t]).unwrap(), ["x = −(y − p)"]);
        let contradiction = solved(&[x - one + x * t]);
        assert!(matches!(contradiction, Err(ExactError::Unsolvable { .. })));
    }

    /// Wherever it stands.
    #[test]
    fn one_contradiction_is_enough() {
        let [x, y] = ["x", "y"].map(Expr::symbol);
        let one = Expr::int(1);
        let agree = [
            x - one,
            y + x - one,
            x + x - one - one,
            y + x - one,
            x - one,
        ];
        assert_eq!(solved(&agree).unwrap(), ["x = 1", "y = 0"]);
        for place in 0..agree.len() {
            let mut equations = agree;
            equations[place] = equations[place] + one;
            let contradiction = solved(&equations);
            assert!(
                matches!(contradiction, Err(ExactError::Unsolvable { .. })),
                "{place}: {contradiction:?}"
            );
        }
    }
}
