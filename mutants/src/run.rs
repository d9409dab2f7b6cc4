//! Switches one change on after the other and runs the tests that come to it, until one fails.

use crate::cover::{Unit, WORKERS, command};
use crate::list::Mutant;
use std::collections::BTreeMap;
use std::error::Error;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::thread;
use std::time::{Duration, Instant};

/// What became of a change: the word in the results, and with what.
type Outcome = (&'static str, String);

/// The test of the figures.
const FIGURES: &str = "the_figures_are_the_recorded_ones";

/// How long a question or a test may take under a change.
fn limit(seconds: f64) -> f64 {
    10.0 * seconds + 1.5
}

/// True for a test that tries the whole ledger: its sheets are asked one by one.
fn whole(unit: &Unit) -> bool {
    4 * unit.reached.iter().filter(|r| **r == 1).count() > 3 * unit.reached.len()
}

/// Of some tests in one process.
struct Step<'a> {
    units: Vec<&'a Unit>,
    /// Whether the last question is for loose tolerances.
    last: bool,
}

/// The steps for a change, the quick ones first; `own` is the claim whose row it changes.
fn steps<'a>(reaching: &[&'a Unit], own: Option<&str>) -> Vec<Step<'a>> {
    let sheets: Vec<_> = reaching
        .iter()
        .copied()
        .filter(|u| u.asks() && !u.name.starts_with("v:"))
        .collect();
    let variants: Vec<_> = reaching
        .iter()
        .copied()
        .filter(|u| u.asks() && u.name.starts_with("v:"))
        .collect();
    let tests = |from: f64, to: f64, most: f64| {
        let mut by_program = BTreeMap::<PathBuf, Vec<&Unit>>::new();
        for u in reaching
            .iter()
            .filter(|u| !u.asks() && (from..to).contains(&u.seconds))
        {
            by_program.entry(u.program.clone()).or_default().push(u);
        }
        let mut steps = Vec::new();
        for units in by_program.into_values() {
            let (mut some, mut sum) = (Vec::new(), 0.0);
            for u in units {
                if sum + u.seconds > most && !some.is_empty() {
                    steps.push(Step {
                        units: std::mem::take(&mut some),
                        last: false,
                    });
                    sum = 0.0;
                }
                sum += u.seconds;
                some.push(u);
            }
            if !some.is_empty() {
                steps.push(Step {
                    units: some,
                    last: false,
                });
            }
        }
        steps
    };
    let mut quick = tests(0.0, 0.1, 0.3);
    let mut all = Vec::new();
    if let Some(own) = own {
        let name = format!("s:{own}");
        let units: Vec<_> = sheets
            .iter()
            .copied()
            .filter(|u| u.name == name || u.name == "d:")
            .collect();
        all.push(Step { units, last: false });
    }
    all.append(&mut quick);
    if !sheets.is_empty() {
        all.push(Step {
            units: sheets,
            last: true,
        });
    }
    all.extend(tests(0.1, 1.0, 0.0));
    let mut slow = tests(1.0, f64::INFINITY, 0.0);
    slow.sort_by(|a, b| a.units[0].seconds.total_cmp(&b.units[0].seconds));
    // The figures are recorded to the byte: of the slow tests none sees more.
    let (figures, slow): (Vec<_>, _) = slow.into_iter().partition(|s| s.units[0].name == FIGURES);
    all.extend(figures);
    if !variants.is_empty() {
        all.push(Step {
            units: variants,
            last: false,
        });
    }
    all.extend(slow);
    all
}

/// Runs a step, for at most so many seconds; `None` if all pass.
fn run(
    step: &Step,
    id: u32,
    copy: &Path,
    table: &str,
    left: f64,
) -> Result<Option<Outcome>, Box<dyn Error>> {
    let asks = step.units[0].asks();
    let mut names: Vec<_> = step
        .units
        .iter()
        .map(|u| u.argument(limit(u.seconds)))
        .collect();
    if step.last {
        names.push(format!("t:{table}=5"));
    }
    let sum: f64 = step.units.iter().map(|u| u.seconds).sum();
    let most = limit(sum)
        + if asks {
            2.0 * step.units.len() as f64
        } else {
            0.0
        };
    let start = Instant::now();
    let mut child = command(&step.units[0].program, asks, &names, copy)
        .env("SLIPBOOK_MUTANT", id.to_string())
        .stdout(Stdio::null())
        .process_group(0)
        .spawn()?;
    let mut wait = Duration::from_micros(500);
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        let spent = start.elapsed().as_secs_f64();
        if spent > most.min(left) {
            // The shell and nice have become the program, but it may have started others.
            let group = format!("-{}", child.id());
            let _ = Command::new("kill").args(["-KILL", "--", &group]).status();
            child.wait()?;
            let word = if spent > most { "slow" } else { "capped" };
            return Ok(Some((word, step.units[0].name.clone())));
        }
        thread::sleep(wait);
        wait = (wait * 5 / 4).min(Duration::from_millis(20));
    };
    let first = step.units[0].name.clone();
    Ok(match (status.code(), status.signal()) {
        (Some(0), _) => None,
        (Some(3), _) if asks => Some(("slow", first)),
        (Some(_), _) => Some(("caught", first)),
        (None, signal) => Some(("crashed", format!("{first} {}", signal.unwrap_or(0)))),
    })
}

/// What becomes of a change; `capped` if it survives for `most` seconds, or all but the slow tests.
fn outcome(
    id: u32,
    steps: &[Step],
    copy: &Path,
    table: &str,
    (most, slow): (f64, bool),
) -> Result<Outcome, Box<dyn Error>> {
    let start = Instant::now();
    if steps.is_empty() {
        return Ok(("unreached", String::new()));
    }
    for step in steps {
        let left = most - start.elapsed().as_secs_f64();
        // A slow test is not begun in the first round, but for the figures.
        let first = step.units[0];
        let long = !slow && !first.asks() && first.seconds > 1.0 && first.name != FIGURES;
        if left < 0.0 || long {
            return Ok(("capped", step.units[0].name.clone()));
        }
        if let Some(outcome) = run(step, id, copy, table, left)? {
            return Ok(outcome);
        }
    }
    Ok(("missed", String::new()))
}

/// The outcomes that are known: by change the last line of the results.
pub fn known(results: &Path) -> BTreeMap<u32, (String, String)> {
    let text = fs::read_to_string(results).unwrap_or_default();
    let line = |l: &str| {
        let mut cells = l.split('\t');
        let id = cells.next()?.parse().ok()?;
        Some((id, (cells.next()?.to_owned(), cells.nth(1)?.to_owned())))
    };
    text.lines().filter_map(line).collect()
}

/// Tries each change whose outcome is not known for at most so many seconds, and adds to the results; `again` those too
/// that took too long before, with slow tests.
pub fn run_all(
    mutants: &[&Mutant],
    own: &BTreeMap<u32, String>,
    units: &[Unit],
    copy: &Path,
    scratch: &Path,
    (most, again): (f64, bool),
) -> Result<(), Box<dyn Error>> {
    let results = scratch.join("results.tsv");
    let table = fs::canonicalize(scratch.join("table"))?;
    let table = table.to_string_lossy();
    let known = known(&results);
    let open = |m: &&&Mutant| {
        known
            .get(&m.id)
            .is_none_or(|(word, _)| again && word == "capped")
    };
    let mut left: Vec<&Mutant> = mutants.iter().filter(open).copied().collect();
    // In an order in which the first ones are already a sample of all.
    left.sort_by_key(|m| m.id.wrapping_mul(2_654_435_769));
    let count = left.len();
    let file = Mutex::new(
        OpenOptions::new()
            .create(true)
            .append(true)
            .open(&results)?,
    );
    let queue = Mutex::new(left);
    let start = Instant::now();
    let work = || -> Result<(), String> {
        loop {
            let (mutant, left) = {
                let mut queue = queue.lock().map_err(|e| e.to_string())?;
                let Some(mutant) = queue.pop() else {
                    return Ok(());
                };
                (mutant, queue.len())
            };
            let id = mutant.id;
            let reaching = units
                .iter()
                .filter(|u| u.reached.get(id as usize) == Some(&1) && !whole(u));
            let reaching: Vec<_> = reaching.collect();
            let steps = steps(&reaching, own.get(&id).map(String::as_str));
            let begin = Instant::now();
            let (word, by) =
                outcome(id, &steps, copy, &table, (most, again)).map_err(|e| e.to_string())?;
            let line = format!("{id}\t{word}\t{:.2}\t{by}\n", begin.elapsed().as_secs_f64());
            let mut file = file.lock().map_err(|e| e.to_string())?;
            file.write_all(line.as_bytes()).map_err(|e| e.to_string())?;
            if left.is_multiple_of(100) {
                eprintln!(
                    "{left} of {count} left after {:.0} s",
                    start.elapsed().as_secs_f64()
                );
            }
        }
    };
    thread::scope(|scope| {
        let workers: Vec<_> = (0..WORKERS).map(|_| scope.spawn(work)).collect();
        for worker in workers {
            worker.join().map_err(|_| "a worker panics")??;
        }
        Ok(())
    })
}
