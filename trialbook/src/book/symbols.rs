//! The index of symbols: the paper's, the code's, what they mean and in which units.

use super::{context::Context, error::Html, table::tried, text::in_code};
use std::collections::BTreeSet;

pub(super) fn table_of(context: &Context<'_>) -> Html {
    let maths = context.maths;
    // What two topics have in common is said once.
    let mut said = BTreeSet::new();
    let symbols = context.edition.symbols.iter();
    let symbols = symbols.filter(|symbol| {
        said.insert((symbol.latex, symbol.argument, symbol.meaning, symbol.claim))
    });
    let rows = symbols.map(|symbol| {
        let unit = match symbol.unit {
            "1" => "dimensionless",
            unit => unit,
        };
        Ok([
            maths.inline(symbol.latex)?,
            in_code(symbol.argument),
            maths.words(symbol.meaning)?,
            unit.to_owned(),
            context.links(&[symbol.claim])?,
        ])
    });
    let head = ["Paper", "Code", "Meaning", "Units", "First in"];
    tried("symbols", head, rows)
}
