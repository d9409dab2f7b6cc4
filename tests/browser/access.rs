//! Accessibility by axe-core, which is not part of this crate: see the licences in `axe/`.

use crate::Book;
use crate::chrome::{Failure, Page};
use crate::pages::none;
use crate::visit::visits;

/// mdBook's own frame, which we do not write: its bar of buttons, and its contents with the label that opens them.
const FOREIGN: &str = "[['#mdbook-sidebar-toggle'], ['#mdbook-menu-bar'], ['#mdbook-sidebar']]";

/// All that the checker knows of the law, and what it holds good practice, landmarks among it.
const ALL: &str = "['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice']";
/// What another look of the same page may break.
const LOOK: &str = "{ type: 'rule', values: ['color-contrast', 'link-in-text-block'] }";

/// The themes, besides the one by day, with pages that have all colours between them.
const LOOKS: [(&str, &[&str]); 4] = [
    (
        "navy",
        &["index.html", "constant.html", "ledger.html", "methods.html"],
    ),
    ("coal", &["constant.html"]),
    ("ayu", &["constant.html"]),
    ("rust", &["constant.html"]),
];

/// The rules that the open page breaks: each with what it asks and the first places.
fn broken(page: &mut Page, rules: &str) -> Result<Vec<String>, Failure> {
    page.value(concat!(include_str!("axe/axe.min.js"), ";0"))?;
    // Checking takes its time for each formula; twenty stand for those of the page, which are all made alike.
    page.texts(&format!(
        "document.querySelectorAll('.katex').forEach((formula, i) => i < 20 || formula.replaceChildren('x'));
         axe.run({{ exclude: {FOREIGN} }}, {{ resultTypes: ['violations'], runOnly: {rules} }}).then(found => found.violations.map(rule =>
             `${{rule.id}}: ${{rule.help}}, ${{rule.nodes.length}} times: `
             + rule.nodes.slice(0, 3).map(node => `${{node.target.join(' ')}} ${{node.any.map(c => c.message).join('; ')}}`).join(' | ')))"
    ))
}

/// The rules of all kinds that the open page breaks.
pub fn all_broken(page: &mut Page) -> Result<Vec<String>, Failure> {
    broken(page, ALL)
}

/// No page breaks a rule on contrast, names, landmarks and the rest.
pub fn pages(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let visits = visits(page, book)?.iter();
    let found = visits.flat_map(|(name, visit)| {
        visit
            .broken
            .iter()
            .map(move |rule| format!("{name}: {rule}"))
    });
    none(found.collect())
}

/// Words can be read and links be told from them in every theme.
pub fn themes(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let mut found = Vec::new();
    for (theme, names) in LOOKS {
        for name in names {
            page.open(&book.address(name))?;
            page.value(&format!("localStorage.setItem('mdbook-theme', '{theme}')"))?;
            page.open(&book.address(name))?;
            let worn = page.value(&format!(
                "document.documentElement.classList.contains('{theme}')"
            ))?;
            if worn != true {
                found.push(format!("{name} does not put on the theme {theme}"));
            }
            let rules = broken(page, LOOK)?;
            found.extend(
                rules
                    .into_iter()
                    .map(|rule| format!("{name} ({theme}): {rule}")),
            );
        }
    }
    page.value("localStorage.removeItem('mdbook-theme')")?;
    none(found)
}
