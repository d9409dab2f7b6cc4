//! The command `find`.

use super::output::{VERSION, csv, json, say};
use crate::claims::Paper;
use crate::claims::values::{Match, search};
use crate::edition::{Failure, Format};
use crate::ledger::plain_words;
use std::fmt::Write;

/// Finds the claims that carry a number.
pub(super) fn find(paper: &Paper, number: &str, format: Format) -> Result<u8, Failure> {
    let found = search(paper.values, number)?;
    match format {
        Format::Text => say(&text(number, &found))?,
        Format::Json => json(&serde_json::json!({
            "version": VERSION,
            "number": number,
            "matches": found,
        }))?,
        Format::Csv => csv(
            &["name", "value", "right", "first_wrong", "claim", "meaning"],
            found.iter().map(|m| {
                vec![
                    m.name.to_owned(),
                    m.value.clone(),
                    m.right.to_string(),
                    m.first_wrong.map_or(String::new(), |n| n.to_string()),
                    m.claim.to_owned(),
                    plain_words(m.meaning),
                ]
            }),
        )?,
    }
    Ok(0)
}

fn text(number: &str, found: &[Match]) -> String {
    if found.is_empty() {
        return format!("no claim carries {number}, nor anything that begins like it");
    }
    let mut text = String::new();
    let digits = number.split(['e', 'E']).next().unwrap_or(number).chars();
    let given = digits
        .filter(char::is_ascii_digit)
        .skip_while(|c| *c == '0')
        .count();
    for m in found {
        let _ = writeln!(text, "{} = {}  {}", m.name, m.value, plain_words(m.meaning));
        let _ = writeln!(text, "    claim: {}", m.claim);
        let grade = match m.first_wrong {
            None if m.right == given => "all digits given are right".to_owned(),
            None => format!(
                "the first {} digits are right; no more are known here",
                m.right
            ),
            Some(n) => format!("{} digits are right, digit {n} is wrong", m.right),
        };
        let _ = writeln!(text, "    {grade}\n    {number}");
        if let Some(column) = m.column {
            let _ = writeln!(text, "    {}^", " ".repeat(column));
        }
    }
    text
}
