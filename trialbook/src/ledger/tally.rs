//! How many wrong variants of a claim's formulas its trials reject, as recorded.

use super::Entry;

/// A count of wrong variants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// How many were rejected.
    pub rejected: usize,
    /// How many were tried.
    pub tried: usize,
}

impl Entry {
    /// The recorded tally; zeros for a claim without a formula.
    pub fn tally(&self) -> Tally {
        let recorded = || {
            let lines = self.paper.tallies.lines();
            let of_claim = |line: &'static str| {
                let (id, counts) = line.split_once(": ")?;
                (id == self.claim.id).then(|| counts.split_once(" of "))?
            };
            let (rejected, tried) = lines.filter_map(of_claim).next()?;
            Some(Tally {
                rejected: rejected.parse().ok()?,
                tried: tried.parse().ok()?,
            })
        };
        recorded().unwrap_or_default()
    }
}
