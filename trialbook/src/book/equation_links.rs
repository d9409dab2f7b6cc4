//! Numbers of equations in the text, as links.

use super::text::after_each;
use crate::ledger::Ledger;
use crate::notation::{Tag, tags};
use std::collections::{BTreeMap, BTreeSet};

/// No running text, or a link already.
const APART: [&str; 13] = [
    "a", "button", "code", "figure", "h1", "h2", "h3", "h4", "math", "pre", "script", "summary",
    "svg",
];

const TEXT: [&str; 2] = ["p", "li"];

pub(super) fn addresses(ledger: &Ledger) -> BTreeMap<u16, String> {
    let entries = ledger.entries.iter();
    let numbered = entries.filter_map(|entry| Some((entry.claim.equation?, entry.address())));
    numbered.collect()
}

/// Each number in brackets that is an equation's, in running text, becomes a link. In the order of tabs is
/// the first that leads to another page.
pub(super) fn linked(page: &str, html: &str, addresses: &BTreeMap<u16, String>) -> String {
    let mut out = String::with_capacity(html.len() + html.len() / 16);
    let mut seen = BTreeSet::new();
    let (mut apart, mut running, mut folded) = (0_usize, 0_usize, 0_usize);
    for Tag {
        tag,
        name,
        closes,
        alone,
        text,
    } in tags(html)
    {
        for (names, depth) in [
            (&APART[..], &mut apart),
            (&TEXT[..], &mut running),
            (&["details"][..], &mut folded),
        ] {
            if names.contains(&name) && !alone {
                *depth = match closes {
                    true => depth.saturating_sub(1),
                    false => *depth + 1,
                };
            }
        }
        out += tag;
        if apart > 0 || running == 0 {
            out += text;
            continue;
        }
        out += &after_each(text, "(", |part, out| {
            let number = part.split_once(')').and_then(|(number, after)| {
                let is_number = number.len() < 4 && number.bytes().all(|b| b.is_ascii_digit());
                let address = addresses.get(&number.parse().ok()?)?;
                is_number.then_some((number, address, after))
            });
            let Some((number, address, after)) = number else {
                out.extend(["(", part]);
                return;
            };
            let own = address.split('#').next() == Some(page);
            let stop = folded > 0 || !own && seen.insert(address);
            let stop = if stop { "" } else { " tabindex=\"-1\"" };
            *out += &format!("<a class=\"cite\" href=\"{address}\"{stop}>({number})</a>{after}");
        });
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_in_the_text_leads_to_its_equation() {
        let addresses = BTreeMap::from([(7, "falls.html#eq-7".to_owned())]);
        let [link, again] = ["", " tabindex=\"-1\""]
            .map(|stop| format!("<a class=\"cite\" href=\"falls.html#eq-7\"{stop}>(7)</a>"));
        for (page, html, expected) in [
            (
                "rises.html",
                "<p>By (7), (8) and (+7), (7).</p>",
                format!("<p>By {link}, (8) and (+7), {again}.</p>"),
            ),
            (
                "falls.html",
                "<li>As <em>in (7)</em><br/> (a)</li>",
                format!("<li>As <em>in {again}</em><br/> (a)</li>"),
            ),
            (
                "rises.html",
                "<details><p>(7)</p></details><p>(7)",
                format!("<details><p>{link}</p></details><p>{link}"),
            ),
            (
                "rises.html",
                "<h2>On (7)</h2>(7)<p><a href=\"x\">(7)</a> <code>(7)</code></p>",
                String::new(),
            ),
        ] {
            let expected = if expected.is_empty() { html } else { &expected };
            assert_eq!(linked(page, html, &addresses), expected);
        }
    }
}
