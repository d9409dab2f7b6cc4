//! The index of symbols: the paper's, the code's, what they mean and in which units.

use super::context::Context;
use super::error::Fault;
use super::tables::table;
use super::text::escape;

/// The table.
pub(super) fn table_of(context: &Context<'_>) -> Result<String, Fault> {
    let maths = context.maths;
    let rows: Result<Vec<_>, Fault> = context
        .edition
        .symbols
        .iter()
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
