//! The register of errata: a row for each, for programs and for the record.

use crate::ledger::Erratum;
use crate::notation::plain_words;
use crate::plotting::{FigureError, Table};
use crate::publishing::Edition;

/// The register as CSV: where each stands, what is printed, what is right, why, the evidence, and the command
/// that tries it again.
///
/// # Errors
/// None: every row has a cell for each column.
pub fn register(edition: &Edition, errata: &[Erratum]) -> Result<String, FigureError> {
    let mut table = Table::new(&[
        "id",
        "section",
        "equation",
        "verdict",
        "printed",
        "corrected",
        "reason",
        "evidence",
        "inherits",
        "check",
    ]);
    for erratum in errata {
        let evidence: Vec<_> = erratum.evidence.iter().map(|e| plain_words(e)).collect();
        let cells = [
            erratum.id.to_owned(),
            erratum.section.to_owned(),
            erratum.equation.map_or(String::new(), |n| n.to_string()),
            erratum.verdict.slug().to_owned(),
            plain_words(&erratum.old),
            plain_words(&erratum.new),
            plain_words(&erratum.reason),
            evidence.join(" "),
            erratum.inherits.join(" "),
            format!("{} verify {}", edition.name, erratum.id),
        ];
        table.row(cells)?;
    }
    Ok(table.into_text())
}
