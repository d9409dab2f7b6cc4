//! Measurements held against slight mistakes: of twice the tolerance, or in a corner.

use super::{Entry, Ledger, parallel};
use crate::evidence::{Outcome, Subject};
use crate::seeded::{Mistake, Seed};
use crate::trials::variants::Variant;

/// An agreeing measurement, and a formula of its claim that it reads.
#[derive(Debug, Clone, Copy)]
pub struct Slight {
    /// The number of the entry in the ledger.
    pub entry: usize,
    /// The number of the trial.
    pub trial: usize,
    /// The formula's name.
    pub formula: &'static str,
    /// It notices that the formula gives too much by twice the tolerance, and too little.
    pub noticed: bool,
}

impl Entry {
    fn measured_by(&self, path: &str) -> Vec<usize> {
        let those = self.evidence.iter().enumerate().filter(|(_, e)| {
            let says = !matches!(e.subject, Subject::Step | Subject::Excepted);
            says && !e.route.is_proof() && e.outcome() == Outcome::Agrees && e.read.contains(path)
        });
        let mut those: Vec<_> = those.map(|(i, _)| i).collect();
        those.sort_by_key(|i| self.evidence[*i].points);
        those
    }
}

impl Ledger {
    /// What measurements do when a formula of their claim is wrong by twice their tolerance, where that is
    /// not zero.
    pub fn slight(&self) -> Vec<Slight> {
        let formulas = &self.paper.formulas;
        let numbers = (formulas.numbers)();
        let of = |(entry, e): (usize, &Entry)| {
            let own = numbers
                .iter()
                .filter(|f| f.claim().as_deref() == Some(e.claim.id) && formulas.has_a_size(f));
            let pairs = own.flat_map(|f| {
                let trials = e.measured_by(f.path).into_iter();
                trials.map(move |trial| (entry, trial, f.path, f.name))
            });
            let pairs: Vec<_> = pairs.collect();
            pairs
        };
        let mut all: Vec<_> = self.entries.iter().enumerate().flat_map(of).collect();
        let tolerance = |entry: usize, trial: usize| self.entries[entry].evidence[trial].tolerance;
        all.retain(|(entry, trial, ..)| tolerance(*entry, *trial).value > 0.0);
        parallel::each(all.len(), |i| {
            let (entry, trial, path, formula) = all[i];
            let part = (0.5 / tolerance(entry, trial).value).round() as i64;
            let noticed = [part, -part].into_iter().all(|part| {
                let seed = Seed::of_value(path, Mistake::Part(part));
                self.entries[entry].reaction(trial, seed).rejects
            });
            Slight {
                entry,
                trial,
                formula,
                noticed,
            }
        })
    }

    /// Which variants a measurement of their claim notices that agrees without; `None` where none reads the
    /// formula.
    pub fn noticed(&self, variants: &[Variant]) -> Vec<Option<bool>> {
        parallel::each(variants.len(), |i| {
            let seed = variants[i].seed;
            let entry = self.entry(&variants[i].claim)?;
            let trials = entry.measured_by(seed.formula);
            let notices = |trial: &usize| entry.reaction(*trial, seed).rejects;
            (!trials.is_empty()).then(|| trials.iter().any(notices))
        })
    }
}
