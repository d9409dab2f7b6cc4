//! The command `find`.

use super::{
    ids::{nearest, numbered},
    ledger::Tried,
    output::{VERSION, complain, csv, json, show},
    screen::screen,
};
use crate::ledger::Entry;
use crate::notation::plain_words;
use crate::numerics::expression::{ExpressionError, expression};
use crate::publishing::{Edition, Failure, Format};
use crate::trials::{
    Paper,
    values::{Form, Match, Value, decimal_of, search},
};
use std::fmt::Write;

/// What is given, which may begin with a minus, unless it is a misspelt option.
pub(super) fn no_option(given: &str) -> Result<String, &'static str> {
    let option = given.starts_with("--");
    (!option)
        .then(|| given.to_owned())
        .ok_or("there is no such option")
}

/// Finds the claims that carry a number, which may be given as an expression, or that speak of words; the exit code is 1 if there
/// is none.
pub(super) fn find(edition: &Edition, given: &str, format: Format) -> Result<u8, Failure> {
    let paper = edition.paper;
    let equation =
        numbered(given.trim()).filter(|_| !given.starts_with(|c: char| c.is_ascii_digit()));
    let equation = equation.and_then(|id| paper.find(&id));
    let number = match decimal_of(given) {
        Ok(number) if equation.is_none() => number,
        Err(why) if equation.is_none() && !is_words(given) => return Err(why.into()),
        _ => return words(edition, given, equation.map(|(_, claim)| claim.id), format),
    };
    let found = search(paper.values(), &number)?;
    match format {
        Format::Text => show(&text(given, &number, &found))?,
        Format::Json => json(&serde_json::json!({
            "version": VERSION,
            "given": given,
            "number": number,
            "matches": found,
        }))?,
        Format::Csv => csv(
            &[
                "name",
                "value",
                "closed",
                "right",
                "first_wrong",
                "claim",
                "meaning",
            ],
            found.iter().map(|m| {
                vec![
                    m.name.to_owned(),
                    m.value.clone(),
                    m.closed.unwrap_or_default().to_owned(),
                    m.right.to_string(),
                    m.first_wrong.map_or(String::new(), |n| n.to_string()),
                    m.claim.to_owned(),
                    plain_words(m.meaning),
                ]
            }),
        )?,
    }
    Ok(u8::from(found.is_empty()))
}

/// Whether a word of it is none of those that numbers are made of.
fn is_words(given: &str) -> bool {
    let parts = given.split(|c: char| !(c.is_alphanumeric() || c == '.'));
    let mut words = parts.filter(|part| part.starts_with(char::is_alphabetic));
    words.any(|word| {
        matches!(
            expression(word, |_| None::<f64>),
            Err(ExpressionError::Word(_))
        )
    })
}

/// All that is said of a claim, in small letters: first its name and title, then the rest, also the words by which the book's
/// search finds it or its topic.
fn said(edition: &Edition, Entry { claim, topic, .. }: &Entry) -> [String; 2] {
    let (paper, stem) = (edition.paper, topic.stem);
    let place = format!("{stem}.html#{stem}\t");
    let aliases = edition.aliases.lines();
    let aliases = aliases.filter(|line| line.starts_with(&place));
    let theorems = paper.known_theorems().of_claim(claim.id);
    let theorems = theorems.iter().map(|(accepted, _)| accepted.name.as_str());
    let conditions = claim.conditions.iter().map(|condition| condition.text);
    let by_hand = claim.by_hand.map(|case| [case.wrong, case.reason]);
    let right = claim.correction.map(|correction| correction.plain);
    let values = claim.values.iter().flat_map(|v| [v.id, v.meaning]);
    let rest = [claim.plain, claim.argument, topic.title, claim.aliases].into_iter();
    let rest = rest
        .chain(right)
        .chain(aliases)
        .chain(conditions)
        .chain(by_hand.into_iter().flatten());
    let rest: Vec<_> = rest.chain(values).chain(theorems).collect();
    [
        format!("{} {} {}", claim.id, claim.name(), claim.title),
        rest.join(" "),
    ]
    .map(|text| plain_words(&text).to_lowercase())
}

/// Finds the claims of which all these words are said, those first that have them in their titles, and before them the equation
/// that is meant.
fn words(
    edition: &Edition,
    given: &str,
    equation: Option<&str>,
    format: Format,
) -> Result<u8, Failure> {
    let lower = given.to_lowercase();
    let wanted: Vec<_> = lower.split_whitespace().collect();
    let tried = Tried::recorded(edition, "`show` tries")?;
    let all = tried.all().into_iter();
    let all: Vec<_> = all.map(|entry| (entry, said(edition, entry))).collect();
    let mut found = Vec::new();
    for (entry, [title, rest]) in &all {
        let has = |word: &&str| title.contains(word) || rest.contains(word);
        if equation == Some(entry.claim.id) {
            found.push((0, *entry));
        } else if wanted.iter().all(|word| title.contains(word)) {
            found.push((1, *entry));
        } else if wanted.iter().all(has) {
            found.push((2, *entry));
        }
    }
    found.sort_by_key(|(rank, _)| *rank);
    let found: Vec<_> = found.into_iter().map(|(_, entry)| entry).collect();
    if found.is_empty() {
        let texts = || all.iter().flat_map(|(_, said)| said);
        let known = || texts().flat_map(|text| text.split(|c: char| !c.is_alphanumeric()));
        let known = || known().filter(|word| word.chars().count() > 3);
        let missing = wanted
            .iter()
            .filter(|word| !texts().any(|text| text.contains(**word)));
        let hints = missing.filter_map(|word| nearest(word, known()));
        let hints: Vec<_> = hints.map(|best| format!("`{best}`")).collect();
        let hint = match &hints[..] {
            [] if wanted.len() > 1 => "fewer words find more".to_owned(),
            [] => format!("`{} list` names all", edition.name),
            hints => format!("did you mean {}?", hints.join(", ")),
        };
        complain(
            edition.name,
            &format!("no claim speaks of `{given}`: {hint}"),
        );
    }
    if format != Format::Text || !found.is_empty() {
        tried.answered(&found, || tried.listed(&found), format)?;
    }
    Ok(u8::from(found.is_empty()))
}

pub(super) fn all(paper: &Paper, format: Format) -> Result<u8, Failure> {
    let row = |value: &Value| -> Result<[String; 5], Failure> {
        Ok([
            value.id.to_owned(),
            value.rounded()?,
            value.closed.unwrap_or_default().to_owned(),
            value.claim.to_owned(),
            plain_words(value.meaning),
        ])
    };
    let rows = paper.values().map(row);
    let rows: Vec<_> = rows.collect::<Result<_, _>>()?;
    let names = ["name", "value", "closed", "claim", "meaning"];
    match format {
        Format::Text => {
            let mut text = String::new();
            for [name, value, closed, claim, meaning] in &rows {
                let closed = written(value, Some(closed.as_str()).filter(|form| !form.is_empty()));
                let _ = writeln!(text, "{name} = {value}{closed}\n    {claim}: {meaning}");
            }
            show(&text)?;
        }
        Format::Json => {
            let object = |row: &[String; 5]| -> serde_json::Map<_, _> {
                let pairs = names.into_iter().zip(row);
                pairs.map(|(k, v)| (k.into(), v.as_str().into())).collect()
            };
            let values: Vec<_> = rows.iter().map(object).collect();
            json(&serde_json::json!({ "version": VERSION, "values": values }))?;
        }
        Format::Csv => csv(&names, rows.into_iter().map(Vec::from))?,
    }
    Ok(0)
}

/// A closed form behind its value, where it is another one.
fn written(value: &str, closed: Option<&str>) -> String {
    let other = closed.filter(|form| *form != value);
    other.map_or(String::new(), |form| format!(" = {form}"))
}

fn text(given: &str, number: &str, found: &[Match]) -> String {
    let mut text = String::new();
    if given != number {
        let _ = writeln!(text, "{given} = {number}");
    }
    if found.is_empty() {
        return format!("{text}no claim carries {number}, nor anything that begins like it");
    }
    let digits = number.split(['e', 'E']).next().unwrap_or(number).chars();
    let count = digits
        .filter(char::is_ascii_digit)
        .skip_while(|c| *c == '0')
        .count();
    for m in found {
        let (value, closed) = (&m.value, written(&m.value, m.closed));
        let meaning = plain_words(m.meaning);
        let _ = writeln!(text, "{} = {value}{closed}  {meaning}", m.name);
        let _ = writeln!(text, "    claim: {}", m.claim);
        let grade = match (m.first_wrong, m.form) {
            (None, Some(Form::Cut)) => {
                "all digits given are right, but cut off: rounded, the last is one more".to_owned()
            }
            (None, _) if m.right == count => "all digits given are right".to_owned(),
            (None, _) => format!(
                "the first {} digits are right; no more are known here",
                m.right
            ),
            (Some(n), _) => format!("{} digits are right, digit {n} is wrong", m.right),
        };
        let grade = screen().grade(m.first_wrong.is_none(), &grade);
        let _ = writeln!(text, "    {grade}\n    {number}");
        if let Some(column) = m.column {
            let _ = writeln!(text, "    {}^", " ".repeat(column));
        }
    }
    text
}
