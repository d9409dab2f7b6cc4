//! The index of values: find a claim by a number.

use super::{
    context::Context,
    error::{Fault, Html},
    table::table,
};
use crate::trials::{Paper, compare::Failure};

fn no_number(failure: Failure) -> Fault {
    format!("no number: {failure}").into()
}

pub(super) fn shown(paper: &Paper, id: &str) -> Html {
    let unknown = || format!("there is no value `{id}`");
    let value = paper.value(id).ok_or_else(unknown)?;
    value.shown().map_err(no_number)
}

fn short(text: &str) -> String {
    let value: f64 = text.parse().unwrap_or(f64::NAN);
    let before = libm::floor(libm::log10(value.abs().max(1e-4))) as i32;
    let decimals = usize::try_from(3 - before).unwrap_or(0);
    let given = text.split_once('.').map_or("", |(_, decimals)| decimals);
    format!("{value:.*}", decimals.min(given.len()))
}

pub(super) fn table_of(context: &Context<'_>) -> Html {
    let paper = context.ledger.paper;
    let mut rows: Vec<(f64, [String; 4])> = Vec::new();
    let mut add = |text: String, meaning: String, claim: &str| -> Result<(), Fault> {
        let number = text.parse().unwrap_or(f64::INFINITY);
        let link = context.link(context.entry(claim)?)?;
        let (known, all) = (short(&text).replace('-', "−"), text.replace('-', "−"));
        rows.push((number, [known, all, meaning, link]));
        Ok(())
    };
    for value in paper.values() {
        let text = value.shown().map_err(no_number)?;
        add(text, context.maths.words(value.meaning)?, value.claim)?;
    }
    for (claim, case) in paper.cases() {
        let numbers = case.numbers().map_err(no_number)?;
        for (text, whose) in numbers.into_iter().zip(["as printed", "in the motion"]) {
            let value: f64 = text.parse().unwrap_or(0.0);
            // Nobody looks a whole number up; and those above need no second row.
            let known = claim.values.iter().filter_map(|v| v.number().ok());
            let known = { known }.any(|v| (v - value).abs() < 1e-4);
            if value.fract() != 0.0 && !known {
                add(text, format!("the case by hand, {whose}"), claim.id)?;
            }
        }
    }
    rows.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let rows = rows.into_iter().map(|(_, row)| row);
    let head = ["Number", "All digits", "What it is", "Claim"];
    Ok(table("values", head, rows))
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn a_number_is_short_as_one_remembers_it() {
        for (all, known) in [
            ("0.5370292721", "0.5370"),
            ("4.603338848752", "4.603"),
            ("85", "85"),
            ("-0.0858", "-0.0858"),
        ] {
            assert_eq!(short(all), known);
        }
    }
}
