//! The command: verify every claim, print the ledger, write the book.

use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use slipbook::ledger::{Difference, Ledger, Record, Verdict};
use slipbook::{book, claims, figures};
use std::io::{self, ErrorKind, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// Tries every claim of the paper, prints what each is worth, and writes the book.
///
/// Exit code 0 when every verdict is the recorded one, 1 when one differs, 2 for bad usage or a failure.
#[derive(Parser)]
#[command(
    version,
    after_help = "Example:\n  slipbook --out target/book    verify, then write the book into target/book"
)]
struct Arguments {
    /// Folder to write the book into; an earlier book there is replaced as a whole
    #[arg(long, value_name = "FOLDER", default_value = "target/book")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match main_job(&Arguments::parse()) {
        Ok(differences) if differences.is_empty() => ExitCode::SUCCESS,
        Ok(_) => ExitCode::from(1),
        Err(error) => {
            eprintln!("slipbook: {error}");
            ExitCode::from(2)
        }
    }
}

fn main_job(arguments: &Arguments) -> Result<Vec<Difference>, Box<dyn std::error::Error>> {
    let start = Instant::now();
    let record = Record::committed()?;
    book::check(&arguments.out)?;
    let (ledger, figures) = rayon::join(verify, figures::all);
    let differences = record.differences(&ledger);
    say(&ledger.table())?;
    for difference in &differences {
        let words = |v: Option<Verdict>| v.map_or("no such claim", Verdict::words);
        say(&format!(
            "{}: recorded as {}, found {}",
            difference.id,
            words(difference.recorded),
            words(difference.found)
        ))?;
    }
    let first_page = book::write(&ledger, &figures?, &arguments.out)?;
    let as_recorded =
        ledger.entries.len() - differences.iter().filter(|d| d.found.is_some()).count();
    say(&format!(
        "{}\n{} comparisons in {:.1} s; {as_recorded} of {} verdicts as recorded\nThe book: {}",
        ledger.summary(),
        ledger.points(),
        start.elapsed().as_secs_f64(),
        ledger.entries.len(),
        first_page.display()
    ))?;
    Ok(differences)
}

/// Tries all claims with a progress bar, which shows on a terminal only.
fn verify() -> Ledger {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} claims  {msg}");
    let bar = ProgressBar::new(claims::all().count() as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let ledger = Ledger::try_all(|claim| {
        bar.set_message(claim.id);
        bar.inc(1);
    });
    bar.finish_and_clear();
    ledger
}

/// Prints a line; a reader who has closed the pipe has read enough.
fn say(line: &str) -> io::Result<()> {
    match writeln!(io::stdout(), "{line}") {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        other => other,
    }
}
