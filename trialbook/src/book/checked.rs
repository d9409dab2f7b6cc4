//! Which proofs a second engine has checked, by their certificates.

use super::context::Context;
use super::error::Fault;
use super::tables::table;
use super::text::{count, escape};
use crate::claims::Claim;
use crate::evidence::{Evidence, Outcome};
use std::collections::BTreeMap;

/// The record of a check: by whom and when, then a line for each certificate: claim, trial, and where its printed formula
/// was found.
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
            let (trial, tie) = rest.split_once(',')?;
            Some([claim, trial, tie])
        };
        Some(Record {
            when,
            engine,
            lines: lines.filter_map(cells).collect(),
        })
    }

    fn has(&self, claim: &Claim, evidence: &Evidence) -> bool {
        let known = |[id, trial, _]: &[&str; 3]| *id == claim.id && *trial == evidence.trial;
        self.lines.iter().any(known)
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
    let word = if record.has(claim, evidence) {
        "Proved, checked by a second engine"
    } else {
        "Proved; no certificate of it has been checked"
    };
    let word = context.explained(word, "certificates");
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
