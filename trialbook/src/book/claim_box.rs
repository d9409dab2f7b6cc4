//! The box that shows one claim: what the paper says, the verdict, and all that it rests on.

use super::{
    code::Place,
    context::{Context, verdict},
    deep,
    error::{Fault, Html},
    formula_diff, lemmas,
    maths::Maths,
    text::{counted, escape, sentence, value},
    theorems,
};
use crate::evidence::{Change, Evidence, Kind, Outcome, Subject};
use crate::ledger::{Entry, Tally};
use crate::trials::{Claim, Sort};

pub(super) fn claim_box(context: &Context<'_>, entry: &Entry) -> Html {
    let (claim, judgement, maths) = (entry.claim, &entry.judgement, context.maths);
    let wrong = entry.in_short().map(|words| maths.words(&words));
    let wrong = wrong.transpose()?.map_or(String::new(), |words| {
        format!("<p class=\"claim-verdict\"><strong>{words}</strong></p>")
    });
    let ground = maths.words(&format!("It {}.", judgement.ground))?;
    let words = ground.split(' ').map(|word| {
        let id = word.trim_end_matches([',', '.']);
        match context.entry(id) {
            Ok(other) => Ok(word.replacen(id, &context.link(other)?, 1)),
            Err(_) => Ok(word.to_owned()),
        }
    });
    let ground = words.collect::<Result<Vec<_>, Fault>>()?.join(" ");
    Ok(format!(
        "<article class=\"claim {slug}\" aria-labelledby=\"{id}\"><div class=\"claim-head\">\
         <h3 id=\"{id}\" class=\"claim-title\"><a class=\"header\" href=\"#{id}\">{heading}</a></h3>{verdict}</div>\
         {was}{wrong}{stated}<details class=\"evidence\" id=\"{id}-evidence\"><summary>{given}{brief}</summary>\
         <p class=\"claim-place\">Section {section}, {kind} <a class=\"permalink\" href=\"#{id}\">#{id}</a></p>\
         <p class=\"claim-ground\">{ground}</p>{behind}</details></article>\n",
        slug = judgement.verdict.slug(),
        was = was(claim),
        id = claim.id,
        heading = maths.words(&heading(claim))?,
        verdict = verdict(judgement.verdict),
        stated = ours(claim) + &statements(context, entry)?,
        given = given(context, claim)?,
        brief = maths.words(&sentence(&entry.brief()))?,
        section = escape(claim.section),
        kind = claim.kind_name(),
        behind = [
            theorems::of_claim(context, entry)?,
            unconditional(context, entry)?,
            conditions(context, claim)?,
            argument(context, claim)?,
            trials(context, entry)?,
            neighbours(context, claim)?,
            code(context, entry),
            source(claim),
        ]
        .concat(),
    ))
}

fn was(claim: &Claim) -> String {
    let anchor = |id: &&str| format!("<span id=\"{}\"></span>", escape(id));
    claim.was.iter().map(anchor).collect()
}

fn ours(claim: &Claim) -> String {
    match claim.ours {
        true => "<p class=\"claim-label\">Derived here, not printed</p>".to_owned(),
        false => String::new(),
    }
}

/// `(11) Speed as a function of direction`, `The paper's Figure 1: Portraits of the velocity`.
pub(super) fn heading(claim: &Claim) -> String {
    let label = claim.name();
    let title = sentence(claim.title);
    match claim.kind {
        _ if title.is_empty() => label,
        Kind::Figure => format!("The paper's {label}: {title}"),
        _ if label == claim.title => title,
        _ => format!("{label} {title}"),
    }
}

pub(super) fn statement(context: &Context<'_>, claim: &Claim, latex: &str) -> Html {
    if is_formula(claim, latex) {
        let formula = context.maths.display(latex)?;
        Ok(format!("<div class=\"claim-formula\">{formula}</div>"))
    } else {
        let words = context.maths.words(latex)?;
        Ok(format!("<p class=\"claim-words\">{words}</p>"))
    }
}

pub(super) fn statement_in_line(context: &Context<'_>, claim: &Claim) -> Html {
    if is_formula(claim, claim.latex) {
        context.maths.inline(claim.latex)
    } else {
        context.maths.words(claim.latex)
    }
}

/// A numbered claim is a formula unless formulas stand within it.
fn is_formula(claim: &Claim, latex: &str) -> bool {
    claim.equation.is_some() && !latex.contains('$')
}

fn statements(context: &Context<'_>, entry: &Entry) -> Html {
    let claim = entry.claim;
    let fails = entry.judgement.verdict.is_wrong();
    let Some(correction) = claim.correction.filter(|_| fails) else {
        return Ok(statement(context, claim, claim.latex)? + &by_hand(context, entry)?);
    };
    let changed = match correction.change {
        Change::Sign => " (changed: a sign)",
        Change::Factor => " (changed: a factor)",
        Change::Symbol => " (changed: a symbol)",
        Change::Statement => "",
    };
    let [old, new] = forms(context, claim, correction.latex)?;
    Ok(format!(
        "<div class=\"{}\">\
         <div class=\"printed\"><p class=\"claim-label\">As printed</p>{old}</div>\
         <div class=\"corrected\"><p class=\"claim-label\">As corrected{changed}</p>{new}</div>\
         </div>{}",
        side_by_side([&old, &new]),
        by_hand(context, entry)?
    ))
}

/// Words take as much room as there is, many words more of it than few.
pub(super) fn side_by_side([old, new]: [&String; 2]) -> &'static str {
    let words = |form: &String| form.contains("<p class=\"claim-words\"");
    match words(old) || words(new) {
        true if new.len() > 3 * old.len() => "claim-forms worded long",
        true => "claim-forms worded",
        false => "claim-forms",
    }
}

pub(super) fn forms(
    context: &Context<'_>,
    claim: &Claim,
    corrected: &str,
) -> Result<[String; 2], Fault> {
    let both = [claim.latex, corrected];
    if !both.iter().all(|latex| is_formula(claim, latex)) {
        let [old, new] = both.map(|latex| statement(context, claim, latex));
        return Ok([old?, new?]);
    }
    let (corrected, words) = apart(corrected);
    let leading = leading(corrected);
    let [old, new] = formula_diff::marked(claim.latex, leading.unwrap_or(corrected));
    let mut new = statement(context, claim, &new)?;
    if leading.is_some() {
        let next = statement(context, claim, corrected)?;
        new += &format!("<p class=\"claim-label\">To the next order</p>{next}");
    }
    if let Some(words) = words {
        let words = context.maths.words(words)?;
        new += &format!("<p class=\"claim-words\">{words}</p>");
    }
    Ok([statement(context, claim, &old)?, new])
}

/// The words behind a formula may be too long for its line.
fn apart(latex: &str) -> (&str, Option<&str>) {
    let parts = latex.strip_suffix('}');
    match parts.and_then(|latex| latex.split_once(r"\quad\text{")) {
        Some((formula, words)) if !words.contains(['{', '}']) => (formula, Some(words)),
        _ => (latex, None),
    }
}

/// An asymptotic law with the bracket behind it, `\left[1-…\right]`, taken for 1: against that the printed
/// law is held.
fn leading(latex: &str) -> Option<&str> {
    let (leading, bracket) = latex.split_once(r"\left[1")?;
    bracket.ends_with(r"\cdots\right]").then_some(leading)
}

/// A form that is regular where the printed one is not: nothing is corrected by it.
fn unconditional(context: &Context<'_>, entry: &Entry) -> Html {
    let conditional = entry.judgement.verdict.has_condition();
    let Some(form) = entry.claim.correction.filter(|_| conditional) else {
        return Ok(String::new());
    };
    let form = statement(context, entry.claim, form.latex)?;
    Ok(format!("<p class=\"claim-label\">A regular form</p>{form}"))
}

fn by_hand(context: &Context<'_>, entry: &Entry) -> Html {
    let fails = entry.judgement.verdict.is_wrong();
    let Some(case) = entry.claim.by_hand.filter(|_| fails) else {
        return Ok(String::new());
    };
    Ok(format!(
        "<div class=\"by-hand\"><p><strong>Why:</strong> {}.</p><p><strong>By hand:</strong> {}.{}</p></div>",
        context.maths.words(&sentence(case.reason))?,
        context.maths.words(&sentence(&case.words()?))?,
        context.watch(entry.claim)
    ))
}

fn given(context: &Context<'_>, claim: &Claim) -> Html {
    let stated = claim.conditions.iter().filter(|c| c.sort == Sort::Stated);
    let stated: Result<Vec<_>, _> = stated.map(|c| context.maths.words(c.text)).collect();
    Ok(match stated?.join("; ") {
        none if none.is_empty() => none,
        stated => format!("Stated: {stated}. "),
    })
}

fn conditions(context: &Context<'_>, claim: &Claim) -> Html {
    if claim.conditions.is_empty() {
        return Ok(String::new());
    }
    let mut html = String::from("<p class=\"claim-label\">Conditions</p><ul class=\"conditions\">");
    for condition in claim.conditions {
        let class = match condition.sort {
            Sort::Stated => "stated",
            Sort::Degenerate | Sort::Convention | Sort::Substance => "unstated",
            Sort::Reading | Sort::Remark => "ours",
        };
        let stated = condition.sort.words(claim.ours);
        let words = context.maths.words(condition.text)?;
        html += &format!("<li class=\"{class}\">{words} <span class=\"tag\">{stated}</span></li>");
    }
    Ok(html + "</ul>")
}

fn linked(context: &Context<'_>, words: &str) -> Html {
    let mut parts = words.split('“');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (title, after) = part.split_once('”').unwrap_or((part, ""));
        let mut entries = context.ledger.entries.iter();
        let entry = entries.find(|entry| entry.claim.title == title);
        let none = || format!("no claim has the title “{title}”");
        out += &(context.link(entry.ok_or_else(none)?)? + after);
    }
    Ok(out)
}

fn argument(context: &Context<'_>, claim: &Claim) -> Html {
    if claim.argument.is_empty() {
        return Ok(String::new());
    }
    let words = linked(context, &context.maths.words(claim.argument)?)?;
    Ok(format!(
        "<p class=\"argument\"><strong>Why what is checked is enough:</strong> {words}</p>"
    ))
}

fn trials(context: &Context<'_>, entry: &Entry) -> Html {
    if entry.evidence.is_empty() {
        return Ok(String::new());
    }
    // Proofs first: they outrank what is measured.
    let code = |i: usize| context.code.trial(entry.claim.trials.get(i)?);
    let trials = entry.evidence.iter().enumerate();
    let (proofs, others): (Vec<_>, Vec<_>) = trials.partition(|(_, e)| e.route.is_proof());
    let (conditional, ours) = (entry.is_conditional(), entry.claim.ours);
    let above = |i: usize| {
        proofs
            .iter()
            .filter(move |(k, _)| *k < i)
            .map(|(_, e)| e.steps.as_slice())
    };
    let items = proofs.iter().chain(&others).map(|(i, e)| {
        trial(
            context,
            e,
            above(*i),
            [conditional, ours],
            code(*i).as_ref(),
        )
    });
    let items = items.collect::<Html>()?;
    let Tally { rejected, tried } = entry.tally();
    let variants = match tried {
        0 => String::new(),
        _ => format!(
            "<p>Of {} of the formula, {rejected} are {}.{}</p>",
            counted(tried, "wrong variant"),
            context.explained("rejected", "variants"),
            context.breaks(entry.claim.id)
        ),
    };
    Ok(format!(
        "<p class=\"claim-label\">Trials</p><ul class=\"trials\">{items}</ul>{}{variants}",
        deep::line(context, entry)
    ))
}

fn trial<'a>(
    context: &Context<'_>,
    evidence: &Evidence,
    above: impl Iterator<Item = &'a [String]>,
    [conditional, ours]: [bool; 2],
    code: Option<&Place>,
) -> Html {
    let maths = context.maths;
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
    let (mut proof, mut reason) = (String::new(), String::new());
    if proved.is_none() {
        reason = format!(" Tolerance: {}.", maths.words(evidence.tolerance.reason)?);
    } else if !evidence.steps.is_empty() {
        proof = lemmas::steps(context, &evidence.steps, above)?;
    }
    Ok(format!(
        "<li class=\"{class}\"><p><strong>{route}</strong>, {about}: <span class=\"outcome\">{outcome}</span>. \
         {compared}{code}</p><p class=\"measure\">{measured}{reason}</p>{proof}{samples}</li>",
        route = evidence.route.name(),
        about = evidence.about(conditional, ours),
        outcome = proved.unwrap_or(outcome),
        compared = maths.words(&evidence.comparison())?,
        measured = maths.folded(&evidence.measured())?,
        samples = samples(maths, evidence)?,
        code = code.map_or(String::new(), |place| format!(
            " <a class=\"code\" href=\"{}\">Code</a>",
            place.address()
        )),
    ))
}

fn samples(maths: &Maths, evidence: &Evidence) -> Html {
    if evidence.samples.is_empty() {
        return Ok(String::new());
    }
    let fails = evidence.outcome() == Outcome::Disagrees;
    let farthest = evidence.farthest.iter();
    let farthest = farthest.filter(|pair| fails && !evidence.samples.contains(pair));
    let mut rows = String::new();
    for sample in evidence.samples.iter().chain(farthest) {
        rows += &format!(
            "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td></tr>",
            maths.folded(&sample.at)?,
            value(sample.stated),
            value(sample.found)
        );
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

fn neighbours(context: &Context<'_>, claim: &Claim) -> Html {
    Ok(context.neighbours("Depends on", claim.depends_on)?
        + &context.neighbours("Used by", &context.users(claim.id))?)
}

fn code(context: &Context<'_>, entry: &Entry) -> String {
    let (code, topic, claim) = (context.code, entry.topic, entry.claim);
    let corrections = claim.correction.and_then(|_| code.corrections(topic));
    let places = [
        ("printed", code.printed(topic, claim)),
        ("corrected", corrections),
        ("motion", code.motion(topic)),
        ("claim", code.entry(topic, claim)),
    ];
    let link = |(word, place): (_, Option<Place>)| Some(format!("{word} {}", place?.link()));
    let links: Vec<_> = places.into_iter().filter_map(link).collect();
    match links.is_empty() {
        true => String::new(),
        false => format!("<p class=\"neighbours\">Code: {}</p>", links.join(", ")),
    }
}

fn source(claim: &Claim) -> String {
    let has_formula = |latex: &&str| is_formula(claim, latex) || latex.contains('$');
    let forms = [Some(claim.latex), claim.correction.map(|c| c.latex)];
    let block = |latex| {
        let latex = escape(latex);
        format!("<pre><code class=\"language-text nohighlight\">{latex}</code></pre>")
    };
    let forms = forms.into_iter().flatten().filter(has_formula);
    let code: String = forms.map(block).collect();
    if code.is_empty() {
        return code;
    }
    format!("<details class=\"latex\"><summary>LaTeX</summary>{code}</details>")
}
