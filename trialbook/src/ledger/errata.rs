//! The errata: what has to be changed in the paper, as data.

use super::{Entry, Ledger, Verdict};
use crate::evidence::{Change, Evidence, Outcome, Subject};

use crate::trials::compare::Failure;
use serde::Serialize;
use std::collections::BTreeSet;

/// One claim that does not stand as printed.
#[derive(Debug, Clone, Serialize)]
pub struct Erratum {
    /// Id of the claim.
    pub id: &'static str,
    /// Section of the paper.
    pub section: &'static str,
    /// Number of the equation, for a numbered one.
    pub equation: Option<u16>,
    /// What the claim is about.
    pub title: &'static str,
    /// The verdict.
    pub verdict: Verdict,
    /// What is printed; formulas in `$…$`.
    pub old: String,
    /// What should stand there; formulas in `$…$`.
    pub new: String,
    /// What is wrong, in one sentence; formulas in `$…$`.
    pub wrong: String,
    /// Why; formulas in `$…$`. Empty where nobody says so.
    pub reason: String,
    /// A case to check on paper; formulas in `$…$`.
    pub case: Option<String>,
    /// What was compared, and what came of it, a trial each; formulas in `$…$`.
    pub evidence: Vec<String>,
    /// Ids of the claims from which its error comes: those that it is derived from and that fail, unless the
    /// step from them fails too.
    pub inherits: Vec<&'static str>,
    /// All claims that rest on this one, directly or not, and have their error from others.
    pub fallen: Vec<&'static str>,
    /// Ids of all that rest on it, directly or not, and stand.
    pub standing: Vec<&'static str>,
}

/// Why there are no errata.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ErrataError {
    /// The numbers of a case cannot be had.
    #[error("the case by hand of {claim}: {reason}")]
    Case {
        /// Id of the claim.
        claim: &'static str,
        /// What failed.
        reason: Failure,
    },
    /// The letter asks for what there is not: what is wrong with it.
    #[error("the letter: {0}")]
    Letter(String),
}

impl Ledger {
    /// All claims that rest on a claim, directly or not, in the ledger's order.
    pub fn resting_on(&self, id: &str) -> Vec<&'static str> {
        let mut found = BTreeSet::from([id]);
        loop {
            let before = found.len();
            for entry in &self.entries {
                if entry.claim.depends_on.iter().any(|on| found.contains(on)) {
                    found.insert(entry.claim.id);
                }
            }
            if found.len() == before {
                break;
            }
        }
        let ids = self.entries.iter().map(|entry| entry.claim.id);
        ids.filter(|other| *other != id && found.contains(other))
            .collect()
    }

    /// Every claim that does not stand as printed, in the paper's order.
    ///
    /// # Errors
    /// [`ErrataError::Case`] if a motion cannot be followed.
    pub fn errata(&self) -> Result<Vec<Erratum>, ErrataError> {
        let entries = self.entries.iter();
        let wrong = entries.filter(|entry| entry.judgement.verdict.asks_for_change());
        wrong.map(|entry| self.erratum(entry)).collect()
    }

    /// The claims resting on this one that have their error from others, and those that stand.
    pub(crate) fn fallen_and_standing(&self, id: &str) -> [Vec<&'static str>; 2] {
        let resting = self.resting_on(id).into_iter();
        let (wrong, standing): (Vec<_>, Vec<_>) = resting.partition(|id| self.is_wrong(id));
        let inherits = |id: &&str| self.entry(id).is_some_and(|e| !self.inherits(e).is_empty());
        let fallen = wrong.into_iter().filter(inherits).collect();
        [fallen, standing]
    }

    fn is_wrong(&self, id: &str) -> bool {
        let entry = self.entry(id);
        entry.is_some_and(|e| e.judgement.verdict.is_wrong())
    }

    fn inherits(&self, entry: &Entry) -> Vec<&'static str> {
        let fails = |e: &Evidence| e.subject == Subject::Step && e.outcome() == Outcome::Disagrees;
        if entry.evidence.iter().any(fails) {
            return Vec::new();
        }
        let below = entry.claim.depends_on.iter().copied();
        below.filter(|id| self.is_wrong(id)).collect()
    }

    /// How many claims are false as printed, misprints among them.
    pub fn wrong(&self) -> usize {
        let wrong = |e: &&Entry| e.judgement.verdict.is_wrong();
        self.entries.iter().filter(wrong).count()
    }

    /// The wrong claims with an error of their own, without the misprints.
    pub fn roots(&self) -> impl Iterator<Item = &Entry> {
        let own = |v: Verdict| v.is_wrong() && v != Verdict::Misprint;
        let entries = self.entries.iter();
        entries.filter(move |e| own(e.judgement.verdict) && self.inherits(e).is_empty())
    }

    /// The errors of their own by weight: topics in which a result fails, and formulas without a factor, a
    /// sign or a symbol that others inherit.
    pub fn weights(&self) -> [usize; 2] {
        let change = |e: &&Entry| e.claim.correction.map(|c| c.change);
        let (results, slips): (Vec<_>, Vec<_>) = self
            .roots()
            .partition(|e| change(e) == Some(Change::Statement));
        let topics: BTreeSet<_> = results.iter().map(|e| e.topic.stem).collect();
        [topics.len(), slips.len()]
    }

    /// How many wrong claims, misprints aside, have an error of their own, and how many have it from others.
    pub(crate) fn roots_and_heirs(&self) -> [usize; 2] {
        let roots = self.roots().count();
        let misprints = self.counts()[&Verdict::Misprint];
        [roots, self.wrong() - misprints - roots]
    }

    fn erratum(&self, entry: &Entry) -> Result<Erratum, ErrataError> {
        let claim = entry.claim;
        let by_hand = claim.by_hand;
        let case = by_hand.map(|case| case.words()).transpose();
        let case = case.map_err(|reason| ErrataError::Case {
            claim: claim.id,
            reason,
        })?;
        let [fallen, standing] = self.fallen_and_standing(claim.id);
        let inherits = self.inherits(entry);
        Ok(Erratum {
            id: claim.id,
            section: claim.section,
            equation: claim.equation,
            title: claim.title,
            verdict: entry.judgement.verdict,
            old: statement(claim.latex, claim.equation),
            new: new_text(
                entry,
                &inherits.iter().map(|id| self.name(id)).collect::<Vec<_>>(),
            ),
            wrong: entry.in_short().unwrap_or_default(),
            reason: by_hand
                .map_or_else(|| reason_of_condition(entry), |case| case.reason.to_owned()),
            case,
            evidence: entry
                .evidence
                .iter()
                .map(|e| said(e, entry.is_conditional()))
                .collect(),
            inherits,
            fallen,
            standing,
        })
    }

    /// What a claim is called: `(82)`, `Figure 5`, or its title.
    pub fn name(&self, id: &str) -> String {
        let entry = self.entry(id);
        entry.map_or_else(|| id.to_owned(), |entry| entry.claim.name())
    }
}

pub(super) fn statement(latex: &str, equation: Option<u16>) -> String {
    match equation {
        Some(_) if !latex.contains('$') => format!("${latex}$"),
        _ => latex.to_owned(),
    }
}

/// The correction, or what is printed with the missing conditions, or what follows from those whose error it
/// inherits.
fn new_text(entry: &Entry, inherits: &[String]) -> String {
    let claim = entry.claim;
    let missing = entry.missing();
    if entry.judgement.verdict == Verdict::Conditional {
        let general = claim.correction.map_or(String::new(), |c| {
            let form = statement(c.latex, claim.equation);
            format!(". A regular form: {form}")
        });
        return format!("add: {missing}{general}");
    }
    let Some(correction) = claim.correction else {
        return format!("nothing takes its place; see {}", inherits.join(", "));
    };
    let new = statement(correction.latex, claim.equation);
    match missing.is_empty() {
        true => new,
        false => format!("{new}, for {missing}"),
    }
}

fn reason_of_condition(entry: &Entry) -> String {
    let outside = |e: &&Evidence| e.subject == Subject::Outside;
    let outside = entry.evidence.iter().filter(outside);
    let fails = outside.filter(|e| e.outcome() == Outcome::Disagrees);
    let sum = |(failed, points), e: &Evidence| (failed + e.failed, points + e.points);
    let (failed, points) = fails.fold((0, 0), sum);
    match points {
        0 => String::new(),
        _ => format!("Without the condition {failed} of {points} comparisons disagree"),
    }
}

fn said(e: &Evidence, conditional: bool) -> String {
    if let Some(recorded) = &e.recorded {
        return recorded.clone();
    }
    let (about, route) = (e.about(conditional, false), e.route.name());
    let (comparison, measured) = (e.comparison(), e.measured());
    format!("{about}, by {route}. {comparison} {measured}")
}

#[cfg(test)]
mod tests {
    use super::super::example::ledger;

    #[test]
    fn errors_come_from_others_unless_the_step_from_them_fails() {
        let ledger = ledger();
        let errata = ledger.errata().unwrap();
        let of = |id| errata.iter().find(|e| e.id == id).unwrap();
        for (id, inherits, fallen, standing) in [
            ("eq-1", &[][..], &["eq-3"][..], &[][..]),
            ("eq-2", &[], &["eq-3"], &[]),
            ("eq-3", &["eq-1", "eq-2"], &[], &[]),
            ("eq-4", &[], &[], &["eq-6"]),
            ("eq-5", &[], &[], &["eq-7"]),
        ] {
            let erratum = of(id);
            assert_eq!(erratum.inherits, inherits, "{id}");
            assert_eq!(erratum.fallen, fallen, "{id}");
            assert_eq!(erratum.standing, standing, "{id}");
        }
        assert_eq!(errata.len(), 5);
        assert_eq!((ledger.wrong(), ledger.roots_and_heirs()), (4, [2, 1]));
        assert_eq!(ledger.weights(), [1, 0]);
        assert_eq!(
            of("eq-5").reason,
            "Without the condition 11 of 40 comparisons disagree"
        );
        assert_eq!(of("eq-1").reason, "");
        assert_eq!(of("eq-3").new, "nothing takes its place; see (1), (2)");
        assert_eq!(of("eq-5").new, "add: $x>0$");
    }
}
