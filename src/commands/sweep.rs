//! A calculator at the points of a grid: a row each. One that is out of range is a row that says why.

use super::{
    axis::Point,
    pieces::{Stop, end, in_pieces, told},
    question::{Asked, word},
};
use crate::numerics::error::plain as number;
use crate::solve::{Field, Report, SolveError, VERSION, Value, head};
use rayon::prelude::*;
use serde_json::{Map, json};
use std::fmt::Write as _;
use std::io::{self, Write};
use trialbook::cli::{Shard, ascii, bom, screen, show};
use trialbook::plotting::Table;
use trialbook::publishing::{Failure, Format};

/// The least and the most points that are asked together; after each such piece the rows are written.
const PIECES: [u64; 2] = [8, 1024];

/// A point with its answer.
struct Row {
    index: u64,
    swept: Vec<(&'static str, f64)>,
    answer: Result<Report, SolveError>,
}

/// Asks at the points of the grid that are this part's, and writes a row for each; `unit` is that of a number that is given.
pub(super) fn run(
    ask: &(dyn Fn(&mut Point) -> Asked + Sync),
    unit: &dyn Fn(&str) -> &'static str,
    total: u64,
    shard: Option<Shard>,
    format: Format,
) -> Result<u8, Stop> {
    if shard.is_some() && format == Format::Text {
        let refused = "--shard goes with --csv or --json, whose parts can be joined";
        return Err(Stop::Failure(refused.into()));
    }
    let shard = shard.unwrap_or(Shard::WHOLE);
    let mut first = Point::new(0);
    let question = ask(&mut first);
    let given = || first.swept.iter().rev().map(|(name, _)| *name);
    let answered = question.heads().map_err(Failure::from)?;
    // Where the answer has a quantity of the same name, what is given says so.
    let given_head = |name| match head(name, unit(name)) {
        head if answered.contains(&head) => format!("given {head}"),
        head => head,
    };
    let mut heads: Vec<_> = given().map(given_head).collect();
    let keys = heads.len();
    heads.extend(answered);
    heads.extend(["digits", "note"].map(str::to_owned));
    let heads: Vec<_> = heads.iter().map(String::as_str).collect();
    let range = shard.range(total);
    let mut out = io::stdout().lock();
    let mut written = |text: String| out.write_all(text.as_bytes()).and_then(|()| out.flush());
    if format == Format::Json && shard.is_first() {
        let (name, version) = (question.name(), VERSION);
        let units: Map<_, _> = given()
            .map(|name| (name.to_owned(), unit(name).into()))
            .collect();
        let units = serde_json::Value::from(units);
        let begin = format!(
            "{{\n  \"version\": {version},\n  \"problem\": \"{name}\",\n  \"units\": {units},\n  \"answers\": ["
        );
        written(begin)?;
    }
    let (mut refused, mut all) = (0, Vec::new());
    let next = in_pieces(range.clone(), PIECES, "rows", |piece| {
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
        refused += rows.iter().filter(|row| row.answer.is_err()).count() as u64;
        let text = match format {
            Format::Text => {
                all.extend(rows.iter().map(cells));
                return Ok(());
            }
            Format::Csv => table(&heads, &rows)?,
            Format::Json => rows.iter().map(object).collect(),
        };
        Ok(written(text)?)
    })?;
    match format {
        Format::Text => show(&aligned(&heads, keys, &all, screen().width))?,
        Format::Csv => {}
        Format::Json => written(end(shard, next, total).unwrap_or_default())?,
    }
    Ok(told(&range, (next, refused), "rows"))
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
        table.row(filled(cells(row), heads.len()))?;
    }
    let text = ascii(&table.into_text());
    Ok(match rows.first().is_some_and(|row| row.index == 0) {
        true => bom().to_owned() + &text,
        false => text
            .split_once('\n')
            .map_or(String::new(), |(_, rows)| rows.to_owned()),
    })
}

/// The table of a single answer: as of several, with one row.
pub(super) fn single(report: Report) -> Result<String, Failure> {
    let heads = report.fields.iter().map(Field::head);
    let heads: Vec<_> = heads.chain(["digits", "note"].map(str::to_owned)).collect();
    let heads: Vec<_> = heads.iter().map(String::as_str).collect();
    let row = Row {
        index: 0,
        swept: Vec::new(),
        answer: Ok(report),
    };
    table(&heads, &[row])
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

/// Rows in columns, of which the first `keys` say where: in as many blocks one below the other as the screen is too narrow
/// for. The first row's note stands below; another one in its row of the last block, or below it where there is no room.
pub(super) fn aligned(
    heads: &[&str],
    keys: usize,
    rows: &[Vec<String>],
    width: Option<usize>,
) -> String {
    let usual = |cells: &Vec<String>| (cells.len() == heads.len()).then(|| cells.last().cloned());
    let usual = rows.iter().find_map(usual).flatten().unwrap_or_default();
    let note = heads.len() - 1;
    let rows: Vec<_> = rows
        .iter()
        .map(|cells| {
            let mut cells = filled(cells.clone(), heads.len());
            if cells[note] == usual {
                cells[note].clear();
            }
            cells
        })
        .collect();
    let widest = |n: usize| {
        let cells = rows.iter().map(|cells| cells[n].chars().count());
        cells.chain([heads[n].chars().count()]).max().unwrap_or(0) + SPACE.len()
    };
    let widths: Vec<_> = (0..note).map(widest).collect();
    let room = width.unwrap_or(usize::MAX);
    let mut blocks = vec![(0..keys).collect::<Vec<_>>()];
    let mut used = widths[..keys].iter().sum::<usize>();
    for (n, width) in widths.iter().enumerate().skip(keys) {
        let last = blocks.len() - 1;
        // The space behind the last column may be missing.
        if used + width > room.saturating_add(SPACE.len()) && blocks[last].len() > keys {
            blocks.push((0..keys).collect());
            used = widths[..keys].iter().sum();
        }
        used += width;
        let last = blocks.len() - 1;
        blocks[last].push(n);
    }
    let longest = rows.iter().map(|cells| cells[note].chars().count()).max();
    let beside = used.saturating_add(longest.unwrap_or(0)) <= room;
    let mut text = String::new();
    for (b, block) in blocks.iter().enumerate() {
        let line = |cells: &dyn Fn(usize) -> String| {
            let cells = block.iter().map(|&n| {
                let (cell, width) = (cells(n), widths[n]);
                format!("{cell:<width$}")
            });
            cells.collect::<String>()
        };
        if b > 0 {
            text.push('\n');
        }
        text += line(&|n| heads[n].to_owned()).trim_end();
        text.push('\n');
        for cells in &rows {
            let mut row = line(&|n| cells[n].clone());
            if b + 1 == blocks.len() && !cells[note].is_empty() {
                if !beside {
                    row.truncate(row.trim_end().len());
                    row += "\n    ";
                }
                row += &cells[note];
            }
            text += row.trim_end();
            text.push('\n');
        }
    }
    if !usual.is_empty() {
        // Nothing can fail in writing to a string.
        let _ = writeln!(text, "\n{usual}");
    }
    text
}

/// What stands between two columns.
const SPACE: &str = "  ";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_as_wide_as_the_screen() {
        let heads = ["x", "one", "two", "digits", "note"];
        let row = |cells: [&str; 5]| cells.map(str::to_owned).to_vec();
        let rows = [
            row(["1", "0.123456", "0.25", "15", "usual"]),
            vec!["2".to_owned(), "out of range".to_owned()],
        ];
        let wide = "x  one       two   digits\n1  0.123456  0.25  15\n2                          out of range\n\nusual\n";
        for width in [None, Some(80), Some(39)] {
            assert_eq!(aligned(&heads, 1, &rows, width), wide);
        }
        assert_eq!(
            aligned(&heads, 1, &rows, Some(25)),
            "x  one       two   digits\n1  0.123456  0.25  15\n2\n    out of range\n\nusual\n"
        );
        assert_eq!(
            aligned(&heads, 1, &rows, Some(24)),
            "x  one       two\n1  0.123456  0.25\n2\n\nx  digits\n1  15\n2          out of range\n\nusual\n"
        );
    }
}
