//! All claims with their verdicts, and how many of each there are.

use super::{
    claim_box::statement_in_line,
    context::{Context, verdict},
    error::{Fault, Html},
    skeleton::strip,
    table::{code, table, tried},
    text::{count, counted, escape},
};
use crate::evidence::Route;
use crate::ledger::{Entry, Ledger, Standing, Verdict};
use crate::trials::{Claim, Topic};
use std::collections::BTreeSet;

pub(super) fn counts(ledger: &Ledger) -> String {
    let counts = ledger.counts();
    let given = Verdict::ALL.into_iter().filter(|v| counts[v] > 0);
    let rows = given.map(|v| [verdict(v), count(counts[&v]), meaning(v).to_owned()]);
    table("counts", ["Verdict", "Claims", "Meaning"], rows)
}

fn meaning(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Confirmed => "every trial agrees, by two independent routes or by a proof",
        Verdict::Degenerate => {
            "the same, but for points where the statement has no value, or that fill no interval, such as a particle at rest"
        }
        Verdict::Conditional => "true, but only under a condition that the paper does not state",
        Verdict::Misprint => {
            "false as printed; a small correction holds, and nothing takes the error over"
        }
        Verdict::Misderived => "a formula that is false; what is right holds instead",
        Verdict::Inherited => "false because what it follows from is; the step to it is right",
        Verdict::Refuted => "a statement in words that is false; what is right holds instead",
        Verdict::Definition => "introduces a symbol; consistent with the use made of it",
        Verdict::Undecided => "the trials made so far do not settle it",
    }
}

pub(super) fn folded_topic(context: &Context<'_>, stem: &str) -> Html {
    let table = topic(context, stem)?;
    let entries: Vec<_> = context.of_topic(stem).collect();
    let wrong = entries.iter().filter(|e| e.judgement.verdict.is_wrong());
    let wrong = match wrong.count() {
        0 => "none".to_owned(),
        n => count(n),
    };
    Ok(format!(
        "<div class=\"claims\">{}<details class=\"contents\"><summary>{}, {wrong} false</summary>{table}</details></div>\n",
        strip(&entries),
        counted(entries.len(), "claim"),
    ))
}

fn topic(context: &Context<'_>, stem: &str) -> Html {
    let mut entries = context.of_topic(stem).peekable();
    if entries.peek().is_none() {
        return Err(format!("there is no topic `{stem}`").into());
    }
    let head = ["Claim", "Verdict", "How that is known"];
    tried("ledger", head, entries.map(|entry| row(context, entry)))
}

fn row(context: &Context<'_>, entry: &Entry) -> Result<[String; 3], Fault> {
    let claim = entry.claim;
    let maths = context.maths;
    let statement = statement_in_line(context, claim)?;
    // The link already bears the title of a claim without a number.
    let title = match claim.equation {
        Some(_) => maths.words(claim.title)?,
        None => String::new(),
    };
    let wrong = match entry.in_short() {
        Some(words) => format!("<div class=\"says\">{}</div>", maths.words(&words)?),
        None => String::new(),
    };
    let link = context.link(entry)?;
    let claim = format!("{link} {title}<div class=\"says\">{statement}</div>{wrong}");
    Ok([claim, verdict(entry.judgement.verdict), known(entry)])
}

fn known(entry: &Entry) -> String {
    let strongest = entry.strongest().map(Route::name);
    let routes: BTreeSet<_> = entry.evidence.iter().map(|e| e.route.name()).collect();
    let others: Vec<_> = routes
        .into_iter()
        .filter(|route| Some(*route) != strongest)
        .collect();
    let first = entry.standing().zip(strongest);
    let first = first.map(|(known, route)| format!("{}, {route}", known.word()));
    let others = (!others.is_empty()).then(|| format!("also {}", others.join(", ")));
    let points = Some(entry.points()).filter(|points| *points > 0);
    let points = points.map(|points| counted(points, "point"));
    let parts = [first, others, points].into_iter().flatten();
    parts.collect::<Vec<_>>().join("; ")
}

pub(super) fn whole_ledger(context: &Context<'_>) -> Html {
    let mut html = String::new();
    let mut seen = BTreeSet::new();
    for entry in &context.ledger.entries {
        let stem = entry.topic.stem;
        if seen.insert(stem) {
            html += &format!(
                "<h2 id=\"ledger-{stem}\"><a class=\"header\" href=\"#ledger-{stem}\">{}{}</a></h2>\n",
                sections(entry.topic),
                escape(entry.topic.title)
            );
            html += &topic(context, stem)?;
        }
    }
    Ok(html)
}

/// The sections of the paper that a topic treats: `2.1 `, `3 to 3.4 `.
fn sections(topic: &Topic) -> String {
    match topic.claims() {
        [] => String::new(),
        [first, .., last] if first.section != last.section => {
            format!("{} to {} ", first.section, last.section)
        }
        [first, ..] => format!("{} ", first.section),
    }
}

pub(super) fn sheets(context: &Context<'_>) -> Html {
    let sheet = |entry: &Entry| {
        Ok(format!(
            "<h2 id=\"sheet-{id}\"><a class=\"header\" href=\"#sheet-{id}\">{name}</a></h2>\n{}",
            code(&entry.sheet()),
            id = entry.claim.id,
            name = context.maths.words(&entry.claim.name())?
        ))
    };
    context.ledger.entries.iter().map(sheet).collect()
}

pub(super) fn proofs(ledger: &Ledger) -> String {
    let row = |name: &str, counts: &dyn Fn(&Entry) -> bool| {
        let entries: Vec<_> = ledger.entries.iter().filter(|e| counts(e)).collect();
        let [proved, argued, measured, defined] = Standing::ALL.map(|of| {
            let known = entries.iter().filter(|e| e.standing() == Some(of));
            count(known.count())
        });
        let all = count(entries.len());
        [name.to_owned(), proved, argued, measured, defined, all]
    };
    let numbered = |e: &Entry| e.claim.equation.is_some();
    let rows = [
        row("Numbered", &numbered),
        row("Statements in words and pictures", &|e| !numbered(e)),
        row("All", &|_| true),
    ];
    table(
        "proofs",
        ["Claims", "Proved", "Argued", "Measured", "Defined", "All"],
        rows,
    )
}

pub(super) fn unreached(context: &Context<'_>) -> Html {
    let row = |(why, claims): &(&str, Vec<&'static Claim>)| {
        let ids: Vec<_> = claims.iter().map(|claim| claim.id).collect();
        Ok([context.maths.words(why)?, context.links(&ids)?])
    };
    let reasons = context.ledger.paper.unproved();
    let head = ["What is missing", "Claims"];
    tried("unreached", head, reasons.iter().map(row))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::Kind;

    #[test]
    fn proofs_are_counted_by_what_they_are() {
        let mut ledger = crate::ledger::example::ledger();
        let last = ledger.entries.last_mut().unwrap();
        last.claim = Box::leak(Box::new(Claim {
            kind: Kind::Definition,
            ..*last.claim
        }));
        let html = proofs(&ledger);
        let cells = |name: &str| {
            let (_, row) = html.split_once(&format!("<td>{name}</td>")).unwrap();
            let row = row.split("</tr>").next().unwrap();
            row.replace("</td><td>", " ")
        };
        // No theorem of them is before a kernel, and no sentence carries their proofs.
        for name in ["Numbered", "All"] {
            assert_eq!(cells(name), "<td>0 0 6 1 8</td>");
        }
        assert_eq!(
            cells("Statements in words and pictures"),
            "<td>0 0 0 0 0</td>"
        );
    }
}
