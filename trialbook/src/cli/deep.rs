//! A run in depth: the trials at ever other points, each round in a process of its own, or many jobs with a part of the rounds each.

use super::{
    output::{complain, say},
    screen::progress,
    shard::Shard,
};
use crate::ledger::{Ledger, deep::Rounds};
use crate::publishing::Failure;
use crate::stop;
use indicatif::ProgressBar;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::Duration;
use std::{env, fs};

/// How often the trials are made, and by whom.
pub(super) struct Depth {
    pub rounds: u32,
    /// How many threads a round has.
    pub jobs: Option<u16>,
    /// Where the parts stand that other jobs have made; nothing if the rounds are still to be made.
    pub parts: Vec<PathBuf>,
}

impl Depth {
    /// Once, at the usual points.
    pub(super) const ONCE: Self = Self {
        rounds: 1,
        jobs: None,
        parts: Vec::new(),
    };
}

/// The ledger of a usual run with what the other rounds bring, judged anew; and how many rounds there were. An
/// interrupt ends it after the rounds that are done.
pub(super) fn deepened(
    mut ledger: Ledger,
    ids: &[&str],
    depth: &Depth,
) -> Result<(Ledger, u32), Failure> {
    if !depth.parts.is_empty() {
        return Ok((joined(ledger, depth)?, depth.rounds));
    }
    if depth.rounds == 1 {
        return Ok((ledger, 1));
    }
    let bar = bar(depth.rounds);
    bar.inc(1);
    let mut rounds = 1;
    while rounds < depth.rounds {
        let Some(brought) = round(rounds, ids, depth.jobs)? else {
            break;
        };
        ledger = ledger.with(&brought)?;
        rounds += 1;
        bar.inc(1);
        bar.set_message(format!("{} comparisons", ledger.points()));
    }
    bar.finish_and_clear();
    Ok((ledger, rounds))
}

/// Prints what the rounds of this part bring.
pub(super) fn part(ids: &[&str], shard: Shard, depth: &Depth) -> Result<u8, Failure> {
    let range = shard.range(depth.rounds.into());
    stop::listen()?;
    let bar = bar((range.end - range.start) as u32);
    let mut text = String::new();
    let mut left = range.start as u32..range.end as u32;
    let whole = loop {
        let Some(number) = left.next() else {
            break true;
        };
        let Some(brought) = round(number, ids, depth.jobs)? else {
            break false;
        };
        text += &Rounds::headed(number, &brought);
        bar.inc(1);
    };
    bar.finish_and_clear();
    if !text.is_empty() {
        say(&text)?;
    }
    if range.is_empty() {
        complain(
            "nothing to do",
            "there are fewer rounds than parts, and this one has none",
        );
    }
    if whole {
        return Ok(0);
    }
    complain("stopped", "the rounds so far are whole");
    Ok(stop::STOPPED)
}

/// The ledger with what the parts have brought in place of its own measurements.
fn joined(ledger: Ledger, depth: &Depth) -> Result<Ledger, Failure> {
    let read = |path: &Path| {
        let text = fs::read_to_string(path);
        text.map_err(|error| format!("{}: {error}", path.display()))
    };
    let texts = depth.parts.iter().map(|path| read(path));
    let texts = texts.collect::<Result<Vec<_>, _>>()?;
    let mut rounds = Rounds::default();
    for (path, text) in depth.parts.iter().zip(&texts) {
        let name = path.display();
        rounds
            .read(text)
            .map_err(|error| format!("{name}: {error}"))?;
    }
    Ok(rounds.in_place_of(&ledger, depth.rounds)?)
}

fn bar(rounds: u32) -> ProgressBar {
    progress(
        rounds.into(),
        "{bar:40} {pos}/{len} rounds  {eta} left  {msg}",
    )
}

/// What a round brings; nothing if somebody has asked to stop before its end.
fn round(number: u32, ids: &[&str], jobs: Option<u16>) -> Result<Option<String>, Failure> {
    if stop::is_asked() {
        return Ok(None);
    }
    let output = asked(number, ids, jobs)?;
    if output.status.success() {
        return Ok(Some(String::from_utf8(output.stdout)?));
    }
    if output.status.code().is_none() {
        // Ctrl-C reaches the round too, and may do so first.
        thread::sleep(Duration::from_millis(200));
    }
    if stop::is_asked() {
        return Ok(None);
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(format!("round {number} failed: {}", said.trim()).into())
}

/// This program, asked for a round.
fn asked(number: u32, ids: &[&str], jobs: Option<u16>) -> Result<Output, Failure> {
    let mut command = Command::new(env::current_exe()?);
    command
        .args(["verify", "--round", &number.to_string()])
        .args(ids);
    if let Some(jobs) = jobs {
        command.args(["--jobs", &jobs.to_string()]);
    }
    Ok(command.stdin(Stdio::null()).output()?)
}
