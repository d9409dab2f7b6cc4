//! The command `find`.

use super::{
    output::{VERSION, csv, json, show},
    screen::screen,
};
use crate::notation::plain_words;
use crate::publishing::{Failure, Format};
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

/// Finds the claims that carry a number, which may be given as an expression; the exit code is 1 if there is none.
pub(super) fn find(paper: &Paper, given: &str, format: Format) -> Result<u8, Failure> {
    let number = decimal_of(given)?;
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
