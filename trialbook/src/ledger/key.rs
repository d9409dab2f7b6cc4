//! What a trial is called in records: its function may be renamed, or move.

use super::{Entry, Ledger};
use crate::evidence::{Evidence, Route, Subject};
use std::fmt;

/// A trial by its claim, route, subject, and number among those of the same three, from 1: `eq-13 integration
/// within 2`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key {
    /// The id of the claim.
    pub claim: &'static str,
    /// The route.
    pub route: Route,
    /// What it speaks about.
    pub subject: Subject,
    /// Its number, from 1.
    pub nth: usize,
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (route, subject) = (self.route.name(), self.subject.name());
        write!(f, "{} {route} {subject} {}", self.claim, self.nth)
    }
}

impl Entry {
    /// The key of the trial of this number, from 0.
    ///
    /// # Panics
    /// If there is none.
    pub fn key(&self, trial: usize) -> Key {
        let Evidence { route, subject, .. } = self.evidence[trial];
        let until = self.evidence[..=trial].iter();
        let same = until.filter(|e| (e.route, e.subject) == (route, subject));
        Key {
            claim: self.claim.id,
            route,
            subject,
            nth: same.count(),
        }
    }

    /// What its trials brought, each with the trial's key.
    pub fn keyed(&self) -> impl Iterator<Item = (Key, &Evidence)> {
        let evidence = self.evidence.iter().enumerate();
        evidence.map(|(i, e)| (self.key(i), e))
    }
}

impl Ledger {
    /// The numbers of the entry and of the trial of this key.
    pub fn position(&self, key: &str) -> Option<(usize, usize)> {
        let (claim, _) = key.split_once(' ')?;
        let entry = self.entries.iter().position(|e| e.claim.id == claim)?;
        let mut keys = self.entries[entry].keyed();
        let trial = keys.position(|(of, _)| of.to_string() == key)?;
        Some((entry, trial))
    }
}

#[cfg(test)]
mod tests {
    use super::super::example::ledger;

    #[test]
    fn every_trial_is_found_by_its_key() {
        let ledger = ledger();
        for (i, entry) in ledger.entries.iter().enumerate() {
            for (trial, (key, _)) in entry.keyed().enumerate() {
                assert_eq!(ledger.position(&key.to_string()), Some((i, trial)));
            }
        }
        assert_eq!(
            ledger.entries[1].key(2).to_string(),
            "eq-2 root corrected 1"
        );
        for none in [
            "",
            "eq-2",
            "eq-2 root corrected 2",
            "eq-9 root printed 1",
            "eq-2 route printed 1",
        ] {
            assert_eq!(ledger.position(none), None, "{none}");
        }
    }

    #[test]
    fn those_of_the_same_claim_route_and_subject_are_counted() {
        let mut entry = ledger().entries.swap_remove(0);
        entry.evidence.push(entry.evidence[1].clone());
        let keys: Vec<_> = entry.keyed().map(|(key, _)| key.to_string()).collect();
        assert_eq!(
            keys,
            [
                "eq-1 root printed 1",
                "eq-1 root corrected 1",
                "eq-1 limit corrected 1",
                "eq-1 root corrected 2"
            ]
        );
    }
}
