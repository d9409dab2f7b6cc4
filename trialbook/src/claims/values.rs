//! The numbers by which a claim can be found: computed, each with the claim that it belongs to.

mod search;

pub use search::{Match, NotDecimal, search};

use super::compare::Failure;
use std::sync::LazyLock;

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
    number: LazyLock<Result<f64, Failure>>,
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
            number: LazyLock::new(number),
        }
    }

    /// The number.
    ///
    /// # Errors
    /// A motion that cannot be followed.
    pub fn number(&self) -> Result<f64, Failure> {
        let failed = |error: &Failure| error.to_string().into();
        self.number.as_ref().copied().map_err(failed)
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
