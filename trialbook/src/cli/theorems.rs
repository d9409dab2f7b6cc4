//! The theorems: what the kernel has accepted, and what goes to it and comes back.

use super::{
    ids,
    output::{VERSION, csv, json, say},
};
use crate::publishing::{Edition, Failure, Format};
use crate::theorems::record::{self, Accepted};
use crate::theorems::{Known, formulas};

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
    #[serde(skip_serializing_if = "Option::is_none")]
    definitions: Option<Vec<String>>,
}

/// Answers for these claims and for theorems by their names, or for all claims.
pub(super) fn theorems(
    edition: &Edition,
    names: &[String],
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
            &known.wanted(paper.claim_ids()),
            &known.record,
        ))?;
    } else if let Some(folder) = &wanted.answers {
        say(&made(known, folder)?)?;
    } else {
        let (mut ids, mut alone) = (Vec::new(), Vec::new());
        for name in names {
            match known.record.iter().any(|accepted| accepted.name == *name) {
                true => alone.push(name.as_str()),
                false => ids.push(ids::known(edition, name)?),
            }
        }
        let of_claims = paper.claims().flat_map(|(_, claim)| {
            let all = known.of_claim(claim.id).into_iter();
            all.map(|(accepted, _)| (claim.id, accepted))
        });
        let beside = known.beside(paper.claim_ids()).into_iter();
        let beside = beside.map(|(accepted, _)| ("", accepted));
        let mut rows: Vec<_> = of_claims.chain(beside).collect();
        rows.retain(|(claim, accepted)| {
            let all = names.is_empty() && !claim.is_empty();
            all || ids.contains(claim) || alone.contains(&accepted.name.as_str())
        });
        list(known, &rows, (!names.is_empty(), &alone), format)?;
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

/// What the statement of a theorem speaks of, each with what the comment before it says.
fn definitions(known: &Known, accepted: &Accepted) -> Vec<String> {
    let sources = &known.sources;
    let used = sources.explains(&accepted.statement, &accepted.file);
    let texts = used.iter().map(|used| match used.about.as_str() {
        "" => format!("{}.", used.text),
        about => format!("(* {about} *)\n{}.", used.text),
    });
    texts.collect()
}

/// The theorems with their claims; with their statements if they are named, and with all that these use if they are alone.
fn list(
    known: &Known,
    rows: &[(&'static str, &Accepted)],
    (whole, alone): (bool, &[&str]),
    format: Format,
) -> Result<(), Failure> {
    match format {
        Format::Json => json(&List {
            version: VERSION,
            theorems: rows
                .iter()
                .map(|(claim, theorem)| Row {
                    claim,
                    theorem,
                    definitions: whole.then(|| definitions(known, theorem)),
                })
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
            rows.iter().map(|(claim, a)| {
                vec![
                    (*claim).to_owned(),
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
            let text = rows.iter().map(|(_, a)| match whole {
                true => {
                    let mut texts = match alone.contains(&a.name.as_str()) {
                        true => definitions(known, a),
                        false => Vec::new(),
                    };
                    let (axioms, file) = (a.axioms.join(" + "), &a.file);
                    texts.push(format!(
                        "{} ({file}, {axioms})\n{}\n\n",
                        a.name, a.statement
                    ));
                    texts.join("\n\n")
                }
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
