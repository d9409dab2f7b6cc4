//! The ledger: every claim with its evidence and the verdict that follows from it.

pub mod deep;
pub mod distrust;
#[cfg(feature = "book")]
mod errata;
#[cfg(test)]
pub(crate) mod example;
mod key;
#[cfg(feature = "book")]
mod letter;
mod parallel;
mod record;
#[cfg(feature = "book")]
mod recorded;
mod row;
mod run;
pub mod sensitivity;
mod sentences;
mod sheet;
mod standing;
mod summary;
mod table;
mod tally;
mod variants;
mod verdict;

#[cfg(feature = "book")]
pub use errata::{ErrataError, Erratum};
pub use key::Key;
#[cfg(feature = "book")]
pub use letter::Format;
pub use record::{Difference, Record, RecordError};
pub use row::{EvidenceRow, Row};
#[cfg(feature = "book")]
pub(crate) use sentences::{count, counted};
pub use standing::Standing;
pub use tally::Tally;
pub use verdict::{Judgement, Verdict, in_view_of, judge};

use crate::evidence::{Evidence, Outcome, Route, Subject};
use crate::trials::{Claim, Paper, Topic};
use std::collections::BTreeMap;

/// One claim, tried and judged.
#[derive(Debug, Clone)]
pub struct Entry {
    /// The paper.
    pub paper: &'static Paper,
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
    #[cfg(feature = "book")]
    pub(crate) fn address(&self) -> String {
        format!("{}.html#{}", self.topic.stem, self.claim.id)
    }

    #[cfg(feature = "book")]
    pub(crate) fn points(&self) -> usize {
        self.evidence.iter().map(|e| e.points).sum()
    }

    /// It holds under a condition which the paper does not state.
    pub(crate) fn is_conditional(&self) -> bool {
        self.judgement.verdict.has_condition()
    }

    /// The strongest route by which what the verdict rests on holds. Proofs come before measurements.
    pub fn strongest(&self) -> Option<Route> {
        self.whole().into_iter().map(|e| e.route).min()
    }

    fn whole(&self) -> Vec<&Evidence> {
        let (undecided, corrected) = match self.judgement.verdict {
            Verdict::Undecided => (true, false),
            verdict => (false, verdict.is_wrong()),
        };
        let counts = |e: &&Evidence| match e.subject {
            Subject::Printed | Subject::Within => !undecided && !corrected,
            Subject::Corrected => corrected,
            Subject::Outside | Subject::Step | Subject::Excepted | Subject::Remark => false,
        };
        let evidence = self.evidence.iter().filter(counts).filter(|e| !e.partial);
        evidence
            .filter(|e| e.outcome() == Outcome::Agrees)
            .collect()
    }

    /// Of the agreeing measurements, the one closest to its tolerance.
    pub fn closest(&self) -> Option<&Evidence> {
        let agrees = |e: &&Evidence| !e.route.is_proof() && e.outcome() == Outcome::Agrees;
        let measured = self.evidence.iter().filter(agrees);
        measured.max_by(|a, b| a.excess().total_cmp(&b.excess()))
    }

    /// What its trials brought, if not read from the record.
    pub fn made(&self) -> impl Iterator<Item = &Evidence> {
        self.evidence.iter().filter(|e| e.recorded.is_none())
    }

    /// The largest disagreement inside the conditions, by its tolerance.
    pub fn worst(&self) -> Option<&Evidence> {
        self.made()
            .filter(|e| {
                !matches!(e.subject, Subject::Outside | Subject::Excepted) && !e.route.is_proof()
            })
            .max_by(|a, b| a.excess().total_cmp(&b.excess()))
    }
}

impl Evidence {
    fn excess(&self) -> f64 {
        match self.worst {
            // Where nothing may differ either, the quotient would be no number.
            0.0 => 0.0,
            worst => worst / self.tolerance.value,
        }
    }
}

/// Every claim, tried and judged, in the paper's order of topics.
#[derive(Debug, Clone)]
pub struct Ledger {
    /// The paper.
    pub paper: &'static Paper,
    /// One entry per claim.
    pub entries: Vec<Entry>,
    /// Neighbours on which their verdicts may rest, no part of the ledger.
    pub beside: Vec<Entry>,
}

impl Ledger {
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
        self.evidence().map(|e| e.points).sum()
    }

    pub(crate) fn evidence(&self) -> impl Iterator<Item = &Evidence> {
        self.entries.iter().flat_map(|entry| &entry.evidence)
    }
}

#[cfg(test)]
mod tests {
    use super::example::{ledger, tried};
    use super::*;
    use crate::trials::tolerances::NONE;

    #[test]
    fn the_verdicts_of_the_example_are_these() {
        let counts = ledger().counts().into_iter().filter(|(_, n)| *n > 0);
        let expected = [
            (Verdict::Confirmed, 3),
            (Verdict::Conditional, 1),
            (Verdict::Misprint, 1),
            (Verdict::Misderived, 2),
            (Verdict::Inherited, 1),
        ];
        assert_eq!(counts.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn the_worst_disagreement_is_not_sought_where_there_has_to_be_one() {
        let ledger = ledger();
        let worst = |entry: &Entry| entry.worst().map(|e| (e.subject, e.worst));
        let conditional = ledger.entry("eq-5").unwrap();
        assert_eq!(worst(conditional), Some((Subject::Within, 1e-16)));
        assert_eq!(
            worst(ledger.entry("eq-1").unwrap()),
            Some((Subject::Printed, 1.0))
        );
        assert_eq!(worst(ledger.entry("eq-8").unwrap()), None);
        // What is excepted may be found by a count; and a count that is right is the best that there is.
        let mut entry = conditional.clone();
        let counted = |subject, worst| Evidence {
            worst,
            tolerance: NONE,
            ..tried(Route::Census, subject, 0)
        };
        entry.evidence.push(counted(Subject::Excepted, 1.0));
        entry.evidence.push(counted(Subject::Within, 0.0));
        assert_eq!(worst(&entry), Some((Subject::Within, 1e-16)));
        assert_eq!(entry.closest().unwrap().worst, 1e-16);
        entry.evidence.push(counted(Subject::Within, 1e-300));
        assert_eq!(worst(&entry), Some((Subject::Within, 1e-300)));
    }

    #[test]
    fn the_strongest_route_is_one_of_what_the_verdict_rests_on() {
        let strongest = |verdict, subjects: [Subject; 2]| {
            let mut entry = ledger().entry("eq-8").unwrap().clone();
            entry.judgement.verdict = verdict;
            let [first, second] = subjects;
            entry.evidence = vec![
                tried(Route::Exact, first, 0),
                tried(Route::Certified, second, 0),
                tried(Route::Exact, Subject::Remark, 0),
                tried(Route::Exact, Subject::Step, 0),
                tried(Route::Exact, Subject::Outside, 0),
            ];
            entry.strongest()
        };
        for verdict in Verdict::ALL {
            let (held, corrected) = match verdict {
                Verdict::Confirmed
                | Verdict::Degenerate
                | Verdict::Conditional
                | Verdict::Definition => (Some(Route::Certified), Some(Route::Exact)),
                Verdict::Misprint | Verdict::Misderived | Verdict::Inherited | Verdict::Refuted => {
                    (Some(Route::Exact), Some(Route::Certified))
                }
                Verdict::Undecided => (None, None),
            };
            for (printed, expected) in [
                ([Subject::Corrected, Subject::Printed], held),
                ([Subject::Corrected, Subject::Within], held),
                ([Subject::Printed, Subject::Corrected], corrected),
                ([Subject::Within, Subject::Corrected], corrected),
            ] {
                let found = strongest(verdict, printed);
                assert_eq!(found, expected, "{verdict:?} {printed:?}");
            }
        }
    }
}
