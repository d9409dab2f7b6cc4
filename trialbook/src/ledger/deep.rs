//! Depth: the same trials at other random points, round after round, judged together.

use super::{Entry, Ledger};
use crate::evidence::Evidence;
use std::collections::BTreeMap;
use std::fmt::Write;

/// What a round has brought, as text that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DeepError {
    /// A line that is not a trial, points, how many disagree, the largest disagreement and where.
    #[error("what a round has brought, line {line}: expected five columns, found `{text}`")]
    Line {
        /// Number of the line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A trial that the ledger does not have.
    #[error("what a round has brought, line {line}: the ledger has no trial `{key}`")]
    Trial {
        /// Number of the line, from 1.
        line: usize,
        /// What stands for the trial.
        key: String,
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

/// Key, points, how many disagree, the largest disagreement, and where.
struct Brought<'a> {
    key: &'a str,
    points: usize,
    failed: usize,
    worst: f64,
    at: &'a str,
}

impl<'a> Brought<'a> {
    fn read(text: &'a str) -> Option<Self> {
        let columns: Vec<_> = text.splitn(5, '\t').collect();
        let [key, points, failed, worst, at] = columns[..] else {
            return None;
        };
        Some(Brought {
            key,
            points: points.parse().ok()?,
            failed: failed.parse().ok()?,
            worst: worst.parse().ok()?,
            at,
        })
    }
}

impl Evidence {
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
    /// What this round has brought, a line a trial, for [`Ledger::with`].
    pub fn round(&self) -> String {
        let mut text = String::new();
        for entry in &self.entries {
            for (key, e) in entry.keyed().filter(|(_, e)| !e.route.is_proof()) {
                // Nothing can fail in writing to a string.
                let _ = writeln!(
                    text,
                    "{key}\t{}\t{}\t{:?}\t{}",
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
        let lines = round.lines().enumerate().map(|(i, text)| {
            let line = i + 1;
            let brought = Brought::read(text).ok_or_else(|| DeepError::Line {
                line,
                text: text.to_owned(),
            })?;
            let place = self.measured_at(&brought).ok_or_else(|| DeepError::Trial {
                line,
                key: brought.key.to_owned(),
            })?;
            Ok((place, brought))
        });
        for (place, brought) in lines.collect::<Result<Vec<_>, _>>()? {
            self.evidence_mut(place).take(&brought);
        }
        Ok(self.judged())
    }

    fn measured_at(&self, brought: &Brought<'_>) -> Option<(usize, usize)> {
        let place = self.position(brought.key);
        place.filter(|(entry, trial)| !self.entries[*entry].evidence[*trial].route.is_proof())
    }

    fn evidence_mut(&mut self, (entry, trial): (usize, usize)) -> &mut Evidence {
        &mut self.entries[entry].evidence[trial]
    }

    /// The record of this run for [`Deep::read`], of so many rounds, and when it was made.
    pub fn record(&self, made: &str, rounds: u32) -> String {
        let measured = self.evidence().filter(|e| !e.route.is_proof());
        let points: usize = measured.map(|e| e.points).sum();
        format!("{made}\t{rounds}\t{points}\n{}", self.round())
    }

    fn unmeasured(&self) -> Self {
        let mut ledger = self.clone();
        let evidence = ledger.entries.iter_mut().flat_map(|e| &mut e.evidence);
        for e in evidence.filter(|e| !e.route.is_proof()) {
            (e.points, e.failed, e.worst) = (0, 0, 0.0);
            e.at.clear();
        }
        ledger
    }

    fn judged(mut self) -> Self {
        let ids: Vec<_> = self.entries.iter().map(|e| e.claim.id).collect();
        self.entries.append(&mut self.beside);
        for entry in &mut self.entries {
            entry.judgement = entry.claim.judged(&entry.evidence);
        }
        Self::of(self.paper, self.entries).about(&ids)
    }
}

/// A deep run as kept beside the verdicts, as of a commit: trials may have come since, or gone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Deep<'a> {
    /// Of which commit it was made, and when.
    pub made: &'a str,
    /// How many rounds it had.
    pub rounds: u32,
    /// How much was compared.
    pub comparisons: usize,
    brought: &'a str,
}

impl<'a> Deep<'a> {
    /// Reads what [`Ledger::record`] has written; nothing if the first line is another.
    pub fn read(text: &'a str) -> Option<Self> {
        let (first, brought) = text.split_once('\n')?;
        let columns: Vec<_> = first.split('\t').collect();
        let [made, rounds, comparisons] = columns[..] else {
            return None;
        };
        Some(Deep {
            made,
            rounds: rounds.parse().ok()?,
            comparisons: comparisons.parse().ok()?,
            brought,
        })
    }

    /// The ledger with what this run has brought instead, judged anew; lines of no trial are left out.
    pub fn in_place_of(&self, ledger: &Ledger) -> Ledger {
        let mut deep = ledger.unmeasured();
        for brought in self.brought.lines().filter_map(Brought::read) {
            if let Some(place) = deep.measured_at(&brought) {
                deep.evidence_mut(place).take(&brought);
            }
        }
        deep.judged()
    }
}

/// What the rounds of a deep run have brought, read in parts.
#[derive(Debug, Default)]
pub struct Rounds(BTreeMap<u32, String>);

fn key(line: &str) -> &str {
    line.split('\t').next().unwrap_or_default()
}

const HEAD: &str = "round\t";

impl Rounds {
    /// What a round has brought, with its number, for [`Rounds::read`].
    pub(crate) fn headed(number: u32, brought: &str) -> String {
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

    /// The ledger with what these rounds have brought instead, judged anew.
    ///
    /// # Errors
    /// [`DeepError::Missing`], [`DeepError::Beyond`] and [`DeepError::Unfinished`] where these are not all rounds and no others,
    /// each with all trials; and as for [`Ledger::with`].
    pub fn in_place_of(&self, ledger: &Ledger, rounds: u32) -> Result<Ledger, DeepError> {
        fn keys(text: &str) -> Vec<&str> {
            let mut keys: Vec<_> = text.lines().map(key).collect();
            keys.sort_unstable();
            keys
        }
        let usual = ledger.round();
        let trials = keys(&usual);
        let mut deep = ledger.unmeasured();
        for number in 0..rounds {
            let round = self.0.get(&number).ok_or(DeepError::Missing(number))?;
            if keys(round) != trials {
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
        let backwards: String = lines.iter().rev().copied().collect();
        for brought in [&all, &backwards] {
            let deep = joined(brought).unwrap();
            let measured = deep.entries.iter().flat_map(Entry::measured);
            assert_eq!(measured.map(|e| e.points).sum::<usize>(), 320);
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

    #[test]
    fn what_a_round_brings_is_judged() {
        let ledger = example::ledger();
        let verdict = |ledger: &Ledger| ledger.entry("eq-5").unwrap().judgement.verdict;
        let before = verdict(&ledger);
        let all = ledger.round();
        let line = all
            .lines()
            .find(|line| line.starts_with("eq-5 root within 1\t"));
        let columns: Vec<_> = line.unwrap().split('\t').collect();
        let off = [&columns[..2], &["3", "1.0", "x = 2"]].concat().join("\t");
        let bad = all.replace(line.unwrap(), &off);
        let mut rounds = Rounds::default();
        rounds.read(&Rounds::headed(0, &all)).unwrap();
        rounds.read(&Rounds::headed(1, &bad)).unwrap();
        let record = format!("commit 0, 2026-11-26\t1\t320\n{bad}");
        for deep in [
            ledger.clone().with(&bad).unwrap(),
            rounds.in_place_of(&ledger, 2).unwrap(),
            Deep::read(&record).unwrap().in_place_of(&ledger),
        ] {
            assert_ne!(before, Verdict::Undecided);
            assert_eq!(verdict(&deep), Verdict::Undecided);
            let (entry, within) = deep.position("eq-5 root within 1").unwrap();
            assert_eq!(deep.entries[entry].evidence[within].failed, 3);
        }
    }

    #[test]
    fn a_record_is_read_as_it_was_written() {
        let ledger = ledger_with_one_more_point();
        let text = ledger.record("commit 0, 2026-01-02", 3);
        let deep = Deep::read(&text).unwrap();
        assert_eq!(
            (deep.made, deep.rounds, deep.comparisons),
            ("commit 0, 2026-01-02", 3, 321)
        );
        let read = deep.in_place_of(&ledger);
        for (read, written) in read.entries.iter().zip(&ledger.entries) {
            assert_eq!(read.evidence, written.evidence);
        }
        for none in ["", "date\t3", "date\t3\n", "date\tthree\t7\n", "\n"] {
            assert_eq!(Deep::read(none), None, "{none}");
        }
    }

    #[test]
    fn of_a_record_the_lines_of_other_trials_are_left_out() {
        let ledger = ledger_with_one_more_point();
        let text = ledger.record("", 3);
        let (others, last) = text.trim_end().rsplit_once('\n').unwrap();
        let gone = "eq-1 root step 1\t20\t0\t0.0\t\neq-8 exact printed 1\t20\t0\t0.0\t\neq-1 root printed 1\tmany\t0\t0.0\t\n\n";
        let read = Deep::read(&format!("{others}\n{gone}"))
            .unwrap()
            .in_place_of(&ledger);
        let missing = read.position(key(last)).unwrap();
        for (i, entry) in ledger.entries.iter().enumerate() {
            for (trial, e) in entry.evidence.iter().enumerate() {
                let points = if (i, trial) == missing { 0 } else { e.points };
                assert_eq!(read.entries[i].evidence[trial].points, points);
            }
        }
    }

    #[test]
    fn a_round_adds_its_points_and_keeps_the_worse_of_two() {
        let ledger = example::ledger();
        let round = ledger.round();
        let twice = ledger.clone().with(&round).unwrap();
        let proofs = ledger.evidence().filter(|e| e.route.is_proof());
        let proofs: usize = proofs.map(|e| e.points).sum();
        assert_eq!(twice.points() + proofs, 2 * ledger.points());
        assert_eq!(twice.counts(), ledger.counts());
        for worst in ["0.5", "inf", "NaN"] {
            let brought = format!("eq-5 root within 1\t7\t2\t{worst}\tλ = 3");
            let ledger = ledger.clone().with(&brought).unwrap();
            let entry = ledger.entry("eq-5").unwrap();
            let e = &entry.evidence[0];
            assert_eq!((e.points, e.failed, e.at.as_str()), (27, 2, "λ = 3"));
            assert_eq!(entry.judgement.verdict, Verdict::Undecided, "{worst}");
        }
    }

    #[test]
    fn a_line_that_is_none_of_a_round_is_refused() {
        let ledger = example::ledger();
        let with = |strange: &str| {
            let good = "eq-5 root within 1\t7\t0\t0.0\tλ = 3\n";
            ledger
                .clone()
                .with(&format!("{good}{strange}"))
                .unwrap_err()
        };
        let error = with("eq-5 root within 1\tseven\t0\t0.0\t");
        assert!(matches!(error, DeepError::Line { line: 2, .. }), "{error}");
        for strange in [
            "eq-5 root within 2",
            "eq-9 root within 1",
            "eq-8 exact printed 1",
        ] {
            let error = with(&format!("{strange}\t7\t0\t0.0\t"));
            let key = strange.to_owned();
            assert_eq!(error, DeepError::Trial { line: 2, key });
        }
    }

    #[test]
    fn rounds_from_any_parts_are_one_run() {
        let ledger = example::ledger();
        let round = |shift: f64| {
            let lines = ledger.round();
            let lines = lines.lines().map(|line| {
                let columns: Vec<_> = line.split('\t').collect();
                let worst = columns[3].parse::<f64>().unwrap() + shift;
                format!("{}\t{worst:?}\tshift {shift}\n", columns[..3].join("\t"))
            });
            lines.collect::<String>()
        };
        let brought = [0.0, 0.0, 1e-17, f64::NAN, 1e-18].map(round);
        let joined = |texts: &[&str], rounds| {
            let mut joined = Rounds::default();
            for text in texts {
                joined.read(text)?;
            }
            joined.in_place_of(&ledger, rounds)
        };
        let parts = |numbers: &[u32]| -> String {
            let of = |&n: &u32| Rounds::headed(n, &brought[n as usize]);
            numbers.iter().map(of).collect()
        };
        let mut whole = joined(&[&parts(&[0])], 1).unwrap();
        for brought in &brought[1..] {
            whole = whole.with(brought).unwrap();
        }
        for texts in [
            [parts(&[3, 4]), parts(&[0]), parts(&[1, 2])],
            [parts(&[4, 2, 0]), String::new(), parts(&[3, 1])],
        ] {
            let joined = joined(&texts.each_ref().map(String::as_str), 5).unwrap();
            assert_eq!(joined.record("", 5), whole.record("", 5));
        }
        let all = parts(&[0, 1, 2, 3, 4]);
        let cut = all.trim_end();
        let unfinished = &all[..all[..cut.rfind('\n').unwrap()].len() + 1];
        let beyond = DeepError::Beyond {
            round: 4,
            rounds: 4,
        };
        for (texts, rounds, error) in [
            (vec![&all[..], "round\t2\n"], 5, DeepError::Twice(2)),
            (vec![&all], 6, DeepError::Missing(5)),
            (vec![&all], 4, beyond),
            (vec![unfinished], 5, DeepError::Unfinished(4)),
            (vec![cut], 5, DeepError::Rounds("the last line is cut off")),
            (
                vec!["round\tx\n"],
                5,
                DeepError::Rounds("a round has no number"),
            ),
            (
                vec!["eq-5\n"],
                5,
                DeepError::Rounds("they begin with no `round`"),
            ),
        ] {
            assert_eq!(joined(&texts, rounds).unwrap_err(), error);
        }
    }

    fn ledger_with_one_more_point() -> Ledger {
        let mut ledger = example::ledger();
        ledger.entries[0].evidence[0].points += 1;
        ledger
    }
}
