//! Trying claims on all cores, and judging them in view of one another.

use super::{Entry, Judgement, Ledger, Verdict, in_view_of, judge};
use crate::evidence::Evidence;
use crate::stop;
use crate::trials::{Claim, Paper, Topic, attempt::Attempt};
use rayon::prelude::*;
use std::iter;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

impl Entry {
    /// Tries one claim and judges it.
    pub fn try_claim(paper: &'static Paper, topic: &'static Topic, claim: &'static Claim) -> Self {
        let evidence: Vec<_> = claim.trials.par_iter().map(Attempt::evidence).collect();
        let judgement = claim.judged(&evidence);
        Entry {
            paper,
            claim,
            topic,
            evidence,
            judgement,
        }
    }

    fn looks_at(&self, claim: &Claim) -> bool {
        match self.judgement.verdict {
            Verdict::Misprint => claim.depends_on.contains(&self.claim.id),
            Verdict::Inherited => self.claim.depends_on.contains(&claim.id),
            _ => false,
        }
    }
}

impl Claim {
    /// Judges the claim by itself.
    pub fn judged(&self, evidence: &[Evidence]) -> Judgement {
        let change = self.correction.map(|c| c.change);
        judge(self.kind, change, self.conditions, evidence)
    }
}

fn tried(
    paper: &'static Paper,
    claims: Vec<(&'static Topic, &'static Claim)>,
    done: &(impl Fn(&Claim) + Sync),
) -> Vec<Entry> {
    let workers = rayon::current_num_threads();
    let shares = Shares::new(claims.len(), workers);
    let work = |worker| {
        let next = move |shares: &Shares| shares.next(worker).filter(|_| !stop::is_asked());
        let shares = &shares;
        iter::from_fn(move || next(shares)).map(|i| {
            let (topic, claim) = claims[i];
            let entry = Entry::try_claim(paper, topic, claim);
            done(claim);
            (i, entry)
        })
    };
    let workers = (0..workers).into_par_iter().with_max_len(1);
    let mut entries: Vec<_> = workers.flat_map_iter(work).collect();
    entries.sort_by_key(|(i, _)| *i);
    entries.into_iter().map(|(_, entry)| entry).collect()
}

fn untried(
    paper: &'static Paper,
    entries: &[Entry],
) -> impl Iterator<Item = (&'static Topic, &'static Claim)> {
    let claims = paper.claims();
    claims.filter(|(_, claim)| entries.iter().all(|e| e.claim.id != claim.id))
}

fn settled(paper: &'static Paper, mut entries: Vec<Entry>) -> Vec<Entry> {
    while stop::is_asked() {
        let left: Vec<_> = untried(paper, &entries).collect();
        let all = entries.len();
        entries.retain(|e| !left.iter().any(|(_, claim)| e.looks_at(claim)));
        if entries.len() == all {
            break;
        }
    }
    entries
}

/// Neighbours share runs, for which one worker waits for another: so each keeps to its own part, and who has
/// finished helps the one with most left from its far end.
struct Shares(Mutex<Vec<Range<usize>>>);

impl Shares {
    fn new(claims: usize, workers: usize) -> Self {
        let bound = |worker| claims * worker / workers;
        let parts = (0..workers).map(|worker| bound(worker)..bound(worker + 1));
        Shares(Mutex::new(parts.collect()))
    }

    fn next(&self, worker: usize) -> Option<usize> {
        // Whole at any time: nothing panics while it is locked.
        let mut parts = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        parts[worker].next().or_else(|| {
            let longest = parts.iter_mut().max_by_key(|part| part.len())?;
            longest.next_back()
        })
    }
}

fn changed(entries: &[Entry]) -> impl Fn((usize, &Entry)) -> Option<(usize, Judgement)> {
    move |(i, entry)| {
        let those = |wanted: &dyn Fn(&Claim) -> bool| -> Vec<_> {
            let others = entries.iter().filter(|e| wanted(e.claim));
            others.map(|e| (e.claim.id, e.judgement.verdict)).collect()
        };
        let below = those(&|other| entry.claim.depends_on.contains(&other.id));
        let above = those(&|other| other.depends_on.contains(&entry.claim.id));
        let judgement = in_view_of(entry.judgement.clone(), &below, &above);
        (judgement != entry.judgement).then_some((i, judgement))
    }
}

impl Ledger {
    /// Tries every claim on all cores; calls `done` after each one. If [stopped](stop), it has those whose
    /// verdict is known by then.
    pub fn try_all(paper: &'static Paper, done: impl Fn(&Claim) + Sync) -> Self {
        let entries = tried(paper, paper.claims().collect(), &done);
        Self::of(paper, settled(paper, entries))
    }

    /// Tries the claims of these ids, and neighbours on which their verdicts may rest, as
    /// [`Ledger::try_all`].
    pub fn try_some(paper: &'static Paper, ids: &[&str], done: impl Fn(&Claim) + Sync) -> Self {
        let mut wanted: Vec<_> = paper
            .claims()
            .filter(|(_, c)| ids.contains(&c.id))
            .collect();
        let mut entries = Vec::new();
        while !wanted.is_empty() {
            entries.extend(tried(paper, wanted, &done));
            wanted = untried(paper, &entries)
                .filter(|(_, claim)| entries.iter().any(|e| e.looks_at(claim)))
                .filter(|_| !stop::is_asked())
                .collect();
        }
        Self::of(paper, settled(paper, entries)).about(ids)
    }

    pub(crate) fn about(mut self, ids: &[&str]) -> Self {
        let asked = |e: &Entry| ids.contains(&e.claim.id);
        (self.entries, self.beside) = self.entries.into_iter().partition(asked);
        self
    }

    pub(super) fn of(paper: &'static Paper, mut entries: Vec<Entry>) -> Self {
        // What a claim is worth may change what its neighbours are.
        while let Some((i, judgement)) = entries.iter().enumerate().find_map(changed(&entries)) {
            entries[i].judgement = judgement;
        }
        Ledger {
            paper,
            entries,
            beside: Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::example;
    use super::*;

    static HEIRS: Paper = Paper {
        topics: &[&example::CHAIN],
        ..Paper::BLANK
    };

    #[test]
    fn each_claim_has_the_same_verdict_alone() {
        for paper in [&HEIRS, &example::PAPER] {
            let all = Ledger::try_all(paper, |_| {});
            for entry in &all.entries {
                let id = entry.claim.id;
                let alone = Ledger::try_some(paper, &[id], |_| {});
                assert_eq!(alone.entries.len(), 1, "{id}");
                let found = &alone.entries[0].judgement;
                assert_eq!(found, &entry.judgement, "{id}");
            }
        }
        let heirs = Ledger::try_all(&HEIRS, |_| {});
        let verdicts = heirs.entries.iter().map(|e| e.judgement.verdict);
        let inherited = [Verdict::Inherited; 3];
        assert!(verdicts.eq([Verdict::Misderived].into_iter().chain(inherited)));
    }

    #[test]
    fn each_keeps_to_its_part_and_then_helps_from_the_far_end() {
        let shares = Shares::new(10, 3);
        let own = [0, 1, 2].map(|_| shares.next(0));
        assert_eq!(own, [0, 1, 2].map(Some));
        assert_eq!(shares.next(1), Some(3));
        // The third has 6 to 9 left, the second 4 and 5.
        assert_eq!([shares.next(0), shares.next(0)], [Some(9), Some(8)]);
        let mut left: Vec<_> = iter::from_fn(|| shares.next(1)).collect();
        assert_eq!(left[..2], [4, 5]);
        left.sort_unstable();
        assert_eq!(left, [4, 5, 6, 7]);
        assert_eq!([shares.next(0), shares.next(2)], [None, None]);
    }
}
