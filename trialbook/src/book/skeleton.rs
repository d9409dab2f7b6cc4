//! A mark for each claim, by its verdict.

use super::{
    claim_box::heading,
    context::{Context, sign},
    text::escape,
};
use crate::ledger::{Entry, Verdict};
use crate::notation::plain_words;
use crate::trials::Topic;
use std::collections::BTreeSet;

fn mark(entry: &Entry, name: &str, more: &str) -> String {
    let verdict = entry.judgement.verdict;
    let name = escape(&format!("{name}: {}", verdict.words()));
    format!(
        "<a class=\"{}\" href=\"{}\" title=\"{name}\" aria-label=\"{name}\"{more}>{}</a>",
        verdict.slug(),
        entry.address(),
        sign(verdict),
    )
}

pub(super) fn strip(entries: &[&Entry]) -> String {
    let marks = entries.iter().enumerate().map(|(i, entry)| {
        let more = if i == 0 { "" } else { " tabindex=\"-1\"" };
        mark(entry, &plain_words(&heading(entry.claim)), more)
    });
    format!(
        "<div class=\"skeleton\" role=\"group\" aria-label=\"The claims, by verdict\">{}</div>",
        marks.collect::<String>()
    )
}

/// One mark can be reached by keyboard; a script leads on from it.
pub(super) fn skeleton(context: &Context<'_>) -> String {
    let marked = |(number, entry): (u16, &Entry)| {
        let more = if number == 1 { "" } else { " tabindex=\"-1\"" };
        // Each tenth shows which it is.
        let more = match number % 10 {
            0 => format!("{more} data-number=\"{number}\""),
            _ => more.to_owned(),
        };
        let name = format!("({number}) {}", plain_words(entry.claim.title));
        mark(entry, &name, &more)
    };
    let part = |topic: &&Topic| {
        let entries = context.of_topic(topic.stem);
        let mut numbered: Vec<_> = entries
            .filter_map(|entry| Some((entry.claim.equation?, entry)))
            .collect();
        numbered.sort_by_key(|(number, _)| *number);
        let section = first_section(topic);
        // Where topics share a section, what the title has after its colon tells them apart.
        let topics = context.ledger.paper.topics;
        let sharing = topics.iter().filter(|t| first_section(t) == section);
        let shared = sharing.count() > 1;
        let label = match topic.title.split_once(": ") {
            Some((_, part)) if shared => format!("{section} {part}"),
            _ => section.to_owned(),
        };
        let marks: String = numbered.into_iter().map(marked).collect();
        match marks.is_empty() {
            true => marks,
            false => format!(
                "<div role=\"group\" aria-label=\"{title}\"><abbr title=\"{title}\">{}</abbr>{marks}</div>",
                escape(&label),
                title = escape(topic.title)
            ),
        }
    };
    let parts: String = context.ledger.paper.topics.iter().map(part).collect();
    let entries = &context.ledger.entries;
    let numbered = entries.iter().filter(|e| e.claim.equation.is_some());
    let numbered: BTreeSet<_> = numbered.map(|e| e.judgement.verdict).collect();
    let used = Verdict::ALL.into_iter().filter(|v| numbered.contains(v));
    let key = used.map(|v| format!("<li class=\"{} marked\">{}</li>", v.slug(), v.words()));
    format!(
        "<div class=\"skeleton\" role=\"group\" aria-label=\"The numbered equations, by verdict\">{parts}</div>\
         <ul class=\"skeleton-key\">{}</ul>\n",
        key.collect::<String>()
    )
}

fn first_section(topic: &Topic) -> &'static str {
    topic.claims().first().map_or("", |claim| claim.section)
}
