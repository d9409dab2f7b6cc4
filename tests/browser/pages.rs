//! Pages, links, search, print.

use crate::Book;
use crate::chrome::{Failure, Page};
use crate::visit::visits;
use serde_json::json;
use std::collections::BTreeSet;

/// Every page loads, and neither complains nor asks anybody for anything.
pub fn load(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let visits = visits(page, book)?.iter();
    let found = visits.flat_map(|(name, visit)| {
        visit
            .complaints
            .iter()
            .map(move |complaint| format!("{name}: {complaint}"))
    });
    none(found.collect())
}

/// Every address in a page, of a link or of a file, leads to a file of the book, every fragment to a place in it.
pub fn links(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let (root, visits) = (book.address(""), visits(page, book)?);
    let leads = |address: &str| {
        let Some(path) = address.strip_prefix(&root) else {
            return address.starts_with("data:");
        };
        let (file, fragment) = path.split_once('#').unwrap_or((path, ""));
        let file = if file.is_empty() { "index.html" } else { file };
        let place = fragment.is_empty()
            || visits
                .get(file)
                .is_some_and(|visit| visit.places.contains(fragment));
        place && book.folder().join(file).is_file()
    };
    let used = visits
        .iter()
        .flat_map(|(name, visit)| visit.addresses.iter().map(move |address| (name, address)));
    let dead: BTreeSet<_> = used.filter(|(_, address)| !leads(address)).collect();
    none(
        dead.into_iter()
            .map(|(name, address)| format!("{name}: {address}"))
            .collect(),
    )
}

/// Whether a label shows what should have become markup, or has and is read as text. Between two quantities `<` is a sign.
pub fn is_marked(label: &str) -> bool {
    let label = label.replace(" < ", "").replace(" > ", "");
    label.contains(['"', '<', '>', '&', '_', '^'])
        || ["tspan", "font-", "KaTeX"]
            .iter()
            .any(|part| label.contains(part))
}

/// The labels of the figures are words, on every page.
pub fn labels(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let visits = visits(page, book)?;
    let all = || {
        visits
            .iter()
            .flat_map(|(name, visit)| visit.labels.iter().map(move |label| (name, label)))
    };
    if all().count() < 1000 {
        return Err(format!("only {} labels", all().count()));
    }
    let wrong = all().filter(|(_, label)| is_marked(label));
    none(
        wrong
            .map(|(name, label)| format!("{name}: {label}"))
            .collect(),
    )
}

/// What a reader may search for, and an address that must be among what is found.
const SOUGHT: [(&str, &str); 2] = [("(37)", "sinusoidal.html#eq-37"), ("λc", "sinusoidal.html")];

/// The search field finds equations by number and symbols.
pub fn search(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let mut missing = Vec::new();
    for (sought, address) in SOUGHT {
        page.open(&book.address("index.html"))?;
        page.value("document.getElementById('mdbook-search-toggle').click()")?;
        page.wait_for("document.activeElement === document.getElementById('mdbook-searchbar')")?;
        page.write(sought)?;
        // The field waits for the index and for a pause in the typing; then its header says what came of it.
        page.wait_for("/search results? for/.test(document.getElementById('mdbook-searchresults-header').textContent)")?;
        let found = page
            .texts("[...document.querySelectorAll('#mdbook-searchresults a')].map(a => a.href)")?;
        // mdBook adds the words to be marked to the address.
        let plain = |found: &String| {
            let (file, rest) = found.split_once('?').unwrap_or((found, ""));
            format!("{file}{}", rest.find('#').map_or("", |i| &rest[i..]))
        };
        if !found.iter().any(|found| plain(found).contains(address)) {
            missing.push(format!(
                "\"{sought}\" does not find {address} but {found:?}"
            ));
        }
    }
    none(missing)
}

/// The contents are opened and closed without a mouse.
pub fn contents(page: &mut Page, book: &Book) -> Result<(), Failure> {
    page.open(&book.address("index.html"))?;
    page.value("document.querySelector('button[aria-controls=mdbook-sidebar]').focus()")?;
    for open in [false, true] {
        page.press("Enter")?;
        page.wait_for(&format!(
            "document.documentElement.classList.contains('sidebar-visible') === {open}
             && document.activeElement.getAttribute('aria-expanded') === '{open}'"
        ))?;
    }
    Ok(())
}

/// On a screen of 390 pixels nothing sticks out at the side.
pub fn narrow(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let visits = visits(page, book)?
        .iter()
        .filter(|(name, _)| book.is_chapter(name));
    let wide = visits.filter(|(_, visit)| visit.width.as_f64().is_none_or(|width| width > 390.0));
    none(
        wide.map(|(name, visit)| format!("{name} is {} wide", visit.width))
            .collect(),
    )
}

/// With scripts off, the figures are seen and the places of the explorers are not.
pub fn without_scripts(page: &mut Page, book: &Book) -> Result<(), Failure> {
    page.call(
        "Emulation.setScriptExecutionDisabled",
        json!({ "value": true }),
    )?;
    let mut wrong = Vec::new();
    for name in crate::explorers::PAGES {
        page.call(
            "Page.navigate",
            json!({ "url": book.address(&format!("{name}.html")) }),
        )?;
        // No script of the page's own runs, but the browser's own eyes are open.
        page.wait_for(&format!(
            "location.pathname.endsWith('/{name}.html') && document.readyState === 'complete'"
        ))?;
        let seen = page.value(
            "(() => { const host = document.querySelector('[data-explorer]');
               return [host.checkVisibility(), host.nextElementSibling.querySelector('svg').checkVisibility()]; })()",
        )?;
        if seen != json!([false, true]) {
            wrong.push(format!("{name}: explorer and figure are seen: {seen}"));
        }
    }
    none(wrong)
}

/// The print page holds the figures, not the explorers.
pub fn printing(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let visit = visits(page, book)?.get("print.html");
    let seen = &visit.ok_or("no page for printing")?.explorers;
    let expected = json!(crate::explorers::PAGES.map(|_| [false, true]));
    if *seen == expected {
        Ok(())
    } else {
        Err(format!("explorers and figures are seen: {seen}"))
    }
}

/// Fails with a list of what was found, unless it is empty.
pub fn none(found: Vec<String>) -> Result<(), Failure> {
    if found.is_empty() {
        Ok(())
    } else {
        Err(format!("{} found:\n{}", found.len(), found.join("\n")))
    }
}
