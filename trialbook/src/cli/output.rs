//! Printing: text, JSON and CSV, on standard output and whole.

use super::screen::{screen, wrapped};
use crate::plotting::Table;
use crate::publishing::Failure;
use serde::Serialize;
use std::io::{self, ErrorKind, Write};
use std::sync::OnceLock;
use std::{env, process};

/// The version of the JSON that is written: it changes when a field changes its meaning or goes.
pub const VERSION: u32 = 1;

static BOM: OnceLock<bool> = OnceLock::new();

/// Settles whether a table begins with the mark of its encoding.
pub(super) fn settle(bom: bool) {
    BOM.get_or_init(|| bom);
}

/// What stands before the head of a table: nothing, or the mark of UTF-8 if it is wanted.
pub fn bom() -> &'static str {
    match BOM.get() {
        Some(true) => "\u{feff}",
        _ => "",
    }
}

/// Prints text and ends its last line; a reader who has closed the pipe has read enough.
///
/// # Errors
/// What the system says where standard output cannot be written.
pub fn say(text: &str) -> io::Result<()> {
    let end = if text.ends_with('\n') { "" } else { "\n" };
    let mut out = io::stdout().lock();
    match write!(out, "{text}{end}").and_then(|()| out.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        other => other.map_err(unwritten),
    }
}

/// What the system says of standard output, with its name.
pub fn unwritten(error: io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("standard output: {error}"))
}

/// Prints text for people: wrapped where a width is known, and through a pager where it is longer than the terminal.
///
/// # Errors
/// What the system says where standard output cannot be written.
pub fn show(text: &str) -> io::Result<()> {
    let screen = screen();
    let text = screen
        .width
        .map_or(text.to_owned(), |width| wrapped(text, width));
    match screen.rows.is_some_and(|rows| text.lines().count() >= rows) && show_in_pager(&text) {
        true => Ok(()),
        false => say(&text),
    }
}

/// Whether a pager has shown it: `PAGER`, or `less`; there is none where that is empty.
fn show_in_pager(text: &str) -> bool {
    let pager = env::var("PAGER").unwrap_or_else(|_| "less".to_owned());
    let mut words = pager.split_whitespace();
    let Some(program) = words.next() else {
        return false;
    };
    let mut command = process::Command::new(program);
    command.args(words).stdin(process::Stdio::piped());
    if env::var_os("LESS").is_none() {
        // Ends by itself on one screen, and leaves colours as they are.
        command.env("LESS", "FRX");
    }
    let Ok(mut child) = command.spawn() else {
        return false;
    };
    if let Some(mut input) = child.stdin.take() {
        // A reader who has seen enough closes it.
        let _ = input.write_all(text.as_bytes());
    }
    child.wait().is_ok()
}

/// Says on standard error what is wrong, by the name of the program; where that is closed or full, nobody hears it.
pub fn complain(name: &str, text: &str) {
    let _ = writeln!(io::stderr(), "{name}: {text}");
}

/// Prints a value as JSON.
///
/// # Errors
/// [`Failure`] where the value is none, or standard output cannot be written.
pub fn json(value: &impl Serialize) -> Result<(), Failure> {
    Ok(say(&serde_json::to_string_pretty(value)?)?)
}

/// Prints rows of text as CSV.
///
/// # Errors
/// [`Failure`] where a row has not as many cells as there are headers, or standard output cannot be written.
pub fn csv(headers: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> Result<(), Failure> {
    let mut table = Table::new(headers);
    for row in rows {
        table.row(row)?;
    }
    Ok(say(&(bom().to_owned() + &table.into_text()))?)
}

/// The refusal of a table where there is none.
pub(crate) fn no_table() -> Failure {
    "--csv: this answer is no table".into()
}
