//! Accessibility by axe-core, which is not part of this crate: see the licence in `axe/`.

use crate::Book;
use crate::chrome::{Failure, Page};
use crate::pages::none;

const AXE: &str = include_str!("axe/axe.min.js");

/// The looks in which the pages are checked: mdBook's default by day and by night.
const THEMES: [&str; 2] = ["light", "navy"];

/// mdBook's own frame, which we do not write: its bar of buttons and the label that opens its contents.
const FOREIGN: &str = "[['#mdbook-sidebar-toggle'], ['#mdbook-menu-bar'], ['#mdbook-sidebar']]";

/// The checker's verdict: for each rule that is broken the rule, what it asks, and the first places.
fn check() -> String {
    format!(
        "axe.run({{ exclude: {FOREIGN} }}, {{ resultTypes: ['violations'], runOnly: ['wcag2a', 'wcag2aa', 'wcag21a',
         'wcag21aa', 'best-practice'] }}).then(found => found.violations.map(rule =>
             `${{rule.id}}: ${{rule.help}}, ${{rule.nodes.length}} times: `
             + rule.nodes.slice(0, 3).map(node => `${{node.target.join(' ')}} ${{node.any.map(c => c.message).join('; ')}}`).join(' | ')))"
    )
}

/// No rule on contrast, names, landmarks and the rest is broken, in either theme.
pub fn pages(page: &mut Page, book: &Book) -> Result<(), Failure> {
    let mut found = Vec::new();
    for theme in THEMES {
        for name in book.chapters() {
            page.open(&book.address(name))?;
            page.value(&format!(
                "document.documentElement.classList.remove('light', 'navy'); document.documentElement.classList.add('{theme}')"
            ))?;
            page.value(&format!("{AXE};0"))?;
            let broken = page.texts(&check())?;
            found.extend(
                broken
                    .into_iter()
                    .map(|rule| format!("{name} ({theme}): {rule}")),
            );
        }
    }
    none(found)
}
