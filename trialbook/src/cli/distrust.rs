//! Mistakes that are seeded in the formulas, and which trial notices which.

use super::{
    output::{VERSION, complain, csv, json, say},
    screen::progress,
};
use crate::ledger::{
    Ledger,
    distrust::{Extent, Tried},
    sensitivity::Slight,
};
use crate::publishing::{Edition, Failure, Format};
use crate::stop;
use crate::trials::{Paper, variants::Variant};
use serde::Serialize;
use std::fmt::Write;

/// All mistakes, and what each trial does with those that it can meet.
#[derive(Serialize)]
struct Matrix<'a> {
    version: u32,
    mistakes: Vec<MistakeRow<'a>>,
    trials: Vec<TrialRow<'a>>,
    slight: Vec<SlightRow<'a>>,
    corners: Vec<CornerRow<'a>>,
}

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
    excuse: Option<&'a str>,
    /// The first mistake that changes what it finds or in what units it compares; there is to be none.
    leans_on: Option<usize>,
}

/// A measurement, and whether it notices that a formula of its claim is wrong by twice its tolerance.
#[derive(Serialize)]
struct SlightRow<'a> {
    claim: &'a str,
    trial: &'a str,
    formula: &'a str,
    noticed: bool,
    excuse: Option<&'static str>,
}

/// A formula that is wrong in a corner, and whether a measurement of its claim notices; null if none reads it.
#[derive(Serialize)]
struct CornerRow<'a> {
    claim: &'a str,
    text: &'a str,
    noticed: Option<bool>,
    excuse: Option<&'static str>,
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
    stop::listen()?;
    let ledger = match ids {
        [] => Ledger::try_all(paper, |_| {}),
        ids => Ledger::try_some(paper, ids, |_| {}),
    };
    let variants = paper.formulas.variants();
    let trials: usize = ledger.entries.iter().map(|e| e.evidence.len()).sum();
    let bar = progress(trials as u64, "{bar:40} {pos}/{len} trials  {eta} left");
    let tried = ledger.distrust(&variants, Extent::Every, || bar.inc(1));
    bar.finish_and_clear();
    let rows: Vec<_> = tried.iter().map(|tried| row(&ledger, tried)).collect();
    let slight = ledger.slight();
    let slight: Vec<_> = slight.iter().map(|s| slight_row(&ledger, s)).collect();
    let mut corners = paper.corners();
    corners.retain(|variant| ledger.entry(&variant.claim).is_some());
    let noticed = ledger.noticed(&corners);
    let pairs = corners.iter().zip(noticed);
    let corners: Vec<_> = pairs
        .map(|(v, noticed)| corner_row(paper, v, noticed))
        .collect();
    if stop::is_asked() {
        complain(edition.name, "stopped: nothing is known of all trials");
        return Ok(stop::STOPPED);
    }
    let code = code(&rows, &slight, &corners);
    match format {
        Format::Text => {
            say(&text(&rows, &variants))?;
            say(&small(&slight, &corners))?;
        }
        Format::Json => json(&Matrix {
            version: VERSION,
            mistakes: variants.iter().map(mistake).collect(),
            trials: rows,
            slight,
            corners,
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

/// The exit code: 1 if a trial is at fault, or if nobody says why a slight mistake or one in a corner is not noticed.
fn code(rows: &[TrialRow<'_>], slight: &[SlightRow<'_>], corners: &[CornerRow<'_>]) -> u8 {
    let coarse = |row: &SlightRow<'_>| !row.noticed && row.excuse.is_none();
    let cut = |row: &CornerRow<'_>| row.noticed != Some(true) && row.excuse.is_none();
    let at_fault = rows.iter().any(TrialRow::is_at_fault);
    u8::from(at_fault || slight.iter().any(coarse) || corners.iter().any(cut))
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
    TrialRow {
        claim: entry.claim.id,
        trial: evidence.trial,
        agrees: tried.agrees,
        rejects: those(true),
        passes: those(false),
        excuse: entry.claim.trials[tried.trial].idle,
        leans_on: tried.leans_on(),
    }
}

fn slight_row<'a>(ledger: &'a Ledger, slight: &Slight) -> SlightRow<'a> {
    let entry = &ledger.entries[slight.entry];
    let mut coarse = entry.claim.trials[slight.trial].coarse.iter();
    let excuse = coarse.find(|excuse| excuse.of == slight.formula);
    SlightRow {
        claim: entry.claim.id,
        trial: entry.evidence[slight.trial].trial,
        formula: slight.formula,
        noticed: slight.noticed,
        excuse: excuse.map(|excuse| excuse.why),
    }
}

fn corner_row<'a>(paper: &Paper, variant: &'a Variant, noticed: Option<bool>) -> CornerRow<'a> {
    let (claim, text) = (variant.claim.as_str(), variant.text.as_str());
    let excuses = paper.find(claim).map(|(_, claim)| match noticed {
        Some(_) => (claim.cornered, text),
        None => (claim.unread, variant.formula),
    });
    let excuse = excuses.and_then(|(excuses, of)| excuses.iter().find(|excuse| excuse.of == of));
    CornerRow {
        claim,
        text,
        noticed,
        excuse: excuse.map(|excuse| excuse.why),
    }
}

/// What became of the slight mistakes: those that are not noticed, and how many are.
fn small(slight: &[SlightRow<'_>], corners: &[CornerRow<'_>]) -> String {
    let mut text = String::new();
    let why = |excuse: Option<&'static str>| excuse.unwrap_or("NOT NOTICED");
    for row in slight.iter().filter(|row| !row.noticed) {
        let _ = writeln!(
            text,
            "{:<28} {:<34} {}  {}",
            row.claim,
            row.trial,
            row.formula,
            why(row.excuse)
        );
    }
    for row in corners.iter().filter(|row| row.noticed != Some(true)) {
        let reason = match row.noticed {
            None => row.excuse.unwrap_or("NOT MEASURED"),
            Some(_) => why(row.excuse),
        };
        let _ = writeln!(text, "{:<28} {}  {reason}", row.claim, row.text);
    }
    let noticed = slight.iter().filter(|row| row.noticed).count();
    let cut = corners
        .iter()
        .filter(|row| row.noticed == Some(true))
        .count();
    let _ = writeln!(
        text,
        "\nof {} mistakes of twice the tolerance {noticed} noticed, of {} in a corner {cut}",
        slight.len(),
        corners.len()
    );
    text
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mistake_that_passes_without_a_reason_is_a_failure() {
        let (claim, trial, formula, text) = ("", "", "", "");
        let why = Some("a reason");
        let row = |agrees, rejects: &[usize], excuse, leans_on| TrialRow {
            claim,
            trial,
            agrees,
            rejects: rejects.to_vec(),
            passes: vec![7],
            excuse,
            leans_on,
        };
        for (row, expected) in [
            (row(true, &[3], None, None), 0),
            (row(true, &[], None, None), 1),
            (row(true, &[], why, None), 0),
            (row(false, &[], None, None), 0),
            (row(true, &[3], None, Some(3)), 1),
            (row(true, &[], why, Some(3)), 1),
        ] {
            assert_eq!(code(&[row], &[], &[]), expected);
        }
        for (noticed, excuse, expected) in [(true, None, 0), (false, None, 1), (false, why, 0)] {
            let slight = SlightRow {
                claim,
                trial,
                formula,
                noticed,
                excuse,
            };
            assert_eq!(code(&[], &[slight], &[]), expected);
            // Whether nobody notices it or nobody measures there.
            let corners = match noticed {
                true => vec![Some(true)],
                false => vec![Some(false), None],
            };
            for noticed in corners {
                let corner = CornerRow {
                    claim,
                    text,
                    noticed,
                    excuse,
                };
                assert_eq!(code(&[], &[], &[corner]), expected);
            }
        }
    }

    #[test]
    fn small_mistakes_are_counted_by_what_became_of_them() {
        let (claim, trial, formula, text) = ("c", "t", "f", "x");
        let slight = |noticed, excuse| SlightRow {
            claim,
            trial,
            formula,
            noticed,
            excuse,
        };
        let corner = |noticed, excuse| CornerRow {
            claim,
            text,
            noticed,
            excuse,
        };
        let why = Some("a reason");
        let said = small(
            &[slight(true, None), slight(false, why), slight(false, None)],
            &[
                corner(Some(true), None),
                corner(Some(true), None),
                corner(Some(false), why),
                corner(None, None),
            ],
        );
        let last = "of 3 mistakes of twice the tolerance 1 noticed, of 4 in a corner 2";
        assert_eq!(said.lines().last(), Some(last), "{said}");
        assert_eq!(said.matches("a reason").count(), 2, "{said}");
        assert_eq!(said.matches("NOT NOTICED").count(), 1, "{said}");
        assert_eq!(said.matches("NOT MEASURED").count(), 1, "{said}");
    }
}
