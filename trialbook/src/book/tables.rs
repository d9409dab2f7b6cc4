//! Tables made from the ledger.

use super::{
    claim_box::statement_in_line,
    context::{Context, verdict},
    error::{Fault, Html},
    overview::strip,
    text::{count, counted, escape, in_code, size},
};
use crate::evidence::{Evidence, Route, Tolerance};
use crate::ledger::{Entry, Ledger, Standing, Verdict};
use crate::trials::{Claim, Excuse, Topic, attempt::Attempt};
use std::collections::{BTreeMap, BTreeSet};

/// A table, as a block of HTML. The cells are HTML.
pub fn table<const N: usize>(
    class: &str,
    head: [&str; N],
    rows: impl IntoIterator<Item = [String; N]>,
) -> String {
    let head = head.map(|cell| format!("<th scope=\"col\">{cell}</th>"));
    let head = head.concat();
    let row = |cells: [String; N]| {
        let cells = cells.map(|cell| format!("<td>{cell}</td>"));
        format!("<tr>{}</tr>", cells.concat())
    };
    let rows: String = rows.into_iter().map(row).collect();
    format!(
        "<div class=\"table-wrapper {class}\"><table><thead><tr>{head}</tr></thead>\
         <tbody>{rows}</tbody></table></div>\n"
    )
}

pub(super) fn tried<const N: usize>(
    class: &str,
    head: [&str; N],
    rows: impl Iterator<Item = Result<[String; N], Fault>>,
) -> Html {
    Ok(table(class, head, rows.collect::<Result<Vec<_>, _>>()?))
}

/// A text as a block of code, in HTML.
pub fn code(text: &str) -> String {
    let lines: Vec<_> = text.lines().map(escape).collect();
    let lines = lines.join("\n");
    format!("<pre><code class=\"language-text\">{lines}</code></pre>\n")
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

pub(super) fn routes(ledger: &Ledger) -> String {
    const ALL: [(Route, &str); 8] = [
        (Route::Exact, "zero-testing in exact arithmetic"),
        (
            Route::Certified,
            "an enclosure by intervals, rounded outwards",
        ),
        (Route::Integration, "integration of the equation of motion"),
        (
            Route::Quadrature,
            "numerical integration of a given integrand",
        ),
        (Route::Root, "root-finding"),
        (Route::Limit, "the approach to a limit, its rate included"),
        (Route::Census, "a count over many cases"),
        (
            Route::Consistency,
            "dimensions, and the use made of a definition",
        ),
    ];
    let rows = ALL.map(|(route, what)| {
        let trials = ledger.evidence().filter(|e| e.route == route).count();
        let proves = match route.is_proof() {
            true => "proves",
            false => "measures",
        };
        [
            route.name().to_owned(),
            what.to_owned(),
            proves.to_owned(),
            count(route.min_points()),
            count(trials),
        ]
    });
    table(
        "routes",
        ["Route", "What it is", "It", "Fewest points", "Trials"],
        rows,
    )
}

pub(super) fn tolerances(context: &Context<'_>) -> Html {
    let mut uses: BTreeMap<&str, (Tolerance, usize)> = BTreeMap::new();
    for evidence in context.ledger.evidence() {
        let tolerance = evidence.tolerance;
        uses.entry(tolerance.name).or_insert((tolerance, 0)).1 += 1;
    }
    let mut uses: Vec<_> = uses.into_values().collect();
    uses.sort_by(|(a, _), (b, _)| a.value.total_cmp(&b.value));
    let rows = uses.into_iter().map(|(tolerance, trials)| {
        let reason = context.maths.words(tolerance.reason)?;
        Ok([size(tolerance.value), reason, count(trials)])
    });
    tried("tolerances", ["Tolerance", "Reason", "Trials"], rows)
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

fn sizes(measured: &Evidence) -> [String; 3] {
    [
        count(measured.points),
        size(measured.worst),
        size(measured.tolerance.value),
    ]
}

pub(super) fn accuracy(context: &Context<'_>) -> Html {
    let entries = context.ledger.entries.iter();
    let measured = entries.filter_map(|entry| Some((entry, entry.closest()?)));
    let rows = measured.map(|(entry, closest)| {
        let [points, worst, tolerance] = sizes(closest);
        Ok([
            context.link(entry)?,
            closest.route.name().to_owned(),
            closest
                .subject
                .words(entry.is_conditional(), entry.claim.ours)
                .to_owned(),
            points,
            worst,
            tolerance,
        ])
    });
    let head = [
        "Claim",
        "By",
        "What",
        "Points",
        "Worst disagreement",
        "Tolerance",
    ];
    tried("accuracy", head, rows)
}

/// `survivors`, wrong variants that are not rejected; `cornered`, mistakes in a corner that no measurement
/// notices, and the formulas that none reads.
pub(super) fn excused(context: &Context<'_>, name: &'static str) -> Html {
    type Lists = &'static [fn(&Claim) -> &[Excuse]];
    let head = ["Claim", "Wrong variant", "Why it stands"];
    let lists: Lists = match name {
        "survivors" => &[|claim| claim.survivors],
        _ => &[|claim| claim.cornered, |claim| claim.unread],
    };
    let entries = || context.ledger.entries.iter();
    let all = lists.iter().flat_map(|list| {
        entries().flat_map(move |entry| list(entry.claim).iter().map(move |excuse| (entry, excuse)))
    });
    let rows = all.map(|(entry, excuse)| {
        let why = context.maths.words(excuse.why)?;
        Ok([context.link(entry)?, in_code(excuse.of), why])
    });
    tried(name, head, rows)
}

fn trials<'a>(context: &Context<'a>) -> impl Iterator<Item = (&'a Entry, &'static Attempt)> {
    let entries = context.ledger.entries.iter();
    entries.flat_map(|entry| entry.claim.trials.iter().map(move |trial| (entry, trial)))
}

/// `coarse`, where measurements do not notice a mistake of twice their tolerance; `spared`, where proofs do
/// not reject every wrong variant.
pub(super) fn excused_trials(context: &Context<'_>, name: &'static str) -> Html {
    type List = fn(&Attempt) -> &'static [Excuse];
    let (head, list): (_, List) = match name {
        "spared" => (
            [
                "Claim",
                "Proof",
                "Formula",
                "Why the proof does not reject all",
            ],
            |trial| trial.spared,
        ),
        _ => (
            ["Claim", "Trial", "Formula", "Why it does not show"],
            |trial| trial.coarse,
        ),
    };
    let all = trials(context)
        .flat_map(|(entry, trial)| list(trial).iter().map(move |excuse| (entry, trial, excuse)));
    let rows = all.map(|(entry, trial, excuse)| {
        Ok([
            context.link(entry)?,
            in_code(trial.name()),
            in_code(excuse.of),
            context.maths.words(excuse.why)?,
        ])
    });
    tried(name, head, rows)
}

pub(super) fn idle(context: &Context<'_>) -> Html {
    let idle = trials(context).filter_map(|(entry, trial)| Some((entry, trial, trial.idle?)));
    let rows = idle.map(|(entry, trial, why)| {
        let why = context.maths.words(why)?;
        Ok([context.link(entry)?, in_code(trial.name()), why])
    });
    let head = ["Claim", "Trial", "What no formula says"];
    tried("idle", head, rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::{Kind, Subject};

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

    #[test]
    fn a_measurement_is_told_by_what_was_found_and_then_by_what_is_allowed() {
        let measured = crate::ledger::example::tried(Route::Root, Subject::Printed, 3);
        let allowed = size(measured.tolerance.value);
        assert_eq!(sizes(&measured), ["20".to_owned(), size(1.0), allowed]);
    }
}
