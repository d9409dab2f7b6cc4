//! The map of claims: its figure, and the same as lists.

use super::{
    context::{Context, sign, verdict},
    error::{Fault, Html},
    table::{table, tried},
    text::{count, counted},
};
use crate::ledger::{Entry, Ledger, Verdict};
use crate::notation::plain_words;
use crate::plotting::{
    Figure, FigureError,
    map::{Node, map},
};
use std::collections::{BTreeMap, BTreeSet};

pub(super) fn figure(ledger: &Ledger) -> Result<Figure, FigureError> {
    let entries = &ledger.entries;
    let places: BTreeMap<_, _> = entries
        .iter()
        .enumerate()
        .map(|(i, e)| (e.claim.id, i))
        .collect();
    let shaken = shaken(ledger);
    let nodes = entries.iter().map(|entry| {
        let claim = entry.claim;
        let name = claim.name();
        let title = plain_words(claim.title);
        Node {
            id: claim.id,
            name: if name == claim.title {
                String::new()
            } else {
                name
            },
            title,
            href: entry.address(),
            class: entry.judgement.verdict.slug(),
            sign: sign(entry.judgement.verdict),
            words: entry.judgement.verdict.words(),
            shaken: shaken.contains(claim.id),
            lane: ledger
                .paper
                .topics
                .iter()
                .position(|topic| topic.stem == entry.topic.stem)
                .unwrap_or(0),
            on: claim
                .depends_on
                .iter()
                .filter_map(|id| places.get(id).copied())
                .collect(),
        }
    });
    let topics = ledger.paper.topics.iter().map(|topic| topic.title);
    map(&topics.collect::<Vec<_>>(), &nodes.collect::<Vec<_>>())
}

fn shaken(ledger: &Ledger) -> BTreeSet<&'static str> {
    let entries = ledger.entries.iter();
    let failing = entries.filter(|e| e.judgement.verdict.is_wrong());
    let resting = failing.flat_map(|e| ledger.resting_on(e.claim.id));
    resting.collect()
}

pub(super) fn key() -> String {
    let item = |v: Verdict| format!("<li>{} {}</li>", sign(v), verdict(v));
    let items: String = Verdict::ALL.map(item).concat();
    format!("<ul class=\"map-key\">{items}</ul>\n")
}

pub(super) fn what_falls(context: &Context<'_>) -> Html {
    let ledger = context.ledger;
    let entries = ledger.entries.iter();
    let failing = entries.filter(|e| e.judgement.verdict.is_wrong());
    let rows = failing.map(|entry| {
        let [fallen, standing] = ledger.fallen_and_standing(entry.claim.id);
        Ok([
            context.link(entry)?,
            verdict(entry.judgement.verdict),
            or_nothing(context.links(&fallen)?),
            or_nothing(context.links(&standing)?),
        ])
    });
    let head = [
        "Claim",
        "Verdict",
        "Falls with it",
        "Rests on it and stands",
    ];
    tried("falls", head, rows)
}

fn or_nothing(links: String) -> String {
    match links.is_empty() {
        true => "nothing".to_owned(),
        false => links,
    }
}

pub(super) fn list(context: &Context<'_>) -> Html {
    let ledger = context.ledger;
    let mut html = String::new();
    for topic in ledger.paper.topics {
        let row = |entry: &Entry| {
            let all = ledger.resting_on(entry.claim.id).len();
            let direct = context.users(entry.claim.id);
            let carries = match all {
                0 => String::new(),
                _ => format!("{} ({} in all)", context.links(&direct)?, count(all)),
            };
            Ok([
                context.link(entry)?,
                verdict(entry.judgement.verdict),
                context.links(entry.claim.depends_on)?,
                carries,
            ])
        };
        let rows = context.of_topic(topic.stem).map(row);
        let rows = rows.collect::<Result<Vec<_>, Fault>>()?;
        html += &format!(
            "<details><summary>{}: {}</summary>{}</details>\n",
            topic.title,
            counted(rows.len(), "claim"),
            table("rests", ["Claim", "Verdict", "Rests on", "Carries"], rows)
        );
    }
    Ok(html)
}

#[cfg(test)]
mod tests {
    use crate::ledger::example::ledger;

    #[test]
    fn what_rests_on_an_error_is_shaken_and_not_what_rests_on_a_condition() {
        let shaken = super::shaken(&ledger());
        assert_eq!(shaken, ["eq-2", "eq-3", "eq-6"].into());
    }
}
