//! The ledger as text, for terminals.

use super::{Entry, Ledger, Verdict};
use crate::evidence::Subject;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Widest formula that still gets a column; a longer one is cut with an ellipsis.
const FORMULA: usize = 58;

impl Entry {
    /// The routes of all trials but those outside a condition, in a fixed order, each once.
    pub fn routes(&self) -> String {
        let routes: BTreeSet<_> = self
            .evidence
            .iter()
            .filter(|e| e.subject != Subject::Outside)
            .map(|e| e.route)
            .collect();
        let names: Vec<_> = routes.iter().map(|r| r.name()).collect();
        names.join(" ")
    }
}

impl Ledger {
    /// All claims by section: id, formula, verdict, that it is proved or else the worst disagreement, routes.
    pub fn table(&self) -> String {
        let mut sections: Vec<&str> = self.entries.iter().map(|e| e.claim.section).collect();
        sections.sort_unstable();
        sections.dedup();
        let mut text = String::new();
        for section in sections {
            let _ = writeln!(text, "\nSection {section}");
            for entry in self.entries.iter().filter(|e| e.claim.section == section) {
                // Of a claim that fails, how badly it does is what matters here.
                let fails = entry.judgement.verdict.is_wrong();
                let worst = match entry.worst() {
                    _ if entry.is_proved() && !fails => "proved".to_owned(),
                    Some(e) => format!("{:.0e}", e.worst),
                    None => String::new(),
                };
                let line = format!(
                    "  {:<31} {:<FORMULA$}  {:<35}  {:<9} {}",
                    entry.claim.id,
                    cut(entry.claim.plain),
                    entry.judgement.verdict.words(),
                    worst,
                    entry.routes(),
                );
                let _ = writeln!(text, "{}", line.trim_end());
            }
        }
        text
    }

    /// One line: how many claims got each verdict.
    pub fn summary(&self) -> String {
        let counts = self.counts();
        let proved = self.entries.iter().filter(|e| e.is_proved()).count();
        let part = |v: &Verdict| format!("{} {}", counts[v], v.of_many(counts[v]));
        let parts: Vec<_> = Verdict::ALL
            .iter()
            .filter(|v| counts[v] > 0)
            .map(part)
            .collect();
        format!(
            "{} claims: {}; {proved} proved",
            self.entries.len(),
            parts.join(", ")
        )
    }
}

fn cut(formula: &str) -> String {
    if formula.chars().count() <= FORMULA {
        formula.to_owned()
    } else {
        formula.chars().take(FORMULA - 1).chain(['…']).collect()
    }
}
