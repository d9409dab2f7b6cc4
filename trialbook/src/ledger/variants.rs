//! Trying claims on wrong variants of their formulas.

use super::{Entry, Ledger, parallel};
use crate::evidence::{Evidence, Outcome, Subject};
use crate::seeded;
use crate::trials::variants::Variant;

impl Ledger {
    /// Which of the variants are rejected. The ledger has to hold every claim: what trials keep is then made
    /// without a mistake.
    pub fn rejected(&self, variants: &[Variant]) -> Vec<bool> {
        parallel::each(variants.len(), |i| {
            let entry = self.entry(&variants[i].claim);
            entry.is_some_and(|entry| entry.rejects(&variants[i]))
        })
    }
}

impl Entry {
    /// A printed formula that fails as it stands has to fail again, in a trial that notices the variant.
    fn rejects(&self, variant: &Variant) -> bool {
        let claim = self.claim;
        let verdict_of = |evidence: &[Evidence]| claim.judged(evidence).verdict;
        let verdict = verdict_of(&self.evidence);
        let fails = verdict.is_wrong() && variant.printed;
        let mut order: Vec<_> = (0..claim.trials.len()).collect();
        order.sort_by_key(|i| self.evidence[*i].points);
        order.into_iter().any(|i| {
            let now = Evidence {
                read: self.evidence[i].read.clone(),
                ..seeded::with(variant.seed, || claim.trials[i].evidence())
            };
            let outcome = now.outcome();
            if fails {
                let printed = matches!(now.subject, Subject::Printed | Subject::Within);
                return printed && outcome != Outcome::Agrees && now != self.evidence[i];
            }
            outcome != self.evidence[i].outcome() && {
                let mut evidence = self.evidence.clone();
                evidence[i] = now;
                verdict_of(&evidence) != verdict
            }
        })
    }
}
