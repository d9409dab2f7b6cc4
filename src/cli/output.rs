//! Printing: text, JSON and CSV, on standard output and whole.

use crate::figures::{Cell, Table};
use serde::Serialize;
use std::io::{self, ErrorKind, Write};

/// Why a command failed: a sentence for the reader.
pub(super) use crate::claims::compare::Failure;

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

/// A number with all its digits, as short as it can be read back.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 || (1e-5..1e15).contains(&x.abs()) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}
