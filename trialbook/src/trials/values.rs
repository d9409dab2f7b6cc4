//! The numbers by which a claim can be found.

mod search;

pub use search::{Form, Match, NotDecimal, decimal_of, search};

use super::compare::Failure;
use super::enclosed::on_balls;
use crate::certified::ball::bits_for;
use crate::certified::enclosure::Enclosure;
use crate::exact::Expr;
use crate::numerics::expression::expression;
use crate::scalar::Scalar;
use crate::seeded::reading::{self, Read};
use std::panic::Location;
use std::sync::OnceLock;

#[derive(Debug, Clone, Copy)]
pub struct Number {
    /// Short name for the pages: `lambda-c`.
    pub id: &'static str,
    enclosure: Option<Enclosure>,
    computed: Option<fn() -> Result<f64, Failure>>,
    pub(super) place: &'static Location<'static>,
}

impl Number {
    /// What a function computes.
    #[track_caller]
    pub const fn new(id: &'static str, number: fn() -> Result<f64, Failure>) -> Self {
        Self {
            id,
            enclosure: None,
            computed: Some(number),
            place: Location::caller(),
        }
    }

    /// What an enclosure alone tells.
    #[track_caller]
    pub const fn enclosed(id: &'static str, enclosure: Enclosure) -> Self {
        Self {
            id,
            enclosure: Some(enclosure),
            computed: None,
            place: Location::caller(),
        }
    }

    /// The same number, which can be enclosed too.
    pub const fn within(mut self, enclosure: Enclosure) -> Self {
        self.enclosure = Some(enclosure);
        self
    }
}

/// A number of a claim, computed when it is first asked for.
#[derive(Debug)]
pub struct Value {
    /// Short name for the pages: `lambda-c`.
    pub id: &'static str,
    /// What it is; formulas in `$…$`.
    pub meaning: &'static str,
    /// Id of the claim.
    pub claim: &'static str,
    /// Decimals shown, all of them certain.
    pub decimals: usize,
    /// How it is enclosed to any number of digits, where that is known.
    pub enclosure: Option<Enclosure>,
    /// Its closed form, as [`expression`] reads it, where there is one.
    pub closed: Option<&'static str>,
    computed: Option<fn() -> Result<f64, Failure>>,
    number: OnceLock<(Result<f64, Failure>, Read)>,
}

impl Value {
    /// A number of the claim of this id, with so many decimals shown.
    pub const fn new(
        number: Number,
        claim: &'static str,
        decimals: usize,
        meaning: &'static str,
        closed: Option<&'static str>,
    ) -> Self {
        Self {
            id: number.id,
            meaning,
            claim,
            decimals,
            enclosure: number.enclosure,
            closed,
            computed: number.computed,
            number: OnceLock::new(),
        }
    }

    /// The number; whoever watches notes what it was computed from.
    ///
    /// # Errors
    /// A motion that cannot be followed, an enclosure that is not proved.
    pub fn number(&self) -> Result<f64, Failure> {
        let compute = || match (self.computed, self.enclosure) {
            (Some(computed), _) => computed(),
            (None, Some(enclosure)) => Ok(enclosure.interval()?.mid()),
            (None, None) => Err("nothing computes it".into()),
        };
        let (number, read) = self.number.get_or_init(|| reading::of(compute));
        reading::also(read);
        number.clone()
    }

    /// Its decimals, correctly rounded to `digits` after the point.
    ///
    /// # Errors
    /// A number without an enclosure, and as [`Enclosure::decimal`].
    pub fn decimal(&self, digits: usize) -> Result<String, Failure> {
        let enclosure = self.enclosure.ok_or("it has no enclosure")?;
        Ok(enclosure.decimal(digits)?)
    }

    /// The number as shown.
    ///
    /// # Errors
    /// A motion that cannot be followed.
    pub fn shown(&self) -> Result<String, Failure> {
        Ok(format!("{:.*}", self.decimals, self.number()?))
    }

    /// How many significant digits are known: of an enclosed number more than [`KNOWN`].
    pub fn known(&self) -> usize {
        // With few decimals a number such as 7/2 lies half-way between two, and no bounds tell which is nearer.
        match self.exactly(ENCLOSED) {
            Some(_) => ENCLOSED,
            None => KNOWN,
        }
    }

    /// The number to all [known](Self::known) digits, rounded; a shorter decimal fraction as it stands.
    ///
    /// # Errors
    /// A motion that cannot be followed.
    pub fn rounded(&self) -> Result<String, Failure> {
        let value = self.number()?;
        let all = places(value, ENCLOSED);
        let exact = shortest(all, |places| self.exactly(places));
        Ok(exact.unwrap_or_else(|| format!("{value:.*}", places(value, KNOWN))))
    }

    /// The number to all [known](Self::known) digits, cut off and not rounded.
    ///
    /// # Errors
    /// A motion that cannot be followed.
    pub fn digits(&self) -> Result<String, Failure> {
        self.cut(self.known())
    }

    /// To so many significant digits if they can be had, and at least to all [known](Self::known) ones; cut
    /// off.
    fn cut(&self, significant: usize) -> Result<String, Failure> {
        let value = self.number()?;
        // Some digits more, so that rounding does not reach those that are kept.
        for more in [5, 7] {
            let all = places(value, significant.max(ENCLOSED)) + more;
            if let Some(mut exact) = self.exactly(all) {
                exact.truncate(exact.len() - more);
                return Ok(exact);
            }
        }
        let mut text = format!("{value:.*}", places(value, KNOWN) + 5);
        text.truncate(text.len() - 5);
        Ok(text)
    }

    fn exactly(&self, places: usize) -> Option<String> {
        match (self.enclosure, self.closed) {
            (Some(enclosure), _) => enclosure.decimal(places).ok(),
            (None, Some(form)) => decimal(form, places),
            (None, None) => None,
        }
    }
}

fn places(value: f64, significant: usize) -> usize {
    let power = libm::floor(libm::log10(value.abs())) as i64;
    usize::try_from(significant as i64 - 1 - power).unwrap_or(0)
}

/// Fewer if the number ends before them, for as far as can be told.
fn shortest(places: usize, decimals: impl Fn(usize) -> Option<String>) -> Option<String> {
    // One that ends with a 5 half-way between two is no longer half-way at its last place.
    let mut enough = places..places + 2;
    let (places, text) = enough.find_map(|places| Some((places, decimals(places)?)))?;
    let longer = decimals(places + ENCLOSED);
    let more = longer.as_deref().and_then(|all| all.strip_prefix(&text));
    let ends = more.is_some_and(|more| more.bytes().all(|c| matches!(c, b'0' | b'.')));
    Some(match ends && text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    })
}

/// Correctly rounded; nothing where it cannot be enclosed.
fn decimal(form: &str, places: usize) -> Option<String> {
    let formula = expression(form, fraction).ok()?;
    // What the parts lose by their size, or by being nearly alike, more bits bring back.
    let mut bits = (0..8).map(|doublings| bits_for(places) + (32 << doublings));
    bits.find_map(|bits| on_balls(formula, bits, &|_| None)?.decimal(places))
}

/// Nothing for one with a large exponent.
fn fraction(text: &str) -> Option<Expr> {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digit = |sum: Expr, c: char| Some(sum * Expr::int(10) + Expr::int(c.to_digit(10)?.into()));
    let all = [whole, decimals].concat();
    let (first, rest) = all.split_at(all.len().min(18));
    let digits = rest
        .chars()
        .try_fold(Expr::int(first.parse().ok()?), digit)?;
    let power = exponent.parse::<i64>().ok()? - i64::try_from(decimals.len()).ok()?;
    let ten = || Expr::int(10).pow(Expr::int(power.abs()));
    match power.signum() {
        _ if power.abs() > FARTHEST => None,
        -1 => Some(digits / ten()),
        1 => Some(digits * ten()),
        _ => Some(digits),
    }
}

/// The largest power of ten in an expression.
const FARTHEST: i64 = 300;

/// Significant digits of every value; the least come from a bisection on a motion.
pub const KNOWN: usize = 11;

/// Significant digits shown of a number that can be enclosed.
pub(crate) const ENCLOSED: usize = 20;
