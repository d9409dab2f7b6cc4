//! The index of values: find a claim by a number.

use super::error::Fault;
use super::fill::Filler;
use super::tables::table;
use crate::claims::by_hand::CASES;
use crate::claims::compare::Failure;
use crate::claims::values::{VALUES, find};

fn no_number(failure: &Failure) -> Fault {
    Fault::Placeholder(format!("no number: {failure}"))
}

/// A number by its short name.
pub(super) fn shown(id: &str) -> Result<String, Fault> {
    let unknown = || Fault::Placeholder(format!("there is no value `{id}`"));
    let value = find(id).ok_or_else(unknown)?;
    value.shown().map_err(|failure| no_number(&failure))
}

/// All numbers by size: those with a name, and those of the cases by hand.
pub(super) fn table_of(filler: &Filler<'_>) -> Result<String, Fault> {
    let mut rows: Vec<(f64, [String; 3])> = Vec::new();
    let mut add = |text: String, meaning: String, claim: &str| -> Result<(), Fault> {
        let number = text.parse().unwrap_or(f64::INFINITY);
        let link = filler.link(filler.entry(claim)?)?;
        rows.push((number, [text.replace('-', "−"), meaning, link]));
        Ok(())
    };
    for value in VALUES {
        let text = value.shown().map_err(|failure| no_number(&failure))?;
        add(text, filler.maths().words(value.meaning)?, value.claim)?;
    }
    for case in &CASES {
        let numbers = case.numbers().map_err(|failure| no_number(&failure))?;
        for (text, whose) in numbers.into_iter().zip(["as printed", "in the motion"]) {
            add(text, format!("the case by hand, {whose}"), case.claim)?;
        }
    }
    rows.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let rows = rows.into_iter().map(|(_, row)| row);
    Ok(table("values", ["Number", "What it is", "Claim"], rows))
}
