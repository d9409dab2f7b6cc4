//! Exact proofs: all identities, and those behind (11), (13), (14) from a cold start: `cargo bench --bench exact`.

use slipbook::claims::PAPER;
use slipbook::claims::constant::exact::{EQ11, EQ12, EQ13, EQ14};
use slipbook::evidence::Evidence;
use std::hint::black_box;
use std::process::Command;
use std::time::{Duration, Instant};
use trialbook::trials::attempt::Attempt;
use trialbook::trials::statement::Statement;

/// How often each of the two is timed.
const TIMES: usize = 100;

/// The identities behind (11), (13) and (14); (12) is the step from (11) to (13).
const FOUR: [Statement; 4] = [EQ11, EQ12, EQ13, EQ14];

/// In place of an option: prove the four and end.
const COLD: &str = "cold";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    if std::env::args().any(|argument| argument == COLD) {
        return if four() {
            Ok(())
        } else {
            Err("one of the four is not proved".into())
        };
    }
    let begin = Instant::now();
    let first = all();
    let once = begin.elapsed();
    let proved = first.iter().filter(|e| e.worst == 0.0).count();
    println!(
        "all identities, {} of {} proved: {once:.1?} the first time",
        proved,
        first.len()
    );
    report("all identities, again", || {
        black_box(all()).len() == first.len()
    })?;
    report("(11) to (14), in this process", four)?;
    let program = std::env::current_exe()?;
    report("(11) to (14), a process each", || {
        Command::new(&program)
            .arg(COLD)
            .status()
            .is_ok_and(|status| status.success())
    })
}

fn four() -> bool {
    FOUR.iter().all(|law| law.proof().holds())
}

/// The evidence of every proof.
fn all() -> Vec<Evidence> {
    let trials = PAPER.claims().flat_map(|(_, claim)| claim.trials);
    let statements = trials.filter_map(Attempt::statement);
    statements.map(|statement| statement.evidence()).collect()
}

/// Times a run that says whether it went well.
fn report(name: &str, run: impl Fn() -> bool) -> Result<(), Box<dyn std::error::Error>> {
    let mut fastest = Duration::MAX;
    let begin = Instant::now();
    for _ in 0..TIMES {
        let one = Instant::now();
        if !run() {
            return Err(format!("{name}: something is not proved").into());
        }
        fastest = fastest.min(one.elapsed());
    }
    let mean = begin.elapsed() / TIMES as u32;
    println!("{name}: {mean:.2?} on average, {fastest:.2?} at best");
    Ok(())
}
