//! Why something was not proved.

use super::interval::Interval;

/// Why something was not proved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CertifiedError {
    /// It is false there, where: that is proved.
    #[error("it is false at {0}")]
    False(String),
    /// Nothing follows there. It may still be true.
    #[error("{why}, at {at}")]
    NotProved {
        /// What failed.
        why: &'static str,
        /// Where.
        at: String,
    },
}

impl CertifiedError {
    /// False on a box.
    pub fn failing(cell: &[Interval]) -> Self {
        CertifiedError::False(text(cell))
    }

    /// Not plain on a box that cannot be made smaller.
    pub fn open(cell: &[Interval]) -> Self {
        Self::unproved("no subdivision makes it plain", cell)
    }

    /// Not proved on a box, and why.
    pub fn unproved(why: &'static str, cell: &[Interval]) -> Self {
        CertifiedError::NotProved {
            why,
            at: text(cell),
        }
    }
}

fn text(cell: &[Interval]) -> String {
    let sides: Vec<_> = cell.iter().map(Interval::to_string).collect();
    sides.join(" × ")
}
