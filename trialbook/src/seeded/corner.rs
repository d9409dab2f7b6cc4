//! Where an argument is at the edge of what a formula is stated for.

use std::fmt;

/// A part of the values of a symbol, between two ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// The symbol's letter.
    pub letter: &'static str,
    /// Below every value in it.
    pub low: f64,
    /// Above every value in it.
    pub high: f64,
}

impl Corner {
    /// True if the value lies in it.
    pub fn holds(&self, value: f64) -> bool {
        self.low < value && value < self.high
    }

    /// True if it has values in common with another part.
    pub fn meets(&self, other: &Corner) -> bool {
        self.low.max(other.low) < self.high.min(other.high)
    }
}

impl fmt::Display for Corner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Corner { letter, low, high } = self;
        match (low.is_finite(), high.is_finite()) {
            (true, true) => write!(f, "{low} < {letter} < {high}"),
            (true, false) => write!(f, "{letter} > {low}"),
            _ => write!(f, "{letter} < {high}"),
        }
    }
}
