//! Which way a particle moves.

/// Direction of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Sign {
    /// w < 0.
    Negative,
    /// w = 0.
    Rest,
    /// w > 0.
    Positive,
}

impl Sign {
    pub(super) fn of(w: f64) -> Self {
        if w > 0.0 {
            Sign::Positive
        } else if w < 0.0 {
            Sign::Negative
        } else {
            Sign::Rest
        }
    }

    /// −1, 0 or 1.
    pub fn factor(self) -> f64 {
        match self {
            Sign::Negative => -1.0,
            Sign::Rest => 0.0,
            Sign::Positive => 1.0,
        }
    }
}
