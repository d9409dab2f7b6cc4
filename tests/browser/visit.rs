//! One visit to every page, and what was seen there.

use crate::access::all_broken;
use crate::chrome::{Failure, Page, Seen};
use crate::{Book, TABS};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

pub struct Visit {
    pub complaints: Vec<String>,
    pub places: BTreeSet<String>,
    /// As the browser resolves them.
    pub addresses: Vec<String>,
    pub labels: Vec<String>,
    /// Whether each is seen, and whether the still figure is.
    pub explorers: Value,
    pub width: Value,
    pub broken: Vec<String>,
}

/// Made when first asked for, in several tabs.
pub fn visits<'b>(page: &Page, book: &'b Book) -> Seen<&'b BTreeMap<String, Visit>> {
    let next = AtomicUsize::new(0);
    let some = || {
        let (mut page, mut some) = (page.browser.page()?, Vec::new());
        while let Some(name) = book.pages.get(next.fetch_add(1, Ordering::Relaxed)) {
            some.push((name.clone(), visit(&mut page, book, name)?));
        }
        Ok::<_, Failure>(some)
    };
    let all = || {
        thread::scope(|scope| {
            let tabs = [(); TABS].map(|()| scope.spawn(some));
            let mut all = BTreeMap::new();
            for tab in tabs {
                all.extend(tab.join().map_err(|_| "a visit broke off")??);
            }
            Ok(all)
        })
    };
    book.visits.get_or_init(all).as_ref().map_err(Clone::clone)
}

fn visit(page: &mut Page, book: &Book, name: &str) -> Seen<Visit> {
    // A phone first, so that a page is laid out twice, not three times.
    if book.is_chapter(name) {
        page.resize(390, 800)?;
    }
    page.open(&book.address(name))?;
    page.show_explorer()?;
    let complaints = page.complaints();
    let places =
        page.texts("[...document.querySelectorAll('[id], a[name]')].map(e => e.id || e.name)")?;
    let addresses = page.texts(
        "[...document.querySelectorAll('[href], [src]')].map(e => e.src || e.href).filter(a => typeof a === 'string')",
    )?;
    let labels = page.texts(
        "[...document.querySelectorAll('svg text, svg title, svg desc')].map(e => e.textContent)
            .concat([...document.querySelectorAll('svg[aria-label]')].map(e => e.getAttribute('aria-label')))",
    )?;
    let explorers = page.value(
        "[...document.querySelectorAll('[data-explorer]')].map(host => [host.checkVisibility(),
            host.nextElementSibling.querySelector('svg').checkVisibility()])",
    )?;
    let (mut width, mut broken) = (Value::Null, Vec::new());
    if book.is_chapter(name) {
        width = page.value("document.documentElement.scrollWidth")?;
        page.resize(1400, 1000)?;
        broken = all_broken(page)?;
    }
    Ok(Visit {
        complaints,
        places: places.into_iter().collect(),
        addresses,
        labels,
        explorers,
        width,
        broken,
    })
}
