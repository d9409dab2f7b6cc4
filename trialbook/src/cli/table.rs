//! The ledger as text: columns for as wide a screen as there is.

use super::screen::{Screen, cut};
use crate::ledger::{Entry, Standing};
use std::fmt::Write;

/// The widest column of formulas or titles.
const WIDEST: usize = 58;

/// Below this a column of formulas says nothing: they get lines of their own.
const LEAST: usize = 24;

/// A claim in cells, with what is painted.
struct Line<'a> {
    entry: &'a Entry,
    cells: [String; 2],
    /// The formula or the title.
    text: &'a str,
    /// What follows where there is room.
    last: String,
}

/// All claims by section: id, formula, verdict, that it is proved or argued, or else the worst disagreement, routes.
pub(super) fn table(entries: &[Entry], screen: &Screen) -> String {
    let mut sections: Vec<&str> = entries.iter().map(|e| e.claim.section).collect();
    sections.sort_unstable();
    sections.dedup();
    let mut lines = Vec::new();
    for section in &sections {
        for entry in entries.iter().filter(|e| e.claim.section == *section) {
            // Of a claim that fails, how badly it does is what matters here.
            let fails = entry.judgement.verdict.is_wrong();
            let worst = entry.worst().map(|e| format!("{:.0e}", e.worst));
            let known = match entry.standing() {
                Some(of) if of != Standing::Measured && !fails => of.word().to_owned(),
                _ => worst.unwrap_or_default(),
            };
            lines.push(Line {
                entry,
                cells: [entry.claim.id.to_owned(), known],
                text: entry.claim.plain,
                last: entry.routes(),
            });
        }
    }
    let (mut text, texts) = set(
        ["claim", "verdict", "off by", "statement", "found by"],
        &lines,
        screen,
    );
    for section in sections {
        // Nothing can fail in writing to a string.
        let _ = writeln!(text, "\nSection {section}");
        for (line, set) in lines.iter().zip(&texts) {
            if line.entry.claim.section == section {
                text += set;
            }
        }
    }
    text
}

/// Claims with section, verdict and title, a line each.
pub(super) fn list(entries: &[&Entry], screen: &Screen) -> String {
    let lines: Vec<_> = entries
        .iter()
        .map(|entry| Line {
            entry,
            cells: [entry.claim.id.to_owned(), entry.claim.section.to_owned()],
            text: entry.claim.title,
            last: String::new(),
        })
        .collect();
    let (head, lines) = set(["claim", "verdict", "section", "title", ""], &lines, screen);
    head + &lines.concat()
}

/// The names of the columns, and the lines, as wide as they need; on a narrow screen what is long gets a line of its own.
fn set(names: [&str; 5], lines: &[Line<'_>], screen: &Screen) -> (String, Vec<String>) {
    let count = |text: &str| text.chars().count();
    let widest = |name: usize, of: &dyn Fn(&Line<'_>) -> usize| {
        lines.iter().map(of).fold(count(names[name]), usize::max)
    };
    let first = widest(0, &|line| count(&line.cells[0]));
    let second = widest(2, &|line| count(&line.cells[1]));
    let verdict = widest(1, &|line| count(line.entry.judgement.verdict.words()));
    let last = widest(4, &|line| count(&line.last));
    let longest = widest(3, &|line| count(line.text)).min(WIDEST);
    // Two spaces before each column.
    let fixed = first + second + verdict + 8;
    let room = screen
        .width
        .map_or(usize::MAX, |width| width.saturating_sub(fixed));
    let one_line = room >= LEAST.min(longest);
    let column = longest.min(room);
    let rest = room.saturating_sub(column) >= last + 2;
    let [a, b, c, d, e] = names;
    let e = if rest { e } else { "" };
    let mut head = format!("  {a:<first$}  {b:<verdict$}  {c:<second$}");
    if one_line {
        let _ = write!(head, "  {d:<column$}  {e}");
    }
    let lines = lines.iter().map(|line| {
        let words = line.entry.judgement.verdict.words();
        let painted = screen.paint(line.entry.judgement.verdict, words);
        let space = " ".repeat(verdict - count(words));
        let [a, b] = &line.cells;
        let mut text = format!("  {a:<first$}  {painted}{space}  {b:<second$}");
        let last = if rest { line.last.as_str() } else { "" };
        if one_line {
            let _ = write!(text, "  {:<column$}  {last}", cut(line.text, column));
        } else {
            let width = screen.width.unwrap_or(usize::MAX).saturating_sub(6);
            let _ = write!(text, "\n      {}", cut(line.text, width));
        }
        text.truncate(text.trim_end().len());
        text + "\n"
    });
    (head.trim_end().to_owned() + "\n", lines.collect())
}
