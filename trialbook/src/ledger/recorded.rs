//! What trials have brought, as it is recorded: enough to list the claims and to write the errata without trying anything.

use super::{Entry, Judgement, Ledger, Record, RecordError, Verdict, record::lines};
use crate::evidence::{Compared, Evidence, Outcome, Subject};
use crate::trials::{Claim, Paper, Topic, tolerances::NONE};
use serde::Deserialize;
use serde::de::value::{BorrowedStrDeserializer, Error};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Stands in place of a number that may turn on a last bit.
const SOME: &str = "some";
const PART: &str = "part";
const IN_WORDS: &str = "words";

impl Ledger {
    /// The record of what the trials have brought, for [`Ledger::recorded`]: a line `id: ground` for each claim, below it one for
    /// each trial, with what the errata say of it. Only what is the same on every machine.
    pub fn brought(&self) -> String {
        let mut text = String::new();
        for entry in &self.entries {
            // Nothing can fail in writing to a string.
            let _ = writeln!(text, "{}: {}", entry.claim.id, entry.judgement.ground);
            for e in &entry.evidence {
                let failed = match (e.outcome(), e.subject) {
                    (Outcome::Agrees, _) => "0".to_owned(),
                    (Outcome::Disagrees, Subject::Outside) => e.failed.to_string(),
                    (Outcome::Disagrees, _) => SOME.to_owned(),
                    _ => f64::NAN.to_string(),
                };
                let (route, subject) = (e.route.name(), e.subject.name());
                let _ = write!(text, "  {route} {subject} {} {failed}", e.points);
                for (word, so) in [(PART, e.partial), (IN_WORDS, e.is_in_words())] {
                    if so {
                        let _ = write!(text, " {word}");
                    }
                }
                if entry.judgement.verdict.asks_for_change() {
                    let about = e.about(entry.is_conditional());
                    let (comparison, result) = (e.comparison(), e.result());
                    let _ = write!(text, "; {about}, by {route}. {comparison} {result}");
                }
                text.push('\n');
            }
        }
        text
    }

    /// The ledger as it is recorded: nothing is tried. A claim that the record lacks is undecided.
    ///
    /// # Errors
    /// [`RecordError`] for the first line that cannot be read.
    pub fn recorded(paper: &'static Paper) -> Result<Self, RecordError> {
        let verdicts = Record::parse(&paper.record)?;
        let mut grounds = BTreeMap::new();
        let mut evidence: Vec<Evidence> = Vec::new();
        let mut id = "";
        for (line, text) in lines(paper.trials.as_str()) {
            let wrong = || RecordError::Trial {
                line,
                text: text.to_owned(),
            };
            match text.strip_prefix("  ") {
                Some(trial) => evidence.push(brought(trial).ok_or_else(wrong)?),
                None => {
                    let (next, ground) = text.split_once(": ").ok_or_else(wrong)?;
                    of(&mut grounds, id).1.append(&mut evidence);
                    id = next;
                    of(&mut grounds, id).0 = ground;
                }
            }
        }
        of(&mut grounds, id).1.append(&mut evidence);
        let entry = |(topic, claim): (&'static Topic, &'static Claim)| {
            let (ground, evidence) = grounds.remove(claim.id).unwrap_or_default();
            let verdict = verdicts.of(claim.id).filter(|_| !ground.is_empty());
            let wrong = |id: &&&str| verdicts.of(id).is_some_and(Verdict::is_wrong);
            let below = claim.depends_on.iter().filter(wrong);
            Entry {
                paper,
                claim,
                topic,
                evidence,
                judgement: match verdict {
                    Some(verdict) => Judgement {
                        verdict,
                        ground: ground.to_owned(),
                        inherits: match verdict {
                            Verdict::Inherited => below.map(|id| (*id).to_owned()).collect(),
                            _ => Vec::new(),
                        },
                    },
                    None => Judgement {
                        verdict: Verdict::Undecided,
                        ground: "it is not recorded".to_owned(),
                        inherits: Vec::new(),
                    },
                },
            }
        };
        Ok(Ledger {
            paper,
            entries: paper.claims().map(entry).collect(),
            beside: Vec::new(),
        })
    }
}

type Brought<'a> = BTreeMap<&'a str, (&'a str, Vec<Evidence>)>;

fn of<'a, 'b>(all: &'b mut Brought<'a>, id: &'a str) -> &'b mut (&'a str, Vec<Evidence>) {
    all.entry(id).or_default()
}

/// What a line of a trial says.
fn brought(text: &'static str) -> Option<Evidence> {
    let (head, said) = text.split_once("; ").unwrap_or((text, ""));
    let words: Vec<_> = head.split(' ').collect();
    let [route, subject, points, failed, ref more @ ..] = words[..] else {
        return None;
    };
    let compared = match more.contains(&IN_WORDS) {
        true => Compared::shown(""),
        false => Compared::one("", ""),
    };
    let (failed, worst) = match failed {
        "0" => (0, 0.0),
        SOME => (1, f64::INFINITY),
        failed => match failed.parse() {
            Ok(failed) => (failed, f64::INFINITY),
            Err(_) => (0, failed.parse().ok()?),
        },
    };
    Some(Evidence {
        points: points.parse().ok()?,
        failed,
        worst,
        partial: more.contains(&PART),
        recorded: Some(said),
        ..Evidence::new(named(route)?, named(subject)?, compared, NONE)
    })
}

/// What is called so.
fn named<T: Deserialize<'static>>(word: &'static str) -> Option<T> {
    T::deserialize(BorrowedStrDeserializer::<Error>::new(word)).ok()
}

#[cfg(test)]
mod tests {
    use super::super::example;
    use super::*;
    use crate::data::Text;

    /// Whatever is known without another trial is known from the record.
    #[test]
    fn a_recorded_ledger_says_what_the_trials_did() {
        let tried = example::ledger();
        let built = |text: String| Text::Built(text.leak());
        let of = |record: String, trials: String| -> &'static Paper {
            Box::leak(Box::new(Paper {
                record: built(record),
                trials: built(trials),
                topics: example::PAPER.topics,
                ..Paper::BLANK
            }))
        };
        let (record, trials) = (Record::text_of(&tried), tried.brought());
        let headed = format!("---\nsource: x\n---\n{trials}");
        let ledger = Ledger::recorded(of(record.clone(), headed)).unwrap();
        assert_eq!(ledger.summary(), tried.summary());
        for (now, then) in ledger.entries.iter().zip(&tried.entries) {
            assert_eq!(now.judgement, then.judgement);
            assert_eq!(
                (now.standing(), now.routes(), now.points()),
                (then.standing(), then.routes(), then.points())
            );
        }
        let errata = |ledger: &Ledger| {
            let errata = ledger.errata().unwrap().into_iter();
            let all: Vec<_> = errata
                .map(|mut erratum| {
                    let evidence = std::mem::take(&mut erratum.evidence);
                    (evidence.len(), format!("{erratum:?}"))
                })
                .collect();
            all
        };
        assert_eq!(errata(&ledger), errata(&tried));
        // What has come since, and what is broken.
        let lost = Ledger::recorded(of(record.clone(), String::new())).unwrap();
        assert_eq!(lost.counts()[&Verdict::Undecided], lost.entries.len());
        for broken in [
            "  exact",
            "  exact printed 1 none",
            "  algebra printed 1 0",
            "eq-1",
        ] {
            let error = Ledger::recorded(of(record.clone(), broken.to_owned())).unwrap_err();
            let line = RecordError::Trial {
                line: 1,
                text: broken.to_owned(),
            };
            assert_eq!(error, line);
        }
    }
}
