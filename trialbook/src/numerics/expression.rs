//! A number as people type it: a decimal number, `2/sqrt(4+pi^2)` or `120deg`.

use crate::scalar::Scalar;

/// Why a text is no number.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ExpressionError {
    /// A comma where a point should be.
    #[error("`{0}`: the decimal sign is a point, not a comma")]
    Comma(String),
    /// A word that is neither a number nor a function.
    #[error("`{0}` is no number: numbers, + - * / ^ ( ), pi, deg and {FUNCTIONS} are known")]
    Word(String),
    /// A number that is not 0 and beyond those that can be read.
    #[error("`{0}` is too large a number, or too small a one")]
    Size(String),
    /// Something else than what has to come.
    #[error("`{text}` is no number: {wanted} is missing {place}")]
    Missing {
        /// The whole text.
        text: String,
        /// What is missing.
        wanted: &'static str,
        /// Where.
        place: String,
    },
    /// Too many brackets or signs within one another.
    #[error("more than {DEEPEST} brackets and signs within one another")]
    Deep,
}

const FUNCTIONS: &str = "sqrt, sin, cos, tan, asin, acos, sinh, cosh, tanh, exp, ln";

const DEEPEST: u32 = 64;

/// The value of an expression over any [`Scalar`]; `number` reads a decimal number without a sign.
///
/// There are `+ - * / ^ ( )`, `pi` or `π`, the functions by their usual names, and `deg` or `°`. A division
/// by zero gives what the scalar makes of it.
///
/// # Errors
/// [`ExpressionError`] where the text is no expression.
pub fn expression<S: Scalar>(
    text: &str,
    number: impl Fn(&str) -> Option<S>,
) -> Result<S, ExpressionError> {
    Ok(Formula::parse(text, number, false)?.at(S::int(0)))
}

/// An [`expression`] of the time `t`.
#[derive(Debug, Clone)]
pub enum Formula<S> {
    /// A number.
    Number(S),
    /// The time.
    Time,
    /// A function of one formula.
    One(fn(S) -> S, Box<Self>),
    /// A function of two.
    Two(fn(S, S) -> S, Box<[Self; 2]>),
}

impl<S: Scalar> Formula<S> {
    /// From a text, as [`expression`] takes it, in which `t` may stand.
    ///
    /// # Errors
    /// As for [`expression`].
    pub fn read(text: &str, number: impl Fn(&str) -> Option<S>) -> Result<Self, ExpressionError> {
        Self::parse(text, number, true)
    }

    fn parse(
        text: &str,
        number: impl Fn(&str) -> Option<S>,
        time: bool,
    ) -> Result<Self, ExpressionError> {
        let letters = |c: char| c.is_ascii_digit() || c.is_whitespace();
        let halves = |(a, b): (&str, &str)| a.ends_with(letters) && b.starts_with(letters);
        if text.split_once(',').is_some_and(halves) {
            return Err(ExpressionError::Comma(text.to_owned()));
        }
        let mut reader = Reader {
            text,
            rest: text.trim(),
            number,
            time,
            depth: 0,
        };
        let formula = reader.sum()?;
        match reader.rest {
            "" => Ok(formula),
            _ => Err(reader.missing("an operator")),
        }
    }

    /// Its value at a time.
    pub fn at(&self, t: S) -> S {
        match self {
            Self::Number(x) => *x,
            Self::Time => t,
            Self::One(f, a) => f(a.at(t)),
            Self::Two(f, ab) => f(ab[0].at(t), ab[1].at(t)),
        }
    }

    /// Its value, if that needs no time.
    pub fn fixed(&self) -> Option<S> {
        match self {
            Self::Number(x) => Some(*x),
            _ => None,
        }
    }

    fn one(f: fn(S) -> S, a: Self) -> Self {
        match a.fixed() {
            Some(a) => Self::Number(f(a)),
            None => Self::One(f, Box::new(a)),
        }
    }

    fn two(f: fn(S, S) -> S, a: Self, b: Self) -> Self {
        match (a.fixed(), b.fixed()) {
            (Some(a), Some(b)) => Self::Number(f(a, b)),
            _ => Self::Two(f, Box::new([a, b])),
        }
    }
}

struct Reader<'a, N> {
    text: &'a str,
    rest: &'a str,
    number: N,
    time: bool,
    depth: u32,
}

impl<S: Scalar, N: Fn(&str) -> Option<S>> Reader<'_, N> {
    fn missing(&self, wanted: &'static str) -> ExpressionError {
        ExpressionError::Missing {
            text: self.text.to_owned(),
            wanted,
            place: match self.rest {
                "" => "at the end".to_owned(),
                rest => format!("before `{rest}`"),
            },
        }
    }

    fn take(&mut self, signs: &[char]) -> Option<char> {
        let sign = self.rest.chars().next().filter(|c| signs.contains(c))?;
        self.rest = self.rest[sign.len_utf8()..].trim_start();
        Some(sign)
    }

    fn sum(&mut self) -> Result<Formula<S>, ExpressionError> {
        let mut sum = self.product()?;
        while let Some(sign) = self.take(&['+', '-', '−']) {
            let f = if sign == '+' { S::add } else { S::sub };
            sum = Formula::two(f, sum, self.product()?);
        }
        Ok(sum)
    }

    fn product(&mut self) -> Result<Formula<S>, ExpressionError> {
        let mut product = self.read_signed()?;
        while let Some(sign) = self.take(&['*', '·', '/']) {
            let f = if sign == '/' { S::div } else { S::mul };
            product = Formula::two(f, product, self.read_signed()?);
        }
        Ok(product)
    }

    /// A power with signs before it: −2² is −4.
    fn read_signed(&mut self) -> Result<Formula<S>, ExpressionError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(ExpressionError::Deep);
        }
        let value = match self.take(&['+', '-', '−']) {
            Some('+') => self.read_signed()?,
            Some(_) => Formula::one(S::neg, self.read_signed()?),
            None => {
                let base = self.atom()?;
                match self.take(&['^']) {
                    Some(_) => Formula::two(S::pow, base, self.read_signed()?),
                    None => base,
                }
            }
        };
        self.depth -= 1;
        Ok(value)
    }

    fn atom(&mut self) -> Result<Formula<S>, ExpressionError> {
        let value = if self.rest.starts_with('(') {
            self.bracket()?
        } else if self
            .rest
            .starts_with(|c: char| c.is_ascii_digit() || c == '.')
        {
            let digits = self.rest;
            self.rest = &digits[decimal(digits)..];
            let digits = &digits[..digits.len() - self.rest.len()];
            let size = digits.starts_with(|c: char| c.is_ascii_digit()) || digits.len() > 1;
            let wrong = if size {
                ExpressionError::Size
            } else {
                ExpressionError::Word
            };
            let number = (self.number)(digits);
            Formula::Number(number.ok_or_else(|| wrong(digits.to_owned()))?)
        } else {
            self.word()?
        };
        self.rest = self.rest.trim_start();
        match ["deg", "°"].iter().find_map(|d| self.rest.strip_prefix(d)) {
            Some(rest) => {
                self.rest = rest.trim_start();
                Ok(Formula::one(|x| x * S::pi() / S::int(180), value))
            }
            None => Ok(value),
        }
    }

    fn bracket(&mut self) -> Result<Formula<S>, ExpressionError> {
        self.take(&['(']).ok_or_else(|| self.missing("`(`"))?;
        let value = self.sum()?;
        self.take(&[')']).ok_or_else(|| self.missing("`)`"))?;
        Ok(value)
    }

    fn word(&mut self) -> Result<Formula<S>, ExpressionError> {
        let end = |c: char| !(c.is_alphabetic() || c == '√');
        let length = self.rest.find(end).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(length);
        if word.is_empty() {
            return Err(self.missing("a number"));
        }
        self.rest = rest.trim_start();
        let function = match word {
            "pi" | "π" => return Ok(Formula::Number(S::pi())),
            "t" if self.time => return Ok(Formula::Time),
            "sqrt" | "√" => S::sqrt,
            "sin" => S::sin,
            "cos" => S::cos,
            "tan" => S::tan,
            "asin" | "arcsin" => S::asin,
            "acos" | "arccos" => S::acos,
            "sinh" => S::sinh,
            "cosh" => S::cosh,
            "tanh" => S::tanh,
            "exp" => S::exp,
            "ln" | "log" => S::ln,
            _ => return Err(ExpressionError::Word(word.to_owned())),
        };
        Ok(Formula::one(function, self.bracket()?))
    }
}

fn decimal(text: &str) -> usize {
    let digits =
        |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let mut length = digits(text);
    if text[length..].starts_with('.') {
        length += 1 + digits(&text[length + 1..]);
    }
    if text[length..].starts_with(['e', 'E']) {
        let power = &text[length + 1..];
        let sign = usize::from(power.starts_with(['+', '-']));
        match digits(&power[sign..]) {
            0 => {}
            digits => length += 1 + sign + digits,
        }
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::double::Double;
    use std::f64::consts::PI;

    fn value(text: &str) -> Result<f64, ExpressionError> {
        expression(text, |digits| digits.parse().ok())
    }

    #[test]
    fn expressions_have_the_value_that_they_have_on_paper() {
        for (text, expected) in [
            ("0.5", 0.5),
            ("-.5e1", -5.0),
            ("2e", f64::NAN),
            ("1 + 2*3", 7.0),
            ("8/2/2", 2.0),
            ("7-2-1", 4.0),
            ("-2^2", -4.0),
            ("2^-1", 0.5),
            ("2^3^2", 512.0),
            ("2/sqrt(4+pi^2)", 2.0 / (4.0 + PI * PI).sqrt()),
            ("√(2)*sin(π/6)", 0.5 * 2.0_f64.sqrt()),
            ("120deg", 2.0 * PI / 3.0),
            ("-(30+60)°", -PI / 2.0),
            ("exp(ln(3)) - tan(45 deg)", 2.0),
            ("acos(-1)−asin(1)", PI / 2.0),
            ("cos(pi/3)", 0.5),
            ("sinh(ln(2))", 0.75),
            ("cosh(ln(2))", 1.25),
            ("tanh(ln(2))", 0.6),
        ] {
            match value(text) {
                Ok(found) => assert!(
                    (found - expected).abs() < 1e-14 * expected.abs(),
                    "{text}: {found}"
                ),
                Err(error) => assert!(expected.is_nan(), "{error}"),
            }
        }
        let third: Double = expression("1/3", |digits| digits.parse().ok()).unwrap();
        assert_eq!(third * Double::int(3), Double::int(1));
    }

    #[test]
    fn what_is_none_says_why() {
        for (text, why) in [
            ("", "a number is missing at the end"),
            ("0,5", "a point, not a comma"),
            ("1+", "a number is missing at the end"),
            ("(1", "`)` is missing at the end"),
            ("1 2", "an operator is missing before `2`"),
            ("sin 1", "`(` is missing before `1`"),
            ("lambda", "`lambda` is no number"),
            ("0x1", "an operator is missing before `x1`"),
            ("nan", "`nan` is no number"),
        ] {
            let error = value(text).unwrap_err().to_string();
            assert!(error.contains(why), "{text}: {error}");
        }
        assert_eq!(value(&"(".repeat(100_000)), Err(ExpressionError::Deep));
        assert_eq!(value(&"-".repeat(100_000)), Err(ExpressionError::Deep));
        assert_eq!(value(&"2^".repeat(100_000)), Err(ExpressionError::Deep));
    }
}
