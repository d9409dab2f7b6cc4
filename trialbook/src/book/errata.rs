//! The page of errata, and the letters beside it.

use super::{
    claim_box::{forms, heading, side_by_side, statement},
    context::{Context, verdict},
    error::Html,
    text::sentence,
};
use crate::ledger::{Entry, Erratum, Verdict};

pub(super) fn list(context: &Context<'_>, verdicts: &[Verdict]) -> Html {
    let errata = context.errata.iter();
    let chosen = errata.filter(|e| verdicts.contains(&e.verdict));
    let items = chosen.map(|erratum| item(context, erratum));
    Ok(match items.collect::<Result<String, _>>()? {
        none if none.is_empty() => "<p>None.</p>\n".to_owned(),
        items => items,
    })
}

/// Errors first, then what inherits them, slips in print and conditions, each in the paper's order.
pub(super) fn number(context: &Context<'_>, id: &str) -> usize {
    let rank = |erratum: &&Erratum| match erratum.verdict {
        Verdict::Inherited => 1,
        Verdict::Misprint => 2,
        Verdict::Conditional => 3,
        _ => 0,
    };
    let mut all: Vec<_> = context.errata.iter().collect();
    all.sort_by_key(rank);
    1 + all.iter().take_while(|erratum| erratum.id != id).count()
}

pub(super) fn errors(context: &Context<'_>, with_fallen: bool) -> Html {
    let line = |entry: &Entry| {
        let wrong = entry.in_short().unwrap_or_default();
        let (_, wrong) = wrong.split_once(": ").unwrap_or(("", &wrong));
        let words = context.maths.words(&sentence(wrong))?;
        let link = context.link(entry)?;
        let (mut numbered, mut fallen) = (String::new(), String::new());
        if with_fallen {
            numbered = format!("No. {}, ", number(context, entry.claim.id));
            let [with_it, _] = context.ledger.fallen_and_standing(entry.claim.id);
            let mut roots = context.ledger.roots().map(|root| root.claim.id);
            // Two errors on one way have the same heirs.
            let alike = roots.find(|root| context.ledger.fallen_and_standing(root)[0] == with_it);
            fallen = match alike {
                _ if with_it.is_empty() => String::new(),
                Some(id) if id != entry.claim.id => {
                    format!(" The same claims fall as with No. {}.", number(context, id))
                }
                _ => format!(" With it {}.", context.links(&with_it)?),
            };
        }
        Ok(format!("<li>{numbered}{link}: {words}.{fallen}</li>"))
    };
    let lines: Html = context.ledger.roots().map(line).collect();
    Ok(match lines?.as_str() {
        "" => "<p>Nothing is false by an error of its own.</p>\n".to_owned(),
        lines => format!("<ul class=\"errors\">{lines}</ul>\n"),
    })
}

fn item(context: &Context<'_>, erratum: &Erratum) -> Html {
    let maths = context.maths;
    let entry = context.entry(erratum.id)?;
    let title = maths.words(&heading(entry.claim))?;
    let [old, new] = match (erratum.verdict, entry.claim.correction) {
        (Verdict::Conditional, _) | (_, None) => [
            statement(context, entry.claim, entry.claim.latex)?,
            format!(
                "<p class=\"claim-words\">{}</p>",
                maths.words(&erratum.new)?
            ),
        ],
        (_, Some(correction)) => forms(context, entry.claim, correction.latex)?,
    };
    let mut html = format!(
        "<section class=\"erratum {slug}\" aria-labelledby=\"erratum-{id}\"><h3 id=\"erratum-{id}\"><a href=\"{page}.html#{id}\">{title}</a></h3>\
         <p class=\"claim-place\">No. {number}, section {section} {verdict}</p>\
         <div class=\"{beside}\"><div class=\"printed\"><p class=\"claim-label\">Printed</p>{old}</div>\
         <div class=\"corrected\"><p class=\"claim-label\">Should be</p>{new}</div></div>",
        slug = erratum.verdict.slug(),
        beside = side_by_side([&old, &new]),
        id = erratum.id,
        page = entry.topic.stem,
        number = number(context, erratum.id),
        section = erratum.section,
        verdict = verdict(erratum.verdict),
    );
    let wrong = maths.words(&erratum.wrong)?;
    html += &format!("<p><strong>{wrong}</strong></p>");
    let watch = context.watch(entry.claim);
    for (label, words, watch) in [
        ("Reason", Some(&erratum.reason), ""),
        ("By hand", erratum.case.as_ref(), watch.as_str()),
    ] {
        if let Some(words) = words.filter(|words| !words.is_empty()) {
            html += &format!(
                "<p><strong>{label}:</strong> {}.{watch}</p>",
                maths.words(&sentence(words))?
            );
        }
    }
    let evidence = erratum.evidence.iter().map(|said| maths.words(said));
    let evidence = evidence.collect::<Result<Vec<_>, _>>()?.join("</li><li>");
    html += &format!(
        "<details class=\"samples\"><summary>Evidence</summary><ul><li>{evidence}</li></ul></details>"
    );
    html += &context.neighbours("Falls with it:", &erratum.fallen)?;
    html += &context.neighbours("Rests on it and stands:", &erratum.standing)?;
    Ok(html + "</section>\n")
}
