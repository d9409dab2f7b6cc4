//! The lemmas: proofs that other proofs rest on and that no box shows, each once.

use super::context::Context;
use super::error::Fault;
use super::text::{counted, escape};
use crate::evidence::{Evidence, Outcome};
use std::collections::BTreeSet;

/// The step by which a proof rests on another one.
const RESTS: &str = "Shown before: ";

/// The steps of a proof, behind a fold; those that rest on another proof lead to it.
pub(super) fn steps(context: &Context<'_>, steps: &[String]) -> Result<String, Fault> {
    let count = counted(steps.len(), "step");
    let step = |step: &String| {
        let words = context.maths.folded(step)?;
        let place = step
            .strip_prefix(RESTS)
            .and_then(|title| place(context, title));
        Ok(match place {
            Some(place) => format!("<li><a href=\"{place}\">{words}</a></li>"),
            None => format!("<li>{words}</li>"),
        })
    };
    let all: Result<String, Fault> = steps.iter().map(step).collect();
    Ok(format!(
        "<details class=\"proof\"><summary>The proof, {count}</summary><div class=\"steps\"><ol>{}</ol></div></details>",
        all?
    ))
}

/// The address of the proof of this title: in the box of the first claim that has it, or on the page of lemmas.
fn place(context: &Context<'_>, title: &str) -> Option<String> {
    let entries = &context.ledger.entries;
    if let Some(entry) = entries
        .iter()
        .find(|entry| entry.evidence.iter().any(|e| shows(e, title)))
    {
        return Some(entry.address());
    }
    let mut pages = context.edition.written();
    let page = pages.find(|page| page.text.contains("{{lemmas}}"))?;
    Some(format!("{}.html#{}", page.stem, anchor(title)))
}

fn shows(evidence: &Evidence, title: &str) -> bool {
    evidence.title == title && evidence.outcome() == Outcome::Agrees
}

fn anchor(title: &str) -> String {
    let words = title.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<_> = words.filter(|word| !word.is_empty()).collect();
    format!("lemma-{}", words.join("-").to_lowercase())
}

/// All lemmas, with their steps, in the order in which the claims need them.
pub(super) fn all(context: &Context<'_>) -> Result<String, Fault> {
    let ledger = context.ledger;
    let proved = ledger.evidence().filter(|e| e.outcome() == Outcome::Agrees);
    let mut known: BTreeSet<&str> = proved.map(|e| e.title.as_str()).collect();
    let lemmas = ledger.evidence().flat_map(|e| &e.lemmas);
    let shown = lemmas.filter(|lemma| known.insert(&lemma.title));
    let shown = shown.map(|lemma| {
        let id = anchor(&lemma.title);
        let title = context.maths.folded(&lemma.title)?;
        let steps = steps(context, &lemma.steps)?;
        Ok(format!(
            "<div class=\"lemma\"><p id=\"{}\"><strong>{title}</strong></p>{steps}</div>",
            escape(&id)
        ))
    });
    shown.collect()
}
