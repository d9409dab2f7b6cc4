//! The theorems: what the kernel has accepted, and what goes to it and comes back.

use super::output::{VERSION, csv, json, say};
use crate::publishing::{Edition, Failure, Format};
use crate::theorems::record::{self, Accepted};
use crate::theorems::{Known, formulas};
use crate::trials::Claim;

use clap::Args;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// What is wanted in place of the list.
#[derive(Args)]
#[group(multiple = false)]
pub(super) struct Wanted {
    /// Print the formulas as definitions of Rocq, all of them
    #[arg(long, conflicts_with = "ids")]
    formulas: bool,
    /// Print a file that asks coqc for all statements
    #[arg(long, conflicts_with = "ids")]
    questions: bool,
    /// Print the record, by what coqc answered and by the FILE.timing beside the sources in that folder
    #[arg(long, value_name = "FOLDER", conflicts_with = "ids")]
    answers: Option<PathBuf>,
}

#[derive(Serialize)]
struct List<'a> {
    version: u32,
    theorems: Vec<Row<'a>>,
}

#[derive(Serialize)]
struct Row<'a> {
    claim: &'static str,
    #[serde(flatten)]
    theorem: &'a Accepted,
}

/// Answers for these claims, or for all.
pub(super) fn theorems(
    edition: &Edition,
    ids: &[&str],
    wanted: &Wanted,
    format: Format,
) -> Result<u8, Failure> {
    let paper = edition.paper;
    let known = paper.known_theorems();
    if wanted.formulas {
        let trees = (paper.formulas.trees)();
        say(&formulas::definitions(&trees, paper.formulas.corrections))?;
    } else if wanted.questions {
        say(&record::questions(
            &known.sources,
            &known.wanted(paper),
            &known.record,
        ))?;
    } else if let Some(folder) = &wanted.answers {
        say(&made(known, folder)?)?;
    } else {
        let claims = paper.claims().map(|(_, claim)| claim);
        let claims: Vec<_> = claims
            .filter(|claim| ids.is_empty() || ids.contains(&claim.id))
            .collect();
        list(known, &claims, !ids.is_empty(), format)?;
    }
    Ok(0)
}

fn made(known: &Known, folder: &Path) -> Result<String, Failure> {
    let answers = fs::read_to_string(folder.join("answers.txt"))?;
    let files = known.sources.items.iter().map(|item| &item.file);
    let times = files.filter_map(|file| {
        let times = fs::read_to_string(folder.join(format!("{file}.timing"))).ok()?;
        Some((file.clone(), times))
    });
    let times: BTreeMap<_, _> = times.collect();
    let all = record::made(&known.sources, &answers, &times, &known.record)?;
    Ok(all.iter().map(ToString::to_string).collect())
}

fn list(
    known: &Known,
    claims: &[&'static Claim],
    whole: bool,
    format: Format,
) -> Result<(), Failure> {
    let ids = claims.iter().map(|claim| claim.id);
    let rows: Vec<_> = ids
        .flat_map(|id| {
            known
                .of_claim(id)
                .into_iter()
                .map(move |(accepted, _)| (id, accepted))
        })
        .collect();
    match format {
        Format::Json => json(&List {
            version: VERSION,
            theorems: rows
                .iter()
                .copied()
                .map(|(claim, theorem)| Row { claim, theorem })
                .collect(),
        }),
        Format::Csv => csv(
            &[
                "claim",
                "theorem",
                "file",
                "speaks",
                "occurs",
                "axioms",
                "seconds",
                "statement",
            ],
            rows.iter().copied().map(|(claim, a)| {
                vec![
                    claim.to_owned(),
                    a.name.clone(),
                    a.file.clone(),
                    a.speaks.word().to_owned(),
                    a.occurs.to_string(),
                    a.axioms.join(" + "),
                    a.seconds.to_string(),
                    a.statement.clone(),
                ]
            }),
        ),
        Format::Text => {
            let text = rows.iter().copied().map(|(_, a)| match whole {
                true => format!(
                    "{} ({}, {})\n{}\n\n",
                    a.name,
                    a.file,
                    a.axioms.join(" + "),
                    a.statement
                ),
                false => format!("{:<40} {:<8} {}\n", a.name, a.speaks.word(), a.file),
            });
            let text: String = text.collect();
            Ok(say(if text.is_empty() {
                "no theorem of it is before the kernel"
            } else {
                &text
            })?)
        }
    }
}
