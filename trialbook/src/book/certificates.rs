//! Which proofs a second engine has checked, by their certificates.

use super::{
    context::Context,
    error::Html,
    tables::table,
    text::{count, escape},
};
use crate::evidence::{Evidence, Outcome};
use crate::ledger::Entry;
use std::collections::BTreeMap;

/// The record of a check: when, of which commit and by whom, then a line for each certificate: claim, which of its proofs,
/// where its printed formula was found, whether it is accepted without its
/// conditions too, and what form of the claim the proof was about.
struct Record<'a> {
    when: &'a str,
    commit: &'a str,
    engine: &'a str,
    lines: Vec<[&'a str; 5]>,
}

impl<'a> Record<'a> {
    fn of(text: &'a str) -> Option<Self> {
        let mut lines = text.lines();
        let (when, head) = lines.next()?.split_once(',')?;
        let (commit, engine) = head.split_once(',')?;
        let cells = |line: &'a str| {
            let cells: Vec<&str> = line.splitn(5, ',').collect();
            cells.try_into().ok()
        };
        Some(Record {
            when,
            commit,
            engine,
            lines: lines.filter_map(cells).collect(),
        })
    }

    /// What a box says of the claim's proof of this number, which is about this form of it.
    fn says(&self, claim: &str, proof: usize, about: &str, in_words: bool) -> &'static str {
        let known =
            |[id, nth, .., of]: &&[&str; 5]| (*id, nth.parse(), *of) == (claim, Ok(proof), about);
        let line = self.lines.iter().find(known);
        match line.map(|[_, _, tie, ..]| *tie) {
            None => "No certificate of it has been checked",
            Some("formula") if !in_words => "Checked by a second engine",
            Some(tie) if in_words || tie == "words" => {
                "Its identities were checked by a second engine, its words were not"
            }
            Some(_) => {
                "Its identities were checked by a second engine; the printed formula is not among them as it stands"
            }
        }
    }
}

/// Whether a proof of the entry that holds was checked, in a sentence; empty for others, and where there is no record.
pub(super) fn line(context: &Context<'_>, entry: &Entry, evidence: &Evidence) -> String {
    let Some(record) = Record::of(&context.ledger.paper.certified) else {
        return String::new();
    };
    if !evidence.route.is_proof() || evidence.outcome() != Outcome::Agrees {
        return String::new();
    }
    let proofs = entry.evidence.iter().filter(|e| e.route.is_proof());
    let before = proofs.take_while(|e| e.trial != evidence.trial).count();
    let about = evidence.about(entry.claim.correction.is_none());
    let says = record.says(entry.claim.id, 1 + before, &about, evidence.is_in_words());
    let word = context.explained(says, "certificates");
    format!("<p class=\"measure\">{word}.</p>")
}

/// How many certificates were accepted, when and by whom, and where the printed formulas were found.
pub(super) fn summary(context: &Context<'_>) -> Html {
    let Some(record) = Record::of(&context.ledger.paper.certified) else {
        return Ok("<p>No certificate has been checked so far.</p>".to_owned());
    };
    let mut ties: BTreeMap<&str, usize> = BTreeMap::new();
    for [_, _, tie, ..] in &record.lines {
        *ties.entry(tie).or_default() += 1;
    }
    let head = format!(
        "<p>On {}, at commit {}, {} certificates were accepted by {}.</p>",
        escape(record.when),
        escape(record.commit),
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
    let uses = |word| record.lines.iter().filter(move |line| line[3] == word);
    let link = |[id, ..]: &[&str; 5]| context.link(context.entry(id)?);
    let needed: Vec<_> = uses("used").map(link).collect::<Result<_, _>>()?;
    let conditions = format!(
        "<p>{} bear conditions that are inequalities; {} of them {} refused without these: {}. What the others calculate is true \
         without them, and no file takes a fact from a proof on which it rests: a hypothesis that is missing is not noticed here.</p>",
        count(needed.len() + uses("idle").count()),
        count(needed.len()),
        if needed.len() == 1 { "is" } else { "are" },
        needed.join(", "),
    );
    let ties = table("certified", ["the printed formula", "certificates"], rows);
    Ok(head + &ties + &conditions)
}

#[cfg(test)]
mod tests {
    use super::Record;

    #[test]
    fn only_a_proof_on_record_was_checked() {
        let with =
            |tie| format!("2026-11-26,0123,FLINT\neq-1,2,{tie},idle,as corrected, a part of it\n");
        let text = with("formula");
        let record = Record::of(&text).unwrap();
        assert_eq!(
            [
                record.when,
                record.commit,
                record.engine,
                record.lines[0][2]
            ],
            ["2026-11-26", "0123", "FLINT", "formula"]
        );
        for (claim, proof, about, checked) in [
            ("eq-1", 2, "as corrected, a part of it", true),
            ("eq-1", 2, "as corrected", false),
            ("eq-1", 1, "as corrected, a part of it", false),
            ("eq-2", 2, "as corrected, a part of it", false),
        ] {
            for in_words in [false, true] {
                let says = record.says(claim, proof, about, in_words);
                assert_eq!(says.contains("second engine"), checked, "{says}");
                assert_eq!(says.contains("its words"), checked && in_words, "{says}");
            }
        }
        // And of another formula than the printed one only where that is said.
        for (tie, qualified) in [
            ("formula", false),
            ("elsewhere", true),
            ("mere names", true),
            ("not read", true),
            ("words", true),
        ] {
            let text = with(tie);
            let of = |in_words| {
                let about = "as corrected, a part of it";
                Record::of(&text).unwrap().says("eq-1", 2, about, in_words)
            };
            assert_eq!(
                of(false) != "Checked by a second engine",
                qualified,
                "{tie}"
            );
            assert!(of(true).ends_with("its words were not"), "{tie}");
        }
    }
}
