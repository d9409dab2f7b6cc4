//! Accessibility by axe-core, which is not part of this crate: see the licences in `axe/`.

use crate::Book;
use crate::chrome::{Page, Seen};
use crate::pages::none;
use crate::visit::visits;

const ALL: &str = "['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice']";
const LOOK: &str = "{ type: 'rule', values: ['color-contrast', 'link-in-text-block'] }";

const LOOKS: [(&str, &[&str]); 4] = [
    ("constant.html", &["navy", "coal", "ayu", "rust"]),
    ("index.html", &["navy"]),
    ("ledger.html", &["navy"]),
    ("methods.html", &["navy"]),
];

fn broken(page: &mut Page, rules: &str) -> Seen<Vec<String>> {
    page.value(concat!(include_str!("axe/axe.min.js"), ";0"))?;
    // Style sheets on the disk may not be read once more. Twenty formulas stand for all of the page. What is folded is not looked
    // at; the answers to the exercises are unfolded.
    page.texts(&format!(
        "document.querySelectorAll('.exercise details').forEach(answer => {{ answer.open = true; }});
         document.querySelectorAll('details:not([open]) > :not(summary)').forEach(hidden => hidden.remove());
         document.querySelectorAll('.katex').forEach((formula, i) => i < 20 || formula.replaceChildren('x'));
         axe.run({{ preload: false, resultTypes: ['violations'], runOnly: {rules} }}).then(found => found.violations.map(rule =>
             `${{rule.id}}: ${{rule.help}}, ${{rule.nodes.length}} times: `
             + rule.nodes.slice(0, 3).map(node => `${{node.target.join(' ')}} ${{node.any.map(c => c.message).join('; ')}}`).join(' | ')))"
    ))
}

pub fn all_broken(page: &mut Page) -> Seen<Vec<String>> {
    broken(page, ALL)
}

pub fn pages(page: &mut Page, book: &Book) -> Seen {
    let visits = visits(page, book)?.iter();
    let found = visits.flat_map(|(name, visit)| {
        visit
            .broken
            .iter()
            .map(move |rule| format!("{name}: {rule}"))
    });
    none(found.collect())
}

pub fn themes(page: &mut Page, book: &Book) -> Seen {
    let mut found = Vec::new();
    for (name, themes) in LOOKS {
        page.open(&book.address(name))?;
        // What is out of view is laid out too, or axe takes guessed places for what lies behind.
        page.value(
            "document.head.insertAdjacentHTML('beforeend', '<style>main > * { content-visibility: visible !important; }</style>')",
        )?;
        for theme in themes {
            page.value(&format!(
                "document.getElementById('mdbook-theme-{theme}').click()"
            ))?;
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
    none(found)
}
