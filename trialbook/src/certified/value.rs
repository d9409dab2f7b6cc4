//! A number that is stated somewhere, with as many certain digits as one asks for.

use super::ball::{Ball, bits_for};
use super::error::CertifiedError;
use super::interval::Interval;

/// A number, and how to enclose it.
#[derive(Debug, Clone, Copy)]
pub struct Value {
    /// A name that is its own.
    pub name: &'static str,
    /// Its symbol, in LaTeX.
    pub symbol: &'static str,
    /// What it is, in a few words. All of them are dimensionless.
    pub meaning: &'static str,
    /// Encloses it with this many bits after the point.
    ball: fn(usize) -> Result<Ball, CertifiedError>,
}

impl Value {
    /// A number, by its enclosure with so many bits after the point; dimensionless.
    pub const fn new(
        name: &'static str,
        symbol: &'static str,
        meaning: &'static str,
        ball: fn(usize) -> Result<Ball, CertifiedError>,
    ) -> Self {
        Self {
            name,
            symbol,
            meaning,
            ball,
        }
    }

    /// An enclosure to about `digits` decimals.
    ///
    /// # Errors
    /// [`CertifiedError`] if it is not proved to exist.
    pub fn ball(&self, digits: usize) -> Result<Ball, CertifiedError> {
        (self.ball)(bits_for(digits))
    }

    /// The number's decimals, correctly rounded to `digits` after the point.
    ///
    /// # Errors
    /// As [`ball`](Self::ball), and [`CertifiedError::NotProved`] if the number is so close to the middle between
    /// two decimals that this enclosure cannot tell which is nearer.
    pub fn decimal(&self, digits: usize) -> Result<String, CertifiedError> {
        let ball = self.ball(digits)?;
        let close = || CertifiedError::unproved("the rounding is not certain", &[ball.interval()]);
        ball.decimal(digits).ok_or_else(close)
    }

    /// Neighbouring f64 around it.
    ///
    /// # Errors
    /// As [`ball`](Self::ball).
    pub fn interval(&self) -> Result<Interval, CertifiedError> {
        Ok(self.ball(25)?.interval())
    }
}
