//! The box that shows one claim: what the paper says, the verdict, and all that it rests on.

use super::code::Place;
use super::context::{Context, verdict};
use super::deep;
use super::error::Fault;
use super::maths::Maths;
use super::plain;
use super::text::{counted, escape, sentence, value};
use crate::claims::{Claim, Sort};
use crate::evidence::{Change, Evidence, Kind, Outcome, Subject};
use crate::ledger::{Entry, Tally};

/// The box of one claim, as a block of HTML.
pub(super) fn claim_box(context: &Context<'_>, entry: &Entry) -> Result<String, Fault> {
    let claim = entry.claim;
    let judgement = &entry.judgement;
    let (in_short, ground) = match entry.in_short() {
        Some(words) => {
            let ground = format!("It {}.", judgement.ground);
            (
                format!("<strong>{}</strong> ", context.maths.words(&words)?),
                ground,
            )
        }
        None => (String::new(), judgement.ground.clone()),
    };
    let mut html = format!(
        "<article class=\"claim {slug}\" aria-labelledby=\"{id}\">\
         <h3 id=\"{id}\" class=\"claim-title\"><a class=\"header\" href=\"#{id}\">{heading}</a></h3>\
         <p class=\"claim-place\">Section {section}, {kind} <a class=\"permalink\" href=\"#{id}\">#{id}</a></p>\
         <p class=\"claim-verdict\">{verdict} {in_short}{ground}</p>",
        slug = judgement.verdict.slug(),
        id = claim.id,
        heading = context.maths.words(&heading(claim))?,
        section = escape(claim.section),
        kind = claim.kind.name(),
        verdict = verdict(judgement.verdict),
        ground = context.maths.words(&ground)?,
    );
    html.push_str(&statements(context, entry)?);
    html.push_str(&conditions(context, claim)?);
    html.push_str(&trials(context, entry)?);
    html.push_str(&neighbours(context, claim)?);
    html.push_str(&code(context, entry));
    html.push_str(&source(claim));
    html.push_str("</article>\n");
    Ok(html)
}

/// `(11) Speed as a function of direction`, `Figure 1: Portraits of the velocity`.
pub(super) fn heading(claim: &Claim) -> String {
    let label = claim.name();
    let title = sentence(claim.title);
    match claim.kind {
        _ if title.is_empty() => label,
        Kind::Figure => format!("{label}: {title}"),
        _ if label == claim.title => title,
        _ => format!("{label} {title}"),
    }
}

/// What a claim states, or what replaces it: a formula on its own line, or words with formulas in them.
pub(super) fn statement(
    context: &Context<'_>,
    claim: &Claim,
    latex: &str,
) -> Result<String, Fault> {
    if is_formula(claim, latex) {
        let formula = context.maths.display(latex)?;
        Ok(format!("<div class=\"claim-formula\">{formula}</div>"))
    } else {
        let words = context.maths.words(latex)?;
        Ok(format!("<p class=\"claim-words\">{words}</p>"))
    }
}

/// A numbered claim is a formula unless formulas stand within it.
pub(super) fn is_formula(claim: &Claim, latex: &str) -> bool {
    claim.equation.is_some() && !latex.contains('$')
}

fn statements(context: &Context<'_>, entry: &Entry) -> Result<String, Fault> {
    let claim = entry.claim;
    let printed = statement(context, claim, claim.latex)?;
    let Some(correction) = claim.correction else {
        return Ok(printed + &by_hand(context, entry)?);
    };
    let changed = match correction.change {
        Change::Sign => "a sign",
        Change::Factor => "a factor",
        Change::Symbol => "a symbol",
        Change::Statement => "the statement",
    };
    let heading = match entry.judgement.verdict {
        // The printed form is right where it has a value; nothing is corrected.
        verdict if verdict.has_condition() => "A form that needs no condition".to_owned(),
        _ => format!("As corrected (changed: {changed})"),
    };
    let corrected = statement(context, claim, correction.latex)?;
    Ok(format!(
        "<div class=\"claim-forms\">\
         <div class=\"printed\"><p class=\"claim-label\">As printed</p>{printed}</div>\
         <div class=\"corrected\"><p class=\"claim-label\">{heading}</p>{corrected}</div>\
         </div>{}",
        by_hand(context, entry)?
    ))
}

/// Why the claim fails, and a case to check on paper.
fn by_hand(context: &Context<'_>, entry: &Entry) -> Result<String, Fault> {
    let fails = entry.judgement.verdict.is_wrong();
    let Some(case) = entry.paper.case(entry.claim.id).filter(|_| fails) else {
        return Ok(String::new());
    };
    let words = case
        .words()
        .map_err(|failure| Fault::Placeholder(failure.to_string()))?;
    Ok(format!(
        "<div class=\"by-hand\"><p><strong>Why:</strong> {}.</p><p><strong>By hand:</strong> {}.</p></div>",
        context.maths.words(&sentence(case.reason))?,
        context.maths.words(&sentence(&words))?
    ))
}

fn conditions(context: &Context<'_>, claim: &Claim) -> Result<String, Fault> {
    if claim.conditions.is_empty() {
        return Ok(String::new());
    }
    let mut html = String::from("<p class=\"claim-label\">Conditions</p><ul class=\"conditions\">");
    for condition in claim.conditions {
        let class = match condition.sort {
            Sort::Stated => "stated",
            Sort::Degenerate | Sort::Substance => "unstated",
        };
        let stated = condition.sort.words();
        let words = context.maths.words(condition.text)?;
        html.push_str(&format!(
            "<li class=\"{class}\">{words} <span class=\"tag\">{stated}</span></li>"
        ));
    }
    Ok(html + "</ul>")
}

fn trials(context: &Context<'_>, entry: &Entry) -> Result<String, Fault> {
    if entry.evidence.is_empty() {
        return Ok(String::new());
    }
    // Proofs first: they outrank what is measured.
    let code = |i: usize| context.code.trial(entry.claim.trials.get(i)?);
    let trials = entry.evidence.iter().enumerate();
    let (proofs, others): (Vec<_>, Vec<_>) = trials.partition(|(_, e)| e.route.is_proof());
    let conditional = entry.is_conditional();
    let items: Result<String, Fault> = proofs
        .into_iter()
        .chain(others)
        .map(|(i, e)| trial(context.maths, e, conditional, code(i).as_ref()))
        .collect();
    let Tally { rejected, tried } = entry.tally();
    let variants = match tried {
        0 => String::new(),
        _ => format!(
            "<p>Of {} of the formula, {rejected} are {}.</p>",
            counted(tried, "wrong variant"),
            context.explained("rejected", "variants")
        ),
    };
    Ok(format!(
        "<p class=\"claim-label\">Trials</p><ul class=\"trials\">{}</ul>{}{variants}",
        items?,
        deep::line(context, entry)
    ))
}

fn trial(
    maths: &Maths,
    evidence: &Evidence,
    conditional: bool,
    code: Option<&Place>,
) -> Result<String, Fault> {
    let (class, outcome) = match evidence.outcome() {
        Outcome::Agrees => ("agrees", "agrees"),
        Outcome::Disagrees if evidence.subject == Subject::Outside => {
            ("matters", "disagrees, so the condition matters")
        }
        Outcome::Disagrees => ("disagrees", "disagrees"),
        Outcome::NotANumber => ("open", "gave no number"),
        Outcome::TooFewPoints => ("open", "has too few points"),
    };
    let proved = evidence.proof_words();
    let proof = proved.map_or(String::new(), |_| proof(evidence));
    let reason = match proved {
        Some(_) => String::new(),
        None => format!(" Tolerance: {}.", maths.words(evidence.tolerance.reason)?),
    };
    Ok(format!(
        "<li class=\"{class}\"><p><strong>{route}</strong>, {about}: <span class=\"outcome\">{outcome}</span>. \
         {compared}{code}</p><p class=\"measure\">{measured}{reason}</p>{proof}{samples}</li>",
        route = evidence.route.name(),
        about = evidence.about(conditional),
        outcome = proved.unwrap_or(outcome),
        compared = maths.words(&evidence.comparison())?,
        measured = maths.words(&evidence.measured())?,
        samples = samples(maths, evidence)?,
        code = code.map_or(String::new(), |place| format!(
            " <a class=\"code\" href=\"{}\">Code</a>",
            place.address()
        )),
    ))
}

/// The steps of a proof, behind a fold.
fn proof(evidence: &Evidence) -> String {
    if evidence.steps.is_empty() {
        return String::new();
    }
    let step = |step: &String| format!("<li>{}</li>", plain::set(step));
    let steps: String = evidence.steps.iter().map(step).collect();
    format!(
        "<details class=\"proof\"><summary>The proof, {}</summary><ol>{steps}</ol></details>",
        counted(evidence.steps.len(), "step")
    )
}

/// A few of the compared pairs; of those that disagree, unfolded, the farthest apart too.
fn samples(maths: &Maths, evidence: &Evidence) -> Result<String, Fault> {
    if evidence.samples.is_empty() {
        return Ok(String::new());
    }
    let fails = evidence.outcome() == Outcome::Disagrees;
    let farthest = evidence.farthest.iter();
    let farthest = farthest.filter(|pair| fails && !evidence.samples.contains(pair));
    let mut rows = String::new();
    for sample in evidence.samples.iter().chain(farthest) {
        rows.push_str(&format!(
            "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td></tr>",
            maths.words(&sample.at)?,
            value(sample.stated),
            value(sample.found)
        ));
    }
    let (open, summary) = match fails {
        true => (" open", "Some of the values that disagree"),
        false => ("", "Some of the compared values"),
    };
    Ok(format!(
        "<details class=\"samples\"{open}><summary>{summary}</summary><div class=\"table-wrapper\"><table>\
         <thead><tr><th>at</th><th>stated</th><th>found</th></tr></thead><tbody>{rows}</tbody>\
         </table></div></details>"
    ))
}

/// What the claim depends on, and what depends on it.
fn neighbours(context: &Context<'_>, claim: &Claim) -> Result<String, Fault> {
    let users = context.users(claim.id);
    let mut html = String::new();
    for (word, ids) in [("Depends on", claim.depends_on), ("Used by", &users)] {
        if !ids.is_empty() {
            html.push_str(&format!(
                "<p class=\"neighbours\">{word} {}</p>",
                context.links(ids)?
            ));
        }
    }
    Ok(html)
}

/// Links to the code of both sides, and to where they meet.
fn code(context: &Context<'_>, entry: &Entry) -> String {
    let (code, topic, claim) = (context.code, entry.topic, entry.claim);
    let corrections = claim.correction.and_then(|_| code.corrections(topic));
    let places = [
        ("printed", code.printed(topic, claim)),
        ("corrected", corrections),
        ("motion", code.motion(topic)),
        ("claim", code.row(topic, claim)),
    ];
    let links = places
        .into_iter()
        .filter_map(|(word, place)| Some(format!("{word} {}", place?.link())));
    let links: Vec<_> = links.collect();
    match links.is_empty() {
        true => String::new(),
        false => format!("<p class=\"neighbours\">Code: {}</p>", links.join(", ")),
    }
}

/// The LaTeX, to copy; nothing where the statement has none.
fn source(claim: &Claim) -> String {
    let has_formula = |latex: &&str| is_formula(claim, latex) || latex.contains('$');
    let forms = [Some(claim.latex), claim.correction.map(|c| c.latex)];
    let code: String = forms
        .into_iter()
        .flatten()
        .filter(has_formula)
        .map(|latex| {
            let latex = escape(latex);
            format!("<pre><code class=\"language-text nohighlight\">{latex}</code></pre>")
        })
        .collect();
    if code.is_empty() {
        return code;
    }
    format!("<details class=\"latex\"><summary>LaTeX</summary>{code}</details>")
}
