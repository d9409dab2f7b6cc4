//! A number with as many certain digits as one asks for.

use super::{
    ball::{Ball, bits_for},
    error::CertifiedError,
    interval::Interval,
};

/// How a number is enclosed: by its ball with so many bits after the point.
#[derive(Debug, Clone, Copy)]
pub struct Enclosure(pub fn(usize) -> Result<Ball, CertifiedError>);

impl Enclosure {
    /// An enclosure to about `digits` decimals.
    ///
    /// # Errors
    /// [`CertifiedError`] if it is not proved to exist.
    pub fn ball(self, digits: usize) -> Result<Ball, CertifiedError> {
        (self.0)(bits_for(digits))
    }

    /// The decimals, correctly rounded to `digits` after the point.
    ///
    /// # Errors
    /// As [`ball`](Self::ball), and [`CertifiedError::NotProved`] if the number is so close to the middle between
    /// two decimals that this enclosure cannot tell which is nearer.
    pub fn decimal(self, digits: usize) -> Result<String, CertifiedError> {
        let ball = self.ball(digits)?;
        let close = || CertifiedError::unproved("the rounding is not certain", &[ball.interval()]);
        ball.decimal(digits).ok_or_else(close)
    }

    /// Neighbouring f64 around it.
    ///
    /// # Errors
    /// As [`ball`](Self::ball).
    pub fn interval(self) -> Result<Interval, CertifiedError> {
        Ok(self.ball(25)?.interval())
    }
}
