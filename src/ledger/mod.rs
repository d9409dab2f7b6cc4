//! The ledger: every claim with its evidence and the verdict that follows from it.

mod errata;
mod letter;
mod plain;
mod record;
mod sheet;
mod table;
mod verdict;

pub use errata::{ErrataError, Erratum};
pub use letter::Format;
pub use plain::{plain_formula, plain_words};
pub use record::{Difference, Record, RecordError};
pub use verdict::{Judgement, Verdict, in_view_of, judge};

use crate::claims::{self, Claim, Topic};
use crate::evidence::{Evidence, Subject};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// One claim, tried and judged.
#[derive(Debug, Clone)]
pub struct Entry {
    /// The claim.
    pub claim: &'static Claim,
    /// The topic that it belongs to.
    pub topic: &'static Topic,
    /// What its trials brought, in the order of the trials.
    pub evidence: Vec<Evidence>,
    /// The verdict and its ground.
    pub judgement: Judgement,
}

impl Entry {
    /// Tries one claim and judges it.
    pub fn try_claim(topic: &'static Topic, claim: &'static Claim) -> Self {
        let evidence: Vec<_> = claim.trials.par_iter().map(|trial| trial()).collect();
        let judgement = judge(claim.kind, claim.correction.map(|c| c.change), &evidence);
        Entry {
            claim,
            topic,
            evidence,
            judgement,
        }
    }

    /// The largest disagreement among the trials of the claim as printed, with its tolerance.
    pub fn worst(&self) -> Option<&Evidence> {
        self.evidence
            .iter()
            .filter(|e| e.subject != Subject::Outside)
            .max_by(|a, b| {
                let excess = |e: &Evidence| e.worst / e.tolerance.value;
                excess(a).total_cmp(&excess(b))
            })
    }
}

/// Finds out whether an entry's judgement changes in view of the claims that depend on it.
fn changed(entries: &[Entry]) -> impl Fn((usize, &Entry)) -> Option<(usize, Judgement)> {
    move |(i, entry)| {
        let follows = |e: &&Entry| e.claim.depends_on.contains(&entry.claim.id);
        let dependents: Vec<_> = entries
            .iter()
            .filter(follows)
            .map(|e| (e.claim.id, e.judgement.verdict))
            .collect();
        let judgement = in_view_of(entry.judgement.clone(), &dependents);
        (judgement != entry.judgement).then_some((i, judgement))
    }
}

/// Every claim, tried and judged, in the paper's order of topics.
#[derive(Debug, Clone)]
pub struct Ledger {
    /// One entry per claim.
    pub entries: Vec<Entry>,
}

impl Ledger {
    /// Tries every claim on all cores; calls `done` after each one.
    pub fn try_all(done: impl Fn(&Claim) + Sync) -> Self {
        let claims: Vec<_> = claims::all().collect();
        let mut entries: Vec<_> = claims
            .into_par_iter()
            .map(|(topic, claim)| {
                let entry = Entry::try_claim(topic, claim);
                done(claim);
                entry
            })
            .collect();
        // A refutation may pass from claim to claim, against the order of derivation.
        while let Some((i, judgement)) = entries.iter().enumerate().find_map(changed(&entries)) {
            entries[i].judgement = judgement;
        }
        Ledger { entries }
    }

    /// The entry of the claim of this id.
    pub fn entry(&self, id: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.claim.id == id)
    }

    /// How many claims got each verdict.
    pub fn counts(&self) -> BTreeMap<Verdict, usize> {
        let mut counts = BTreeMap::from(Verdict::ALL.map(|v| (v, 0)));
        for entry in &self.entries {
            *counts.entry(entry.judgement.verdict).or_default() += 1;
        }
        counts
    }

    /// How many comparisons all trials made together.
    pub fn points(&self) -> usize {
        let evidence = self.entries.iter().flat_map(|entry| &entry.evidence);
        evidence.map(|e| e.points).sum()
    }
}
