//! What can go wrong when the book is written.

use crate::ledger::ErrataError;
use crate::plotting::FigureError;
use crate::trials::compare::Failure;
use std::io;
use std::path::PathBuf;

/// Why no book was written. The folder is as it was before, unless the error says otherwise.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BookError {
    /// A file or folder cannot be written.
    #[error("cannot write `{}`: {reason}", path.display())]
    Unwritable {
        /// What was to be written.
        path: PathBuf,
        /// What the system says.
        #[source]
        reason: io::Error,
    },
    /// Neither the new book nor the earlier one could be put in place.
    #[error("cannot put the book in place: {reason}; the earlier book is now in `{}`", kept.display())]
    Displaced {
        /// Where the earlier book is.
        kept: PathBuf,
        /// What the system says.
        #[source]
        reason: io::Error,
    },
    /// What stands there is not an earlier book, and is left alone.
    #[error(
        "`{}` is not empty, and nothing that this command has written: name another folder, or empty this one",
        path.display()
    )]
    NotOurs {
        /// The folder.
        path: PathBuf,
    },
    /// A placeholder on a page that means nothing, or not there.
    #[error("{page}, line {line}: `{placeholder}`: {reason}")]
    Placeholder {
        /// The page's file name.
        page: String,
        /// The line on the page, from 1.
        line: usize,
        /// The placeholder as it stands there.
        placeholder: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A formula that cannot be set.
    #[error("{page}, line {line}: the formula `{formula}`: {reason}")]
    Formula {
        /// The page's file name.
        page: String,
        /// The line on the page, from 1.
        line: usize,
        /// The formula, in LaTeX.
        formula: String,
        /// What is wrong with it.
        reason: String,
    },
    /// Markup that would not come out as it was meant.
    #[error("{page}, line {line}: {reason}")]
    Markup {
        /// The page's file name.
        page: String,
        /// The line on the page, from 1.
        line: usize,
        /// What is wrong.
        reason: String,
    },
    /// A claim of the ledger that no page shows.
    #[error("no page shows the claim `{id}`: put {{{{claim {id}}}}} on the page {page}")]
    ClaimNowhere {
        /// The claim's id.
        id: &'static str,
        /// The page where it belongs.
        page: String,
    },
    /// What is computed for no page.
    #[error(
        "no page says what is computed as `{name}`: take it out, or put {{{{is {name} …}}}} where it belongs"
    )]
    SaidNowhere {
        /// Its name.
        name: &'static str,
    },
    /// Links that lead nowhere.
    #[error("dead links, each behind its page: {}", links.join("; "))]
    DeadLinks {
        /// As [`dead_links`](super::dead_links()) has them.
        links: Vec<String>,
    },
    /// The map of claims cannot be drawn.
    #[error("the map of claims: {0}")]
    Map(#[from] FigureError),
    /// The errata have no numbers.
    #[error(transparent)]
    Errata(#[from] ErrataError),
    /// mdBook refused the pages or the settings.
    #[error("mdBook: {0}")]
    Render(String),
}

pub(super) type Html = Result<String, Fault>;

#[derive(Debug)]
pub(super) enum Fault {
    Placeholder(String),
    Formula {
        /// The formula, in LaTeX.
        formula: String,
        /// What is wrong with it.
        reason: String,
    },
}

impl From<String> for Fault {
    fn from(reason: String) -> Self {
        Fault::Placeholder(reason)
    }
}

impl From<Failure> for Fault {
    fn from(failure: Failure) -> Self {
        failure.to_string().into()
    }
}

impl From<Fault> for BookError {
    fn from(fault: Fault) -> Self {
        Self::Render(match fault {
            Fault::Placeholder(reason) => reason,
            Fault::Formula { formula, reason } => format!("{formula}: {reason}"),
        })
    }
}
