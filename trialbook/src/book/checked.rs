//! Which proofs a second engine has checked, by their certificates.

use super::context::Context;
use super::error::Fault;
use super::tables::table;
use super::text::{count, escape};
use crate::claims::Claim;
use crate::evidence::{Evidence, Outcome};
use std::collections::BTreeMap;

/// The record of a check: by whom and when, then a line for each certificate: claim, trial, where its printed formula was
/// found, and a digest of it, which the tests hold against what is proved.
struct Record<'a> {
    when: &'a str,
    engine: &'a str,
    lines: Vec<[&'a str; 3]>,
}

impl<'a> Record<'a> {
    fn of(text: &'a str) -> Option<Self> {
        let mut lines = text.lines();
        let (when, engine) = lines.next()?.split_once(',')?;
        let cells = |line: &'a str| {
            let (claim, rest) = line.split_once(',')?;
            let (trial, rest) = rest.split_once(',')?;
            let (tie, _) = rest.split_once(',')?;
            Some([claim, trial, tie])
        };
        Some(Record {
            when,
            engine,
            lines: lines.filter_map(cells).collect(),
        })
    }

    /// What a box says of the proof that this trial of the claim is.
    fn says(&self, claim: &str, trial: &str) -> &'static str {
        let known = |[id, of, _]: &[&str; 3]| (*id, *of) == (claim, trial);
        match self.lines.iter().any(known) {
            true => "Proved, checked by a second engine",
            false => "Proved; no certificate of it has been checked",
        }
    }
}

/// Whether a proof that holds was checked, in a sentence; empty for others, and where there is no record.
pub(super) fn line(context: &Context<'_>, claim: &Claim, evidence: &Evidence) -> String {
    let Some(record) = Record::of(context.ledger.paper.certified) else {
        return String::new();
    };
    if !evidence.route.is_proof() || evidence.outcome() != Outcome::Agrees {
        return String::new();
    }
    let word = context.explained(record.says(claim.id, evidence.trial), "certificates");
    format!("<p class=\"measure\">{word}.</p>")
}

/// How many certificates were accepted, when and by whom, and where the printed formulas were found.
pub(super) fn summary(context: &Context<'_>) -> Result<String, Fault> {
    let none = || Fault::Placeholder("the paper has no record of checked certificates".into());
    let record = Record::of(context.ledger.paper.certified).ok_or_else(none)?;
    if record.lines.is_empty() {
        return Ok("<p>No certificate has been checked so far.</p>".to_owned());
    }
    let mut ties: BTreeMap<&str, usize> = BTreeMap::new();
    for [_, _, tie] in &record.lines {
        *ties.entry(tie).or_default() += 1;
    }
    let head = format!(
        "<p>On {}, {} certificates were accepted by {}.</p>",
        escape(record.when),
        count(record.lines.len()),
        escape(record.engine)
    );
    let rows = ties.into_iter().map(|(tie, n)| {
        let words = match tie {
            "formula" => "is among the formulas of the witnesses",
            "elsewhere" => "was read, and is not among them in this form",
            "mere names" => "has no more in it than names and numbers",
            "not read" => "was not read: vectors, rates, cases, series",
            _ => "is a statement in words",
        };
        [words.to_owned(), count(n)]
    });
    Ok(head + &table("certified", ["the printed formula", "certificates"], rows))
}

#[cfg(test)]
mod tests {
    use super::Record;

    #[test]
    fn only_a_proof_on_record_was_checked() {
        let record = Record::of("2026-11-26,FLINT\neq-1,law::EQ1,formula,0123\n").unwrap();
        assert_eq!((record.when, record.lines[0][2]), ("2026-11-26", "formula"));
        for (claim, trial, checked) in [
            ("eq-1", "law::EQ1", true),
            ("eq-1", "law::EQ2", false),
            ("eq-2", "law::EQ1", false),
        ] {
            let says = record.says(claim, trial);
            assert_eq!(says.contains("second engine"), checked, "{says}");
            assert_eq!(says.contains("no certificate"), !checked, "{says}");
        }
    }
}
