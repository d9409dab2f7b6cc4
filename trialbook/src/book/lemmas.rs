//! The lemmas: proofs that other proofs rest on and that no box shows, each once.

use super::context::Context;
use super::error::Fault;
use super::text::{counted, escape};
use crate::evidence::{Evidence, Outcome};
use crate::notation::{Piece, pieces};
use std::collections::BTreeSet;

/// The step by which a proof rests on another one.
const RESTS: &str = "Shown before: ";
/// The step of a proof that says what it shows.
const SHOWS: &str = "To be shown: ";

/// The steps of a proof, behind a fold; those that rest on another proof lead to it.
pub(super) fn steps(context: &Context<'_>, steps: &[String]) -> Result<String, Fault> {
    let count = counted(steps.len(), "step");
    let letters = letters(steps);
    let step = |step: &String| {
        let words = context.maths.folded(&lettered(step, &letters))?;
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

/// The capitals that stand for something in these steps: those in their formulas, where no index follows.
fn letters(steps: &[String]) -> BTreeSet<char> {
    let pieces = steps.iter().flat_map(|step| pieces(step));
    let formulas = pieces.filter_map(|piece| match piece {
        Piece::Formula(latex) => Some(latex),
        _ => None,
    });
    let mut letters = BTreeSet::new();
    for latex in formulas {
        let alone = |c: char| !c.is_ascii_alphabetic() && c != '\\';
        let chars: Vec<_> = [' ']
            .into_iter()
            .chain(latex.chars())
            .chain([' '])
            .collect();
        let alone = chars
            .windows(3)
            .filter(|w| alone(w[0]) && alone(w[2]) && w[2] != '_');
        letters.extend(alone.map(|w| w[1]).filter(char::is_ascii_uppercase));
    }
    letters
}

/// A step in which those letters are formulas where they stand alone among words, too; not an article, with which it begins.
fn lettered(step: &str, letters: &BTreeSet<char>) -> String {
    let mut out = String::new();
    let pieces = pieces(step);
    let part = |i: usize| match pieces.get(i) {
        Some(Piece::Text(text)) => text.chars().next(),
        Some(_) => Some('x'),
        None => None,
    };
    let word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    for (i, piece) in pieces.iter().enumerate() {
        match piece {
            Piece::Formula(latex) => out += &format!("${latex}$"),
            Piece::Minus => out.push('−'),
            Piece::Scientific(number) => out += number,
            Piece::Text(text) => {
                let c = text
                    .chars()
                    .next()
                    .filter(|c| letters.contains(c) && text.len() == 1);
                let before = i.checked_sub(1).and_then(part);
                let article = c == Some('A') && i == 0;
                match c {
                    Some(c) if !word(before) && !word(part(i + 1)) && !article => {
                        out += &format!("${c}$")
                    }
                    _ => out += text,
                }
            }
        }
    }
    out
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
        let mut rest = lemma.steps.clone();
        let said = rest.iter().position(|step| step.starts_with(SHOWS));
        let said = said.map_or_else(String::new, |i| rest.remove(i)[SHOWS.len()..].to_owned());
        let said = context
            .maths
            .folded(&lettered(&said, &letters(&lemma.steps)))?;
        let steps = steps(context, &rest)?;
        Ok(format!(
            "<div class=\"lemma\"><p id=\"{}\"><strong>{title}.</strong> {said}</p>{steps}</div>",
            escape(&id)
        ))
    });
    shown.collect()
}
