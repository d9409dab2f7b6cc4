//! The book: pages filled from the ledger and the figures, rendered by mdBook, put in place whole.
//!
//! The pages are Markdown under `book/src`, with formulas in `$…$` and `$$…$$` and with placeholders:
//!
//! | placeholder | stands for |
//! |---|---|
//! | `{{claim eq-11}}` | the claim's box; every claim has one, on the page of its topic |
//! | `{{figure fig-1}}` | the figure with its caption, text alternative and data |
//! | `{{explorer}}` | the page's explorer, right before the figure that it answers for |
//! | `{{counts}}` | a table of the verdicts with the number of claims |
//! | `{{ledger constant}}` | a table of the claims of a topic |
//! | `{{ledger}}` | the tables of all topics under headings |
//! | `{{proofs}}` | a table of what is proved and what is measured, by the kind of claim |
//! | `{{strongest}}` | a table of all claims with the strongest route of each |
//! | `{{measured}}` | a table of the claims without a proof, by the reason |
//! | `{{equations}}`, `{{symbols}}`, `{{values}}` | the indexes |
//! | `{{errata misprint refuted}}` | the errata with these verdicts |
//! | `{{map key}}`, `{{map list}}`, `{{falls}}` | the signs of the map of claims, and what it shows as tables |
//! | `{{speed}}`, `{{growth}}`, `{{measured-on}}` | the committed timings beside those of others, by the number of starts, and when and where they were taken |
//! | `{{routes}}`, `{{tolerances}}` | tables of what the trials of this ledger use |
//! | `{{sheet eq-20}}` | the claim's sheet, as the snapshots have it |
//! | `{{verdict eq-11}}` | the verdict in word and colour |
//! | `{{points eq-11}}` | how many points its trials compared |
//! | `{{worst eq-11}}` | the disagreement that comes nearest to, or farthest beyond, its tolerance |
//! | `{{ref eq-11}}` | a link to the claim's box |
//! | `{{value lambda-c}}` | a number of the index of values, by its short name |
//! | `{{count confirmed}}` | the number of claims of a verdict, by its slug |
//! | `{{count proved}}` | the number of claims that are proved |
//! | `{{count claims}}`, `{{count points}}` | the number of all claims, of all compared points |
//!
//! Those that stand for a box, a figure or a table stand alone on their line. None is filled in code.
//! Whatever cannot be filled or set stops the book, with page and line.

mod assets;
mod claim_box;
mod code;
mod errata;
mod error;
mod expand;
mod explorer;
mod fill;
mod map;
mod maths;
mod pages;
mod plain;
mod search;
mod speed;
mod swap;
mod symbols;
mod tables;
#[cfg(test)]
mod tests;
mod text;
mod values;

pub use error::BookError;

use crate::claims::values::VALUES;
use crate::figures::Figure;
use crate::ledger::{Format, Ledger};
use code::Code;
use fill::Filler;
use maths::Forms;
use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use pages::Page;
use rayon::prelude::*;
use search::Search;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use swap::{Staging, unwritable};

/// Writes the book into the folder `out` and returns the path of its first page.
///
/// The book is made in a temporary folder beside `out`, which changes places with `out` at the end:
/// until then, and whenever anything fails, `out` is what it was. Parent folders are made where they
/// are missing. The same ledger and figures give the same bytes.
///
/// # Errors
/// [`BookError::Unwritable`] if a file or folder cannot be written, [`BookError::NotOurs`] if `out`
/// is neither empty nor an earlier book, and the other kinds of [`BookError`] if a page does not
/// fit the ledger.
pub fn write(ledger: &Ledger, figures: &[Figure], out: &Path) -> Result<PathBuf, BookError> {
    write_pages(pages::pages(figures), ledger, figures, out)
}

/// Sets the formulas and computes the numbers that do not depend on a verdict; [`write()`] then has less to do. It may
/// be left out.
pub fn prepare() {
    LazyLock::force(&maths::KNOWN);
    for value in &VALUES {
        // A failure shows where the number is used.
        let _ = value.number();
    }
}

/// Finds out whether a book can be written into `out`, before the work is done; changes nothing but for
/// missing parent folders, which it makes.
///
/// # Errors
/// [`BookError::Unwritable`] and [`BookError::NotOurs`], as for [`write()`].
pub fn check(out: &Path) -> Result<(), BookError> {
    Staging::beside(out).map(drop)
}

fn write_pages(
    pages: Vec<Page>,
    ledger: &Ledger,
    figures: &[Figure],
    out: &Path,
) -> Result<PathBuf, BookError> {
    let figures = [figures, &[map::figure(ledger)?]].concat();
    let errata = ledger.errata()?;
    let code = Code::new();
    let filler = Filler::new(ledger, &figures, &errata, &code);
    let text = |page: &Page| Ok((page.file(), expand::expand(page, &filler)?));
    let texts: Vec<Result<_, BookError>> = pages.par_iter().map(text).collect();
    // Of several faults, the first in the book is reported.
    let mut files = texts.into_iter().collect::<Result<Vec<_>, _>>()?;
    if let Some(entry) = filler.without_box() {
        return Err(BookError::ClaimNowhere {
            id: entry.claim.id,
            page: format!("{}.md", entry.topic.stem),
        });
    }
    files.push(("SUMMARY.md".into(), pages::summary(&pages)));
    for figure in &figures {
        files.push((fill::data_file(figure), figure.csv.clone()));
    }

    files.extend(explorer::files());

    let staging = Staging::beside(out)?;
    let source = staging.path("source");
    for (name, text) in &files {
        put(&source.join("src").join(name), text.as_bytes())?;
    }
    for (name, bytes) in assets::THEME {
        // mdBook takes style sheets, scripts and its theme from beside `src`, all other files from within it.
        let folder = if name.contains("katex") && !name.ends_with(".css") {
            source.join("src")
        } else {
            source.clone()
        };
        put(&folder.join(name), bytes)?;
    }
    let book = staging.path("book");
    render(&source, &book)?;
    let forms = filler.maths().forms();
    let beside = || {
        for (name, format) in [("errata.txt", Format::Text), ("errata.tex", Format::Latex)] {
            put(&book.join(name), ledger.letter(format)?.as_bytes())?;
        }
        let mut pages = code.pages();
        pages.try_for_each(|(name, html)| put(&book.join(name), html.as_bytes()))
    };
    let (finished, written) = rayon::join(|| finish(&book, &pages, &forms), beside);
    finished?;
    written?;
    put(&book.join(swap::MARKER), swap::MARKER_TEXT)?;
    let out = staging.swap(&book)?;
    Ok(out.join("index.html"))
}

/// Puts the formulas into mdBook's pages, and our index in place of mdBook's.
fn finish(book: &Path, pages: &[Page], maths: &Forms) -> Result<(), BookError> {
    let read = |name: String| {
        let path = book.join(&name);
        match fs::read_to_string(&path) {
            Ok(html) => Ok((name, path, html)),
            Err(reason) => Err(unwritable(&path, reason)),
        }
    };
    let searched = pages.len();
    let names = pages.iter().map(|page| format!("{}.html", page.stem));
    let written: Result<Vec<_>, _> = names.chain(["print.html".to_owned()]).map(read).collect();
    let written = written?;
    let index = || {
        let mut search = Search::new();
        for (name, _, html) in &written[..searched] {
            search.add(name, &maths.with_words(html));
        }
        let index = search.file();
        index.map_err(|error| BookError::Render(error.to_string()))
    };
    let formulas = || {
        let pages = written.par_iter();
        pages.try_for_each(|(_, path, html)| put(path, maths.with_formulas(html).as_bytes()))
    };
    let (index, set) = rayon::join(index, formulas);
    set?;
    put(&book.join("searchindex.js"), index?.as_bytes())
}

/// Lets mdBook make `book` from `source`.
fn render(source: &Path, book: &Path) -> Result<(), BookError> {
    let mut config: Config = assets::SETTINGS
        .parse()
        .map_err(|error| BookError::Render(format!("{error:#}")))?;
    config.build.build_dir = book.to_owned();
    MDBook::load_with_config(source, config)
        .and_then(|mdbook| mdbook.build())
        .map_err(|error| BookError::Render(format!("{error:#}")))
}

/// Writes one file, with its folders.
fn put(path: &Path, bytes: &[u8]) -> Result<(), BookError> {
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder).map_err(|reason| unwritable(folder, reason))?;
    fs::write(path, bytes).map_err(|reason| unwritable(path, reason))
}
