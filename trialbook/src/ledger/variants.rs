//! Trying claims on wrong variants of their formulas.

use super::{Entry, Ledger};
use crate::claims::variants::Variant;
use crate::evidence::{Evidence, Outcome, Subject};
use crate::seeded;
use rayon::ThreadPoolBuilder;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{available_parallelism, scope};

impl Ledger {
    /// Which of the variants are rejected. The ledger has to hold every claim: what trials keep of the motion has
    /// then been made without a mistake.
    pub fn rejected(&self, variants: &[Variant]) -> Vec<bool> {
        let next = AtomicUsize::new(0);
        let work = || {
            // A mistake is seeded on one thread alone, so all that a trial does has to stay on this one.
            let alone = ThreadPoolBuilder::new().num_threads(1).use_current_thread();
            let pool = alone.build().expect("the thread is in no pool yet");
            let mut found = Vec::new();
            while let Some((i, variant)) = {
                let i = next.fetch_add(1, Ordering::Relaxed);
                variants.get(i).map(|variant| (i, variant))
            } {
                let entry = self.entry(&variant.claim);
                let rejects = || entry.is_some_and(|entry| entry.rejects(variant));
                found.push((i, pool.install(rejects)));
            }
            found
        };
        let threads = available_parallelism().map_or(1, usize::from);
        let mut rejected = vec![false; variants.len()];
        scope(|scope| {
            let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
            for worker in workers {
                let found = worker.join().expect("no trial panics");
                found.into_iter().for_each(|(i, yes)| rejected[i] = yes);
            }
        });
        rejected
    }
}

impl Entry {
    /// True if the claim, tried with the variant, does not get its verdict. A printed formula that fails as it stands
    /// has to fail again, in a trial that notices the variant.
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
