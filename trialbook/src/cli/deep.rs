//! A run in depth: the trials at ever other points, each round in a process of its own.

use super::screen::progress;
use crate::edition::Failure;
use crate::ledger::Ledger;
use std::env;
use std::process::{Command, Output, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The ledger of a first round, with what `depth − 1` others bring, judged anew; and how many rounds were run. An
/// interrupt ends it after the rounds that are done.
pub(super) fn deepened(
    mut ledger: Ledger,
    ids: &[&str],
    depth: u32,
    jobs: Option<u16>,
) -> Result<(Ledger, u32), Failure> {
    let stop = Arc::new(AtomicBool::new(false));
    let asked = Arc::clone(&stop);
    ctrlc::set_handler(move || asked.store(true, Ordering::Relaxed))?;
    let bar = progress(
        depth.into(),
        "{bar:40} {pos}/{len} rounds  {eta} left  {msg}",
    );
    bar.inc(1);
    let mut rounds = 1;
    while rounds < depth && !stop.load(Ordering::Relaxed) {
        let output = round(rounds, ids, jobs)?;
        if !output.status.success() {
            if stop.load(Ordering::Relaxed) {
                break;
            }
            let said = String::from_utf8_lossy(&output.stderr);
            return Err(format!("round {rounds} failed: {}", said.trim()).into());
        }
        ledger.add(&String::from_utf8(output.stdout)?)?;
        rounds += 1;
        bar.inc(1);
        bar.set_message(format!("{} comparisons", ledger.points()));
    }
    bar.finish_and_clear();
    Ok((ledger.judged(), rounds))
}

/// This program, asked for a round.
fn round(number: u32, ids: &[&str], jobs: Option<u16>) -> Result<Output, Failure> {
    let mut command = Command::new(env::current_exe()?);
    command
        .args(["verify", "--round", &number.to_string()])
        .args(ids);
    if let Some(jobs) = jobs {
        command.args(["--jobs", &jobs.to_string()]);
    }
    Ok(command.stdin(Stdio::null()).output()?)
}
