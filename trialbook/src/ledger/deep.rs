//! Depth: the same trials at other random points, round after round, and one judgement of all together.

use super::{Entry, Ledger};
use crate::evidence::Evidence;
use std::collections::BTreeMap;
use std::fmt::Write;

/// What a round has brought, as text that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DeepError {
    /// A line that is not a claim, a trial, points, how many of them disagree, the largest disagreement and where it was.
    #[error("what a round has brought, line {line}: expected six columns, found `{text}`")]
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
        /// The name of the trial.
        trial: String,
    },
    /// A record that does not begin with a date, the number of rounds and that of all comparisons.
    #[error("the record of a deep run: expected date, rounds and comparisons, found `{0}`")]
    Header(String),
    /// A record whose lines are not those that were counted.
    #[error("the record of a deep run: {counted} comparisons were counted, its lines have {found}")]
    Comparisons {
        /// What its first line says.
        counted: usize,
        /// What the others add up to.
        found: usize,
    },
    /// Rounds that do not begin with the number of one, or whose last line is cut off.
    #[error("rounds of a deep run: {0}")]
    Rounds(&'static str),
    /// A round that two parts have.
    #[error("round {0} is there twice")]
    Twice(u32),
    /// A round that no part has.
    #[error("round {0} is missing")]
    Missing(u32),
    /// A round that is not one of the run.
    #[error("there is a round {round}, and the run has {rounds}, from 0")]
    Beyond {
        /// Its number.
        round: u32,
        /// How many the run has.
        rounds: u32,
    },
    /// A round that has not a line for each measured trial.
    #[error("round {0} does not have a line for each trial")]
    Unfinished(u32),
}

/// A line of a round: of which claim and trial, how many points, at how many it disagrees, the largest disagreement, and where.
struct Brought<'a> {
    claim: &'a str,
    trial: &'a str,
    points: usize,
    failed: usize,
    worst: f64,
    at: &'a str,
}

impl<'a> Brought<'a> {
    fn read(text: &'a str) -> Option<Self> {
        let columns: Vec<_> = text.splitn(6, '\t').collect();
        let [claim, trial, points, failed, worst, at] = columns[..] else {
            return None;
        };
        Some(Brought {
            claim,
            trial,
            points: points.parse().ok()?,
            failed: failed.parse().ok()?,
            worst: worst.parse().ok()?,
            at,
        })
    }
}

impl Evidence {
    /// Takes in what the same trial has brought at other points.
    fn take(&mut self, other: &Brought<'_>) {
        // No number is worse than any, and any is worse than nothing.
        if self.points == 0 || other.worst > self.worst || other.worst.is_nan() {
            (self.worst, self.at) = (other.worst, other.at.to_owned());
        }
        self.points += other.points;
        self.failed += other.failed;
    }
}

impl Entry {
    pub(crate) fn measured(&self) -> impl Iterator<Item = &Evidence> {
        self.evidence.iter().filter(|e| !e.route.is_proof())
    }
}

impl Ledger {
    /// What this round has brought: a line a measured trial, for [`Ledger::with`].
    pub fn round(&self) -> String {
        let mut text = String::new();
        for entry in &self.entries {
            for e in entry.measured() {
                // Nothing can fail in writing to a string.
                let _ = writeln!(
                    text,
                    "{}\t{}\t{}\t{}\t{:?}\t{}",
                    entry.claim.id,
                    e.trial,
                    e.points,
                    e.failed,
                    e.worst,
                    e.at.replace(['\t', '\n'], " ")
                );
            }
        }
        text
    }

    /// The ledger with what another round has brought, judged anew.
    ///
    /// # Errors
    /// [`DeepError`] for the first line that cannot be read or belongs to no trial.
    pub fn with(mut self, round: &str) -> Result<Self, DeepError> {
        let read = |(i, text): (usize, &'_ str)| {
            let line = i + 1;
            let brought = Brought::read(text).ok_or_else(|| DeepError::Line {
                line,
                text: text.to_owned(),
            })?;
            let mut entries = self.entries.iter();
            let entry = entries.position(|e| e.claim.id == brought.claim);
            let place = entry.and_then(|entry| {
                let mut trials = self.entries[entry].evidence.iter();
                let trial = trials.position(|e| !e.route.is_proof() && e.trial == brought.trial)?;
                Some((entry, trial))
            });
            place.ok_or_else(|| DeepError::Trial {
                line,
                claim: brought.claim.to_owned(),
                trial: brought.trial.to_owned(),
            })
        };
        let places: Vec<_> = round
            .lines()
            .enumerate()
            .map(read)
            .collect::<Result<_, _>>()?;
        for ((entry, trial), text) in places.into_iter().zip(round.lines()) {
            if let Some(brought) = Brought::read(text) {
                self.entries[entry].evidence[trial].take(&brought);
            }
        }
        Ok(self.judged())
    }

    /// The record of this run, of so many rounds, for [`Deep::read`].
    pub fn record(&self, date: &str, rounds: u32) -> String {
        let points = self.measured_points();
        format!("{date}\t{rounds}\t{points}\n{}", self.round())
    }

    fn measured_points(&self) -> usize {
        let measured = self.entries.iter().flat_map(Entry::measured);
        measured.map(|e| e.points).sum()
    }

    /// The same, as if nothing had been measured.
    fn unmeasured(&self) -> Self {
        let mut ledger = self.clone();
        let evidence = ledger.entries.iter_mut().flat_map(|e| &mut e.evidence);
        for e in evidence.filter(|e| !e.route.is_proof()) {
            (e.points, e.failed, e.worst) = (0, 0, 0.0);
            e.at.clear();
        }
        ledger
    }

    /// The same evidence, judged anew.
    fn judged(mut self) -> Self {
        let ids: Vec<_> = self.entries.iter().map(|e| e.claim.id).collect();
        self.entries.append(&mut self.beside);
        for entry in &mut self.entries {
            entry.judgement = entry.claim.judged(&entry.evidence);
        }
        Self::of(self.paper, self.entries).about(&ids)
    }
}

/// A deep run as it is kept beside the verdicts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Deep<'a> {
    /// When it was made.
    pub date: &'a str,
    /// How many rounds it had.
    pub rounds: u32,
    /// How much was compared.
    pub comparisons: usize,
    brought: &'a str,
}

impl<'a> Deep<'a> {
    /// Reads what [`Ledger::record`] has written.
    ///
    /// # Errors
    /// [`DeepError::Header`] for another first line.
    pub fn read(text: &'a str) -> Result<Self, DeepError> {
        let (first, brought) = text.split_once('\n').unwrap_or((text, ""));
        let header = || {
            let columns: Vec<_> = first.split('\t').collect();
            let [date, rounds, comparisons] = columns[..] else {
                return None;
            };
            Some(Deep {
                date,
                rounds: rounds.parse().ok()?,
                comparisons: comparisons.parse().ok()?,
                brought,
            })
        };
        header().ok_or_else(|| DeepError::Header(first.to_owned()))
    }

    /// The ledger with what this run has brought in place of its own measurements, judged anew: a trial that the run did not
    /// have is left without points.
    ///
    /// # Errors
    /// As for [`Ledger::with`]; [`DeepError::Comparisons`] where lines are missing, or are there twice.
    pub fn in_place_of(&self, ledger: &Ledger) -> Result<Ledger, DeepError> {
        let deep = ledger.unmeasured().with(self.brought)?;
        let (counted, found) = (self.comparisons, deep.measured_points());
        match counted == found {
            true => Ok(deep),
            false => Err(DeepError::Comparisons { counted, found }),
        }
    }
}

/// What the rounds of a deep run have brought, read from the parts that many jobs have made.
#[derive(Debug, Default)]
pub struct Rounds(BTreeMap<u32, String>);

/// Of which claim and trial a line of a round is.
fn name(line: &str) -> String {
    let columns: Vec<_> = line.split('\t').take(2).collect();
    columns.join("\t")
}

/// What goes before the number of a round.
const HEAD: &str = "round\t";

impl Rounds {
    /// What a round has brought, with its number before it, for [`Rounds::read`].
    pub fn headed(number: u32, brought: &str) -> String {
        format!("{HEAD}{number}\n{brought}")
    }

    /// Takes in the rounds of a part.
    ///
    /// # Errors
    /// [`DeepError::Rounds`] for text that is none, [`DeepError::Twice`] for a round that is here already.
    pub fn read(&mut self, text: &str) -> Result<(), DeepError> {
        let mut open = None;
        for line in text.split_inclusive('\n') {
            let line = line
                .strip_suffix('\n')
                .ok_or(DeepError::Rounds("the last line is cut off"))?;
            if let Some(number) = line.strip_prefix(HEAD) {
                let number = number.parse();
                let number = number.map_err(|_| DeepError::Rounds("a round has no number"))?;
                if self.0.insert(number, String::new()).is_some() {
                    return Err(DeepError::Twice(number));
                }
                open = Some(number);
                continue;
            }
            let round = open.and_then(|number| self.0.get_mut(&number));
            let round = round.ok_or(DeepError::Rounds("they begin with no `round`"))?;
            *round += line;
            round.push('\n');
        }
        Ok(())
    }

    /// The ledger with what these rounds have brought in place of its own measurements, judged anew: as one run of so many
    /// rounds would have it.
    ///
    /// # Errors
    /// [`DeepError::Missing`], [`DeepError::Beyond`] and [`DeepError::Unfinished`] where these are not all rounds and no others,
    /// each with all trials; and as for [`Ledger::with`].
    pub fn in_place_of(&self, ledger: &Ledger, rounds: u32) -> Result<Ledger, DeepError> {
        let names = |text: &str| -> Vec<String> {
            let mut names: Vec<_> = text.lines().map(name).collect();
            names.sort_unstable();
            names
        };
        let trials = names(&ledger.round());
        let mut deep = ledger.unmeasured();
        for number in 0..rounds {
            let round = self.0.get(&number).ok_or(DeepError::Missing(number))?;
            if names(round) != trials {
                return Err(DeepError::Unfinished(number));
            }
            deep = deep.with(round)?;
        }
        match self.0.keys().next_back() {
            Some(&round) if round >= rounds => Err(DeepError::Beyond { round, rounds }),
            _ => Ok(deep),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Verdict, example};
    use super::*;

    #[test]
    fn a_round_has_one_line_for_each_trial() {
        let ledger = example::ledger();
        let all = ledger.round();
        let lines: Vec<_> = all.split_inclusive('\n').collect();
        let [first, second, ..] = lines[..] else {
            panic!("{all}")
        };
        let joined = |brought: &str| {
            let mut rounds = Rounds::default();
            rounds.read(&Rounds::headed(0, brought)).unwrap();
            rounds.in_place_of(&ledger, 1)
        };
        // Sixteen trials of twenty points, in any order.
        let backwards: String = lines.iter().rev().copied().collect();
        for brought in [&all, &backwards] {
            let deep = joined(brought).unwrap();
            assert_eq!(deep.measured_points(), 320);
            assert_eq!(deep.counts(), ledger.counts());
        }
        let without = |n: usize| [&lines[..n], &lines[n + 1..]].concat().concat();
        for wrong in [
            without(0),
            without(lines.len() - 1),
            format!("{all}{first}"),
            format!("{second}{}", without(0)),
            String::new(),
        ] {
            let error = joined(&wrong).unwrap_err();
            assert_eq!(error, DeepError::Unfinished(0), "{wrong}");
        }
    }

    /// One comparison that disagrees in a later round is worth as much as one in the first, by whichever way it comes in.
    #[test]
    fn what_a_round_brings_is_judged() {
        let ledger = example::ledger();
        let verdict = |ledger: &Ledger| ledger.entry("eq-5").unwrap().judgement.verdict;
        let before = verdict(&ledger);
        let all = ledger.round();
        let line = all
            .lines()
            .find(|line| line.starts_with("eq-5\texample::RootWithin"));
        let columns: Vec<_> = line.unwrap().split('\t').collect();
        let off = [&columns[..3], &["3", "1.0", "x = 2"]].concat().join("\t");
        let bad = all.replace(line.unwrap(), &off);
        let mut rounds = Rounds::default();
        rounds.read(&Rounds::headed(0, &all)).unwrap();
        rounds.read(&Rounds::headed(1, &bad)).unwrap();
        let record = format!("2026-11-26\t1\t320\n{bad}");
        for deep in [
            ledger.clone().with(&bad).unwrap(),
            rounds.in_place_of(&ledger, 2).unwrap(),
            Deep::read(&record).unwrap().in_place_of(&ledger).unwrap(),
        ] {
            assert_ne!(before, Verdict::Undecided);
            assert_eq!(verdict(&deep), Verdict::Undecided);
            let mut within = deep.entry("eq-5").unwrap().measured();
            let within = within.find(|e| e.trial == "example::RootWithin");
            assert_eq!(within.unwrap().failed, 3);
        }
    }
}
