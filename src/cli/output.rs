//! Printing: text, JSON and CSV, on standard output and whole.

use crate::figures::{Cell, Table};
use serde::Serialize;
use std::io::{self, ErrorKind, Write};

/// Why a command failed: a sentence for the reader.
/// Why a command ends without its answer.
pub(super) type Failure = Box<dyn std::error::Error + Send + Sync>;
pub(super) use crate::claims::solve::plain as number;

/// In which form a command answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Text,
    Json,
    Csv,
}

/// The version of the JSON that is written: it changes when a field changes its meaning or goes.
pub(super) const VERSION: u32 = crate::claims::solve::VERSION;

/// Prints text and ends its last line; a reader who has closed the pipe has read enough.
pub(super) fn say(text: &str) -> io::Result<()> {
    let end = if text.ends_with('\n') { "" } else { "\n" };
    let mut out = io::stdout().lock();
    match write!(out, "{text}{end}").and_then(|()| out.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        other => other,
    }
}

/// Says on standard error what is wrong; where that is closed or full, nobody hears it.
pub(super) fn complain(text: &str) {
    let _ = writeln!(io::stderr(), "slipbook: {text}");
}

/// Prints a value as JSON.
pub(super) fn json(value: &impl Serialize) -> Result<(), Failure> {
    Ok(say(&serde_json::to_string_pretty(value)?)?)
}

/// Prints rows of text as CSV.
pub(super) fn csv(
    headers: &[&str],
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<(), Failure> {
    let mut table = Table::new(headers);
    for row in rows {
        table.row(row.into_iter().map(Cell::Text))?;
    }
    Ok(say(&table.into_text())?)
}

/// The refusal of a table where there is none.
pub(super) fn no_table() -> Failure {
    "--csv: this answer is no table".into()
}
