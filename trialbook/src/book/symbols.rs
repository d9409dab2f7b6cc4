//! The index of symbols: the paper's, the code's, what they mean and in which units.

use super::context::Context;
use super::error::Fault;
use super::tables::table;
use super::text::escape;
use std::collections::BTreeSet;

/// The table.
pub(super) fn table_of(context: &Context<'_>) -> Result<String, Fault> {
    let maths = context.maths;
    // What two topics have in common is said once.
    let mut said = BTreeSet::new();
    let rows: Result<Vec<_>, Fault> = context
        .edition
        .symbols
        .iter()
        .filter(|symbol| said.insert((symbol.latex, symbol.argument, symbol.meaning, symbol.claim)))
        .map(|symbol| {
            let unit = match symbol.unit {
                "1" => "dimensionless",
                unit => unit,
            };
            Ok([
                maths.inline(symbol.latex)?,
                format!("<code>{}</code>", escape(symbol.argument)),
                maths.words(symbol.meaning)?,
                unit.to_owned(),
                context.link(context.entry(symbol.claim)?)?,
            ])
        })
        .collect();
    let head = ["Paper", "Code", "Meaning", "Units", "First in"];
    Ok(table("symbols", head, rows?))
}
