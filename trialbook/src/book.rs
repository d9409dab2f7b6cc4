//! The book: pages filled from the ledger and the figures, rendered by mdBook, put in place whole.
//!
//! The pages of an [`Edition`] are Markdown, with formulas in `$…$` and `$$…$$` and with placeholders:
//!
//! | placeholder | stands for |
//! |---|---|
//! | `{{claim eq-11}}` | the claim's box; every claim has one, on the page of its topic |
//! | `{{figure fig-1}}` | the figure with its caption, text alternative and data |
//! | `{{title}}`, `{{authors}}` | of the paper |
//! | `{{repository}}` | where the program is kept: a link, or that no public address is known |
//! | `{{counts}}` | a table of the verdicts with the number of claims |
//! | `{{errors}}`, `{{errors fallen}}` | the independent errors, a line each with link; and with what falls with each |
//! | `{{skeleton}}` | a mark for each numbered equation, by its verdict |
//! | `{{ask}}` | a field that answers with a claim to a number, a symbol or words |
//! | `{{contents}}` | on the page of a topic: its equations, how many statements in words and figures it has |
//! | `{{ledger constant}}` | a table of the claims of a topic |
//! | `{{ledger}}` | the tables of all topics under headings |
//! | `{{unreached}}` | a table of the claims of which no theorem says the whole, with what is missing |
//! | `{{definitions}}` | what the statements of the theorems speak of, with links to it in the boxes |
//! | `{{proofs}}` | a table of what is proved and what is measured, by the kind of claim |
//! | `{{symbols}}`, `{{values}}` | the indexes |
//! | `{{errata misprint refuted}}` | the errata with these verdicts |
//! | `{{map key}}`, `{{map list}}`, `{{falls}}` | the signs of the map of claims, and what it shows as tables |
//! | `{{routes}}`, `{{tolerances}}` | tables of what the trials of this ledger use |
//! | `{{sheet eq-20}}` | the claim's sheet, as the snapshots have it |
//! | `{{sheets}}` | the sheets of all claims under headings |
//! | `{{first-paper}}` | the program of a first paper, to begin with |
//! | `{{verdict eq-11}}` | the verdict in word and colour |
//! | `{{points eq-11}}` | how many points its trials compared |
//! | `{{worst eq-11}}` | the disagreement that comes nearest to, or farthest beyond, its tolerance |
//! | `{{ref eq-11}}` | a link to the claim's box |
//! | `{{value lambda-c}}` | a number of the index of values, by its short name |
//! | `{{count confirmed}}` | the number of claims of a verdict, by its slug |
//! | `{{count wrong}}`, `{{count roots}}`, `{{count heirs}}` | of the claims that are false: all, those with an error of their own, the others |
//! | `{{count results}}`, `{{count factors}}` | of the errors of their own: the topics in which a result does not hold, the formulas that have lost a factor or the like |
//! | `{{beside}}` | the theorems before a kernel that belong to no claim |
//! | `{{lemmas}}` | the proofs that others rest on and that no box shows |
//! | `{{count proved}}`, `argued`, `measured` | how many claims are known in this way |
//! | `{{lines src/motion}}` | how much code stands in these modules, without comments and tests, and their paths |
//! | `{{is fall falls\|rises}}` | the first word if what is computed by this name says so, else the second, and so on; `!fall` for `rises\|falls` |
//! | `{{is loops six}}` | the number as it stands there, if it is the one that is computed by this name |
//! | `{{code three quarters}}` | the number as it stands there, if the code of the section has it |
//! | `{{count claims}}`, `{{count points}}` | the number of all claims, of all compared points |
//!
//! An edition may have more of its own. Those that stand for a box, a figure or a table stand alone on their line. None is
//! filled in code. Whatever cannot be filled or set stops the book, with page and line.
//!
//! mdBook renders the pages before anything is known of the verdicts, with marks in the place of formulas and of what
//! fills the placeholders: it then reads a tenth of the text, and the rest is put in last.

mod answers;
mod assembly;
mod assets;
mod atomic_replace;
mod claim_box;
mod code;
mod context;
mod deep;
mod equation_links;
mod errata;
mod error;
mod excuses;
mod expand;
mod fill;
mod formula_diff;
mod ledger_tables;
mod lemmas;
mod links;
mod map;
mod maths;
mod metadata;
mod method_tables;
mod moved;
mod pages;
mod pieces;
mod register;
mod rows;
mod search;
mod skeleton;
mod symbols;
mod table;
#[cfg(test)]
mod tests;
mod text;
mod theorems;
mod values;

pub use assembly::Frame;
pub use atomic_replace::bare;
pub use error::BookError;
pub(crate) use expand::options;
pub use links::{dead_links, files_below};
pub use pieces::{Piece, pieces};
pub use register::register;
pub use table::{code, table};
pub use text::escape;

use crate::ledger::Ledger;
use crate::plotting::Figure;
use crate::publishing::Edition;
use atomic_replace::{Staging, unwritable};
use std::fs;
use std::path::{Path, PathBuf};

/// Writes the book into the folder `out`, with missing parents, and returns the path of its first page.
///
/// It is made in a temporary folder beside `out`: until the end, and whenever anything fails, `out` is what
/// it was. The same ledger and figures give the same bytes.
///
/// # Errors
/// [`BookError::Unwritable`] if a file or folder cannot be written, [`BookError::NotOurs`] if `out`
/// is neither empty nor an earlier book, and the other kinds of [`BookError`] if a page does not
/// fit the ledger.
pub fn write(
    edition: &Edition,
    ledger: &Ledger,
    figures: &[Figure],
    out: &Path,
) -> Result<PathBuf, BookError> {
    Frame::new(edition, figures, out)?.fill(ledger, figures)
}

/// Finds out whether a book can be written into `out`; makes nothing but missing parent folders.
///
/// # Errors
/// [`BookError::Unwritable`] and [`BookError::NotOurs`], as for [`write()`].
pub fn check(edition: &Edition, out: &Path) -> Result<(), BookError> {
    Staging::beside(out, edition.name).map(drop)
}

/// Writes files with these names and texts into the folder `out`, whole or not at all; returns where that is.
/// An earlier folder of the same `name` is replaced.
///
/// # Errors
/// [`BookError::Unwritable`] and [`BookError::NotOurs`], as for [`write()`].
pub fn folder(
    out: &Path,
    name: &'static str,
    files: &[(String, String)],
) -> Result<PathBuf, BookError> {
    let staging = Staging::beside(out, name)?;
    let places = staging.places();
    let written = || {
        let made = staging.path("made");
        for (file, text) in files {
            put(&made.join(file), text.as_bytes())?;
        }
        staging.mark(&made)?;
        staging.swap(&made)
    };
    written().map_err(|error| places.named(error))
}

fn put(path: &Path, bytes: &[u8]) -> Result<(), BookError> {
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder).map_err(|reason| unwritable(folder, reason))?;
    fs::write(path, bytes).map_err(|reason| unwritable(path, reason))
}
