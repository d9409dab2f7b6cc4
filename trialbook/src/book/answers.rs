//! The field in which one asks for a claim, and what it can answer.

use super::{
    claim_box::statement_in_line,
    context::{Context, verdict},
    error::Html,
    text::sentence,
};
use crate::ledger::Entry;
use crate::notation::plain_words;
use serde::Serialize;

pub(super) const ANSWERS: &str = "answers.js";

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
