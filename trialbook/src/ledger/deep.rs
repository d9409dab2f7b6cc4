//! Depth: the same trials at other random points, round after round, and one judgement of all together.

use super::{Entry, Ledger};
use crate::evidence::Evidence;
use std::fmt::Write;

/// What a round has brought, as text that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum DeepError {
    /// A line that is not a claim, the number of a trial, points, a disagreement and where it was.
    #[error("what a round has brought, line {line}: expected five columns, found `{text}`")]
    Line {
        /// Number of the line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A trial that the ledger does not have.
    #[error("what a round has brought, line {line}: the ledger has no trial {trial} of {claim}")]
    Trial {
        /// Number of the line, from 1.
        line: usize,
        /// The id of the claim.
        claim: String,
        /// The number of the trial, from 0.
        trial: usize,
    },
}

/// A line of a round: of which claim and trial, how many points, the largest disagreement, and where.
struct Brought<'a> {
    claim: &'a str,
    trial: usize,
    points: usize,
    worst: f64,
    at: &'a str,
}

impl<'a> Brought<'a> {
    fn read(text: &'a str) -> Option<Self> {
        let columns: Vec<_> = text.splitn(5, '\t').collect();
        let [claim, trial, points, worst, at] = columns[..] else {
            return None;
        };
        Some(Brought {
            claim,
            trial: trial.parse().ok()?,
            points: points.parse().ok()?,
            worst: worst.parse().ok()?,
            at,
        })
    }
}

impl Evidence {
    /// Takes in what the same trial has brought at other points.
    fn take(&mut self, other: &Brought<'_>) {
        self.points += other.points;
        // No number is worse than any.
        if other.worst > self.worst || other.worst.is_nan() {
            (self.worst, self.at) = (other.worst, other.at.to_owned());
        }
    }
}

impl Entry {
    fn measured(&self) -> impl Iterator<Item = (usize, &Evidence)> {
        let all = self.evidence.iter().enumerate();
        all.filter(|(_, e)| !e.route.is_proof())
    }
}

impl Ledger {
    /// What this round has brought: a line a measured trial, for [`Ledger::add`].
    pub fn round(&self) -> String {
        let mut text = String::new();
        for entry in &self.entries {
            for (trial, e) in entry.measured() {
                // Nothing can fail in writing to a string.
                let _ = writeln!(
                    text,
                    "{}\t{trial}\t{}\t{:?}\t{}",
                    entry.claim.id,
                    e.points,
                    e.worst,
                    e.at.replace(['\t', '\n'], " ")
                );
            }
        }
        text
    }

    /// Adds what another round has brought to the evidence; the verdicts are judged anew by [`Ledger::judged`].
    ///
    /// # Errors
    /// [`DeepError`] for the first line that cannot be read or belongs to no trial; nothing is added then.
    pub fn add(&mut self, round: &str) -> Result<(), DeepError> {
        let read = |(i, text): (usize, &str)| {
            let line = i + 1;
            let brought = Brought::read(text).ok_or_else(|| DeepError::Line {
                line,
                text: text.to_owned(),
            })?;
            let entry = self
                .entries
                .iter()
                .position(|e| e.claim.id == brought.claim);
            let known = entry.filter(|e| brought.trial < self.entries[*e].evidence.len());
            known
                .map(|entry| (entry, brought.trial, line))
                .ok_or_else(|| DeepError::Trial {
                    line,
                    claim: brought.claim.to_owned(),
                    trial: brought.trial,
                })
        };
        let places: Vec<_> = round
            .lines()
            .enumerate()
            .map(read)
            .collect::<Result<_, _>>()?;
        for ((entry, trial, _), text) in places.into_iter().zip(round.lines()) {
            if let Some(brought) = Brought::read(text) {
                self.entries[entry].evidence[trial].take(&brought);
            }
        }
        Ok(())
    }

    /// The same evidence, judged anew.
    pub fn judged(mut self) -> Self {
        for entry in &mut self.entries {
            entry.judgement = entry.claim.judged(&entry.evidence);
        }
        Self::of(self.paper, self.entries)
    }
}
