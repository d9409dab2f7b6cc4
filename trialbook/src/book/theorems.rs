//! Theorems before the kernel: in the box of their claim, and all of them on a page.

use super::{context::Context, error::Html, text::escape};
use crate::ledger::Entry;
use crate::notation::plain_formula;
use crate::theorems::Known;
use crate::theorems::prose::{Said, Writer, spoken};
use crate::theorems::record::Accepted;
use crate::theorems::source::Item;
use crate::trials::Paper;

pub(super) fn of_claim(context: &Context<'_>, entry: &Entry) -> Html {
    let all = context
        .ledger
        .paper
        .known_theorems()
        .of_claim(entry.claim.id);
    all.into_iter()
        .map(|(accepted, item)| theorem(context, accepted, item))
        .collect()
}

pub(super) fn beside(context: &Context<'_>) -> Html {
    let paper = context.ledger.paper;
    let all = paper.known_theorems().beside(paper.claim_ids());
    all.into_iter()
        .map(|(accepted, item)| theorem(context, accepted, item))
        .collect()
}

/// How the formula of a definition is written: `\text{(13)}`, or by the words of its name, `\text{late angle}` for `s21_late_angle`; with a
/// hat where it corrects or adds.
fn formula(known: &Known, paper: &Paper, name: &str) -> Option<String> {
    let (claim, printed) = known.formulas.get(name)?;
    let (_, claim) = paper.find(claim)?;
    let words = match claim.equation {
        Some(number) => format!("({number})"),
        None => {
            let prefix = match name.split('_').next() {
                Some("right") => 2,
                Some(section) if section.contains(|c: char| c.is_ascii_digit()) => 1,
                _ => 0,
            };
            name.split('_').skip(prefix).collect::<Vec<_>>().join(" ")
        }
    };
    Some(match printed {
        true => format!(r"\text{{{words}}}"),
        false => format!(r"\widehat{{\text{{{words}}}}}"),
    })
}

fn theorem(context: &Context<'_>, accepted: &Accepted, item: &Item) -> Html {
    let paper = context.ledger.paper;
    let known = paper.known_theorems();
    let formula = |name: &str| formula(known, paper, name);
    let writer = Writer {
        sources: &known.sources,
        formula: &formula,
    };
    let said = writer.said(&accepted.statement);
    let told = match said.filter(fits) {
        Some(said) => told(context, &said)?,
        None => String::new(),
    };
    let occurs = if accepted.occurs {
        "; that this occurs is shown, too"
    } else {
        ""
    };
    Ok(format!(
        "<div class=\"theorem\" id=\"{name}\"><p class=\"claim-label\">{}</p><p>{about}</p>{told}\
         <details class=\"rocq\"><summary>As the kernel has accepted it</summary><pre><code class=\"language-text nohighlight\">Theorem {name} :\n{statement}.</code></pre>\
         <p class=\"measure\">{file}, {seconds:.1} s; rests on {axioms}{occurs}.</p></details></div>",
        context.explained("Theorem", "kernel"),
        name = escape(&accepted.name),
        about = context.maths.folded(&spoken(&item.about))?,
        statement = linked(context, &accepted.statement),
        file = escape(&accepted.file),
        seconds = accepted.seconds,
        axioms = match accepted.axioms.join(" and ") {
            none if none.is_empty() => "no axiom".to_owned(),
            some => escape(&some),
        },
    ))
}

const LINE: usize = 72;

/// Else a statement is shown as it was accepted alone.
fn fits(said: &Said) -> bool {
    let all = said.given.iter().chain(&said.supposed).chain(&said.holds);
    let mut formulas = all.flat_map(|text| text.split('$').skip(1).step_by(2));
    formulas.all(|formula| {
        let whole = formula.matches('{').count() == formula.matches('}').count();
        whole && plain_formula(formula).chars().count() <= LINE
    })
}

fn told(context: &Context<'_>, said: &Said) -> Html {
    let list = |before: &str, of: &[String]| -> Html {
        if of.is_empty() {
            return Ok(String::new());
        }
        let items = of
            .iter()
            .map(|one| Ok(format!("<li>{}</li>", context.maths.words(one)?)));
        Ok(format!(
            "<p>{before}</p><ul>{}</ul>",
            items.collect::<Html>()?
        ))
    };
    let given = match said.given.is_empty() {
        true => String::new(),
        false => format!(
            "<p>Given {}.</p>",
            context.maths.words(&said.given.join("; "))?
        ),
    };
    Ok(given + &list("Suppose", &said.supposed)? + &list("Then", &said.holds)?)
}

fn linked(context: &Context<'_>, statement: &str) -> String {
    let sources = &context.ledger.paper.known_theorems().sources;
    let word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'' | '.');
    let mut out = String::new();
    let mut rest = statement;
    while !rest.is_empty() {
        let length = match rest.starts_with(word) {
            true => rest.find(|c: char| !word(c)).unwrap_or(rest.len()),
            false => rest.find(word).unwrap_or(rest.len()),
        };
        let text = &rest[..length];
        let meaning = sources.meaning(text).filter(|_| text.starts_with(word));
        match meaning {
            Some(item) => {
                out += &format!(
                    "<a href=\"{}#{}\">{}</a>",
                    page(context),
                    place(item),
                    escape(text)
                )
            }
            None => out += &escape(text),
        }
        rest = &rest[length..];
    }
    out
}

fn place(item: &Item) -> String {
    escape(&format!("{}.{}", item.stem(), item.name))
}

fn page(context: &Context<'_>) -> String {
    let mut pages = context.edition.written();
    let page = pages.find(|page| page.text.contains("{{definitions}}"));
    page.map_or(String::new(), |page| format!("{}.html", page.stem))
}

pub(super) fn definitions(context: &Context<'_>) -> Html {
    let known = context.ledger.paper.known_theorems();
    let used: std::collections::BTreeSet<_> = known
        .record
        .iter()
        .filter_map(|a| known.sources.proved(&a.name))
        .flat_map(|item| known.sources.behind(item))
        .collect();
    let all = used.into_iter().map(|i| {
        let item = &known.sources.items[i];
        let Item { about, text, file, .. } = item;
        Ok(format!(
            "<div class=\"meaning\" id=\"{name}\"><p>{}</p><pre><code class=\"language-text nohighlight\">{}</code></pre><p class=\"measure\">{}</p></div>",
            context.maths.words(&spoken(&about.replace(['«', '»'], "")))?,
            linked(context, &format!("{text}.")),
            escape(file),
            name = place(item),
        ))
    });
    all.collect()
}
