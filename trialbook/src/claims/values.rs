//! The numbers by which a claim can be found: computed, each with the claim that it belongs to.

mod search;

pub use search::{Match, NotDecimal, search};

use super::compare::Failure;
use crate::certified::enclosure::Enclosure;
use crate::seeded::reading::{self, Read};
use std::sync::OnceLock;

/// A number, computed when it is first asked for.
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
    computed: Option<fn() -> Result<f64, Failure>>,
    number: OnceLock<(Result<f64, Failure>, Read)>,
}

impl Value {
    /// A number of a claim, which `number` computes.
    pub const fn new(
        id: &'static str,
        claim: &'static str,
        decimals: usize,
        meaning: &'static str,
        number: fn() -> Result<f64, Failure>,
    ) -> Self {
        Value {
            id,
            meaning,
            claim,
            decimals,
            enclosure: None,
            computed: Some(number),
            number: OnceLock::new(),
        }
    }

    /// A number of a claim by its enclosure alone.
    pub const fn enclosed(
        id: &'static str,
        claim: &'static str,
        decimals: usize,
        meaning: &'static str,
        enclosure: Enclosure,
    ) -> Self {
        Value {
            id,
            meaning,
            claim,
            decimals,
            enclosure: Some(enclosure),
            computed: None,
            number: OnceLock::new(),
        }
    }

    /// The same number, which can be enclosed too.
    pub const fn within(mut self, enclosure: Enclosure) -> Self {
        self.enclosure = Some(enclosure);
        self
    }

    /// The number; whoever watches notes what it was computed from, now or before.
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

    /// The number to [`KNOWN`] significant digits, cut off and not rounded.
    ///
    /// # Errors
    /// A motion that cannot be followed.
    pub fn digits(&self) -> Result<String, Failure> {
        let value = self.number()?;
        let power = libm::floor(libm::log10(value.abs())) as i32;
        let places = (KNOWN as i32 - 1 - power).max(0) as usize;
        // Five digits more, so that rounding does not reach those that are kept.
        let mut text = format!("{value:.*}", places + 5);
        text.truncate(text.len() - 5);
        Ok(text)
    }
}

/// Significant digits that every value is good for: the least come from a bisection on a motion.
pub const KNOWN: usize = 11;
