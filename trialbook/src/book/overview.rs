//! What the first page shows of the whole.

use super::{
    claim_box::{heading, statement_in_line},
    context::{Context, sign, verdict},
    errata,
    error::Html,
    text::{escape, sentence},
};
use crate::ledger::{Entry, Verdict};
use crate::notation::plain_words;
use crate::publishing::Edition;
use crate::trials::Topic;
use serde::Serialize;
use std::collections::BTreeSet;

pub(super) const ANSWERS: &str = "answers.js";

pub(super) fn errors(context: &Context<'_>, with_fallen: bool) -> Html {
    let line = |entry: &Entry| {
        let wrong = entry.in_short().unwrap_or_default();
        let (_, wrong) = wrong.split_once(": ").unwrap_or(("", &wrong));
        let words = context.maths.words(&sentence(wrong))?;
        let link = context.link(entry)?;
        let (mut number, mut fallen) = (String::new(), String::new());
        if with_fallen {
            number = format!("No. {}, ", errata::number(context, entry.claim.id));
            let [with_it, _] = context.ledger.fallen_and_standing(entry.claim.id);
            let mut roots = context.ledger.roots().map(|root| root.claim.id);
            // Two errors on one way have the same heirs.
            let alike = roots.find(|root| context.ledger.fallen_and_standing(root)[0] == with_it);
            fallen = match alike {
                _ if with_it.is_empty() => String::new(),
                Some(id) if id != entry.claim.id => format!(
                    " The same claims fall as with No. {}.",
                    errata::number(context, id)
                ),
                _ => format!(" With it {}.", context.links(&with_it)?),
            };
        }
        Ok(format!("<li>{number}{link}: {words}.{fallen}</li>"))
    };
    let lines: Html = context.ledger.roots().map(line).collect();
    Ok(match lines?.as_str() {
        "" => "<p>Nothing is false by an error of its own.</p>\n".to_owned(),
        lines => format!("<ul class=\"errors\">{lines}</ul>\n"),
    })
}

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

pub(super) fn repository(edition: &Edition) -> String {
    match edition.repository {
        Some(address) => format!("<a href=\"{}\">the program’s sources</a>", escape(address)),
        None => "the program’s sources, which have no public address yet,".to_owned(),
    }
}

pub(super) fn field() -> String {
    format!(
        "<form class=\"ask\" role=\"search\" aria-label=\"Ask for a claim\" data-answers=\"{ANSWERS}\" hidden>\
         <label>Is it right? <input type=\"search\" autocomplete=\"off\" spellcheck=\"false\" \
         placeholder=\"13, λc, 0.537, stick slip\"></label>\
         <div class=\"answers\" role=\"status\"></div></form>\n"
    )
}

#[derive(Serialize)]
struct Answer {
    id: &'static str,
    at: String,
    name: String,
    equation: Option<u16>,
    title: String,
    verdict: String,
    says: String,
    /// As MathML; where there is none, the words.
    formula: String,
}

#[derive(Serialize)]
struct Hint {
    is: String,
    means: String,
    id: &'static str,
}

#[derive(Serialize)]
struct Answers {
    claims: Vec<Answer>,
    symbols: Vec<Hint>,
}

pub(super) fn answers(context: &Context<'_>) -> Html {
    let entries = &context.ledger.entries;
    let statements = entries
        .iter()
        .map(|entry| statement_in_line(context, entry.claim));
    let statements: Result<Vec<_>, _> = statements.collect();
    let (statements, forms) = (statements?, context.maths.forms());
    let claim = |(entry, statement): (&Entry, &String)| {
        let claim = entry.claim;
        let says = entry.in_short();
        Answer {
            id: claim.id,
            at: entry.address(),
            name: plain_words(&claim.name()),
            equation: claim.equation,
            title: plain_words(claim.title),
            verdict: verdict(entry.judgement.verdict),
            says: plain_words(&says.unwrap_or_else(|| sentence(&entry.brief()))),
            formula: forms.with_mathml(statement),
        }
    };
    let claims = entries.iter().zip(&statements).map(claim).collect();
    let symbols = context.edition.symbols.iter().map(|symbol| Hint {
        is: symbol.plain.to_owned(),
        means: plain_words(symbol.meaning),
        id: symbol.claim,
    });
    let all = Answers {
        claims,
        symbols: symbols.collect(),
    };
    let text = serde_json::to_string(&all).map_err(|error| error.to_string())?;
    Ok(format!("window.trialbookAnswers = {text};\n"))
}
