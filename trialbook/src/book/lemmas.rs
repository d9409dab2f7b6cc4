//! The lemmas: proofs that other proofs rest on and that no box shows, each once.

use super::{
    context::Context,
    error::{Fault, Html},
    text::{counted, escape},
};
use crate::evidence::{Evidence, Outcome};
use crate::exact::NORMAL;
use crate::notation::{Piece, pieces};
use std::collections::BTreeSet;

const RESTS: &str = "Shown before: ";
const SHOWS: &str = "To be shown: ";

/// As many steps as an earlier proof has too are not written again.
const SAME: usize = 4;

/// Behind a fold; those that rest on another proof lead to it, and those of a proof above to this.
pub(super) fn steps<'a>(
    context: &Context<'_>,
    steps: &[String],
    above: impl Iterator<Item = &'a [String]>,
) -> Html {
    let count = counted(steps.len(), "step");
    let letters = letters(steps);
    let said = |text: &str| context.maths.folded(&lettered(text, &letters));
    let step = |step: &String| {
        let (step, normal) = step.split_once(NORMAL).unwrap_or((step, ""));
        let words = said(step)?;
        let fold = match normal {
            "" => String::new(),
            normal => format!(
                "<details class=\"normal\"><summary>In normal form</summary>{}</details>",
                said(normal)?
            ),
        };
        let place = step.strip_prefix(RESTS);
        Ok(match place.and_then(|title| place_of(context, title)) {
            Some(place) => format!("<li><a href=\"{place}\">{words}</a></li>"),
            None => format!("<li>{words}{fold}</li>"),
        })
    };
    let mut all = steps
        .iter()
        .map(step)
        .collect::<Result<Vec<String>, Fault>>()?;
    if let Some((proof, from, at, n)) = same(steps, above) {
        let which = ["first", "second", "third"].get(proof).unwrap_or(&"last");
        let as_above = format!(
            "<li>Steps {} to {} of the {which} proof</li><li value=\"{}\">",
            from + 1,
            from + n,
            at + n + 1
        );
        all.splice(at..at + n, []);
        if let Some(next) = all.get_mut(at) {
            *next = next.replacen("<li>", &as_above, 1);
        }
    }
    Ok(format!(
        "<details class=\"proof\"><summary>The proof, {count}</summary><div class=\"steps\"><ol>{}</ol></div></details>",
        all.concat()
    ))
}

/// The longest that is also one of a proof above, if long enough and not all: of which, where it begins there
/// and here, and its length.
fn same<'a>(
    steps: &[String],
    above: impl Iterator<Item = &'a [String]>,
) -> Option<(usize, usize, usize, usize)> {
    let stretches = above.enumerate().flat_map(|(proof, other)| {
        let starts = (0..other.len()).flat_map(|i| (0..steps.len()).map(move |k| (i, k)));
        starts.map(move |(i, k)| {
            let pairs = other[i..].iter().zip(&steps[k..]);
            (proof, i, k, pairs.take_while(|(a, b)| a == b).count())
        })
    });
    let long = stretches.filter(|(_, _, k, n)| *n >= SAME && k + n < steps.len());
    long.max_by_key(|(.., n)| *n)
}

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

/// Those letters are formulas where they stand alone among words, too; not an article at the beginning.
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

fn place_of(context: &Context<'_>, title: &str) -> Option<String> {
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

pub(super) fn all(context: &Context<'_>) -> Html {
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
        let steps = steps(context, &rest, std::iter::empty())?;
        Ok(format!(
            "<div class=\"lemma\"><p id=\"{}\"><strong>{title}.</strong> {said}</p>{steps}</div>",
            escape(&id)
        ))
    });
    shown.collect()
}
