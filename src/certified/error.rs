//! Why something was not proved.

use super::interval::Interval;

/// Why something was not proved. It may still be true.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CertifiedError {
    /// Nothing follows there.
    #[error("{why}, at {at}")]
    NotProved {
        /// What failed.
        why: &'static str,
        /// Where.
        at: Interval,
    },
}
