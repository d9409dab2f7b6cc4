//! The index of symbols: the paper's, the code's, what they mean and in which units.

use super::error::Fault;
use super::fill::Filler;
use super::tables::table;
use super::text::escape;
use crate::symbols::SYMBOLS;

/// The table.
pub(super) fn table_of(filler: &Filler<'_>) -> Result<String, Fault> {
    let maths = filler.maths();
    let rows: Result<Vec<_>, Fault> = SYMBOLS
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
                filler.link(filler.entry(symbol.claim)?)?,
            ])
        })
        .collect();
    let head = ["Paper", "Code", "Meaning", "Units", "First in"];
    Ok(table("symbols", head, rows?))
}

#[cfg(test)]
mod tests {
    use super::SYMBOLS;
    use crate::book::code::Code;

    #[test]
    fn every_name_stands_in_the_code() {
        let code = Code::new();
        for symbol in SYMBOLS {
            assert!(code.names(symbol.argument), "no `{}`", symbol.argument);
        }
    }
}
