//! The ledger as text, for terminals.

use super::{Entry, Ledger, Standing, Verdict};
use crate::evidence::Subject;
use std::collections::BTreeSet;

impl Entry {
    /// The routes of all trials but those outside a condition, each once.
    pub fn routes(&self) -> String {
        let routes: BTreeSet<_> = self
            .evidence
            .iter()
            .filter(|e| e.subject != Subject::Outside)
            .map(|e| e.route)
            .collect();
        let names: Vec<_> = routes.iter().map(|r| r.name()).collect();
        names.join(" ")
    }
}

impl Ledger {
    /// One line: how many claims got each verdict.
    pub fn summary(&self) -> String {
        let counts = self.counts();
        let known = Standing::ALL.map(|of| format!("{} {}", self.known(of), of.word()));
        let part = |v: &Verdict| format!("{} {}", counts[v], v.of_many(counts[v]));
        let parts: Vec<_> = Verdict::ALL
            .iter()
            .filter(|v| counts[v] > 0)
            .map(part)
            .collect();
        let all = self.entries.len();
        let claims = if all == 1 { "claim" } else { "claims" };
        format!("{all} {claims}: {}; {}", parts.join(", "), known.join(", "))
    }
}
