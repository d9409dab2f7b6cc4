//! Mistakes that are seeded in the formulas, and which trial notices which.

use super::output::{VERSION, csv, json, say};
use crate::claims::variants::Variant;
use crate::edition::{Edition, Failure, Format};
use crate::ledger::Ledger;
use crate::ledger::distrust::{Extent, Tried};
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::fmt::Write;

/// All mistakes, and what each trial does with those that it can meet.
#[derive(Serialize)]
struct Matrix<'a> {
    version: u32,
    mistakes: Vec<MistakeRow<'a>>,
    trials: Vec<TrialRow<'a>>,
}

/// A formula with a mistake.
#[derive(Serialize)]
struct MistakeRow<'a> {
    claim: &'a str,
    formula: &'a str,
    text: &'a str,
}

/// A trial, with the numbers of the mistakes that it rejects and of those that it lets pass.
#[derive(Serialize)]
struct TrialRow<'a> {
    claim: &'a str,
    trial: &'a str,
    agrees: bool,
    rejects: Vec<usize>,
    passes: Vec<usize>,
    /// Why it need not reject any.
    #[serde(skip_serializing_if = "Option::is_none")]
    excuse: Option<&'a str>,
    /// The first mistake that changes what it finds; there is to be none.
    #[serde(skip_serializing_if = "Option::is_none")]
    leans_on: Option<usize>,
}

impl TrialRow<'_> {
    /// True if it notices nothing and nobody says why, or if what it finds rests on a formula.
    fn is_at_fault(&self) -> bool {
        self.leans_on.is_some() || self.agrees && self.rejects.is_empty() && self.excuse.is_none()
    }
}

/// Tries the trials of these claims, or of all, on every mistake.
pub(super) fn distrust(edition: &Edition, ids: &[&str], format: Format) -> Result<u8, Failure> {
    let paper = edition.paper;
    let ledger = match ids {
        [] => Ledger::try_all(paper, |_| {}),
        ids => Ledger::try_some(paper, ids, |_| {}),
    };
    let variants = paper.formulas.variants();
    let trials: usize = ledger.entries.iter().map(|e| e.evidence.len()).sum();
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} trials  {eta} left");
    let bar = ProgressBar::new(trials as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let tried = ledger.distrust(&variants, Extent::Every, || bar.inc(1));
    bar.finish_and_clear();
    let rows: Vec<_> = tried.iter().map(|tried| row(&ledger, tried)).collect();
    let code = u8::from(rows.iter().any(TrialRow::is_at_fault));
    match format {
        Format::Text => say(&text(&rows, &variants))?,
        Format::Json => json(&Matrix {
            version: VERSION,
            mistakes: variants.iter().map(mistake).collect(),
            trials: rows,
        })?,
        Format::Csv => {
            let headers = ["claim", "trial", "agrees", "rejects", "passes", "leans"];
            let cells = |row: &TrialRow<'_>| {
                vec![
                    row.claim.to_owned(),
                    row.trial.to_owned(),
                    u8::from(row.agrees).to_string(),
                    row.rejects.len().to_string(),
                    row.passes.len().to_string(),
                    u8::from(row.leans_on.is_some()).to_string(),
                ]
            };
            csv(&headers, rows.iter().map(cells))?;
        }
    }
    Ok(code)
}

fn mistake(variant: &Variant) -> MistakeRow<'_> {
    MistakeRow {
        claim: &variant.claim,
        formula: variant.formula,
        text: &variant.text,
    }
}

fn row<'a>(ledger: &'a Ledger, tried: &Tried) -> TrialRow<'a> {
    let entry = &ledger.entries[tried.entry];
    let evidence = &entry.evidence[tried.trial];
    let those = |rejects: bool| {
        let of = tried.reactions.iter().filter(|(_, r)| r.rejects == rejects);
        of.map(|(variant, _)| *variant).collect()
    };
    let mut idle = ledger.paper.idle.iter();
    TrialRow {
        claim: entry.claim.id,
        trial: evidence.trial,
        agrees: tried.agrees,
        rejects: those(true),
        passes: those(false),
        excuse: idle
            .find(|idle| idle.claim == entry.claim.id && idle.trial == evidence.trial)
            .map(|idle| idle.reason),
        leans_on: tried.leans_on(),
    }
}

fn text(rows: &[TrialRow<'_>], variants: &[Variant]) -> String {
    let mut text = String::new();
    for row in rows {
        let all = row.rejects.len() + row.passes.len();
        let note = match (row.leans_on, row.excuse) {
            (Some(variant), _) => format!("  LEANS on {}", variants[variant].formula),
            (None, Some(reason)) => format!("  {reason}"),
            _ if row.is_at_fault() => "  NOTICES NOTHING".to_owned(),
            _ => String::new(),
        };
        // Nothing can fail in writing to a string.
        let _ = writeln!(
            text,
            "{:<28} {:<34} {:>4} of {all:<4}{note}",
            row.claim,
            row.trial,
            row.rejects.len()
        );
    }
    let agree = rows.iter().filter(|row| row.agrees);
    let idle = agree.clone().filter(|row| row.rejects.is_empty()).count();
    let rejected: usize = rows.iter().map(|row| row.rejects.len()).sum();
    let put: usize = rows.iter().map(|row| row.passes.len()).sum::<usize>() + rejected;
    let faults = rows.iter().filter(|row| row.is_at_fault()).count();
    let _ = writeln!(
        text,
        "\n{put} mistakes put to {} trials, {rejected} noticed; of the {} that agree all but {idle} notice one at \
         least; {faults} at fault",
        rows.len(),
        agree.count()
    );
    text
}
