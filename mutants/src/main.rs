//! Every mistake in the physics of `mutants/physics`, one at a time: each has to change a verdict of the ledger.
//!
//! A copy of the crate, in which each mistake stands behind a switch, is built once in `target/physics`; the ledger is tried for
//! each mistake in a process of its own. The results go to `snapshots/physics.csv` and `snapshots/reactions.csv`. No measurement
//! may have ceased to react, and one that reacts to nothing needs a line in `mutants/reads_no_motion.txt`. Names of mistakes may
//! follow: then only these are tried and nothing is recorded.

mod build;
mod list;
mod patch;
mod run;
mod table;

use std::error::Error;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::{env, fs};

const LIST: &str = "mutants/physics";
const TABLE: &str = "snapshots/physics.csv";
const REACTIONS: &str = "snapshots/reactions.csv";
/// Of the measurements that react to none.
const EXCUSES: &str = "mutants/reads_no_motion.txt";
const RECORD: &str = "snapshots/verdicts.snap";

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let named: Vec<String> = env::args().skip(1).collect();
    let mistakes = list::read(Path::new(LIST))?;
    if let Some(unknown) = named
        .iter()
        .find(|n| mistakes.iter().all(|m| m.name != **n))
    {
        return Err(format!("no mistake is called {unknown}").into());
    }
    let copy = Path::new("target/physics");
    let lost = build::write(&mistakes, copy)?;
    for lost in &lost {
        eprintln!("{lost}");
    }
    let program = build::build(copy)?;
    let right = run::without(&program)?;
    run::as_recorded(&right, &fs::read_to_string(RECORD)?)?;
    let made: Vec<_> = (1..)
        .zip(&mistakes)
        .filter(|(_, m)| !lost.iter().any(|l| l.mistake == m.name))
        .filter(|(_, m)| named.is_empty() || named.contains(&m.name))
        .collect();
    let reach = run::within_reach(&program, &right)?;
    let found = run::all(&program, &made, &right, &reach);
    let unnoticed = found.iter().filter(|(_, found)| !found.is_noticed());
    let unnoticed: Vec<_> = unnoticed.map(|(m, _)| m.name.as_str()).collect();
    let as_of = as_of()?;
    let mut complaints = Vec::new();
    if named.is_empty() && lost.is_empty() {
        let reactions = run::reactions(&right, &found);
        let recorded = fs::read_to_string(REACTIONS).unwrap_or_default();
        complaints = table::complaints(&reactions, &recorded, &fs::read_to_string(EXCUSES)?);
        record(TABLE, &table::csv(&as_of, &found))?;
        record(REACTIONS, &table::reactions(&as_of, &reactions))?;
    } else {
        print!("{}", table::csv(&as_of, &found));
    }
    for complaint in &complaints {
        eprintln!("{complaint}");
    }
    eprintln!(
        "{} of {} mistakes change a verdict; {} could not be made",
        found.len() - unnoticed.len(),
        mistakes.len(),
        lost.len()
    );
    if !unnoticed.is_empty() {
        eprintln!("no verdict changes with: {}", unnoticed.join(", "));
    }
    let passed = unnoticed.is_empty() && lost.is_empty() && complaints.is_empty();
    Ok(match passed {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    })
}

/// Where more of it than its head is different.
fn record(path: &str, text: &str) -> std::io::Result<()> {
    let there = fs::read_to_string(path).unwrap_or_default();
    match there.lines().skip(1).eq(text.lines().skip(1)) {
        true => Ok(()),
        false => fs::write(path, text),
    }
}

fn as_of() -> Result<String, Box<dyn Error>> {
    let form = "--format=# As of commit %h, %as";
    let said = Command::new("git").args(["log", "-1", form]).output()?;
    Ok(String::from_utf8(said.stdout)?.trim_end().to_owned())
}
