//! The recorded verdicts, against which a run is held.

use super::{Ledger, Verdict};
use serde::Serialize;
use std::collections::BTreeMap;

/// A verdict per claim id, as reviewed and committed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Record(BTreeMap<String, Verdict>);

/// A record that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RecordError {
    /// A line that is not `id: verdict`.
    #[error("the record of verdicts, line {line}: expected `id: verdict`, found `{text}`")]
    Line {
        /// Number of the line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A sheet that does not say what was found.
    #[error("the recorded sheet {path} {why}: the test of the claims writes it")]
    Sheet {
        /// Its path in the folder of the sheets.
        path: String,
        /// What it lacks.
        why: &'static str,
    },
}

/// A claim whose verdict is not the recorded one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// The claim's id.
    pub id: String,
    /// What the record says; `None` where it does not name the claim.
    pub recorded: Option<Verdict>,
    /// What the run found; `None` where there is no such claim.
    pub found: Option<Verdict>,
}

impl Record {
    /// Reads `id: verdict` lines; a snapshot's header, up to its second `---`, is passed over.
    ///
    /// # Errors
    /// [`RecordError::Line`] for the first line that does not read so.
    pub fn parse(text: &str) -> Result<Self, RecordError> {
        let marks = text.lines().enumerate().filter(|(_, l)| *l == "---");
        let header = match text.starts_with("---") {
            true => marks.map(|(i, _)| i + 1).nth(1).unwrap_or(0),
            false => 0,
        };
        let mut verdicts = BTreeMap::new();
        let lines = (1..).zip(text.lines()).skip(header);
        for (line, text) in lines.filter(|(_, text)| !text.trim().is_empty()) {
            let entry = text.split_once(": ").and_then(|(id, slug)| {
                let verdict = Verdict::ALL.into_iter().find(|v| v.slug() == slug.trim())?;
                Some((id.trim().to_owned(), verdict))
            });
            let (id, verdict) = entry.ok_or_else(|| RecordError::Line {
                line,
                text: text.to_owned(),
            })?;
            verdicts.insert(id, verdict);
        }
        Ok(Record(verdicts))
    }

    /// The text of the record that a ledger would make.
    pub fn text_of(ledger: &Ledger) -> String {
        let line = |e: &super::Entry| format!("{}: {}\n", e.claim.id, e.judgement.verdict.slug());
        ledger.entries.iter().map(line).collect()
    }

    /// Every claim whose verdict differs, in order of id.
    pub fn differences(&self, ledger: &Ledger) -> Vec<Difference> {
        let found: BTreeMap<_, _> = ledger
            .entries
            .iter()
            .map(|e| (e.claim.id.to_owned(), e.judgement.verdict))
            .collect();
        let ids: std::collections::BTreeSet<_> = self.0.keys().chain(found.keys()).collect();
        ids.into_iter()
            .map(|id| Difference {
                id: id.clone(),
                recorded: self.0.get(id).copied(),
                found: found.get(id).copied(),
            })
            .filter(|d| d.recorded != d.found)
            .collect()
    }
}
