//! The search for a number among the known ones, digit by digit.

use super::{ENCLOSED, Value, decimal, fraction, on_balls, places, shortest};
use crate::certified::ball::Ball;
use crate::numerics::expression::expression;
use crate::trials::runs::{Failure, failures};
use serde::Serialize;

/// A number found among those of the claims.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Match {
    /// Its short name.
    pub name: &'static str,
    /// Its value, to as many digits as are known, rounded.
    pub value: String,
    /// Its closed form, where there is one.
    pub closed: Option<&'static str>,
    /// What it is; formulas in `$…$`.
    pub meaning: &'static str,
    /// Id of the claim that carries it.
    pub claim: &'static str,
    /// How many of the given significant digits are right, from the first on.
    pub right: usize,
    /// Which significant digit is the first wrong one, from 1; nothing if none is known to be wrong.
    pub first_wrong: Option<usize>,
    /// Where that digit stands in the number as it was given, counted from 0.
    pub column: Option<usize>,
    /// How the number given comes from the value; nothing if a digit is wrong or beyond what is known.
    pub form: Option<Form>,
}

/// How a number with right digits comes from a longer one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// The longer one ends there.
    Exact,
    /// The nearest with so many digits.
    Rounded,
    /// The first digits of it, though the next one would have to be rounded up.
    Cut,
}

/// What cannot be searched for.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is no decimal number such as 0.537 or -4.6e0")]
pub struct NotDecimal(String);

failures!(NotDecimal);

/// Digits given beyond so many are not looked at.
const LONGEST: usize = 1000;

/// Wrong numbers are graded if at least so many of their first digits are right.
const ENOUGH: usize = 3;

/// An expression that is not told from 0 with twice 32 bits, doubled so often, is 0.
const FINEST: usize = 7;

/// A decimal number, or the value of an expression such as `2/sqrt(4+pi^2)` to twenty digits.
///
/// # Errors
/// A text that is neither, and an expression that is 0, has no value or has one beyond floating-point numbers.
pub fn decimal_of(given: &str) -> Result<String, Failure> {
    let fits = given
        .parse::<f64>()
        .is_ok_and(|x| x.is_finite() && x != 0.0);
    if fits && Digits::read(given).is_some() {
        return Ok(given.to_owned());
    }
    let formula = expression(given, fraction).map_err(|e| e.to_string())?;
    let ball = |bits| on_balls(formula, bits, &|_| None);
    let mut bits = (1..=FINEST).map(|doublings| 32 << doublings);
    let told = bits.find(|bits| ball(*bits).is_some_and(|ball| !ball.holds_zero()));
    let value = told.and_then(|bits| size(&ball(2 * bits)?));
    match value.filter(|value| value.is_finite()) {
        None if ball(32 << FINEST).is_some() && told.is_none() => {
            Err(format!("`{given}` is 0, or not to be told from it").into())
        }
        None => Err(format!("`{given}` has no finite value, or too large a one").into()),
        Some(value) => {
            let all = places(value, ENCLOSED);
            let text = shortest(all, |places| decimal(given, places));
            let text = text.map(|text| with_power(&text));
            Ok(text.ok_or_else(|| format!("the digits of `{given}` cannot be told"))?)
        }
    }
}

/// The number in a ball that does not hold 0, about.
fn size(ball: &Ball) -> Option<f64> {
    let value = ball.interval().mid();
    if value.abs() > 1.0 {
        return Some(value);
    }
    // In an interval as narrow as that a small number would lose its digits.
    let inverse = Ball::int(1, ball.bits()).over(ball)?;
    Some(1.0 / inverse.interval().mid())
}

fn with_power(text: &str) -> String {
    let digits = text.trim_start_matches(['-', '0', '.']);
    match text.split_once('.') {
        Some((_, decimals)) if decimals.len() > digits.len() + 3 => {
            let (sign, power) = (
                if text.starts_with('-') { "-" } else { "" },
                decimals.len() - digits.len() + 1,
            );
            let (first, rest) = digits.split_at(1);
            let point = if rest.is_empty() { "" } else { "." };
            format!("{sign}{first}{point}{rest}e-{power}")
        }
        _ => text.to_owned(),
    }
}

/// Of `values`, those that agree with `given` to all of its digits, else those that begin like it. The last
/// digit may be rounded or cut off; a single digit has to be all of the number.
///
/// # Errors
/// A text that is no decimal number, and a value that cannot be computed.
pub fn search<'a>(
    values: impl IntoIterator<Item = &'a Value>,
    given: &str,
) -> Result<Vec<Match>, Failure> {
    let wanted = Digits::read(given).ok_or_else(|| NotDecimal(given.to_owned()))?;
    let mut found = Vec::new();
    for value in values {
        found.extend(wanted.grade(value)?);
    }
    if found.iter().any(|m| m.first_wrong.is_none()) {
        found.retain(|m| m.first_wrong.is_none());
    } else {
        let most = found.iter().map(|m| m.right).max().unwrap_or(0);
        found.retain(|m| m.right == most && most >= ENOUGH);
    }
    Ok(found)
}

struct Digits {
    negative: bool,
    digits: Vec<u8>,
    columns: Vec<usize>,
    power: i64,
}

impl Digits {
    fn read(text: &str) -> Option<Self> {
        let value: f64 = text.parse().ok().filter(|v: &f64| v.is_finite())?;
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let exponent: i64 = exponent.parse::<i32>().ok()?.into();
        let (mut digits, mut columns) = (Vec::new(), Vec::new());
        let (mut power, mut after_point) = (exponent - 1, false);
        for (column, c) in mantissa.chars().enumerate() {
            let Some(digit) = c.to_digit(10) else {
                after_point |= c == '.';
                continue;
            };
            if digits.is_empty() && digit == 0 {
                power -= i64::from(after_point);
                continue;
            }
            digits.push(digit as u8);
            columns.push(column);
            power += i64::from(!after_point);
        }
        (!digits.is_empty()).then_some(Digits {
            negative: value < 0.0,
            digits,
            columns,
            power,
        })
    }

    /// Nothing if not even sign and size are the same.
    fn grade(&self, value: &Value) -> Result<Option<Match>, Failure> {
        let decimals = value.cut(self.digits.len().min(LONGEST) + 1)?;
        let known = Digits::read(&decimals).ok_or_else(|| NotDecimal(decimals.clone()))?;
        if known.negative != self.negative || known.power != self.power {
            return Ok(None);
        }
        let given = self.digits.len();
        let ends = |from: usize| known.digits.iter().skip(from).all(|digit| *digit == 0);
        if given == 1 && !(self.digits[0] == known.digits[0] && ends(1)) {
            return Ok(None);
        }
        let same = self
            .digits
            .iter()
            .zip(&known.digits)
            .take_while(|(a, b)| a == b)
            .count();
        // A number that ends, such as 7/2, is known to any length.
        let whole = same == given.min(known.digits.len());
        let settled = whole || self.rounds(&known.digits);
        let form = match known.digits.get(given) {
            _ if !settled => None,
            Some(_) if whole && ends(given) => Some(Form::Exact),
            Some(5..) if whole => Some(Form::Cut),
            next => next.map(|_| Form::Rounded),
        };
        let right = if settled {
            given.min(known.digits.len())
        } else {
            same
        };
        Ok(Some(Match {
            name: value.id,
            value: value.rounded()?,
            closed: value.closed,
            meaning: value.meaning,
            claim: value.claim,
            right,
            first_wrong: (!settled).then_some(same + 1),
            column: (!settled).then(|| self.columns[same]),
            form,
        }))
    }

    fn rounds(&self, known: &[u8]) -> bool {
        let given = self.digits.len();
        if given >= known.len() || known[given] < 5 {
            return false;
        }
        let mut rounded = known[..given].to_vec();
        for digit in rounded.iter_mut().rev() {
            *digit = (*digit + 1) % 10;
            if *digit != 0 {
                break;
            }
        }
        rounded == self.digits
    }
}

#[cfg(test)]
mod tests {
    use super::super::Number;
    use super::*;
    use std::f64::consts::PI;

    const fn value(
        id: &'static str,
        closed: Option<&'static str>,
        number: fn() -> Result<f64, Failure>,
    ) -> Value {
        Value::new(Number::new(id, number), "eq-1", 10, "", closed)
    }

    static VALUES: [Value; 5] = [
        value("lambda-c", None, || Ok(2.0 / libm::sqrt(4.0 + PI * PI))),
        value("q", None, || Ok(4.603_338_848_751_7)),
        value("minus", None, || Ok(-0.0858)),
        value("half", Some("7/2"), || Ok(3.5)),
        value("five", None, || Ok(0.732_51)),
    ];

    fn found(given: &str) -> Vec<(&'static str, usize, Option<usize>, Option<usize>)> {
        let found = search(&VALUES, given).unwrap();
        found
            .iter()
            .map(|m| (m.name, m.right, m.first_wrong, m.column))
            .collect()
    }

    #[test]
    fn a_number_is_found_however_it_is_written() {
        // λ_c = 0.53702927…
        for given in [
            "0.537", ".537", "0.5370", "+5.37e-1", "537e-3", "0.0537E1", "0.54", "0.53703",
        ] {
            let [("lambda-c", right, None, None)] = found(given)[..] else {
                panic!("{given}: {:?}", found(given))
            };
            let digits = given.split(['e', 'E']).next().unwrap();
            let digits = digits.chars().filter(char::is_ascii_digit);
            assert_eq!(right, digits.skip_while(|c| *c == '0').count(), "{given}");
        }
    }

    #[test]
    fn the_first_wrong_digit_is_marked_where_it_stands() {
        assert_eq!(found("0.53701"), [("lambda-c", 4, Some(5), Some(6))]);
        assert_eq!(found("5371e-4"), [("lambda-c", 3, Some(4), Some(3))]);
    }

    #[test]
    fn digits_are_cut_or_rounded_by_the_next_one() {
        // 2/√(4 + π²) = 0.53702927…, 4.6033388487517
        for (given, form) in [
            ("0.537", Form::Rounded),
            ("0.53703", Form::Rounded),
            ("0.53702", Form::Cut),
            ("4.60333", Form::Cut),
            ("4.60334", Form::Rounded),
            ("4.6033", Form::Rounded),
            // Before a 5, and rounded there.
            ("0.732", Form::Cut),
            ("0.733", Form::Rounded),
            ("-0.085", Form::Cut),
            ("-0.086", Form::Rounded),
            ("3.5", Form::Exact),
            ("3.500", Form::Exact),
        ] {
            let found = search(&VALUES, given).unwrap();
            let [m] = &found[..] else {
                panic!("{given}: {found:?}")
            };
            assert_eq!(m.form, Some(form), "{given}");
        }
    }

    #[test]
    fn fewer_than_three_right_digits_are_none() {
        for given in ["0.51", "0.533", "0.5391", "4.7", "4.61", "-0.0851"] {
            let right = found(given);
            assert!(right.is_empty(), "{given}: {right:?}");
        }
        assert_eq!(found("0.5374"), [("lambda-c", 3, Some(4), Some(5))]);
        assert_eq!(found("4.601"), [("q", 3, Some(4), Some(4))]);
    }

    #[test]
    fn sign_and_size_have_to_be_right() {
        for given in ["-0.537", "5.37", "0.0537", "537"] {
            assert!(found(given).iter().all(|m| m.0 != "lambda-c"), "{given}");
        }
    }

    #[test]
    fn digits_are_rounded_with_a_carry() {
        let known = |text: &str| Digits::read(text).unwrap();
        for (given, all, rounds) in [
            ("0.54", "0.537", true),
            ("0.53", "0.537", false),
            ("0.40", "0.397", true),
            ("0.54", "0.534", false),
            ("0.537", "0.537", false),
            ("0.535", "0.5345", true),
            ("0.56", "0.537", false),
        ] {
            assert_eq!(
                known(given).rounds(&known(all).digits),
                rounds,
                "{given} {all}"
            );
        }
    }

    #[test]
    fn what_is_no_decimal_number_is_refused() {
        for given in [
            "",
            "twelve",
            "0",
            "0.00",
            "nan",
            "inf",
            "1e",
            "0x1",
            "1e-2147483649",
        ] {
            let refused = search(&VALUES, given).unwrap_err();
            assert_eq!(refused.to_string(), NotDecimal(given.into()).to_string());
        }
    }

    #[test]
    fn a_number_is_read_by_sign_digits_and_power() {
        for (given, negative, digits, power) in [
            ("537", false, [5, 3, 7], 2),
            ("-5.37", true, [5, 3, 7], 0),
            ("0.0537", false, [5, 3, 7], -2),
            ("-.100", true, [1, 0, 0], -1),
            ("5.37e3", false, [5, 3, 7], 3),
            ("-053.7E-10", true, [5, 3, 7], -9),
        ] {
            let read = Digits::read(given).unwrap();
            assert_eq!((read.negative, read.power), (negative, power), "{given}");
            assert_eq!(read.digits, digits, "{given}");
        }
    }
}
