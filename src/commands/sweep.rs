//! A calculator at the points of a grid: a row each. One that is out of range is a row that says why.

use super::axis::Point;
use super::question::Question;
use super::solve::word;
use crate::claims::solve::{Field, Report, SolveError, VERSION, Value};
use crate::numerics::error::plain as number;
use rayon::prelude::*;
use serde_json::{Map, json};
use std::fmt::Write as _;
use std::io::{self, ErrorKind, Write};
use trialbook::cli::{Shard, unwritten};
use trialbook::edition::{Failure, Format};
use trialbook::figures::{Cell, Table};

/// Points that are asked together; after each such piece the rows are written.
const PIECE: u64 = 1024;

/// A point with its answer.
struct Row {
    index: u64,
    swept: Vec<(&'static str, f64)>,
    answer: Result<Report, SolveError>,
}

/// Asks at the points of the grid that are this part's, and writes a row for each.
pub(super) fn run(
    ask: &(dyn Fn(&mut Point) -> Question + Sync),
    total: u64,
    shard: Option<Shard>,
    format: Format,
) -> Result<u8, Failure> {
    if shard.is_some() && format == Format::Text {
        return Err("--shard goes with --csv or --json, whose parts can be joined".into());
    }
    let shard = shard.unwrap_or(Shard::WHOLE);
    let mut first = Point::new(0);
    let question = ask(&mut first);
    let mut heads: Vec<&str> = first.swept.iter().rev().map(|(name, _)| *name).collect();
    heads.extend(question.quantities()?);
    heads.extend(["digits", "note"]);
    let range = shard.range(total);
    let mut out = io::stdout().lock();
    let mut written = |text: String| match out.write_all(text.as_bytes()).and_then(|()| out.flush())
    {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(false),
        Err(error) => Err(unwritten(error)),
        Ok(()) => Ok(true),
    };
    if format == Format::Json && shard.is_first() {
        let (name, version) = (question.name(), VERSION);
        let begin =
            format!("{{\n  \"version\": {version},\n  \"problem\": \"{name}\",\n  \"answers\": [");
        if !written(begin)? {
            return Ok(0);
        }
    }
    let mut next = range.start;
    let mut all = Vec::new();
    while next < range.end {
        let piece = next..range.end.min(next + PIECE);
        next = piece.end;
        let rows = piece.into_par_iter().map(|index| {
            let mut point = Point::new(index);
            let answer = ask(&mut point).report();
            point.swept.reverse();
            Row {
                index,
                swept: point.swept,
                answer,
            }
        });
        let rows: Vec<_> = rows.collect();
        let text = match format {
            Format::Text => {
                all.extend(rows.iter().map(cells));
                continue;
            }
            Format::Csv => table(&heads, &rows)?,
            Format::Json => rows.iter().map(object).collect(),
        };
        if !written(text)? {
            return Ok(0);
        }
    }
    match format {
        Format::Json if shard.is_last() => written("\n  ]\n}\n".to_owned())?,
        Format::Text => written(aligned(&heads, &all))?,
        _ => true,
    };
    Ok(0)
}

/// The cells of a row: the place, the quantities, digits and note.
fn cells(row: &Row) -> Vec<String> {
    let mut cells: Vec<_> = row.swept.iter().map(|(_, x)| number(*x)).collect();
    match &row.answer {
        Ok(report) => {
            let value = |field: &Field| match field.value {
                Value::Missing => String::new(),
                value => word(value),
            };
            cells.extend(report.fields.iter().map(value));
            cells.push(report.digits.map_or(String::new(), |n| n.to_string()));
            cells.push(report.note.clone());
        }
        Err(error) => cells.push(error.to_string()),
    }
    cells
}

/// The same, as wide as the head: of what has no answer the quantities are empty.
fn filled(mut cells: Vec<String>, width: usize) -> Vec<String> {
    let note = cells.pop().unwrap_or_default();
    cells.resize(width - 1, String::new());
    cells.push(note);
    cells
}

/// Rows as CSV, with the head if the first of all is among them.
fn table(heads: &[&str], rows: &[Row]) -> Result<String, Failure> {
    let mut table = Table::new(heads);
    for row in rows {
        table.row(filled(cells(row), heads.len()).into_iter().map(Cell::Text))?;
    }
    let text = table.into_text();
    Ok(match rows.first().is_some_and(|row| row.index == 0) {
        true => text,
        false => text
            .split_once('\n')
            .map_or(String::new(), |(_, rows)| rows.to_owned()),
    })
}

/// A row as JSON, with what goes before it.
fn object(row: &Row) -> String {
    let given: Map<_, _> = row
        .swept
        .iter()
        .map(|(name, x)| ((*name).to_owned(), json!(x)))
        .collect();
    let answer = match &row.answer {
        Ok(report) => json!({ "given": given, "answer": report, "error": null }),
        Err(error) => json!({ "given": given, "answer": null, "error": error.to_string() }),
    };
    let separator = if row.index == 0 { "\n    " } else { ",\n    " };
    format!("{separator}{answer}")
}

/// Rows in columns; the note that most have stands below, and in a row only where it is another.
fn aligned(heads: &[&str], rows: &[Vec<String>]) -> String {
    let usual = |cells: &Vec<String>| (cells.len() == heads.len()).then(|| cells.last().cloned());
    let usual = rows.iter().find_map(usual).flatten().unwrap_or_default();
    let rows: Vec<_> = rows
        .iter()
        .map(|cells| {
            let mut cells = filled(cells.clone(), heads.len());
            if cells.last() == Some(&usual) {
                cells.pop();
            }
            cells
        })
        .collect();
    let width = |n: usize| {
        let cells = rows.iter().filter_map(|cells| cells.get(n));
        let cells = cells.map(|cell| cell.chars().count());
        cells.chain([heads[n].len()]).max().unwrap_or(0)
    };
    let widths: Vec<_> = (0..heads.len()).map(width).collect();
    let line = |cells: &mut dyn Iterator<Item = &str>| {
        let mut line = String::new();
        for (cell, width) in cells.zip(&widths) {
            // Nothing can fail in writing to a string.
            let _ = write!(line, "{cell:<width$}  ");
        }
        line.trim_end().to_owned() + "\n"
    };
    let mut text = line(&mut heads[..heads.len() - 1].iter().copied());
    for cells in &rows {
        text += &line(&mut cells.iter().map(String::as_str));
    }
    if !usual.is_empty() {
        let _ = writeln!(text, "\n{usual}");
    }
    text
}
