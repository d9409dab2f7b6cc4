//! How many wrong variants of a claim's formulas its trials reject.

use super::Entry;

/// A count of wrong variants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// How many are rejected.
    pub rejected: usize,
    /// How many are tried.
    pub tried: usize,
}

impl Entry {
    /// The tally of a paper whose test tries all variants; else zeros, and for a claim without a formula.
    pub fn tally(&self) -> Tally {
        if !self.paper.tries_variants {
            return Tally::default();
        }
        let tried = self.paper.formulas.variants_of_claim(self.claim.id).len();
        Tally {
            rejected: tried.saturating_sub(self.claim.survivors.len()),
            tried,
        }
    }
}
