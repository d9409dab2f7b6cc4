//! One visit to every page, and what was seen there.

use crate::Book;
use crate::access::all_broken;
use crate::chrome::{Failure, Page};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// What was seen on a page.
pub struct Visit {
    /// Errors, and requests to anywhere but the disk.
    pub complaints: Vec<String>,
    /// The places to which a fragment may lead.
    pub places: BTreeSet<String>,
    /// All addresses, of links and of files, as the browser resolves them.
    pub addresses: Vec<String>,
    /// Its width on a screen of 390 pixels, for a chapter.
    pub width: Value,
    /// The rules of accessibility that it breaks, if it is a chapter.
    pub broken: Vec<String>,
}

/// The visits, made when they are first asked for.
pub fn visits<'b>(page: &mut Page, book: &'b Book) -> Result<&'b BTreeMap<String, Visit>, Failure> {
    let all = || {
        book.pages
            .iter()
            .map(|name| Ok((name.clone(), visit(page, book, name)?)))
            .collect()
    };
    book.visits.get_or_init(all).as_ref().map_err(Clone::clone)
}

fn visit(page: &mut Page, book: &Book, name: &str) -> Result<Visit, Failure> {
    page.open(&book.address(name))?;
    let complaints = page.complaints();
    let places =
        page.texts("[...document.querySelectorAll('[id], a[name]')].map(e => e.id || e.name)")?;
    let addresses = page.texts(
        "[...document.querySelectorAll('[href], [src]')].map(e => e.src || e.href).filter(a => typeof a === 'string')",
    )?;
    let (mut width, mut broken) = (Value::Null, Vec::new());
    if book.is_chapter(name) {
        page.resize(390, 800)?;
        width = page.value("document.documentElement.scrollWidth")?;
        page.resize(1400, 1000)?;
        broken = all_broken(page)?;
    }
    Ok(Visit {
        complaints,
        places: places.into_iter().collect(),
        addresses,
        width,
        broken,
    })
}
