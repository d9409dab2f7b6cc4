//! The errata: what stands in the paper and is not so, with what is.

use super::{Entry, Ledger, Verdict};
use serde::Serialize;
use std::fmt::Write;

/// One entry of the errata.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Erratum {
    /// The claim's id.
    pub id: &'static str,
    /// Number of the equation, for a numbered one.
    pub equation: Option<u16>,
    /// Section of the paper.
    pub section: &'static str,
    /// The verdict.
    pub verdict: Verdict,
    /// The statement as printed, in LaTeX.
    pub printed: &'static str,
    /// What is right, in LaTeX.
    pub corrected: &'static str,
    /// The ground of the verdict.
    pub reason: String,
    /// Ids of the claims that depend on this one and fail too.
    pub consequences: Vec<&'static str>,
    /// The statement as printed and what is right, in plain text.
    #[serde(skip)]
    plain: [&'static str; 2],
}

fn fails(entry: &Entry) -> bool {
    matches!(
        entry.judgement.verdict,
        Verdict::Misprint | Verdict::Refuted
    )
}

/// Every misprint and every refuted claim of the ledger, in its order.
pub fn errata(ledger: &Ledger) -> Vec<Erratum> {
    let erratum = |entry: &Entry| {
        let claim = entry.claim;
        let correction = claim.correction?;
        let follows = |e: &&Entry| e.claim.depends_on.contains(&claim.id) && fails(e);
        Some(Erratum {
            id: claim.id,
            equation: claim.equation,
            section: claim.section,
            verdict: entry.judgement.verdict,
            printed: claim.latex,
            corrected: correction.latex,
            reason: entry.judgement.ground.clone(),
            consequences: ledger
                .entries
                .iter()
                .filter(follows)
                .map(|e| e.claim.id)
                .collect(),
            plain: [claim.plain, correction.plain],
        })
    };
    ledger
        .entries
        .iter()
        .filter(|e| fails(e))
        .filter_map(erratum)
        .collect()
}

/// The errata as plain text.
pub fn text(ledger: &Ledger) -> String {
    let mut text = String::new();
    for e in errata(ledger) {
        let [printed, corrected] = e.plain;
        let _ = writeln!(
            text,
            "{} (section {}): {}",
            e.id,
            e.section,
            e.verdict.words()
        );
        let _ = writeln!(
            text,
            "    printed:    {printed}\n    instead:    {corrected}"
        );
        let _ = writeln!(text, "    because it {}", e.reason);
        if !e.consequences.is_empty() {
            let _ = writeln!(text, "    with it fall {}", e.consequences.join(", "));
        }
        text.push('\n');
    }
    text
}

/// The errata as the body of a LaTeX document.
pub fn latex(ledger: &Ledger) -> String {
    let mut text = String::from("\\begin{description}\n");
    for e in errata(ledger) {
        let name = e
            .equation
            .map_or(e.id.to_owned(), |n| format!("Equation ({n})"));
        let set = |statement: &str| match statement.contains('$') {
            true => statement.to_owned(),
            false => format!("$\\displaystyle {statement}$"),
        };
        let _ = writeln!(
            text,
            "\\item[{name}] Section {}. Printed: {}. Instead: {}.",
            e.section,
            set(e.printed),
            set(e.corrected)
        );
    }
    text + "\\end{description}\n"
}
