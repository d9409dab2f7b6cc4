//! Claims without a proof.

/// Why some claims are measured and not proved.
#[derive(Debug, Clone, Copy)]
pub struct Measured {
    /// The reason.
    pub reason: &'static str,
    /// Ids of the claims.
    pub claims: &'static [&'static str],
}
